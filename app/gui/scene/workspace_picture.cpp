// Shades each pixel of the slab by the slope of its relief, with dithering and soft shadows.

#include "app/gui/scene/workspace_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <QtGui/QPainter>
#include <QtGui/QPolygonF>
#include <glm/geometric.hpp>

#include "app/gui/scene/body_picture.h"

namespace asperity {
namespace {

constexpr double kCorner = 0.035;  // radius of the slab's corners, in patches
constexpr double kBevel = 0.010;   // of its upper edge, in patches

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// The signed distance from a rectangle with rounded corners, negative inside: that from the rectangle without its
// corners' radius, less the radius.
double distance_to_slab(const SurfacePatch& patch, double x_m, double y_m) {
  const double radius_m = kCorner * larger_extent_m(patch);
  const double dx = std::abs(x_m) - 0.5 * patch.extent_m.x + radius_m;
  const double dy = std::abs(y_m) - 0.5 * patch.extent_m.y + radius_m;
  const double out_x = std::max(dx, 0.0);
  const double out_y = std::max(dy, 0.0);
  return std::sqrt(out_x * out_x + out_y * out_y) + std::min(std::max(dx, dy), 0.0) - radius_m;
}

// The outward normal of the slab's outline, by central differences of the distance.
glm::dvec3 away_from_slab(const SurfacePatch& patch, double x_m, double y_m) {
  const double step_m = 1e-4 * larger_extent_m(patch);
  const glm::dvec3 gradient{
      distance_to_slab(patch, x_m + step_m, y_m) - distance_to_slab(patch, x_m - step_m, y_m),
      distance_to_slab(patch, x_m, y_m + step_m) - distance_to_slab(patch, x_m, y_m - step_m), 0.0};
  const double length = glm::length(gradient);
  return length > 0.0 ? gradient / length : glm::dvec3{0.0, -1.0, 0.0};
}

double linear(double level) { return std::pow(level, 2.2); }
int level_of(double value, double dither) {
  return static_cast<int>(
      std::floor(255.0 * std::pow(std::clamp(value, 0.0, 1.0), 1.0 / 2.2) + dither));
}
// From 0 to 1, uniform over any small group of pixels, so that a slow gradient shows no steps: the additive sequence of
// the plastic number, which extends that of the golden ratio to two dimensions.
double dither_at(int column, int row) {
  const double sum = 0.7548776662 * column + 0.5698402910 * row;
  return sum - std::floor(sum);
}

struct Relief {
  const HeightField* field = nullptr;
  SurfacePatch patch{};
  double exaggeration = 1.0;
  double rms_m = 1.0;

  HeightSample at(double x_m, double y_m) const {
    return field->sample(patch.motion_scale * x_m, patch.motion_scale * y_m, patch.tiling);
  }
};

Relief prepare_relief(const HeightField& field, const SurfacePatch& patch) {
  Relief relief{.field = &field, .patch = patch};
  constexpr int kSide = 64;
  double slopes = 0.0;
  double heights = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const HeightSample sample = relief.at(patch.extent_m.x * ((i % kSide + 0.5) / kSide - 0.5),
                                          patch.extent_m.y * ((i / kSide + 0.5) / kSide - 0.5));
    slopes += sample.slope_x * sample.slope_x + sample.slope_y * sample.slope_y;
    heights += (sample.height_m - field.mean_m()) * (sample.height_m - field.mean_m());
  }
  const double rms_slope = std::sqrt(slopes / (kSide * kSide));
  relief.exaggeration = rms_slope > 0.0 ? kShownSlope / rms_slope : 0.0;
  relief.rms_m = std::max(std::sqrt(heights / (kSide * kSide)), 1e-12);
  return relief;
}

glm::dvec3 lit(const glm::dvec3& normal, double openness) {
  return kSceneStone * (workspace_light(normal) * openness);
}

class Painter final {
 public:
  Painter(const WorkspaceCamera& camera, const WorkspacePicture& picture)
      : camera_(camera),
        patch_(camera.patch()),
        size_m_(larger_extent_m(camera.patch())),
        look_(picture.look),
        ground_{linear(picture.ground.redF()), linear(picture.ground.greenF()),
                linear(picture.ground.blueF())} {
    if (look_ == SurfaceLook::relief && picture.relief) {
      relief_ = prepare_relief(*picture.relief, patch_);
    }
  }

  glm::dvec3 colour_at(double column, double row) const {
    const QPointF pixel(column, row);
    const glm::dvec3 top = camera_.point_at(pixel, 0.0);
    const double pixel_m = 1.0 / camera_.scale_at(patch_.centre_m + top);
    // On an inclined surface the rows of the picture are further apart.
    const double footprint_m = pixel_m / std::sin(kElevation_rad);
    const double inside =
        smoothstep(0.5, -0.5, distance_to_slab(patch_, top.x, top.y) / footprint_m);
    if (inside >= 1.0) return surface(top, footprint_m);
    const glm::dvec3 beside = wall_or_table(pixel, pixel_m);
    return inside <= 0.0 ? beside : glm::mix(beside, surface(top, footprint_m), inside);
  }

 private:
  glm::dvec3 surface(const glm::dvec3& at, double footprint_m) const {
    glm::dvec3 colour{0.0};
    if (relief_.field != nullptr) {
      // Four samples per pixel, so that a relief finer than the picture is averaged.
      constexpr std::array<std::array<double, 2>, 4> kPlaces = {
          {{-0.375, -0.125}, {0.125, -0.375}, {0.375, 0.125}, {-0.125, 0.375}}};
      for (const auto& place : kPlaces) {
        const HeightSample sample =
            relief_.at(at.x + place[0] * footprint_m, at.y + place[1] * footprint_m);
        const double height =
            std::clamp((sample.height_m - relief_.field->mean_m()) / relief_.rms_m, -2.0, 2.0);
        glm::dvec3 normal{-relief_.exaggeration * sample.slope_x,
                          -relief_.exaggeration * sample.slope_y, 1.0};
        colour += 0.25 * lit(bevelled(glm::normalize(normal), at), 1.0 + 0.07 * height);
      }
      return colour;
    }
    colour = lit(bevelled({0.0, 0.0, 1.0}, at), 1.0);
    if (look_ == SurfaceLook::pattern) {
      const glm::dvec3 point{nearest_pattern_point_m(at.x), nearest_pattern_point_m(at.y), 0.0};
      // Points that the edge would cut are left out.
      if (distance_to_slab(patch_, point.x, point.y) > -0.3 * kPatternSpacing_m) return colour;
      const double away_m = glm::length(glm::dvec3{at.x - point.x, at.y - point.y, 0.0});
      const double covered =
          smoothstep(0.7 * footprint_m, -0.7 * footprint_m, away_m - kPatternPoint_m);
      colour *= 1.0 - 0.45 * covered;
    }
    return colour;
  }

  // The upper edge is rounded, so that it reflects the light.
  glm::dvec3 bevelled(const glm::dvec3& normal, const glm::dvec3& at) const {
    const double from_edge = -distance_to_slab(patch_, at.x, at.y) / (kBevel * size_m_);
    if (from_edge >= 1.0) return normal;
    const double tilt = 1.0 - std::max(from_edge, 0.0);
    return glm::normalize(normal + 0.9 * tilt * tilt * away_from_slab(patch_, at.x, at.y));
  }

  glm::dvec3 wall_or_table(const QPointF& pixel, double pixel_m) const {
    const glm::dvec3 table = table_at(camera_.point_at(pixel, -camera_.thickness_m()));
    const glm::dvec3 middle = camera_.point_at(pixel, -0.5 * camera_.thickness_m());
    if (distance_to_slab(patch_, middle.x, middle.y) > camera_.thickness_m()) return table;
    // The slab as a stack of thin slabs: the wall is the first one that the ray meets, and its coverage of the pixel the
    // largest of all.
    constexpr int kLayers = 24;
    double nearest = std::numeric_limits<double>::infinity();
    bool met = false;
    double depth = 1.0;
    glm::dvec3 place{};
    for (int layer = 0; layer <= kLayers; ++layer) {
      const double way = static_cast<double>(layer) / kLayers;
      const glm::dvec3 at = camera_.point_at(pixel, -way * camera_.thickness_m());
      const double distance = distance_to_slab(patch_, at.x, at.y);
      if (!met && (distance <= 0.0 || distance < nearest)) {
        depth = way;
        place = at;
      }
      met = met || distance <= 0.0;
      nearest = std::min(nearest, distance);
    }
    const double covered = smoothstep(0.5, -0.5, nearest / pixel_m);
    if (covered <= 0.0) return table;
    const glm::dvec3 normal = away_from_slab(patch_, place.x, place.y);
    const glm::dvec3 wall = lit(normal, 0.98 - 0.30 * depth * depth);
    return glm::mix(table, wall, covered);
  }

  glm::dvec3 table_at(const glm::dvec3& at) const {
    // The shadow is opposite to the light, dark and narrow near the slab, faint at a distance.
    const double away_m = 0.9 * camera_.thickness_m();
    const double cast = distance_to_slab(patch_, at.x + away_m * kLight.x / kLight.z,
                                         at.y + away_m * kLight.y / kLight.z) /
                        size_m_;
    const double close = distance_to_slab(patch_, at.x, at.y) / size_m_;
    const double shade = 0.34 * smoothstep(0.09, -0.03, cast) + 0.30 * std::exp(-close / 0.018);
    // The table is slightly darker towards the borders of the picture.
    const double off = glm::length(at) / size_m_;
    return ground_ * ((1.0 - 0.10 * smoothstep(0.5, 1.8, off)) * (1.0 - std::min(shade, 0.62)));
  }

  const WorkspaceCamera& camera_;
  SurfacePatch patch_{};
  double size_m_ = 1.0;
  SurfaceLook look_ = SurfaceLook::plain;
  glm::dvec3 ground_{1.0};
  Relief relief_{};
};

// The table without an object, darker towards the borders of the picture.
QImage draw_table(const WorkspaceCamera& camera, const QColor& ground,
                  const std::stop_token& stop) {
  const glm::dvec3 colour{linear(ground.redF()), linear(ground.greenF()), linear(ground.blueF())};
  const double size_m = larger_extent_m(camera.patch());
  QImage image(camera.size(), QImage::Format_RGB32);
  for (int row = 0; row < image.height() && !stop.stop_requested(); ++row) {
    auto* pixels = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const glm::dvec3 at = camera.point_at({column + 0.5, row + 0.5}, -camera.thickness_m());
      const double light = 1.0 - 0.10 * smoothstep(0.5, 1.8, glm::length(at) / size_m);
      const double dither = dither_at(column, row);
      pixels[column] = qRgb(level_of(colour.r * light, dither), level_of(colour.g * light, dither),
                            level_of(colour.b * light, dither));
    }
  }
  return image;
}

// The mean over 5 × 5 pixels, three times, which hides the corners of the box.
QImage softened(QImage mask) {
  constexpr int kReach = 2;
  const int width = mask.width();
  const int height = mask.height();
  for (int pass = 0; pass < 6; ++pass) {
    const bool along_rows = pass % 2 == 0;
    QImage smoother(mask.size(), QImage::Format_Alpha8);
    for (int row = 0; row < height; ++row) {
      uchar* const line = smoother.scanLine(row);
      for (int column = 0; column < width; ++column) {
        int sum = 0;
        for (int off = -kReach; off <= kReach; ++off) {
          const int at_row = along_rows ? row : std::clamp(row + off, 0, height - 1);
          const int at_column = along_rows ? std::clamp(column + off, 0, width - 1) : column;
          sum += mask.constScanLine(at_row)[at_column];
        }
        line[column] = static_cast<uchar>((sum + kReach) / (2 * kReach + 1));
      }
    }
    mask = std::move(smoother);
  }
  return mask;
}

// The shadow of a body on the table, dark below it and faint at a distance.
void draw_shadow(QPainter& painter, const WorkspaceCamera& camera,
                 const WorkspacePicture& picture) {
  const double table_m = camera.patch().centre_m.z - camera.thickness_m();
  // Two lamps: the one of the picture, and the sky straight above it.
  struct Lamp {
    glm::dvec3 towards{};
    double darkness = 0.0;
    double softness = 0.0;  ///< of the shadow's edge, in patches
  };
  for (const Lamp& lamp : {Lamp{kLight, 0.36, 0.030}, Lamp{{0.0, 0.0, 1.0}, 0.28, 0.018}}) {
    QImage mask(camera.size(), QImage::Format_Alpha8);
    mask.fill(0);
    QPainter on_mask(&mask);
    on_mask.setPen(Qt::NoPen);
    on_mask.setBrush(Qt::black);
    for (const auto& triangle : picture.body->triangles) {
      QPolygonF seen{};
      for (const std::uint32_t corner : triangle) {
        const glm::dvec3 point = picture.body->vertices_m[corner] + picture.body_m;
        const double fall = (point.z - table_m) / lamp.towards.z;
        seen << camera.project(point - fall * lamp.towards);
      }
      on_mask.drawPolygon(seen);
    }
    on_mask.end();
    const double soft_px =
        lamp.softness * larger_extent_m(camera.patch()) * camera.scale_at(camera.patch().centre_m);
    // Softened on a smaller picture, in which a box of five pixels has the width of the soft edge.
    const QSize small =
        (QSizeF(mask.size()) / std::max(1.0, soft_px / 5.0)).toSize().expandedTo(QSize(1, 1));
    mask = softened(mask.scaled(small, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                        .convertToFormat(QImage::Format_Alpha8))
               .scaled(camera.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
               .convertToFormat(QImage::Format_Alpha8);
    QImage shade(camera.size(), QImage::Format_ARGB32_Premultiplied);
    shade.fill(Qt::black);
    shade.setAlphaChannel(mask);
    painter.setOpacity(lamp.darkness);
    painter.drawImage(0, 0, shade);
  }
  painter.setOpacity(1.0);
}

QImage draw_body(const WorkspaceCamera& camera, const WorkspacePicture& picture,
                 const std::stop_token& stop) {
  QImage image = draw_table(camera, picture.ground, stop);
  if (stop.stop_requested()) return {};
  const SeenBody body(picture.body, picture.look, kSceneStone);
  const SeenPose pose{.position_m = picture.body_m};
  constexpr int kFineness = 2;
  const QRect area = body.area(camera, pose);
  BodyLayer layer(area, kFineness);
  body.draw(camera, pose, layer);
  if (stop.stop_requested()) return {};
  QPainter painter(&image);
  draw_shadow(painter, camera, picture);
  painter.drawImage(area.topLeft(), layer.image());
  return image;
}

}  // namespace

QImage draw_workspace(const WorkspaceCamera& camera, const WorkspacePicture& picture,
                      const std::stop_token& stop) {
  if (picture.body) return draw_body(camera, picture, stop);
  const Painter painter(camera, picture);
  QImage image(camera.size(), QImage::Format_RGB32);
  for (int row = 0; row < image.height(); ++row) {
    if (stop.stop_requested()) return {};
    auto* pixels = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const glm::dvec3 colour = painter.colour_at(column + 0.5, row + 0.5);
      const double dither = dither_at(column, row);
      pixels[column] =
          qRgb(level_of(colour.r, dither), level_of(colour.g, dither), level_of(colour.b, dither));
    }
  }
  return image;
}

}  // namespace asperity
