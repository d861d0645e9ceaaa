// Implements the walk of a proxy over the facets of a body.

#include "renderers/proxy/surface_proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "stimuli/meshes/mesh_edges.h"

namespace asperity {
namespace {

using Nearest = SurfaceSearch::Nearest;

constexpr int kMostFacets = 64;  // on a walk: it takes one or two
constexpr int kMostNeighbours =
    1024;  // on a descent: some 50 facets, as beside the edge of a box at 0.2 m/s
constexpr int kMostNewtonSteps = 12;   // from the plane of the facet it takes three or four
constexpr double kOnEdge = 1e-9;       // of barycentric coordinates
constexpr double kOnSurface_m = 1e-9;  // has no side
constexpr double kFarthest = 2.0;  // distance of the proxy from the probe to that of the surface
constexpr double kCrease = 0.5;    // cosine of the angle between facets

/// The place of a point in the prism over a facet.
struct PrismPlace {
  glm::dvec3 barycentric{0.0};
  double along_normal = 0.0;  ///< w
};

struct FacetCorners {
  std::array<glm::dvec3, 3> m{};
  std::array<glm::dvec3, 3> normal{};
};

FacetCorners corners_of(const BodySurface& surface, std::uint32_t facet) noexcept {
  FacetCorners corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t vertex = surface.corners(facet)[i];
    corners.m[i] = surface.vertex_m(vertex);
    corners.normal[i] = surface.normal(vertex);
  }
  return corners;
}

glm::dvec3 point_of(const std::array<glm::dvec3, 3>& corners,
                    const glm::dvec3& barycentric) noexcept {
  return barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2];
}

/// nullopt where the facet, moved along its normals to the height of the point, is turned over.
///
/// The moved facet has the corners pᵢ + w nᵢ; w is where its plane contains the point:
///   (E₁ × E₂)·(d − w n₀) = 0,   Eᵢ = eᵢ + w gᵢ,   d = p − p₀
std::optional<PrismPlace> place_in_prism(const FacetCorners& facet,
                                         const glm::dvec3& probe_m) noexcept {
  const glm::dvec3 e1 = facet.m[1] - facet.m[0];
  const glm::dvec3 e2 = facet.m[2] - facet.m[0];
  const glm::dvec3 g1 = facet.normal[1] - facet.normal[0];
  const glm::dvec3 g2 = facet.normal[2] - facet.normal[0];
  const glm::dvec3 d = probe_m - facet.m[0];
  const glm::dvec3& n0 = facet.normal[0];
  const glm::dvec3 c0 = glm::cross(e1, e2);
  const glm::dvec3 c1 = glm::cross(e1, g2) + glm::cross(g1, e2);
  const glm::dvec3 c2 = glm::cross(g1, g2);
  const double upright = glm::dot(c0, facet.normal[0] + facet.normal[1] + facet.normal[2]) / 3.0;
  if (!(upright > 0.0)) return {};
  double w = glm::dot(c0, d) / upright;
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    const glm::dvec3 m = c0 + w * (c1 + w * c2);
    const glm::dvec3 apart = d - w * n0;
    const double slope = glm::dot(c1 + 2.0 * w * c2, apart) - glm::dot(m, n0);
    if (!(slope < 0.0)) return {};
    const double change = glm::dot(m, apart) / slope;
    w -= change;
    if (std::abs(change) <= 1e-14) break;
  }
  const glm::dvec3 m = c0 + w * (c1 + w * c2);
  if (!(glm::dot(m, c0) > 0.0)) return {};
  const glm::dvec3 apart = d - w * n0;
  const double size = glm::dot(m, m);
  const double b1 = glm::dot(glm::cross(apart, e2 + w * g2), m) / size;
  const double b2 = glm::dot(glm::cross(e1 + w * g1, apart), m) / size;
  return PrismPlace{{1.0 - b1 - b2, b1, b2}, w};
}

std::array<glm::dvec3, 3> corners_m_of(const BodySurface& surface, std::uint32_t facet) noexcept {
  const auto& corners = surface.corners(facet);
  return {surface.vertex_m(corners[0]), surface.vertex_m(corners[1]), surface.vertex_m(corners[2])};
}

Nearest nearest_in(const BodySurface& surface, std::uint32_t facet,
                   const glm::dvec3& probe_m) noexcept {
  const std::array<glm::dvec3, 3> corners_m = corners_m_of(surface, facet);
  const glm::dvec3 b = nearest_in_triangle(corners_m, probe_m);
  return {glm::distance(point_of(corners_m, b), probe_m), facet, b};
}

/// Whether the plane of a facet, and with it the facet, is at least as far from the probe as a distance.
bool is_beyond(const BodySurface& surface, std::uint32_t facet, const glm::dvec3& probe_m,
               double distance_m) noexcept {
  const std::array<glm::dvec3, 3> corners_m = corners_m_of(surface, facet);
  const glm::dvec3 normal = glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
  const double along = glm::dot(normal, probe_m - corners_m[0]);
  return along * along > distance_m * distance_m * glm::dot(normal, normal);
}

glm::dvec3 doubled_area_m2(const BodySurface& surface, std::uint32_t facet) noexcept {
  const auto& corners = surface.corners(facet);
  const glm::dvec3& first_m = surface.vertex_m(corners[0]);
  return glm::cross(surface.vertex_m(corners[1]) - first_m, surface.vertex_m(corners[2]) - first_m);
}

glm::dvec3 normal_of(const BodySurface& surface, std::uint32_t facet) noexcept {
  const glm::dvec3 doubled_m2 = doubled_area_m2(surface, facet);
  const double size_m2 = glm::length(doubled_m2);
  return size_m2 > 0.0 ? doubled_m2 / size_m2 : glm::dvec3(0.0);
}

/// Whether a facet contains a place of one of its neighbours.
bool contains(const BodySurface& surface, std::uint32_t facet, const Nearest& place) noexcept {
  const auto& corners = surface.corners(facet);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(place.barycentric[static_cast<int>(i)] > 0.0)) continue;
    const std::uint32_t vertex = surface.corners(place.triangle)[i];
    if (std::find(corners.begin(), corners.end(), vertex) == corners.end()) return false;
  }
  return true;
}

bool has_crease(const BodySurface& surface, std::uint32_t facet, std::uint32_t other) noexcept {
  return glm::dot(normal_of(surface, facet), normal_of(surface, other)) < kCrease;
}

/// ± the distance, by the side on which the probe is of the facets that meet at the nearest point.
double height_m(const BodySurface& surface, const Nearest& nearest,
                const glm::dvec3& probe_m) noexcept {
  const FacetCorners corners = corners_of(surface, nearest.triangle);
  glm::dvec3 outward = normal_of(surface, nearest.triangle);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (nearest.barycentric[static_cast<int>(corner)] >= 1.0) {
      outward = corners.normal[corner];
      break;
    }
    if (nearest.barycentric[static_cast<int>(corner)] > 0.0) continue;
    const std::uint32_t beyond = surface.beyond(nearest.triangle, corner);
    if (beyond != kNoHalfEdge) outward += normal_of(surface, beyond);
  }
  const glm::dvec3 apart_m = probe_m - point_of(corners.m, nearest.barycentric);
  return glm::dot(apart_m, outward) < 0.0 ? -nearest.distance_m : nearest.distance_m;
}

}  // namespace

SurfaceProxy::SurfaceProxy(std::shared_ptr<const BodySurface> surface)
    : surface_(std::move(surface)) {}

void SurfaceProxy::reset() noexcept {
  last_.reset();
  clear_m_ = 0.0;
}

std::optional<ProxyPlace> SurfaceProxy::follow(const glm::dvec3& probe_m) noexcept {
  if (last_ && glm::distance(probe_m, last_->probe_m) > kLongestMove_m) reset();
  if (!last_ && clear_m_ > 0.0 && glm::distance(probe_m, clear_of_m_) < clear_m_) return {};
  const Nearest nearest = last_ ? next_nearest(probe_m) : surface_->search().nearest(probe_m);
  const double height = height_m(*surface_, nearest, probe_m);
  if (height > kReach_m) {
    const bool was_inside = last_ && last_->height_m < 0.0;
    clear_of_m_ = probe_m;
    clear_m_ = was_inside ? 0.0 : nearest.distance_m - kReach_m;
    last_.reset();
    return {};
  }
  const std::uint32_t from = last_ ? last_->facet : nearest.triangle;
  last_ = Last{.nearest = nearest, .facet = from, .height_m = height, .probe_m = probe_m};
  const OnFacet at = walk(probe_m);
  last_->facet = at.facet;
  const FacetCorners corners = corners_of(*surface_, at.facet);
  return ProxyPlace{.point_m = point_of(corners.m, at.barycentric),
                    .normal = glm::normalize(point_of(corners.normal, at.barycentric)),
                    .height_m = height};
}

Nearest SurfaceProxy::next_nearest(const glm::dvec3& probe_m) const noexcept {
  const Nearest& last = last_->nearest;
  const SurfaceSearch& search = surface_->search();
  if (last_->height_m >= 0.0) {
    const Nearest there = nearest_in(*surface_, last.triangle, probe_m);
    return search.nearest({.point_m = probe_m, .within_m = there.distance_m}).value_or(there);
  }
  if (const std::optional<Nearest> descended = descend(probe_m)) return *descended;
  const glm::dvec3 outward = normal_of(*surface_, last.triangle);
  const std::optional<Nearest> same_side = search.nearest({.point_m = probe_m, .outward = outward});
  return same_side ? *same_side : search.nearest(probe_m);
}

std::optional<Nearest> SurfaceProxy::descend(const glm::dvec3& probe_m) const noexcept {
  Nearest best = nearest_in(*surface_, last_->nearest.triangle, probe_m);
  int visited = 0;
  while (true) {
    Nearest next = best;
    for (const std::uint32_t corner : surface_->corners(best.triangle)) {
      for (const std::uint32_t facet : surface_->around(corner)) {
        if (++visited > kMostNeighbours) return {};
        if (facet == best.triangle || is_beyond(*surface_, facet, probe_m, next.distance_m))
          continue;
        const Nearest there = nearest_in(*surface_, facet, probe_m);
        if (!(there.distance_m < next.distance_m)) continue;
        if (contains(*surface_, facet, best) || !has_crease(*surface_, facet, best.triangle)) {
          next = there;
        }
      }
    }
    if (!(next.distance_m < best.distance_m)) return best;
    best = next;
  }
}

SurfaceProxy::OnFacet SurfaceProxy::walk(const glm::dvec3& probe_m) const noexcept {
  const Nearest& nearest = last_->nearest;
  if (const auto there = walk_from(nearest.triangle, probe_m)) return *there;
  // Beside a sharp edge the walk from y may turn in a circle.
  if (const auto there = walk_from(last_->facet, probe_m)) return *there;
  return {.facet = nearest.triangle, .barycentric = nearest.barycentric};
}

std::optional<SurfaceProxy::OnFacet> SurfaceProxy::walk_from(
    std::uint32_t facet, const glm::dvec3& probe_m) const noexcept {
  const double distance_m = last_->nearest.distance_m;
  for (int visited = 0; visited < kMostFacets; ++visited) {
    const FacetCorners corners = corners_of(*surface_, facet);
    const std::optional<PrismPlace> place = place_in_prism(corners, probe_m);
    if (!place) return {};
    const glm::dvec3& b = place->barycentric;
    const std::size_t least = b.x <= b.y && b.x <= b.z ? 0 : b.y <= b.z ? 1 : 2;
    if (b[static_cast<int>(least)] >= -kOnEdge) {
      const bool is_near = std::abs(place->along_normal) <= kFarthest * distance_m + kOnSurface_m;
      const bool is_on_its_side =
          distance_m <= kOnSurface_m || (place->along_normal < 0.0) == (last_->height_m < 0.0);
      if (!is_near || !is_on_its_side) return {};
      return OnFacet{.facet = facet, .barycentric = b};
    }
    facet = surface_->beyond(facet, least);
    if (facet == kNoHalfEdge) return {};
  }
  return {};
}

}  // namespace asperity
