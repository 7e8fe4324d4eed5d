// SPDX-License-Identifier: MIT
#include "storage/SessionReader.h"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/common/Error.h"
#include "storage/CloudBlobs.h"
#include "storage/PayloadReading.h"
#include "storage/Payloads.h"
#include "storage/SessionErrors.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::byte> readBlob(SQLite::Database& database, const std::string& sha256) {
    SQLite::Statement query(database, "SELECT bytes FROM blobs WHERE sha256 = ?");
    query.bind(1, sha256);
    if (!query.executeStep()) throw std::invalid_argument("the blob " + sha256 + " is missing");
    const SQLite::Column column = query.getColumn(0);
    const auto* first = static_cast<const std::byte*>(column.getBlob());
    return first == nullptr ? std::vector<std::byte>() : std::vector<std::byte>(first, first + column.getBytes());
}

/// Reads blobs, each field only once: while tuning, many detections rest on the same one.
class BlobSource {
  public:
    BlobSource(SQLite::Database& database, std::string subject) : database_(database), subject_(std::move(subject)) {}

    const std::string& subject() const { return subject_; }

    std::vector<std::byte> bytes(const Json& name) const {
        return readBlob(database_, name.at("sha256").get<std::string>());
    }

    std::shared_ptr<const DiscrepancyField> field(const Json& name) {
        auto& field = fields_[name.at("sha256").get<std::string>()];
        if (!field) field = std::make_shared<const DiscrepancyField>(decodeField(bytes(name), subject_));
        return field;
    }

  private:
    SQLite::Database& database_;
    std::string subject_;
    std::map<std::string, std::shared_ptr<const DiscrepancyField>> fields_;
};

void attachVoxels(CandidateSet& set, const Json& json, std::size_t fieldSize, const BlobSource& blobs) {
    auto lists = decodeVoxels(blobs.bytes(json.at("voxels")), blobs.subject());
    if (lists.size() != set.candidates.size()) throw std::invalid_argument("the candidates' voxels do not fit");
    set.candidateOfVoxel.assign(fieldSize, -1);
    for (std::size_t i = 0; i < lists.size(); ++i) {
        for (const std::uint32_t voxel : lists[i]) {
            if (voxel >= fieldSize) throw std::invalid_argument("a candidate has a voxel outside the field");
            set.candidateOfVoxel[voxel] = static_cast<std::int32_t>(i);
        }
        set.candidates[i].voxels = std::move(lists[i]);
    }
}

DetectionRecord detectionFrom(const Json& payload, BlobSource& blobs) {
    DetectionRecord record;
    record.parameters =
        parseParameters(payload.at("parameters_yaml").get<std::string>(), blobs.subject(), Parameters());
    record.registration = registrationFrom(payload.at("registration"));
    record.floorHeight_m = numberFrom(payload.at("floor_height_m"));
    if (!payload.at("field").is_null()) record.field = blobs.field(payload.at("field"));
    const Json& candidates = payload.at("candidates");
    if (!candidates.is_null()) {
        CandidateSet set = candidateSetFrom(candidates);
        attachVoxels(set, candidates, record.field ? record.field->size() : 0, blobs);
        record.candidates = std::make_shared<const CandidateSet>(std::move(set));
    }
    const Json& coverage = payload.at("coverage");
    if (!coverage.is_null()) {
        Coverage read;
        read.observedShare = numberFrom(coverage.at("observed_share"));
        read.leftOut = coverage.at("left_out").get<std::size_t>();
        read.observed = decodeCoverage(blobs.bytes(coverage.at("observed")), blobs.subject());
        record.coverage = std::make_shared<const Coverage>(std::move(read));
    }
    return record;
}

std::shared_ptr<const ReferenceMap> referenceFrom(const Json& payload, const BlobSource& blobs) {
    ReferenceMap reference = decodeReference(blobs.bytes(payload.at("cloud")), blobs.subject());
    reference.provenance = payload.at("provenance").get<std::vector<std::string>>();
    return std::make_shared<const ReferenceMap>(std::move(reference));
}

void replayPlan(InspectionState& state, const Json& payload, const BlobSource& blobs) {
    OccupancyGrid grid = gridFrom(payload.at("grid_map"));
    grid.cells = decodeGrid(blobs.bytes(payload.at("grid_map").at("cells")), blobs.subject());
    const bool fits = grid.width >= 0 && grid.height >= 0 &&
                      grid.cells.size() == static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    if (!fits) throw std::invalid_argument("the grid's cells do not fit its size");
    std::vector<Visit> visits;
    for (const Json& visit : payload.at("visits")) {
        visits.push_back(visitFrom(visit));
    }
    applyPlan(state, grid, planFrom(payload), visits);
}

void replay(InspectionState& state, const std::string& kind, const Json& payload, BlobSource& blobs) {
    if (kind == act_kind::kHeader) {
        state.header = headerFrom(payload);
    } else if (kind == act_kind::kReference) {
        applyReference(state, sourceFrom(payload), referenceFrom(payload, blobs));
    } else if (kind == act_kind::kMap) {
        applyMap(state, sourceFrom(payload));
    } else if (kind == act_kind::kParameters) {
        state.parameters = parseParameters(payload.at("yaml").get<std::string>(), blobs.subject(), Parameters());
    } else if (kind == act_kind::kDetection) {
        applyDetection(state, detectionFrom(payload, blobs), payload.at("highest_candidate_number").get<int>());
    } else if (kind == act_kind::kPlan) {
        replayPlan(state, payload, blobs);
    } else if (kind == act_kind::kRoute) {
        std::vector<Visit> visits;
        for (const Json& visit : payload.at("visits"))
            visits.push_back(visitFrom(visit));
        applyRoute(state, routeFrom(payload), visits);
    } else if (kind == act_kind::kVisit) {
        if (!applyVisit(state, visitFrom(payload))) throw std::invalid_argument("the plan has no such waypoint");
    } else if (kind == act_kind::kPhoto) {
        Photo photo = photoFrom(payload);
        photo.bytes = blobs.bytes(payload.at("image"));
        state.photos.push_back(std::move(photo));
    } else if (kind == act_kind::kLabelSet) {
        state.labelSet = labelSetFrom(payload);
    } else if (kind == act_kind::kDecision) {
        state.decisions.push_back(decisionFrom(payload));
    } else if (kind == act_kind::kReport) {
        state.reports.push_back(reportFrom(payload));
    } else {
        throw std::invalid_argument("the kind is unknown");
    }
}

}  // namespace

void forEachAct(SQLite::Database& database, const std::function<void(const Act&)>& use) {
    SQLite::Statement query(database,
                            "SELECT sequence, kind, payload, author, time_utc, software_version, previous_hash, hash "
                            "FROM acts ORDER BY sequence");
    while (query.executeStep()) {
        const auto text = [&](int column) { return query.getColumn(column).getString(); };
        use({query.getColumn(0).getInt64(), text(1), text(2), text(3), text(4), text(5), text(6), text(7)});
    }
}

InspectionState readInspection(SQLite::Database& database, const std::filesystem::path& file) {
    InspectionState state;
    BlobSource blobs(database, file.string());
    forEachAct(database, [&](const Act& act) {
        try {
            replay(state, act.kind, Json::parse(act.payload), blobs);
        } catch (const nlohmann::json::exception& exception) {
            throw damagedSession(file, nameOf(act) + ": " + exception.what());
        } catch (const std::invalid_argument& exception) {
            throw damagedSession(file, nameOf(act) + ": " + exception.what());
        }
    });
    return state;
}

}  // namespace fodscope
