// SPDX-License-Identifier: MIT
#include "ui/theme/Colours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fodscope {
namespace {

struct PublishedColour {
    int index;
    double red;
    double green;
    double blue;
};

// matplotlib 3.6, _cm_listed.py, _viridis_data[index] of 256.
constexpr PublishedColour kMatplotlib[] = {{0, 0.267004, 0.004874, 0.329415},
                                           {64, 0.229739, 0.322361, 0.545706},
                                           {128, 0.127568, 0.566949, 0.550556},
                                           {191, 0.360741, 0.785964, 0.387814},
                                           {255, 0.993248, 0.906157, 0.143936}};

TEST(Colours, ViridisIsMatplotlibs) {
    for (const PublishedColour& published : kMatplotlib) {
        const QColor colour = viridis(published.index / 255.0);
        EXPECT_NEAR(colour.redF(), published.red, 0.5 / 255.0 + 1e-4) << published.index;
        EXPECT_NEAR(colour.greenF(), published.green, 0.5 / 255.0 + 1e-4) << published.index;
        EXPECT_NEAR(colour.blueF(), published.blue, 0.5 / 255.0 + 1e-4) << published.index;
    }
}

TEST(Colours, ViridisGetsLighterAllTheWay) {
    double before = -1.0;
    for (int i = 0; i <= 1000; ++i) {
        const QColor colour = viridis(i / 1000.0);
        const double lightness = 0.2126 * colour.redF() + 0.7152 * colour.greenF() + 0.0722 * colour.blueF();
        EXPECT_GE(lightness, before - 1e-3) << i;
        before = lightness;
    }
}

TEST(Colours, ViridisClampsAndHasNoColourForNaN) {
    EXPECT_EQ(viridis(-3.0), viridis(0.0));
    EXPECT_EQ(viridis(7.0), viridis(1.0));
    EXPECT_EQ(viridis(INFINITY), viridis(1.0));
    EXPECT_FALSE(viridis(std::nan("")).isValid());
}

TEST(Colours, CandidateColoursAreOkabeItosAndDistinct) {
    EXPECT_EQ(candidateColour(0), QColor(230, 159, 0));
    EXPECT_EQ(candidateColour(1), QColor(86, 180, 233));
    EXPECT_EQ(candidateColour(4), QColor(0, 114, 178));
    for (int i = 0; i < kCandidateColours; ++i) {
        for (int j = 0; j < i; ++j) {
            const QColor a = candidateColour(i);
            const QColor b = candidateColour(j);
            EXPECT_GT(std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()), 80)
                << i << " and " << j;
        }
    }
    EXPECT_EQ(candidateColour(8), candidateColour(0));
    EXPECT_EQ(candidateColour(-1), candidateColour(7));
}

TEST(Colours, ACandidateKeepsItsColourByItsId) {
    EXPECT_EQ(candidateColour(QStringLiteral("C-001")), candidateColour(0));
    EXPECT_EQ(candidateColour(QStringLiteral("C-010")), candidateColour(9));
    EXPECT_TRUE(candidateColour(QStringLiteral("odd name")).isValid());
    EXPECT_TRUE(candidateColour(QString()).isValid());
}

}  // namespace
}  // namespace fodscope
