// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fodscope {

/// Sizes of the parts that work on many points is divided into.
inline constexpr std::size_t kPart = 2048;

/// Calls `work(begin, end, part)` for parts of 0 … count − 1, in parallel.
template <class Work>
void forEachPart(std::size_t count, const Work& work) {
    const std::size_t parts = (count + kPart - 1) / kPart;
    const auto one = [&](std::size_t part) { work(part * kPart, std::min((part + 1) * kPart, count), part); };
    if (parts == 1) return one(0);
    tbb::parallel_for(std::size_t{0}, parts, one);
}

/// The sum of `sumOf(begin, end)` over parts of 0 … count − 1 that are the same for any number of threads, as is the
/// order in which they are added: rounding does not depend on either.
template <class Sum, class SumOf>
Sum orderedSum(std::size_t count, const Sum& zero, const SumOf& sumOf) {
    std::vector<Sum> sums((count + kPart - 1) / kPart, zero);
    forEachPart(count, [&](std::size_t begin, std::size_t end, std::size_t part) { sums[part] = sumOf(begin, end); });
    Sum sum = zero;
    for (const Sum& part : sums)
        sum += part;
    return sum;
}

}  // namespace fodscope
