// SPDX-License-Identifier: MIT
#include "ui/report/ReportWriter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QBuffer>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/inspection/ReportModel.h"
#include "tests/fakes/TankInspection.h"
#include "ui/report/EvidencePhoto.h"
#include "ui/report/HtmlText.h"

namespace fodscope {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kHead = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";

class Report : public testing::Test {
  protected:
    std::filesystem::path file(const char* name) const {
        return std::filesystem::path(folder.path().toStdString()) / name;
    }

    std::string run(const QString& program, const QStringList& arguments) const {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(60000)) << program.toStdString();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        return process.readAllStandardOutput().toStdString();
    }

    /// The text of a PDF with all blanks made one, as lines break where the page ends.
    std::string pdfText(const std::filesystem::path& pdf) const {
        const std::string text =
            run(QStringLiteral("pdftotext"),
                {QStringLiteral("-layout"), QString::fromStdString(pdf.string()), QStringLiteral("-")});
        return QString::fromStdString(text).simplified().toStdString();
    }

    std::string pdfReadingOrder(const std::filesystem::path& pdf) const {
        const std::string text =
            run(QStringLiteral("pdftotext"), {QString::fromStdString(pdf.string()), QStringLiteral("-")});
        return QString::fromStdString(text).simplified().toStdString();
    }

    QTemporaryDir folder;
    InspectionState state = tankInspection();
};

std::vector<ReportCandidate> allCandidates(const ReportModel& model) {
    std::vector<ReportCandidate> all = model.findings;
    all.insert(all.end(), model.open.begin(), model.open.end());
    all.insert(all.end(), model.rejected.begin(), model.rejected.end());
    return all;
}

TEST_F(Report, ThePdfTellsWhatTheModelTells) {
    writeReport(state, kHead, file("report.pdf"));
    const std::string text = pdfReadingOrder(file("report.pdf"));
    const ReportModel model = makeReportModel(state);
    EXPECT_THAT(text, HasSubstr(model.title));
    EXPECT_THAT(text, HasSubstr(model.statement));
    EXPECT_THAT(text, HasSubstr(kHead));
    EXPECT_THAT(text, HasSubstr(state.header.id));
    EXPECT_THAT(text, HasSubstr("page 1 of "));
    ASSERT_EQ(allCandidates(model).size(), 8U);
    for (const ReportCandidate& candidate : allCandidates(model))
        EXPECT_THAT(text, HasSubstr(candidate.id));
    for (const ReportCandidate& finding : model.findings) {
        EXPECT_THAT(text, HasSubstr(finding.id + " · " + finding.verdictText));
        for (const ReportField& field : finding.fields)
            EXPECT_THAT(text, HasSubstr(field.value));
    }
    for (const ReportField& field : model.counts)
        EXPECT_THAT(text, HasSubstr(field.value));
}

TEST_F(Report, TheFontsOfThePdfAreEmbedded) {
    writeReport(state, kHead, file("report.pdf"));
    const std::string fonts = run(QStringLiteral("pdffonts"), {QString::fromStdString(file("report.pdf").string())});
    EXPECT_THAT(fonts, HasSubstr("DejaVu"));
    const QStringList lines = QString::fromStdString(fonts).split('\n', Qt::SkipEmptyParts).mid(2);
    for (const QString& line : lines)
        EXPECT_TRUE(line.contains(QStringLiteral(" yes "))) << line.toStdString();
}

TEST_F(Report, ADraftSaysSoOnEveryPageAndAFinishedReportNowhere) {
    ASSERT_TRUE(makeReportModel(state).missing.empty()) << makeReportModel(state).missing.front();
    writeReport(state, kHead, file("report.pdf"));
    EXPECT_THAT(pdfText(file("report.pdf")), Not(testing::ContainsRegex("[Dd]raft")));
    state.header.inspector.clear();
    writeReport(state, kHead, file("draft.pdf"));
    const std::string text = pdfText(file("draft.pdf"));
    EXPECT_THAT(text, HasSubstr("draft – not issued"));
    EXPECT_THAT(text, HasSubstr(makeReportModel(state).missing.front()));
    const std::string info = run(QStringLiteral("pdfinfo"), {QString::fromStdString(file("draft.pdf").string())});
    const QString pages =
        QString::fromStdString(info).section(QStringLiteral("Pages:"), 1).section('\n', 0, 0).trimmed();
    EXPECT_EQ(QString::fromStdString(text).count(QStringLiteral("draft – not issued")), pages.toInt());
    EXPECT_THAT(info, HasSubstr("A4"));
}

TEST_F(Report, NoFormEverClaimsThatNoFodIsThere) {
    for (const InspectionState& each : {state, tankInspection({.candidates = 0, .visited = false, .decided = false}),
                                        tankInspection({.visited = false, .decided = false})}) {
        writeReport(each, kHead, file("claim.pdf"));
        writeReport(each, kHead, file("claim.html"));
        for (const std::string& text : {pdfText(file("claim.pdf")), readTextFile(file("claim.html"))}) {
            EXPECT_FALSE(QString::fromStdString(text).contains(QStringLiteral("free of FOD"), Qt::CaseInsensitive));
        }
    }
}

TEST_F(Report, TheHtmlHoldsTheSameNumbersAndNeedsNoOtherFile) {
    writeReport(state, kHead, file("report.html"));
    const std::string html = readTextFile(file("report.html"));
    const ReportModel model = makeReportModel(state);
    EXPECT_THAT(html, HasSubstr(report::escaped(model.statement).toStdString()));
    EXPECT_THAT(html, HasSubstr(kHead));
    for (const ReportCandidate& candidate : allCandidates(model)) {
        EXPECT_THAT(html, HasSubstr(candidate.id));
        for (const ReportField& field : candidate.fields) {
            EXPECT_THAT(html, HasSubstr(report::escaped(field.value).toStdString()));
        }
    }
    EXPECT_THAT(html, Not(HasSubstr("http")));
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, HasSubstr("data:image/jpeg;base64,"));
}

TEST_F(Report, TheHtmlIsWellFormed) {
    state.header.title = "Tank <5> & \"pipes\"";
    writeReport(state, kHead, file("report.html"));
    QByteArray html = QByteArray::fromStdString(readTextFile(file("report.html")));
    // HTML leaves these open; an XML reader then checks that everything else nests.
    for (const char* tag : {"<meta", "<img"}) {
        for (int at = html.indexOf(tag); at >= 0; at = html.indexOf(tag, at + 1))
            html.insert(html.indexOf('>', at), '/');
    }
    html.replace("<br>", "<br/>");
    html.replace("<!DOCTYPE html>", "");
    QXmlStreamReader reader(html);
    while (!reader.atEnd())
        reader.readNext();
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line " << reader.lineNumber();
    EXPECT_FALSE(html.contains("Tank <5>"));
}

TEST_F(Report, CsvAndJsonAreTheModelsOwn) {
    writeReport(state, kHead, file("report.CSV"));
    writeReport(state, kHead, file("report.json"));
    EXPECT_EQ(readTextFile(file("report.CSV")), reportCsv(state));
    EXPECT_EQ(nlohmann::json::parse(readTextFile(file("report.json"))).at("schema"), "fodscope.session/1");
}

TEST_F(Report, AnotherExtensionIsAnErrorThatNamesTheForms) {
    for (const char* name : {"report.docx", "report", "report."}) {
        try {
            writeReport(state, kHead, file(name));
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(".pdf, .html, .csv or .json"));
        }
    }
}

TEST_F(Report, AFolderThatIsMissingIsAnError) {
    EXPECT_THROW(writeReport(state, kHead, file("nowhere/report.pdf")), Error);
    EXPECT_THROW(writeReport(state, kHead, file("nowhere/report.html")), Error);
}

TEST_F(Report, AnUnreadablePhotoIsSaidToBeUnreadable) {
    for (Photo& photo : state.photos)
        photo.bytes.resize(30);
    writeReport(state, "", file("report.pdf"));
    writeReport(state, "", file("report.html"));
    EXPECT_THAT(pdfText(file("report.pdf")), HasSubstr("not a readable picture"));
    EXPECT_THAT(pdfText(file("report.pdf")), HasSubstr("head hash not recorded"));
    EXPECT_THAT(readTextFile(file("report.html")), HasSubstr("not a readable picture"));
}

TEST_F(Report, AnEmptyInspectionIsADraftAndNoError) {
    writeReport({}, "", file("empty.pdf"));
    writeReport({}, "", file("empty.html"));
    EXPECT_THAT(pdfText(file("empty.pdf")), HasSubstr("draft – not issued"));
}

TEST_F(Report, PhotosAreScaledDownAndTheSessionsStayAsTheyAre) {
    QImage large(3200, 1800, QImage::Format_RGB32);
    large.fill(Qt::gray);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    large.save(&buffer, "PNG");
    Photo& photo = state.photos.front();
    photo.bytes.assign(reinterpret_cast<const std::byte*>(png.constData()),
                       reinterpret_cast<const std::byte*>(png.constData()) + png.size());
    photo.mediaType = "image/png";
    const auto evidence = report::evidenceOf(state, photo.candidateIds.front());
    const report::EncodedPhoto encoded = report::encodedEvidence(evidence);
    EXPECT_EQ(encoded.mediaType, "image/jpeg");
    EXPECT_EQ(QImage::fromData(encoded.bytes).size(), QSize(1600, 900));
    EXPECT_EQ(photo.bytes.size(), static_cast<std::size_t>(png.size()));
    const auto untouched = report::evidenceOf(state, state.photos.back().candidateIds.front());
    EXPECT_EQ(static_cast<std::size_t>(report::encodedEvidence(untouched).bytes.size()), untouched.photo->bytes.size());
}

TEST_F(Report, TheEvidenceIsThePhotoWhereFodWasNamed) {
    // A second photo of C-001 on which nobody named anything must not replace the one that was decided on.
    const auto decided = report::evidenceOf(state, "C-001");
    ASSERT_TRUE(decided.photo);
    const std::string id = decided.photo->id;
    Photo second = *decided.photo;
    second.id = "P-900";
    state.photos.insert(state.photos.begin(), second);
    EXPECT_EQ(report::evidenceOf(state, "C-001").photo->id, id);
    EXPECT_EQ(report::evidenceOf(state, "C-008").photo, nullptr);
}

}  // namespace
}  // namespace fodscope
