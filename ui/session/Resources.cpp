// SPDX-License-Identifier: MIT
#include "ui/session/Resources.h"

#include <QCoreApplication>

#include "core/common/Error.h"

namespace fodscope {

std::filesystem::path resourceFile(const std::string& name) {
    const std::filesystem::path program = QCoreApplication::applicationDirPath().toStdString();
    for (const auto& folder : {program / "../share/fodscope", std::filesystem::path(FODSCOPE_SOURCE_RESOURCES)}) {
        std::error_code ignored;
        if (std::filesystem::exists(folder / name, ignored)) return folder / name;
    }
    throw Error(name, "a file that belongs to Fodscope is missing", "install Fodscope again");
}

}  // namespace fodscope
