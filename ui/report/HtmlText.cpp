// SPDX-License-Identifier: MIT
#include "ui/report/HtmlText.h"

#include "ui/report/ReportStyle.h"

namespace fodscope::report {

QString escaped(const QString& text) {
    return text.toHtmlEscaped();
}

QString escaped(const std::string& text) {
    return escaped(QString::fromStdString(text));
}

QString htmlStyle() {
    const Theme& theme = colours();
    return QStringLiteral(R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 32px 24px 64px; max-width: 1040px; background: #ffffff; color: %1;
  font: 15px/1.5 "DejaVu Sans", "Noto Sans", "Segoe UI", system-ui, sans-serif; font-variant-numeric: tabular-nums; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 16px; }
h2 { font-size: 20px; margin: 40px 0 12px; padding-bottom: 6px; border-bottom: 1px solid %3; }
h3 { font-size: 17px; margin: 0 0 10px; }
.muted, dt, figcaption, th { color: %2; }
.statement { background: %4; border-left: 4px solid %1; padding: 14px 18px; font-size: 16px; }
.draft { border: 2px solid %5; border-radius: 6px; padding: 12px 18px; margin: 20px 0; }
.draft strong { color: %5; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(360px, 1fr)); gap: 8px 40px; }
dl { display: grid; grid-template-columns: minmax(140px, 40%) 1fr; margin: 8px 0; }
dt, dd { margin: 0; padding: 5px 0; border-bottom: 1px solid %3; overflow-wrap: anywhere; font-size: 14px; }
dt { padding-right: 16px; }
figure { margin: 0; }
figure svg, figure img { display: block; width: 100%; height: auto; border: 1px solid %3; }
figcaption { font-size: 13px; margin-top: 6px; }
.finding { margin: 0 0 36px; break-inside: avoid; }
.finding h3::before { content: "\25C6"; color: %5; margin-right: 10px; }
.pictures { display: grid; grid-template-columns: 2fr 1fr; gap: 16px; align-items: start; margin-bottom: 12px; }
.nophoto { border: 1px dashed %2; padding: 48px 24px; text-align: center; color: %2; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13px; }
th, td { text-align: left; vertical-align: top; padding: 6px 12px 6px 6px; border-bottom: 1px solid %3; }
th { background: %4; font-weight: normal; }
.mono { font-family: "DejaVu Sans Mono", ui-monospace, monospace; font-size: 12px; overflow-wrap: anywhere; }
footer { margin-top: 48px; padding-top: 12px; border-top: 1px solid %3; font-size: 13px; color: %2; }
@page { size: A4; margin: 18mm 16mm; }
@media (max-width: 700px) { .pictures { grid-template-columns: 1fr; } }
@media print { body { padding: 0; max-width: none; font-size: 9.5pt; } h2 { break-after: avoid; }
  dt, dd, table { font-size: 8.5pt; } .pictures { grid-template-columns: 2fr 1fr; } tr { break-inside: avoid; } }
)")
        .arg(theme.text.name(), theme.muted.name(), theme.line.name(), theme.surface2.name(), theme.finding.name());
}

QString htmlHeading(int level, const QString& text) {
    return QStringLiteral("<h%1>%2</h%1>\n").arg(QString::number(level), escaped(text));
}

QString htmlParagraph(const std::string& text, const QString& cssClass) {
    const QString attribute = cssClass.isEmpty() ? QString() : QStringLiteral(" class=\"%1\"").arg(cssClass);
    return QStringLiteral("<p%1>%2</p>\n").arg(attribute, escaped(text));
}

QString htmlList(const std::vector<std::string>& sentences) {
    QString html = QStringLiteral("<ul>\n");
    for (const std::string& sentence : sentences)
        html += QStringLiteral("<li>%1</li>\n").arg(escaped(sentence));
    return html + QStringLiteral("</ul>\n");
}

QString htmlFields(const std::vector<ReportField>& fields) {
    if (fields.empty()) return {};
    QString html = QStringLiteral("<dl>\n");
    for (const ReportField& field : fields) {
        html += QStringLiteral("<dt>%1</dt><dd>%2</dd>\n").arg(escaped(field.name), escaped(field.value));
    }
    return html + QStringLiteral("</dl>\n");
}

QString htmlImage(const QString& src, const QString& description, const QString& cssClass) {
    const QString attribute = cssClass.isEmpty() ? QString() : QStringLiteral(" class=\"%1\"").arg(cssClass);
    return QStringLiteral("<img%1 src=\"%2\" alt=\"%3\">\n").arg(attribute, src, escaped(description));
}

QString dataUri(const QByteArray& bytes, const QString& mediaType) {
    return QStringLiteral("data:%1;base64,%2").arg(mediaType, QString::fromLatin1(bytes.toBase64()));
}

}  // namespace fodscope::report
