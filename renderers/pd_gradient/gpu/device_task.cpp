// Lays out tasks and answers as the kernels expect, and computes depth and gradient from an answer.

#include "renderers/pd_gradient/gpu/device_task.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "renderers/pd_gradient/sampling/moved_poses.h"

namespace asperity {
namespace {

constexpr std::size_t kHere = 1;   // A's surface at its pose
constexpr std::size_t kMoved = 2;  // the first of the others

static_assert(kDeviceSurfaces == kMoved + kMovedPoses);
static_assert(sizeof(DeviceTask) == 8 * (12 + 12 * kDeviceSurfaces + 5) + 4 * 8);
static_assert(sizeof(DeviceAnswer) == 8 * (kDeviceSurfaces + 1 + 2 * (1 + kDeviceRates)) + 4 * 4);
static_assert(sizeof(DeviceCorner) == 8 * 8 + 4 * 2);

std::array<double, 12> columns_of(const Pose& pose) {
  const glm::dmat3& r = pose.rotation;
  const glm::dvec3& p = pose.position_m;
  return {r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z, p.x, p.y, p.z};
}

void set_gradient(const DeviceAnswer& answer, const DifferenceSteps& steps, Penetration& result) {
  std::array<std::optional<double>, kMovedPoses> moved_m{};
  for (std::size_t i = 0; i < kMovedPoses; ++i) {
    const double depth_m = answer.depth_m[kMoved + i];
    if (!std::isnan(depth_m)) moved_m[i] = depth_m;
  }
  set_gradient(answer.depth_m[kHere], moved_m, steps, result);
}

void set_gradient(const DeviceAnswer& answer, const SmoothMaximum& law, Penetration& result) {
  const auto& sums = answer.sums;
  const double sunk = sums[1] / sums[0];  // (δ − here)/τ
  std::array<double, kDeviceRates> rates{};
  for (std::size_t q = 0; q < kDeviceRates; ++q) {
    // δ decreases where A rises.
    rates[q] = -((1.0 - sunk) * sums[2 + q] + sums[2 + kDeviceRates + q]) / sums[0];
  }
  result.depth_m += law.tau_m * sunk;
  result.slope = {rates[0], rates[1]};
  result.lever_m = {rates[2], rates[3], rates[4]};
}

}  // namespace

DeviceTask device_task_of(const GpuContact& contact) {
  const ContactFrame& frame = contact.frame;
  DeviceTask task{
      .frame = {frame.origin_m.x, frame.origin_m.y, frame.origin_m.z, frame.u.x, frame.u.y,
                frame.u.z, frame.v.x, frame.v.y, frame.v.z, frame.n.x, frame.n.y, frame.n.z},
      .spacing_m = contact.grid.spacing_m(),
      .width_m = contact.grid.width_m,
      .leaning = {contact.leaning_b, contact.leaning_a},
      .samples = contact.grid.samples};
  task.poses[0] = columns_of(contact.pose_b);
  task.poses[kHere] = columns_of(contact.pose_a);
  if (const auto* smooth = std::get_if<SmoothMaximum>(&contact.law)) {
    task.tau_m = smooth->tau_m;
    task.used_surfaces = kMoved;
    return task;
  }
  task.used_surfaces = kDeviceSurfaces;
  const auto& hard = std::get<HardMaximum>(contact.law);
  const std::array<Pose, kMovedPoses> moved =
      moved_poses(contact.pose_a, frame, difference_steps(contact.grid, hard.step_m));
  std::transform(moved.begin(), moved.end(), task.poses.begin() + kMoved, columns_of);
  return task;
}

std::optional<Penetration> penetration_of(const DeviceAnswer& answer, const GpuContact& contact) {
  if (answer.covered == 0) return std::nullopt;
  const SamplingGrid& grid = contact.grid;
  const int row = answer.sample / grid.samples;
  const int column = answer.sample % grid.samples;
  Penetration result{.depth_m = answer.depth_m[kHere],
                     .deepest_m = {grid.place_m(column), grid.place_m(row), answer.height_m},
                     .covered = answer.covered,
                     .folded = answer.folded,
                     .at_border = answer.at_border != 0,
                     .at_window = grid.is_outermost(row, column)};
  if (const auto* hard = std::get_if<HardMaximum>(&contact.law)) {
    set_gradient(answer, difference_steps(grid, hard->step_m), result);
  } else {
    set_gradient(answer, std::get<SmoothMaximum>(contact.law), result);
  }
  return result;
}

std::vector<DeviceCorner> corners_of(const TexturedMesh& mesh) {
  std::vector<DeviceCorner> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      const glm::dvec3& p = mesh.vertices_m[vertex];
      const glm::dvec3& n = mesh.normals[vertex];
      const glm::dvec2& place = mesh.places[i][k];
      corners.push_back({.point_m = {p.x, p.y, p.z},
                         .normal = {n.x, n.y, n.z},
                         .place = {place.x, place.y},
                         .vertex = static_cast<std::int32_t>(vertex)});
    }
  }
  return corners;
}

}  // namespace asperity
