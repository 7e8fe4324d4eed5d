// SPDX-License-Identifier: MIT
#include "core/cloud/BlockKernels.h"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace fodscope {
namespace {

std::uint32_t plainBlockDistances(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                                  BlockDistances& distances) {
    std::uint32_t within = 0;
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        const double x = block.at[0][i] - point.x();
        const double y = block.at[1][i] - point.y();
        const double z = block.at[2][i] - point.z();
        distances[i] = x * x + y * y + z * z;
        within |= (distances[i] <= limit ? 1U : 0U) << i;
    }
    return within;
}

void plainBoxDistances(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances) {
    distances.fill(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = box.low[static_cast<Eigen::Index>(axis)];
        const double high = box.high[static_cast<Eigen::Index>(axis)];
        for (std::size_t i = 0; i < kBlockFan; ++i) {
            const double gap = std::max(std::max(boxes.low[axis][i] - high, low - boxes.high[axis][i]), 0.0);
            distances[i] += gap * gap;
        }
    }
}

void plainCountSmaller(std::span<const float> keys, std::span<std::uint32_t> counts) {
    std::ranges::fill(counts, 0U);
    for (const float other : keys) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            counts[i] += other < keys[i] ? 1U : 0U;
    }
}

#if defined(__x86_64__)
// No fused operations: they would round otherwise than the plain code does.

__attribute__((target("avx2"))) std::uint32_t avx2BlockDistances(const PointBlock& block, const Eigen::Vector3d& point,
                                                                 double limit, BlockDistances& distances) {
    const __m256d px = _mm256_set1_pd(point.x());
    const __m256d py = _mm256_set1_pd(point.y());
    const __m256d pz = _mm256_set1_pd(point.z());
    const __m256d most = _mm256_set1_pd(limit);
    std::uint32_t within = 0;
    for (std::size_t i = 0; i < kBlockSize; i += 4) {
        const __m256d x = _mm256_sub_pd(_mm256_load_pd(&block.at[0][i]), px);
        const __m256d y = _mm256_sub_pd(_mm256_load_pd(&block.at[1][i]), py);
        const __m256d z = _mm256_sub_pd(_mm256_load_pd(&block.at[2][i]), pz);
        const __m256d sum = _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(x, x), _mm256_mul_pd(y, y)), _mm256_mul_pd(z, z));
        _mm256_storeu_pd(&distances[i], sum);
        const auto mask = static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(sum, most, _CMP_LE_OQ)));
        within |= mask << i;
    }
    return within;
}

__attribute__((target("avx2"))) void avx2BoxDistances(const BoxGroup& boxes, const PointBox& box,
                                                      std::array<double, kBlockFan>& distances) {
    const __m256d zero = _mm256_setzero_pd();
    __m256d first = zero;
    __m256d second = zero;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const __m256d low = _mm256_set1_pd(box.low[static_cast<Eigen::Index>(axis)]);
        const __m256d high = _mm256_set1_pd(box.high[static_cast<Eigen::Index>(axis)]);
        const auto gap = [&](std::size_t i) __attribute__((target("avx2"))) {
            const __m256d above = _mm256_sub_pd(_mm256_load_pd(&boxes.low[axis][i]), high);
            const __m256d below = _mm256_sub_pd(low, _mm256_load_pd(&boxes.high[axis][i]));
            return _mm256_max_pd(_mm256_max_pd(above, below), zero);
        };
        const __m256d gapFirst = gap(0);
        const __m256d gapSecond = gap(4);
        first = _mm256_add_pd(first, _mm256_mul_pd(gapFirst, gapFirst));
        second = _mm256_add_pd(second, _mm256_mul_pd(gapSecond, gapSecond));
    }
    _mm256_storeu_pd(distances.data(), first);
    _mm256_storeu_pd(distances.data() + 4, second);
}

__attribute__((target("avx2"))) void avx2CountSmaller(std::span<const float> keys, std::span<std::uint32_t> counts) {
    for (std::size_t i = 0; i < keys.size(); i += kRankStep) {
        const __m256 first = _mm256_loadu_ps(&keys[i]);
        const __m256 second = _mm256_loadu_ps(&keys[i + 8]);
        __m256i countFirst = _mm256_setzero_si256();
        __m256i countSecond = _mm256_setzero_si256();
        for (const float& key : keys) {
            const __m256 other = _mm256_broadcast_ss(&key);
            // A true comparison is −1.
            countFirst = _mm256_sub_epi32(countFirst, _mm256_castps_si256(_mm256_cmp_ps(other, first, _CMP_LT_OQ)));
            countSecond = _mm256_sub_epi32(countSecond, _mm256_castps_si256(_mm256_cmp_ps(other, second, _CMP_LT_OQ)));
        }
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(&counts[i]), countFirst);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(&counts[i + 8]), countSecond);
    }
}

bool hasAvx2() {
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
}
#else
bool hasAvx2() {
    return false;
}
const auto avx2BlockDistances = plainBlockDistances;
const auto avx2BoxDistances = plainBoxDistances;
const auto avx2CountSmaller = plainCountSmaller;
#endif

}  // namespace

std::uint32_t squaredDistances(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                               BlockDistances& distances) {
    return hasAvx2() ? avx2BlockDistances(block, point, limit, distances)
                     : plainBlockDistances(block, point, limit, distances);
}

void squaredDistances(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances) {
    hasAvx2() ? avx2BoxDistances(boxes, box, distances) : plainBoxDistances(boxes, box, distances);
}

void countSmaller(std::span<const float> keys, std::span<std::uint32_t> counts) {
    hasAvx2() ? avx2CountSmaller(keys, counts) : plainCountSmaller(keys, counts);
}

}  // namespace fodscope
