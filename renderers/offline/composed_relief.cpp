// Implements the composition of two textured bodies to one relief.

#include "renderers/offline/composed_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"

namespace asperity {
namespace {

constexpr int kRows = 9;  // enough for differences across the stroke

void require_some(const char* name, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(std::string("TipStroke::") + name + " must be positive, but it is " +
                              number_text(value));
}

TexturedMesh gained(const GainedBody& body) {
  if (!(body.gain >= 0.0) || !std::isfinite(body.gain)) {
    throw std::invalid_argument("GainedBody::gain must not be negative, but it is " +
                                number_text(body.gain));
  }
  TexturedMesh mesh = body.mesh;
  mesh.atlas.step_m *= body.gain;
  return mesh;
}

/// An odd number of samples, so that one lies at the origin and the samples of two grids coincide.
SamplingGrid grid_around(double half_width_m, double cell_m) {
  const int samples = 2 * static_cast<int>(std::ceil(half_width_m / cell_m)) + 1;
  return {.width_m = samples * cell_m, .samples = samples};
}

/// The side of a body that faces the other one, sampled over a square about the frame's origin.
class Side final {
 public:
  Side(const TexturedMesh& mesh, const ContactFrame& frame, const SamplingGrid& grid, Facing facing)
      : samples_(grid.samples) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    SampledSurface sampled = sample_surface({.mesh = mesh, .triangles = all}, frame, grid, facing);
    heights_m_ = std::move(sampled.height_m);
    for (std::size_t i = 0; i < heights_m_.size(); ++i) {
      if (sampled.covered[i] == 0) heights_m_[i] = kNowhere;
    }
  }
  int half() const noexcept { return samples_ / 2; }
  /// The height at an index relative to the middle; NaN where the body has no surface.
  double height_m(int column, int row) const noexcept {
    const int x = column + half();
    const int y = row + half();
    if (x < 0 || y < 0 || x >= samples_ || y >= samples_) return kNowhere;
    return heights_m_[static_cast<std::size_t>(y) * static_cast<std::size_t>(samples_) +
                      static_cast<std::size_t>(x)];
  }
  double highest_m() const noexcept {
    double highest_m = -std::numeric_limits<double>::infinity();
    for (const double height_m : heights_m_) highest_m = std::fmax(highest_m, height_m);
    return highest_m;
  }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  int samples_ = 0;
  std::vector<double> heights_m_{};
};

/// One sample of the tool's lower side: its column and row relative to the tip and its height above the tip.
struct Underside {
  int column = 0;
  int row = 0;
  double height_m = 0.0;
};

std::vector<Underside> lowest_first(const Side& tool) {
  std::vector<Underside> underside;
  for (int row = -tool.half(); row <= tool.half(); ++row) {
    for (int column = -tool.half(); column <= tool.half(); ++column) {
      const double height_m = tool.height_m(column, row);
      if (!std::isnan(height_m)) underside.push_back({column, row, height_m});
    }
  }
  std::sort(underside.begin(), underside.end(), [](const Underside& one, const Underside& other) {
    return one.height_m < other.height_m;
  });
  return underside;
}

/// The height of the vertex of a parabola through three samples above the middle one, if the middle one is the highest.
double above_middle_m(double before_m, double middle_m, double after_m) {
  const double bend_m = before_m - 2.0 * middle_m + after_m;
  return bend_m < 0.0 ? -(after_m - before_m) * (after_m - before_m) / (8.0 * bend_m) : 0.0;
}

/// The height of the tool on the surface at one position, by its first contact point, with parabolic interpolation
/// between samples. nullopt if there is no surface under the tool.
class Meeting final {
 public:
  Meeting(const Side& tool, const Side& surface)
      : tool_(tool),
        surface_(surface),
        underside_(lowest_first(tool)),
        highest_m_(surface.highest_m()) {}

  std::optional<double> height_m(int column, int row) const {
    const Underside* first = nullptr;
    double highest_m = -std::numeric_limits<double>::infinity();
    for (const Underside& at : underside_) {
      if (highest_m_ - at.height_m <= highest_m) break;  // nor do the samples above it
      const double here_m = surface_.height_m(column + at.column, row + at.row) - at.height_m;
      if (!(here_m > highest_m)) continue;
      highest_m = here_m;
      first = &at;
    }
    if (first == nullptr) return std::nullopt;
    const auto beside_m = [&](int columns, int rows) {
      const int x = first->column + columns;
      const int y = first->row + rows;
      return surface_.height_m(column + x, row + y) - tool_.height_m(x, y);
    };
    return highest_m + above_middle_m(beside_m(-1, 0), highest_m, beside_m(1, 0)) +
           above_middle_m(beside_m(0, -1), highest_m, beside_m(0, 1));
  }

 private:
  const Side& tool_;
  const Side& surface_;
  std::vector<Underside> underside_;
  double highest_m_ = 0.0;
};

}  // namespace

HeightField composed_relief(const GainedBody& tool, const GainedBody& surface,
                            const TipStroke& stroke) {
  require_some("length_m", stroke.length_m);
  require_some("cell_m", stroke.cell_m);
  const TexturedMesh held = gained(tool);
  const TexturedMesh touched = gained(surface);
  const double along_x = std::cos(stroke.direction_rad);
  const double along_y = std::sin(stroke.direction_rad);
  // The tool does not turn with the stroke; the frame in which both bodies are sampled does.
  const ContactFrame frame{.u = {along_x, along_y, 0.0}, .v = {-along_y, along_x, 0.0}};

  double half_width_m = 0.0;
  for (const glm::dvec3& vertex_m : held.vertices_m) {
    half_width_m = std::max(half_width_m, std::hypot(vertex_m.x, vertex_m.y));
  }
  const double cell_m = std::max({stroke.cell_m, 2.0 * half_width_m / kMostAcross,
                                  (stroke.length_m + 2.0 * half_width_m) / kMostAlong});
  const double cells = std::max(1.0, std::round(stroke.pitch_m / cell_m));
  const double pitch_m = cells * cell_m;
  const int most_half_columns =
      std::clamp(static_cast<int>(std::floor(0.5 * stroke.length_m / pitch_m)), kRows / 2,
                 (kMostColumns - 1) / 2);
  const auto step = static_cast<int>(cells);
  const Side under(held, frame, grid_around(half_width_m, cell_m), Facing::against_n);
  const Side upper(touched, frame, grid_around(most_half_columns * pitch_m + half_width_m, cell_m),
                   Facing::along_n);
  const Meeting meeting(under, upper);
  // Columns are computed from the middle outwards until the tool has no surface under it.
  using Column = std::array<float, kRows>;
  const auto column_at = [&](int column) -> std::optional<Column> {
    Column heights_m{};
    for (int row = 0; row < kRows; ++row) {
      const auto height_m = meeting.height_m(step * column, step * (kRows / 2 - row));
      if (!height_m) return std::nullopt;
      heights_m[static_cast<std::size_t>(row)] =
          static_cast<float>(*height_m);  // the top row first
    }
    return heights_m;
  };
  std::deque<Column> columns;
  if (const auto middle = column_at(0)) columns.push_back(*middle);
  for (int half = 1; !columns.empty() && half <= most_half_columns; ++half) {
    const std::optional<Column> left = column_at(-half);
    const std::optional<Column> right = column_at(half);
    if (!left || !right) break;
    columns.push_front(*left);
    columns.push_back(*right);
  }
  if (columns.size() < static_cast<std::size_t>(kRows)) {
    throw std::invalid_argument(
        "there is no surface under the middle of the strokes of the tool; place the surface there");
  }
  std::vector<float> heights_m;
  heights_m.reserve(kRows * columns.size());
  for (std::size_t row = 0; row < kRows; ++row) {
    for (const Column& column : columns) heights_m.push_back(column[row]);
  }
  return {{.rows = static_cast<std::size_t>(kRows), .columns = columns.size(), .pitch_m = pitch_m},
          std::move(heights_m)};
}

}  // namespace asperity
