// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>

#include "ui/theme/Theme.h"

int main(int argumentCount, char** arguments) {
    const QTemporaryDir home;
    qputenv("HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toUtf8());
    fodscope::prepareApplication();
    QApplication application(argumentCount, arguments);
    fodscope::applyTheme(application, fodscope::ThemeKind::Dark);
    testing::InitGoogleTest(&argumentCount, arguments);
    return RUN_ALL_TESTS();
}
