// SPDX-License-Identifier: MIT
#include "core/simulation/Raycaster.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

#include "core/common/Error.h"
#include "core/simulation/SmoothNormals.h"

namespace fodscope {
namespace {

constexpr Rgb kUnpainted{150, 150, 146};

/// What a hit on one mesh needs beside Embree's own copy.
struct Surface {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Eigen::Vector3f, 3>> normals;
    std::vector<Rgb> colours;
};

/// Embree ends the program over rays with NaN or astronomic numbers.
bool isUsable(const Eigen::Vector3f& v) {
    constexpr float kFarthest = 1e12f;
    return v.cwiseAbs().maxCoeff() < kFarthest && !v.hasNaN();
}

Rgb mix(const Rgb& a, const Rgb& b, const Rgb& c, float u, float v) {
    const auto channel = [&](std::uint8_t x, std::uint8_t y, std::uint8_t z) {
        const float value =
            (1.0f - u - v) * static_cast<float>(x) + u * static_cast<float>(y) + v * static_cast<float>(z);
        return static_cast<std::uint8_t>(std::lround(std::min(255.0f, std::max(0.0f, value))));
    };
    return {channel(a.red, b.red, c.red), channel(a.green, b.green, c.green), channel(a.blue, b.blue, c.blue)};
}

}  // namespace

struct Raycaster::Scene {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    /// By Embree's geometry number; `object` is that number − 1.
    std::vector<Surface> surfaces;

    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void add(const TriangleMesh& mesh, unsigned id) {
        surfaces.push_back({mesh.triangles, smoothNormals(mesh), mesh.colours});
        if (mesh.triangles.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
        if (!vertices || !indices) {
            rtcReleaseGeometry(geometry);
            throw Error("simulation", "there is not enough memory for the world's meshes", "use a smaller world");
        }
        for (const Eigen::Vector3d& v : mesh.vertices)
            for (int axis = 0; axis < 3; ++axis)
                *vertices++ = static_cast<float>(v[axis]);
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t index : t)
                *indices++ = index;
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }
};

Raycaster::Raycaster(const World& world) : scene_(std::make_unique<Scene>()) {
    // Embree must not start threads of its own: the callers' tasks are the parallelism.
    scene_->device = rtcNewDevice("threads=1");
    if (!scene_->device)
        throw Error("simulation", "the ray caster (Embree) does not start on this processor", "use another computer");
    scene_->scene = rtcNewScene(scene_->device);
    rtcSetSceneFlags(scene_->scene, RTC_SCENE_FLAG_ROBUST);
    scene_->add(world.structure, 0);
    for (std::size_t i = 0; i < world.objects.size(); ++i)
        scene_->add(world.objects[i].mesh, static_cast<unsigned>(i + 1));
    rtcCommitScene(scene_->scene);
    if (rtcGetDeviceError(scene_->device) != RTC_ERROR_NONE)
        throw Error("simulation", "the world could not be prepared for ray casting", "use a smaller world");
}

Raycaster::~Raycaster() = default;
Raycaster::Raycaster(Raycaster&&) noexcept = default;

std::optional<RayHit> Raycaster::cast(const Eigen::Vector3d& origin_world, const Eigen::Vector3d& direction_world,
                                      double range_m) const {
    const double length = direction_world.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const Eigen::Vector3f origin = origin_world.cast<float>();
    const Eigen::Vector3f direction = (direction_world / length).cast<float>();
    if (!isUsable(origin) || !isUsable(direction) || !(range_m > 0.0)) return std::nullopt;
    RTCRayHit ray{};
    ray.ray.org_x = origin.x();
    ray.ray.org_y = origin.y();
    ray.ray.org_z = origin.z();
    ray.ray.dir_x = direction.x();
    ray.ray.dir_y = direction.y();
    ray.ray.dir_z = direction.z();
    ray.ray.tfar = static_cast<float>(range_m);
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Surface& surface = scene_->surfaces[ray.hit.geomID];
    const float u = ray.hit.u, v = ray.hit.v;
    RayHit hit;
    hit.distance_m = static_cast<double>(ray.ray.tfar);
    hit.object = static_cast<int>(ray.hit.geomID) - 1;
    const auto& corners = surface.normals[ray.hit.primID];
    const Eigen::Vector3f geometric(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    Eigen::Vector3f normal = ((1.0f - u - v) * corners[0] + u * corners[1] + v * corners[2]).normalized();
    // Meshes of plates may face either way; a hit is always seen from its front.
    if (geometric.dot(direction) > 0.0f) normal = -normal;
    hit.normal_world = normal.cast<double>();
    hit.colour = kUnpainted;
    if (!surface.colours.empty()) {
        const auto& t = surface.triangles[ray.hit.primID];
        hit.colour = mix(surface.colours[t[0]], surface.colours[t[1]], surface.colours[t[2]], u, v);
    }
    return hit;
}

bool Raycaster::blocked(const Eigen::Vector3d& origin_world, const Eigen::Vector3d& target_world) const {
    const Eigen::Vector3f origin = origin_world.cast<float>();
    const Eigen::Vector3f way = (target_world - origin_world).cast<float>();
    if (!isUsable(origin) || !isUsable(way)) return false;
    RTCRay ray{};
    ray.org_x = origin.x();
    ray.org_y = origin.y();
    ray.org_z = origin.z();
    ray.dir_x = way.x();
    ray.dir_y = way.y();
    ray.dir_z = way.z();
    ray.tfar = 1.0f;
    ray.mask = ~0u;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_->scene, &context, &ray);
    return ray.tfar < 0.0f;
}

}  // namespace fodscope
