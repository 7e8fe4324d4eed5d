// SPDX-License-Identifier: MIT
#include "ui/view3d/LabelPlacement.h"

#include <gtest/gtest.h>

namespace fodscope {
namespace {

const QRectF kArea(0, 0, 400, 300);

TEST(LabelPlacement, CrowdedLabelsDoNotOverlapOrLeaveTheArea) {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 12; ++i)
        requests.push_back({QPointF(200 + 4 * i, 150 + 3 * i), QSizeF(56, 22), 0});
    const auto labels = placeLabels(requests, kArea, {});
    int placed = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i].placed) continue;
        ++placed;
        EXPECT_TRUE(kArea.contains(labels[i].box));
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(labels[j].placed && labels[i].box.intersects(labels[j].box)) << i << " and " << j;
        }
    }
    EXPECT_GE(placed, 10);
}

TEST(LabelPlacement, KeepsOffBlockedAreas) {
    const std::vector<LabelRequest> requests = {{QPointF(200, 150), QSizeF(56, 22), 0}};
    const std::vector<QRectF> blocked = {QRectF(150, 60, 250, 80)};
    const auto labels = placeLabels(requests, kArea, blocked);
    ASSERT_TRUE(labels[0].placed);
    EXPECT_FALSE(labels[0].box.intersects(blocked[0]));
}

TEST(LabelPlacement, TheSelectedOneGetsThePlaceWhenThereIsOnlyOne) {
    const QRectF small(0, 0, 100, 60);
    const std::vector<LabelRequest> requests = {{QPointF(40, 50), QSizeF(56, 22), 0},
                                                {QPointF(42, 50), QSizeF(56, 22), 2}};
    const auto labels = placeLabels(requests, small, {});
    EXPECT_TRUE(labels[1].placed);
    EXPECT_FALSE(labels[0].placed);
}

TEST(LabelPlacement, AnchorsOutsideGetNoLabel) {
    const std::vector<LabelRequest> requests = {{QPointF(-5, 50), QSizeF(56, 22), 0}};
    EXPECT_FALSE(placeLabels(requests, kArea, {})[0].placed);
}

}  // namespace
}  // namespace fodscope
