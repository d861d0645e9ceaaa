// Declares the proxy: the point of a body's surface that belongs to a probe above it or in it.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/surface_search.h"

namespace asperity {

/// The place of a probe relative to a body.
struct ProxyPlace {
  glm::dvec3 point_m{0.0};  ///< of the surface
  glm::dvec3 normal{0.0};   ///< of the surface there, unit length, outward
  double height_m = 0.0;    ///< of the probe above the surface; negative inside the body
};

/// Follows a probe along the surface of a body, in contact and near it.
///
/// Model: the height of the probe p is ± its distance from the nearest point y of the facets. Place and normal are those of the
/// point x near y whose interpolated normal n passes through p,
///
///   p = x + w·n,   x = Σ bᵢ pᵢ,   n = Σ bᵢ nᵢ
///
/// with the barycentric coordinates bᵢ of a facet, its corners pᵢ and their normals nᵢ [Panozzo 2013]. For a facet this is
/// a cubic in w. Unlike y, x does not jump or halt where p passes an edge of a facet: on an edge both facets give the same
/// x, w and n. The distance from y has no step there, because the two facets are equally far away where y jumps from one to
/// the other. The distance |p − x| is not used: it exceeds the depth at a sharp edge, up to √2 times at one of 90°.
///
/// Outside the body, y is the nearest point of the whole surface. Inside it is followed from tick to tick as the constrained
/// point of a god-object [Zilles 1995]: it moves only along the surface, to nearer facets around it, so that a probe that is
/// pressed through a thin wall is still pushed back to the side from which it came. It passes a crease of more than 60° only
/// when it has come to its edge. There is no other constraint from an earlier tick, so that the proxy does not stick in a
/// concave corner.
///
/// Steps: while y is followed, the height changes by no more than p moves, except where y slides off an edge to a nearer side:
/// the height then decreases at once. Where p passes a place that is equally far from separate parts of the surface (the
/// medial axis: between the walls of a groove, or in a body behind an edge), place and normal change at once.
/// They also do where no facet near y has a point x (deeper behind an edge than the facets beside it are wide), and x is y.
///
/// A probe beyond `kReach_m` has no place. The search there is repeated only after the probe has moved by the distance that
/// was free.
///
/// Gaps: where p moves by more than `kLongestMove_m` in a tick, y is found anew as the nearest point of the whole surface,
/// without the constraint to the side from which p came. Where it moves less, but over more facets than a tick visits, y is
/// the nearest point of all facets that are inclined to the last one by less than 120°: not the other side of a wall. A probe
/// that has left the body in a gap of its path therefore has a height above the surface that it is next to.
///
/// Bounds: a tick visits at most 1024 facets to find y and 128 to find x, and searches the tree at most twice.
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
  /// A place on the surface.
  struct OnFacet {
    std::uint32_t facet = 0;
    glm::dvec3 barycentric{0.0};
  };
  /// The state after a tick in which the probe had a place.
  struct Last {
    SurfaceSearch::Nearest nearest{};  ///< y
    std::uint32_t facet = 0;           ///< of x; before a walk, that of the tick before
    double height_m = 0.0;
    glm::dvec3 probe_m{0.0};
  };

  SurfaceSearch::Nearest next_nearest(const glm::dvec3& probe_m) const noexcept;
  /// nullopt where the nearest point is farther away than a tick may descend.
  std::optional<SurfaceSearch::Nearest> descend(const glm::dvec3& probe_m) const noexcept;
  /// The point whose normal passes through the probe, on the same side and not much farther away than the nearest
  /// point; the nearest point where there is none.
  OnFacet walk(const glm::dvec3& probe_m) const noexcept;
  std::optional<OnFacet> walk_from(std::uint32_t facet, const glm::dvec3& probe_m) const noexcept;

  std::shared_ptr<const BodySurface> surface_;
  std::optional<Last> last_{};
  glm::dvec3 clear_of_m_{0.0};  ///< without a place: the centre of a ball without one,
  double clear_m_ = 0.0;        ///< and its radius
};

}  // namespace asperity
