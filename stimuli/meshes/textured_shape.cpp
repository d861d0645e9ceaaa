// Implements the meshes of shapes and the layout of a height field on them.

#include "stimuli/meshes/textured_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/texture_atlas.h"

namespace asperity {

namespace {

constexpr double kLargest_m = 10.0;
constexpr std::size_t kMostTexels = std::size_t{1} << 25;
/// Approximate number of texels along the side of a face: few faces, and patches that are searched quickly.
constexpr double kCell_texels = 128.0;

struct Corner {
  glm::dvec3 point_m{};
  glm::dvec3 normal{};
};

/// The displacement of a point along the normal, both interpolated.
using Displacement = std::function<double(const glm::dvec3& point_m, const glm::dvec3& normal)>;

double area_m2(const glm::dvec3& box_m) {
  return 2.0 * (box_m.x * box_m.y + box_m.y * box_m.z + box_m.z * box_m.x);
}

class Building final {
 public:
  Building(const HeightField& field, const ShapeRelief& relief)
      : field_(field),
        relief_(relief),
        pitch_m_(std::min(2.0 * field.grid().pitch_m / relief.samples_per_wavelength,
                          relief.rim_m / 16.0)) {
    if (!(relief.samples_per_wavelength >= 1.0 && relief.samples_per_wavelength <= 64.0)) {
      throw std::invalid_argument("samples_per_wavelength is " +
                                  number_text(relief.samples_per_wavelength) +
                                  "; it must be from 1 to 64.");
    }
  }

  /// Adds the faces, without their texels.
  void lay_out(const PlateShape& plate) {
    check({plate.size_m.x, plate.size_m.y, plate.size_m.z});
    require_few_faces(area_m2(plate.size_m));
    box(plate.size_m, {0.0, 0.0, -0.5 * plate.size_m.z}, {2});
  }
  void lay_out(const BoxShape& shape) {
    check({shape.size_m.x, shape.size_m.y, shape.size_m.z});
    require_few_faces(area_m2(shape.size_m));
    box(shape.size_m, glm::dvec3{0.0}, {-3, -2, -1, 0, 1, 2});
  }
  void lay_out(const CylinderShape& cylinder);
  void lay_out(const SphereShape& sphere);

  void require_few_texels() const {
    const std::size_t texels = atlas_texels(sides_);
    if (texels > kMostTexels) refuse(std::to_string(texels));
  }
  TexturedMesh fill();

 private:
  void check(const std::vector<double>& sizes_m) const {
    for (const double size_m : sizes_m) {
      if (!(size_m > 0.0 && size_m <= kLargest_m)) {
        throw std::invalid_argument("a size of the shape is " + number_text(size_m) +
                                    " m; it must be above 0 m and at most 10 m.");
      }
    }
    const double smallest_m = *std::min_element(sizes_m.begin(), sizes_m.end());
    if (!(relief_.rim_m > 0.0 && relief_.rim_m <= 0.25 * smallest_m)) {
      throw std::invalid_argument(
          "rim_m is " + number_text(relief_.rim_m) +
          " m; it must be above 0 m and at most a quarter of the smallest size, which is " +
          number_text(smallest_m) + " m.");
    }
  }

  [[noreturn]] static void refuse(const std::string& texels) {
    throw std::invalid_argument("the texture of the shape would take " + texels +
                                " texels, and at most " + std::to_string(kMostTexels) +
                                " are possible; use a smaller shape or a coarser height field.");
  }
  /// Throws before the number of faces exceeds the memory. The actual texel spacing is at most `pitch_m_`.
  void require_few_faces(double area_m2) const {
    const double texels = area_m2 / (pitch_m_ * pitch_m_);
    if (texels > 8.0 * static_cast<double>(kMostTexels)) refuse(number_text(std::floor(texels)));
  }

  double height_m(double x_m, double y_m) const {
    return field_.sample(x_m, y_m, relief_.tiling).height_m;
  }
  /// Linear interpolation between texels deviates from a round side by p²/(8R): R/80 000.
  void bend(double radius_m) { pitch_m_ = std::min(pitch_m_, 0.01 * radius_m); }
  /// In the outer half of the rim there is no relief, so that normals can change direction there; in the other half the
  /// relief rises.
  double bare_m() const { return 0.5 * relief_.rim_m; }
  double risen(double from_edge_m) const {
    return glm::smoothstep(0.0, 1.0, (from_edge_m - bare_m()) / (relief_.rim_m - bare_m()));
  }
  int texels_for(double length_m) const {
    return std::max(1, static_cast<int>(std::ceil(length_m / pitch_m_)));
  }

  std::uint32_t vertex(const Corner& corner) {
    const std::array<double, 6> key{corner.point_m.x, corner.point_m.y, corner.point_m.z,
                                    corner.normal.x,  corner.normal.y,  corner.normal.z};
    const auto [place, is_new] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices_m.size()));
    if (is_new) {
      mesh_.vertices_m.push_back(corner.point_m);
      mesh_.normals.push_back(corner.normal);
    }
    return place->second;
  }
  void add(const std::array<Corner, 3>& corners, int texels, std::size_t displacement) {
    mesh_.triangles.push_back({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])});
    sides_.push_back(texels);
    displacement_of_.push_back(displacement);
  }
  /// a, b, c, d are counter-clockwise.
  void add_cell(const std::array<Corner, 4>& corners, int texels, std::size_t displacement) {
    add({corners[0], corners[1], corners[3]}, texels, displacement);
    add({corners[2], corners[3], corners[1]}, texels, displacement);
  }

  /// The lines across a length: its ends, the bare rim at both ends, cells in between.
  std::vector<double> lines_m(double length_m) const {
    const double half_m = 0.5 * length_m;
    const double inner_m = half_m - bare_m();
    const auto cells = static_cast<int>(std::ceil(2.0 * inner_m / (kCell_texels * pitch_m_)));
    std::vector<double> lines{-half_m};
    for (int i = 0; i <= cells; ++i) lines.push_back(inner_m * (2.0 * i - cells) / cells);
    lines.push_back(half_m);
    return lines;
  }
  static double widest_m(const std::vector<double>& lines) {
    double widest = 0.0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      widest = std::max(widest, lines[i] - lines[i - 1]);
    }
    return widest;
  }

  /// `rough` lists the sides with relief: the axis for its upper side, −1 − axis for its lower one.
  void box(const glm::dvec3& size_m, const glm::dvec3& centre_m, const std::vector<int>& rough);

  const HeightField& field_;
  ShapeRelief relief_;
  double pitch_m_;
  TexturedMesh mesh_{};
  std::map<std::array<double, 6>, std::uint32_t> vertices_{};
  std::vector<int> sides_{};
  std::vector<std::size_t> displacement_of_{};
  std::vector<Displacement> displacements_{};
};

TexturedMesh Building::fill() {
  fill_atlas(mesh_, sides_, [this](std::uint32_t triangle, int i, int j) {
    const double b = static_cast<double>(i) / sides_[triangle];
    const double c = static_cast<double>(j) / sides_[triangle];
    const std::array<double, 3> weights{1.0 - b - c, b, c};
    glm::dvec3 point_m{0.0};
    glm::dvec3 normal{0.0};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      point_m += weights[corner] * mesh_.vertices_m[mesh_.triangles[triangle][corner]];
      normal += weights[corner] * mesh_.normals[mesh_.triangles[triangle][corner]];
    }
    return displacements_[displacement_of_[triangle]](point_m, normal);
  });
  return std::move(mesh_);
}

void Building::box(const glm::dvec3& size_m, const glm::dvec3& centre_m,
                   const std::vector<int>& rough) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const std::vector<double> lines_u_m = lines_m(size_m[u]);
    const std::vector<double> lines_v_m = lines_m(size_m[v]);
    const int texels = texels_for(std::max(widest_m(lines_u_m), widest_m(lines_v_m)));
    for (const double side : {1.0, -1.0}) {
      const int code = side > 0.0 ? axis : -1 - axis;
      const bool smooth = std::find(rough.begin(), rough.end(), code) == rough.end();
      displacements_.push_back([=, this](const glm::dvec3& point_m, const glm::dvec3&) {
        if (smooth) return 0.0;
        const double u_m = point_m[u] - centre_m[u];
        const double v_m = point_m[v] - centre_m[v];
        const double from_edge_m =
            std::min(0.5 * size_m[u] - std::abs(u_m), 0.5 * size_m[v] - std::abs(v_m));
        const double share = risen(from_edge_m);
        return share > 0.0 ? share * height_m(side * u_m, v_m) : 0.0;
      });
      const auto corner = [&](std::size_t i, std::size_t j) {
        Corner result{centre_m, glm::dvec3{0.0}};
        result.point_m[axis] += side * 0.5 * size_m[axis];
        result.point_m[u] += lines_u_m[i];
        result.point_m[v] += lines_v_m[j];
        result.normal[axis] = side;
        if (i == 0 || i + 1 == lines_u_m.size()) result.normal[u] = i == 0 ? -1.0 : 1.0;
        if (j == 0 || j + 1 == lines_v_m.size()) result.normal[v] = j == 0 ? -1.0 : 1.0;
        result.normal /= glm::length(result.normal);
        return result;
      };
      for (std::size_t j = 0; j + 1 < lines_v_m.size(); ++j) {
        for (std::size_t i = 0; i + 1 < lines_u_m.size(); ++i) {
          const bool bare =
              smooth || i == 0 || j == 0 || i + 2 == lines_u_m.size() || j + 2 == lines_v_m.size();
          std::array<Corner, 4> corners{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                        corner(i, j + 1)};
          if (side < 0.0) std::swap(corners[1], corners[3]);
          add_cell(corners, bare ? 1 : texels, displacements_.size() - 1);
        }
      }
    }
  }
}

void Building::lay_out(const CylinderShape& cylinder) {
  check({cylinder.diameter_m, cylinder.length_m});
  const double radius_m = 0.5 * cylinder.diameter_m;
  bend(radius_m);
  const double half_m = 0.5 * cylinder.length_m;
  const double around_m = std::numbers::pi * cylinder.diameter_m;
  require_few_faces(around_m * (cylinder.length_m + radius_m));
  const std::vector<double> lines = lines_m(cylinder.length_m);
  const auto segments =
      std::clamp(static_cast<int>(std::ceil(around_m / (kCell_texels * pitch_m_))), 32, 1024);
  const int texels = texels_for(std::max(around_m / segments, widest_m(lines)));
  const double periods = std::max(1.0, std::round(around_m / field_.width_m()));
  // Points and normals of the round side are interpolated between those of two of its lines: |point| is R w and
  // |normal| is w, with w the cosine factor of the chord. A distance of R + h from the axis is therefore (R + h)/w − R
  // along the normal.
  displacements_.push_back([=, this](const glm::dvec3& point_m, const glm::dvec3&) {
    const double w = std::hypot(point_m.x, point_m.y) / radius_m;
    const double from_end_m = half_m - std::abs(point_m.z);
    const double share = risen(from_end_m);
    if (share <= 0.0) {
      return radius_m * (1.0 / w - 1.0) * std::clamp(from_end_m / bare_m(), 0.0, 1.0);
    }
    const double turns = std::atan2(point_m.y, point_m.x) / (2.0 * std::numbers::pi);
    const double height = share * height_m(turns * periods * field_.width_m(), point_m.z);
    return (radius_m + height) / w - radius_m;
  });
  displacements_.push_back([](const glm::dvec3&, const glm::dvec3&) { return 0.0; });
  const auto around = [&](int segment) {
    const double angle_rad = 2.0 * std::numbers::pi * (segment % segments) / segments;
    return glm::dvec3{std::cos(angle_rad), std::sin(angle_rad), 0.0};
  };
  const auto on_side = [&](int segment, std::size_t line) {
    const glm::dvec3 out = around(segment);
    const double end = line == 0 ? -1.0 : line + 1 == lines.size() ? 1.0 : 0.0;
    const glm::dvec3 normal = out + glm::dvec3{0.0, 0.0, end};
    return Corner{radius_m * out + glm::dvec3{0.0, 0.0, lines[line]}, normal / glm::length(normal)};
  };
  for (int segment = 0; segment < segments; ++segment) {
    for (std::size_t line = 0; line + 1 < lines.size(); ++line) {
      add_cell({on_side(segment, line), on_side(segment + 1, line), on_side(segment + 1, line + 1),
                on_side(segment, line + 1)},
               texels, 0);
    }
    for (const double end : {-1.0, 1.0}) {
      const glm::dvec3 axis{0.0, 0.0, end};
      const std::size_t line = end < 0.0 ? 0 : lines.size() - 1;
      const auto on_end = [&](int of) {
        return Corner{(radius_m - bare_m()) * around(of) + half_m * axis, axis};
      };
      const int first = end > 0.0 ? segment : segment + 1;
      const int second = end > 0.0 ? segment + 1 : segment;
      add_cell({on_side(first, line), on_side(second, line), on_end(second), on_end(first)}, 1, 1);
      add({Corner{half_m * axis, axis}, on_end(first), on_end(second)}, 1, 1);
    }
  }
}

void Building::lay_out(const SphereShape& sphere) {
  check({sphere.diameter_m});
  const double radius_m = 0.5 * sphere.diameter_m;
  bend(radius_m);
  const double around_m = std::numbers::pi * sphere.diameter_m;
  const double periods = std::max(1.0, std::round(around_m / field_.width_m()));
  displacements_.push_back([=, this](const glm::dvec3&, const glm::dvec3& normal) {
    constexpr double kFades_rad = std::numbers::pi / 3.0;
    constexpr double kEnds_rad = std::numbers::pi * 75.0 / 180.0;
    const double w = glm::length(normal);
    const double latitude_rad = std::asin(std::clamp(normal.z / w, -1.0, 1.0));
    const double share =
        glm::smoothstep(0.0, 1.0, (kEnds_rad - std::abs(latitude_rad)) / (kEnds_rad - kFades_rad));
    const double turns = std::atan2(normal.y, normal.x) / (2.0 * std::numbers::pi);
    const double height =
        share > 0.0 ? share * height_m(turns * periods * field_.width_m(), latitude_rad * radius_m)
                    : 0.0;
    return (radius_m + height) / w - radius_m;
  });
  constexpr int kParts = 8;  // each face of an octahedron in 8² triangles
  // The sides of the middle ones are longer than an eighth of a quarter circle, by a factor below two.
  const int texels = texels_for(2.0 * around_m / 4.0 / kParts);
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {1.0, -1.0}) {
        const auto corner = [&](int i, int j) {
          const glm::dvec3 out = glm::normalize(glm::dvec3{x * i, y * j, z * (kParts - i - j)});
          return Corner{radius_m * out, out};
        };
        const bool mirrored = x * y * z < 0.0;
        const auto add_turned = [&](Corner a, Corner b, Corner c) {
          if (mirrored) std::swap(b, c);
          add({a, b, c}, texels, 0);
        };
        for (int j = 0; j < kParts; ++j) {
          for (int i = 0; i + j < kParts; ++i) {
            add_turned(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            if (i + j + 2 <= kParts) {
              add_turned(corner(i + 1, j + 1), corner(i, j + 1), corner(i + 1, j));
            }
          }
        }
      }
    }
  }
}

}  // namespace

TexturedMesh textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief) {
  Building building(field, relief);
  std::visit([&building](const auto& chosen) { building.lay_out(chosen); }, shape);
  building.require_few_texels();
  return building.fill();
}

void require_textured_shape(const Shape& shape, const HeightField& field,
                            const ShapeRelief& relief) {
  Building building(field, relief);
  std::visit([&building](const auto& chosen) { building.lay_out(chosen); }, shape);
  building.require_few_texels();
}

}  // namespace asperity
