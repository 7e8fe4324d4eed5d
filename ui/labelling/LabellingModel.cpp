// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingModel.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <utility>

namespace fodscope {

std::vector<LabelPhoto> labelPhotos(const InspectionState& state) {
    std::vector<LabelPhoto> photos;
    photos.reserve(state.photos.size());
    for (const Photo& photo : state.photos) {
        LabelPhoto item;
        item.id = photo.id;
        item.candidateIds = photo.candidateIds;
        item.waypointId = photo.waypointId;
        item.taken = photo.taken;
        item.bytes =
            QByteArray(reinterpret_cast<const char*>(photo.bytes.data()), static_cast<int>(photo.bytes.size()));
        item.isOutlined = state.detection && state.detection->field && state.detection->candidates &&
                          photo.intrinsics.width_px > 0 && photo.intrinsics.fx_px > 0.0;
        if (item.isOutlined) item.outlines = candidateOutlines(*state.detection, photo);
        photos.push_back(std::move(item));
    }
    return photos;
}

QStringList shownInWords(const LabelPhoto& photo) {
    QStringList shown;
    QStringList outside;
    for (const std::string& id : photo.candidateIds) {
        const auto outline = std::ranges::find(photo.outlines, id, &CandidateOutline::candidateId);
        const bool isOutside = photo.isOutlined && (outline == photo.outlines.end() || outline->polygon_px.isEmpty());
        (isOutside ? outside : shown) << QString::fromStdString(id);
    }
    QStringList words;
    if (!shown.isEmpty()) words << QObject::tr("shows %1").arg(shown.join(QStringLiteral(", ")));
    if (!outside.isEmpty()) words << QObject::tr("outside the picture: %1").arg(outside.join(QStringLiteral(", ")));
    return words;
}

QString toWords(PhotoState state) {
    switch (state) {
        case PhotoState::Undecided:
            return QObject::tr("undecided");
        case PhotoState::NotSure:
            return QObject::tr("not sure");
        case PhotoState::NoFod:
            return QObject::tr("no FOD");
        case PhotoState::Fod:
            return QObject::tr("FOD");
    }
    return {};
}

PhotoState photoState(const Decision* decision, const LabelSet& labels) {
    if (!decision || decision->labels.empty()) return PhotoState::Undecided;
    const auto names = [&](LabelKind kind) {
        return std::any_of(decision->labels.begin(), decision->labels.end(),
                           [&](const PhotoLabel& given) { return kindOf(labels, given.label) == kind; });
    };
    if (names(LabelKind::Fod)) return PhotoState::Fod;
    return names(LabelKind::NotSure) ? PhotoState::NotSure : PhotoState::NoFod;
}

std::vector<PhotoState> photoStates(std::span<const LabelPhoto> photos, std::span<const Decision> decisions,
                                    const std::string& labeller, const LabelSet& labels) {
    std::vector<PhotoState> states;
    states.reserve(photos.size());
    for (const LabelPhoto& photo : photos) {
        states.push_back(photoState(lastDecision(decisions, photo.id, labeller), labels));
    }
    return states;
}

std::optional<int> nextUndecided(std::span<const PhotoState> states, int current) {
    const int count = static_cast<int>(states.size());
    for (int step = 1; step <= count; ++step) {
        const int index = (std::max(current, -1) + step) % count;
        if (states[static_cast<std::size_t>(index)] == PhotoState::Undecided) return index;
    }
    return std::nullopt;
}

QString progressText(std::span<const PhotoState> states) {
    if (states.empty()) return QObject::tr("no photos");
    const auto undecided = std::count(states.begin(), states.end(), PhotoState::Undecided);
    const auto notSure = std::count(states.begin(), states.end(), PhotoState::NotSure);
    QString text = QObject::tr("%1 of %2 decided").arg(states.size() - undecided).arg(states.size());
    if (notSure > 0) text += QObject::tr(" · %1 not sure").arg(notSure);
    return text;
}

QString labelsInWords(std::span<const PhotoLabel> labels) {
    QStringList words;
    for (const PhotoLabel& label : labels)
        words << QString::fromStdString(label.label);
    return words.isEmpty() ? QObject::tr("nothing") : words.join(QStringLiteral(", "));
}

int keyWithoutShift(int qtKey, bool shift, quint32 nativeScanCode) {
    if (!shift) return qtKey;
    constexpr quint32 kScanCodeOf1 = 10;
    if (nativeScanCode >= kScanCodeOf1 && nativeScanCode < kScanCodeOf1 + 9) {
        return Qt::Key_1 + static_cast<int>(nativeScanCode - kScanCodeOf1);
    }
    if (nativeScanCode == kScanCodeOf1 + 9) return Qt::Key_0;
    constexpr std::pair<int, int> kUsSigns[] = {{Qt::Key_Exclam, Qt::Key_1},     {Qt::Key_At, Qt::Key_2},
                                                {Qt::Key_NumberSign, Qt::Key_3}, {Qt::Key_Dollar, Qt::Key_4},
                                                {Qt::Key_Percent, Qt::Key_5},    {Qt::Key_AsciiCircum, Qt::Key_6},
                                                {Qt::Key_Ampersand, Qt::Key_7},  {Qt::Key_Asterisk, Qt::Key_8},
                                                {Qt::Key_ParenLeft, Qt::Key_9},  {Qt::Key_ParenRight, Qt::Key_0}};
    for (const auto& [sign, digit] : kUsSigns) {
        if (qtKey == sign) return digit;
    }
    return qtKey;
}

const Label* labelForKey(const LabelSet& labels, int qtKey) {
    if (qtKey <= 0x20 || qtKey >= 0x7f) return nullptr;
    const auto upper = [](int character) { return std::toupper(character); };
    for (const Label& label : labels.labels) {
        if (label.key != 0 && upper(static_cast<unsigned char>(label.key)) == upper(qtKey)) return &label;
    }
    return nullptr;
}

QString keyCapText(const Label& label) {
    return label.key == 0 ? QString() : QString(QChar::fromLatin1(label.key)).toUpper();
}

DraftStep giveLabel(const LabelDraft& draft, const Label& label, bool addAnother) {
    DraftStep step{draft, std::nullopt, {}};
    const bool isNoFod = label.kind == LabelKind::NoFod;
    if (isNoFod && draft.openBox) {
        step.refusal = QObject::tr("The box waits for a label of FOD. Backspace takes the box away.");
        return step;
    }
    if (isNoFod && !draft.labels.empty()) {
        step.refusal = QObject::tr("“no FOD” cannot stand beside %1. Backspace takes the last label away.")
                           .arg(labelsInWords(draft.labels));
        return step;
    }
    if (draft.openBox) {
        step.draft.labels.push_back({label.name, draft.openBox});
        step.draft.openBox.reset();
        return step;
    }
    if (isNoFod && addAnother) {
        step.refusal = QObject::tr("“no FOD” stands alone: press %1 without Shift.").arg(keyCapText(label));
        return step;
    }
    step.draft.labels.push_back({label.name, std::nullopt});
    if (!addAnother) step.decision = step.draft.labels;
    return step;
}

DraftStep finishDraft(const LabelDraft& draft) {
    DraftStep step{draft, std::nullopt, {}};
    if (draft.openBox) {
        step.refusal = QObject::tr("Give the box a label first, or take it away with Backspace.");
    } else if (!draft.labels.empty()) {
        step.decision = draft.labels;
    }
    return step;
}

LabelDraft dropLast(LabelDraft draft) {
    if (draft.openBox) {
        draft.openBox.reset();
    } else if (!draft.labels.empty()) {
        draft.labels.pop_back();
    }
    return draft;
}

std::optional<TakenBack> takenBack(std::span<const Decision> before, std::span<const Decision> after,
                                   const std::string& labeller) {
    if (after.size() != before.size() + 1 || !std::equal(before.begin(), before.end(), after.begin())) {
        return std::nullopt;
    }
    const Decision& act = after.back();
    if (!act.takesBack || act.labeller != labeller) return std::nullopt;
    const Decision* counted = lastDecision(before, act.photoId, labeller);
    return TakenBack{act.photoId, counted ? counted->labels : std::vector<PhotoLabel>{}};
}

bool hasDecisions(std::span<const Decision> decisions, const std::string& labeller) {
    return std::any_of(decisions.begin(), decisions.end(), [&](const Decision& decision) {
        return lastDecision(decisions, decision.photoId, labeller) != nullptr;
    });
}

}  // namespace fodscope
