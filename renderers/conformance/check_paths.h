// The paths of a probe on which force models are checked.

#pragma once

#include <vector>

#include "renderers/force/force_model.h"

namespace asperity {

inline constexpr double kConformanceRate_Hz = 1000.0;  ///< of the servo loop
inline constexpr double kConformanceSpeed_m_per_s = 0.04;
inline constexpr double kConformanceGratingAmplitude_m = 1e-4;
inline constexpr double kConformanceBall_m = 0.002;   ///< the tool of a model with two bodies
inline constexpr double kConformanceSphere_m = 0.02;  ///< the body of a point model

/// Along +x at a constant depth.
std::vector<ProbeState> stroke(const ForceModel& model, double duration_s, double rate_Hz);

/// To and fro over 60 mm at up to 0.94 m/s, into and out of contact.
std::vector<ProbeState> wandering(const ForceModel& model, double duration_s);

/// Around a sphere of kConformanceSphere_m about the origin, at 0.19 m/s, from 1 mm above its surface to 1 mm in it, so that every
/// projection of the texture comes into use during contact and between contacts.
std::vector<ProbeState> around_sphere(double duration_s);

}  // namespace asperity
