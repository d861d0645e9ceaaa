// Implements the hull, thickness and queries of a textured body.

#include "renderers/pd_gradient/contact/textured_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace asperity {
namespace {

double checked_gain(double gain) {
  if (!(gain >= 0.0) || !std::isfinite(gain)) {
    throw std::invalid_argument("TexturedBody: gain is " + std::to_string(gain) +
                                "; it must be at least 0.");
  }
  return gain;
}

TriangleMesh plain(const TexturedMesh& mesh) {
  return {.vertices_m = mesh.vertices_m, .triangles = mesh.triangles};
}

/// With one texel of 0 for all faces: what a gain of 0 makes of every texture, in little memory.
TexturedMesh without_texture(const TexturedMesh& mesh) {
  return {.vertices_m = mesh.vertices_m,
          .normals = mesh.normals,
          .triangles = mesh.triangles,
          .places = std::vector<std::array<glm::dvec2, 3>>(mesh.triangles.size()),
          .atlas = {.rows = 1, .columns = 1, .step_m = 0.0, .values = {0}}};
}

TriangleMesh hull_of(const TexturedMesh& mesh, double outward_m) {
  TriangleMesh hull = plain(mesh);
  for (std::size_t i = 0; i < hull.vertices_m.size(); ++i) {
    hull.vertices_m[i] += outward_m * mesh.normals[i];
  }
  return hull;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

bool is_inside(const std::array<glm::dvec2, 3>& corners, const glm::dvec2& place) {
  bool left = true;
  bool right = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = cross(corners[(i + 1) % 3] - corners[i], place - corners[i]);
    left = left && side >= 0.0;
    right = right && side <= 0.0;
  }
  return left || right;
}

/// Computes the lowest and the highest displacement of the faces, without their margins. A margin continues its face
/// and may exceed it: the texels beyond a crest that is cut by an edge lie above it.
class Relief final {
 public:
  Relief(const TexturedMesh& mesh, double gain) : atlas_(mesh.atlas), gain_(gain) {
    for (const auto& places : mesh.places) add(places);
  }
  double low_m() const { return std::min(gain_ * low_m_, gain_ * high_m_); }
  double high_m() const { return std::max(gain_ * low_m_, gain_ * high_m_); }

 private:
  // The displacement is bilinear between texels, without a maximum inside a cell. Its maximum is therefore at a texel
  // of the face or on the border, where it is quadratic between the lines of texels.
  void add(const std::array<glm::dvec2, 3>& places) {
    const auto first = texel(glm::ceil(glm::min(glm::min(places[0], places[1]), places[2])));
    const auto last = texel(glm::floor(glm::max(glm::max(places[0], places[1]), places[2])));
    for (double y = first.y; y <= last.y; y += 1.0) {
      for (double x = first.x; x <= last.x; x += 1.0) {
        if (is_inside(places, {x, y})) add(height_m({x, y}));
      }
    }
    for (std::size_t i = 0; i < 3; ++i) add_edge(places[i], places[(i + 1) % 3]);
  }
  void add_edge(const glm::dvec2& from, const glm::dvec2& to) {
    std::vector<double> parts{0.0, 1.0};  // of the edge, at lines of texels
    for (const int axis : {0, 1}) {
      const double way = to[axis] - from[axis];
      const double last = texel(glm::floor(glm::max(from, to)))[axis];
      for (double line = texel(glm::ceil(glm::min(from, to)))[axis]; line <= last; line += 1.0) {
        if (way != 0.0) parts.push_back(std::clamp((line - from[axis]) / way, 0.0, 1.0));
      }
    }
    std::sort(parts.begin(), parts.end());
    const auto at = [&](double part) { return height_m(from + part * (to - from)); };
    add(at(0.0));
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const double begin_m = at(parts[i - 1]);
      const double end_m = at(parts[i]);
      const double bulge_m = at(0.5 * (parts[i - 1] + parts[i])) - 0.5 * (begin_m + end_m);
      add(end_m);
      // begin + (end − begin)·t + 4·bulge·t·(1 − t), with its extremum at `top`.
      if (bulge_m == 0.0) continue;
      const double top = 0.5 + (end_m - begin_m) / (8.0 * bulge_m);
      if (top > 0.0 && top < 1.0) add(begin_m + 4.0 * bulge_m * top * top);
    }
  }
  void add(double height_m) {
    low_m_ = std::min(low_m_, height_m);
    high_m_ = std::max(high_m_, height_m);
  }
  // The nearest position within the atlas.
  glm::dvec2 texel(const glm::dvec2& place) const {
    return glm::clamp(
        place, glm::dvec2(0.0),
        glm::dvec2(static_cast<double>(atlas_.columns - 1), static_cast<double>(atlas_.rows - 1)));
  }
  double height_m(const glm::dvec2& place) const {
    const glm::dvec2 inside = texel(place);
    const auto [column, right, x] = cell(inside.x, atlas_.columns);
    const auto [row, below, y] = cell(inside.y, atlas_.rows);
    const auto along = [this, from = column, to = right, share = x](std::size_t of_row) {
      const std::int16_t* values = atlas_.values.data() + of_row * atlas_.columns;
      return (1.0 - share) * values[from] + share * values[to];
    };
    return atlas_.step_m * ((1.0 - y) * along(row) + y * along(below));
  }
  struct Cell {
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0.0;
  };
  static Cell cell(double place, std::size_t texels) {
    const auto first = static_cast<std::size_t>(place);
    return {first, std::min(first + 1, texels - 1), place - static_cast<double>(first)};
  }

  const DisplacementAtlas& atlas_;
  double gain_ = 1.0;
  double low_m_ = std::numeric_limits<double>::infinity();
  double high_m_ = -std::numeric_limits<double>::infinity();
};

/// The thickness across each of the largest faces, from its plane to the farthest vertices; the smallest of them.
double thickness_m(const TriangleMesh& mesh) {
  constexpr std::size_t kFaces = 256;
  struct Face {
    glm::dvec3 area{0.0};
    double size = 0.0;
  };
  std::vector<Face> faces;
  faces.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 area = glm::cross(mesh.vertices_m[b] - mesh.vertices_m[a],
                                       mesh.vertices_m[c] - mesh.vertices_m[a]);
    faces.push_back({area, glm::length(area)});
  }
  // Stable, so that equal faces are selected reproducibly.
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& one, const Face& other) { return one.size > other.size; });
  if (faces.size() > kFaces) faces.resize(kFaces);
  double least_m = std::numeric_limits<double>::infinity();
  for (const Face& face : faces) {
    if (!(face.size > 0.0)) continue;
    const glm::dvec3 normal = face.area / face.size;
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    for (const glm::dvec3& vertex_m : mesh.vertices_m) {
      const double along_m = glm::dot(normal, vertex_m);
      low_m = std::min(low_m, along_m);
      high_m = std::max(high_m, along_m);
    }
    least_m = std::min(least_m, high_m - low_m);
  }
  return least_m;
}

/// The intersection of a ray, from a point along a unit vector, with a face.
struct Crossing {
  double way_m = std::numeric_limits<double>::infinity();  // not behind the point
  bool is_out = false;
};

// A ray through an edge intersects both faces.
Crossing crossing(const std::array<glm::dvec3, 3>& corners_m, const glm::dvec3& point_m,
                  const glm::dvec3& along) noexcept {
  constexpr double kRounding = 1e-9;
  const glm::dvec3 area = glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
  const double facing = glm::dot(along, area);
  if (!(std::abs(facing) > kRounding * glm::length(area))) return {};
  const double way_m = glm::dot(area, corners_m[0] - point_m) / facing;
  if (!(way_m >= 0.0)) return {};
  const glm::dvec3 place_m = point_m + way_m * along;
  const double least = -kRounding * glm::dot(area, area);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 edge_m = corners_m[(i + 1) % 3] - corners_m[i];
    if (!(glm::dot(area, glm::cross(edge_m, place_m - corners_m[i])) >= least)) return {};
  }
  return {.way_m = way_m, .is_out = facing > 0.0};
}

/// A lower bound of the distance of a face from the origin.
double clearance_m(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) noexcept {
  const glm::dvec3 low_m = glm::min(a, glm::min(b, c));
  const glm::dvec3 high_m = glm::max(a, glm::max(b, c));
  const double from_box_m = glm::length(glm::max(glm::dvec3(0.0), glm::max(low_m, -high_m)));
  const glm::dvec3 area = glm::cross(b - a, c - a);
  const double length = glm::length(area);
  return length > 0.0 ? std::max(from_box_m, std::abs(glm::dot(area, a)) / length) : from_box_m;
}

}  // namespace

TexturedBody::TexturedBody(const TexturedMesh& textured, double gain) {
  require_sound(textured);
  const bool is_smooth = checked_gain(gain) == 0.0;
  const TexturedMesh smooth = is_smooth ? without_texture(textured) : TexturedMesh{};
  const TexturedMesh& mesh = is_smooth ? smooth : textured;
  surface_ = std::make_shared<const PackedSurface>(mesh, gain);
  plain_clusters_ = std::make_shared<const ClusteredMesh>(plain(mesh));
  const Relief relief(mesh, gain);
  hull_ = std::make_shared<const TriangleMesh>(hull_of(mesh, std::max(0.0, relief.high_m())));
  hull_clusters_ = std::make_shared<const ClusteredMesh>(*hull_);
  furthest_m_ = std::max(std::abs(relief.low_m()), std::abs(relief.high_m()));
  waves_ = fine_waves_of(mesh, gain);
  thickness_m_ = asperity::thickness_m(*hull_);
}

std::size_t TexturedBody::bytes() const noexcept {
  return surface_->bytes() + std::as_bytes(std::span(hull_->vertices_m)).size() +
         std::as_bytes(std::span(hull_->triangles)).size() + hull_clusters_->bytes() +
         plain_clusters_->bytes();
}

std::size_t TexturedBody::find_triangles(const ContactFrame& frame, const glm::dvec3& facing,
                                         const WindowBox& box,
                                         std::span<std::uint32_t> room) const noexcept {
  const SlabBox slabs =
      plain_clusters_->slab_box({.centre_m = frame.origin_m,
                                 .axes = {frame.u, frame.v, frame.n},
                                 .half_m = {box.half_width_m, box.half_width_m, box.half_height_m},
                                 .facing = facing});
  std::size_t found = 0;
  const std::span<const TriangleCluster> clusters = plain_clusters_->clusters();
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    for (std::uint32_t left = plain_clusters_->find_in_box(i, slabs); left != 0; left &= left - 1) {
      if (found < room.size()) room[found] = clusters[i].triangles[std::countr_zero(left)];
      ++found;
    }
  }
  return found;
}

WayOut TexturedBody::way_out(const glm::dvec3& point_m, const glm::dvec3& along,
                             double most_m) const noexcept {
  constexpr double kRounding_m = 1e-7;  // of boxes, which are in single precision
  double out_m = std::numeric_limits<double>::infinity();
  double in_m = out_m;
  const glm::dvec3 half_way_m = 0.5 * most_m * along;
  const glm::dvec3 middle_m = point_m + half_way_m - plain_clusters_->centre_m();
  const glm::dvec3 reach_m = glm::abs(half_way_m) + kRounding_m;
  const std::span<const TriangleCluster> clusters = plain_clusters_->clusters();
  // Of a box among sixteen; that of an unused lane is empty.
  const auto is_apart = [&](const auto& boxes, std::size_t lane) {
    for (int axis = 0; axis < 3; ++axis) {
      if (boxes.low[axis][lane] > middle_m[axis] + reach_m[axis] ||
          boxes.high[axis][lane] < middle_m[axis] - reach_m[axis]) {
        return true;
      }
    }
    return false;
  };
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (is_apart(plain_clusters_->boxes()[i / kClusterSize], i % kClusterSize)) continue;
    for (std::size_t place = 0; place < kClusterSize; ++place) {
      if (is_apart(clusters[i], place)) continue;
      const Crossing met =
          crossing(plain_clusters_->corners_m(clusters[i].triangles[place]), point_m, along);
      double& nearest_m = met.is_out ? out_m : in_m;
      nearest_m = std::min(nearest_m, met.way_m);
    }
  }
  return {.way_m = std::min(out_m, most_m), .is_inside = out_m <= most_m && out_m < in_m};
}

// Half the sum of the solid angles of all faces, as seen from the point [Van Oosterom 1983].
Whereabouts TexturedBody::whereabouts(const glm::dvec3& point_m) const noexcept {
  double half_angles_rad = 0.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : hull_->triangles) {
    const glm::dvec3 a = hull_->vertices_m[i] - point_m;
    const glm::dvec3 b = hull_->vertices_m[j] - point_m;
    const glm::dvec3 c = hull_->vertices_m[k] - point_m;
    nearest_m = std::min(nearest_m, clearance_m(a, b, c));
    const double a_m = glm::length(a);
    const double b_m = glm::length(b);
    const double c_m = glm::length(c);
    half_angles_rad +=
        std::atan2(glm::dot(a, glm::cross(b, c)), a_m * b_m * c_m + glm::dot(a, b) * c_m +
                                                      glm::dot(b, c) * a_m + glm::dot(c, a) * b_m);
  }
  return {.is_inside = half_angles_rad > std::numbers::pi, .clear_m = nearest_m};
}

}  // namespace asperity
