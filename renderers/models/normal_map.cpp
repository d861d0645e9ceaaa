// Implements the two maps of normals.

#include "renderers/models/normal_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

constexpr double kSlopePerGreyLevel = 0.01;
constexpr double kWhite = 255.0;

/// The index in [0, count) of a texel with a whole number as its coordinate.
std::size_t texel_index(double coordinate, std::size_t count, Tiling tiling) noexcept {
  const auto texels = static_cast<double>(count);
  double index = coordinate;
  switch (tiling) {
    case Tiling::bounded:
      break;
    case Tiling::repeat:
      index -= texels * std::floor(index / texels);
      break;
    case Tiling::mirror:
      index -= 2.0 * texels * std::floor(index / (2.0 * texels));
      index = std::min(index, 2.0 * texels - 1.0 - index);
      break;
  }
  return static_cast<std::size_t>(std::clamp(index, 0.0, texels - 1.0));
}

/// The normals of a picture of heights, each computed where it is looked up.
class GreyLevelMap final {
 public:
  GreyLevelMap(std::shared_ptr<const HeightField> field, double bits)
      : field_(std::move(field)),
        levels_(std::exp2(bits) - 1.0),
        zero_(std::exp2(bits - 1.0)),
        lowest_m_(field_->minimum_m()) {
    const double range_m = field_->maximum_m() - lowest_m_;
    if (range_m > 0.0) levels_per_m_ = levels_ / range_m;
  }

  glm::dvec2 slope(double x_m, double y_m, Tiling tiling) const noexcept {
    const HeightField::Grid& grid = field_->grid();
    const double u = x_m / grid.pitch_m + 0.5 * static_cast<double>(grid.columns - 1);
    const double v = 0.5 * static_cast<double>(grid.rows - 1) - y_m / grid.pitch_m;
    const double first_u = std::floor(u);
    const double first_v = std::floor(v);
    // The four texels around the point and their neighbours.
    std::array<std::array<double, 4>, 4> grey{};
    std::array<std::size_t, 4> columns{};
    for (std::size_t j = 0; j < 4; ++j) {
      columns[j] = texel_index(first_u + static_cast<double>(j) - 1.0, grid.columns, tiling);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const float* const row_m =
          field_->heights_m().data() +
          grid.columns * texel_index(first_v + static_cast<double>(i) - 1.0, grid.rows, tiling);
      for (std::size_t j = 0; j < 4; ++j) grey[i][j] = grey_level(row_m[columns[j]]);
    }
    const std::array<double, 2> weight_u{1.0 - (u - first_u), u - first_u};
    const std::array<double, 2> weight_v{1.0 - (v - first_v), v - first_v};
    glm::dvec3 normal{0.0};
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        // Rows count downwards, y upwards.
        normal +=
            weight_v[i] * weight_u[j] *
            stored({grey[i + 1][j + 2] - grey[i + 1][j], grey[i][j + 1] - grey[i + 2][j + 1]});
      }
    }
    return {-normal.x / normal.z, -normal.y / normal.z};
  }

 private:
  double grey_level(float height_m) const noexcept {
    const double level = (static_cast<double>(height_m) - lowest_m_) * levels_per_m_;
    return std::floor(level + 0.5) * kWhite / levels_;
  }

  /// The normal of a texel whose neighbours differ by `rise` grey levels along x and y, as it is stored and read again.
  glm::dvec3 stored(const glm::dvec2& rise) const noexcept {
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3(-kSlopePerGreyLevel * rise.x, -kSlopePerGreyLevel * rise.y, 1.0));
    return (glm::floor(zero_ + (zero_ - 1.0) * normal) - zero_) / (zero_ - 1.0);
  }

  std::shared_ptr<const HeightField> field_;
  double levels_ = 255.0;  // of the picture, less one
  double zero_ = 128.0;    // the stored number of a component 0
  double lowest_m_ = 0.0;
  double levels_per_m_ = 0.0;
};

class NormalMap final : public ForceRenderer {
 public:
  explicit NormalMap(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        map_(inputs.height_field, number_of(inputs.parameters, "bits")),
        height_scale_(number_of(inputs.parameters, "height_scale")),
        physical_(choice_of(inputs.parameters, "law") == "physical") {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const glm::dvec2 slope = height_scale_ * slope_at(point);
    const double upright_N = contact_.material().stiffness_N_per_m * penetration_m /
                             std::sqrt(1.0 + glm::dot(slope, slope));
    return contact_.force(point, probe,
                          {.texture_N = {-upright_N * slope.x, -upright_N * slope.y, upright_N},
                           .normal_N = upright_N,
                           .penetration_m = penetration_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  glm::dvec2 slope_at(const PatchPoint& point) const noexcept {
    const Tiling tiling = contact_.patch().tiling;
    if (!physical_) return map_.slope(point.x_m, point.y_m, tiling);
    const HeightSample h = field_->sample(point.x_m, point.y_m, tiling);
    return contact_.patch().motion_scale * glm::dvec2(h.slope_x, h.slope_y);
  }

  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  GreyLevelMap map_;
  double height_scale_ = 1.0;
  bool physical_ = false;
};

}  // namespace

ForceModel normal_map_model() {
  ModelDeclaration declaration{
      .id = "normal_map",
      .version = "2",
      .summary =
          phrase("Models",
                 "A flat plate whose force is turned by a map of normals, as in haptic frameworks"),
      .source = "CHAI3D 3.3, cNormalMap: a normal map from the grey levels of a picture",
      .needs_height_field = true,
      .amplitude_parameter = "height_scale",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      choice_parameter(
          "law", {"grey_level", "physical"},
          phrase("Models",
                 "grey_level: slope 0.01 for each of 255 grey levels between neighbouring texels, "
                 "as in the source; physical: the slope of the heights in metres")),
      number_parameter("height_scale", "1", 0.0, 100.0, 1.0,
                       phrase("Models", "Factor applied to the slopes of the map")),
      {.name = "bits",
       .kind = ParameterKind::integer,
       .unit = "1",
       .minimum = 4.0,  // with fewer, the third component of a steep normal is stored as 0
       .maximum = 24.0,
       .choices = {},
       .default_value = 8.0,
       .meaning = phrase(
           "Models",
           "Law grey_level only: bits of a grey level and of a stored component; 8 as in the "
           "source, 24 for practically no rounding")}};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<NormalMap>(inputs);
          },
          .suggested_by = {},
          .band = band_of_height_field,
          .band_formula = kBandOfHeightField};
}

}  // namespace asperity
