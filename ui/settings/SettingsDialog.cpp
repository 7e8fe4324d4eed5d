// SPDX-License-Identifier: MIT
#include "ui/settings/SettingsDialog.h"

#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "core/common/Files.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/settings/ParameterEditor.h"
#include "ui/settings/ParameterWords.h"
#include "ui/settings/SettingsRow.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/Card.h"

namespace fodscope {
namespace {

constexpr int kIndexWidth_px = 172;
constexpr int kNameWidth_px = 168;

QString fileFilter() {
    return QObject::tr("Parameter files (*.yaml *.yml);;All files (*)");
}

QWidget* hairline(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setFrameShape(QFrame::HLine);
    return line;
}

}  // namespace

SettingsDialog::SettingsDialog(InspectionController& controller, FileDialogs& files, QWidget* parent)
    : QDialog(parent),
      controller_(controller),
      files_(files),
      draft_(controller.state().parameters, presetParameters(nearestPreset(controller.state().parameters))) {
    setObjectName(QStringLiteral("settings"));
    setWindowTitle(tr("All settings"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeTop());
    column->addWidget(hairline(this));
    column->addWidget(makeSections(), 1);
    column->addWidget(hairline(this));
    column->addWidget(makeBottom());
    resize(940, 640);
    connect(&controller, &InspectionController::sessionChanged, this, [this] { draft_.discard(); });
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::parametersChanged,
                              &InspectionController::visitsChanged})
        connect(&controller, signal, this, &SettingsDialog::takeInspection);
    takeInspection();
    filter();
    search_->setFocus();
}

SettingsDialog::~SettingsDialog() = default;

QWidget* SettingsDialog::makeTop() {
    auto* top = new QWidget(this);
    auto* row = new QHBoxLayout(top);
    row->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                            metrics::kPanelMargin_px);
    row->setSpacing(2 * metrics::kStep_px);
    search_ = new QLineEdit(top);
    search_->setObjectName(QStringLiteral("settings.search"));
    search_->setPlaceholderText(tr("Search by name or meaning"));
    search_->setClearButtonEnabled(true);
    auto* presetLabel = new QLabel(tr("Compared with preset"), top);
    setTextRole(presetLabel, TextRole::Muted);
    preset_ = new QComboBox(top);
    preset_->setObjectName(QStringLiteral("settings.preset"));
    for (const std::string& name : presetNames())
        preset_->addItem(QString::fromStdString(name));
    preset_->setCurrentText(QString::fromStdString(nearestPreset(controller_.state().parameters)));
    preset_->setToolTip(tr("Where a value differs from this preset, the preset's value is shown beside it"));
    presetLabel->setBuddy(preset_);
    usePreset_ = new QPushButton(tr("Use all its values"), top);
    usePreset_->setObjectName(QStringLiteral("settings.usePreset"));
    row->addWidget(search_, 1);
    row->addSpacing(metrics::kPanelMargin_px);
    row->addWidget(presetLabel);
    row->addWidget(preset_);
    row->addWidget(usePreset_);
    connect(search_, &QLineEdit::textChanged, this, &SettingsDialog::filter);
    connect(preset_, QOverload<int>::of(&QComboBox::activated), this, &SettingsDialog::choosePreset);
    connect(usePreset_, &QPushButton::clicked, this, [this] {
        draft_.usePreset();
        refresh();
    });
    return top;
}

QWidget* SettingsDialog::makeSections() {
    auto* middle = new QWidget(this);
    auto* row = new QHBoxLayout(middle);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    index_ = new QListWidget(middle);
    index_->setObjectName(QStringLiteral("settings.sections"));
    index_->setFixedWidth(kIndexWidth_px);
    index_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* edge = new QFrame(middle);
    edge->setFrameShape(QFrame::VLine);
    scroll_ = new QScrollArea(middle);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget(scroll_);
    setSurface(page, SurfaceRole::Surface1);
    auto* cards = new QVBoxLayout(page);
    cards->setContentsMargins(0, 0, 0, 0);
    cards->setSpacing(0);
    nothingFound_ = new QLabel(tr("No setting has these words in its name or meaning."), page);
    nothingFound_->setContentsMargins(12, 16, 12, 16);
    setTextRole(nothingFound_, TextRole::Muted);
    cards->addWidget(nothingFound_);
    for (const ParameterField& field : parameterTable())
        if (cards_.empty() || cards_.back().first != field.section) cards->addWidget(makeCard(field.section, page));
    cards->addStretch();
    scroll_->setWidget(page);
    row->addWidget(index_);
    row->addWidget(edge);
    row->addWidget(scroll_, 1);
    connect(index_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { showSection(item->data(Qt::UserRole).toString().toStdString()); });
    return middle;
}

Card* SettingsDialog::makeCard(const std::string& section, QWidget* parent) {
    auto* card = new Card(sectionTitle(section), parent);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(metrics::kPanelMargin_px);
    grid->setVerticalSpacing(metrics::kStep_px);
    grid->setColumnMinimumWidth(0, kNameWidth_px);
    grid->setColumnMinimumWidth(2, 32);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(4, 2);
    for (const ParameterField& field : parameterTable()) {
        if (field.section != section) continue;
        auto* row = new SettingsRow(field, *grid, grid->rowCount(), card);
        connect(row, &SettingsRow::edited, this, [this, &field](const QString& text) {
            draft_.setText(field, text);
            refresh();
        });
        connect(row, &SettingsRow::resetAsked, this, [this, &field] {
            draft_.reset(field);
            refresh();
        });
        rows_.push_back(row);
    }
    card->body()->addLayout(grid);
    cards_.emplace_back(section, card);
    auto* item = new QListWidgetItem(index_);
    item->setData(Qt::UserRole, QString::fromStdString(section));
    return card;
}

QWidget* SettingsDialog::makeBottom() {
    auto* bottom = new QWidget(this);
    auto* column = new QVBoxLayout(bottom);
    column->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                               metrics::kPanelMargin_px);
    column->setSpacing(2 * metrics::kStep_px);
    frozen_ = new QLabel(tr("Frozen: the visits have begun, so candidates keep their ids. What steers the visits can "
                            "still be changed."),
                         bottom);
    frozen_->setObjectName(QStringLiteral("settings.frozen"));
    frozen_->setWordWrap(true);
    setTextRole(frozen_, TextRole::Muted);
    problems_ = new QLabel(bottom);
    problems_->setObjectName(QStringLiteral("settings.problems"));
    problems_->setWordWrap(true);
    problems_->setTextFormat(Qt::PlainText);
    problems_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2 * metrics::kStep_px);
    const auto button = [&](const QString& text, const char* name) {
        auto* made = new QPushButton(text, bottom);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        buttons->addWidget(made);
        return made;
    };
    auto* load = button(tr("Load parameter file…"), "settings.load");
    load->setToolTip(tr("Reads a YAML file over the values of the chosen preset"));
    save_ = button(tr("Save parameter file…"), "settings.save");
    buttons->addStretch();
    auto* close = button(tr("Close"), "settings.close");
    close->setToolTip(tr("Esc. What was not applied is given up"));
    discard_ = button(tr("Discard changes"), "settings.discard");
    apply_ = button(tr("Apply"), "settings.apply");
    apply_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Return")));
    setButtonRole(apply_, ButtonRole::Primary);
    column->addWidget(frozen_);
    column->addWidget(problems_);
    column->addLayout(buttons);
    connect(load, &QPushButton::clicked, this, &SettingsDialog::load);
    connect(save_, &QPushButton::clicked, this, &SettingsDialog::save);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(discard_, &QPushButton::clicked, this, [this] {
        draft_.discard();
        refresh();
    });
    connect(apply_, &QPushButton::clicked, this, &SettingsDialog::apply);
    return bottom;
}

void SettingsDialog::takeInspection() {
    const Parameters& now = controller_.state().parameters;
    // What somebody typed here outlives a change that came from elsewhere, as long as it can still be applied.
    if (now != draft_.inEffect()) draft_ = ParameterDraft(now, presetParameters(preset_->currentText().toStdString()));
    draft_.setFrozen(controller_.candidatesAreFrozen());
    if (!controller_.isOpen()) hide();
    refresh();
}

void SettingsDialog::refresh() {
    for (SettingsRow* row : rows_)
        row->show(draft_);
    for (int i = 0; i < index_->count(); ++i) {
        QListWidgetItem* item = index_->item(i);
        const std::string section = item->data(Qt::UserRole).toString().toStdString();
        const auto changed = std::ranges::count_if(parameterTable(), [&](const ParameterField& field) {
            return field.section == section && draft_.differsFromPreset(field);
        });
        const QString title = sectionTitle(section);
        item->setText(changed == 0 ? title : tr("%1  ·  %2 changed").arg(title).arg(changed));
    }
    frozen_->setVisible(controller_.candidatesAreFrozen());
    QStringList problems = draft_.problems();
    if (!told_.isEmpty()) problems.prepend(told_);
    told_.clear();
    problems_->setText(problems.join(QLatin1Char('\n')));
    problems_->setVisible(!problems.isEmpty());
    problems_->setProperty("problem", !draft_.problems().isEmpty());
    problems_->style()->unpolish(problems_);
    problems_->style()->polish(problems_);
    const QString obstacle = draft_.obstacle();
    apply_->setEnabled(obstacle.isEmpty());
    apply_->setToolTip(obstacle.isEmpty() ? tr("Keeps the values and detects again (Ctrl+Return)")
                                          : tr("Cannot be applied: %1").arg(obstacle));
    discard_->setEnabled(draft_.hasChanges());
    discard_->setToolTip(draft_.hasChanges() ? tr("Back to the values in effect") : tr("Nothing was changed"));
    save_->setEnabled(draft_.problems().isEmpty());
    save_->setToolTip(save_->isEnabled() ? tr("Writes all values as commented YAML, also for fodscope-cli --params")
                                         : tr("Cannot be saved: %1").arg(obstacle));
    const bool differs = std::ranges::any_of(
        parameterTable(), [this](const ParameterField& field) { return draft_.differsFromPreset(field); });
    usePreset_->setEnabled(differs);
    usePreset_->setToolTip(differs ? tr("Every value becomes that of the preset; Apply makes it take effect")
                                   : tr("All values are those of the preset"));
}

void SettingsDialog::filter() {
    const QString search = search_->text();
    bool any = false;
    for (SettingsRow* row : rows_)
        row->setVisible(matchesSearch(row->field(), search));
    for (int i = 0; i < index_->count(); ++i) {
        const auto& [section, card] = cards_[static_cast<std::size_t>(i)];
        const bool found = std::ranges::any_of(parameterTable(), [&](const ParameterField& field) {
            return field.section == section && matchesSearch(field, search);
        });
        card->setVisible(found);
        index_->item(i)->setHidden(!found);
        any = any || found;
    }
    nothingFound_->setVisible(!any);
    refresh();
}

void SettingsDialog::showSection(const std::string& section) {
    for (const auto& [name, card] : cards_) {
        if (name != section) continue;
        scroll_->ensureWidgetVisible(scroll_->widget(), 0, 0);
        scroll_->verticalScrollBar()->setValue(card->y());
    }
}

void SettingsDialog::choosePreset() {
    draft_.setPreset(presetParameters(preset_->currentText().toStdString()));
    refresh();
}

void SettingsDialog::load() {
    const QString file = files_.openFile(this, tr("Parameter file"), fileFilter());
    if (file.isEmpty()) return;
    try {
        draft_.setEdited(readParameters(file.toStdString(), presetParameters(preset_->currentText().toStdString())));
    } catch (const std::exception& error) {
        told_ = sentenceOf(error);
    }
    refresh();
}

void SettingsDialog::save() {
    const QString file =
        files_.saveFile(this, tr("Save the parameters"), QStringLiteral("parameters.yaml"), fileFilter());
    if (file.isEmpty()) return;
    try {
        writeFile(file.toStdString(), std::string_view(parametersYaml(draft_.edited())));
        told_ = tr("Saved as %1.").arg(QFileInfo(file).fileName());
    } catch (const std::exception& error) {
        told_ = sentenceOf(error);
    }
    refresh();
}

void SettingsDialog::apply() {
    controller_.applyParameters(draft_.edited());
}

}  // namespace fodscope
