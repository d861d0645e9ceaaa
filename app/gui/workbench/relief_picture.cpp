// Averages the field down to a mesh, and fills its triangles with diffuse light.

#include "app/gui/workbench/relief_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <QtGui/QPainter>
#include <QtGui/QPolygonF>
#include <glm/geometric.hpp>

namespace asperity {

namespace {

constexpr double kTallest = 1.0 / 12.0;  // of the width
constexpr double kSteepest_rms = 0.6;
constexpr double kBase = 0.035;  // thickness of the slab below the lowest point, of the width
const glm::vec3 kStone{226.0F, 219.0F, 208.0F};

/// The largest of 1, 2, 5, 10 … that is no larger than `limit`; 1 at least.
double round_factor(double limit) {
  double factor = 1.0;
  while (true) {
    for (const double next : {2.0, 5.0, 10.0}) {
      if (factor * next > limit) {
        return next == 2.0 ? factor : factor * (next == 5.0 ? 2.0 : 5.0);
      }
    }
    factor *= 10.0;
    if (factor >= 1e6) return factor;
  }
}

/// One pixel of every sample it covers, averaged.
void average_down(const HeightField& field, ReliefMesh& mesh) {
  const HeightField::Grid& grid = field.grid();
  mesh.heights_m.reserve(mesh.rows * mesh.columns);
  for (std::size_t i = 0; i < mesh.rows; ++i) {
    const std::size_t top = i * grid.rows / mesh.rows;
    const std::size_t bottom = std::max(top + 1, (i + 1) * grid.rows / mesh.rows);
    for (std::size_t j = 0; j < mesh.columns; ++j) {
      const std::size_t left = j * grid.columns / mesh.columns;
      const std::size_t right = std::max(left + 1, (j + 1) * grid.columns / mesh.columns);
      float sum_m = 0.0F;
      for (std::size_t row = top; row < bottom; ++row) {
        const float* values = field.heights_m().data() + row * grid.columns;
        for (std::size_t column = left; column < right; ++column) sum_m += values[column];
      }
      const auto count = static_cast<float>((bottom - top) * (right - left));
      mesh.heights_m.push_back(sum_m / count - static_cast<float>(field.mean_m()));
    }
  }
}

/// Slopes by central differences, one-sided at the border.
template <class Use>
void for_each_slope(const ReliefMesh& mesh, const Use& use) {
  const auto step_x_m = static_cast<float>(mesh.width_m / static_cast<double>(mesh.columns));
  const auto step_y_m = static_cast<float>(mesh.length_m / static_cast<double>(mesh.rows));
  for (std::size_t i = 0; i < mesh.rows; ++i) {
    const std::size_t up = i > 0 ? i - 1 : i;
    const std::size_t down = std::min(i + 1, mesh.rows - 1);
    for (std::size_t j = 0; j < mesh.columns; ++j) {
      const std::size_t left = j > 0 ? j - 1 : j;
      const std::size_t right = std::min(j + 1, mesh.columns - 1);
      const float* h = mesh.heights_m.data();
      const float rise_x_m = h[i * mesh.columns + right] - h[i * mesh.columns + left];
      const float rise_y_m = h[up * mesh.columns + j] - h[down * mesh.columns + j];
      use(i * mesh.columns + j, rise_x_m / (step_x_m * static_cast<float>(right - left)),
          rise_y_m / (step_y_m * static_cast<float>(down - up)));
    }
  }
}

/// The limits and the normals of its heights.
void complete(ReliefMesh& mesh) {
  const auto [low, high] = std::minmax_element(mesh.heights_m.begin(), mesh.heights_m.end());
  mesh.lowest_m = static_cast<double>(*low);
  mesh.highest_m = static_cast<double>(*high);
  for_each_slope(mesh, [&mesh](std::size_t index, float slope_x, float slope_y) {
    mesh.normals[index] = glm::normalize(glm::vec3{-slope_x, -slope_y, 1.0F});
  });
}

struct Vertex {
  float x = 0.0F;
  float y = 0.0F;
  glm::vec3 color{};
};

std::uint32_t packed(const glm::vec3& color) {
  const auto channel = [](float value) {
    return static_cast<std::uint32_t>(std::clamp(value, 0.0F, 255.0F));
  };
  return 0xFF000000U | channel(color.r) << 16U | channel(color.g) << 8U | channel(color.b);
}

struct Canvas {
  std::uint32_t* pixels = nullptr;
  int width = 0;
  int height = 0;
};

/// Fills the pixels whose centre lies inside, whichever way round the corners are.
void fill_triangle(const Canvas& canvas, const Vertex& a, const Vertex& b, const Vertex& c) {
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (std::abs(area) < 1e-6F) return;
  const float low_x = std::min({a.x, b.x, c.x});
  const float high_x = std::max({a.x, b.x, c.x});
  const float low_y = std::min({a.y, b.y, c.y});
  const float high_y = std::max({a.y, b.y, c.y});
  const int first_x = std::max(0, static_cast<int>(std::ceil(low_x - 0.5F)));
  const int last_x = std::min(canvas.width - 1, static_cast<int>(std::floor(high_x - 0.5F)));
  const int first_y = std::max(0, static_cast<int>(std::ceil(low_y - 0.5F)));
  const int last_y = std::min(canvas.height - 1, static_cast<int>(std::floor(high_y - 0.5F)));
  if (first_x > last_x || first_y > last_y) return;
  const float one = 1.0F / area;
  // Barycentric weights of b and c, and what they gain by a step to the right.
  const float u_step = (c.y - a.y) * one;
  const float v_step = (a.y - b.y) * one;
  constexpr float kSlack = -1e-4F;  // neighbours share an edge: better twice than not at all
  for (int y = first_y; y <= last_y; ++y) {
    const float py = static_cast<float>(y) + 0.5F - a.y;
    const float px = static_cast<float>(first_x) + 0.5F - a.x;
    float u = (px * (c.y - a.y) - py * (c.x - a.x)) * one;
    float v = (py * (b.x - a.x) - px * (b.y - a.y)) * one;
    std::uint32_t* row = canvas.pixels + static_cast<std::ptrdiff_t>(y) * canvas.width;
    for (int x = first_x; x <= last_x; ++x, u += u_step, v += v_step) {
      if (u < kSlack || v < kSlack || u + v > 1.0F - kSlack) continue;
      row[x] = packed(a.color + u * (b.color - a.color) + v * (c.color - a.color));
    }
  }
}

glm::vec3 light_direction(const ReliefLook& look) {
  return {static_cast<float>(std::cos(look.light_elevation_rad) * std::cos(look.light_azimuth_rad)),
          static_cast<float>(std::cos(look.light_elevation_rad) * std::sin(look.light_azimuth_rad)),
          static_cast<float>(std::sin(look.light_elevation_rad))};
}

/// Matt stone: some light from everywhere, the lamp, and a little darkness in what lies low.
glm::vec3 shade(const glm::vec3& normal, const glm::vec3& light, float share_of_height) {
  const float lamp = std::max(0.0F, glm::dot(normal, light));
  const float sky = 0.5F + 0.5F * normal.z;
  return kStone * ((0.30F * sky + 1.0F * lamp) * (0.82F + 0.18F * share_of_height));
}

double x_of(const ReliefMesh& mesh, std::size_t column) {
  return ((static_cast<double>(column) + 0.5) / static_cast<double>(mesh.columns) - 0.5) *
         mesh.width_m;
}

double y_of(const ReliefMesh& mesh, std::size_t row) {
  return (0.5 - (static_cast<double>(row) + 0.5) / static_cast<double>(mesh.rows)) * mesh.length_m;
}

/// A border of the relief, from its heights down to the base.
void draw_wall(QPainter& painter, const ReliefMesh& mesh, const ReliefProjection& projection,
               const std::vector<glm::dvec3>& border, const glm::dvec2& outwards,
               const ReliefLook& look) {
  const double base_m = mesh.lowest_m - kBase * mesh.width_m;
  QPolygonF outline{};
  for (const glm::dvec3& point : border) outline << projection.on_screen(point);
  outline << projection.on_screen({border.back().x, border.back().y, base_m})
          << projection.on_screen({border.front().x, border.front().y, base_m});
  const glm::vec3 normal{static_cast<float>(outwards.x), static_cast<float>(outwards.y), 0.0F};
  // A cut face is smooth and throws back more light than its shade would tell.
  const float lamp = std::max(0.0F, glm::dot(normal, light_direction(look)));
  const glm::vec3 color = kStone * (0.48F + 0.30F * lamp);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor::fromRgb(packed(color)));
  painter.drawPolygon(outline);
}

}  // namespace

ReliefMesh relief_mesh(const HeightField& field, std::size_t longest_side) {
  const HeightField::Grid& grid = field.grid();
  const double factor = std::min(1.0, static_cast<double>(longest_side) /
                                          static_cast<double>(std::max(grid.rows, grid.columns)));
  const auto side = [factor](std::size_t samples) {
    return std::max<std::size_t>(
        2, static_cast<std::size_t>(std::llround(factor * static_cast<double>(samples))));
  };
  ReliefMesh mesh{.rows = side(grid.rows),
                  .columns = side(grid.columns),
                  .width_m = field.width_m(),
                  .length_m = field.length_m()};
  average_down(field, mesh);

  double squares = 0.0;
  for_each_slope(mesh, [&squares](std::size_t, float slope_x, float slope_y) {
    squares += static_cast<double>(slope_x * slope_x + slope_y * slope_y);
  });
  const double slope_rms = std::sqrt(squares / static_cast<double>(mesh.heights_m.size()));
  const auto [low, high] = std::minmax_element(mesh.heights_m.begin(), mesh.heights_m.end());
  const auto range_m = static_cast<double>(*high - *low);
  if (range_m > 0.0) {
    mesh.exaggeration =
        round_factor(std::min(kTallest * mesh.width_m / range_m, kSteepest_rms / slope_rms));
  }
  for (float& height_m : mesh.heights_m) height_m *= static_cast<float>(mesh.exaggeration);
  mesh.normals.resize(mesh.heights_m.size());
  complete(mesh);
  return mesh;
}

ReliefMesh pressed_in(const ReliefMesh& mesh, const SurfaceDent& dent) {
  ReliefMesh pressed = mesh;
  for (std::size_t i = 0; i < mesh.rows; ++i) {
    for (std::size_t j = 0; j < mesh.columns; ++j) {
      pressed.heights_m[i * mesh.columns + j] -=
          static_cast<float>(mesh.exaggeration * dent.depth_at({x_of(mesh, j), y_of(mesh, i)}));
    }
  }
  complete(pressed);
  // The slab below stays as thick as without the dent.
  pressed.lowest_m = mesh.lowest_m;
  pressed.highest_m = mesh.highest_m;
  return pressed;
}

ReliefProjection::ReliefProjection(const ReliefLook& look, double width_m, double length_m,
                                   QSize size)
    : cos_turn_(std::cos(look.turn_rad)),
      sin_turn_(std::sin(look.turn_rad)),
      cos_tilt_(std::cos(look.tilt_rad)),
      sin_tilt_(std::sin(look.tilt_rad)),
      half_m_(0.5 * width_m, 0.5 * length_m) {
  // Between the circle through the corners, which nothing leaves, and a tight fit that would
  // breathe while the relief turns: the middle, with the corners at the picture's border.
  const double across_m = std::hypot(width_m, length_m);
  const double tall_m = across_m * sin_tilt_ + 0.14 * width_m * cos_tilt_;
  scale_ = look.zoom * 0.98 *
           std::min(static_cast<double>(size.width()) / across_m,
                    static_cast<double>(size.height()) / tall_m);
  centre_ = {0.5 * size.width(), 0.5 * size.height()};
}

QPointF ReliefProjection::on_screen(const glm::dvec3& point_m) const noexcept {
  const double right = cos_turn_ * point_m.x - sin_turn_ * point_m.y;
  const double away = sin_turn_ * point_m.x + cos_turn_ * point_m.y;
  return centre_ + scale_ * QPointF(right, -(away * sin_tilt_ + point_m.z * cos_tilt_));
}

std::optional<glm::dvec2> ReliefProjection::on_surface(QPointF screen) const noexcept {
  const QPointF from_centre = (screen - centre_) / scale_;
  const double right = from_centre.x();
  const double away = -from_centre.y() / sin_tilt_;
  const glm::dvec2 point_m{cos_turn_ * right + sin_turn_ * away,
                           -sin_turn_ * right + cos_turn_ * away};
  if (std::abs(point_m.x) > half_m_.x || std::abs(point_m.y) > half_m_.y) return std::nullopt;
  return point_m;
}

QImage draw_relief(const ReliefMesh& mesh, const ReliefLook& look, QSize size) {
  QImage picture(size, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  const ReliefProjection projection(look, mesh.width_m, mesh.length_m, size);
  const glm::vec3 light = light_direction(look);
  const double range_m = mesh.highest_m - mesh.lowest_m;
  const auto per_m = static_cast<float>(range_m > 0.0 ? 1.0 / range_m : 0.0);
  const auto lowest_m = static_cast<float>(mesh.lowest_m);

  // Positions are linear in column and row: one projection for the origin and each step.
  const QPointF origin = projection.on_screen({x_of(mesh, 0), y_of(mesh, 0), 0.0});
  const QPointF across = projection.on_screen({x_of(mesh, 1), y_of(mesh, 0), 0.0}) - origin;
  const QPointF down = projection.on_screen({x_of(mesh, 0), y_of(mesh, 1), 0.0}) - origin;
  const auto up = static_cast<float>(projection.on_screen({0.0, 0.0, 1.0}).y() -
                                     projection.on_screen({0.0, 0.0, 0.0}).y());
  std::vector<Vertex> vertices(mesh.heights_m.size());
  for (std::size_t i = 0; i < mesh.rows; ++i) {
    for (std::size_t j = 0; j < mesh.columns; ++j) {
      const std::size_t index = i * mesh.columns + j;
      const QPointF flat = origin + static_cast<double>(j) * across + static_cast<double>(i) * down;
      const float height_m = mesh.heights_m[index];
      vertices[index] = {
          static_cast<float>(flat.x()), static_cast<float>(flat.y()) + up * height_m,
          shade(mesh.normals[index], light, std::max(0.0F, (height_m - lowest_m) * per_m))};
    }
  }

  const Canvas canvas{reinterpret_cast<std::uint32_t*>(picture.bits()), size.width(),
                      size.height()};
  // Farther away is higher up in the picture before heights are added.
  const bool rows_forward = down.y() >= 0.0;
  const bool columns_forward = across.y() >= 0.0;
  for (std::size_t row = 0; row + 1 < mesh.rows; ++row) {
    const std::size_t i = rows_forward ? row : mesh.rows - 2 - row;
    for (std::size_t column = 0; column + 1 < mesh.columns; ++column) {
      const std::size_t j = columns_forward ? column : mesh.columns - 2 - column;
      const Vertex* corner = vertices.data() + i * mesh.columns + j;
      fill_triangle(canvas, corner[0], corner[1], corner[mesh.columns]);
      fill_triangle(canvas, corner[1], corner[mesh.columns], corner[mesh.columns + 1]);
    }
  }

  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto at = [&mesh](std::size_t row, std::size_t column) {
    return glm::dvec3{x_of(mesh, column), y_of(mesh, row),
                      static_cast<double>(mesh.heights_m[row * mesh.columns + column])};
  };
  std::array<std::vector<glm::dvec3>, 4> borders{};
  for (std::size_t j = 0; j < mesh.columns; ++j) {
    borders[0].push_back(at(0, j));
    borders[1].push_back(at(mesh.rows - 1, j));
  }
  for (std::size_t i = 0; i < mesh.rows; ++i) {
    borders[2].push_back(at(i, 0));
    borders[3].push_back(at(i, mesh.columns - 1));
  }
  const std::array<glm::dvec2, 4> outwards{{{0.0, 1.0}, {0.0, -1.0}, {-1.0, 0.0}, {1.0, 0.0}}};
  for (std::size_t k = 0; k < borders.size(); ++k) {
    // A wall is seen when its outward direction points down the picture.
    const double drop = projection.on_screen({outwards[k].x, outwards[k].y, 0.0}).y() -
                        projection.on_screen({0.0, 0.0, 0.0}).y();
    if (drop > 0.0) draw_wall(painter, mesh, projection, borders[k], outwards[k], look);
  }
  return picture;
}

}  // namespace asperity
