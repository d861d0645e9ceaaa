// Reads the options of asperity sweep.

#include "app/cli/sweep/sweep_options.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/asset_option.h"
#include "app/cli/options/body_option.h"
#include "app/cli/options/model_option.h"
#include "app/cli/options/number_list.h"
#include "app/cli/options/parameter_option.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/words/text_parts.h"
#include "renderers/proxy/body_surface.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {

namespace {

/// The unit of a quantity, and a value that no hand reaches: a greater number was meant in another unit.
struct Given {
  const char* name = "";
  const char* unit = "";
  double most = 0.0;
  const char* like = "";
};

Given given_of(VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return {"a probe diameter", "m", 0.1, "write 2 mm as 0.002"};
    case VariedQuantity::applied_force:
      return {"a force", "N", 100.0, "write 500 mN as 0.5"};
    case VariedQuantity::exploratory_speed:
      return {"a speed", "m/s", 10.0, "write 60 mm/s as 0.06"};
    case VariedQuantity::turning:
      return {"an amplitude of turning", "rad", 3.14159, "write 10 degrees as 0.1745"};
  }
  return {};
}

constexpr Given kGivenSpacing{"a spacing", "m", 0.1, "write 4 mm as 0.004"};

void require_unit(const std::string& option, double number, const Given& given) {
  if (!(number > given.most)) return;
  throw WrongUsage(option + ": " + given.name + " is given in " + given.unit + " and is at most " +
                   number_text(given.most) + ' ' + given.unit + ", not " + number_text(number) +
                   ' ' + given.unit + "; " + given.like);
}

std::vector<double> values_of(VariedQuantity varied, const std::string& text) {
  const Given given = given_of(varied);
  std::vector<double> values =
      numbers_of("--values", text, ',',
                 std::string(given.name) + " is given in " + given.unit + ": " + given.like);
  for (const double value : values) require_unit("--values " + text, value, given);
  return values;
}

std::vector<double> spacings_of(const std::string& text) {
  constexpr const char* kExpected = "write FROM:TO:COUNT, in metres, such as 0.0005:0.008:40";
  const std::vector<double> numbers = numbers_of("--spacings", text, ':', kExpected);
  if (numbers.size() != 3) {
    throw WrongUsage("--spacings " + text + " has " + counted(numbers.size(), "number", "numbers") +
                     " instead of three; " + kExpected);
  }
  constexpr int kMostSpacings = 10000;
  if (numbers[2] != std::floor(numbers[2]) || numbers[2] < 2.0 || numbers[2] > kMostSpacings) {
    throw WrongUsage("--spacings " + text + ": COUNT is " + number_text(numbers[2]) +
                     "; it must be a whole number from 2 to " + std::to_string(kMostSpacings));
  }
  for (const double spacing_m : {numbers[0], numbers[1]}) {
    require_unit("--spacings " + text, spacing_m, kGivenSpacing);
  }
  try {
    return logarithmic_spacings(numbers[0], numbers[1], static_cast<int>(numbers[2]));
  } catch (const std::invalid_argument& error) {
    throw WrongUsage("--spacings " + text + ": " + error.what());
  }
}

HandModel hand_of(const std::string& text) {
  std::string expected = "write M_kg,B_N_s_per_m,K_N_per_m, such as 0.05,3,200";
  for (const HandPreset& preset : hand_presets()) {
    if (text == preset.name) return preset.hand;
    expected += std::string(", or ") + preset.name;
  }
  const std::vector<double> numbers = numbers_of("--hand", text, ',', expected);
  if (numbers.size() != 3) {
    throw WrongUsage("--hand " + text + " has " + counted(numbers.size(), "number", "numbers") +
                     " instead of three; " + expected);
  }
  return {.mass_kg = numbers[0], .damping_N_s_per_m = numbers[1], .stiffness_N_per_m = numbers[2]};
}

void take_texture(SweepOrder& order, const std::string& text) {
  std::vector<std::string> pieces = parts_of(text, ',');
  if (std::filesystem::path(text).extension() == ".png") {
    const LoadedHeightField loaded = load_height_field(text);
    order.texture.relief = loaded.field;
    order.relief_sha256 = loaded.sha256;
    return;
  }
  order.texture.kind = pieces.front();
  pieces.erase(pieces.begin());
  for (const std::string& piece : pieces) {
    if (piece.find('=') == std::string::npos) {
      throw WrongUsage("--texture " + text + ": \"" + piece +
                       "\" has no value; write KIND[,NAME=VALUE…] or FILE.png");
    }
  }
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    if (surface.kind != order.texture.kind) continue;
    order.texture.values = parameters_from(pieces, surface.parameters, surface.kind);
  }
  if (order.texture.values.contains("spacing_m")) {
    throw WrongUsage("--texture " + text +
                     ": the spacing is set by --spacings; leave out spacing_m");
  }
}

void take_tip(SweepOrder& order, const std::string& text) {
  if (!order.stroke.model->declaration.needs_bodies) {
    throw WrongUsage("the force model " + order.stroke.model->declaration.id +
                     " computes the contact at a point, and --tool needs a model with two bodies; "
                     "leave out --tool, or choose another model");
  }
  const std::map<std::string, TipForm> forms{
      {"point", TipForm::point}, {"sphere", TipForm::sphere}, {"disc", TipForm::disc}};
  const auto form = forms.find(text);
  if (form != forms.end()) {
    order.stroke.tip.form = form->second;
    return;
  }
  if (!std::filesystem::exists(text)) {
    throw std::runtime_error("--tool " + text +
                             ": there is no such file; write sphere, disc, point, or the file of a "
                             "textured mesh");
  }
  const LoadedTexturedMesh loaded = load_textured_mesh(text);
  order.stroke.tool = {loaded.stored, &loaded.stored->mesh};
  order.tool_sha256 = loaded.sha256;
}

void take_turning(SweepOrder& order, const SweepOptions& options) {
  if (order.varied != VariedQuantity::turning && !options.turning_rad) {
    if (!options.turning_radius_m) return;
    throw WrongUsage(
        "--turning-radius-m is the radius of a tool that turns; add --turning-rad or --vary "
        "turning_rad, or leave it out");
  }
  order.stroke.turning.emplace();
  if (options.turning_radius_m) {
    constexpr Given kRadius{"a radius", "m", 1.0, "write 20 mm as 0.02"};
    require_unit("--turning-radius-m", *options.turning_radius_m, kRadius);
    order.stroke.turning->radius_m = *options.turning_radius_m;
  }
}

void take_body(SweepOrder& order, const std::string& text) {
  const BodyOption body = body_option("--stimulus", text);
  if (body.is_plain_height_field()) {
    throw WrongUsage("--stimulus " + text +
                     " is a height field, which the sweep takes as --texture " +
                     body.file->string() + "; --stimulus is the body under the texture");
  }
  order.body = text;
  if (body.file) order.body_sha256 = sha256_of(read_file(*body.file));
  order.stroke.body = std::make_shared<const BodySurface>(*load_body(body));
}

/// A level that is constant in the sweep, which the varied quantity is not.
void take_level(const SweepOrder& order, VariedQuantity quantity, const char* option,
                std::optional<double> given, double& level) {
  if (!given) return;
  if (order.varied == quantity) {
    throw WrongUsage(
        std::string(option) +
        " sets the quantity that --vary varies; leave it out, and give the levels with --values");
  }
  require_unit(std::string(option) + ' ' + number_text(*given), *given, given_of(quantity));
  level = *given;
}

/// The experiment with speed presses with a constant force on a stiff surface, as participants do on a plate: at a constant height
/// the effect of speed is that of the simulated hand's resonance, and has the wrong direction.
void take_drag(SweepOrder& order, const SweepOptions& options) {
  constexpr double kStiff_N_per_m = 20000.0;
  const bool varies_speed = order.varied == VariedQuantity::exploratory_speed;
  order.stroke.mode =
      options.drag.value_or(varies_speed ? DragMode::constant_force : DragMode::constant_height);
  double& stiffness_N_per_m = order.stroke.material.stiffness_N_per_m;
  if (varies_speed && order.stroke.mode == DragMode::constant_force) {
    stiffness_N_per_m = kStiff_N_per_m;
  }
  stiffness_N_per_m = options.stiffness_N_per_m.value_or(stiffness_N_per_m);
}

}  // namespace

void complete_order(SweepOptions& options, const ModelRegistry& models) {
  const ForceModel& model = model_named(models, options.model);
  SweepOrder& order = options.order;
  order.stroke.model = &model;
  order.stroke.parameters =
      parameters_from(options.parameters, model.declaration.parameters, options.model);
  for (const std::string& text : options.assets) {
    const std::string role = add_asset(order.stroke, model.declaration, text);
    order.asset_sha256[role] = sha256_of(*order.stroke.assets.at(role));
  }
  order.stroke.hand = hand_of(options.hand);
  take_drag(order, options);
  order.values =
      options.values.empty() ? usual_values(order.varied) : values_of(order.varied, options.values);
  order.spacings_m = spacings_of(options.spacings);
  take_texture(order, options.texture);
  if (options.tool) take_tip(order, *options.tool);
  if (options.stimulus) take_body(order, *options.stimulus);
  take_turning(order, options);
  if (options.turning_rad) {
    take_level(order, VariedQuantity::turning, "--turning-rad", options.turning_rad,
               order.stroke.turning->amplitude_rad);
  }
  take_level(order, VariedQuantity::probe_diameter, "--probe-diameter-m", options.probe_diameter_m,
             order.stroke.tip.diameter_m);
  take_level(order, VariedQuantity::applied_force, "--applied-force-n", options.applied_force_N,
             order.stroke.force_N);
  take_level(order, VariedQuantity::exploratory_speed, "--exploratory-speed-m-per-s",
             options.exploratory_speed_m_per_s, order.stroke.speed_m_per_s);
}

}  // namespace asperity
