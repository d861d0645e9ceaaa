// Declares a point model on the surface of a body.

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "renderers/force/force_model.h"
#include "renderers/force/surface_contact.h"
#include "renderers/proxy/surface_proxy.h"

namespace asperity {

/// Renders a model of a point on a plane on the surface of a body. The model itself is unchanged.
///
/// Model: at the place of the proxy (surface_proxy.h) the model computes its force as on a plane that touches the body
/// there: the height of the probe above this plane is its height above the body, x and y are texture coordinates, and
/// the velocity is that of the probe in the axes of the plane. The force is rotated back into the frame of the device.
///
/// Texture coordinates: for each axis of the body's frame there is a chart, the projection along it. Their coordinates,
/// in metres, with the normal towards +axis and towards −axis:
///
///   z: (x, y), (−x, y)     y: (−x, z), (x, z)     x: (y, z), (−y, z)
///
/// so that a texture on a side has z upwards, and on a level upper side is that of the plane. The chart of the axis k has
/// the weight s(1 + (|n_k| − max|n|)/0.15)/Σ with s(u) = u²(3 − 2u) on [0, 1], and the force is the weighted mean over the
/// charts: at a seam between two charts there is no step, and textures blend where the normal is within 6° of the
/// bisector of two axes.
///
/// The axes of the plane are those of the chart, turned by the smallest rotation that turns the chart's axis to n.
///
/// Error: on a surface inclined by θ to a chart, lengths of the texture are longer by the factor 1/cos θ down the slope and
/// unchanged across it: exact on the sides of a box, 4 % at 15°, 15 % at 30°, 29 % where the blend with another chart begins (49 %
/// with two others). A force along
/// the surface that a model computes from slopes is steeper than that of the stretched texture by this factor. A force that
/// is a gradient on a plane is one on a body only where the surface is level in its chart.
///
/// Friction continues from chart to chart; all other states of a model (its path, its noise) begin anew in a chart. Border
/// of the patch: as SurfaceContact, in the device's frame.
///
/// A tip with a size (ForceRenderer::tip) has one contact, whose relief is the weighted mean of the charts' reliefs
/// (tip_on_charts.h), so that it is computed once in a tick and its loads and dents stay where charts blend. Its axes are those of
/// the chart in which the probe comes near the body, and are carried along the way of the proxy: in every tick by the smallest
/// rotation from the last normal to the present one, which does not turn the dent on the surface.
///
/// Units and frame: as ForceRenderer; the origin of the body's frame is `inputs.patch.centre_m`, its axes are the device's.
///
/// Errors: std::invalid_argument for a texture that rises more than SurfaceProxy::kReach_m above the body, for a model that
/// computes no finite force there, and in the cases of the model. The height is examined at the highest and at the lowest
/// sample of the height field and at 4096 scattered places.
///
/// Real-time: as ForceRenderer.
class PointOnBody final : public ForceRenderer {
 public:
  /// `inputs` with a body and with complete parameters.
  PointOnBody(const ForceModel& model, const RendererInputs& inputs);

  void reset(const ProbeState& first) noexcept override;
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override;
  /// The sums over the renderers of the charts: a tick in which charts of a point blend can count more than once.
  std::span<const NamedCount> limits() const noexcept override { return counts_; }
  /// That of the first chart that has one.
  std::string_view error() const noexcept override;

 private:
  /// A right-handed frame that touches the body: axes along the texture, and the normal.
  struct Tangents {
    glm::dvec3 x{1.0, 0.0, 0.0};
    glm::dvec3 y{0.0, 1.0, 0.0};
    glm::dvec2 texture_m{0.0};  ///< the coordinates of the place
  };
  struct Chart {
    double weight = 0.0;  ///< in the last tick
    Tangents tangents{};  ///< in this tick
  };
  /// The frame of the contact of a tip; `axes.texture_m` is the way of the proxy in it.
  struct CarriedFrame {
    Tangents axes{};
    glm::dvec3 normal{0.0};
    glm::dvec3 point_m{0.0};
  };

  static Tangents tangents_of(int axis, const ProxyPlace& place) noexcept;
  /// A vector in one frame, in the other one.
  static glm::dmat2 turn_between(const Tangents& from, const Tangents& to) noexcept;
  /// The probe in the axes of a frame, and a force in them in the frame of the device.
  static ProbeState in_frame(const ProbeState& probe, const Tangents& axes,
                             const ProxyPlace& place) noexcept;
  static glm::dvec3 of_device(const glm::dvec3& force_N, const Tangents& axes,
                              const ProxyPlace& place) noexcept;
  /// Resets a chart's renderer at a place and continues the friction of the chart with the greatest weight.
  void enter(std::size_t axis, const ProxyPlace& place, const ProbeState& local) noexcept;
  /// With the weights of the charts; the penetration and the force in the frame of the device.
  RenderedTick points(const ProbeState& probe, const ProxyPlace& place,
                      const std::array<double, 3>& weights, double dt_s) noexcept;
  RenderedTick tip(const ProbeState& probe, const ProxyPlace& place,
                   const std::array<double, 3>& weights, double dt_s) noexcept;
  /// Whether the frame continues that of the last tick.
  bool carry_frame(const ProxyPlace& place, const Tangents& first) noexcept;
  void count_limits() noexcept;
  RenderedTick no_contact() noexcept;

  SurfaceContact border_;
  SurfaceProxy proxy_;
  std::vector<std::unique_ptr<ForceRenderer>>
      renderers_{};  ///< one for each chart, or that of a tip
  std::array<Chart, 3> charts_{};
  std::optional<CarriedFrame> tip_frame_{};  ///< empty while a tip is beyond the reach of the proxy
  std::vector<NamedCount> counts_{};         ///< of a constant size, that of the model
};

}  // namespace asperity
