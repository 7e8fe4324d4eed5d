// SPDX-License-Identifier: MIT
#include "core/cloud/BlockKernels.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>
#include <limits>

// Functions for AVX2 in a program for every x86-64: only what is marked may use it. No fused operations: they would
// round otherwise than the plain code does.
#define FODSCOPE_AVX2 __attribute__((target("avx2")))

namespace fodscope {
namespace {

constexpr std::size_t kLanes = 4;

struct Point4 {
    __m256d x;
    __m256d y;
    __m256d z;
};

FODSCOPE_AVX2 inline Point4 everywhere(const Eigen::Vector3d& point) {
    return {_mm256_set1_pd(point.x()), _mm256_set1_pd(point.y()), _mm256_set1_pd(point.z())};
}

FODSCOPE_AVX2 inline Point4 load(const PointBlock& block, std::size_t i) {
    return {_mm256_load_pd(&block.at[0][i]), _mm256_load_pd(&block.at[1][i]), _mm256_load_pd(&block.at[2][i])};
}

FODSCOPE_AVX2 inline __m256d squaredNorm(__m256d x, __m256d y, __m256d z) {
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(x, x), _mm256_mul_pd(y, y)), _mm256_mul_pd(z, z));
}

FODSCOPE_AVX2 inline __m256d squaredDistance(const Point4& a, const Point4& b) {
    return squaredNorm(_mm256_sub_pd(a.x, b.x), _mm256_sub_pd(a.y, b.y), _mm256_sub_pd(a.z, b.z));
}

FODSCOPE_AVX2 inline std::uint32_t bitsAtMost(__m256d values, __m256d limits) {
    return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(values, limits, _CMP_LE_OQ)));
}

FODSCOPE_AVX2 std::uint32_t squaredDistances(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                                             BlockDistances& distances) {
    const Point4 to = everywhere(point);
    const __m256d most = _mm256_set1_pd(limit);
    std::uint32_t within = 0;
    for (std::size_t i = 0; i < kBlockSize; i += kLanes) {
        const __m256d sum = squaredDistance(load(block, i), to);
        _mm256_storeu_pd(&distances[i], sum);
        within |= bitsAtMost(sum, most) << i;
    }
    return within;
}

/// For each set of four bits: where the elements whose bits are set come from, one behind the other.
struct Compression {
    alignas(32) std::array<std::array<std::uint32_t, 8>, 16> doubles{};
    alignas(16) std::array<std::array<std::uint32_t, 4>, 16> singles{};

    constexpr Compression() {
        for (std::uint32_t bits = 0; bits < 16; ++bits) {
            std::size_t place = 0;
            for (std::uint32_t i = 0; i < kLanes; ++i) {
                if ((bits >> i & 1U) == 0) continue;
                singles[bits][place] = i;
                doubles[bits][2 * place] = 2 * i;
                doubles[bits][2 * place + 1] = 2 * i + 1;
                ++place;
            }
        }
    }
};

FODSCOPE_AVX2 std::size_t takeWithin(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                                     double* distances, std::uint32_t* indices) {
    static constexpr Compression compression;
    const Point4 to = everywhere(point);
    const __m256d most = _mm256_set1_pd(limit);
    std::size_t count = 0;
    for (std::size_t i = 0; i < kBlockSize; i += kLanes) {
        const __m256d sum = squaredDistance(load(block, i), to);
        const std::uint32_t bits = bitsAtMost(sum, most);
        const auto* doubles = reinterpret_cast<const __m256i*>(compression.doubles[bits].data());
        const __m256i found = _mm256_permutevar8x32_epi32(_mm256_castpd_si256(sum), _mm256_load_si256(doubles));
        _mm256_storeu_pd(distances + count, _mm256_castsi256_pd(found));
        const auto* singles = reinterpret_cast<const __m128i*>(compression.singles[bits].data());
        const auto* originals = reinterpret_cast<const float*>(&block.original[i]);
        _mm_storeu_ps(reinterpret_cast<float*>(indices + count),
                      _mm_permutevar_ps(_mm_load_ps(originals), _mm_load_si128(singles)));
        // AVX2 processors count bits in one instruction, but compilers use it only when told.
        constexpr std::uint64_t bitCounts = 0x4332322132212110;
        count += bitCounts >> (4 * bits) & 15U;
    }
    return count;
}

FODSCOPE_AVX2 void boxDistances(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances) {
    const __m256d zero = _mm256_setzero_pd();
    for (std::size_t i = 0; i < kBlockFan; i += kLanes) {
        __m256d gaps[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const __m256d low = _mm256_set1_pd(box.low[static_cast<Eigen::Index>(axis)]);
            const __m256d high = _mm256_set1_pd(box.high[static_cast<Eigen::Index>(axis)]);
            const __m256d above = _mm256_sub_pd(_mm256_load_pd(&boxes.low[axis][i]), high);
            const __m256d below = _mm256_sub_pd(low, _mm256_load_pd(&boxes.high[axis][i]));
            gaps[axis] = _mm256_max_pd(_mm256_max_pd(above, below), zero);
        }
        _mm256_storeu_pd(&distances[i], squaredNorm(gaps[0], gaps[1], gaps[2]));
    }
}

FODSCOPE_AVX2 std::uint32_t nearBox(const PointBox& box, const PointBlock& points, const BlockDistances& limits) {
    const Point4 low = everywhere(box.low);
    const Point4 high = everywhere(box.high);
    const __m256d zero = _mm256_setzero_pd();
    const auto gap = [&](__m256d lowest, __m256d highest, __m256d at) FODSCOPE_AVX2 {
        return _mm256_max_pd(_mm256_max_pd(_mm256_sub_pd(lowest, at), _mm256_sub_pd(at, highest)), zero);
    };
    std::uint32_t near = 0;
    for (std::size_t i = 0; i < kBlockSize; i += kLanes) {
        const Point4 at = load(points, i);
        const __m256d sum = squaredNorm(gap(low.x, high.x, at.x), gap(low.y, high.y, at.y), gap(low.z, high.z, at.z));
        near |= bitsAtMost(sum, _mm256_loadu_pd(&limits[i])) << i;
    }
    return near;
}

FODSCOPE_AVX2 std::uint32_t leastDistances(const PointBlock& block, const PointBlock& points, std::uint32_t wanted,
                                           const BlockDistances& limits, BlockDistances& least) {
    std::uint32_t within = 0;
    const __m256d infinity = _mm256_set1_pd(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < kBlockSize; i += kLanes) {
        __m256d nearest = infinity;
        if ((wanted >> i & 15U) != 0) {
            const Point4 to = load(points, i);
            for (std::size_t p = 0; p < kBlockSize; ++p) {
                const Point4 from = {_mm256_broadcast_sd(&block.at[0][p]), _mm256_broadcast_sd(&block.at[1][p]),
                                     _mm256_broadcast_sd(&block.at[2][p])};
                nearest = _mm256_min_pd(nearest, squaredDistance(from, to));
            }
        }
        _mm256_storeu_pd(&least[i], nearest);
        within |= bitsAtMost(nearest, _mm256_loadu_pd(&limits[i])) << i;
    }
    return within & wanted;
}

FODSCOPE_AVX2 void widen(const SmallBlock& block, PointBlock& wide) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < kBlockSize; i += kLanes)
            _mm256_store_pd(&wide.at[axis][i], _mm256_cvtps_pd(_mm_load_ps(&block.at[axis][i])));
    }
    wide.original = block.original;
}

FODSCOPE_AVX2 void countSmaller(std::span<const std::int16_t> keys, std::span<std::uint16_t> counts) {
    constexpr std::size_t strip = 4;
    for (std::size_t first = 0; first < keys.size(); first += strip * kRankStep) {
        const std::size_t vectors = std::min(strip, (keys.size() - first) / kRankStep);
        __m256i own[strip];
        __m256i smaller[strip];
        for (std::size_t v = 0; v < strip; ++v) {
            const std::size_t at = first + std::min(v, vectors - 1) * kRankStep;
            own[v] = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(&keys[at]));
            smaller[v] = _mm256_setzero_si256();
        }
        const auto count = [&]<std::size_t of>() FODSCOPE_AVX2 {
            for (const std::int16_t key : keys) {
                const __m256i other = _mm256_set1_epi16(key);
                // A true comparison is −1.
                for (std::size_t v = 0; v < of; ++v)
                    smaller[v] = _mm256_sub_epi16(smaller[v], _mm256_cmpgt_epi16(own[v], other));
            }
        };
        vectors <= 1 ? count.template operator()<1>()
                     : (vectors == 2 ? count.template operator()<2>() : count.template operator()<strip>());
        for (std::size_t v = 0; v < vectors; ++v)
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(&counts[first + v * kRankStep]), smaller[v]);
    }
}

}  // namespace

const BlockKernels* avx2Kernels() {
    static constexpr BlockKernels kernels{squaredDistances, takeWithin, boxDistances, nearBox,
                                          leastDistances,   widen,      countSmaller};
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has ? &kernels : nullptr;
}

}  // namespace fodscope
#else
namespace fodscope {
const BlockKernels* avx2Kernels() {
    return nullptr;
}
}  // namespace fodscope
#endif
