// Declares the proxy: the point of a body's surface that belongs to a probe above it or in it.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "renderers/proxy/body_surface.h"

namespace asperity {

/// The place of a probe relative to a body.
struct ProxyPlace {
  glm::dvec3 point_m{0.0};  ///< of the surface
  glm::dvec3 normal{0.0};   ///< of the surface there, unit length, outward
  double height_m = 0.0;    ///< of the probe above the surface; negative inside the body
};

/// Follows a probe along the surface of a body, in contact and near it.
///
/// Model: the proxy is the point x of the surface whose interpolated normal n passes through the probe p,
///
///   p = x + w·n,   x = Σ bᵢ pᵢ,   n = Σ bᵢ nᵢ
///
/// with the barycentric coordinates bᵢ of a facet, its corners pᵢ and their normals nᵢ [Panozzo 2013]. For a facet this is
/// a cubic in w. Unlike the nearest point, x does not jump or halt where p passes an edge of a facet: on an edge both
/// facets give the same x, w and n. The height is ± the distance of p from this facet, by the sign of w, so that it does not
/// exceed the distance of the surface by more than the facets are inclined to each other. It has a step at an edge, whose
/// measured size docs/meshes.md states.
///
/// From tick to tick the proxy walks over neighbouring facets. It is the constrained point of a god-object [Zilles 1995] in
/// this sense: it moves only along the surface, so that a probe that is pressed through a thin wall is still pushed
/// back to the side from which it came. Where no facet near the last one has such a point (deeper behind a sharp edge
/// than the facets beside it are wide), the proxy descends to the nearest point of the surface, over facets of
/// decreasing distance. There is no constraint that remains from an earlier tick, so that the proxy does not stick in
/// a concave corner.
///
/// A probe beyond `kReach_m` has no place. The search there is repeated only after the probe has moved by the distance that
/// was free.
///
/// Gaps: where p moves so far in a tick that the nearest point is more than 64 facets away, and where it moves by more than
/// `kLongestMove_m`, the proxy is found anew with the search tree, without the constraint to the side from which it came.
/// A probe that has left the body in a gap of its path therefore has a height above the surface that it is next to.
///
/// Bounds: the walk is accepted if the size of the height grows by at most 2·|Δp| + 1 µm in a tick in which p moves by |Δp|.
/// A tick visits at most 64 facets on the walk and about as many on the descent, and searches the tree at most once.
///
/// Units and frame: metres, in the body's own frame.
///
/// Real-time: `follow` and `reset` do not allocate, lock or throw.
///
/// [Zilles 1995] Zilles, Salisbury: A constraint-based god-object method for haptic display.
/// [Panozzo 2013] Panozzo et al.: Weighted averages on surfaces.
class SurfaceProxy final {
 public:
  /// Within this distance outside a body the probe has a place: a texture may rise this high above the body.
  static constexpr double kReach_m = 0.010;

  /// A probe that moves farther than this in a tick (5 m/s at 1 kHz) is found anew.
  static constexpr double kLongestMove_m = 0.005;

  explicit SurfaceProxy(std::shared_ptr<const BodySurface> surface);

  void reset() noexcept;
  /// The place of a probe; nullopt beyond the reach.
  std::optional<ProxyPlace> follow(const glm::dvec3& probe_m) noexcept;

 private:
  /// A facet with the point of it that belongs to the probe.
  struct Found {
    std::uint32_t facet = 0;
    glm::dvec3 barycentric{0.0};
    double height_m = 0.0;
  };

  struct Searched {
    Found found{};
    double distance_m = 0.0;  ///< from the nearest point of the surface
  };

  std::optional<Found> walk(const glm::dvec3& probe_m, std::uint32_t from) const noexcept;
  /// nullopt where the nearest point is farther away than a tick may descend.
  std::optional<Found> descend(const glm::dvec3& probe_m, std::uint32_t from) const noexcept;
  Searched search(const glm::dvec3& probe_m) const noexcept;
  double height_m(const glm::dvec3& probe_m, std::uint32_t facet,
                  const glm::dvec3& nearest) const noexcept;

  std::shared_ptr<const BodySurface> surface_;
  std::optional<Found> last_{};
  glm::dvec3 last_probe_m_{0.0};
  glm::dvec3 clear_of_m_{0.0};  ///< without a place: the centre of a ball without one,
  double clear_m_ = 0.0;        ///< and its radius
};

}  // namespace asperity
