// SPDX-License-Identifier: MIT
#include "tests/benchmark/ProcessMemory.h"

#include <fstream>
#include <string>

namespace fodscope {
namespace {

/// @return a line of the kernel's account of this process, bytes
std::size_t memory(const std::string& line) {
    std::ifstream status("/proc/self/status");
    std::string word;
    std::size_t kilobytes = 0;
    while (status >> word)
        if (word == line && status >> kilobytes) return 1024 * kilobytes;
    return 0;
}

}  // namespace

std::size_t peakMemory() {
    return memory("VmHWM:");
}

std::size_t restartPeakMemory() {
    std::ofstream("/proc/self/clear_refs") << "5";
    return memory("VmRSS:");
}

}  // namespace fodscope
