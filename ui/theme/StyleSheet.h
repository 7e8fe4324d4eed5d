// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "ui/theme/Theme.h"

namespace fodscope {

/// @return resources/style/fodscope.qss with the theme's colours in place of its tokens
QString styleSheetFor(const Theme& theme);

}  // namespace fodscope
