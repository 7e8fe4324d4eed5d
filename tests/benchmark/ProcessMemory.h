// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace fodscope {

/// The most memory that this process held since it began, or since restartPeakMemory(); bytes. From the kernel's
/// account of the process: what getrusage() calls the peak counts from the process that started this one.
std::size_t peakMemory();

/// From here on the peak counts from what is held now.
/// @return what is held now, bytes
std::size_t restartPeakMemory();

}  // namespace fodscope
