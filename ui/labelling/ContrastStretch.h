// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>

namespace fodscope {

/// A copy for looking at: the darkest and lightest half percent go to black and white and the middle is lifted, all
/// channels alike so that hues stay. The photo itself is never changed.
QImage contrastStretched(const QImage& photo);

}  // namespace fodscope
