// SPDX-License-Identifier: MIT
#include "ui/report/ReportWriter.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/inspection/ReportModel.h"
#include "ui/report/ReportApplication.h"
#include "ui/report/ReportDocument.h"
#include "ui/report/ReportHtml.h"
#include "ui/report/ReportPdf.h"

namespace fodscope {

namespace {

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension;
}

void writeBytes(const std::filesystem::path& file, const QByteArray& bytes) {
    writeFile(file, std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size()))));
}

}  // namespace

void writeReport(const InspectionState& state, const std::string& headHash, const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    if (extension == ".csv") return writeFile(file, reportCsv(state));
    if (extension == ".json") return writeFile(file, sessionJson(state));
    const bool isPdf = extension == ".pdf";
    if (!isPdf && extension != ".html" && extension != ".htm") {
        throw Error(file.string(), "no report is written in this form", "name it .pdf, .html, .csv or .json");
    }
    const ReportApplication application;
    const auto content = report::reportContent(state, headHash);
    writeBytes(file, isPdf ? report::reportPdf(content) : report::reportHtml(*content));
}

}  // namespace fodscope
