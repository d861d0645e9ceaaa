// Implements the walk of a proxy over the facets of a body.

#include "renderers/proxy/surface_proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "stimuli/meshes/mesh_edges.h"

namespace asperity {
namespace {

constexpr int kMostFacets = 64;       // 0.2 m/s cross about six facets of 0.2 mm in 1 ms
constexpr int kMostNewtonSteps = 12;  // from the plane of the facet it takes three or four
constexpr double kOnEdge = 1e-9;      // of barycentric coordinates
constexpr double kSlack_m = 1e-6;
constexpr double kInclined = 1.05;  // distance of the facet of a proxy to that of the nearest facet

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

double distance_m(const FacetCorners& corners, const glm::dvec3& nearest,
                  const glm::dvec3& probe_m) noexcept {
  return glm::distance(point_of(corners.m, nearest), probe_m);
}

}  // namespace

SurfaceProxy::SurfaceProxy(std::shared_ptr<const BodySurface> surface)
    : surface_(std::move(surface)) {}

void SurfaceProxy::reset() noexcept {
  last_.reset();
  clear_m_ = 0.0;
}

std::optional<ProxyPlace> SurfaceProxy::follow(const glm::dvec3& probe_m) noexcept {
  if (last_ && glm::distance(probe_m, last_probe_m_) > kLongestMove_m) reset();
  Found found{};
  if (last_) {
    const double farthest_m =
        std::abs(last_->height_m) + 2.0 * glm::distance(probe_m, last_probe_m_) + kSlack_m;
    const std::optional<Found> walked = walk(probe_m, last_->facet);
    if (walked && std::abs(walked->height_m) <= farthest_m) {
      found = *walked;
    } else {
      const std::optional<Found> descended = descend(probe_m, last_->facet);
      found = descended ? *descended : search(probe_m).found;
    }
  } else {
    if (clear_m_ > 0.0 && glm::distance(probe_m, clear_of_m_) < clear_m_) return {};
    const Searched searched = search(probe_m);
    found = searched.found;
    clear_of_m_ = probe_m;
    clear_m_ = searched.distance_m - kReach_m;
  }
  if (found.height_m > kReach_m) {
    if (last_) clear_m_ = 0.0;
    last_.reset();
    return {};
  }
  last_ = found;
  last_probe_m_ = probe_m;
  const FacetCorners corners = corners_of(*surface_, found.facet);
  return ProxyPlace{.point_m = point_of(corners.m, found.barycentric),
                    .normal = glm::normalize(point_of(corners.normal, found.barycentric)),
                    .height_m = found.height_m};
}

std::optional<SurfaceProxy::Found> SurfaceProxy::walk(const glm::dvec3& probe_m,
                                                      std::uint32_t from) const noexcept {
  std::uint32_t facet = from;
  for (int visited = 0; visited < kMostFacets; ++visited) {
    const FacetCorners corners = corners_of(*surface_, facet);
    const std::optional<PrismPlace> place = place_in_prism(corners, probe_m);
    if (!place) return {};
    const glm::dvec3& b = place->barycentric;
    const std::size_t least = b.x <= b.y && b.x <= b.z ? 0 : b.y <= b.z ? 1 : 2;
    if (b[static_cast<int>(least)] >= -kOnEdge) {
      const double apart_m = distance_m(corners, nearest_in_triangle(corners.m, probe_m), probe_m);
      return Found{.facet = facet,
                   .barycentric = b,
                   .height_m = place->along_normal < 0.0 ? -apart_m : apart_m};
    }
    facet = surface_->beyond(facet, least);
    if (facet == kNoHalfEdge) return {};
  }
  return {};
}

std::optional<SurfaceProxy::Found> SurfaceProxy::descend(const glm::dvec3& probe_m,
                                                         std::uint32_t from) const noexcept {
  struct Nearest {
    std::uint32_t facet = 0;
    glm::dvec3 barycentric{0.0};
    double distance_m = 0.0;
  };
  const auto nearest_in = [&](std::uint32_t facet) {
    const FacetCorners corners = corners_of(*surface_, facet);
    const glm::dvec3 b = nearest_in_triangle(corners.m, probe_m);
    return Nearest{facet, b, distance_m(corners, b, probe_m)};
  };
  Nearest best = nearest_in(from);
  int visited = 1;
  for (bool nearer = true; nearer;) {
    if (visited >= kMostFacets) return {};
    Nearest next = best;
    const auto consider = [&](std::uint32_t facet) {
      ++visited;
      const Nearest there = nearest_in(facet);
      if (there.distance_m < next.distance_m) next = there;
    };
    // On a side: the facet beyond it. In a corner: all facets around it.
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (best.barycentric[static_cast<int>(corner)] > 0.0) continue;
      const std::uint32_t beyond = surface_->beyond(best.facet, corner);
      if (beyond != kNoHalfEdge) consider(beyond);
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (best.barycentric[static_cast<int>(corner)] < 1.0) continue;
      const std::uint32_t vertex = surface_->corners(best.facet)[corner];
      std::uint32_t facet = surface_->beyond(best.facet, (corner + 2) % 3);
      while (facet != kNoHalfEdge && facet != best.facet) {
        if (visited >= kMostFacets) return {};
        consider(facet);
        const auto& corners = surface_->corners(facet);
        const std::size_t at = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
        facet = surface_->beyond(facet, (at + 2) % 3);
      }
    }
    nearer = next.distance_m < best.distance_m;
    best = next;
  }
  return Found{.facet = best.facet,
               .barycentric = best.barycentric,
               .height_m = height_m(probe_m, best.facet, best.barycentric)};
}

SurfaceProxy::Searched SurfaceProxy::search(const glm::dvec3& probe_m) const noexcept {
  const SurfaceSearch::Nearest nearest = surface_->search().nearest(probe_m);
  const Found found{.facet = nearest.triangle,
                    .barycentric = nearest.barycentric,
                    .height_m = height_m(probe_m, nearest.triangle, nearest.barycentric)};
  const std::optional<Found> walked = walk(probe_m, found.facet);
  const double farthest_m = kInclined * std::abs(found.height_m) + kSlack_m;
  return {walked && std::abs(walked->height_m) <= farthest_m ? *walked : found, nearest.distance_m};
}

/// The sign is that of the side on which the probe is of the facets that meet at the nearest point.
double SurfaceProxy::height_m(const glm::dvec3& probe_m, std::uint32_t facet,
                              const glm::dvec3& nearest) const noexcept {
  const auto face_normal = [this](std::uint32_t of) {
    const auto& corners = surface_->corners(of);
    const glm::dvec3& first_m = surface_->vertex_m(corners[0]);
    const glm::dvec3 doubled = glm::cross(surface_->vertex_m(corners[1]) - first_m,
                                          surface_->vertex_m(corners[2]) - first_m);
    const double size = glm::length(doubled);
    return size > 0.0 ? doubled / size : glm::dvec3(0.0);
  };
  glm::dvec3 outward = face_normal(facet);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (nearest[static_cast<int>(corner)] >= 1.0) {
      outward = surface_->normal(surface_->corners(facet)[corner]);
      break;
    }
    if (nearest[static_cast<int>(corner)] > 0.0) continue;
    const std::uint32_t beyond = surface_->beyond(facet, corner);
    if (beyond != kNoHalfEdge) outward += face_normal(beyond);
  }
  const FacetCorners corners = corners_of(*surface_, facet);
  const glm::dvec3 apart_m = probe_m - point_of(corners.m, nearest);
  const double size_m = glm::length(apart_m);
  return glm::dot(apart_m, outward) < 0.0 ? -size_m : size_m;
}

}  // namespace asperity
