// Implements ray and nearest-point queries; the only user of Embree.

#include "stimuli/meshes/surface_search.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

struct Device {
  RTCDevice device = nullptr;
  // The tree is built by one thread, so that it, and the choice between two equal hits, is always the same.
  Device() : device(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device == nullptr) {
      throw std::runtime_error("Embree cannot be initialised (error code " +
                               std::to_string(rtcGetDeviceError(nullptr)) +
                               "); close other programs, then try again");
    }
  }
  ~Device() { rtcReleaseDevice(device); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
};

void find_first_hit(RTCScene scene, RTCRayHit& hit) {
#if RTC_VERSION_MAJOR < 4
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
#else
  rtcIntersect1(scene, &hit);
#endif
}

}  // namespace

struct SurfaceSearch::Scene {
  explicit Scene(const TriangleMesh& searched) : mesh(searched) {
    if (mesh.triangles.empty())
      throw std::invalid_argument("the mesh has no triangles; a search needs at least one");
    glm::dvec3 low_m = mesh.vertices_m[mesh.triangles[0][0]];
    glm::dvec3 high_m = low_m;
    for (const glm::dvec3& point_m : mesh.vertices_m) {
      low_m = glm::min(low_m, point_m);
      high_m = glm::max(high_m, point_m);
    }
    centre_m = 0.5 * (low_m + high_m);
    size_m = glm::length(high_m - low_m);
    scene = rtcNewScene(device.device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices_m.size()));
    auto* corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (points != nullptr && corners != nullptr) {
      for (const glm::dvec3& point_m : mesh.vertices_m) {
        const glm::dvec3 point = scaled(point_m);
        for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(point[axis]);
      }
      for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) *corners++ = corner;
      }
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (const RTCError error = rtcGetDeviceError(device.device); error != RTC_ERROR_NONE) {
      rtcReleaseScene(scene);
      throw std::runtime_error("Embree cannot build a search tree of " +
                               counted(mesh.triangles.size(), "triangle", "triangles") +
                               " (error code " + std::to_string(error) +
                               "); simplify the mesh, or close other programs");
    }
  }
  ~Scene() { rtcReleaseScene(scene); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The coordinates in a frame in which the mesh has unit size about the origin, for single precision.
  glm::dvec3 scaled(const glm::dvec3& point_m) const { return (point_m - centre_m) / size_m; }

  std::array<glm::dvec3, 3> corners_m(std::uint32_t triangle) const {
    const auto& corners = mesh.triangles[triangle];
    return {mesh.vertices_m[corners[0]], mesh.vertices_m[corners[1]], mesh.vertices_m[corners[2]]};
  }

  const TriangleMesh& mesh;
  glm::dvec3 centre_m{};
  double size_m = 1.0;
  Device device{};
  RTCScene scene = nullptr;
};

namespace {

struct NearestSearch {
  const TriangleMesh* mesh = nullptr;
  double size_m = 1.0;
  SurfaceSearch::Near near{};
  SurfaceSearch::Nearest best{};
  bool is_found = false;
};

/// Of a query in the scaled frame: with a margin for single precision.
float radius_of(double distance_m, double size_m) {
  constexpr double kSinglePrecision = 1e-6;
  return static_cast<float>(distance_m / size_m * (1.0 + kSinglePrecision) + kSinglePrecision);
}

bool faces(const std::array<glm::dvec3, 3>& corners_m, const glm::dvec3& outward) {
  if (outward == glm::dvec3(0.0)) return true;
  const glm::dvec3 front = glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
  return glm::dot(front, outward) > -0.5 * glm::length(front) * glm::length(outward);
}

bool consider(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<NearestSearch*>(arguments->userPtr);
  const auto& triangle = search.mesh->triangles[arguments->primID];
  std::array<glm::dvec3, 3> corners_m{};
  for (std::size_t i = 0; i < 3; ++i) corners_m[i] = search.mesh->vertices_m[triangle[i]];
  const glm::dvec3& point_m = search.near.point_m;
  const glm::dvec3 b = nearest_in_triangle(corners_m, point_m);
  const double distance_m =
      glm::length(b.x * corners_m[0] + b.y * corners_m[1] + b.z * corners_m[2] - point_m);
  // Of equally near triangles the one with the smallest index is used, independent of the order of traversal.
  if (distance_m > search.best.distance_m ||
      (search.is_found && distance_m == search.best.distance_m &&
       arguments->primID >= search.best.triangle) ||
      !faces(corners_m, search.near.outward)) {
    return false;
  }
  search.best = {distance_m, arguments->primID, b};
  search.is_found = true;
  arguments->query->radius = radius_of(distance_m, search.size_m);
  return true;
}

}  // namespace

SurfaceSearch::SurfaceSearch(const TriangleMesh& mesh) : scene_(std::make_unique<Scene>(mesh)) {}

SurfaceSearch::~SurfaceSearch() = default;

std::optional<SurfaceSearch::Hit> SurfaceSearch::first_front(const Ray& ray) const {
  const glm::dvec3 origin = scene_->scaled(ray.origin_m);
  const glm::dvec3 direction = ray.direction / scene_->size_m;
  RTCRayHit hit{};
  hit.ray.org_x = static_cast<float>(origin.x);
  hit.ray.org_y = static_cast<float>(origin.y);
  hit.ray.org_z = static_cast<float>(origin.z);
  hit.ray.dir_x = static_cast<float>(direction.x);
  hit.ray.dir_y = static_cast<float>(direction.y);
  hit.ray.dir_z = static_cast<float>(direction.z);
  hit.ray.mask = ~0U;
  hit.ray.tnear = 0.0F;
  // A ray that has to pass through more sheets is far from the surface that is searched.
  constexpr int kMostSheets = 16;
  for (int sheet = 0; sheet < kMostSheets; ++sheet) {
    hit.ray.tfar = static_cast<float>(ray.reach);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    find_first_hit(scene_->scene, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const auto corners_m = scene_->corners_m(hit.hit.primID);
    const glm::dvec3 front = glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
    if (glm::dot(front, ray.outward) > 0.0) {
      return Hit{static_cast<double>(hit.ray.tfar), hit.hit.primID};
    }
    hit.ray.tnear = std::nextafter(hit.ray.tfar, std::numeric_limits<float>::max());
  }
  return {};
}

SurfaceSearch::Nearest SurfaceSearch::nearest(const glm::dvec3& point_m) const {
  return nearest(Near{.point_m = point_m})
      .value_or(Nearest{std::numeric_limits<double>::infinity(), 0, {}});
}

std::optional<SurfaceSearch::Nearest> SurfaceSearch::nearest(const Near& near) const {
  const glm::dvec3 point = scene_->scaled(near.point_m);
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x);
  query.y = static_cast<float>(point.y);
  query.z = static_cast<float>(point.z);
  query.radius = radius_of(near.within_m, scene_->size_m);
  RTCPointQueryContext context{};
  rtcInitPointQueryContext(&context);
  NearestSearch search{&scene_->mesh, scene_->size_m, near, {near.within_m, 0, {}}};
  rtcPointQuery(scene_->scene, &query, &context, &consider, &search);
  if (!search.is_found) return {};
  return search.best;
}

glm::dvec3 nearest_in_triangle(const std::array<glm::dvec3, 3>& corners_m,
                               const glm::dvec3& point_m) noexcept {
  const glm::dvec3 ab_m = corners_m[1] - corners_m[0];
  const glm::dvec3 ac_m = corners_m[2] - corners_m[0];
  const glm::dvec3 ap_m = point_m - corners_m[0];
  const double bb = glm::dot(ab_m, ab_m);
  const double bc = glm::dot(ab_m, ac_m);
  const double cc = glm::dot(ac_m, ac_m);
  const double pb = glm::dot(ap_m, ab_m);
  const double pc = glm::dot(ap_m, ac_m);
  const double determinant = bb * cc - bc * bc;
  if (determinant > 0.0) {
    const double b = (cc * pb - bc * pc) / determinant;
    const double c = (bb * pc - bc * pb) / determinant;
    if (b >= 0.0 && c >= 0.0 && b + c <= 1.0) return {1.0 - b - c, b, c};
  }
  // Outside, or zero area: the nearest point of the three sides.
  glm::dvec3 best{1.0, 0.0, 0.0};
  double best_m2 = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 3; ++side) {
    const int next = (side + 1) % 3;
    const glm::dvec3& from_m = corners_m[static_cast<std::size_t>(side)];
    const glm::dvec3 along_m = corners_m[static_cast<std::size_t>(next)] - from_m;
    const double squared_m2 = glm::dot(along_m, along_m);
    const double part = squared_m2 > 0.0
                            ? glm::clamp(glm::dot(point_m - from_m, along_m) / squared_m2, 0.0, 1.0)
                            : 0.0;
    const glm::dvec3 apart_m = from_m + part * along_m - point_m;
    const double distance_m2 = glm::dot(apart_m, apart_m);
    if (distance_m2 < best_m2) {
      best_m2 = distance_m2;
      best = glm::dvec3{0.0};
      best[side] = 1.0 - part;
      best[next] = part;
    }
  }
  return best;
}

}  // namespace asperity
