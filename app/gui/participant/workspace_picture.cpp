#include "app/gui/participant/workspace_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <QtGui/QPainter>
#include <QtGui/QPolygonF>
#include <glm/geometric.hpp>

#include "app/gui/participant/body_picture.h"

namespace asperity {

namespace {

constexpr double kElevation_rad = 48.0 * std::numbers::pi / 180.0;
constexpr double kDistance = 2.6;     // of the eye, in patches: how strong the perspective is
constexpr double kThickness = 0.07;   // of the slab, in patches
constexpr double kCorner = 0.035;     // radius of its corners, in patches
constexpr double kBevel = 0.010;      // of its upper edge, in patches
const glm::dvec3 kLight = glm::normalize(glm::dvec3{-0.50, 0.42, 0.76});
const glm::dvec3 kSlab{0.80, 0.775, 0.735};  // its colour, linear: a pale, warm stone

double larger_extent(const SurfacePatch& patch) {
  return std::max(patch.extent_m.x, patch.extent_m.y);
}

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Distance from a rectangle with round corners: negative inside.
double distance_to_slab(const SurfacePatch& patch, double x_m, double y_m) {
  const double radius_m = kCorner * larger_extent(patch);
  const double dx = std::abs(x_m) - 0.5 * patch.extent_m.x + radius_m;
  const double dy = std::abs(y_m) - 0.5 * patch.extent_m.y + radius_m;
  const double out_x = std::max(dx, 0.0);
  const double out_y = std::max(dy, 0.0);
  return std::sqrt(out_x * out_x + out_y * out_y) + std::min(std::max(dx, dy), 0.0) - radius_m;
}

/// Outward, in the plane.
glm::dvec3 away_from_slab(const SurfacePatch& patch, double x_m, double y_m) {
  const double step_m = 1e-4 * larger_extent(patch);
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
/// 0 to 1, even over any few pixels, so that a slow gradient shows no steps: the golden ratio in
/// two dimensions.
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
  return kSlab * (workspace_light(normal) * openness);
}

class Painter final {
 public:
  Painter(const WorkspaceCamera& camera, const WorkspacePicture& picture)
      : camera_(camera),
        patch_(camera.patch()),
        size_m_(larger_extent(camera.patch())),
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
    // Rows of the picture are further apart on a surface that is seen at a slant.
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
      // Four samples in a pixel: a relief finer than the picture becomes even, not coarse.
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
      const auto nearest = [](double x_m) {
        return kPatternSpacing_m * (std::floor(x_m / kPatternSpacing_m) + 0.5);
      };
      const glm::dvec3 point{nearest(at.x), nearest(at.y), 0.0};
      // No point is cut by the edge.
      if (distance_to_slab(patch_, point.x, point.y) > -0.3 * kPatternSpacing_m) return colour;
      const double away_m = glm::length(glm::dvec3{at.x - point.x, at.y - point.y, 0.0});
      const double covered =
          smoothstep(0.7 * footprint_m, -0.7 * footprint_m, away_m - kPatternPoint_m);
      colour *= 1.0 - 0.45 * covered;
    }
    return colour;
  }

  /// The upper edge is rounded off: it catches the light.
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
    // The slab as a stack of thin ones: the wall is the first that the ray meets, and covers the
    // pixel as far as any of them does.
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
    // The shadow lies away from the light; it is dark and narrow beside the slab, faint further off.
    const double away_m = 0.9 * camera_.thickness_m();
    const double cast = distance_to_slab(patch_, at.x + away_m * kLight.x / kLight.z,
                                         at.y + away_m * kLight.y / kLight.z) /
                        size_m_;
    const double close = distance_to_slab(patch_, at.x, at.y) / size_m_;
    const double shade = 0.34 * smoothstep(0.09, -0.03, cast) + 0.30 * std::exp(-close / 0.018);
    // The table darkens a little towards the borders of the picture.
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

/// The table alone, darker towards the borders of the picture.
QImage draw_table(const WorkspaceCamera& camera, const QColor& ground,
                  const std::stop_token& stop) {
  const glm::dvec3 colour{linear(ground.redF()), linear(ground.greenF()), linear(ground.blueF())};
  const double size_m = larger_extent(camera.patch());
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

/// The mean over 5 × 5 pixels, three times: no corner of a box is left to see.
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

/// Where a body keeps the lamp's light from the table, dark beneath it and faint further off.
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
        lamp.softness * larger_extent(camera.patch()) * camera.scale_at(camera.patch().centre_m);
    // Softened on a smaller picture of it, where a box of five is as wide as the edge is soft.
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
  const SeenBody body(picture.body, picture.look, kSlab);
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

double workspace_light(const glm::dvec3& normal) {
  const double direct = std::max(0.0, glm::dot(normal, kLight));
  // The rest of the light comes from all around, most of it from above.
  const double around = 0.68 + 0.32 * normal.z;
  return 0.33 * around + 0.69 * direct;
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

WorkspaceCamera::WorkspaceCamera(const SurfacePatch& patch, QSize size)
    : WorkspaceCamera(patch, size, kThickness * larger_extent(patch)) {}

WorkspaceCamera::WorkspaceCamera(const SurfacePatch& patch, QSize size, double thickness_m)
    : patch_(patch), size_(size), thickness_m_(thickness_m) {
  const double extent_m = larger_extent(patch);
  eye_m_ =
      kDistance * extent_m * glm::dvec3{0.0, -std::cos(kElevation_rad), std::sin(kElevation_rad)};
  // Fit the slab, and a little more above it for the tool, into the picture.
  QRectF seen{};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z_m : {-thickness_m_, 0.22 * extent_m}) {
        const QPointF at =
            project(patch.centre_m + glm::dvec3{x * patch.extent_m.x, y * patch.extent_m.y, z_m});
        if (z_m > 0.0 && y < 0.0) continue;  // the tool covers the front of the slab
        seen = seen.isNull() ? QRectF(at, QSizeF(1e-9, 1e-9))
                             : seen.united(QRectF(at, QSizeF(1e-9, 1e-9)));
      }
    }
  }
  constexpr double kFilled = 0.84;
  focal_px_ = kFilled * std::min(size.width() / seen.width(), size.height() / seen.height());
  centre_px_ = QPointF(0.5 * size.width(), 0.5 * size.height()) - focal_px_ * seen.center();
}

double WorkspaceCamera::thickness_m() const noexcept { return thickness_m_; }

double WorkspaceCamera::scale_at(const glm::dvec3& point_m) const noexcept {
  const glm::dvec3 from_eye = point_m - patch_.centre_m - eye_m_;
  return focal_px_ /
         (from_eye.y * std::cos(kElevation_rad) - from_eye.z * std::sin(kElevation_rad));
}

QPointF WorkspaceCamera::project(const glm::dvec3& point_m) const noexcept {
  const glm::dvec3 from_eye = point_m - patch_.centre_m - eye_m_;
  const double up = from_eye.y * std::sin(kElevation_rad) + from_eye.z * std::cos(kElevation_rad);
  const double scale = scale_at(point_m);
  return centre_px_ + QPointF(scale * from_eye.x, -scale * up);
}

glm::dvec3 WorkspaceCamera::point_at(QPointF pixel, double z_m) const noexcept {
  const double right = (pixel.x() - centre_px_.x()) / focal_px_;
  const double up = -(pixel.y() - centre_px_.y()) / focal_px_;
  const double s = std::sin(kElevation_rad);
  const double c = std::cos(kElevation_rad);
  const glm::dvec3 ray{right, c + up * s, up * c - s};
  // A ray that does not go down meets the plane nowhere: far away.
  const double way = ray.z < -1e-3 ? (z_m - eye_m_.z) / ray.z : (z_m - eye_m_.z) / -1e-3;
  return eye_m_ + way * ray;
}

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
