// Implements the JSON line of a planned trial, which is stored before a session starts.

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

#include "protocols/plan/plan.h"
#include "protocols/plan/shown_options.h"

namespace asperity {

namespace {

/// Writes JSON text incrementally, byte for byte as nlohmann's `dump`: plans are compared with those that older
/// programs stored with `dump`. The tree that `dump` requires would take ten times as long, and checking a study makes
/// a million plans again.
class JsonLine final {
 public:
  void open(char bracket) {
    separate();
    line_ += bracket;
  }
  void close(char bracket) { line_ += bracket; }
  void key(std::string_view name) {
    add(name);
    line_ += ':';
  }

  void add(std::string_view text) {
    separate();
    const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) {
      return c >= ' ' && c <= '~' && c != '"' && c != '\\';
    });
    if (is_plain) {
      line_ += '"';
      line_ += text;
      line_ += '"';
    } else {
      line_ += nlohmann::json(text).dump();
    }
  }
  void add(const std::string& text) { add(std::string_view(text)); }
  void add(const char* text) { add(std::string_view(text)); }
  void add(int number) {
    separate();
    line_ += std::to_string(number);
  }
  void add(bool value) {
    separate();
    line_ += value ? "true" : "false";
  }
  void add(double number) {
    separate();
    line_ += nlohmann::json(number).dump();
  }
  void add(const Level& level) {
    std::visit([this](const auto& held) { add(held); }, level);
  }
  void add(std::nullopt_t) {
    separate();
    line_ += "null";
  }
  template <typename Value>
  void add(const std::optional<Value>& value) {
    if (value) {
      add(*value);
    } else {
      add(std::nullopt);
    }
  }

  template <typename Value>
  void field(std::string_view name, const Value& value) {
    key(name);
    add(value);
  }
  /// Writes an object of factors or parameters.
  template <typename Levels>
  void levels(const Levels& named) {
    open('{');
    for (const auto& [name, value] : named) field(name, value);
    close('}');
  }

  std::string take() && { return std::move(line_); }

 private:
  /// Writes the comma between elements of an object or array.
  void separate() {
    if (!line_.empty() && line_.back() != '{' && line_.back() != '[' && line_.back() != ':') {
      line_ += ',';
    }
  }

  std::string line_{};
};

void add_body(JsonLine& line, std::string_view key, const BodyDescription& body) {
  line.key(key);
  line.open('{');
  line.field("body", body.name);
  line.field("mesh", body.mesh);
  line.field("height_field", body.height_field);
  line.close('}');
}

void add_vector(JsonLine& line, std::string_view key, const glm::dvec2& vector) {
  line.key(key);
  line.open('[');
  line.add(vector.x);
  line.add(vector.y);
  line.close(']');
}

/// Nothing where the surface has its whole workspace.
void add_place(JsonLine& line, const PlannedPresentation& planned) {
  const SurfacePatch& whole = planned.stimulus.patch;
  const SurfacePatch& patch = planned.patch;
  if (patch.centre_m == whole.centre_m && patch.extent_m == whole.extent_m &&
      patch.texture_origin_m == whole.texture_origin_m) {
    return;
  }
  line.key("patch");
  line.open('{');
  add_vector(line, "centre_m", patch.centre_m);
  if (patch.centre_m.z != whole.centre_m.z) line.field("centre_z_m", patch.centre_m.z);
  add_vector(line, "extent_m", patch.extent_m);
  add_vector(line, "texture_origin_m", patch.texture_origin_m);
  line.close('}');
}

void add_presentation(JsonLine& line, const PlannedPresentation& planned) {
  const StimulusDescription& stimulus = planned.stimulus;
  line.open('{');
  line.field("position", planned.position);
  line.field("role", planned.role);
  line.field("item", planned.item);
  line.field("code", planned.code);
  line.field("stimulus", stimulus.name);
  line.field("model", stimulus.model);
  line.field("texture", stimulus.texture);
  line.field("height_field", stimulus.height_field);
  line.key("parameters");
  line.levels(stimulus.parameters);
  if (planned.equal_force) {
    line.key("equal_force");
    line.open('{');
    line.field("rms_N", planned.equal_force->rms_N);
    line.field("to_model", planned.equal_force->to_model);
    line.field("band_low_Hz", planned.equal_force->band_low_Hz);
    line.field("band_high_Hz", planned.equal_force->band_high_Hz);
    line.close('}');
  } else {
    line.field("equal_force", std::nullopt);
  }
  // From here on only what the presentation has.
  if (stimulus.relative_amplitude) {
    line.field("relative_amplitude", *stimulus.relative_amplitude);
  }
  if (planned.roughness_match) line.field("roughness_match", text_of(*planned.roughness_match));
  if (stimulus.surface) add_body(line, "surface", *stimulus.surface);
  if (stimulus.tool) add_body(line, "tool", *stimulus.tool);
  if (!stimulus.declared_assets.empty()) {
    line.key("assets");
    line.levels(stimulus.declared_assets);
  }
  add_place(line, planned);
  if (planned.has_own_material) {
    line.key("material");
    line.open('{');
    line.field("stiffness_N_per_m", stimulus.material.stiffness_N_per_m);
    line.field("friction", stimulus.material.friction);
    line.close('}');
  }
  line.close('}');
}

/// Labels are texts, and a plan is the same in all languages.
void add_parameters(JsonLine& line, const AnswerForm& form) {
  if (const auto* const line_form = std::get_if<LineForm>(&form)) {
    line.field("longest", line_form->longest);
  }
  const auto* const number = std::get_if<NumberForm>(&form);
  if (number != nullptr && !number->is_estimate) {
    line.field("minimum", number->minimum);
    line.field("maximum", number->maximum);
  }
  const auto* const scale = std::get_if<ScaleForm>(&form);
  if (scale == nullptr) return;
  line.field("minimum", scale->minimum);
  line.field("maximum", scale->maximum);
  line.field("points", scale->points);
}

void add_options_and_correct(JsonLine& line, const Question& question) {
  line.key("options");
  line.open('[');
  for (const Option& option : question.options) {
    line.open('{');
    line.field("value", option.value);
    line.field("label", option.label);
    line.field("picture", option.picture);
    line.close('}');
  }
  line.close(']');
  line.key("correct");
  line.open('[');
  for (const std::string& answer : question.correct) line.add(answer);
  line.close(']');
}

void add_questions(JsonLine& line, const Trial& trial) {
  line.field("standard_picture", trial.standard_picture);
  line.field("layout", trial.on_one_page ? "one_page" : "one_after_another");
  line.key("questions");
  line.open('[');
  for (const Question& question : trial.questions) {
    line.open('{');
    line.field("name", question.name);
    line.field("form", name_of(question.form));
    add_parameters(line, question.form);
    add_options_and_correct(line, question);
    if (question.condition) line.field("if", signs_of(*question.condition));
    line.close('}');
  }
  line.close(']');
}

}  // namespace

std::string json_of(const Trial& trial) {
  JsonLine line{};
  line.open('{');
  line.field("ordinal", trial.ordinal);
  line.field("block", trial.block);
  line.field("block_ordinal", trial.block_ordinal);
  line.field("phase", text_of(trial.phase));
  line.field("repetition", trial.repetition);
  if (trial.track) {
    line.field("track", trial.track->track);
    line.field("step", trial.track->step);
  }
  if (trial.catch_trial) line.field("catch", text_of(trial.catch_trial->type));
  // An anchor without this member is at the start (anchor_place_in).
  if (trial.anchor && *trial.anchor != AnchorPlace::start) {
    line.field("anchor", text_of(*trial.anchor));
  }
  line.key("factors");
  line.levels(trial.factors);
  line.key("presentations");
  line.open('[');
  for (const PlannedPresentation& planned : trial.presentations) add_presentation(line, planned);
  line.close(']');
  add_questions(line, trial);
  line.close('}');
  return std::move(line).take();
}

std::string factors_json_of(const Trial& trial) {
  JsonLine line{};
  line.levels(trial.factors);
  return std::move(line).take();
}

AnchorPlace anchor_place_in(const nlohmann::json& trial) {
  const auto stated = trial.find("anchor");
  if (stated == trial.end()) return AnchorPlace::start;
  return *stated == text_of(AnchorPlace::middle) ? AnchorPlace::middle : AnchorPlace::end;
}

std::string options_json_of(const Question& question) {
  JsonLine line{};
  line.open('[');
  for (const Option& option : question.options) line.add(option.value);
  line.close(']');
  return std::move(line).take();
}

}  // namespace asperity
