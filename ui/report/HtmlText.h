// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/inspection/ReportModel.h"

namespace fodscope::report {

/// Text as it may stand in an element or an attribute.
QString escaped(const std::string& text);
QString escaped(const QString& text);

/// The style of the report: light, readable, and made for A4 when printed.
QString htmlStyle();

QString htmlHeading(int level, const QString& text);
QString htmlParagraph(const std::string& text, const QString& cssClass = {});
QString htmlList(const std::vector<std::string>& sentences);
QString htmlFields(const std::vector<ReportField>& fields);
/// @param src a data URI
QString htmlImage(const QString& src, const QString& description, const QString& cssClass = {});
QString dataUri(const QByteArray& bytes, const QString& mediaType);

}  // namespace fodscope::report
