// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>

namespace fodscope {

/// A copy for looking at: the brightness of the darkest and lightest half percent goes to black and white and the
/// middle is lifted; the channels of a pixel are scaled alike, so that hues stay. The photo itself is never changed.
QImage contrastStretched(const QImage& photo);

}  // namespace fodscope
