// SPDX-License-Identifier: MIT
#include "ui/panels/PanelParts.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace fodscope {

FieldList::FieldList(QWidget* parent) : QWidget(parent) {
    form_ = new QFormLayout(this);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setHorizontalSpacing(12);
    form_->setVerticalSpacing(4);
    form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    form_->setFormAlignment(Qt::AlignLeft | Qt::AlignTop);
    form_->setRowWrapPolicy(QFormLayout::DontWrapRows);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void FieldList::setFields(const std::vector<std::pair<QString, QString>>& fields) {
    while (rows_.size() > fields.size()) {
        form_->removeRow(static_cast<int>(rows_.size()) - 1);
        rows_.pop_back();
    }
    while (rows_.size() < fields.size()) {
        auto* name = new QLabel(this);
        setTextRole(name, TextRole::Muted);
        auto* value = makeText({}, TextRole::Body, this);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        form_->addRow(name, value);
        rows_.emplace_back(name, value);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        rows_[i].first->setText(fields[i].first);
        rows_[i].second->setText(fields[i].second);
    }
}

void FieldList::setFields(const std::vector<ReportField>& fields) {
    std::vector<std::pair<QString, QString>> rows;
    for (const ReportField& field : fields)
        rows.emplace_back(QString::fromStdString(field.name), QString::fromStdString(field.value));
    setFields(rows);
}

PanelColumn::PanelColumn(QWidget* parent, int leastWidth_px) : QScrollArea(parent), leastWidth_px_(leastWidth_px) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* content = new QWidget(this);
    setSurface(content, SurfaceRole::Surface1);
    setSurface(this, SurfaceRole::Surface1);
    column_ = new QVBoxLayout(content);
    column_->setContentsMargins(0, 0, 0, metrics::kPanelMargin_px);
    column_->setSpacing(0);
    content->installEventFilter(this);
    setWidget(content);
}

QSize PanelColumn::sizeHint() const {
    return {300, 400};
}

QSize PanelColumn::minimumSizeHint() const {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {std::max(leastWidth_px_, widget()->minimumSizeHint().width() + bar), 120};
}

bool PanelColumn::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) setMinimumWidth(minimumSizeHint().width());
    return QScrollArea::eventFilter(watched, event);
}

void PanelColumn::addBare(QWidget* widget) {
    auto* row = new QVBoxLayout;
    row->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px, 0);
    row->addWidget(widget);
    column_->addLayout(row);
}

QLabel* makeText(const QString& text, TextRole role, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    label->setMinimumWidth(60);
    setTextRole(label, role);
    return label;
}

}  // namespace fodscope
