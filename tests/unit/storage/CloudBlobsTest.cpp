// SPDX-License-Identifier: MIT
#include "storage/CloudBlobs.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/common/Error.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

double doubleAt(const std::vector<std::byte>& bytes, std::size_t offset) {
    double value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(CloudBlobs, ReferenceLiesAsDocumented) {
    const Blob blob = encodeReference(test::sampleReference());
    EXPECT_EQ(blob.format, "fodscope.reference/1");
    ASSERT_EQ(blob.bytes.size(), 8u + 8 + 4 + 3 * (24 + 4 + 4 + 48 + 1));
    EXPECT_EQ(std::memcmp(blob.bytes.data(), "FODSREF1", 8), 0);
    EXPECT_EQ(blob.bytes[8], std::byte{3});
    EXPECT_EQ(blob.bytes[16], std::byte{0b1111});
    EXPECT_EQ(doubleAt(blob.bytes, 20), 0.1);
    EXPECT_EQ(doubleAt(blob.bytes, 20 + 3 * (24 + 8) + 8), 2e-5);  // cov_xy of the first point
}

TEST(CloudBlobs, ReferenceWithoutCovariancesStaysWithout) {
    ReferenceMap reference;
    reference.points = {{1, 2, 3}};
    const ReferenceMap read = decodeReference(encodeReference(reference).bytes, "s");
    EXPECT_EQ(read.points, reference.points);
    EXPECT_FALSE(read.hasCovariance());
    EXPECT_TRUE(read.occupancy.empty());
}

TEST(CloudBlobs, EveryTruncationIsRefused) {
    const DetectionResult detection = test::sampleDetection();
    const std::vector<Blob> blobs{encodeReference(test::sampleReference()), encodeField(*detection.field),
                                  encodeVoxels(*detection.candidates), encodeCoverage(*detection.coverage),
                                  encodeGrid(test::sampleGrid())};
    const auto decode = [](std::size_t which, std::span<const std::byte> bytes) {
        if (which == 0) decodeReference(bytes, "s");
        if (which == 1) decodeField(bytes, "s");
        if (which == 2) decodeVoxels(bytes, "s");
        if (which == 3) decodeCoverage(bytes, "s");
        if (which == 4) decodeGrid(bytes, "s");
    };
    for (std::size_t which = 0; which < blobs.size(); ++which) {
        EXPECT_NO_THROW(decode(which, blobs[which].bytes));
        for (std::size_t size = 0; size < blobs[which].bytes.size(); ++size) {
            EXPECT_THROW(decode(which, std::span(blobs[which].bytes).first(size)), Error) << which << " " << size;
        }
        std::vector<std::byte> longer = blobs[which].bytes;
        longer.push_back(std::byte{0});
        EXPECT_THROW(decode(which, longer), Error);
    }
}

TEST(CloudBlobs, AbsurdCountsAllocateNothing) {
    std::vector<std::byte> bytes = encodeReference(test::sampleReference()).bytes;
    for (std::size_t i = 8; i < 16; ++i) {
        bytes[i] = std::byte{0xFF};
    }
    EXPECT_THROW(decodeReference(bytes, "s"), Error);
}

TEST(CloudBlobs, CellsOtherThanTheThreeAreRefused) {
    std::vector<std::byte> bytes = encodeGrid(test::sampleGrid()).bytes;
    bytes.back() = std::byte{3};
    EXPECT_THROW(decodeGrid(bytes, "s"), Error);
}

}  // namespace
}  // namespace fodscope
