// Implements the packing and filling of the atlas.

#include "stimuli/meshes/texture_atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

namespace asperity {

namespace {

// A patch with n texels along a side contains (i, j) with i, j ≥ −1 and i + j ≤ n + 2, including its margin. Two of
// them, one rotated by half a turn, fit into a block of n + 5 by n + 6.
std::size_t block_columns(int side) { return static_cast<std::size_t>(side) + 5; }
std::size_t block_rows(int side) { return static_cast<std::size_t>(side) + 6; }

struct Patch {
  std::size_t column = 0;  ///< of corner 0
  std::size_t row = 0;
  bool turned = false;
};

struct Packing {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<Patch> patches{};
};

Packing pack(const std::vector<int>& sides) {
  std::vector<std::uint32_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sides[a] > sides[b]; });
  Packing packing{};
  packing.patches.resize(sides.size());
  packing.columns = std::max(
      block_columns(sides[order.front()]),
      static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(atlas_texels(sides))))));
  std::size_t column = 0;
  std::size_t row = 0;
  int shelf = sides[order.front()];
  for (std::size_t i = 0; i < order.size();) {
    const int side = sides[order[i]];
    if (side != shelf || column + block_columns(side) > packing.columns) {
      row += block_rows(shelf);
      column = 0;
      shelf = side;
    }
    packing.patches[order[i++]] = {column + 1, row + 1, false};
    if (i < order.size() && sides[order[i]] == side) {
      packing.patches[order[i++]] = {column + block_columns(side) - 2, row + block_rows(side) - 2,
                                     true};
    }
    column += block_columns(side);
  }
  packing.rows = row + block_rows(shelf);
  return packing;
}

/// The counts of one patch with its margin, (i, j) from −1.
class Counts final {
 public:
  explicit Counts(int side)
      : side_(side), width_(static_cast<std::size_t>(side) + 4), counts_(width_ * width_) {}
  int& at(int i, int j) {
    return counts_[static_cast<std::size_t>(j + 1) * width_ + static_cast<std::size_t>(i + 1)];
  }

  void continue_beyond() {
    const int n = side_;
    // The cells along the hypotenuse are planar, so that interpolation on it is linear between its texels.
    for (int i = 1; i <= n; ++i) {
      const int j = n + 1 - i;
      at(i, j) = at(i - 1, j) + at(i, j - 1) - at(i - 1, j - 1);
    }
    at(n + 1, 0) = 2 * at(n, 0) - at(n - 1, 0);
    at(0, n + 1) = 2 * at(0, n) - at(0, n - 1);
    for (int k = 0; k <= n + 1; ++k) {
      at(k, -1) = k <= n ? 2 * at(k, 0) - at(k, 1) : at(n + 1, 0);
      at(-1, k) = k <= n ? 2 * at(0, k) - at(1, k) : at(0, n + 1);
    }
    at(-1, -1) = at(0, 0);
    for (int i = 1; i <= n + 1; ++i) at(i, n + 2 - i) = at(i, n + 1 - i);
  }

 private:
  int side_;
  std::size_t width_;
  std::vector<int> counts_;
};

/// A margin texel is at most 3 times as large as the texels that it continues; within this limit it fits into an int16.
constexpr double kLargestCount = 10900.0;
constexpr double kSmallestStep_m = 1e-12;

}  // namespace

std::size_t atlas_texels(const std::vector<int>& sides) {
  std::size_t doubled = 0;
  for (const int side : sides) doubled += block_columns(side) * block_rows(side);
  return doubled / 2;
}

void fill_atlas(TexturedMesh& mesh, const std::vector<int>& sides, const TexelSource& source) {
  const Packing packing = pack(sides);
  double largest_m = 0.0;
  for (std::uint32_t triangle = 0; triangle < sides.size(); ++triangle) {
    for (int j = 0; j <= sides[triangle]; ++j) {
      for (int i = 0; i + j <= sides[triangle]; ++i) {
        largest_m = std::max(largest_m, std::abs(source(triangle, i, j)));
      }
    }
  }
  mesh.atlas = {packing.rows, packing.columns, std::max(kSmallestStep_m, largest_m / kLargestCount),
                std::vector<std::int16_t>(packing.rows * packing.columns, 0)};
  mesh.places.resize(sides.size());
  for (std::uint32_t triangle = 0; triangle < sides.size(); ++triangle) {
    const int n = sides[triangle];
    Counts counts(n);
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i + j <= n; ++i) {
        counts.at(i, j) = static_cast<int>(std::lround(source(triangle, i, j) / mesh.atlas.step_m));
      }
    }
    counts.continue_beyond();
    const Patch& patch = packing.patches[triangle];
    const std::ptrdiff_t sign = patch.turned ? -1 : 1;
    for (int j = -1; j <= n + 1; ++j) {
      for (int i = -1; i <= n + 1 && i + j <= n + 2; ++i) {
        const auto row =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(patch.row) + sign * j);
        const auto column =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(patch.column) + sign * i);
        mesh.atlas.values[row * packing.columns + column] =
            static_cast<std::int16_t>(std::clamp(counts.at(i, j), -32767, 32767));
      }
    }
    const glm::dvec2 corner(static_cast<double>(patch.column), static_cast<double>(patch.row));
    const double leg = patch.turned ? -n : n;
    mesh.places[triangle] = {corner, corner + glm::dvec2{leg, 0.0}, corner + glm::dvec2{0.0, leg}};
  }
}

std::vector<glm::dvec3> vertex_normals(const std::vector<glm::dvec3>& vertices_m,
                                       const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<glm::dvec3> sums(vertices_m.size(), glm::dvec3{0.0});
  std::vector<std::vector<glm::dvec3>> fronts(vertices_m.size());
  for (const auto& triangle : triangles) {
    const auto side = [&](std::size_t from, std::size_t to) {
      return vertices_m[triangle[to]] - vertices_m[triangle[from]];
    };
    const glm::dvec3 doubled = glm::cross(side(0, 1), side(0, 2));
    const double size = glm::length(doubled);
    if (!(size > 0.0)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 one = side(i, (i + 1) % 3);
      const glm::dvec3 other = side(i, (i + 2) % 3);
      const double angle_rad =
          std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
      sums[triangle[i]] += angle_rad / size * doubled;
      fronts[triangle[i]].push_back(doubled / size);
    }
  }
  for (std::size_t vertex = 0; vertex < sums.size(); ++vertex) {
    const std::vector<glm::dvec3>& faces = fronts[vertex];
    const double length = glm::length(sums[vertex]);
    glm::dvec3 normal = length > 0.0     ? sums[vertex] / length
                        : !faces.empty() ? faces.front()
                                         : glm::dvec3{0.0, 0.0, 1.0};
    const auto most_averted = [&](const glm::dvec3& candidate) {
      return std::min_element(faces.begin(), faces.end(), [&](const auto& a, const auto& b) {
        return glm::dot(a, candidate) < glm::dot(b, candidate);
      });
    };
    // Moves towards the most averted face by decreasing steps and keeps the best normal.
    constexpr double kLeast = 0.2;
    glm::dvec3 best = normal;
    for (double step = 0.5; !faces.empty() && step > 0.01; step *= 0.85) {
      const auto worst = most_averted(normal);
      if (glm::dot(*worst, normal) >= kLeast) break;
      normal = glm::normalize(normal + step * *worst);
      if (glm::dot(*most_averted(normal), normal) > glm::dot(*most_averted(best), best)) {
        best = normal;
      }
    }
    if (!faces.empty() &&
        glm::dot(*most_averted(best), best) > glm::dot(*most_averted(normal), normal)) {
      normal = best;
    }
    sums[vertex] = normal;
  }
  return sums;
}

}  // namespace asperity
