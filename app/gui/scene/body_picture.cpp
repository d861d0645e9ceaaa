// Rasterises the triangles of a mesh, with normals from its displacements and weights in perspective.

#include "app/gui/scene/body_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

// Smaller deviations are steps of the displacements, not a relief.
constexpr double kLeastSlope = 2e-3;

// The level of the screen for a linear light from 0 to 1.
class Levels final {
 public:
  Levels() {
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const double value = static_cast<double>(i) / static_cast<double>(levels_.size() - 1);
      levels_[i] = static_cast<int>(255.0 * std::pow(value, 1.0 / 2.2) + 0.5);
    }
  }
  int of(double value) const noexcept {
    const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(levels_.size() - 1);
    return levels_[static_cast<std::size_t>(place + 0.5)];
  }

 private:
  std::array<int, 4096> levels_{};
};

// The change of a quantity of the corners over a step of a column and of a row: (first, second)·M⁻¹ with the texel
// coordinates M of both edges.
std::array<glm::dvec3, 2> along_texels(const glm::dmat2& inverse, const glm::dvec3& first,
                                       const glm::dvec3& second) {
  return {first * inverse[0][0] + second * inverse[0][1],
          first * inverse[1][0] + second * inverse[1][1]};
}

// Barycentric coordinates in a triangle of the plane; outside, one of the three is negative.
struct Barycentric {
  glm::dvec2 origin{};
  glm::dvec2 a{};
  glm::dvec2 b{};
  double inverse = 0.0;

  Barycentric(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2)
      : origin(p0), a(p1 - p0), b(p2 - p0) {
    const double area = a.x * b.y - a.y * b.x;
    inverse = area != 0.0 ? 1.0 / area : 0.0;
  }
  glm::dvec3 at(double x, double y) const {
    const glm::dvec2 d{x - origin.x, y - origin.y};
    const double second = (d.x * b.y - d.y * b.x) * inverse;
    const double third = (a.x * d.y - a.y * d.x) * inverse;
    return {1.0 - second - third, second, third};
  }
};

// 1 on a point of the pattern, 0 outside, without a jump between them.
double on_point(double first_m, double second_m) {
  const auto off = [](double x_m) { return x_m - nearest_pattern_point_m(x_m); };
  const double away_m = std::hypot(off(first_m), off(second_m));
  return std::clamp(1.5 - away_m / kPatternPoint_m, 0.0, 1.0);
}

}  // namespace

BodyBounds bounds_of(const TexturedMesh& mesh) noexcept {
  BodyBounds bounds{};
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const glm::dvec3& vertex = mesh.vertices_m[i];
    bounds.low_m = i == 0 ? vertex : glm::min(bounds.low_m, vertex);
    bounds.high_m = i == 0 ? vertex : glm::max(bounds.high_m, vertex);
  }
  return bounds;
}

BodyLayer::BodyLayer(QRect area, int fineness)
    : area_(area),
      fineness_(fineness),
      pixels_(area.size() * fineness, QImage::Format_ARGB32_Premultiplied) {
  pixels_.fill(0);
  nearness_.assign(
      static_cast<std::size_t>(pixels_.width()) * static_cast<std::size_t>(pixels_.height()), 0.0F);
}

QImage BodyLayer::image() const {
  if (fineness_ == 1) return pixels_;
  return pixels_.scaled(area_.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void BodyLayer::keep_covered(QImage& picture) const {
  for (int row = 0; row < picture.height(); ++row) {
    auto* const pixels = reinterpret_cast<QRgb*>(picture.scanLine(row));
    for (int column = 0; column < picture.width(); ++column) {
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(fineness_) *
                                 static_cast<std::size_t>(pixels_.width()) +
                             static_cast<std::size_t>(column) * static_cast<std::size_t>(fineness_);
      if (nearness_[at] <= 0.0F) pixels[column] = 0;
    }
  }
}

SeenBody::SeenBody(std::shared_ptr<const TexturedMesh> mesh, SurfaceLook look, const Colour& colour)
    : mesh_(std::move(mesh)), look_(look), colour_(colour), bounds_(bounds_of(*mesh_)) {
  faces_.resize(mesh_->triangles.size());
  if (look_ != SurfaceLook::relief) return;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const auto& places = mesh_->places[i];
    const auto& corners = mesh_->triangles[i];
    const glm::dmat2 texels(places[1] - places[0], places[2] - places[0]);
    const double area = glm::determinant(texels);
    // A face of a few texels has no relief. A face around an edge of the body is left out because the deviations of the
    // edge would make those of all other faces look small.
    if (std::abs(area) < 16.0 || bends_sharply(corners)) continue;
    const glm::dmat2 inverse = glm::inverse(texels);
    const auto over = [&](const std::vector<glm::dvec3>& of) {
      return along_texels(inverse, of[corners[1]] - of[corners[0]],
                          of[corners[2]] - of[corners[0]]);
    };
    faces_[i] = {over(mesh_->vertices_m), over(mesh_->normals), false};
    for (const glm::dvec3& weights :
         {glm::dvec3{1.0 / 3.0}, glm::dvec3{0.6, 0.3, 0.1}, glm::dvec3{0.2, 0.2, 0.6}}) {
      const glm::dvec3 deviation = deviation_at(i, weights);
      squares += glm::dot(deviation, deviation);
      ++count;
    }
  }
  const double rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
  exaggeration_ = rms > kLeastSlope ? kShownSlope / rms : 0.0;
}

bool SeenBody::bends_sharply(const std::array<std::uint32_t, 3>& corners) const {
  constexpr double kSharp = 0.74;  // the cosine of 42°
  const auto apart = [&](std::size_t i, std::size_t j) {
    return glm::dot(mesh_->normals[corners[i]], mesh_->normals[corners[j]]) < kSharp;
  };
  return apart(0, 1) || apart(1, 2) || apart(2, 0);
}

double SeenBody::displacement_m(double column, double row) const {
  const DisplacementAtlas& atlas = mesh_->atlas;
  const auto bounded = [](double place, std::size_t count) {
    return std::clamp(place, 0.0, static_cast<double>(count - 1) - 1e-9);
  };
  const double c = bounded(column, atlas.columns);
  const double r = bounded(row, atlas.rows);
  const auto c0 = static_cast<std::size_t>(c);
  const auto r0 = static_cast<std::size_t>(r);
  const double fc = c - static_cast<double>(c0);
  const double fr = r - static_cast<double>(r0);
  const auto at = [&atlas](std::size_t j, std::size_t i) {
    return static_cast<double>(atlas.values[j * atlas.columns + i]);
  };
  const std::size_t c1 = std::min(c0 + 1, atlas.columns - 1);
  const std::size_t r1 = std::min(r0 + 1, atlas.rows - 1);
  return atlas.step_m * ((1.0 - fr) * ((1.0 - fc) * at(r0, c0) + fc * at(r0, c1)) +
                         fr * ((1.0 - fc) * at(r1, c0) + fc * at(r1, c1)));
}

glm::dvec3 SeenBody::deviation_at(std::size_t face, const glm::dvec3& weights) const {
  const auto& corners = mesh_->triangles[face];
  const auto& places = mesh_->places[face];
  const glm::dvec3 normal = weights.x * mesh_->normals[corners[0]] +
                            weights.y * mesh_->normals[corners[1]] +
                            weights.z * mesh_->normals[corners[2]];
  const glm::dvec2 at = weights.x * places[0] + weights.y * places[1] + weights.z * places[2];
  const double here_m = displacement_m(at.x, at.y);
  const double column_m =
      0.5 * (displacement_m(at.x + 1.0, at.y) - displacement_m(at.x - 1.0, at.y));
  const double row_m = 0.5 * (displacement_m(at.x, at.y + 1.0) - displacement_m(at.x, at.y - 1.0));
  // The derivatives of the surface p + d·n from texel to texel: ∂p + ∂d·n + d·∂n. Their cross product is its normal.
  const Face& of = faces_[face];
  const glm::dvec3 first = of.along_texel_m[0] + column_m * normal + here_m * of.turn[0];
  const glm::dvec3 second = of.along_texel_m[1] + row_m * normal + here_m * of.turn[1];
  const glm::dvec3 across = glm::cross(first, second);
  const double length = glm::length(across);
  if (!(length > 0.0)) return glm::dvec3{0.0};
  const glm::dvec3 smooth = glm::normalize(normal);
  return (glm::dot(across, smooth) < 0.0 ? -across : across) / length - smooth;
}

glm::dvec3 SeenBody::normal_at(std::size_t face, const glm::dvec3& weights) const {
  const auto& corners = mesh_->triangles[face];
  const glm::dvec3 smooth = glm::normalize(weights.x * mesh_->normals[corners[0]] +
                                           weights.y * mesh_->normals[corners[1]] +
                                           weights.z * mesh_->normals[corners[2]]);
  if (faces_[face].is_flat || exaggeration_ == 0.0) return smooth;
  return glm::normalize(smooth + exaggeration_ * deviation_at(face, weights));
}

glm::dvec3 SeenBody::colour_at(std::size_t face, const glm::dvec3& weights,
                               const glm::dmat3& turn) const {
  const glm::dvec3 normal = normal_at(face, weights);
  glm::dvec3 colour = colour_ * workspace_light(turn * normal);
  if (look_ != SurfaceLook::pattern) return colour;
  const auto& corners = mesh_->triangles[face];
  const glm::dvec3 point_m = weights.x * mesh_->vertices_m[corners[0]] +
                             weights.y * mesh_->vertices_m[corners[1]] +
                             weights.z * mesh_->vertices_m[corners[2]];
  const glm::dvec3 facing = glm::abs(normal);
  const double most = std::max({facing.x, facing.y, facing.z});
  const double covered = facing.z == most   ? on_point(point_m.x, point_m.y)
                         : facing.x == most ? on_point(point_m.y, point_m.z)
                                            : on_point(point_m.x, point_m.z);
  // Points fade out before an edge, so that none continues around it.
  const double faces = std::clamp((most - 0.80) / 0.18, 0.0, 1.0);
  return colour * (1.0 - 0.45 * covered * faces);
}

void SeenBody::rasterise(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer,
                         bool colours) const {
  struct Corner {
    glm::dvec2 at{};
    double nearness = 0.0;
  };
  std::vector<Corner> corners(mesh_->vertices_m.size());
  const double fine = layer.fineness_;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 point_m = pose.rotation * mesh_->vertices_m[i] + pose.position_m;
    const QPointF at = camera.project(point_m);
    corners[i] = {{fine * (at.x() - layer.area_.x()), fine * (at.y() - layer.area_.y())},
                  camera.scale_at(point_m)};
  }
  const Levels levels{};
  const int width = layer.pixels_.width();
  const int height = layer.pixels_.height();
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const auto& of = mesh_->triangles[face];
    const Corner& a = corners[of[0]];
    const Corner& b = corners[of[1]];
    const Corner& c = corners[of[2]];
    const Barycentric inside(a.at, b.at, c.at);
    // Rows are counted downwards: counter-clockwise in the world is clockwise in the picture.
    if (!(inside.inverse < 0.0) || std::min({a.nearness, b.nearness, c.nearness}) <= 0.0) continue;
    const int left = std::max(0, static_cast<int>(std::floor(std::min({a.at.x, b.at.x, c.at.x}))));
    const int right =
        std::min(width - 1, static_cast<int>(std::ceil(std::max({a.at.x, b.at.x, c.at.x}))));
    const int top = std::max(0, static_cast<int>(std::floor(std::min({a.at.y, b.at.y, c.at.y}))));
    const int bottom =
        std::min(height - 1, static_cast<int>(std::ceil(std::max({a.at.y, b.at.y, c.at.y}))));
    for (int row = top; row <= bottom; ++row) {
      auto* const pixels = reinterpret_cast<QRgb*>(layer.pixels_.scanLine(row));
      for (int column = left; column <= right; ++column) {
        constexpr double kOnEdge = -1e-9;  // neighbours leave no gap
        const glm::dvec3 weights = inside.at(column + 0.5, row + 0.5);
        if (std::min({weights.x, weights.y, weights.z}) < kOnEdge) continue;
        const auto nearness = static_cast<float>(weights.x * a.nearness + weights.y * b.nearness +
                                                 weights.z * c.nearness);
        float& nearest =
            layer.nearness_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(column)];
        if (nearness <= nearest) continue;
        nearest = nearness;
        if (!colours) {
          pixels[column] = 0;
          continue;
        }
        // Perspective-correct interpolation: 1/depth is linear in the picture, weights are linear on the face.
        const glm::dvec3 on_face =
            glm::dvec3{weights.x * a.nearness, weights.y * b.nearness, weights.z * c.nearness} /
            static_cast<double>(nearness);
        const glm::dvec3 colour = colour_at(face, on_face, pose.rotation);
        pixels[column] = qRgb(levels.of(colour.r), levels.of(colour.g), levels.of(colour.b));
      }
    }
  }
}

void SeenBody::draw(const WorkspaceCamera& camera, const SeenPose& pose, BodyLayer& layer) const {
  rasterise(camera, pose, layer, true);
}

void SeenBody::hide_behind(const WorkspaceCamera& camera, const SeenPose& pose,
                           BodyLayer& layer) const {
  rasterise(camera, pose, layer, false);
}

QRect SeenBody::area(const WorkspaceCamera& camera, const SeenPose& pose) const {
  QRectF area{};
  for (const glm::dvec3& vertex : mesh_->vertices_m) {
    const QRectF at(camera.project(pose.rotation * vertex + pose.position_m), QSizeF(1e-6, 1e-6));
    area = area.isNull() ? at : area.united(at);
  }
  return area.toAlignedRect().adjusted(-1, -1, 1, 1) & QRect({0, 0}, camera.size());
}

SeenPatch seen_patch_of(const TexturedMesh& body, const SurfacePatch& patch) {
  const BodyBounds bounds = bounds_of(body);
  SeenPatch seen{.patch = patch};
  seen.patch.centre_m += glm::dvec3{0.5 * (bounds.low_m.x + bounds.high_m.x),
                                    0.5 * (bounds.low_m.y + bounds.high_m.y), bounds.high_m.z};
  seen.patch.extent_m = {bounds.high_m.x - bounds.low_m.x, bounds.high_m.y - bounds.low_m.y};
  seen.thickness_m = bounds.high_m.z - bounds.low_m.z;
  return seen;
}

QImage picture_of_body(const std::shared_ptr<const TexturedMesh>& mesh, int side_px) {
  const SeenPatch seen = seen_patch_of(*mesh, SurfacePatch{});
  const QSize size(side_px, side_px);
  const WorkspaceCamera camera(seen.patch, size, seen.thickness_m);
  BodyLayer layer(QRect(QPoint(0, 0), size), 2);
  SeenBody(mesh, SurfaceLook::relief, kSceneStone).draw(camera, {}, layer);
  return layer.image();
}

double lift_above_m(const TexturedMesh& tool, const SeenPose& tool_pose,
                    const TexturedMesh& surface, const glm::dvec3& surface_m, double most_m) {
  std::vector<glm::dvec3> corners_m{};
  corners_m.reserve(tool.vertices_m.size());
  BodyBounds reach{};
  for (const glm::dvec3& vertex : tool.vertices_m) {
    const glm::dvec3 at_m = tool_pose.rotation * vertex + tool_pose.position_m - surface_m;
    reach.low_m = corners_m.empty() ? at_m : glm::min(reach.low_m, at_m);
    reach.high_m = corners_m.empty() ? at_m : glm::max(reach.high_m, at_m);
    corners_m.push_back(at_m);
  }
  double lift_m = 0.0;
  for (const auto& [i, j, k] : surface.triangles) {
    const glm::dvec3& a = surface.vertices_m[i];
    const glm::dvec3& b = surface.vertices_m[j];
    const glm::dvec3& c = surface.vertices_m[k];
    const Barycentric inside({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
    // Only faces of the upper side that the tool is above.
    if (!(inside.inverse > 0.0) || std::max({a.x, b.x, c.x}) < reach.low_m.x ||
        std::min({a.x, b.x, c.x}) > reach.high_m.x || std::max({a.y, b.y, c.y}) < reach.low_m.y ||
        std::min({a.y, b.y, c.y}) > reach.high_m.y || std::max({a.z, b.z, c.z}) < reach.low_m.z) {
      continue;
    }
    for (const glm::dvec3& corner : corners_m) {
      const glm::dvec3 weights = inside.at(corner.x, corner.y);
      if (std::min({weights.x, weights.y, weights.z}) < 0.0) continue;
      const double below_m = weights.x * a.z + weights.y * b.z + weights.z * c.z - corner.z;
      if (below_m <= most_m) lift_m = std::max(lift_m, below_m);
    }
  }
  return lift_m;
}

}  // namespace asperity
