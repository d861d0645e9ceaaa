// Implements the rays from a simplified mesh to the original.

#include "stimuli/meshes/texture_baking.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/surface_search.h"
#include "stimuli/meshes/texture_atlas.h"

namespace asperity {

namespace {

constexpr float kMissed = std::numeric_limits<float>::quiet_NaN();

class Baking final {
 public:
  Baking(const TriangleMesh& original, const TriangleMesh& simplified, const BakeSettings& settings,
         const Workers& workers)
      : original_(original),
        simplified_(simplified),
        settings_(settings),
        workers_(workers),
        original_search_(original),
        simplified_search_(simplified),
        opposite_(opposite_half_edges(simplified.triangles)) {}

  BakedMesh run() {
    const std::vector<glm::dvec3> samples_m = surface_samples(original_, settings_.error_samples);
    BakedMesh baked{};
    report_.plain = plain_error(samples_m, simplified_search_, part(0.0, 0.15));
    normals_ = vertex_normals(simplified_.vertices_m, simplified_.triangles);
    count_folds();
    find_reach();
    choose_sides();
    cast_rays();
    continue_misses();
    baked.mesh.vertices_m = simplified_.vertices_m;
    baked.mesh.normals = normals_;
    baked.mesh.triangles = simplified_.triangles;
    fill_atlas(baked.mesh, sides_,
               [this](std::uint32_t triangle, int i, int j) { return texel_m(triangle, i, j); });
    report_.textured = textured_error(samples_m, baked.mesh, part(0.8, 1.0));
    baked.report = report_;
    return baked;
  }

 private:
  static constexpr int kFewestTexels = 8;  ///< along a side: a curved original under flat faces
  static constexpr int kMostTexels = 1024;
  static constexpr double kReach = 2.0;  ///< distance along a normal over nearest distance

  Workers part(double from, double to) const {
    if (!workers_.progress) return workers_;
    return {workers_.jobs, [this, from, to](double fraction) {
              workers_.progress(from + (to - from) * fraction);
            }};
  }

  std::uint32_t triangles() const {
    return static_cast<std::uint32_t>(simplified_.triangles.size());
  }
  std::uint32_t corner(std::uint32_t half) const {
    return simplified_.triangles[half / 3][half % 3];
  }
  double edge_m(std::uint32_t half) const {
    return glm::length(simplified_.vertices_m[corner(next_half_edge(half))] -
                       simplified_.vertices_m[corner(half)]);
  }
  double longest_edge_m(std::uint32_t triangle) const {
    return std::max({edge_m(3 * triangle), edge_m(3 * triangle + 1), edge_m(3 * triangle + 2)});
  }

  void count_folds() {
    for (const auto& triangle : simplified_.triangles) {
      const auto at_m = [&](std::size_t i) { return simplified_.vertices_m[triangle[i]]; };
      const glm::dvec3 front = glm::cross(at_m(1) - at_m(0), at_m(2) - at_m(0));
      const bool folded = std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
        return glm::dot(normals_[vertex], front) <= 0.0;
      });
      if (folded) ++report_.folded_faces;
    }
  }

  /// Determines the local distance of the surfaces from the vertices of the original.
  void find_reach() {
    const std::size_t count = original_.vertices_m.size();
    std::vector<SurfaceSearch::Nearest> nearest(count);
    side_by_side(count, part(0.15, 0.25), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        nearest[i] = simplified_search_.nearest(original_.vertices_m[i]);
      }
    });
    glm::dvec3 low_m = original_.vertices_m.front();
    glm::dvec3 high_m = low_m;
    for (const glm::dvec3& point_m : original_.vertices_m) {
      low_m = glm::min(low_m, point_m);
      high_m = glm::max(high_m, point_m);
    }
    // A ray starts this far behind its texel, so that an original directly at the texel is not missed.
    back_m_ = 1e-5 * glm::length(high_m - low_m);
    reach_m_.assign(simplified_.vertices_m.size(), back_m_);
    for (const SurfaceSearch::Nearest& found : nearest) {
      report_.plain.max_m = std::max(report_.plain.max_m, found.distance_m);
      for (const std::uint32_t vertex : simplified_.triangles[found.triangle]) {
        reach_m_[vertex] = std::max(reach_m_[vertex], kReach * found.distance_m);
      }
    }
  }

  struct Meeting {
    double displacement_m = 0.0;
    std::uint32_t triangle = 0;
  };
  /// The intersection with the original from a point along a normal, both interpolated.
  std::optional<Meeting> meet(const glm::dvec3& point_m, const glm::dvec3& normal,
                              double reach_m) const {
    // Normals that nearly cancel each other have no meaningful direction.
    constexpr double kShortestNormal = 0.3;
    const double length = glm::length(normal);
    if (!(length > kShortestNormal)) return {};
    const double back = back_m_ / length;
    // Limits the displacement, which is in multiples of the normal: where a face is folded, a front twice as far away
    // is a different part, and one such texel would enlarge the hull of the whole body.
    const double reach = reach_m + back;
    std::optional<Meeting> nearest{};
    for (const double sign : {1.0, -1.0}) {
      const glm::dvec3 direction = sign * normal;
      const auto hit =
          original_search_.first_front({point_m - back * direction, direction, normal, reach});
      if (!hit) continue;
      const double displacement_m = sign * (hit->distance - back);
      if (!nearest || std::abs(displacement_m) < std::abs(nearest->displacement_m)) {
        nearest = {displacement_m, hit->triangle};
      }
    }
    return nearest;
  }

  std::optional<Meeting> meet(std::uint32_t triangle, const glm::dvec3& barycentric) const {
    glm::dvec3 point_m{0.0};
    glm::dvec3 normal{0.0};
    double reach_m = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = barycentric[static_cast<int>(i)];
      if (weight <= 0.0) continue;
      const std::uint32_t vertex = simplified_.triangles[triangle][i];
      point_m += weight * simplified_.vertices_m[vertex];
      normal += weight * normals_[vertex];
      reach_m = std::max(reach_m, reach_m_[vertex]);
    }
    return meet(point_m, normal, reach_m);
  }

  /// Chooses the texels from the vertex spacing of the original under each face, the lower third of its distribution.
  void choose_sides() {
    constexpr int kProbes = 12;
    std::vector<double> spacings_m(triangles(), 0.0);
    side_by_side(triangles(), part(0.25, 0.3), [&](std::size_t begin, std::size_t end) {
      for (std::size_t face = begin; face < end; ++face) {
        std::vector<double> found_m{};
        for (int j = 0; j < kProbes; ++j) {
          for (int i = 0; i + j < kProbes; ++i) {
            const double b = (i + 1.0 / 3.0) / kProbes;
            const double c = (j + 1.0 / 3.0) / kProbes;
            if (const auto met = meet(static_cast<std::uint32_t>(face), {1.0 - b - c, b, c})) {
              found_m.push_back(spacing_m(met->triangle));
            }
          }
        }
        if (found_m.empty()) continue;
        const auto third = found_m.begin() + static_cast<std::ptrdiff_t>(found_m.size() / 3);
        std::nth_element(found_m.begin(), third, found_m.end());
        spacings_m[face] = *third;
      }
    });
    sides_.assign(triangles(), kFewestTexels);
    std::vector<double> wanted(triangles(), 0.0);
    for (std::uint32_t face = 0; face < triangles(); ++face) {
      if (spacings_m[face] <= 0.0) continue;
      wanted[face] =
          longest_edge_m(face) * settings_.samples_per_wavelength / (2.0 * spacings_m[face]);
      while (sides_[face] < wanted[face] && sides_[face] < kMostTexels) sides_[face] *= 2;
    }
    while (atlas_texels(sides_) > settings_.most_texels &&
           *std::max_element(sides_.begin(), sides_.end()) > kFewestTexels) {
      for (int& side : sides_) side = std::max(kFewestTexels, side / 2);
    }
    report_.samples_per_wavelength = settings_.samples_per_wavelength;
    report_.finest_pitch_m = std::numeric_limits<double>::infinity();
    for (std::uint32_t face = 0; face < triangles(); ++face) {
      const double pitch_m = longest_edge_m(face) / sides_[face];
      report_.finest_pitch_m = std::min(report_.finest_pitch_m, pitch_m);
      report_.coarsest_pitch_m = std::max(report_.coarsest_pitch_m, pitch_m);
      if (wanted[face] > sides_[face]) {
        report_.samples_per_wavelength =
            std::min(report_.samples_per_wavelength,
                     settings_.samples_per_wavelength * sides_[face] / wanted[face]);
      }
    }
  }

  /// The side of the equilateral triangle with the same area.
  double spacing_m(std::uint32_t triangle) const {
    const auto& corners = original_.triangles[triangle];
    const glm::dvec3& a_m = original_.vertices_m[corners[0]];
    const glm::dvec3 doubled =
        glm::cross(original_.vertices_m[corners[1]] - a_m, original_.vertices_m[corners[2]] - a_m);
    return std::sqrt(2.0 / std::sqrt(3.0) * glm::length(doubled));
  }

  /// Each edge belongs to its first half-edge and has the number of texels of its coarser face.
  bool owns_edge(std::uint32_t half) const {
    return opposite_[half] == kNoHalfEdge || half < opposite_[half];
  }
  int edge_texels(std::uint32_t half) const {
    const int own = sides_[half / 3];
    return opposite_[half] == kNoHalfEdge ? own : std::min(own, sides_[opposite_[half] / 3]);
  }

  static std::size_t interior_texels(int side) {
    return static_cast<std::size_t>(side - 1) * static_cast<std::size_t>(side - 2) / 2;
  }
  /// The index within the interior of a patch, row by row; 1 ≤ i, 1 ≤ j, i + j < side.
  static std::size_t interior_index(int side, int i, int j) {
    const auto rows_before = static_cast<std::size_t>(j - 1);
    return rows_before * static_cast<std::size_t>(side - 1) - rows_before * (rows_before + 1) / 2 +
           static_cast<std::size_t>(i - 1);
  }

  void cast_rays() {
    vertex_m_.assign(simplified_.vertices_m.size(), kMissed);
    edge_m_.resize(3 * static_cast<std::size_t>(triangles()));
    interior_m_.resize(triangles());
    const auto value_of = [](const std::optional<Meeting>& met) {
      return met ? static_cast<float>(met->displacement_m) : kMissed;
    };
    side_by_side(vertex_m_.size(), {workers_.jobs, {}}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        vertex_m_[i] = value_of(meet(simplified_.vertices_m[i], normals_[i], reach_m_[i]));
      }
    });
    side_by_side(triangles(), part(0.3, 0.8), [&](std::size_t begin, std::size_t end) {
      for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face) {
        for (std::uint32_t half = 3 * face; half < 3 * face + 3; ++half) {
          if (!owns_edge(half)) continue;
          const int count = edge_texels(half);
          const std::uint32_t next = next_half_edge(half);
          for (int k = 1; k < count; ++k) {
            glm::dvec3 barycentric{0.0};
            barycentric[static_cast<int>(half % 3)] = 1.0 - static_cast<double>(k) / count;
            barycentric[static_cast<int>(next % 3)] = static_cast<double>(k) / count;
            edge_m_[half].push_back(value_of(meet(face, barycentric)));
          }
        }
        const int side = sides_[face];
        interior_m_[face].reserve(interior_texels(side));
        for (int j = 1; j < side; ++j) {
          for (int i = 1; i + j < side; ++i) {
            const double b = static_cast<double>(i) / side;
            const double c = static_cast<double>(j) / side;
            interior_m_[face].push_back(value_of(meet(face, {1.0 - b - c, b, c})));
          }
        }
      }
    });
  }

  void count(const std::vector<float>& values_m) {
    report_.samples += values_m.size();
    report_.missed += static_cast<std::size_t>(std::count_if(
        values_m.begin(), values_m.end(), [](float value) { return std::isnan(value); }));
  }

  /// Fills the texels whose rays missed from their neighbours: along an edge by linear interpolation between hits,
  /// within a face layer by layer.
  void continue_misses() {
    count(vertex_m_);
    for (float& value : vertex_m_) {
      if (std::isnan(value))
        value = 0.0F;  // a vertex of the simplified mesh is one of the original
    }
    for (std::uint32_t half = 0; half < edge_m_.size(); ++half) {
      count(edge_m_[half]);
      bridge(edge_m_[half], vertex_m_[corner(half)], vertex_m_[corner(next_half_edge(half))]);
    }
    for (std::uint32_t face = 0; face < triangles(); ++face) {
      count(interior_m_[face]);
      grow_inward(face);
    }
  }

  static void bridge(std::vector<float>& values, float before, float after) {
    std::size_t begin = 0;
    while (begin < values.size()) {
      if (!std::isnan(values[begin])) {
        before = values[begin++];
        continue;
      }
      std::size_t end = begin;
      while (end < values.size() && std::isnan(values[end])) ++end;
      const float beyond = end < values.size() ? values[end] : after;
      const auto gap = static_cast<float>(end - begin + 1);
      for (std::size_t i = begin; i < end; ++i) {
        values[i] = before + (beyond - before) * static_cast<float>(i - begin + 1) / gap;
      }
      begin = end;
    }
  }

  void grow_inward(std::uint32_t face) {
    struct Texel {
      int i = 0;
      int j = 0;
      double value_m = 0.0;
    };
    const int side = sides_[face];
    std::vector<Texel> missing{};
    for (int j = 1; j < side; ++j) {
      for (int i = 1; i + j < side; ++i) {
        if (std::isnan(interior_m_[face][interior_index(side, i, j)])) missing.push_back({i, j});
      }
    }
    while (!missing.empty()) {
      std::vector<Texel> known{};
      std::vector<Texel> left{};
      for (const Texel& texel : missing) {
        constexpr int kAround[6][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
        double sum_m = 0.0;
        int neighbours = 0;
        for (const auto& [di, dj] : kAround) {
          const double value_m = texel_m(face, texel.i + di, texel.j + dj);
          if (std::isnan(value_m)) continue;
          sum_m += value_m;
          ++neighbours;
        }
        if (neighbours > 0) {
          known.push_back({texel.i, texel.j, sum_m / neighbours});
        } else {
          left.push_back(texel);
        }
      }
      for (const Texel& texel : known) {
        interior_m_[face][interior_index(side, texel.i, texel.j)] =
            static_cast<float>(texel.value_m);
      }
      missing = std::move(left);
    }
  }

  /// The displacement at texel k of `side` along a half-edge, from the texels of its edge.
  double edge_texel_m(std::uint32_t half, int k, int side) const {
    const bool own = owns_edge(half);
    const std::uint32_t owner = own ? half : opposite_[half];
    const std::vector<float>& values_m = edge_m_[owner];
    const int count = static_cast<int>(values_m.size()) + 1;
    const int from_owner = own ? k : side - k;
    const int ratio = side / count;
    const auto value_m = [&](int index) {
      if (index == 0) return static_cast<double>(vertex_m_[corner(owner)]);
      if (index == count) return static_cast<double>(vertex_m_[corner(next_half_edge(owner))]);
      return static_cast<double>(values_m[static_cast<std::size_t>(index - 1)]);
    };
    const int index = from_owner / ratio;
    const int rest = from_owner % ratio;
    if (rest == 0) return value_m(index);
    return value_m(index) + (value_m(index + 1) - value_m(index)) * rest / ratio;
  }

  double texel_m(std::uint32_t triangle, int i, int j) const {
    const int side = sides_[triangle];
    if (j == 0) return edge_texel_m(3 * triangle, i, side);
    if (i + j == side) return edge_texel_m(3 * triangle + 1, j, side);
    if (i == 0) return edge_texel_m(3 * triangle + 2, side - j, side);
    return static_cast<double>(interior_m_[triangle][interior_index(side, i, j)]);
  }

  const TriangleMesh& original_;
  const TriangleMesh& simplified_;
  BakeSettings settings_;
  const Workers& workers_;
  SurfaceSearch original_search_;
  SurfaceSearch simplified_search_;
  std::vector<std::uint32_t> opposite_;
  std::vector<glm::dvec3> normals_{};
  BakeReport report_{};
  std::vector<double> reach_m_{};  ///< of rays around each vertex
  double back_m_ = 0.0;
  std::vector<int> sides_{};  ///< texels along the sides of each face's patch
  std::vector<float> vertex_m_{};
  std::vector<std::vector<float>>
      edge_m_{};  ///< of the half-edge that owns the edge, without its ends
  std::vector<std::vector<float>> interior_m_{};
};

}  // namespace

std::optional<std::string> warning_of(const BakeReport& report) {
  const GeometricError& plain = report.plain;
  const GeometricError& textured = report.textured;
  // Tolerance for rounding errors of a mesh that is its own original.
  constexpr double kFinest_m = 1e-7;
  const bool is_further = textured.rms_m > plain.rms_m + kFinest_m;
  if (!is_further && !(textured.max_m > plain.max_m + kFinest_m)) return {};
  const auto micrometres = [](double length_m) { return fixed(length_m * 1e6, 1) + " µm"; };
  const auto both = [&](double GeometricError::*of) {
    return micrometres(textured.*of) + " from the original with its texture and " +
           micrometres(plain.*of) + " without";
  };
  return is_further
             ? "The mesh lies " + both(&GeometricError::rms_m) +
                   " (RMS): the texture increases this distance. Increase the number of triangles."
             : "At its worst point the mesh lies " + both(&GeometricError::max_m) +
                   ": there the texture increases this distance. Increase the number of triangles.";
}

BakedMesh bake_texture(const TriangleMesh& original, const TriangleMesh& simplified,
                       const BakeSettings& settings, const Workers& workers) {
  if (original.triangles.empty() || simplified.triangles.empty()) {
    throw std::invalid_argument(
        "the original or the simplified mesh has no triangles; use meshes with triangles.");
  }
  return Baking(original, simplified, settings, workers).run();
}

}  // namespace asperity
