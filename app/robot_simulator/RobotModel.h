// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What the node's ROS side sees of the simulation. Its files are C++17, the simulation is C++20: so nothing here
/// includes anything of core.
namespace fodscope::robot_simulator {

struct PlanarPose {
    double x_m = 0.0;
    double y_m = 0.0;
    double yaw_rad = 0.0;
};

struct Velocity {
    double forward_m_per_s = 0.0;
    double turn_rad_per_s = 0.0;
};

/// Rows of percent as nav_msgs/OccupancyGrid has them: 0 free, 100 occupied, −1 unknown; row 0 at the origin.
struct PercentGrid {
    int width = 0;
    int height = 0;
    double resolution_m = 0.0;
    double originX_map_m = 0.0;
    double originY_map_m = 0.0;
    std::vector<std::int8_t> percent;
};

struct ColouredPoint {
    float x_m = 0.0F;
    float y_m = 0.0F;
    float z_m = 0.0F;
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

/// The camera as it sits on the robot: a pinhole that looks forward and a little down.
struct CameraShape {
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double height_m = 0.0;
    double pitchDown_rad = 0.0;
};

/// One frame of the camera.
struct Picture {
    double exposed_s = 0.0;
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> jpeg;
    /// The same as rows of red, green, blue.
    std::vector<std::uint8_t> rgb;
};

struct ModelSettings {
    /// "builtin" or the file of a world.
    std::string world = "builtin";
    /// What lies in the built-in tank, and where.
    std::uint64_t fodSeed = 8;
    /// Of the mapping run, the map frame and the camera's noise; the default is the trial of `fodscope --demo`.
    std::uint64_t seed = 106;
    /// Begins with a finished map, as RTAB-Map does with the database of an earlier drive; else with an empty one.
    bool mapped = true;
    /// The finished map, when it is not to be simulated; its frame is the world's map frame.
    std::string mapFile;
    double speed_m_per_s = 0.22;
    double turnSpeed_rad_per_s = 1.0;
    /// The wheels stop when no velocity was commanded for this long.
    double commandTimeout_s = 0.5;
    int imageWidth_px = 1280;
    int imageHeight_px = 720;
    double imageRate_hz = 5.0;
    /// Where the robot stands at first, map frame; empty: where the world says.
    std::optional<PlanarPose> start_map;
};

/// The simulated robot in its world. Time is the caller's, monotonic, in seconds. Not for several threads.
class RobotModel {
  public:
    virtual ~RobotModel() = default;

    virtual void advance(double now_s) = 0;

    virtual PlanarPose pose_map() const = 0;
    /// Where it stood first, which is the origin of its odometry.
    virtual PlanarPose start_map() const = 0;
    virtual Velocity velocity() const = 0;

    /// Begins a drive along the cost map's path. @return false when no path leads there; the robot then stands
    virtual bool driveTo(const PlanarPose& goal_map) = 0;
    /// @return whether it is on a drive, and which share of the drive's time has passed
    virtual bool isDriving() const = 0;
    virtual double drivenShare() const = 0;
    virtual void stop() = 0;
    /// Drives by velocity, as teleoperation does; not heard during a drive to a goal. It stops at obstacles.
    virtual void command(const Velocity& velocity) = 0;

    virtual bool isMapping() const = 0;
    virtual void setMapping(bool on) = 0;
    /// Rises whenever the SLAM has worked in a new view, which takes motion.
    virtual std::uint64_t mapUpdates() const = 0;
    /// Rises whenever map, grid or path have become others.
    virtual std::uint64_t mapVersion() const = 0;
    virtual std::vector<ColouredPoint> mapCloud() const = 0;
    virtual PercentGrid grid() const = 0;
    virtual PercentGrid costMap() const = 0;
    /// Where the robot was when it saw the map, as the SLAM believes.
    virtual std::vector<PlanarPose> mapPath() const = 0;

    virtual CameraShape camera() const = 0;
    /// Frames are made only while somebody wants them.
    virtual void setCameraWanted(bool wanted) = 0;
    /// @return a frame that was finished since the last call
    virtual std::optional<Picture> takePicture() = 0;
};

/// @throws std::runtime_error with one sentence for the user, for a world or map that cannot be used
std::unique_ptr<RobotModel> makeRobotModel(const ModelSettings& settings);

}  // namespace fodscope::robot_simulator
