// Implements the division of a textured mesh into facets.

#include "stimuli/meshes/displaced_facets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/textured_point.h"

namespace asperity {
namespace {

constexpr double kTexelsPerFacet = 2.0;

std::uint32_t divisions_of(const TexturedMesh& mesh, const FacetLimits& limits) {
  double wanted = 1.0;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t next = (corner + 1) % 3;
      const double side_m = glm::distance(mesh.vertices_m[mesh.triangles[triangle][corner]],
                                          mesh.vertices_m[mesh.triangles[triangle][next]]);
      const double texels =
          glm::distance(mesh.places[triangle][corner], mesh.places[triangle][next]);
      wanted = std::max({wanted, side_m / limits.longest_m, texels / kTexelsPerFacet});
    }
  }
  const double possible =
      std::sqrt(static_cast<double>(limits.most) / static_cast<double>(mesh.triangles.size()));
  return static_cast<std::uint32_t>(std::max(1.0, std::min(std::ceil(wanted), possible)));
}

/// The vertices of the facets, of which those on an edge belong to both of its triangles.
class FacetVertices final {
 public:
  FacetVertices(const TexturedMesh& mesh, std::uint32_t divisions, TriangleMesh& facets)
      : mesh_(mesh),
        divisions_(divisions),
        facets_(facets),
        corners_(mesh.vertices_m.size(), kNone) {}

  /// The vertex of a triangle with the weights (n − i − j, i, j)/n.
  std::uint32_t at(std::uint32_t triangle, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t first = divisions_ - i - j;
    const auto& corners = mesh_.triangles[triangle];
    if (first == divisions_) return shared(corners_[corners[0]], triangle, i, j);
    if (i == divisions_) return shared(corners_[corners[1]], triangle, i, j);
    if (j == divisions_) return shared(corners_[corners[2]], triangle, i, j);
    if (j == 0) return on_edge(corners[0], corners[1], i, triangle, i, j);
    if (first == 0) return on_edge(corners[1], corners[2], j, triangle, i, j);
    if (i == 0) return on_edge(corners[2], corners[0], first, triangle, i, j);
    if (triangle != inner_of_ || inner_.empty()) {
      inner_of_ = triangle;
      inner_.assign(std::size_t{divisions_} * divisions_, kNone);
    }
    return shared(inner_[std::size_t{j} * divisions_ + i], triangle, i, j);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  std::uint32_t shared(std::uint32_t& known, std::uint32_t triangle, std::uint32_t i,
                       std::uint32_t j) {
    if (known != kNone) return known;
    const double n = divisions_;
    facets_.vertices_m.push_back(
        textured_point_m(mesh_, triangle, {(n - i - j) / n, i / n, j / n}));
    return known = static_cast<std::uint32_t>(facets_.vertices_m.size() - 1);
  }
  /// `steps` from `from` towards `to`.
  std::uint32_t on_edge(std::uint32_t from, std::uint32_t to, std::uint32_t steps,
                        std::uint32_t triangle, std::uint32_t i, std::uint32_t j) {
    auto& edge = edges_[edge_key(from, to)];
    if (edge.empty()) edge.assign(divisions_, kNone);
    return shared(edge[from < to ? steps : divisions_ - steps], triangle, i, j);
  }

  const TexturedMesh& mesh_;
  std::uint32_t divisions_ = 1;
  TriangleMesh& facets_;
  std::vector<std::uint32_t> corners_{};
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> edges_{};
  std::uint32_t inner_of_ = 0;
  std::vector<std::uint32_t> inner_{};
};

}  // namespace

TriangleMesh displaced_facets(const TexturedMesh& mesh, const FacetLimits& limits) {
  TriangleMesh facets{};
  if (mesh.triangles.empty()) return facets;
  const std::uint32_t n = divisions_of(mesh, limits);
  facets.triangles.reserve(mesh.triangles.size() * n * n);
  FacetVertices vertices(mesh, n, facets);
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i + j < n; ++i) {
        const std::uint32_t right = vertices.at(triangle, i + 1, j);
        const std::uint32_t up = vertices.at(triangle, i, j + 1);
        facets.triangles.push_back({vertices.at(triangle, i, j), right, up});
        if (i + j + 2 > n) continue;
        facets.triangles.push_back({vertices.at(triangle, i + 1, j + 1), up, right});
      }
    }
  }
  return facets;
}

}  // namespace asperity
