// Implements the distances of samples, which are stored by index and summed in a fixed order.

#include "stimuli/meshes/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/textured_point.h"

namespace asperity {

namespace {

GeometricError error_of(const std::vector<double>& distances_m) {
  GeometricError error{};
  double sum_m2 = 0.0;
  for (const double distance_m : distances_m) {
    sum_m2 += distance_m * distance_m;
    error.max_m = std::max(error.max_m, distance_m);
  }
  if (!distances_m.empty()) {
    error.rms_m = std::sqrt(sum_m2 / static_cast<double>(distances_m.size()));
  }
  return error;
}

/// A position on the mesh before displacement.
struct PlaceOnFace {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{};
};

class DisplacedSurface final {
 public:
  explicit DisplacedSurface(const TexturedMesh& mesh)
      : mesh_(mesh),
        opposite_(opposite_half_edges(mesh.triangles)),
        rows_(rows_for(mesh.triangles.size())),
        coarse_(coarse_of(mesh, rows_)),
        search_(coarse_) {}

  double distance_m(const glm::dvec3& point_m) const {
    const PlaceOnFace near = near_place(point_m);
    const double from_near_m = distance_about_m(point_m, near);
    const PlaceOnFace under = place_under(point_m, near);
    return std::min(from_near_m, distance_about_m(point_m, under));
  }

 private:
  // Displacements may be longer than parts of the body are thick: the nearest point on the undisplaced mesh may be on
  // the wrong side of a leg, or on another leg. The search therefore uses the displaced surface, with each face divided
  // into this number of rows of triangles.
  static int rows_for(std::size_t triangles) {
    constexpr std::size_t kMostTriangles = std::size_t{1} << 19;
    constexpr int kMostRows = 32;
    int rows = 1;
    while (rows < kMostRows &&
           4 * static_cast<std::size_t>(rows * rows) * triangles <= kMostTriangles) {
      rows *= 2;
    }
    return rows;
  }

  /// The barycentric coordinates of the grid point (i, j) of a face; 0 ≤ i, 0 ≤ j, i + j ≤ rows.
  static glm::dvec3 corner(int i, int j, int rows) {
    const double b = static_cast<double>(i) / rows;
    const double c = static_cast<double>(j) / rows;
    return {1.0 - b - c, b, c};
  }

  /// The mesh with rows² triangles per face, row by row; in each row those with the face's orientation come first.
  static TriangleMesh coarse_of(const TexturedMesh& mesh, int rows) {
    TriangleMesh coarse{};
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
      auto below = static_cast<std::uint32_t>(coarse.vertices_m.size());
      for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i + j <= rows; ++i) {
          coarse.vertices_m.push_back(textured_point_m(mesh, face, corner(i, j, rows)));
        }
      }
      for (int j = 0; j < rows; ++j) {
        const auto count = static_cast<std::uint32_t>(rows - j);
        const std::uint32_t above = below + count + 1;
        for (std::uint32_t i = 0; i < count; ++i) {
          coarse.triangles.push_back({below + i, below + i + 1, above + i});
        }
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
          coarse.triangles.push_back({below + i + 1, above + i + 1, above + i});
        }
        below = above;
      }
    }
    return coarse;
  }

  PlaceOnFace near_place(const glm::dvec3& point_m) const {
    const SurfaceSearch::Nearest nearest = search_.nearest(point_m);
    const auto of_face = static_cast<std::uint32_t>(rows_ * rows_);
    auto rest = static_cast<int>(nearest.triangle % of_face);
    int j = 0;
    for (; rest >= 2 * (rows_ - j) - 1; ++j) rest -= 2 * (rows_ - j) - 1;
    const bool stands_like_face = rest < rows_ - j;
    const int i = stands_like_face ? rest : rest - (rows_ - j);
    const glm::dvec3 b = nearest.barycentric;
    return {nearest.triangle / of_face,
            stands_like_face ? b.x * corner(i, j, rows_) + b.y * corner(i + 1, j, rows_) +
                                   b.z * corner(i, j + 1, rows_)
                             : b.x * corner(i + 1, j, rows_) + b.y * corner(i + 1, j + 1, rows_) +
                                   b.z * corner(i, j + 1, rows_)};
  }

  /// Finds the position whose interpolated normal passes through the point, by Newton's method from triangle to
  /// triangle. Without convergence it returns the last position.
  PlaceOnFace place_under(const glm::dvec3& point_m, PlaceOnFace place) const {
    constexpr int kMostSteps = 24;
    constexpr double kArrived = 1e-9;
    double height = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
      const auto& corners = mesh_.triangles[place.triangle];
      const glm::dvec3& b = place.barycentric;
      glm::dvec3 at_m{0.0};
      glm::dvec3 along{0.0};
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = corners[static_cast<std::size_t>(i)];
        at_m += b[i] * mesh_.vertices_m[vertex];
        along += b[i] * mesh_.normals[vertex];
      }
      const auto towards = [&](std::size_t i) {
        return mesh_.vertices_m[corners[i]] - mesh_.vertices_m[corners[0]] +
               height * (mesh_.normals[corners[i]] - mesh_.normals[corners[0]]);
      };
      const glm::dmat3 jacobian(towards(1), towards(2), along);
      const double determinant = glm::determinant(jacobian);
      if (!(std::abs(determinant) > 1e-12 * glm::length(towards(1)) * glm::length(towards(2)))) {
        return place;
      }
      const glm::dvec3 change = glm::inverse(jacobian) * (point_m - at_m - height * along);
      const glm::dvec3 by{-change.x - change.y, change.x, change.y};
      // The step is limited to the triangle.
      double part = 1.0;
      int left_behind = -1;
      for (int i = 0; i < 3; ++i) {
        if (b[i] + by[i] < -kArrived && b[i] + part * by[i] < 0.0) {
          part = std::max(0.0, b[i] / -by[i]);
          left_behind = i;
        }
      }
      place.barycentric = glm::max(b + part * by, glm::dvec3{0.0});
      height += part * change.z;
      if (left_behind < 0) {
        if (glm::length(by) < kArrived) return place;
        continue;
      }
      const auto side = static_cast<std::uint32_t>((left_behind + 1) % 3);
      const std::uint32_t across = opposite_[3 * place.triangle + side];
      if (across == kNoHalfEdge) return place;
      const std::uint32_t next = across / 3;
      glm::dvec3 there{0.0};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (mesh_.triangles[next][j] == corners[i]) {
            there[static_cast<int>(j)] = place.barycentric[static_cast<int>(i)];
          }
        }
      }
      const double sum = there.x + there.y + there.z;
      if (!(sum > 0.5)) return place;
      place = {next, there / sum};
    }
    return place;
  }

  /// The distance from the nearest triangle between texels around a position; the window grows with the distance.
  double distance_about_m(const glm::dvec3& point_m, const PlaceOnFace& place) const {
    constexpr int kWidest = 32;
    double distance_m = std::numeric_limits<double>::infinity();
    for (int radius = 1; radius <= kWidest; radius *= 2) {
      const Window window = window_about(place, radius);
      distance_m = distance_in_m(point_m, place.triangle, window);
      if (distance_m < 0.5 * radius * cell_m(place.triangle) || window.whole) break;
    }
    return distance_m;
  }

  struct Window {
    int first_i = 0;
    int last_i = 0;
    int first_j = 0;
    int last_j = 0;
    bool whole = false;
  };

  int texels(std::uint32_t triangle) const {
    const glm::dvec2 leg = glm::abs(mesh_.places[triangle][1] - mesh_.places[triangle][0]);
    return static_cast<int>(std::lround(std::max(leg.x, leg.y)));
  }

  double cell_m(std::uint32_t triangle) const {
    const auto& corners = mesh_.triangles[triangle];
    return glm::length(mesh_.vertices_m[corners[1]] - mesh_.vertices_m[corners[0]]) /
           texels(triangle);
  }

  Window window_about(const PlaceOnFace& place, int radius) const {
    const int count = texels(place.triangle);
    const int i = std::min(static_cast<int>(place.barycentric.y * count), count - 1);
    const int j = std::min(static_cast<int>(place.barycentric.z * count), count - 1);
    Window window{std::max(0, i - radius), std::min(count - 1, i + radius), std::max(0, j - radius),
                  std::min(count - 1, j + radius)};
    window.whole = window.first_i == 0 && window.first_j == 0 && window.last_i == count - 1 &&
                   window.last_j == count - 1;
    return window;
  }

  double distance_in_m(const glm::dvec3& point_m, std::uint32_t triangle,
                       const Window& window) const {
    const int count = texels(triangle);
    const auto surface_m = [&](int i, int j) {
      const double b = static_cast<double>(i) / count;
      const double c = static_cast<double>(j) / count;
      const glm::dvec3 weights{1.0 - b - c, b, c};
      const auto& corners = mesh_.triangles[triangle];
      const auto& places = mesh_.places[triangle];
      const glm::dvec2 place =
          weights.x * places[0] + weights.y * places[1] + weights.z * places[2];
      const auto texel = static_cast<std::size_t>(std::lround(place.y)) * mesh_.atlas.columns +
                         static_cast<std::size_t>(std::lround(place.x));
      glm::dvec3 at_m{0.0};
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = corners[static_cast<std::size_t>(corner)];
        at_m += weights[corner] *
                (mesh_.vertices_m[vertex] +
                 mesh_.atlas.step_m * mesh_.atlas.values[texel] * mesh_.normals[vertex]);
      }
      return at_m;
    };
    double best_m = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::array<glm::dvec3, 3>& corners_m) {
      const glm::dvec3 b = nearest_in_triangle(corners_m, point_m);
      best_m = std::min(best_m, glm::length(b.x * corners_m[0] + b.y * corners_m[1] +
                                            b.z * corners_m[2] - point_m));
    };
    std::vector<glm::dvec3> row_m{};
    std::vector<glm::dvec3> next_row_m{};
    const auto fill = [&](std::vector<glm::dvec3>& points_m, int j) {
      points_m.clear();
      for (int i = window.first_i; i <= window.last_i + 1 && i + j <= count; ++i) {
        points_m.push_back(surface_m(i, j));
      }
    };
    fill(row_m, window.first_j);
    for (int j = window.first_j; j <= window.last_j; ++j) {
      fill(next_row_m, j + 1);
      for (std::size_t i = 0; i < next_row_m.size() && i + 1 < row_m.size(); ++i) {
        consider({row_m[i], row_m[i + 1], next_row_m[i]});
        if (i + 1 < next_row_m.size()) {
          consider({row_m[i + 1], next_row_m[i + 1], next_row_m[i]});
        }
      }
      std::swap(row_m, next_row_m);
    }
    return best_m;
  }

  const TexturedMesh& mesh_;
  std::vector<std::uint32_t> opposite_;
  int rows_;
  TriangleMesh coarse_;
  SurfaceSearch search_;
};

}  // namespace

std::vector<glm::dvec3> surface_samples(const TriangleMesh& mesh, std::size_t count) {
  std::vector<double> up_to_m2{};
  up_to_m2.reserve(mesh.triangles.size());
  double sum_m2 = 0.0;
  const auto corner_m = [&](std::size_t triangle, std::size_t i) {
    return mesh.vertices_m[mesh.triangles[triangle][i]];
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    sum_m2 += 0.5 * glm::length(glm::cross(corner_m(i, 1) - corner_m(i, 0),
                                           corner_m(i, 2) - corner_m(i, 0)));
    up_to_m2.push_back(sum_m2);
  }
  std::vector<glm::dvec3> samples_m{};
  samples_m.reserve(count);
  std::size_t triangle = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double at_m2 = (static_cast<double>(k) + 0.5) / static_cast<double>(count) * sum_m2;
    while (triangle + 1 < up_to_m2.size() && up_to_m2[triangle] < at_m2) ++triangle;
    // Multiples of two irrational numbers fill the unit square evenly (those of the plastic number).
    const auto n = static_cast<double>(k);
    double b = std::fmod(0.5 + n * 0.7548776662466927, 1.0);
    double c = std::fmod(0.5 + n * 0.5698402909980532, 1.0);
    if (b + c > 1.0) {
      b = 1.0 - b;
      c = 1.0 - c;
    }
    samples_m.push_back((1.0 - b - c) * corner_m(triangle, 0) + b * corner_m(triangle, 1) +
                        c * corner_m(triangle, 2));
  }
  return samples_m;
}

GeometricError plain_error(const std::vector<glm::dvec3>& samples_m, const SurfaceSearch& search,
                           const Workers& workers) {
  std::vector<double> distances_m(samples_m.size());
  side_by_side(samples_m.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      distances_m[i] = search.nearest(samples_m[i]).distance_m;
    }
  });
  return error_of(distances_m);
}

GeometricError textured_error(const std::vector<glm::dvec3>& samples_m, const TexturedMesh& mesh,
                              const Workers& workers) {
  const DisplacedSurface surface(mesh);
  std::vector<double> distances_m(samples_m.size());
  side_by_side(samples_m.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      distances_m[i] = surface.distance_m(samples_m[i]);
    }
  });
  return error_of(distances_m);
}

}  // namespace asperity
