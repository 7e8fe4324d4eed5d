// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core/labels/Decision.h"
#include "core/labels/LabelSet.h"
#include "ui/labelling/LabellingModel.h"

namespace fodscope {

/// Photo in the middle, label keys below it, thumbnails at the bottom. Shows one labeller's own decisions only.
///
/// A key emits decided(). The view goes on to the next undecided photo when setDecisions() brings that decision back,
/// that is when it is safe on the disk; decisionFailed() ends the wait with a message instead. A correction of an
/// earlier decision stays on its photo. When setDecisions() brings an undo, the view goes to its photo and says what
/// was taken back.
class LabellingView : public QWidget {
    Q_OBJECT

  public:
    explicit LabellingView(QWidget* parent = nullptr);
    ~LabellingView() override;

    void setLabelSet(const LabelSet& labelSet);
    /// Keeps the photo shown when it is still among them.
    void setPhotos(std::vector<LabelPhoto> photos);
    /// All decisions of the inspection, oldest first.
    void setDecisions(std::vector<Decision> decisions);
    /// Empty: the view asks for the name before the first decision.
    void setLabeller(const QString& name);
    /// Unknown ids are ignored.
    void setCurrent(const QString& photoId);
    /// Shows the first photo of a candidate; one selection everywhere.
    void setCandidate(const QString& candidateId);
    /// The decision could not be kept; the photo stays and the sentence is shown.
    void decisionFailed(const QString& message);

    QString currentPhoto() const;
    QString labeller() const;

  signals:
    void decided(const QString& photoId, const std::vector<fodscope::PhotoLabel>& labels, const QString& comment);
    void undoRequested();
    void photoSelected(const QString& photoId);
    void labellerNamed(const QString& name);

  public slots:
    void goToNextUndecided();
    void goToNext();
    void goToPrevious();
    void toggleOutline();
    void toggleContrast();
    void requestUndo();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void goTo(int index);
    bool mayDecide();
    void take(const Label& label, bool addAnother);
    void takeBox(const PixelBox& box);
    void takeName(const QString& name);
    bool takeBack();
    void finish();
    void apply(const DraftStep& step);
    void decide(const std::vector<PhotoLabel>& labels);
    void finishSaving(std::size_t decisionsBefore);
    void finishUndo(const TakenBack& undone);
    bool takeControlKey(int key);
    bool takeMoveKey(int key);
    bool takeCommandKey(int key);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fodscope

Q_DECLARE_METATYPE(std::vector<fodscope::PhotoLabel>)
