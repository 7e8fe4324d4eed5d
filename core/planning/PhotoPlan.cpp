// SPDX-License-Identifier: MIT
#include "core/planning/PhotoPlan.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/planning/PhotoCover.h"

namespace fodscope {
namespace {

/// A part with the places that show it.
struct ShownPart {
    PhotoPart part;
    std::vector<PhotoPlace> places;
    /// From its centre to the farthest corner.
    double radius_m = 0.0;
};

double radiusOf(const PhotoPart& part) {
    double radius_m = 0.0;
    for (const Eigen::Vector2d& corner : part.footprint_map)
        radius_m = std::max(radius_m, (corner - part.centre_map).norm());
    return radius_m;
}

bool isFinite(const PlanTarget& target) {
    return target.centroid_map.allFinite() && target.size_m.allFinite() &&
           std::ranges::all_of(target.voxels, [](const Eigen::Vector3d& voxel) { return voxel.allFinite(); });
}

/// Finds places for a target, dividing it where no place shows the whole.
class Division {
  public:
    Division(const SearchFloor& floor, const CameraFit& camera, const WaypointSettings& settings,
             std::vector<ShownPart>& parts)
        : floor_(floor), camera_(camera), settings_(settings), parts_(parts) {}

    CandidateView divide(const PlanTarget& target, std::size_t index, const Progress& progress) {
        CandidateView view{target.candidateId, 0.0, WaypointStatus::OutsideGrid};
        if (!isFinite(target)) return view;
        const PhotoPart whole = wholeOf(target, index);
        shown_ = 0;
        firstReason_ = WaypointStatus::Ok;
        const WaypointStatus reason = search(whole, progress);
        view.share = static_cast<double>(shown_) / static_cast<double>(whole.voxels.size());
        // A target that no photo shows has the reason of the whole, not that of some corner of it.
        view.rest = shown_ == 0 ? reason : firstReason_;
        return view;
    }

  private:
    /// @return why the part is not whole on any photo
    WaypointStatus search(const PhotoPart& part, const Progress& progress) {
        progress.throwIfCancelled();
        PhotoPlaces found = placesFor(part, floor_, camera_, settings_);
        if (found.status == WaypointStatus::Ok) {
            shown_ += part.voxels.size();
            parts_.push_back({part, std::move(found.places), radiusOf(part)});
            return WaypointStatus::Ok;
        }
        const auto halves = found.status == WaypointStatus::OutsideGrid ? std::nullopt : halvesOf(part);
        if (halves) {
            search(halves->first, progress);
            search(halves->second, progress);
        } else if (firstReason_ == WaypointStatus::Ok) {
            firstReason_ = found.status;
        }
        return found.status;
    }

    const SearchFloor& floor_;
    const CameraFit& camera_;
    const WaypointSettings& settings_;
    std::vector<ShownPart>& parts_;
    std::size_t shown_ = 0;
    WaypointStatus firstReason_ = WaypointStatus::Ok;
};

/// A part seen from a place.
struct View {
    std::size_t part = 0;
    double cost = 0.0;
    YawRange yaws;
};

double bearing(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

/// The choice of poses, each with the parts that it shows.
class Poses {
  public:
    Poses(std::span<const ShownPart> parts, const SearchFloor& floor, const CameraFit& camera)
        : parts_(parts), floor_(floor), camera_(camera) {}

    void addAllOf(std::size_t part, const Progress& progress) {
        for (const PhotoPlace& place : parts_[part].places) {
            const double facing_rad = bearing(place.place_map, parts_[part].part.centre_map);
            add({part}, place.cost,
                {place.place_map.x(), place.place_map.y(),
                 wrapAngle(std::clamp(facing_rad, place.yaws.lowest_rad, place.yaws.highest_rad))});
            progress.throwIfCancelled();
            addShared(place, viewsFrom(place, part));
        }
    }

    std::vector<PhotoPose> fewest() const {
        std::vector<CoverSet> sets;
        std::vector<const Pose2*> poses;
        for (const auto& [parts, best] : bests_) {
            sets.push_back({parts, best.cost});
            poses.push_back(&best.pose_map);
        }
        std::vector<PhotoPose> chosen;
        for (const std::size_t set : fewestSets(sets, parts_.size())) {
            PhotoPose pose{*poses[set], sets[set].cost, {}};
            for (const std::size_t part : sets[set].elements)
                pose.targets.push_back(parts_[part].part.target);
            std::ranges::sort(pose.targets);
            const auto repeated = std::ranges::unique(pose.targets);
            pose.targets.erase(repeated.begin(), repeated.end());
            chosen.push_back(std::move(pose));
        }
        return chosen;
    }

  private:
    struct Best {
        double cost = 0.0;
        Pose2 pose_map;
    };

    /// All that is whole in a picture from the place, if the robot turns there, the part that the place belongs to
    /// first.
    std::vector<View> viewsFrom(const PhotoPlace& place, std::size_t owner) const {
        std::vector<View> views{{owner, place.cost, place.yaws}};
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const ShownPart& other = parts_[i];
            if (i == owner) continue;
            if ((other.part.centre_map - place.place_map).norm() > camera_.range_m() + other.radius_m) continue;
            View view{i, 0.0, {}};
            if (camera_.fit(place.place_map, other.part, view.yaws) != PictureFit::Fits) continue;
            const auto cost = floor_.costOfSight(place.place_map, other.part);
            if (!cost || isCovered(place.place_map, other.part)) continue;
            view.cost = *cost;
            views.push_back(view);
        }
        return views;
    }

    /// Candidates are left out of the map that lines of sight cross, but they may stand before each other.
    bool isCovered(const Eigen::Vector2d& place_map, const PhotoPart& part) const {
        const Eigen::Vector3d lens(place_map.x(), place_map.y(), camera_.height_m());
        const Eigen::Vector3d middle(part.centre_map.x(), part.centre_map.y(), 0.5 * (part.low_m + part.high_m));
        return std::ranges::any_of(parts_, [&](const ShownPart& other) {
            return other.part.target != part.target && isInTheWay(other.part, lens, middle);
        });
    }

    /// Every largest set of views that one yaw has in the picture.
    void addShared(const PhotoPlace& place, std::vector<View> views) {
        if (views.size() < 2) return;
        const double reference_rad = 0.5 * (views.front().yaws.lowest_rad + views.front().yaws.highest_rad);
        for (View& view : views) {
            const double middle_rad = 0.5 * (view.yaws.lowest_rad + view.yaws.highest_rad);
            const double shift_rad = reference_rad + wrapAngle(middle_rad - reference_rad) - middle_rad;
            view.yaws.lowest_rad += shift_rad;
            view.yaws.highest_rad += shift_rad;
        }
        for (const View& first : views) {
            const double turn_rad = first.yaws.lowest_rad;
            std::vector<std::size_t> parts;
            double cost = 0.0, lowest_rad = turn_rad, highest_rad = first.yaws.highest_rad;
            Eigen::Vector2d facing = Eigen::Vector2d::Zero();
            for (const View& view : views) {
                if (view.yaws.lowest_rad > turn_rad || view.yaws.highest_rad < turn_rad) continue;
                parts.push_back(view.part);
                cost += view.cost;
                highest_rad = std::min(highest_rad, view.yaws.highest_rad);
                facing += (parts_[view.part].part.centre_map - place.place_map).normalized();
            }
            if (parts.size() < 2) continue;
            std::ranges::sort(parts);
            // In the middle between them, as far as all stay in the picture.
            const double middle_rad = std::atan2(facing.y(), facing.x());
            const double wanted_rad = reference_rad + wrapAngle(middle_rad - reference_rad);
            const double yaw_rad = std::clamp(wanted_rad, lowest_rad, highest_rad);
            add(parts, cost, {place.place_map.x(), place.place_map.y(), wrapAngle(yaw_rad)});
        }
    }

    void add(const std::vector<std::size_t>& parts, double cost, const Pose2& pose_map) {
        const auto [known, isNew] = bests_.try_emplace(parts, Best{cost, pose_map});
        if (!isNew && cost < known->second.cost) known->second = {cost, pose_map};
    }

    std::span<const ShownPart> parts_;
    const SearchFloor& floor_;
    const CameraFit& camera_;
    /// The cheapest pose for each set of parts; of equally cheap ones the first.
    std::map<std::vector<std::size_t>, Best> bests_;
};

}  // namespace

PhotoPlan planPhotos(std::span<const PlanTarget> targets, const SearchFloor& floor, const CameraFit& camera,
                     const WaypointSettings& settings, Progress& progress) {
    PhotoPlan plan;
    std::vector<ShownPart> parts;
    Division division(floor, camera, settings, parts);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        progress.report("choosing waypoints", 0.5 * static_cast<double>(i) / static_cast<double>(targets.size()));
        plan.views.push_back(division.divide(targets[i], i, progress));
    }
    Poses poses(parts, floor, camera);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        progress.report("choosing waypoints", 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(parts.size()));
        poses.addAllOf(i, progress);
    }
    plan.poses = poses.fewest();
    return plan;
}

}  // namespace fodscope
