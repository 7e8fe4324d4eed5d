// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"
#include "core/labels/Agreement.h"
#include "core/labels/ConfusionMatrix.h"

namespace fodscope {

/// FOD on each photo, by the photo's id, in the words of the session's label set; an empty set is `no FOD`.
using ActualLabels = std::map<std::string, std::set<std::string>>;

/// A session with what its photos really show, if anybody knows.
struct ReadSession {
    std::string file;
    std::string id;
    LabelSet labelSet;
    std::vector<std::string> photoIds;
    std::vector<Decision> decisions;
    std::optional<ActualLabels> actual;
    /// Where `actual` comes from, for the record.
    std::string truth;
};

struct ReaderFigures {
    std::string name;
    std::size_t photos = 0;
    /// Empty without truth.
    std::optional<double> accuracy;
};

/// How well readers name what photos show, and how far they agree.
struct ReaderAgreement {
    /// In alphabetical order.
    std::vector<ReaderFigures> readers;
    /// Labellers who know the truth and are no readers.
    std::vector<std::string> leftOut;
    std::size_t photos = 0;
    std::size_t photosWithoutReader = 0;
    /// Empty when no photo that was read has a truth.
    std::optional<ConfusionMatrix> confusion;
    AgreementStatistics statistics;
    std::size_t categories = 0;
};

/// Over readers and sessions: the last decision of each reader on each photo counts, and readers are told apart by
/// name. Copies of one session (equal ids) count as one: each reader may have worked on a copy.
/// @param isSimulated tells labellers who know the truth; they count only where no person has read anything and the
///        truth comes from elsewhere
/// @throws Error when nobody has labelled a photo
ReaderAgreement readerAgreement(std::span<const ReadSession> sessions,
                                const std::function<bool(const std::string&)>& isSimulated);

/// `agreement.json`: equal figures give an equal text.
std::string agreementJson(const ReaderAgreement& agreement, std::span<const ReadSession> sessions);

/// Matrix and statistics as text, and how they were counted.
std::string agreementText(const ReaderAgreement& agreement, std::span<const ReadSession> sessions);

}  // namespace fodscope
