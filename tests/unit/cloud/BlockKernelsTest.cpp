// SPDX-License-Identifier: MIT
#include "core/cloud/BlockKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Blocks of random points about a place, the last with few points.
std::vector<PointBlock> blocksAbout(const Eigen::Vector3d& place, double spread, std::uint64_t seed) {
    const auto points = randomPoints(100, seed);
    std::vector<PointBlock> blocks(7);
    for (std::size_t i = 0; i < blocks.size() * kBlockSize; ++i) {
        PointBlock& block = blocks[i / kBlockSize];
        block.original[i % kBlockSize] = static_cast<std::uint32_t>(7919 * i % 1000);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<Eigen::Index>(axis);
            block.at[axis][i % kBlockSize] = i < points.size() ? place[a] + spread * points[i][a] : kInfinity;
        }
    }
    return blocks;
}

/// Places and spreads for which rounding differs.
std::vector<std::vector<PointBlock>> allBlocks() {
    return {blocksAbout({0, 0, 0}, 1.0, 21),    blocksAbout({6.1e5, 5.3e6, -40.0}, 0.3, 22),
            blocksAbout({1, 2, 3}, 1e-9, 23),   blocksAbout({0, 0, 0}, 0.0, 24),
            blocksAbout({-1, 0, 1}, 1e200, 25), blocksAbout({0, 0, 0}, 1e-170, 26)};
}

template <std::size_t size>
std::array<std::uint64_t, size> bits(const std::array<double, size>& values) {
    std::array<std::uint64_t, size> result;
    std::ranges::transform(values, result.begin(), [](double value) { return std::bit_cast<std::uint64_t>(value); });
    return result;
}

PointBox boxOf(const PointBlock& block) {
    PointBox box;
    for (std::size_t i = 0; i < kBlockSize; ++i)
        if (block.at[0][i] < kInfinity) box.add(block.point(i));
    return box;
}

/// Both kinds of the kernels on the same input: the plain ones are what the others must equal, bit for bit.
class BlockKernelsTest : public testing::Test {
  protected:
    void SetUp() override {
        if (avx2Kernels() == nullptr) GTEST_SKIP() << "this processor has no AVX2";
    }
    const BlockKernels& plain = plainKernels();
    const BlockKernels& fast = bestKernels();
};

TEST_F(BlockKernelsTest, MeasureTheSameDistances) {
    for (const auto& blocks : allBlocks()) {
        for (const PointBlock& block : blocks) {
            for (std::size_t i = 0; i < kBlockSize; ++i) {
                const Eigen::Vector3d point = blocks.front().point(i);
                BlockDistances a;
                BlockDistances b;
                plain.squaredDistances(block, point, 0.0, a);
                const double limit = std::min(a[3], std::numeric_limits<double>::max());
                EXPECT_EQ(plain.squaredDistances(block, point, limit, a),
                          fast.squaredDistances(block, point, limit, b));
                EXPECT_EQ(bits(a), bits(b));
                const double x = block.at[0][5] - point.x();
                const double y = block.at[1][5] - point.y();
                const double z = block.at[2][5] - point.z();
                EXPECT_EQ(a[5], (x * x + y * y) + z * z);
            }
        }
    }
}

TEST_F(BlockKernelsTest, TakeTheSamePointsInTheSameOrder) {
    for (const auto& blocks : allBlocks()) {
        for (const PointBlock& block : blocks) {
            for (std::size_t i = 0; i < kBlockSize; ++i) {
                const Eigen::Vector3d point = blocks.front().point(i);
                BlockDistances all;
                plain.squaredDistances(block, point, 0.0, all);
                for (double limit : all) {
                    limit = std::min(limit, std::numeric_limits<double>::max());
                    BlockDistances a{};
                    BlockDistances b{};
                    std::array<std::uint32_t, kBlockSize> indicesA{};
                    std::array<std::uint32_t, kBlockSize> indicesB{};
                    const std::size_t count = plain.takeWithin(block, point, limit, a.data(), indicesA.data());
                    ASSERT_EQ(fast.takeWithin(block, point, limit, b.data(), indicesB.data()), count);
                    ASSERT_EQ(static_cast<std::ptrdiff_t>(count),
                              std::ranges::count_if(all, [&](double distance) { return distance <= limit; }));
                    EXPECT_TRUE(std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin()));
                    EXPECT_TRUE(std::equal(indicesA.begin(), indicesA.begin() + static_cast<std::ptrdiff_t>(count),
                                           indicesB.begin()));
                }
            }
        }
    }
}

TEST_F(BlockKernelsTest, MeasureTheSameDistancesToBoxes) {
    for (const auto& blocks : allBlocks()) {
        BoxGroup group;
        for (std::size_t i = 0; i < kBlockFan; ++i) {
            const PointBox box = i < blocks.size() ? boxOf(blocks[i]) : PointBox();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                group.low[axis][i] = box.low[static_cast<Eigen::Index>(axis)];
                group.high[axis][i] = box.high[static_cast<Eigen::Index>(axis)];
            }
        }
        for (const Eigen::Vector3d& shift : randomPoints(20, 27)) {
            PointBox box = boxOf(blocks[1]);
            box.low += shift;
            box.high += shift;
            std::array<double, kBlockFan> a;
            std::array<double, kBlockFan> b;
            plain.boxDistances(group, box, a);
            fast.boxDistances(group, box, b);
            EXPECT_EQ(bits(a), bits(b));
            EXPECT_EQ(a.back(), kInfinity);
            BlockDistances limits;
            for (std::size_t i = 0; i < kBlockSize; ++i)
                limits[i] = std::min(a[i % 7], std::numeric_limits<double>::max());
            EXPECT_EQ(plain.nearBox(box, blocks[2], limits), fast.nearBox(box, blocks[2], limits));
        }
    }
}

TEST_F(BlockKernelsTest, FindTheSameLeastDistances) {
    for (const auto& blocks : allBlocks()) {
        for (const PointBlock& block : blocks) {
            for (const std::uint32_t wanted : {0xFFFFU, 0x0001U, 0x8421U, 0x00F0U}) {
                BlockDistances limits;
                plain.squaredDistances(block, blocks[4].point(0), 0.0, limits);
                BlockDistances a;
                BlockDistances b;
                EXPECT_EQ(plain.leastDistances(block, blocks[3], wanted, limits, a),
                          fast.leastDistances(block, blocks[3], wanted, limits, b));
                for (std::size_t i = 0; i < kBlockSize; ++i) {
                    if ((wanted >> i & 1U) == 0) continue;
                    EXPECT_EQ(a[i], b[i]);
                }
            }
        }
    }
}

TEST_F(BlockKernelsTest, WidenFloatsAlike) {
    SmallBlock small;
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            small.at[axis][i] = i == 15 ? std::numeric_limits<float>::infinity() : 0.1F * static_cast<float>(i + axis);
        small.original[i] = static_cast<std::uint32_t>(i * i);
    }
    PointBlock a;
    PointBlock b;
    plain.widen(small, a);
    fast.widen(small, b);
    EXPECT_EQ(a.at, b.at);
    EXPECT_EQ(a.original, b.original);
    EXPECT_EQ(a.at[1][3], double{small.at[1][3]});
}

TEST_F(BlockKernelsTest, CountSmallerKeysAlike) {
    std::mt19937_64 generator(28);
    for (std::size_t size = kRankStep; size <= 320; size += kRankStep) {
        std::vector<std::int16_t> keys(size);
        for (std::int16_t& key : keys)
            key = static_cast<std::int16_t>(generator() % 200);
        keys.back() = std::numeric_limits<std::int16_t>::max();
        std::vector<std::uint16_t> a(size);
        std::vector<std::uint16_t> b(size);
        plain.countSmaller(keys, a);
        fast.countSmaller(keys, b);
        EXPECT_EQ(a, b);
        for (std::size_t i = 0; i < size; ++i)
            ASSERT_EQ(a[i], std::ranges::count_if(keys, [&](std::int16_t key) { return key < keys[i]; }));
    }
}

}  // namespace
}  // namespace fodscope
