// SPDX-License-Identifier: MIT
// Photos, decisions and reports of the inspection controller.
#include <QSettings>
#include <algorithm>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/common/Hash.h"
#include "ui/report/ReportWriter.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

const Photo* InspectionController::findPhoto(const QString& photoId) const {
    return fodscope::findPhoto(state(), photoId.toStdString());
}

void InspectionController::setLabeller(const QString& name) {
    if (name == labeller_) return;
    labeller_ = name;
    QSettings().setValue("labelling/labeller", name);
    emit labellerChanged();
    emit historyChanged();
}

void InspectionController::loadLabelSet(const QString& yamlFile) {
    if (!inspection_) return;
    if (attempt([&] { inspection_->setLabelSet(readLabelSet(yamlFile.toStdString())); })) emit labelSetChanged();
}

bool InspectionController::decide(const QString& photoId, const std::vector<PhotoLabel>& labels,
                                  const QString& comment) {
    if (!inspection_) return false;
    const std::string photo = photoId.toStdString();
    const std::string labeller = labeller_.toStdString();
    const std::string remark = comment.toStdString();
    if (!attempt([&] { recordDecision(photo, labeller, labels, remark); })) return false;
    history_.add({tr("decision on %1").arg(photoId), [this, labeller] { takeBackDecision(labeller); },
                  [this, photo, labeller, labels, remark] { recordDecision(photo, labeller, labels, remark); }});
    emit historyChanged();
    return true;
}

void InspectionController::recordDecision(const std::string& photoId, const std::string& labeller,
                                          const std::vector<PhotoLabel>& labels, const std::string& comment) {
    inspection_->decide(photoId, labeller, labels, comment, UtcTime::now());
    refreshVerdicts();
    emit decisionsChanged();
    emit stepsChanged();
}

void InspectionController::takeBackDecision(const std::string& labeller) {
    const auto photo = inspection_->undoDecision(labeller, UtcTime::now());
    if (!photo) return;
    refreshVerdicts();
    emit decisionsChanged();
    emit stepsChanged();
    selectPhoto(QString::fromStdString(*photo));
}

bool InspectionController::hasDecisionOf(const std::string& labeller) const {
    return std::ranges::any_of(state().photos, [&](const Photo& photo) {
        return lastDecision(state().decisions, photo.id, labeller) != nullptr;
    });
}

void InspectionController::selectPhoto(const QString& photoId) {
    if (photoId == selectedPhoto_) return;
    selectedPhoto_ = photoId;
    emit photoSelectionChanged(photoId);
    const Photo* photo = findPhoto(photoId);
    if (photo != nullptr && !photo->candidateIds.empty())
        selectCandidate(QString::fromStdString(photo->candidateIds.front()));
}

void InspectionController::issueReport(const QString& folder) {
    if (!inspection_) return;
    runFor(Step::Report, tr("writing the report"),
           [this, folder, snapshot = state(), head = headHash().toStdString(),
            by = labeller_.toStdString()](Progress& progress) -> TaskRunner::Adopt {
               const std::filesystem::path target = folder.toStdString();
               makeFolder(target);
               const std::array<const char*, 4> names = {"report.pdf", "report.html", "report.csv", "report.json"};
               for (std::size_t i = 0; i < names.size(); ++i) {
                   progress.report(names[i], static_cast<double>(i) / static_cast<double>(names.size()));
                   writeReport(snapshot, head, target / names[i]);
               }
               ReportRecord record;
               record.issued = UtcTime::now();
               record.issuedBy = snapshot.header.inspector.empty() ? by : snapshot.header.inspector;
               record.fileName = names.front();
               record.sha256 = sha256OfFile(target / names.front());
               return [this, folder, record] {
                   inspection_->reportIssued(record);
                   emit reportIssued(folder);
                   emit stepsChanged();
               };
           });
}

}  // namespace fodscope
