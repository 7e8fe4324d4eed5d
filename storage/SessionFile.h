// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/inspection/Journal.h"

namespace fodscope {

/// What verify() found.
struct SessionVerification {
    bool intact = false;
    std::size_t acts = 0;
    std::string headHash;
    /// The first thing that was altered, in words; empty when intact.
    std::string problem;
};

/// The session file: one SQLite database per inspection (WAL, synchronous FULL, one transaction an act). Acts are
/// appended, never changed, each with who, when and the hash of the one before. Used from one thread.
class SessionFile : public Journal {
  public:
    /// Makes a new file.
    /// @throws Error when it exists or cannot be made
    static std::unique_ptr<SessionFile> create(const std::filesystem::path& file, const InspectionHeader& header);

    /// Opens a file for going on.
    /// @throws Error when it is missing, no session, damaged, of a newer version, or may not be written
    static std::unique_ptr<SessionFile> open(const std::filesystem::path& file);

    /// Opens a file for reading alone, even where it may not be written; recording throws.
    /// @throws Error as open() but for the last
    static std::unique_ptr<SessionFile> openForReading(const std::filesystem::path& file);

    ~SessionFile() override;

    /// Reads the whole inspection back.
    InspectionState load() const;
    const std::filesystem::path& path() const;
    std::string headHash() const;

    /// Walks the chain of acts and the fingerprints of photos and clouds.
    SessionVerification verify() const;
    /// @throws Error naming the first thing that was altered
    void requireIntact() const;
    /// @return whether that hash is in the chain
    bool chainHolds(const std::string& hash) const;

    void recordHeader(const InspectionHeader& header) override;
    void recordReference(const SourceFile& source, const ReferenceMap& reference) override;
    void recordMap(const SourceFile& source) override;
    void recordParameters(const Parameters& parameters) override;
    void recordDetection(const DetectionRecord& detection, int highestCandidateNumber) override;
    void recordPlan(const OccupancyGrid& grid_map, const VisitPlan& plan, const std::vector<Visit>& visits) override;
    void recordRoute(const InspectionRoute& route, const std::vector<Visit>& visits) override;
    void recordVisit(const Visit& visit) override;
    void recordPhoto(const Photo& photo) override;
    void recordLabelSet(const LabelSet& labelSet) override;
    void recordDecision(const Decision& decision) override;
    void recordReport(const ReportRecord& report) override;

  private:
    struct Database;
    explicit SessionFile(std::unique_ptr<Database> database);
    std::unique_ptr<Database> database_;
};

}  // namespace fodscope
