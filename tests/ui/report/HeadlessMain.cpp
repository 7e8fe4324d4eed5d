// SPDX-License-Identifier: MIT
// A program without a Qt application and without a display, as the command line is: writes a report into the folder
// given, and fails when that does not work.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "core/inspection/InspectionState.h"
#include "ui/report/ReportWriter.h"

int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) return 2;
    const std::filesystem::path folder(arguments[1]);
    try {
        std::filesystem::create_directories(folder);
        for (const char* name : {"headless.pdf", "headless.html", "headless.csv", "headless.json"}) {
            fodscope::writeReport({}, "", folder / name);
            if (std::filesystem::file_size(folder / name) == 0) return 1;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
