// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/widgets/Card.h"
#include "ui/widgets/EmptyState.h"
#include "ui/widgets/KeyCap.h"
#include "ui/widgets/NumberReadout.h"
#include "ui/widgets/StatusChip.h"
#include "ui/widgets/TaskBar.h"
#include "ui/widgets/Toast.h"

namespace fodscope {
namespace {

TEST(EmptyState, OffersTheButtonThatGetsWhatIsMissing) {
    EmptyState state(QStringLiteral("The map is not loaded yet."), QStringLiteral("Open a map"));
    QSignalSpy activated(&state, &EmptyState::activated);
    QTest::mouseClick(state.findChild<QPushButton*>(), Qt::LeftButton);
    EXPECT_EQ(activated.count(), 1);
    state.showLoading(QStringLiteral("Reading the map"), 0.4);
    EXPECT_TRUE(state.findChild<QPushButton*>()->isHidden());
}

TEST(Card, FoldsItsBody) {
    Card card(QStringLiteral("Clustering"));
    auto* content = new QLabel(QStringLiteral("body"));
    card.body()->addWidget(content);
    card.setCollapsible(true);
    card.show();
    QSignalSpy changed(&card, &Card::collapsedChanged);
    card.findChild<QToolButton*>()->click();
    EXPECT_TRUE(card.isCollapsed());
    EXPECT_FALSE(content->isVisible());
    EXPECT_EQ(changed.count(), 1);
    card.setCollapsible(false);
    EXPECT_TRUE(content->isVisible()) << "what cannot be folded is open";
}

TEST(KeyCap, IsALargeTargetThatSaysItsKey) {
    KeyCap cap(QStringLiteral("1"), QStringLiteral("bolt or nut"));
    EXPECT_GE(cap.sizeHint().height(), metrics::kKeyHeight_px);
    EXPECT_TRUE(cap.accessibleName().contains(QStringLiteral("key 1")));
    QSignalSpy clicked(&cap, &KeyCap::clicked);
    QTest::mouseClick(&cap, Qt::LeftButton);
    EXPECT_EQ(clicked.count(), 1);
    EXPECT_TRUE(cap.isChecked());
}

TEST(NumberReadout, NotKnownIsNotZero) {
    NumberReadout readout(QStringLiteral("candidates"));
    EXPECT_FALSE(readout.number().contains(QLatin1Char('0')));
    readout.setNumber(QStringLiteral("12"));
    EXPECT_EQ(readout.number(), QStringLiteral("12"));
    readout.setUnknown();
    EXPECT_EQ(readout.number(), QString(QChar(0x2013)));
}

TEST(StatusChip, EachStateHasItsOwnShape) {
    const Theme theme = makeTheme(ThemeKind::Dark);
    std::vector<QImage> pictures;
    for (const StatusKind kind : {StatusKind::ToDo, StatusKind::Running, StatusKind::Attention, StatusKind::Clear,
                                  StatusKind::Finding, StatusKind::NotObserved}) {
        // Only the alpha: the shapes differ even for who sees no colours.
        QImage picture(24, 24, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintStatusShape(painter, QRectF(0, 0, 24, 24), kind, theme);
        painter.end();
        pictures.push_back(picture.convertToFormat(QImage::Format_Alpha8));
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
    }
}

TEST(TaskBar, ShowsWhileSomethingRunsAndCancelsOnce) {
    TaskBar bar;
    EXPECT_FALSE(bar.isRunning());
    bar.setTask(QStringLiteral("smoothing"), 0.5);
    EXPECT_TRUE(bar.isRunning());
    EXPECT_FALSE(bar.isHidden());
    EXPECT_TRUE(bar.findChild<QLabel*>()->text().contains(QStringLiteral("50")));
    QSignalSpy cancel(&bar, &TaskBar::cancelRequested);
    auto* button = bar.findChild<QToolButton*>();
    button->click();
    button->click();
    EXPECT_EQ(cancel.count(), 1);
    bar.setTask(QStringLiteral("smoothing"), 0.6);
    EXPECT_TRUE(bar.findChild<QLabel*>()->text().contains(QStringLiteral("cancelling")));
    bar.finish();
    EXPECT_TRUE(bar.isHidden());
    EXPECT_TRUE(button->isEnabled());
}

TEST(TaskBar, DurationsAreRough) {
    EXPECT_EQ(roughDuration(0.2), QStringLiteral("1 s"));
    EXPECT_EQ(roughDuration(42.0), QStringLiteral("42 s"));
    EXPECT_EQ(roughDuration(83.0), QStringLiteral("1 min 20 s"));
    EXPECT_EQ(roughDuration(3000.0), QStringLiteral("50 min"));
}

TEST(Toast, ErrorsStayAndOthersLeave) {
    QWidget window;
    window.resize(800, 600);
    window.show();
    Toast toast(&window);
    toast.setDuration(1);
    toast.showMessage(StatusKind::Neutral, QStringLiteral("Set aside C-004"), QStringLiteral("Undo"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return toast.isHidden(); }, 5000));
    toast.showMessage(StatusKind::Finding, QStringLiteral("The robot does not answer"));
    QCoreApplication::processEvents();
    EXPECT_FALSE(toast.isHidden());
    EXPECT_TRUE(window.rect().contains(toast.geometry()));
}

TEST(Toast, OffersItsAction) {
    QWidget window;
    window.resize(800, 600);
    window.show();
    Toast toast(&window);
    toast.showMessage(StatusKind::Neutral, QStringLiteral("Set aside C-004"), QStringLiteral("Undo"));
    QSignalSpy action(&toast, &Toast::actionTriggered);
    toast.findChild<QPushButton*>()->click();
    EXPECT_EQ(action.count(), 1);
    EXPECT_TRUE(toast.isHidden());
}

}  // namespace
}  // namespace fodscope
