// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/evaluation/ReaderAgreement.h"
#include "core/evaluation/TextTable.h"
#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;
constexpr std::size_t kLineWidth = 110;

Json orNull(const std::optional<double>& value) {
    return value ? rounded(*value) : Json(nullptr);
}

std::string orUnknown(const std::optional<double>& value) {
    return value ? fixed(*value, 3) : "-";
}

std::vector<std::string> howCounted(const ReaderAgreement& agreement, std::span<const ReadSession> sessions) {
    std::vector<std::string> lines;
    lines.push_back(std::to_string(sessions.size()) + " sessions with " + std::to_string(agreement.photos) +
                    " photos, " + std::to_string(agreement.photosWithoutReader) +
                    " of them read by nobody. The last decision of each reader on each photo counts; copies of one "
                    "session count as one.");
    std::string leftOut;
    for (const std::string& name : agreement.leftOut)
        leftOut += (leftOut.empty() ? "" : ", ") + name;
    if (!leftOut.empty()) lines.push_back("Left out, for it knows the truth: " + leftOut + ".");
    if (agreement.confusion) {
        lines.push_back(
            "Rows are what was labelled, columns what the photo shows (FOD that covers at least 200 pixels). A label "
            "that names a FOD on the photo is right. Of what is left over: 'no FOD' and 'not sure' go to the FOD's "
            "column, to 'mixed' when there are several; one wrong label and one FOD left go to their cell; labels "
            "without a FOD left go to column 'no FOD', FOD without a label left to row 'missed'; anything else is "
            "'mixed'.");
        lines.push_back("Accuracy is the trace over the total; 'not sure' counts as wrong.");
    } else {
        lines.push_back(
            "What the photos really show is not known here, so there is no confusion matrix; give --worlds.");
    }
    lines.push_back("Agreement is over the photos with at least two readers and " +
                    std::to_string(agreement.categories) +
                    " categories: every label that can be given, and every combination of labels that was. Cohen's "
                    "kappa exists for two readers only. '-' is undefined.");
    return lines;
}

std::string matrixText(const ConfusionMatrix& matrix) {
    Rows rows = {{"labelled \\ actual"}};
    rows[0].insert(rows[0].end(), matrix.columns.begin(), matrix.columns.end());
    for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        rows.push_back({matrix.rows[i]});
        for (const std::size_t count : matrix.counts[i])
            rows.back().push_back(std::to_string(count));
    }
    return "Confusion matrix\n" + textTable(rows) + "\nAccuracy " + std::to_string(matrix.correct()) + " / " +
           std::to_string(matrix.total()) + " = " + orUnknown(matrix.accuracy()) + "\n\n";
}

}  // namespace

std::string agreementJson(const ReaderAgreement& agreement, std::span<const ReadSession> sessions) {
    Json root = {{"schema", "fodscope.agreement/1"}, {"sessions", Json::array()}, {"readers", Json::array()}};
    for (const ReadSession& session : sessions)
        root["sessions"].push_back({{"file", session.file},
                                    {"photos", session.photoIds.size()},
                                    {"truth", session.actual ? Json(session.truth) : Json(nullptr)}});
    for (const ReaderFigures& reader : agreement.readers)
        root["readers"].push_back(
            {{"name", reader.name}, {"photos", reader.photos}, {"accuracy", orNull(reader.accuracy)}});
    root["left_out"] = agreement.leftOut;
    root["photos"] = agreement.photos;
    root["photos_without_reader"] = agreement.photosWithoutReader;
    root["confusion_matrix"] = nullptr;
    root["accuracy"] = nullptr;
    if (agreement.confusion) {
        const ConfusionMatrix& matrix = *agreement.confusion;
        root["confusion_matrix"] = {{"rows", matrix.rows}, {"columns", matrix.columns}, {"counts", matrix.counts}};
        root["accuracy"] = orNull(matrix.accuracy());
        root["correct"] = matrix.correct();
        root["total"] = matrix.total();
    }
    const AgreementStatistics& statistics = agreement.statistics;
    root["agreement"] = {{"readers", statistics.readers},
                         {"n", statistics.items},
                         {"categories", agreement.categories},
                         {"raw", orNull(statistics.raw)},
                         {"cohen_kappa", orNull(statistics.cohenKappa)},
                         {"fleiss_kappa", orNull(statistics.fleissKappa)},
                         {"gwet_ac1", orNull(statistics.gwetAc1)}};
    root["how_counted"] = howCounted(agreement, sessions);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string agreementText(const ReaderAgreement& agreement, std::span<const ReadSession> sessions) {
    std::string text = agreement.confusion ? matrixText(*agreement.confusion) : "";
    Rows rows = {{"reader", "photos", "accuracy"}};
    for (const ReaderFigures& reader : agreement.readers)
        rows.push_back({reader.name, std::to_string(reader.photos), orUnknown(reader.accuracy)});
    text += "Readers\n" + textTable(rows);
    const AgreementStatistics& statistics = agreement.statistics;
    text += "\nAgreement between readers\n" +
            textTable(
                {{"readers", "photos", "raw", "Cohen's kappa", "Fleiss' kappa", "Gwet's AC1"},
                 {std::to_string(statistics.readers), std::to_string(statistics.items), orUnknown(statistics.raw),
                  orUnknown(statistics.cohenKappa), orUnknown(statistics.fleissKappa), orUnknown(statistics.gwetAc1)}});
    text += "\nHow it was counted\n";
    for (const std::string& line : howCounted(agreement, sessions))
        text += wrapped(line, kLineWidth);
    return text;
}

}  // namespace fodscope
