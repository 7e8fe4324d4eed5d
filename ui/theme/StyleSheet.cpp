// SPDX-License-Identifier: MIT
#include "ui/theme/StyleSheet.h"

#include <QFile>
#include <QPair>
#include <QVector>
#include <algorithm>

#include "ui/theme/Colours.h"

// Must be outside of every namespace; the style lives in a static library.
static void loadStyleResource() {
    Q_INIT_RESOURCE(style);
}

namespace fodscope {
namespace {

using Token = QPair<QString, QString>;

QVector<Token> tokensOf(const Theme& theme) {
    const auto entry = [](const char* name, const QColor& colour) {
        return Token(QLatin1Char('@') + QLatin1String(name), colour.name(QColor::HexRgb));
    };
    QVector<Token> tokens = {entry("surface0", theme.surface0),
                             entry("surface1", theme.surface1),
                             entry("surface2", theme.surface2),
                             entry("hover", theme.hover),
                             entry("line", theme.line),
                             entry("lineFaint", mixed(theme.surface1, theme.line, 0.5)),
                             entry("text", theme.text),
                             entry("textHover", mixed(theme.text, theme.accent, 0.35)),
                             entry("muted", theme.muted),
                             entry("disabled", theme.disabled),
                             entry("accent", theme.accent),
                             entry("accentHover", mixed(theme.accent, theme.text, 0.18)),
                             entry("accentPressed", mixed(theme.accent, theme.surface0, 0.18)),
                             entry("onAccent", theme.onAccent),
                             entry("finding", theme.finding),
                             entry("findingHover", mixed(theme.finding, theme.text, 0.15)),
                             entry("findingPressed", mixed(theme.finding, theme.surface0, 0.2)),
                             entry("onFinding", theme.onFinding),
                             entry("attention", theme.attention),
                             entry("clear", theme.clear),
                             entry("selection", theme.selection),
                             entry("scrollHandle", mixed(theme.line, theme.muted, 0.3)),
                             Token(QStringLiteral("@theme"),
                                   theme.kind == ThemeKind::Dark ? QStringLiteral("dark") : QStringLiteral("light"))};
    // Longer names first, so that @line does not eat the start of @lineFaint.
    std::sort(tokens.begin(), tokens.end(),
              [](const Token& a, const Token& b) { return a.first.size() > b.first.size(); });
    return tokens;
}

}  // namespace

QString styleSheetFor(const Theme& theme) {
    loadStyleResource();
    QFile file(QStringLiteral(":/fodscope/style/fodscope.qss"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString sheet = QString::fromUtf8(file.readAll());
    for (const Token& token : tokensOf(theme))
        sheet.replace(token.first, token.second);
    return sheet;
}

}  // namespace fodscope
