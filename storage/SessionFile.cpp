// SPDX-License-Identifier: MIT
#include "storage/SessionFile.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Version.h"
#include "storage/ActChain.h"
#include "storage/Payloads.h"
#include "storage/SessionDatabase.h"
#include "storage/SessionErrors.h"
#include "storage/SessionReader.h"
#include "storage/SessionVerifier.h"
#include "storage/SessionWriter.h"

namespace fodscope {
namespace {

constexpr std::size_t kLargestBlob = 1'000'000'000;

void checkSizes(const std::filesystem::path& file, const ActContent& content) {
    for (const Blob& blob : content.blobs) {
        if (blob.bytes.size() < kLargestBlob) continue;
        throw Error(file.string(), "a cloud or photo is larger than the session file can hold (1 GB)",
                    "use a coarser reference map");
    }
}

}  // namespace

struct SessionFile::Database {
    std::filesystem::path file;
    bool readOnly = false;
    std::unique_ptr<SQLite::Database> sqlite;
    std::int64_t lastSequence = 0;
    std::string headHash = firstPreviousHash();
    std::string inspector;
    StoredClouds storedClouds;

    /// @return the act that would come next
    Act nextAct(const ActContent& content) const {
        Act act;
        act.sequence = lastSequence + 1;
        act.kind = content.kind;
        act.payload = content.payload;
        act.author = !content.author.empty() ? content.author : !inspector.empty() ? inspector : "not recorded";
        act.timeUtc = toIso8601(UtcTime::now());
        act.softwareVersion = kVersion;
        act.previousHash = headHash;
        act.hash = hashOf(act);
        return act;
    }

    void remember(const Act& act) {
        lastSequence = act.sequence;
        headHash = act.hash;
        if (act.kind == act_kind::kHeader) {
            inspector = nlohmann::ordered_json::parse(act.payload).value("inspector", std::string());
        }
    }

    /// One transaction: the act is in the file with all that belongs to it, or nothing of it is.
    void record(const ActContent& content) {
        if (readOnly) throw Error(file.string(), "the session was opened for reading only", "open it for going on");
        checkSizes(file, content);
        const Act act = nextAct(content);
        try {
            SQLite::Transaction transaction(*sqlite, SQLite::TransactionBehavior::IMMEDIATE);
            writeAct(*sqlite, act, content);
            transaction.commit();
        } catch (const SQLite::Exception& exception) {
            throw sessionError(file, exception);
        }
        remember(act);
    }

    void readHead() {
        try {
            SQLite::Statement head(*sqlite, "SELECT sequence, hash FROM acts ORDER BY sequence DESC LIMIT 1");
            if (head.executeStep()) {
                lastSequence = head.getColumn(0).getInt64();
                headHash = head.getColumn(1).getString();
            }
            SQLite::Statement header(*sqlite,
                                     "SELECT payload FROM acts WHERE kind = 'header' ORDER BY sequence DESC LIMIT 1");
            if (header.executeStep()) {
                const std::string payload = header.getColumn(0).getString();
                inspector = nlohmann::ordered_json::parse(payload).value("inspector", std::string());
            }
        } catch (const SQLite::Exception& exception) {
            throw sessionError(file, exception);
        } catch (const nlohmann::json::exception& exception) {
            throw damagedSession(file, exception.what());
        }
    }
};

SessionFile::SessionFile(std::unique_ptr<Database> database) : database_(std::move(database)) {}

SessionFile::~SessionFile() = default;

std::unique_ptr<SessionFile> SessionFile::create(const std::filesystem::path& file, const InspectionHeader& header) {
    auto database = std::make_unique<Database>();
    database->file = file;
    const ActContent content = headerContent(header);
    const Act act = database->nextAct(content);
    database->sqlite = createSessionDatabase(file, [&](SQLite::Database& sqlite) { writeAct(sqlite, act, content); });
    database->remember(act);
    return std::unique_ptr<SessionFile>(new SessionFile(std::move(database)));
}

std::unique_ptr<SessionFile> SessionFile::open(const std::filesystem::path& file) {
    auto database = std::make_unique<Database>();
    database->file = file;
    database->sqlite = openSessionDatabase(file);
    database->readHead();
    return std::unique_ptr<SessionFile>(new SessionFile(std::move(database)));
}

std::unique_ptr<SessionFile> SessionFile::openForReading(const std::filesystem::path& file) {
    auto database = std::make_unique<Database>();
    database->file = file;
    database->readOnly = true;
    // Where the file may be written it is held as for going on, so that nobody changes it meanwhile.
    const bool writable = ::access(file.c_str(), W_OK) == 0 &&
                          ::access(file.parent_path().empty() ? "." : file.parent_path().c_str(), W_OK) == 0;
    database->sqlite = writable ? openSessionDatabase(file) : openSessionDatabaseForReading(file);
    database->readHead();
    return std::unique_ptr<SessionFile>(new SessionFile(std::move(database)));
}

InspectionState SessionFile::load() const {
    try {
        return readInspection(*database_->sqlite, database_->file);
    } catch (const SQLite::Exception& exception) {
        throw sessionError(database_->file, exception);
    }
}

const std::filesystem::path& SessionFile::path() const {
    return database_->file;
}

std::string SessionFile::headHash() const {
    return database_->headHash;
}

SessionVerification SessionFile::verify() const {
    try {
        return verifySession(*database_->sqlite);
    } catch (const SQLite::Exception& exception) {
        throw sessionError(database_->file, exception);
    }
}

void SessionFile::requireIntact() const {
    const SessionVerification verification = verify();
    if (verification.intact) return;
    throw Error(path().string(), "was altered after it was written (" + verification.problem + ")",
                "use a copy that `fodscope-cli verify` calls intact");
}

bool SessionFile::chainHolds(const std::string& hash) const {
    try {
        SQLite::Statement query(*database_->sqlite, "SELECT 1 FROM acts WHERE hash = ?");
        query.bind(1, hash);
        return query.executeStep();
    } catch (const SQLite::Exception& exception) {
        throw sessionError(database_->file, exception);
    }
}

void SessionFile::recordHeader(const InspectionHeader& header) {
    database_->record(headerContent(header));
}
void SessionFile::recordReference(const SourceFile& source, const ReferenceMap& reference) {
    database_->record(referenceContent(source, reference));
}
void SessionFile::recordMap(const SourceFile& source) {
    database_->record(mapContent(source));
}
void SessionFile::recordParameters(const Parameters& parameters) {
    database_->record(parametersContent(parameters));
}
void SessionFile::recordDetection(const DetectionRecord& detection, int highestCandidateNumber) {
    StoredClouds stored = database_->storedClouds;
    database_->record(detectionContent(detection, highestCandidateNumber, stored));
    database_->storedClouds = std::move(stored);
}
void SessionFile::recordPlan(const OccupancyGrid& grid_map, const VisitPlan& plan, const std::vector<Visit>& visits) {
    database_->record(planContent(grid_map, plan, visits));
}
void SessionFile::recordRoute(const InspectionRoute& route, const std::vector<Visit>& visits) {
    database_->record(routeContent(route, visits));
}
void SessionFile::recordVisit(const Visit& visit) {
    database_->record(visitContent(visit));
}
void SessionFile::recordPhoto(const Photo& photo) {
    database_->record(photoContent(photo));
}
void SessionFile::recordLabelSet(const LabelSet& labelSet) {
    database_->record(labelSetContent(labelSet));
}
void SessionFile::recordDecision(const Decision& decision) {
    database_->record(decisionContent(decision));
}
void SessionFile::recordReport(const ReportRecord& report) {
    database_->record(reportContent(report));
}

}  // namespace fodscope
