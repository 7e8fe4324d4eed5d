// SPDX-License-Identifier: MIT
#include "core/inspection/ParameterTable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace fodscope {
namespace {

/// A parameter read and written through its member of the struct that `Path` finds in a record.
template <typename Path, typename Settings, typename Value>
struct Accessor {
    Path path;
    Value Settings::*member;

    const Value& in(const Parameters& parameters) const { return path(parameters).*member; }
    Value& in(Parameters& parameters) const { return path(parameters).*member; }
};

/// What the fields of one section, or of the settings nested in it, have in common.
/// @tparam Path takes a record, constant or not, to the settings
template <typename Path>
class Section {
  public:
    using Settings = std::remove_reference_t<std::invoke_result_t<Path, Parameters&>>;

    Section(std::vector<ParameterField>& table, std::string name, Path path)
        : table_(table), name_(std::move(name)), path_(std::move(path)) {}

    void number(double Settings::*member, std::string key, const char* unit, double minimum, double maximum,
                const char* help) {
        const auto access = accessTo(member);
        add(std::move(key), unit, help, ParameterKind::Number, minimum, maximum).get =
            [access](const Parameters& from) { return ParameterValue(access.in(from)); };
        table_.back().set = [access](Parameters& to, const ParameterValue& value) {
            access.in(to) = std::get<double>(value);
        };
    }

    void angle(double Settings::*member, std::string key, double minimum_deg, double maximum_deg, const char* help) {
        const auto access = accessTo(member);
        add(std::move(key), "deg", help, ParameterKind::Number, minimum_deg, maximum_deg).get =
            [access](const Parameters& from) { return ParameterValue(degreesThatGive(access.in(from))); };
        table_.back().set = [access](Parameters& to, const ParameterValue& value) {
            access.in(to) = radiansFromDegrees(std::get<double>(value));
        };
    }

    void optionalNumber(std::optional<double> Settings::*member, std::string key, const char* unit, double minimum,
                        double maximum, const char* help) {
        const auto access = accessTo(member);
        add(std::move(key), unit, help, ParameterKind::OptionalNumber, minimum, maximum).get =
            [access](const Parameters& from) {
                const std::optional<double>& value = access.in(from);
                return value ? ParameterValue(*value) : ParameterValue();
            };
        table_.back().set = [access](Parameters& to, const ParameterValue& value) {
            access.in(to).reset();
            if (const double* number = std::get_if<double>(&value)) access.in(to) = *number;
        };
    }

    void whole(int Settings::*member, std::string key, double minimum, double maximum, const char* help) {
        const auto access = accessTo(member);
        add(std::move(key), "", help, ParameterKind::Whole, minimum, maximum).get = [access](const Parameters& from) {
            return ParameterValue(access.in(from));
        };
        table_.back().set = [access](Parameters& to, const ParameterValue& value) {
            access.in(to) = std::get<int>(value);
        };
    }

    void toggle(bool Settings::*member, std::string key, const char* help) {
        const auto access = accessTo(member);
        add(std::move(key), "", help, ParameterKind::Switch, 0.0, 1.0).get = [access](const Parameters& from) {
            return ParameterValue(access.in(from));
        };
        table_.back().set = [access](Parameters& to, const ParameterValue& value) {
            access.in(to) = std::get<bool>(value);
        };
    }

    /// `words` in the order of the enumerators, which start at 0.
    template <typename Enum>
    ParameterField& choice(Enum Settings::*member, std::string key, std::vector<std::string> words, const char* help) {
        const auto access = accessTo(member);
        ParameterField& field = add(std::move(key), "", help, ParameterKind::Choice, 0.0, 0.0);
        field.choices = words;
        field.get = [access, words](const Parameters& from) {
            return ParameterValue(words[static_cast<std::size_t>(access.in(from))]);
        };
        field.set = [access, words](Parameters& to, const ParameterValue& value) {
            const auto word = std::ranges::find(words, std::get<std::string>(value));
            access.in(to) = static_cast<Enum>(word - words.begin());
        };
        return field;
    }

  private:
    template <typename Value>
    Accessor<Path, Settings, Value> accessTo(Value Settings::*member) const {
        return {path_, member};
    }

    ParameterField& add(std::string key, std::string unit, std::string help, ParameterKind kind, double minimum,
                        double maximum) {
        ParameterField field;
        field.section = name_;
        field.key = std::move(key);
        field.unit = std::move(unit);
        field.help = std::move(help);
        field.kind = kind;
        field.minimum = minimum;
        field.maximum = maximum;
        return table_.emplace_back(std::move(field));
    }

    /// The shortest number of degrees that is read back as exactly these radians, where there is one.
    static double degreesThatGive(double angle_rad) {
        const double exact_deg = degreesFromRadians(angle_rad);
        for (int digits = 1; digits <= 17; ++digits) {
            char text[64];
            const auto end = std::to_chars(text, text + sizeof text, exact_deg, std::chars_format::general, digits);
            double short_deg = exact_deg;
            std::from_chars(text, end.ptr, short_deg);
            if (radiansFromDegrees(short_deg) == angle_rad) return short_deg;
        }
        return exact_deg;
    }

    std::vector<ParameterField>& table_;
    std::string name_;
    Path path_;
};

/// Settings nested in a section: their keys begin with a word that tells them apart.
template <typename Path>
void addSmoothing(std::vector<ParameterField>& table, const std::string& name, const std::string& word, Path path) {
    Section section(table, name, path);
    section.choice(&SmoothingSettings::neighbourhood, word + "_neighbourhood", {"knn", "ball"},
                   "what is smoothed over: the k nearest, or all in a ball");
    section.whole(&SmoothingSettings::neighbours, word + "_neighbours", 1, 1000000,
                  "k of the k nearest; 1: no smoothing");
    section.number(&SmoothingSettings::radius_m, word + "_radius_m", "m", 0.001, 100, "radius of the ball");
    section.choice(&SmoothingSettings::weights, word + "_weights", {"mean", "gaussian"},
                   "all alike, or exp(-r^2 / sigma^2) at the distance r");
    section.number(&SmoothingSettings::sigma_m, word + "_sigma_m", "m", 0.0001, 100, "sigma of the gaussian");
}

void addReference(std::vector<ParameterField>& table) {
    Section section(
        table, kReferenceSection, [](auto& all) -> auto& { return all.reference; });
    section.number(&ReferenceSettings::cadSpacing_m, "cad_spacing_m", "m", 0.001, 1,
                   "spacing of the samples of a CAD mesh");
    section.number(&ReferenceSettings::voxelSize_m, "voxel_size_m", "m", 0.001, 1, "voxels of the nominal maps' mean");
    section.number(&ReferenceSettings::occupancyQuantile, "occupancy_quantile", "", 0, 1,
                   "voxels with fewer points than this quantile of the counts are dropped");
    addSmoothing(
        table, kReferenceSection, "covariance", [](auto& all) -> auto& { return all.reference.covariance.smoothing; });
    Section fit(
        table, kReferenceSection, [](auto& all) -> auto& { return all.reference.covariance; });
    fit.optionalNumber(&CovarianceFitSettings::smoothingVoxelSize_m, "covariance_voxel_size_m", "m", 0.001, 10,
                       "covariances are smoothed at the means of these voxels; none: at every point");
    fit.number(&CovarianceFitSettings::regularisation_m2, "covariance_regularisation_m2", "m^2", 0, 1,
               "added to the diagonal of every fitted covariance");
}

void addDenoise(std::vector<ParameterField>& table) {
    Section section(
        table, "denoise", [](auto& all) -> auto& { return all.denoise; });
    section.toggle(&OutlierRemovalSettings::enabled, "enabled", "statistical outlier removal of the map");
    section.whole(&OutlierRemovalSettings::neighbours, "neighbours", 2, 10000,
                  "nearest points that judge a point, itself among them");
    section.number(&OutlierRemovalSettings::standardDeviations, "standard_deviations", "", 0.01, 100,
                   "points farther from their neighbours than the mean and this many deviations are dropped");
}

void addRegistration(std::vector<ParameterField>& table) {
    Section section(
        table, "registration", [](auto& all) -> auto& { return all.registration; });
    section.number(&RegistrationSettings::mapVoxelSize_m, "map_voxel_size_m", "m", 0.001, 1, "voxels of the map");
    section.number(&RegistrationSettings::maximumCorrespondence_m, "maximum_correspondence_m", "m", 0.001, 100,
                   "pairs of points farther apart are ignored");
    section.whole(&RegistrationSettings::maximumIterations, "maximum_iterations", 1, 100000,
                  "steps after which the search gives up");
    section.number(&RegistrationSettings::overlapDistance_m, "overlap_distance_m", "m", 0.001, 10,
                   "a map voxel this near to the reference overlaps");
    section.number(&RegistrationSettings::minimumOverlap, "minimum_overlap", "", 0, 1,
                   "share of overlapping map voxels under which the alignment is bad");
    section.number(&RegistrationSettings::coarseVoxelSize_m, "coarse_voxel_size_m", "m", 0.01, 5,
                   "voxels whose surfaces are searched and fitted");
    section.number(&RegistrationSettings::minimumExplained, "minimum_explained", "", 0, 1,
                   "share of the map's surfaces, all directions alike, that have to lie in the reference's");
    section.number(&RegistrationSettings::ambiguityMargin, "ambiguity_margin", "", 0, 1,
                   "another pose whose share is at most this smaller fits nearly as well");
    section.choice(&RegistrationSettings::refinement, "refinement", {"point-to-plane", "point-to-point"},
                   "last step: true to most surfaces, or the least distances to the nearest reference points (paper)");
}

void addDiscrepancy(std::vector<ParameterField>& table) {
    Section section(
        table, "discrepancy", [](auto& all) -> auto& { return all.discrepancy; });
    section.choice(&DiscrepancySettings::downSampling, "down_sampling", {"voxel", "random"},
                   "how the map is thinned: to the means of voxels, or to a share of its points");
    section.number(&DiscrepancySettings::voxelSize_m, "voxel_size_m", "m", 0.001, 1,
                   "voxels of the map; size of a point that was kept at random");
    section.number(&DiscrepancySettings::randomRatio, "random_ratio", "", 0.01, 1,
                   "share of the points that random down-sampling keeps");
    section.whole(&DiscrepancySettings::randomSeed, "random_seed", 0, 2147483647, "another seed keeps other points");
    section.toggle(&DiscrepancySettings::cropToReference, "crop_to_reference",
                   "drop map points outside the reference's bounds");
    section.optionalNumber(&DiscrepancySettings::cropHeight_m, "crop_height_m", "m", -1000, 1000,
                           "map points higher than this in the reference frame are dropped; none: no limit");
    addSmoothing(
        table, "discrepancy", "smoothing", [](auto& all) -> auto& { return all.discrepancy.smoothing; });
    section.whole(&DiscrepancySettings::smoothingPasses, "smoothing_passes", 0, 100,
                  "how often the discrepancy is smoothed; 0: not at all");
}

/// The threshold of the test follows its settings, unless it is set after them.
void thresholdFollows(ParameterField& field) {
    field.set = [set = field.set](Parameters& to, const ParameterValue& value) {
        const LocalStatisticalTestSettings before = to.chiSquare;
        set(to, value);
        if (to.candidates.metric == Metric::ChiSquare && to.chiSquare != before)
            to.candidates.threshold = testThreshold(to.chiSquare);
    };
}

void addChiSquare(std::vector<ParameterField>& table) {
    Section section(
        table, "chi_square", [](auto& all) -> auto& { return all.chiSquare; });
    section.choice(&LocalStatisticalTestSettings::distribution, "distribution", {"gauss", "weibull"},
                   "what the Euclidean discrepancy is expected to follow in the chi-square metric");
    section.whole(&LocalStatisticalTestSettings::neighbours, "neighbours", 2, 10000,
                  "nearest voxels that are tested together, the voxel itself among them");
    thresholdFollows(table.back());
    section.number(&LocalStatisticalTestSettings::pValue, "p_value", "", 1e-12, 0.5,
                   "share of unremarkable voxels above the metric's usual threshold");
    thresholdFollows(table.back());
}

void addCandidates(std::vector<ParameterField>& table) {
    Section section(
        table, "candidates", [](auto& all) -> auto& { return all.candidates; });
    ParameterField& metric =
        section.choice(&CandidateSettings::metric, "metric", {"euclidean", "mahalanobis", "chi-square"},
                       "how far a map voxel deviates from the reference");
    metric.set = [setMetric = metric.set](Parameters& to, const ParameterValue& value) {
        const Metric before = to.candidates.metric;
        setMetric(to, value);
        if (to.candidates.metric == before) return;
        // A threshold means nothing in the other metric's unit, so its own usual values come with it.
        const CandidateSettings kept = to.candidates;
        to.candidates = usualCandidateSettings(kept.metric, to);
        to.candidates.linkage = kept.linkage;
        to.candidates.centroid = kept.centroid;
    };
    section.number(&CandidateSettings::threshold, "threshold", "", 0, 10000,
                   "a voxel is discrepant when its smoothed discrepancy is greater; metres for euclidean");
    section.number(&CandidateSettings::clusterCutoff_m, "cluster_cutoff_m", "m", 0, 100,
                   "clusters at most this far apart are merged");
    section.choice(&CandidateSettings::linkage, "linkage", {"centroid", "single"},
                   "how far clusters are apart: from centroid to centroid, or from nearest point to nearest point");
    section.whole(&CandidateSettings::minimumPoints, "minimum_points", 0, 1000000,
                  "clusters with fewer voxels are dropped");
    section.choice(&CandidateSettings::centroid, "centroid", {"plain", "discrepancy-weighted"},
                   "where a candidate is said to be");
}

void addCoverage(std::vector<ParameterField>& table) {
    Section section(
        table, "coverage", [](auto& all) -> auto& { return all.coverage; });
    section.number(&CoverageSettings::observedWithin_m, "observed_within_m", "m", 0.001, 10,
                   "a reference point with a map voxel this near was observed");
}

void addOccupancy(std::vector<ParameterField>& table) {
    Section section(
        table, "occupancy", [](auto& all) -> auto& { return all.occupancy; });
    section.number(&OccupancySettings::resolution_m, "resolution_m", "m", 0.005, 5, "edge of a grid cell");
    section.number(&OccupancySettings::obstacleMinimumHeight_m, "obstacle_minimum_height_m", "m", -10, 100,
                   "points higher than this over the floor are obstacles");
    section.number(&OccupancySettings::obstacleMaximumHeight_m, "obstacle_maximum_height_m", "m", -10, 100,
                   "points higher than this pass over the robot");
    section.whole(&OccupancySettings::minimumObstaclePoints, "minimum_obstacle_points", 1, 1000000,
                  "cells with fewer obstacle points stay free");
    section.number(&OccupancySettings::closeGaps_m, "close_gaps_m", "m", 0, 10,
                   "unknown cells this near to known floor, enclosed by it, count as free");
}

void addCostMap(std::vector<ParameterField>& table) {
    Section section(
        table, "cost_map", [](auto& all) -> auto& { return all.costMap; });
    section.number(&CostMapSettings::inscribedRadius_m, "inscribed_radius_m", "m", 0, 100,
                   "the robot touches an obstacle that is this near");
    section.number(&CostMapSettings::inflationRadius_m, "inflation_radius_m", "m", 0, 100,
                   "obstacles cost nothing farther away");
    section.number(&CostMapSettings::costScalingFactor, "cost_scaling_factor", "", 0, 1000,
                   "how fast the cost falls with distance");
}

void addCamera(std::vector<ParameterField>& table) {
    Section section(
        table, "camera", [](auto& all) -> auto& { return all.camera; });
    section.whole(&CameraSettings::width_px, "width_px", 16, 16384, "width of a photo in pixels");
    section.whole(&CameraSettings::height_px, "height_px", 16, 16384, "height of a photo in pixels");
    section.angle(&CameraSettings::horizontalFieldOfView_rad, "horizontal_field_of_view_deg", 1, 170,
                  "what a photo shows from its left to its right edge");
    section.number(&CameraSettings::height_m, "height_m", "m", 0, 10, "height of the lens over the floor");
    section.angle(&CameraSettings::pitchDown_rad, "pitch_down_deg", -60, 60, "how far the camera looks down");
    section.number(&CameraSettings::nearLimit_m, "near_limit_m", "m", 0, 10, "what is nearer is not sharp");
}

void addWaypoints(std::vector<ParameterField>& table) {
    Section section(
        table, "waypoints", [](auto& all) -> auto& { return all.waypoints; });
    section.number(&WaypointSettings::minimumDistance_m, "minimum_distance_m", "m", 0, 100,
                   "nearest pose to the candidate's edge");
    section.number(&WaypointSettings::maximumDistance_m, "maximum_distance_m", "m", 0.01, 100,
                   "farthest pose from the candidate's edge");
    section.number(&WaypointSettings::closestDistance_m, "closest_distance_m", "m", 0, 100,
                   "a widened ring comes no nearer");
    section.number(&WaypointSettings::candidateClearance_m, "candidate_clearance_m", "m", 0, 100,
                   "no pose is nearer to any candidate");
    section.number(&WaypointSettings::coarsestPixel_m, "coarsest_pixel_m", "m", 0.00001, 1,
                   "a pixel of the photo covers at most so much of the candidate");
    section.number(&WaypointSettings::edgeMargin, "edge_margin", "", 0, 0.4,
                   "share of the photo that stays free along each edge");
    section.number(&WaypointSettings::widening, "widening", "", 0, 1,
                   "share by which the ring is widened when no pose is found");
    section.whole(&WaypointSettings::maximumTries, "maximum_tries", 1, 1000, "rings that are tried");
    section.number(&WaypointSettings::costThresholdPercent, "cost_threshold_percent", "%", 0, 100,
                   "poses on cells with at least this cost collide");
    section.angle(&WaypointSettings::angleStep_rad, "angle_step_deg", 0.1, 180, "step of the poses along the ring");
    section.number(&WaypointSettings::distanceStep_m, "distance_step_m", "m", 0.001, 10,
                   "step of the poses across the ring");
    section.number(&WaypointSettings::rayStep_cells, "ray_step_cells", "", 0.001, 10,
                   "step along a line of sight, in grid cells");
    section.choice(&WaypointSettings::order, "order", {"nearest-next", "shortest-tour"},
                   "visit order: always the nearest waypoint that is left (paper), or the shortest tour found");
}

void addVisits(std::vector<ParameterField>& table) {
    Section section(
        table, "visits", [](auto& all) -> auto& { return all.visits; });
    section.number(&VisitSettings::acknowledgeTimeout_s, "acknowledge_timeout_s", "s", 0.1, 3600,
                   "sent to accepted: a goal that the robot has not confirmed by then counts as not acknowledged");
    section.number(&VisitSettings::departureTimeout_s, "departure_timeout_s", "s", 0.1, 86400,
                   "accepted to driving: longest wait for the robot to set out");
    section.number(&VisitSettings::driveTimeout_s, "drive_timeout_s", "s", 1, 86400,
                   "driving to arrived: longest drive to a waypoint");
    section.number(&VisitSettings::localiseTimeout_s, "localise_timeout_s", "s", 0.1, 3600,
                   "arrived to photo: longest wait for the robot to know where it stands");
    section.number(&VisitSettings::photoTimeout_s, "photo_timeout_s", "s", 0.1, 3600,
                   "photo to done: longest wait for a photo");
    section.number(&VisitSettings::linkTimeout_s, "link_timeout_s", "s", 0.1, 86400,
                   "a link that stays lost this long holds the visits until somebody resumes them");
    section.number(&VisitSettings::cancelTimeout_s, "cancel_timeout_s", "s", 0.1, 3600,
                   "a stop that the robot has not obeyed by then is sent again");
    section.whole(&VisitSettings::maximumTries, "maximum_tries", 1, 100, "drives that a visit tries");
    section.whole(&VisitSettings::maximumPhotoTries, "maximum_photo_tries", 1, 100,
                  "photos that are asked for at a waypoint");
    section.number(&VisitSettings::retryPause_s, "retry_pause_s", "s", 0, 3600,
                   "pause before a second try; twice as long before each further one");
    section.number(&VisitSettings::arrivalTolerance_m, "arrival_tolerance_m", "m", 0.01, 100,
                   "a robot that stands farther from the waypoint has not arrived");
    section.angle(&VisitSettings::arrivalTolerance_rad, "arrival_tolerance_deg", 0.1, 180,
                  "a robot that is turned farther from the waypoint's direction has not arrived");
    section.number(&VisitSettings::maximumPoseAge_s, "maximum_pose_age_s", "s", 0.1, 3600,
                   "an older pose does not tell where the robot stands");
    section.number(&VisitSettings::maximumClockOffset_s, "maximum_clock_offset_s", "s", 0.01, 86400,
                   "the robot's clock may be this far off, and a photo's time from the visit");
    section.number(&VisitSettings::cameraReach_m, "camera_reach_m", "m", 0.01, 100,
                   "a photo whose camera was farther from the waypoint is of another place");
    section.number(&VisitSettings::leastContrast, "least_photo_contrast", "", 0, 255,
                   "grey levels, of 255, that a photo spans at least; 0 takes black ones too");
}

std::string shortest(double number) {
    char text[64];
    return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

}  // namespace

std::span<const ParameterField> parameterTable() {
    static const std::vector<ParameterField> table = [] {
        std::vector<ParameterField> fields;
        addReference(fields);
        addDenoise(fields);
        addRegistration(fields);
        addDiscrepancy(fields);
        addChiSquare(fields);
        addCandidates(fields);
        addCoverage(fields);
        addOccupancy(fields);
        addCostMap(fields);
        addCamera(fields);
        addWaypoints(fields);
        addVisits(fields);
        return fields;
    }();
    return table;
}

const ParameterField* findParameter(const std::string& section, const std::string& key) {
    for (const ParameterField& field : parameterTable()) {
        if (field.section == section && field.key == key) return &field;
    }
    return nullptr;
}

std::string toString(const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return "none";
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const int* whole = std::get_if<int>(&value)) return std::to_string(*whole);
    if (const double* number = std::get_if<double>(&value)) return shortest(*number);
    return std::get<std::string>(value);
}

std::vector<std::string> parameterProblems(const Parameters& parameters) {
    std::vector<std::string> problems;
    for (const ParameterField& field : parameterTable()) {
        const ParameterValue value = field.get(parameters);
        std::optional<double> number;
        if (const int* whole = std::get_if<int>(&value)) number = *whole;
        if (const double* real = std::get_if<double>(&value)) number = *real;
        if (!number || (*number >= field.minimum && *number <= field.maximum)) continue;
        problems.push_back(field.section + "." + field.key + " is " + toString(value) + ", allowed is " +
                           shortest(field.minimum) + " to " + shortest(field.maximum));
    }
    const auto ordered = [&](double low, double high, const std::string& lowKey, const std::string& highKey) {
        if (low > high) problems.push_back(lowKey + " is greater than " + highKey);
    };
    ordered(parameters.occupancy.obstacleMinimumHeight_m, parameters.occupancy.obstacleMaximumHeight_m,
            "occupancy.obstacle_minimum_height_m", "occupancy.obstacle_maximum_height_m");
    ordered(parameters.costMap.inscribedRadius_m, parameters.costMap.inflationRadius_m, "cost_map.inscribed_radius_m",
            "cost_map.inflation_radius_m");
    ordered(parameters.waypoints.minimumDistance_m, parameters.waypoints.maximumDistance_m,
            "waypoints.minimum_distance_m", "waypoints.maximum_distance_m");
    return problems;
}

}  // namespace fodscope
