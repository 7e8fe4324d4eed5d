// SPDX-License-Identifier: MIT
#include <QString>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <ostream>

#include "app/cli/commands/Commands.h"
#include "core/common/Hash.h"
#include "core/inspection/Inspection.h"
#include "storage/SessionFile.h"
#include "ui/report/ReportWriter.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string session;
    std::string issuedBy;
    std::string out;
};

/// Qt remarks on the desktop that is not there, which concerns nobody who issues a report from a command line.
void keepQtQuiet(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg) std::fprintf(stderr, "%s\n", message.toUtf8().constData());
}

void execute(const Options& options, Context& context) {
    qInstallMessageHandler(keepQtQuiet);
    const std::unique_ptr<SessionFile> session = SessionFile::open(options.session);
    context.progress.report("reading the session", 0.0);
    session->requireIntact();
    Inspection inspection(session->load(), *session);
    context.progress.report("writing the report", 0.0);
    // The head before this act: that the report was issued stands in the chain after what it reports.
    const std::string head = session->headHash();
    writeReport(inspection.state(), head, options.out);
    ReportRecord record;
    record.issued = UtcTime::now();
    record.issuedBy = options.issuedBy;
    record.fileName = std::filesystem::path(options.out).filename().string();
    record.sha256 = sha256OfFile(options.out);
    inspection.reportIssued(record);
    context.out << options.out << ": issued, head " << head << "\n";
}

}  // namespace

void addReportCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("report", "issue the report of a session");
    command->add_option("session", options->session, "session file")->required()->type_name("SESSION");
    command->add_option("--issued-by", options->issuedBy, "who issues it, for the record");
    command->add_option("--out", options->out, "the extension chooses the form")
        ->required()
        ->type_name("FILE.pdf|.html|.csv|.json");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
