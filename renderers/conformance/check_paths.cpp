// Derives the height of contact and the depth of a path from what the model needs.

#include "renderers/conformance/check_paths.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity {
namespace {

// Deeper than any texture at its defaults, so that a stroke stays in contact.
constexpr double kDepth_m = 0.002;

/// The height of the probe above the plane at which the contact begins.
double contact_height_m(const ForceModel& model) {
  // The frame of the ball has its origin at its centre, and the plate has crests.
  return model.declaration.needs_bodies ? 0.5 * kConformanceBall_m + kConformanceGratingAmplitude_m
                                        : 0.0;
}

double depth_m(const ForceModel& model) {
  return model.declaration.needs_bodies ? kConformanceGratingAmplitude_m : kDepth_m;
}

}  // namespace

std::vector<ProbeState> stroke(const ForceModel& model, double duration_s, double rate_Hz) {
  std::vector<ProbeState> path(static_cast<std::size_t>(std::lround(duration_s * rate_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / rate_Hz;
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m = {kConformanceSpeed_m_per_s * time_s - 0.02, 0.0,
                          contact_height_m(model) - depth_m(model)};
    path[i].velocity_m_per_s = {kConformanceSpeed_m_per_s, 0.0, 0.0};
  }
  return path;
}

std::vector<ProbeState> wandering(const ForceModel& model, double duration_s) {
  constexpr double kAcross_rad_per_s = 2.0 * std::numbers::pi * 5.0;
  constexpr double kDown_rad_per_s = 2.0 * std::numbers::pi * 1.7;
  constexpr double kHalf_m = 0.03;
  std::vector<ProbeState> path(
      static_cast<std::size_t>(std::lround(duration_s * kConformanceRate_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / kConformanceRate_Hz;
    const double across_rad = kAcross_rad_per_s * time_s;
    const double down_rad = kDown_rad_per_s * time_s;
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m = {kHalf_m * std::sin(across_rad), 0.3 * kHalf_m * std::sin(down_rad),
                          contact_height_m(model) + depth_m(model) * std::cos(down_rad)};
    path[i].velocity_m_per_s = {kHalf_m * kAcross_rad_per_s * std::cos(across_rad),
                                0.3 * kHalf_m * kDown_rad_per_s * std::cos(down_rad),
                                -depth_m(model) * kDown_rad_per_s * std::sin(down_rad)};
  }
  return path;
}

std::vector<ProbeState> around_sphere(double duration_s) {
  constexpr double kAround_rad_per_s = 2.0 * std::numbers::pi * 3.0;
  constexpr double kDown_rad_per_s = 2.0 * std::numbers::pi * 8.0;
  constexpr double kTilt_rad_per_s = 2.0 * std::numbers::pi * 0.7;
  constexpr double kDeepest_m = 0.001;
  std::vector<ProbeState> path(
      static_cast<std::size_t>(std::lround(duration_s * kConformanceRate_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / kConformanceRate_Hz;
    const double around_rad = kAround_rad_per_s * time_s;
    const double tilt_rad = kTilt_rad_per_s * time_s;
    const glm::dvec3 outward{std::sin(around_rad) * std::cos(tilt_rad),
                             std::sin(around_rad) * std::sin(tilt_rad), std::cos(around_rad)};
    const double radius_m =
        0.5 * kConformanceSphere_m + kDeepest_m * std::cos(kDown_rad_per_s * time_s);
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m = radius_m * outward;
    if (i > 0) {
      path[i].velocity_m_per_s =
          kConformanceRate_Hz * (path[i].position_m - path[i - 1].position_m);
    }
  }
  return path;
}

}  // namespace asperity
