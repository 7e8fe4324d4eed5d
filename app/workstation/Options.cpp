// SPDX-License-Identifier: MIT
#include "app/workstation/Options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/common/Version.h"

namespace fodscope {
namespace {

constexpr int kWrongUsage = 2;

std::string checkedSize(const std::string& text, std::optional<QSize>& size) {
    int width = 0;
    int height = 0;
    char surplus = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &surplus) != 2 || width < 800 || height < 600 ||
        width > 16384 || height > 16384)
        return "expects WIDTHxHEIGHT in pixels, at least 800x600";
    size = QSize(width, height);
    return {};
}

}  // namespace

ParsedOptions parseOptions(int argc, char** argv) {
    ParsedOptions parsed;
    Options& options = parsed.options;
    std::string size;
    std::string theme;
    CLI::App program("Fodscope finds foreign object debris: the workstation.", "fodscope");
    program.set_version_flag("--version", std::string(kVersion));
    program.add_option("SESSION", options.session, "session file to open (.fodscope)");
    auto* demo = program.add_flag("--demo", options.demo, "open the built-in tank with the simulated robot");
    auto* screenshots = program.add_option("--screenshots", options.screenshots, "folder for what the autopilot makes");
    auto* autopilot = program.add_flag("--autopilot", options.autopilot, "carry the whole inspection out and exit");
    autopilot->needs(demo);
    autopilot->needs(screenshots);
    screenshots->needs(autopilot);
    program.add_option("--size", size, "size of the window, e.g. 1366x768")->check([&options](const std::string& text) {
        return checkedSize(text, options.size);
    });
    program.add_option("--theme", theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
    try {
        program.parse(argc, argv);
        if (options.demo && !options.session.empty())
            throw CLI::ValidationError("SESSION", "cannot be opened together with --demo");
    } catch (const CLI::ParseError& error) {
        parsed.exitCode = program.exit(error) == 0 ? 0 : kWrongUsage;
        return parsed;
    }
    if (!theme.empty()) options.theme = theme == "light" ? ThemeKind::Light : ThemeKind::Dark;
    return parsed;
}

}  // namespace fodscope
