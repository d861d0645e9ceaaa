// Implements the layout of the texture, the making of the renderer, and the drag.

#include "renderers/offline/roughness_stroke.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/spectrum.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/textured_shape.h"

namespace asperity {
namespace {

constexpr double kSpacings = 8.0;
constexpr double kDitheredSpacings = 16.0;
constexpr double kMostAlongRow = 64.0;
constexpr double kWholeSpacing = 1e-3;
constexpr double kStrokeSamplesPerSpacing = 64.0;
constexpr double kCoarsest_m = 30e-6;
constexpr std::size_t kMostPixels = 2048;
constexpr double kLongestStep_m = 1e-4;  // the declared default, which sessions render
constexpr double kStepsPerSpacing = 40.0;
// Next to the stroke the plate is as wide as the contact of any tool, and its relief rises from its edges.
constexpr double kPlateWidth_m = 0.010;
constexpr double kPlateBeyond_m = 0.006;
constexpr double kPlateRim_m = 0.002;
constexpr double kTexelsPerWave = 2.0;  // of the shortest wave, with two samples: one texel each
constexpr double kPlateThickness_m = 0.01;
constexpr double kLongestPlate_m = 0.25;

TextureAtSpacing stretched(const HeightField& relief, double spacing_m) {
  const std::optional<double> wavelength_m =
      dominant_wavelength_m({.heights_m = relief.heights_m(),
                             .rows = relief.grid().rows,
                             .columns = relief.grid().columns,
                             .pitch_m = relief.grid().pitch_m});
  if (!wavelength_m) {
    throw std::invalid_argument(
        "the relief is a plane and has no wavelength to be stretched; choose a height field with a "
        "texture");
  }
  HeightField::Grid grid = relief.grid();
  grid.pitch_m *= spacing_m / *wavelength_m;
  TextureAtSpacing texture{.field = std::make_shared<const HeightField>(grid, relief.heights_m()),
                           .tiling = Tiling::mirror,  // pictures do not repeat without a seam
                           .spacing_m = spacing_m};
  texture.repeats_after_m = 2.0 * texture.field->width_m();
  return texture;
}

/// The least width, in spacings, of at least kDitheredSpacings in which turned rows repeat without a seam: √(a² + b²) with
/// b/a the tangent of their angle.
double seamless_spacings(double angle_rad) {
  const double tangent = std::tan(angle_rad);
  for (double a = 1.0; a <= kMostAlongRow; ++a) {
    const double b = std::round(a * tangent);
    const double spacings = std::hypot(a, b);
    if (spacings >= kDitheredSpacings && std::abs(a * tangent - b) < kWholeSpacing) return spacings;
  }
  throw std::invalid_argument("cones: angle_rad is " + number_text(angle_rad) +
                              "; rows repeat without a seam if the tangent of their angle is a "
                              "ratio of whole numbers up to 64, "
                              "for example 0.643501 (3 to 4)");
}

bool declares(const std::vector<Parameter>& parameters, std::string_view name) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [name](const Parameter& one) { return one.name == name; });
}

// The length of the stroke with a record of a quarter of a second or sixteen spacings; that of the arc.
double plate_length_m(const RoughnessStroke& stroke, const TextureAtSpacing& texture) {
  if (stroke.turning) {
    const double quarter_rad = 0.5 * std::numbers::pi;
    return 2.0 * stroke.turning->radius_m *
               std::sin(std::min(stroke.turning->amplitude_rad, quarter_rad)) +
           2.0 * kPlateBeyond_m;
  }
  const double beginning_m =
      stroke.speed_m_per_s * beginning_s(stroke.hand, stroke.material.stiffness_N_per_m);
  const double record_m = std::max(0.25 * stroke.speed_m_per_s, 16.0 * texture.spacing_m);
  return std::min(kLongestPlate_m, beginning_m + record_m + 2.0 * kPlateBeyond_m);
}

// About the line of the stroke. An arc bends to one side of it.
double plate_width_m(const RoughnessStroke& stroke) {
  if (!stroke.turning) return kPlateWidth_m;
  return kPlateWidth_m +
         2.0 * stroke.turning->radius_m * (1.0 - std::cos(stroke.turning->amplitude_rad));
}

bool is_constant_across(const HeightField& field) {
  const HeightField::Grid& grid = field.grid();
  const std::vector<float>& heights_m = field.heights_m();
  return std::equal(heights_m.begin() + static_cast<std::ptrdiff_t>(grid.columns), heights_m.end(),
                    heights_m.begin());
}

void require_stroke(const RoughnessStroke& stroke, const TextureAtSpacing& texture) {
  const ModelDeclaration& declaration = stroke.model->declaration;
  if (stroke.body && declaration.needs_bodies) {
    throw std::invalid_argument("the force model " + declaration.id +
                                " is dragged over a plate with the texture; leave out the body, or "
                                "choose a model of a point");
  }
  if (!stroke.turning) return;
  const double amplitude_rad = stroke.turning->amplitude_rad;
  if (!(amplitude_rad > 0.0 && amplitude_rad <= std::numbers::pi)) {
    throw std::invalid_argument("Turning::amplitude_rad is " + number_text(amplitude_rad) +
                                "; it must be above 0 and at most pi");
  }
  if (stroke.body) {
    throw std::invalid_argument("a tool turns on a plane only; leave out the body or the turning");
  }
  if (declaration.needs_bodies && !stroke.tool && !is_constant_across(*texture.field)) {
    throw std::invalid_argument(
        "the texture varies across the stroke, where a turning tip of " + declaration.id +
        " is computed on one line only; choose a texture that is constant across the stroke, such "
        "as sinusoid, or a textured mesh as tool");
  }
}

}  // namespace

TextureAtSpacing texture_at_spacing(const SpacedTexture& texture, double spacing_m) {
  if (!(spacing_m > 0.0 && std::isfinite(spacing_m))) {
    throw std::invalid_argument("spacing_m must be positive, but it is " + number_text(spacing_m));
  }
  if (texture.relief) return stretched(*texture.relief, spacing_m);
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    if (surface.kind == texture.kind && !declares(surface.parameters, "spacing_m")) {
      throw std::invalid_argument(
          "the synthetic surface " + texture.kind +
          " has no spacing_m that could be varied; choose a kind that has one");
    }
  }
  ParameterValues values = texture.values;
  values["spacing_m"] = spacing_m;
  const bool has_rows = texture.kind == "cones";
  const auto angle = values.find("angle_rad");
  const double spacings = !has_rows ? kSpacings
                          : angle != values.end()
                              ? seamless_spacings(std::get<double>(angle->second))
                              : kDitheredSpacings;
  const double width_m = spacings * spacing_m;
  const double pitch_m = std::min(spacing_m / kStrokeSamplesPerSpacing, kCoarsest_m);
  const auto pixels =
      std::min(kMostPixels, static_cast<std::size_t>(std::lround(width_m / pitch_m)));
  return {.field = std::make_shared<const HeightField>(make_surface(
              texture.kind, values, {.width_m = width_m, .pixels = pixels, .seed = texture.seed})),
          .spacing_m = spacing_m,
          .repeats_after_m = width_m,
          .line_m = has_rows ? 0.5 * spacing_m : 0.0};  // even row counts are symmetric about 0
}

HeightField recorded_relief(const TextureAtSpacing& texture) {
  const HeightField& field = *texture.field;
  const HeightField::Grid& grid = field.grid();
  const auto copies =
      static_cast<std::size_t>(std::max(1.0, std::ceil(kRecordedWidth_m / field.width_m())));
  HeightField::Grid wide = grid;
  wide.columns = copies * grid.columns;
  std::vector<float> heights_m{};
  heights_m.reserve(wide.rows * wide.columns);
  for (std::size_t row = 0; row < grid.rows; ++row) {
    const auto first = field.heights_m().begin() + static_cast<std::ptrdiff_t>(row * grid.columns);
    const auto last = first + static_cast<std::ptrdiff_t>(grid.columns);
    for (std::size_t copy = 0; copy < copies; ++copy) {
      const bool is_mirrored = texture.tiling == Tiling::mirror && copy % 2 == 1;
      if (is_mirrored) {
        heights_m.insert(heights_m.end(), std::make_reverse_iterator(last),
                         std::make_reverse_iterator(first));
      } else {
        heights_m.insert(heights_m.end(), first, last);
      }
    }
  }
  return {wide, std::move(heights_m)};
}

RendererInputs stroked_inputs(const RoughnessStroke& stroke, const TextureAtSpacing& texture) {
  const ForceModel& model = *stroke.model;
  require_stroke(stroke, texture);
  RendererInputs inputs{.parameters = stroke.parameters,
                        .material = stroke.material,
                        .patch = {.centre_m = {0.0, -texture.line_m, 0.0},
                                  .extent_m = {1e3, 1e3},
                                  .tiling = texture.tiling},
                        .height_field = texture.field,
                        .assets = stroke.assets,
                        .asset_names = stroke.asset_names,
                        .seed = stroke.seed};
  const std::vector<AssetDeclaration>& files = model.declaration.assets;
  if (std::any_of(files.begin(), files.end(), [&](const AssetDeclaration& file) {
        return !stroke.assets.contains(file.role);
      })) {
    add_files_of_relief(inputs, model, recorded_relief(texture));
    for (const auto& [role, content] : stroke.assets) inputs.assets[role] = content;
    inputs.asset_names = stroke.asset_names;
  }
  if (stroke.body) {
    inputs.body = stroke.body;
    inputs.patch.centre_m = BodyGuide(stroke.body, texture.line_m).body_origin_m();
  }
  if (model.suggested_by) {
    ParameterValues suggested = model.suggested_by(*texture.field, stroke.material);
    if (declares(model.declaration.parameters, "wavelength_m")) {
      suggested["wavelength_m"] = texture.spacing_m;
    }
    inputs.parameters.merge(suggested);  // given values are kept
  }
  return inputs;
}

std::unique_ptr<ForceRenderer> stroked_renderer(const RoughnessStroke& stroke,
                                                const TextureAtSpacing& texture) {
  const ForceModel& model = *stroke.model;
  RendererInputs inputs = stroked_inputs(stroke, texture);
  if (!model.declaration.needs_bodies) return make_renderer(model, inputs);
  const double step_m = std::min(kLongestStep_m, texture.spacing_m / kStepsPerSpacing);
  inputs.parameters.try_emplace("step_m", step_m);
  if (!stroke.tool) return make_tip_renderer(model, inputs, stroke.tip);
  inputs.parameters.try_emplace("cell_m", inputs.parameters.at("step_m"));
  inputs.parameters.try_emplace("coupling", std::string("none"));
  inputs.tool = stroke.tool;
  inputs.surface = std::make_shared<const TexturedMesh>(textured_shape(
      PlateShape{{plate_length_m(stroke, texture), plate_width_m(stroke), kPlateThickness_m}},
      *texture.field,
      {.tiling = texture.tiling, .rim_m = kPlateRim_m, .samples_per_wavelength = kTexelsPerWave}));
  return make_renderer(model, inputs);
}

std::optional<DragResult> dragged(const RoughnessStroke& stroke, const TextureAtSpacing& texture,
                                  const std::stop_token& stop) {
  const std::unique_ptr<ForceRenderer> renderer = stroked_renderer(stroke, texture);
  Drag drag_of{.hand = stroke.hand,
               .mode = stroke.mode,
               .speed_m_per_s = stroke.speed_m_per_s,
               .force_N = stroke.force_N,
               .spacing_m = texture.spacing_m,
               .repeats_after_m = texture.repeats_after_m,
               .stiffness_N_per_m = stroke.material.stiffness_N_per_m};
  const auto whole_spacings_m = [&texture](double length_m) {
    return std::max(1.0, std::floor(length_m / texture.spacing_m)) * texture.spacing_m;
  };
  if (stroke.turning) {
    drag_of.guide = std::make_shared<const TurningGuide>(stroke.turning->radius_m);
    drag_of.swing_m = stroke.turning->radius_m * stroke.turning->amplitude_rad;
  } else if (stroke.body) {
    const auto guide = std::make_shared<const BodyGuide>(stroke.body, texture.line_m);
    drag_of.start_x_m = guide->from_m();
    drag_of.reach_m = guide->to_m() - guide->from_m();
    drag_of.repeats_after_m = whole_spacings_m(std::min(texture.repeats_after_m, drag_of.reach_m));
    drag_of.guide = guide;
  } else if (stroke.model->declaration.needs_bodies && stroke.tool) {
    const double length_m = plate_length_m(stroke, texture);
    drag_of.start_x_m = -0.5 * length_m + kPlateBeyond_m;
    drag_of.reach_m = length_m - 2.0 * kPlateBeyond_m;
    drag_of.repeats_after_m = whole_spacings_m(std::min(texture.repeats_after_m, drag_of.reach_m));
  }
  return drag(*renderer, drag_of, stop);
}

const char* text_of(VariedQuantity varied) noexcept {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return "probe_diameter";
    case VariedQuantity::applied_force:
      return "applied_force";
    case VariedQuantity::exploratory_speed:
      return "exploratory_speed";
    case VariedQuantity::turning:
      return "turning_rad";
  }
  return "";
}

bool depends_on(const ForceModel& model, const ParameterValues& given, VariedQuantity varied) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return model.declaration.needs_bodies;
    case VariedQuantity::applied_force:
      return feels_applied_force(model, given);
    case VariedQuantity::exploratory_speed:
    case VariedQuantity::turning:
      return true;
  }
  return true;
}

}  // namespace asperity
