// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingModel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fodscope {
namespace {

using testing::ElementsAre;

LabelSet toolLabels() {
    return parseLabelSet("name: Tools\nlabels: [{name: hammer, key: 1}, {name: glove, key: 2}]\n", "test");
}

Decision decision(const std::string& photo, const std::string& labeller, const std::vector<std::string>& labels) {
    Decision made;
    made.photoId = photo;
    made.labeller = labeller;
    for (const std::string& label : labels)
        made.labels.push_back({label, std::nullopt});
    return made;
}

std::vector<LabelPhoto> photos(int count) {
    std::vector<LabelPhoto> list(static_cast<std::size_t>(count));
    for (int index = 0; index < count; ++index)
        list[static_cast<std::size_t>(index)].id = "P-" + std::to_string(index);
    return list;
}

TEST(LabelPhotoWords, CandidateOutsideThePictureIsNeverSaidToBeShown) {
    LabelPhoto photo;
    photo.candidateIds = {"C-001", "C-002"};
    EXPECT_EQ(shownInWords(photo).join("; "), "shows C-001, C-002") << "without a camera nothing is known of it";
    photo.isOutlined = true;
    photo.outlines = {{"C-001", QPolygonF(QRectF(0, 0, 10, 10))}};
    EXPECT_EQ(shownInWords(photo).join("; "), "shows C-001; outside the picture: C-002");
    photo.outlines.clear();
    EXPECT_EQ(shownInWords(photo).join("; "), "outside the picture: C-001, C-002");
}

TEST(LabelKeys, DigitsAndLettersOfEitherCaseGiveTheirLabel) {
    const LabelSet labels = toolLabels();
    EXPECT_EQ(labelForKey(labels, Qt::Key_1)->name, "hammer");
    EXPECT_EQ(labelForKey(labels, Qt::Key_0)->name, kNoFod);
    EXPECT_EQ(labelForKey(labels, 'u')->name, kNotSure);
    EXPECT_EQ(labelForKey(labels, Qt::Key_U)->name, kNotSure);
    EXPECT_EQ(labelForKey(labels, Qt::Key_3), nullptr);
}

TEST(LabelKeys, KeysThatMoveNeverDecide) {
    const LabelSet labels = toolLabels();
    for (const int key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Tab, Qt::Key_Return,
                          Qt::Key_Space, Qt::Key_N, Qt::Key_Escape, Qt::Key_F1}) {
        EXPECT_EQ(labelForKey(labels, key), nullptr) << key;
    }
}

TEST(LabelKeys, ShiftedDigitsAreFoundByTheirPlaceOnTheKeyboard) {
    EXPECT_EQ(keyWithoutShift(Qt::Key_Exclam, true, 10), Qt::Key_1);
    EXPECT_EQ(keyWithoutShift(Qt::Key_QuoteDbl, true, 11), Qt::Key_2) << "Shift+2 on a German keyboard";
    EXPECT_EQ(keyWithoutShift(Qt::Key_Equal, true, 19), Qt::Key_0) << "Shift+0 on a German keyboard";
    EXPECT_EQ(keyWithoutShift(Qt::Key_Ampersand, true, 0), Qt::Key_7) << "no scan code: the signs of the US layout";
    EXPECT_EQ(keyWithoutShift(Qt::Key_1, false, 10), Qt::Key_1);
    EXPECT_EQ(keyWithoutShift(Qt::Key_U, true, 30), Qt::Key_U);
}

TEST(LabelDraftSteps, AKeyOnAnUntouchedPhotoIsTheDecision) {
    const LabelSet labels = toolLabels();
    const DraftStep step = giveLabel({}, *labels.find("hammer"), false);
    ASSERT_TRUE(step.decision);
    EXPECT_THAT(*step.decision, ElementsAre(PhotoLabel{"hammer", std::nullopt}));
}

TEST(LabelDraftSteps, SeveralThingsOnAPhotoAreOneDecision) {
    const LabelSet labels = toolLabels();
    const DraftStep first = giveLabel({}, *labels.find("hammer"), true);
    EXPECT_FALSE(first.decision);
    const DraftStep second = giveLabel(first.draft, *labels.find("glove"), true);
    EXPECT_FALSE(second.decision);
    const DraftStep done = finishDraft(second.draft);
    ASSERT_TRUE(done.decision);
    EXPECT_EQ(labelsInWords(*done.decision), "hammer, glove");
}

TEST(LabelDraftSteps, ABoxTakesItsLabelAndTheDecisionWaits) {
    const LabelSet labels = toolLabels();
    LabelDraft draft;
    draft.openBox = PixelBox{1, 2, 30, 40};
    const DraftStep step = giveLabel(draft, *labels.find("glove"), false);
    EXPECT_FALSE(step.decision);
    EXPECT_FALSE(step.draft.openBox);
    EXPECT_THAT(step.draft.labels, ElementsAre(PhotoLabel{"glove", PixelBox{1, 2, 30, 40}}));
}

TEST(LabelDraftSteps, NoFodStandsAlone) {
    const LabelSet labels = toolLabels();
    LabelDraft draft;
    draft.labels = {{"hammer", std::nullopt}};
    const DraftStep step = giveLabel(draft, *labels.find(kNoFod), false);
    EXPECT_FALSE(step.decision);
    EXPECT_FALSE(step.refusal.isEmpty());
    EXPECT_THAT(step.draft.labels, ElementsAre(PhotoLabel{"hammer", std::nullopt}));
    draft = {};
    draft.openBox = PixelBox{0, 0, 9, 9};
    EXPECT_FALSE(giveLabel(draft, *labels.find(kNoFod), false).refusal.isEmpty());
    EXPECT_FALSE(giveLabel({}, *labels.find(kNoFod), true).refusal.isEmpty());
}

TEST(LabelDraftSteps, ABoxWithoutLabelIsNotDecided) {
    LabelDraft draft;
    draft.openBox = PixelBox{0, 0, 9, 9};
    const DraftStep step = finishDraft(draft);
    EXPECT_FALSE(step.decision);
    EXPECT_FALSE(step.refusal.isEmpty());
    EXPECT_FALSE(finishDraft({}).decision);
}

TEST(LabelDraftSteps, TheBoxIsDroppedBeforeTheLabels) {
    LabelDraft draft;
    draft.labels = {{"hammer", std::nullopt}};
    draft.openBox = PixelBox{0, 0, 9, 9};
    draft = dropLast(draft);
    EXPECT_FALSE(draft.openBox);
    EXPECT_EQ(draft.labels.size(), 1U);
    EXPECT_TRUE(dropLast(draft).isEmpty());
}

TEST(PhotoStates, AreTheReadersOwn) {
    const std::vector<Decision> decisions{decision("P-0", "Anna", {"hammer"}), decision("P-1", "Anna", {kNoFod}),
                                          decision("P-2", "Anna", {kNotSure}), decision("P-3", "Piet", {"hammer"})};
    EXPECT_THAT(photoStates(photos(4), decisions, "Anna", toolLabels()),
                ElementsAre(PhotoState::Fod, PhotoState::NoFod, PhotoState::NotSure, PhotoState::Undecided));
    EXPECT_THAT(photoStates(photos(4), decisions, "Piet", toolLabels()),
                ElementsAre(PhotoState::Undecided, PhotoState::Undecided, PhotoState::Undecided, PhotoState::Fod));
}

TEST(PhotoStates, AnUndoneDecisionIsUndecided) {
    const std::vector<Decision> decisions{decision("P-0", "Anna", {"hammer"}), decision("P-0", "Anna", {})};
    EXPECT_THAT(photoStates(photos(1), decisions, "Anna", toolLabels()), ElementsAre(PhotoState::Undecided));
    EXPECT_FALSE(hasDecisions(decisions, "Anna"));
}

TEST(PhotoStates, AFodLabelOfAnEarlierSetIsStillFod) {
    const Decision made = decision("P-0", "Anna", {"torch"});
    EXPECT_EQ(photoState(&made, toolLabels()), PhotoState::Fod);
}

TEST(NextUndecided, GoesRoundFromTheCurrentPhoto) {
    const auto u = PhotoState::Undecided;
    const auto d = PhotoState::NoFod;
    EXPECT_EQ(nextUndecided(std::vector{u, d, u, d}, 0), 2);
    EXPECT_EQ(nextUndecided(std::vector{u, d, u, d}, 2), 0);
    EXPECT_EQ(nextUndecided(std::vector{d, d, u}, -1), 2);
    EXPECT_EQ(nextUndecided(std::vector{d, u, d}, 1), 1) << "the only one left is the current one";
    EXPECT_EQ(nextUndecided(std::vector{d, d}, 0), std::nullopt);
    EXPECT_EQ(nextUndecided({}, -1), std::nullopt);
}

TEST(ProgressText, CountsDecidedAndNotSure) {
    std::vector<PhotoState> states(47, PhotoState::Undecided);
    std::fill_n(states.begin(), 9, PhotoState::NoFod);
    std::fill_n(states.begin() + 9, 3, PhotoState::NotSure);
    EXPECT_EQ(progressText(states), QStringLiteral("12 of 47 decided · 3 not sure"));
    EXPECT_EQ(progressText(std::vector(2, PhotoState::Fod)), "2 of 2 decided");
    EXPECT_EQ(progressText({}), "no photos");
}

TEST(TakenBack, NamesThePhotoAndWhatCountedBefore) {
    std::vector<Decision> before{decision("P-0", "Anna", {"hammer"}), decision("P-1", "Piet", {"glove"})};
    std::vector<Decision> after = before;
    after.push_back(*undoOf(before, "Anna", {}));
    EXPECT_FALSE(takenBack(before, after, "Piet")) << "Anna's act is none of Piet's";
    EXPECT_FALSE(takenBack({}, after, "Anna")) << "a session that is opened undoes nothing";
    const auto undone = takenBack(before, after, "Anna");
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->photoId, "P-0");
    EXPECT_EQ(labelsInWords(undone->labels), "hammer");
}

}  // namespace
}  // namespace fodscope
