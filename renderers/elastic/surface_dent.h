// Declares the depth to which a soft surface is displaced, for pictures of it.

#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "renderers/elastic/cell_field.h"

namespace asperity {

/// The displacement of a surface into the body. Units and frame: metres, in that of ProbeState.
struct SurfaceDent {
  glm::dvec2 centre_m{0.0};  ///< of the window
  double cell_m = 0.0;
  CellField depth_m{};
  double far_m2 = 0.0;  ///< depth times distance, far from the window

  /// Bilinear between cells. Outside the window, along a line from the centre: far_m2/r + c/r³, with c from the depth at the
  /// border. These are the first two terms of the displacement of a half-space around a symmetric load; for a flat end they
  /// are 5 % too large at twice its radius.
  double depth_at(const glm::dvec2& at_m) const noexcept;
};

/// Implemented by a renderer (ForceRenderer) of a soft surface.
class DentsSurface {
 public:
  virtual ~DentsSurface() = default;
  DentsSurface(const DentsSurface&) = delete;
  DentsSurface& operator=(const DentsSurface&) = delete;

  /// After the last tick, the dents of earlier loads included; nullopt if the surface is as without a tip. The thread that
  /// calls `tick`.
  virtual std::optional<SurfaceDent> dent() const = 0;

 protected:
  DentsSurface() = default;
};

}  // namespace asperity
