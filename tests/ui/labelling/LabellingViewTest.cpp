// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingView.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/fakes/TankInspection.h"
#include "tests/ui/Screenshot.h"
#include "ui/labelling/PhotoCanvas.h"
#include "ui/labelling/ThumbnailStrip.h"
#include "ui/widgets/Toast.h"

namespace fodscope {
namespace {

using testing::ElementsAre;

/// The view with what stands behind it: an inspection that keeps decisions, or refuses to.
class Labelling : public testing::Test {
  protected:
    Labelling() {
        view.setLabelSet(state.labelSet);
        view.setPhotos(labelPhotos(state));
        view.setLabeller(QStringLiteral("Anna"));
        view.resize(1000, 700);
        view.show();
        view.setFocus();
        QObject::connect(
            &view, &LabellingView::decided, [this](const QString& photo, const auto& labels, const QString& comment) {
                if (diskIsFull)
                    return view.decisionFailed(QStringLiteral("tank.fodscope: the disk is full; free some space"));
                Decision decision;
                decision.photoId = photo.toStdString();
                decision.labeller = view.labeller().toStdString();
                decision.labels = labels;
                decision.comment = comment.toStdString();
                kept.push_back(decision);
                if (!diskIsSlow) view.setDecisions(kept);
            });
        QObject::connect(&view, &LabellingView::undoRequested, [this] {
            kept.push_back(*undoOf(kept, view.labeller().toStdString(), {}));
            view.setDecisions(kept);
        });
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&view, key, modifiers);
    }
    QString words(const char* name) { return view.findChild<QLabel*>(QLatin1String(name))->text(); }
    QString message() { return view.findChild<Toast*>()->message(); }
    QLineEdit* comment() { return view.findChild<QLineEdit*>(QStringLiteral("comment")); }
    PhotoCanvas* canvas() { return view.findChild<PhotoCanvas*>(); }
    void drawBox(QPoint from, QPoint to) {
        QTest::mousePress(canvas(), Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(canvas(), (from + to) / 2);
        QTest::mouseRelease(canvas(), Qt::LeftButton, Qt::NoModifier, to);
    }

    InspectionState state = tankInspection({.decided = false});
    std::vector<Decision> kept;
    bool diskIsFull = false;
    bool diskIsSlow = false;
    LabellingView view;
};

TEST_F(Labelling, AWholeReviewNeedsNoMouse) {
    const std::size_t count = state.photos.size();
    ASSERT_GE(count, 6U);
    for (std::size_t photo = 0; photo < count; ++photo)
        press(photo % 2 ? Qt::Key_0 : Qt::Key_1);
    ASSERT_EQ(kept.size(), count);
    for (std::size_t photo = 0; photo < count; ++photo) {
        EXPECT_EQ(kept[photo].photoId, state.photos[photo].id);
        EXPECT_EQ(kept[photo].labels.front().label, photo % 2 ? kNoFod : "hammer");
    }
    EXPECT_EQ(words("labellingProgress"), QStringLiteral("%1 of %1 decided").arg(count));
}

TEST_F(Labelling, ArrowsOnlyMove) {
    EXPECT_EQ(view.currentPhoto(), "P-001");
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    EXPECT_EQ(view.currentPhoto(), "P-003");
    press(Qt::Key_Left);
    EXPECT_EQ(view.currentPhoto(), "P-002");
    EXPECT_TRUE(kept.empty());
}

TEST_F(Labelling, TheNextPhotoWaitsForTheDisk) {
    diskIsSlow = true;
    press(Qt::Key_1);
    press(Qt::Key_2);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    EXPECT_EQ(kept.size(), 1U) << "a key while the decision is on its way is not a second decision";
    view.setDecisions(kept);
    EXPECT_EQ(view.currentPhoto(), "P-002");
}

TEST_F(Labelling, AFullDiskKeepsThePhotoAndSaysSo) {
    diskIsFull = true;
    press(Qt::Key_1);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    EXPECT_TRUE(message().contains(QStringLiteral("disk is full")));
    diskIsFull = false;
    press(Qt::Key_1);
    EXPECT_EQ(view.currentPhoto(), "P-002");
}

TEST_F(Labelling, NGoesToTheNextUndecidedPhoto) {
    press(Qt::Key_1);
    press(Qt::Key_1);
    press(Qt::Key_Home);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    press(Qt::Key_N);
    EXPECT_EQ(view.currentPhoto(), "P-003");
}

TEST_F(Labelling, NothingIsCarriedToTheNextPhoto) {
    comment()->setText(QStringLiteral("broken handle"));
    press(Qt::Key_1);
    EXPECT_EQ(kept.back().comment, "broken handle");
    EXPECT_TRUE(comment()->text().isEmpty());
    for (const auto* key : view.findChildren<QAbstractButton*>()) {
        if (key->objectName().startsWith(QStringLiteral("label:"))) {
            EXPECT_FALSE(key->isChecked());
        }
    }
}

TEST_F(Labelling, ShiftAddsALabelAndEnterDecides) {
    press(Qt::Key_1, Qt::ShiftModifier);
    press(Qt::Key_3, Qt::ShiftModifier);
    EXPECT_TRUE(kept.empty());
    press(Qt::Key_Return);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(labelsInWords(kept[0].labels), "hammer, tape measure");
    EXPECT_EQ(view.currentPhoto(), "P-002");
}

TEST_F(Labelling, AddAnotherByButtonOrKeyHoldsUntilEnter) {
    press(Qt::Key_A);
    press(Qt::Key_1);
    QTest::mouseClick(view.findChild<QAbstractButton*>(QStringLiteral("label:drill")), Qt::LeftButton);
    EXPECT_TRUE(kept.empty());
    press(Qt::Key_Return);
    EXPECT_EQ(labelsInWords(kept.at(0).labels), "hammer, drill");
    press(Qt::Key_1);
    EXPECT_EQ(kept.size(), 2U) << "adding ends with the photo";
}

TEST_F(Labelling, AKeyLabelsTheBoxThatWasDrawn) {
    drawBox({400, 200}, {520, 300});
    press(Qt::Key_2);
    EXPECT_TRUE(kept.empty());
    press(Qt::Key_Return);
    ASSERT_EQ(kept.size(), 1U);
    ASSERT_TRUE(kept[0].labels.front().box);
    EXPECT_EQ(kept[0].labels.front().label, "drill");
    const double scale = fittedViewport({1280, 720}, canvas()->size()).scale;
    EXPECT_NEAR(kept[0].labels.front().box->width_px, 120 / scale, 2.0);
    EXPECT_NEAR(kept[0].labels.front().box->height_px, 100 / scale, 2.0);
}

TEST_F(Labelling, ABoxWithoutLabelIsNeverDecided) {
    drawBox({400, 200}, {520, 300});
    press(Qt::Key_Return);
    EXPECT_TRUE(kept.empty());
    press(Qt::Key_0);
    EXPECT_TRUE(kept.empty()) << "a box marks something";
    press(Qt::Key_Backspace);
    press(Qt::Key_0);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(kept[0].labels.front().label, kNoFod);
}

TEST_F(Labelling, WhatWasBegunWaitsOnItsPhoto) {
    press(Qt::Key_1, Qt::ShiftModifier);
    comment()->setText(QStringLiteral("two of them"));
    press(Qt::Key_Right);
    EXPECT_TRUE(comment()->text().isEmpty());
    press(Qt::Key_Left);
    EXPECT_EQ(comment()->text(), "two of them");
    press(Qt::Key_Return);
    EXPECT_EQ(labelsInWords(kept.at(0).labels), "hammer");
}

TEST_F(Labelling, UndoGoesToThePhotoAndNamesWhatItUndid) {
    press(Qt::Key_1);
    EXPECT_EQ(view.currentPhoto(), "P-002");
    press(Qt::Key_Right);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    EXPECT_TRUE(message().contains(QStringLiteral("hammer"))) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("P-001")));
    EXPECT_EQ(words("labellingProgress"), QStringLiteral("0 of %1 decided").arg(state.photos.size()));
}

TEST_F(Labelling, AnUndoAskedForElsewhereIsShownAsWell) {
    press(Qt::Key_1);
    press(Qt::Key_Left);
    press(Qt::Key_2);
    press(Qt::Key_End);
    kept.push_back(*undoOf(kept, "Anna", {}));
    view.setDecisions(kept);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    EXPECT_TRUE(message().contains(QStringLiteral("drill"))) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("hammer"))) << "it is hammer again";
}

TEST_F(Labelling, UndoWithoutADecisionAsksForNothing) {
    QSignalSpy asked(&view, &LabellingView::undoRequested);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(asked.count(), 0);
    EXPECT_FALSE(message().isEmpty());
}

TEST_F(Labelling, ACorrectionStaysOnItsPhoto) {
    press(Qt::Key_1);
    press(Qt::Key_Left);
    press(Qt::Key_0);
    EXPECT_EQ(view.currentPhoto(), "P-001");
    EXPECT_EQ(kept.size(), 2U);
}

TEST_F(Labelling, KeysTypedIntoTheCommentAreText) {
    press(Qt::Key_M);
    QTest::keyClicks(comment(), QStringLiteral("1 nut, 0 bolts"));
    EXPECT_TRUE(kept.empty());
    QTest::keyClick(comment(), Qt::Key_Return);
    EXPECT_TRUE(kept.empty()) << "Enter leads back to the photo";
    press(Qt::Key_9);
    EXPECT_EQ(kept.at(0).comment, "1 nut, 0 bolts");
}

TEST_F(Labelling, ACommentAddedLaterIsALaterDecision) {
    press(Qt::Key_1);
    press(Qt::Key_Left);
    comment()->setText(QStringLiteral("taped handle"));
    QTest::keyClick(comment(), Qt::Key_Return);
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept[1].labels, kept[0].labels);
    EXPECT_EQ(kept[1].comment, "taped handle");
}

TEST_F(Labelling, OutlineAndContrastAreForLookingOnly) {
    EXPECT_TRUE(canvas()->outlineShown());
    press(Qt::Key_O);
    press(Qt::Key_C);
    EXPECT_FALSE(canvas()->outlineShown());
    EXPECT_TRUE(canvas()->contrast());
    press(Qt::Key_Right);
    EXPECT_TRUE(canvas()->contrast()) << "kept from photo to photo";
    EXPECT_TRUE(kept.empty());
}

TEST_F(Labelling, ReadersDoNotSeeEachOther) {
    press(Qt::Key_1);
    view.setLabeller(QStringLiteral("Piet"));
    EXPECT_EQ(words("labellingProgress"), QStringLiteral("0 of %1 decided").arg(state.photos.size()));
}

TEST_F(Labelling, AClickOnAThumbnailSelectsItsPhoto) {
    QSignalSpy selected(&view, &LabellingView::photoSelected);
    auto* strip = view.findChild<ThumbnailStrip*>();
    QTest::mouseClick(strip, Qt::LeftButton, Qt::NoModifier, {8 + 2 * 136 + 30, 30});
    EXPECT_EQ(view.currentPhoto(), "P-003");
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.at(0).at(0).toString(), "P-003");
}

TEST_F(Labelling, ACandidateSelectedElsewhereShowsItsPhoto) {
    view.setCandidate(QString::fromStdString(state.photos[2].candidateIds.front()));
    EXPECT_EQ(view.currentPhoto(), "P-003");
    view.setCandidate(QStringLiteral("C-999"));
    view.setCurrent(QStringLiteral("P-999"));
    EXPECT_EQ(view.currentPhoto(), "P-003");
}

TEST_F(Labelling, NewPhotosLeaveThePhotoInSight) {
    press(Qt::Key_Right);
    std::vector<LabelPhoto> more = labelPhotos(state);
    more.push_back(more.front());
    more.back().id = "P-999";
    view.setPhotos(more);
    EXPECT_EQ(view.currentPhoto(), "P-002");
}

TEST_F(Labelling, ABrokenPhotoCanOnlyBeNotSure) {
    std::vector<LabelPhoto> photos = labelPhotos(state);
    photos[0].bytes = photos[0].bytes.left(40);
    view.setPhotos(photos);
    press(Qt::Key_1);
    press(Qt::Key_0);
    EXPECT_TRUE(kept.empty());
    saveScreenshot(view, QStringLiteral("labelling-broken"));
    press(Qt::Key_U);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(kept[0].labels.front().label, kNotSure);
}

TEST_F(Labelling, WithoutPhotosKeysDoNothing) {
    view.setPhotos({});
    press(Qt::Key_1);
    press(Qt::Key_Right);
    press(Qt::Key_N);
    press(Qt::Key_Return);
    EXPECT_TRUE(kept.empty());
    EXPECT_TRUE(view.currentPhoto().isEmpty());
    saveScreenshot(view, QStringLiteral("labelling-empty"));
}

TEST_F(Labelling, TheNameIsAskedOnceBeforeTheFirstDecision) {
    view.setLabeller({});
    QSignalSpy named(&view, &LabellingView::labellerNamed);
    press(Qt::Key_1);
    EXPECT_TRUE(kept.empty());
    auto* name = view.findChild<QLineEdit*>(QStringLiteral("labellerName"));
    name->setText(QStringLiteral("  Anna  Bergström "));
    saveScreenshot(view, QStringLiteral("labelling-name"));
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(named.count(), 1);
    EXPECT_EQ(named.at(0).at(0).toString(), QStringLiteral("Anna Bergström"));
    press(Qt::Key_1);
    EXPECT_EQ(kept.at(0).labeller, "Anna Bergström");
}

TEST_F(Labelling, LooksAsDesigned) {
    press(Qt::Key_1);
    press(Qt::Key_0);
    press(Qt::Key_U);
    for (int turn = 0; turn < 40; ++turn)
        QCoreApplication::processEvents();
    view.resize(1300, 800);
    saveScreenshot(view, QStringLiteral("labelling-1920"));
    view.resize(760, 560);
    drawBox({300, 120}, {420, 220});
    press(Qt::Key_2);
    drawBox({150, 150}, {220, 220});
    saveScreenshot(view, QStringLiteral("labelling-1366"));
    press(Qt::Key_4);
    press(Qt::Key_C);
    press(Qt::Key_Z);
    saveScreenshot(view, QStringLiteral("labelling-draft"));
    SUCCEED();
}

}  // namespace
}  // namespace fodscope
