// Implements the conversion of a plug-in's description, and the renderer that calls its functions.

#include "renderers/plugin/plugin_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/unit_of_name.h"
#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"
#include "renderers/plugin/plugin_call.h"

namespace asperity {
namespace {

constexpr const char* kUncaught = "an exception left a function of the plug-in";
constexpr const char* kInvalid =
    "a result is not finite (more than 3.4e38 counts as infinite), or its normal force or "
    "penetration is negative";

/// A description and the library that it is in.
struct Plugin {
  const asperity_model* description = nullptr;
  std::shared_ptr<const void> library{};
  std::string name{};  ///< for PluginCall
};

[[noreturn]] void refuse(const std::string& field, const std::string& problem) {
  throw std::invalid_argument("asperity_model::" + field + ' ' + problem);
}

/// The bytes of the character at the beginning, from its first byte; 0 for a byte that begins none. Encodings that are longer
/// than necessary and surrogates are not excluded: no program stores them.
std::size_t length_of_character(unsigned char first) noexcept {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// The bytes before the first one that is not part of a complete character of UTF-8.
std::size_t valid_length(std::string_view text) noexcept {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = length_of_character(static_cast<unsigned char>(text[at]));
    if (length == 0 || at + length > text.size()) break;
    const std::string_view rest = text.substr(at + 1, length - 1);
    const bool is_whole = std::all_of(rest.begin(), rest.end(), [](char byte) {
      return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
    });
    if (!is_whole) break;
    at += length;
  }
  return at;
}

std::string text_in(const char* text, const std::string& field) {
  if (text == nullptr || *text == 0) refuse(field, "is empty; set it");
  if (valid_length(text) != std::string_view(text).size()) {
    refuse(field, "is not UTF-8; save the source as UTF-8");
  }
  return text;
}

Parameter choice_of_plugin(const asperity_parameter& given, Parameter parameter,
                           const std::string& field) {
  if (given.choices == nullptr || given.choice_count == 0)
    refuse(field, "has no choices; list them");
  for (std::uint32_t i = 0; i < given.choice_count; ++i) {
    std::string choice = text_in(given.choices[i], field + ".choices");
    const auto& others = parameter.choices;
    if (std::find(others.begin(), others.end(), choice) != others.end()) {
      refuse(field, "has the choice " + choice + " twice; give each choice its own name");
    }
    parameter.choices.push_back(std::move(choice));
  }
  const double place = given.default_value;
  if (!(place >= 0.0 && place < given.choice_count && place == std::floor(place))) {
    refuse(field, "has the default " + number_text(place) +
                      "; for a choice it is the place of the default among the choices, from 0");
  }
  parameter.default_value = parameter.choices[static_cast<std::size_t>(place)];
  return parameter;
}

Parameter parameter_of(const asperity_parameter& given, std::size_t index) {
  const std::string place = "parameters[" + std::to_string(index) + ']';
  Parameter parameter{};
  parameter.name = text_in(given.name, place + ".name");
  const std::string field = place + " (" + parameter.name + ')';
  const bool begins_well = parameter.name.front() >= 'a' && parameter.name.front() <= 'z';
  if (!begins_well || !std::all_of(parameter.name.begin(), parameter.name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
      })) {
    refuse(field,
           "must have a name of letters, digits and underscores that begins with a small "
           "letter");
  }
  parameter.unit = text_in(given.unit, place + ".unit");
  const std::string unit = unit_in_files(parameter.name);
  if (unit != "1" && given.kind != ASPERITY_CHOICE && unit != parameter.unit) {
    refuse(field, "has the unit \"" + parameter.unit + "\", and its name ends in the unit \"" +
                      unit + "\"; correct one of them");
  }
  parameter.meaning = text_in(given.meaning, place + ".meaning");
  if (given.kind == ASPERITY_CHOICE) {
    parameter.kind = ParameterKind::choice;
    return choice_of_plugin(given, std::move(parameter), field);
  }
  if (given.kind != ASPERITY_NUMBER && given.kind != ASPERITY_INTEGER) {
    refuse(field, "has the kind " + std::to_string(given.kind) + "; kinds are 0, 1 and 2");
  }
  parameter.kind = given.kind == ASPERITY_NUMBER ? ParameterKind::number : ParameterKind::integer;
  parameter.minimum = given.minimum;
  parameter.maximum = given.maximum;
  parameter.default_value = given.default_value;
  if (!std::isfinite(given.minimum) || !std::isfinite(given.maximum) ||
      given.minimum > given.maximum) {
    refuse(field, "has the range " + number_text(given.minimum) + " to " +
                      number_text(given.maximum) + "; it must be finite and not empty");
  }
  if (const auto complaint = complaint_about(parameter, parameter.default_value)) {
    refuse(field, "has a default that it does not allow: " + complaint->english());
  }
  return parameter;
}

std::vector<Parameter> parameters_of(const asperity_model& description) {
  if (description.parameters == nullptr && description.parameter_count > 0) {
    refuse("parameters", "is null; set it, or set parameter_count to 0");
  }
  std::vector<Parameter> parameters{};
  add_layer_parameters(parameters);
  const std::size_t shared = parameters.size();
  for (std::uint32_t i = 0; i < description.parameter_count; ++i) {
    Parameter own = parameter_of(description.parameters[i], i);
    for (const Parameter& other : parameters) {
      if (other.name != own.name) continue;
      refuse("parameters[" + std::to_string(i) + ']',
             "has the name " + own.name + ", which another parameter has; choose another name");
    }
    parameters.push_back(std::move(own));
  }
  std::rotate(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(shared),
              parameters.end());
  return parameters;
}

void require_amplitude(const ModelDeclaration& declaration) {
  for (const Parameter& parameter : declaration.parameters) {
    if (parameter.name != declaration.amplitude_parameter) continue;
    if (parameter.kind == ParameterKind::number && parameter.minimum == 0.0) return;
    refuse("amplitude_parameter", "is " + parameter.name +
                                      ", which is not a number with the minimum 0; at 0 the model "
                                      "is the plate without texture");
  }
  refuse("amplitude_parameter",
         "is " + declaration.amplitude_parameter.value_or("") + ", which is not a parameter");
}

ModelDeclaration declaration_of(const asperity_model& description) {
  ModelDeclaration declaration{};
  declaration.id = text_in(description.id, "id");
  declaration.version = text_in(description.version, "version");
  declaration.summary = text_in(description.summary, "summary");
  declaration.source = text_in(description.source, "source");
  declaration.needs_height_field = description.needs_height_field != 0;
  declaration.feels_applied_force = description.feels_applied_force != 0;
  declaration.amplitude_parameter = text_in(description.amplitude_parameter, "amplitude_parameter");
  declaration.parameters = parameters_of(description);
  require_amplitude(declaration);
  return declaration;
}

void require_functions(const asperity_model& description) {
  const std::array functions{std::pair{"band", description.band == nullptr},
                             std::pair{"create", description.create == nullptr},
                             std::pair{"destroy", description.destroy == nullptr},
                             std::pair{"reset", description.reset == nullptr},
                             std::pair{"tick", description.tick == nullptr}};
  for (const auto& [name, is_missing] : functions) {
    if (is_missing) refuse(name, "is null; set it to a function");
  }
}

/// The height field of a renderer, in the form of the interface.
class HeightFieldOfPlugin final {
 public:
  HeightFieldOfPlugin(std::shared_ptr<const HeightField> field, Tiling tiling)
      : field_(std::move(field)), tiling_(tiling) {
    if (!field_) return;
    given_ = {.field = this,
              .sample = sample,
              .pitch_m = field_->grid().pitch_m,
              .minimum_m = field_->minimum_m(),
              .maximum_m = field_->maximum_m()};
  }
  HeightFieldOfPlugin(const HeightFieldOfPlugin&) = delete;
  HeightFieldOfPlugin& operator=(const HeightFieldOfPlugin&) = delete;

  const asperity_height_field* given() const noexcept { return field_ ? &given_ : nullptr; }

 private:
  static void sample(const void* field, double x_m, double y_m, asperity_height* height) noexcept {
    const auto& own = *static_cast<const HeightFieldOfPlugin*>(field);
    const HeightSample found = own.field_->sample(x_m, y_m, own.tiling_);
    *height = {.height_m = found.height_m, .slope_x = found.slope_x, .slope_y = found.slope_y};
  }

  std::shared_ptr<const HeightField> field_{};
  Tiling tiling_ = Tiling::repeat;
  asperity_height_field given_{};
};

/// The values of the plug-in's own parameters, which are the first ones.
std::vector<double> values_for(const asperity_model& description, const RendererInputs& inputs) {
  std::vector<double> values{};
  for (std::uint32_t i = 0; i < description.parameter_count; ++i) {
    const asperity_parameter& declared = description.parameters[i];
    const ParameterValue& value = inputs.parameters.at(declared.name);
    if (const double* const number = std::get_if<double>(&value)) {
      values.push_back(*number);
      continue;
    }
    const std::string& choice = std::get<std::string>(value);
    const auto found =
        std::find(declared.choices, declared.choices + declared.choice_count, choice);
    values.push_back(static_cast<double>(found - declared.choices));
  }
  return values;
}

/// The inputs in the form of the interface; they borrow from the arguments.
asperity_inputs inputs_for(const RendererInputs& inputs, const std::vector<double>& values,
                           const asperity_height_field* field) {
  return {.values = values.data(),
          .value_count = static_cast<std::uint32_t>(values.size()),
          .stiffness_N_per_m = inputs.material.stiffness_N_per_m,
          .motion_scale = inputs.patch.motion_scale,
          .seed = inputs.seed,
          .height_field = field};
}

class PluginRenderer final : public ForceRenderer {
 public:
  PluginRenderer(Plugin plugin, const RendererInputs& inputs)
      : plugin_(std::move(plugin)),
        contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(plugin_.description->needs_height_field != 0 ? inputs.height_field : nullptr,
               inputs.patch.tiling) {
    const std::vector<double> values = values_for(*plugin_.description, inputs);
    const asperity_inputs given = inputs_for(inputs, values, field_.given());
    std::array<char, 256> message{};
    const PluginCall call(plugin_.name.c_str(), PluginFunction::create);
    try {
      renderer_ = plugin_.description->create(&given, message.data(), message.size());
    } catch (...) {
      throw std::invalid_argument(where() + kUncaught + " (create)");
    }
    if (renderer_ == nullptr) {
      message.back() = 0;
      throw std::invalid_argument(
          where() + (message.front() == 0
                         ? std::string("create returned no renderer")
                         : std::string(message.data(), valid_length(message.data()))));
    }
  }

  ~PluginRenderer() override {
    const PluginCall call(plugin_.name.c_str(), PluginFunction::destroy);
    try {
      plugin_.description->destroy(renderer_);
    } catch (...) {
      // The renderer is given up either way.
    }
  }

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    failure_ = nullptr;
    const PluginCall call(plugin_.name.c_str(), PluginFunction::reset);
    const asperity_sample sample = sample_of(contact_.locate(first.position_m), first, 0.0);
    try {
      if (plugin_.description->reset(renderer_, &sample) != 0) fail(counts_[kError], message());
    } catch (...) {
      fail(counts_[kError], kUncaught);
    }
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    asperity_force force{};
    if (failure_ == nullptr) {
      const PluginCall call(plugin_.name.c_str(), PluginFunction::tick);
      const asperity_sample sample = sample_of(point, probe, dt_s);
      try {
        if (plugin_.description->tick(renderer_, &sample, &force) != 0) {
          fail(counts_[kError], message());
        } else if (!is_valid(force)) {
          fail(counts_[kNotValid], kInvalid);
        }
      } catch (...) {
        fail(counts_[kError], kUncaught);
      }
    }
    if (failure_ != nullptr) {
      ++failure_->ticks;
      constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
      return {.wrench = {.force_N = glm::dvec3(kNaN)}, .penetration_m = kNaN};
    }
    if (point.gain == 0.0 || force.penetration_m == 0.0) return contact_.no_contact();
    return contact_.force(point, probe,
                          {.texture_N = {force.force_N[0], force.force_N[1], force.force_N[2]},
                           .normal_N = force.normal_N,
                           .penetration_m = force.penetration_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }
  std::span<const NamedCount> limits() const noexcept override { return counts_; }
  std::string_view error() const noexcept override { return error_.data(); }

 private:
  static constexpr std::size_t kError = 0;
  static constexpr std::size_t kNotValid = 1;

  static asperity_sample sample_of(const PatchPoint& point, const ProbeState& probe,
                                   double dt_s) noexcept {
    return {.x_m = point.x_m,
            .y_m = point.y_m,
            .height_m = point.height_m,
            .velocity_m_per_s = {probe.velocity_m_per_s.x, probe.velocity_m_per_s.y,
                                 probe.velocity_m_per_s.z},
            .dt_s = dt_s};
  }

  static bool is_valid(const asperity_force& force) noexcept {
    return is_finite_as_stored(glm::dvec3(force.force_N[0], force.force_N[1], force.force_N[2])) &&
           is_finite_as_stored(force.normal_N) && is_finite_as_stored(force.penetration_m) &&
           force.normal_N >= 0.0 && force.penetration_m >= 0.0;
  }

  std::string where() const {
    return "the plug-in model " + std::string(plugin_.description->id) + ": ";
  }

  const char* message() const {
    const char* const text =
        plugin_.description->message == nullptr ? nullptr : plugin_.description->message(renderer_);
    return text == nullptr || *text == 0 ? "the plug-in reported an error without a message" : text;
  }

  void fail(NamedCount& counted_as, const char* reason) noexcept {
    failure_ = &counted_as;
    std::size_t length = 0;
    while (length + 1 < error_.size() && reason[length] != 0) ++length;
    // A message that was cut may end within a character.
    length = valid_length({reason, length});
    std::copy_n(reason, length, error_.begin());
    error_[length] = 0;
  }

  Plugin plugin_{};
  SurfaceContact contact_;
  HeightFieldOfPlugin field_;
  void* renderer_ = nullptr;
  std::array<char, 256> error_{};
  std::array<NamedCount, 2> counts_{NamedCount{.name = "plugin_error"},
                                    NamedCount{.name = "plugin_not_valid"}};
  NamedCount* failure_ = nullptr;  ///< since the last reset, with the count of its kind
};

TextureBand band_of(const Plugin& plugin, const RendererInputs& inputs) {
  const std::vector<double> values = values_for(*plugin.description, inputs);
  const HeightFieldOfPlugin field(
      plugin.description->needs_height_field != 0 ? inputs.height_field : nullptr,
      inputs.patch.tiling);
  const asperity_inputs given = inputs_for(inputs, values, field.given());
  asperity_band band{};
  const PluginCall call(plugin.name.c_str(), PluginFunction::band);
  int error = 0;
  try {
    error = plugin.description->band(&given, &band);
  } catch (...) {
    error = 1;
  }
  if (error != 0 || !std::isfinite(band.per_m) || !std::isfinite(band.time_Hz)) {
    throw std::invalid_argument("the plug-in model " + std::string(plugin.description->id) +
                                " states no band for these inputs");
  }
  return {.per_m = band.per_m, .time_Hz = band.time_Hz};
}

}  // namespace

ForceModel model_of_plugin(const asperity_model& description, std::shared_ptr<const void> library,
                           const std::string& file) {
  // Reading the description can fail as its functions can: a pointer or a count in it may be wrong.
  const PluginCall call(file.c_str(), PluginFunction::description);
  if (description.abi_version != ASPERITY_PLUGIN_ABI_VERSION) {
    throw std::invalid_argument("it has version " + std::to_string(description.abi_version) +
                                " of the plug-in interface, and this program has version " +
                                std::to_string(ASPERITY_PLUGIN_ABI_VERSION) +
                                "; compile it with the header that this program installs");
  }
  require_functions(description);
  ForceModel model{};
  model.declaration = declaration_of(description);
  const Plugin plugin{&description, std::move(library), model.declaration.id + " (" + file + ')'};
  model.make = [plugin](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
    return std::make_unique<PluginRenderer>(plugin, inputs);
  };
  if (description.is_conservative != 0) model.conservative_with = ParameterValues{};
  if (description.moves_by_itself != 0) model.moves_by_itself_with = ParameterValues{};
  model.band = [plugin](const RendererInputs& inputs) { return band_of(plugin, inputs); };
  model.band_formula = text_in(description.band_formula, "band_formula");
  return model;
}

}  // namespace asperity
