// References, ranges and feasibility.

#include "protocols/meaning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>

#include "protocols/block_rows.h"
#include "protocols/plan.h"
#include "protocols/trial_order.h"
#include "protocols/wording.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using Run = Protocol::Run;

// More trials than anybody sits through; a plan stays small enough to be made while one waits.
constexpr std::size_t kMaximumTrials = 2000;
constexpr std::size_t kMaximumSessionTrials = 5000;
constexpr std::size_t kMaximumRows = 100'000;

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names{};
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

template <class Map>
std::string unknown(std::string_view what, const std::string& name, const Map& map) {
  const std::vector<std::string> names = names_of(map);
  const std::string guess = did_you_mean(name, names);
  return "there is no " + std::string(what) + " " + in_quotes(name) +
         (!guess.empty()  ? guess
          : names.empty() ? "; none is declared"
                          : "; declared: " + one_of(names));
}

/// Complaints about the whole protocol, gathered place by place.
class Meaning {
 public:
  Meaning(const Protocol& protocol, const JsonDocument& document,
          const std::vector<ModelDeclaration>& models)
      : protocol_(protocol), document_(document) {
    for (const ModelDeclaration& model : models) models_.emplace(model.id, &model);
  }

  std::vector<Diagnostic> check() {
    check_head();
    check_textures();
    check_factors();
    check_explorations();
    check_questions();
    for (const auto& [name, stimulus] : protocol_.stimuli) {
      check_stimulus(stimulus, pointer_to("/stimuli", name));
    }
    check_flow();
    for (const auto& [name, block] : protocol_.blocks) {
      check_block(block, pointer_to("/blocks", name));
    }
    // What a trial amounts to can only be seen in one, and only when all references hold.
    if (found_.empty()) check_size();
    if (found_.empty()) check_trials();
    std::stable_sort(found_.begin(), found_.end(), [](const Diagnostic& a, const Diagnostic& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    return std::move(found_);
  }

 private:
  void report(const std::string& pointer, std::string message) {
    if (!said_.emplace(pointer, message).second) return;
    found_.push_back(document_.at(pointer, std::move(message)));
  }
  void report_key(const std::string& pointer, std::string message) {
    if (!said_.emplace(pointer, message).second) return;
    found_.push_back(document_.at_key(pointer, std::move(message)));
  }

  void check_head();
  void check_textures();
  void check_path(const std::optional<std::string>& path, const std::string& pointer);
  void check_factors();
  void check_explorations();
  void check_band(const Band& band, const std::string& pointer);
  void check_questions();
  void check_stimulus(const StimulusTemplate& stimulus, const std::string& pointer);
  void check_equal_force(const StimulusTemplate& stimulus, const std::string& pointer);
  void check_flow();
  void check_block(const Block& block, const std::string& pointer);
  void check_presented(const Block& block, const std::string& pointer);
  void check_question(const Block& block, const std::string& pointer);
  void check_order(const Block& block, const std::string& pointer);
  void check_criterion(const Block& block, const std::string& pointer);
  void check_size();
  void check_trials();
  Protocol with_every_possible_trial();
  void check_expectation(const Trial& trial, const std::string& pointer);

  /// The texts that a binding can stand for, each with the place to complain at.
  std::vector<std::pair<std::string, std::string>> texts_of(const Binding<std::string>& binding,
                                                            const std::string& pointer);
  bool check_level(const std::string& factor, const Level& level, const std::string& pointer);
  std::set<std::string> factors_set_by(const Block& block, const Run* run) const;
  std::vector<const Run*> runs_of(const Block& block) const;

  const Protocol& protocol_;
  const JsonDocument& document_;
  std::map<std::string, const ModelDeclaration*, std::less<>> models_{};
  std::vector<Diagnostic> found_{};
  std::set<std::pair<std::string, std::string>> said_{};
};

void Meaning::check_head() {
  const bool is_selection = protocol_.kind == ProtocolKind::selection;
  if (is_selection && !protocol_.realism_standard) {
    report("/kind",
           "a selection has to say what \"realistic\" is measured against: add the key "
           "\"realism_standard\" with \"photograph\", \"physical_sample\" or \"memory\"");
  }
  if (!is_selection && protocol_.realism_standard) {
    report_key("/realism_standard", "only a selection is measured against a standard of realism");
  }
  const auto& patch = protocol_.patch;
  if (2.0 * patch.edge_width_m >= std::min(patch.extent_m.x, patch.extent_m.y)) {
    report("/surface/edge_width_m",
           "two edges of " + digits(patch.edge_width_m) + " m leave nothing of a patch of " +
               digits(patch.extent_m.x) + " m by " + digits(patch.extent_m.y) + " m");
  }
  const auto& root = document_.root();
  if (root.contains("environment") && root.at("environment").contains("masking_noise")) {
    const auto& noise = root.at("environment").at("masking_noise");
    const bool is_none = noise.at("kind") == "none";
    if (is_none && noise.contains("level_dBA")) {
      report_key("/environment/masking_noise/level_dBA", "no noise has no level");
    }
    if (!is_none && !noise.contains("level_dBA")) {
      report("/environment/masking_noise", "masking noise has to state its \"level_dBA\"");
    }
  }
}

void Meaning::check_path(const std::optional<std::string>& path, const std::string& pointer) {
  if (!path) return;
  const std::string& text = *path;
  const auto refuse = [&](const std::string& why) {
    report(pointer, in_quotes(text) + " " + why +
                        "; name a file inside the study, such as \"stimuli/metal.png\"");
  };
  if (text.starts_with('/') || text.starts_with('~') || (text.size() > 1 && text[1] == ':')) {
    return refuse("is not a path relative to the study");
  }
  for (const char c : text) {
    if (c == '\\' || static_cast<unsigned char>(c) < 0x20) {
      return refuse("contains a backslash or a control character");
    }
  }
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t end = std::min(text.find('/', from), text.size());
    const std::string_view part = std::string_view(text).substr(from, end - from);
    if (part == "..") return refuse("leaves the study");
    if (part.empty() || part == ".") return refuse("has an empty part");
    from = end + 1;
  }
}

void Meaning::check_textures() {
  std::map<std::string, std::string> codes{};
  for (const auto& [name, texture] : protocol_.textures) {
    const std::string pointer = pointer_to("/textures", name);
    check_path(texture.height_field, pointer + "/height_field");
    check_path(texture.picture, pointer + "/picture");
    check_path(texture.true_height_field, pointer + "/true_height_field");
    if (!texture.height_field && !texture.picture) {
      report(pointer,
             "this texture can be neither felt nor seen: give it a \"height_field\", a "
             "\"picture\" or both");
    }
    if (texture.code.empty()) continue;
    const auto [other, is_new] = codes.emplace(texture.code, name);
    if (!is_new) {
      report(pointer + "/code", "the code " + in_quotes(texture.code) + " is also that of " +
                                    in_quotes(other->second) + "; codes tell textures apart");
    }
  }
}

void Meaning::check_factors() {
  for (const auto& [name, factor] : protocol_.factors) {
    const std::string pointer = pointer_to("/factors", name) + "/levels";
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
      const Level& level = factor.levels[i];
      if (level.index() != factor.levels.front().index()) {
        report(pointer_to(pointer, i), "the levels of a factor are all numbers or all names");
      } else if (std::find(factor.levels.begin(),
                           factor.levels.begin() + static_cast<std::ptrdiff_t>(i),
                           level) != factor.levels.begin() + static_cast<std::ptrdiff_t>(i)) {
        report(pointer_to(pointer, i), in_quotes(text_of(level)) + " is listed twice");
      } else if (std::holds_alternative<std::string>(level) && text_of(level).empty()) {
        report(pointer_to(pointer, i), "a level cannot be empty");
      }
    }
  }
}

void Meaning::check_band(const Band& band, const std::string& pointer) {
  const auto ordered = [](const std::optional<double>& a, const std::optional<double>& b) {
    return !a || !b || *a <= *b;
  };
  if (!ordered(band.minimum, band.target) || !ordered(band.target, band.maximum) ||
      !ordered(band.minimum, band.maximum)) {
    report(pointer, "a band goes up: minimum ≤ target ≤ maximum");
  }
}

void Meaning::check_explorations() {
  for (const auto& [name, exploration] : protocol_.explorations) {
    const std::string pointer = pointer_to("/explorations", name);
    check_band(exploration.stroke_length_m, pointer + "/stroke_length_m");
    check_band(exploration.speed_m_per_s, pointer + "/speed_m_per_s");
    check_band(exploration.normal_force_N, pointer + "/normal_force_N");
    check_band(exploration.strokes, pointer + "/strokes");
    const auto too_strong = [&](const std::optional<double>& force_N, const char* key) {
      if (!force_N || *force_N <= protocol_.force_limit_N) return;
      report(pointer + "/normal_force_N/" + key,
             "the band reaches " + digits(*force_N) + " N, but the device stops at its limit of " +
                 digits(protocol_.force_limit_N) + " N (/device/force_limit_N)");
    };
    too_strong(exploration.normal_force_N.minimum, "minimum");
    too_strong(exploration.normal_force_N.target, "target");
    too_strong(exploration.normal_force_N.maximum, "maximum");
    const auto& patch = protocol_.patch;
    const double along_x = std::abs(std::cos(exploration.direction_rad));
    const double along_y = std::abs(std::sin(exploration.direction_rad));
    const auto too_long = [&](const std::optional<double>& length_m, const char* key) {
      constexpr double kRounding_m = 1e-9;
      if (!length_m || (*length_m * along_x <= patch.extent_m.x + kRounding_m &&
                        *length_m * along_y <= patch.extent_m.y + kRounding_m)) {
        return;
      }
      report(pointer + "/stroke_length_m/" + key,
             "a stroke of " + digits(*length_m) + " m does not fit into the patch of " +
                 digits(patch.extent_m.x) + " m by " + digits(patch.extent_m.y) + " m");
    };
    too_long(exploration.stroke_length_m.minimum, "minimum");
    too_long(exploration.stroke_length_m.target, "target");
    if (exploration.minimum_contact_s > exploration.maximum_contact_s) {
      report(pointer + "/minimum_contact_s",
             "at least " + digits(exploration.minimum_contact_s) +
                 " s of contact are asked for, but the surface is gone after " +
                 digits(exploration.maximum_contact_s) + " s");
    }
    const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
    if (exploration.required_fraction_in_band > 0.0 && !bounded(exploration.normal_force_N) &&
        !bounded(exploration.speed_m_per_s)) {
      report(pointer + "/required_fraction_in_band",
             "there is no band to be in: give normal_force_N or speed_m_per_s a minimum or a "
             "maximum");
    }
    const bool repeats = exploration.on_failure != Exploration::OnFailure::flag;
    if (repeats && exploration.maximum_repeats < 1) {
      report(pointer + "/on_failure",
             "trials are to be repeated, but never: set maximum_repeats to 1 or more");
    }
    if (!repeats && exploration.maximum_repeats > 0) {
      report(pointer + "/maximum_repeats",
             "nothing is repeated while on_failure is \"flag\"; choose \"repeat_now\" or "
             "\"requeue_at_end_of_block\"");
    }
  }
}

void Meaning::check_questions() {
  const auto& root = document_.root();
  for (const auto& [name, question] : protocol_.questions) {
    const std::string pointer = pointer_to("/questions", name);
    const auto& object = root.at("questions").at(name);
    switch (question.form) {
      case Question::Form::choice:
        if (question.options.empty()) report(pointer, "a choice has to list its \"options\"");
        break;
      case Question::Form::number:
      case Question::Form::text:
        if (object.contains("options")) {
          report_key(pointer + "/options", "only a question of the form \"choice\" has options");
        }
        break;
    }
    if (question.form != Question::Form::number) {
      for (const char* const key : {"minimum", "maximum"}) {
        if (object.contains(key)) {
          report_key(pointer + "/" + key, "only a question of the form \"number\" has limits");
        }
      }
    } else if (question.minimum && question.maximum && *question.minimum > *question.maximum) {
      report(pointer + "/minimum", "no number is at least " + digits(*question.minimum) +
                                       " and at most " + digits(*question.maximum));
    }
    for (std::size_t i = 0; i < question.options.size(); ++i) {
      const auto here = question.options.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(question.options.begin(), here, *here) != here) {
        report(pointer_to(pointer + "/options", i), in_quotes(*here) + " is listed twice");
      }
    }
  }
  if (!root.contains("participants") || !root.at("participants").contains("questions")) return;
  const auto& asked = root.at("participants").at("questions");
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto name = asked[i].get<std::string>();
    if (!protocol_.questions.contains(name)) {
      report(pointer_to("/participants/questions", i),
             unknown("question", name, protocol_.questions));
    }
  }
}

std::vector<std::pair<std::string, std::string>> Meaning::texts_of(
    const Binding<std::string>& binding, const std::string& pointer) {
  if (binding.value) return {{*binding.value, pointer}};
  const auto factor = protocol_.factors.find(binding.factor);
  if (factor == protocol_.factors.end()) {
    if (!binding.factor.empty()) {
      report(pointer + "/factor", unknown("factor", binding.factor, protocol_.factors));
    }
    return {};
  }
  std::vector<std::pair<std::string, std::string>> texts{};
  for (std::size_t i = 0; i < factor->second.levels.size(); ++i) {
    const std::string place = pointer_to(pointer_to("/factors", binding.factor) + "/levels", i);
    if (const auto* const text = std::get_if<std::string>(&factor->second.levels[i])) {
      texts.emplace_back(*text, place);
    } else {
      report(place, text_of(factor->second.levels[i]) +
                        " is a number, but the factor stands for a name at " + pointer);
    }
  }
  return texts;
}

void Meaning::check_stimulus(const StimulusTemplate& stimulus, const std::string& pointer) {
  std::vector<const ModelDeclaration*> models{};
  bool needs_height_field = false;
  for (const auto& [id, place] : texts_of(stimulus.model, pointer + "/model")) {
    const auto model = models_.find(id);
    if (model == models_.end()) {
      report(place, unknown("force model", id, models_));
      continue;
    }
    models.push_back(model->second);
    needs_height_field = needs_height_field || model->second->needs_height_field;
  }
  const bool has_texture = stimulus.texture.value || !stimulus.texture.factor.empty();
  if (needs_height_field && !has_texture) {
    report(pointer, "the model needs a height field: give the stimulus a \"texture\"");
  }
  for (const auto& [name, place] : texts_of(stimulus.texture, pointer + "/texture")) {
    const auto texture = protocol_.textures.find(name);
    if (texture == protocol_.textures.end()) {
      report(place, unknown("texture", name, protocol_.textures));
    } else if (!texture->second.height_field) {
      report(place,
             "the texture " + in_quotes(name) + " cannot be felt: it has no \"height_field\"");
    }
  }
  for (const auto& [name, binding] : stimulus.parameters) {
    const std::string place = pointer_to(pointer + "/parameters", name);
    std::vector<std::pair<ParameterValue, std::string>> values{};
    if (binding.value) {
      values.emplace_back(*binding.value, place);
    } else if (const auto factor = protocol_.factors.find(binding.factor);
               factor != protocol_.factors.end()) {
      for (std::size_t i = 0; i < factor->second.levels.size(); ++i) {
        values.emplace_back(factor->second.levels[i],
                            pointer_to(pointer_to("/factors", binding.factor) + "/levels", i));
      }
    } else {
      report(place + "/factor", unknown("factor", binding.factor, protocol_.factors));
    }
    for (const ModelDeclaration* const model : models) {
      const auto declared =
          std::find_if(model->parameters.begin(), model->parameters.end(),
                       [&name = name](const Parameter& each) { return each.name == name; });
      if (declared == model->parameters.end()) {
        std::map<std::string, int> names{};
        for (const Parameter& each : model->parameters) names[each.name] = 0;
        report_key(place, "the model " + in_quotes(model->id) +
                              " has no such parameter: " + unknown("parameter", name, names));
        continue;
      }
      for (const auto& [value, at] : values) {
        if (const auto complaint = complaint_about(*declared, value)) report(at, *complaint);
      }
    }
  }
  if (stimulus.equal_force) check_equal_force(stimulus, pointer);
}

void Meaning::check_equal_force(const StimulusTemplate& stimulus, const std::string& pointer) {
  const EqualForce& equal = *stimulus.equal_force;
  const std::string place = pointer + "/equal_force";
  if (equal.band_low_Hz >= equal.band_high_Hz) {
    report(place, "the band from " + digits(equal.band_low_Hz) + " Hz to " +
                      digits(equal.band_high_Hz) + " Hz is empty");
  }
  if (equal.band_high_Hz > 0.5 * protocol_.rate_Hz) {
    report(place, "the band ends at " + digits(equal.band_high_Hz) +
                      " Hz, above half of the servo rate of " + digits(protocol_.rate_Hz) + " Hz");
  }
  if (equal.rms_N && *equal.rms_N > protocol_.force_limit_N) {
    report(place + "/rms_N", digits(*equal.rms_N) + " N are above the force limit of " +
                                 digits(protocol_.force_limit_N) + " N (/device/force_limit_N)");
  }
  if (!equal.to_model.empty() && !models_.contains(equal.to_model)) {
    report(place + "/to_model", unknown("force model", equal.to_model, models_));
  }
  for (const auto& [id, at] : texts_of(stimulus.model, pointer + "/model")) {
    const auto model = models_.find(id);
    if (model == models_.end()) continue;
    // The model that the others are made equal to is compared as it is by default: an amplitude of
    // its own would make it the only one of another strength.
    if (!model->second->amplitude_parameter) {
      if (id == equal.to_model) continue;
      report(at, "the model " + in_quotes(id) +
                     " has no amplitude that could make its texture force equal");
    } else if (stimulus.parameters.contains(*model->second->amplitude_parameter)) {
      report_key(pointer_to(pointer + "/parameters", *model->second->amplitude_parameter),
                 id == equal.to_model ? "the others are made equal to " + in_quotes(id) +
                                            " with this parameter at its default; do not give it"
                                      : "equal_force solves this parameter of " + in_quotes(id) +
                                            "; do not give it");
    }
  }
}

void Meaning::check_flow() {
  std::set<std::string> run_blocks{};
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const std::string pointer = pointer_to("/flow", i);
    if (const auto* const ask = std::get_if<Protocol::Ask>(&protocol_.flow[i])) {
      for (std::size_t j = 0; j < ask->questions.size(); ++j) {
        if (!protocol_.questions.contains(ask->questions[j])) {
          report(pointer_to(pointer + "/ask", j),
                 unknown("question", ask->questions[j], protocol_.questions));
        }
      }
    }
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    if (run == nullptr) continue;
    run_blocks.insert(run->block);
    if (!protocol_.blocks.contains(run->block)) {
      report(pointer + "/run", unknown("block", run->block, protocol_.blocks));
    }
    if (!run->for_each.empty()) {
      iterated.insert(run->for_each);
      if (!protocol_.factors.contains(run->for_each)) {
        report(pointer + "/for_each", unknown("factor", run->for_each, protocol_.factors));
      }
    }
    if (run->break_every_trials > 0 && !run->pause) {
      report(pointer, "break_every_trials needs a \"pause\" that says how long the break is");
    }
    if (run->pause && run->break_every_trials == 0 && run->for_each.empty()) {
      report(pointer + "/pause",
             "nothing says when this pause comes: add break_every_trials or for_each");
    }
  }
  for (const auto& [name, block] : protocol_.blocks) {
    if (!run_blocks.contains(name)) {
      report_key(pointer_to("/blocks", name), "the block " + in_quotes(name) +
                                                  " is never run; add {\"run\": \"" + name +
                                                  "\"} to the flow or take the block out");
    }
  }
  if (protocol_.counterbalance != Protocol::Counterbalance::none && iterated.empty()) {
    report("/counterbalance",
           "there is nothing to counterbalance: no step of the flow has a \"for_each\"");
  }
  constexpr std::size_t kMaximumLevels = 32;
  for (const std::string& name : iterated) {
    const auto factor = protocol_.factors.find(name);
    if (factor != protocol_.factors.end() && factor->second.levels.size() > kMaximumLevels) {
      report(pointer_to("/factors", name) + "/levels",
             "a factor of for_each has at most 32 levels");
    }
  }
}

bool Meaning::check_level(const std::string& factor, const Level& level,
                          const std::string& pointer) {
  const auto found = protocol_.factors.find(factor);
  if (found == protocol_.factors.end()) {
    report_key(pointer, unknown("factor", factor, protocol_.factors));
    return false;
  }
  const std::vector<Level>& levels = found->second.levels;
  if (std::find(levels.begin(), levels.end(), level) != levels.end()) return true;
  std::vector<std::string> names{};
  for (const Level& each : levels) names.push_back(text_of(each));
  report(pointer, in_quotes(text_of(level)) + " is not a level of the factor " + in_quotes(factor) +
                      "; its levels are " + one_of(names) + did_you_mean(text_of(level), names));
  return false;
}

std::vector<const Run*> Meaning::runs_of(const Block& block) const {
  std::vector<const Run*> runs{};
  for (const Protocol::Step& step : protocol_.flow) {
    const auto* const run = std::get_if<Run>(&step);
    if (run != nullptr && run->block == block.name) runs.push_back(run);
  }
  return runs;
}

std::set<std::string> Meaning::factors_set_by(const Block& block, const Run* run) const {
  std::set<std::string> names(block.crossed.begin(), block.crossed.end());
  names.insert(block.drawn.begin(), block.drawn.end());
  for (const FactorLevels& row : block.listed) {
    for (const auto& [name, level] : row) names.insert(name);
  }
  if (run != nullptr && !run->for_each.empty()) names.insert(run->for_each);
  return names;
}

void Meaning::check_block(const Block& block, const std::string& pointer) {
  if (!block.crossed.empty() && !block.listed.empty()) {
    report_key(pointer + "/listed", "crossed and listed exclude each other; keep one");
    return;
  }
  std::map<std::string, std::string> setters{};
  const auto claim = [&](const std::string& factor, const std::string& by, const std::string& at) {
    if (!protocol_.factors.contains(factor)) {
      report(at, unknown("factor", factor, protocol_.factors));
      return;
    }
    const auto [earlier, is_new] = setters.emplace(factor, by);
    if (!is_new) {
      report(at, "the factor " + in_quotes(factor) + " is already set by " + earlier->second);
    }
  };
  for (std::size_t i = 0; i < block.crossed.size(); ++i) {
    claim(block.crossed[i], "crossed", pointer_to(pointer + "/crossed", i));
  }
  for (std::size_t i = 0; i < block.listed.size(); ++i) {
    const std::string row = pointer_to(pointer + "/listed", i);
    for (const auto& [name, level] : block.listed[i]) {
      if (check_level(name, level, pointer_to(row, name))) setters.emplace(name, "listed");
    }
    for (const auto& [name, level] : block.listed.front()) {
      if (!block.listed[i].contains(name)) {
        report(row, "this row does not set " + in_quotes(name) +
                        ", which the first row does; every row sets the same factors");
      }
    }
    for (const auto& [name, level] : block.listed[i]) {
      if (!block.listed.front().contains(name)) {
        report_key(pointer_to(row, name), "the first row does not set " + in_quotes(name) +
                                              "; every row sets the same factors");
      }
    }
  }
  for (std::size_t i = 0; i < block.drawn.size(); ++i) {
    claim(block.drawn[i], "another key of the block", pointer_to(pointer + "/drawn", i));
  }
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    if (run != nullptr && run->block == block.name && setters.contains(run->for_each)) {
      report(pointer_to("/flow", i) + "/for_each",
             "the factor " + in_quotes(run->for_each) + " is already set inside the block");
    }
  }
  if (!protocol_.explorations.contains(block.exploration)) {
    report(pointer + "/exploration",
           unknown("exploration", block.exploration, protocol_.explorations));
  }
  check_presented(block, pointer);
  check_question(block, pointer);
  check_order(block, pointer);
}

void Meaning::check_presented(const Block& block, const std::string& pointer) {
  const std::string expected = protocol_.kind == ProtocolKind::selection ? "alternative" : "target";
  for (std::size_t i = 0; i < block.presented.size(); ++i) {
    const Protocol::Presented& presented = block.presented[i];
    const std::string place = pointer_to(pointer + "/presented", i);
    if (presented.role != expected) {
      report(place + "/role", "in this kind of protocol every surface is " + in_quotes(expected));
    }
    for (const auto& [factor, level] : presented.with) {
      check_level(factor, level, pointer_to(place + "/with", factor));
    }
    const auto stimulus = protocol_.stimuli.find(presented.stimulus);
    if (stimulus == protocol_.stimuli.end()) {
      report(place + "/stimulus", unknown("stimulus", presented.stimulus, protocol_.stimuli));
      continue;
    }
    std::set<std::string> needed{stimulus->second.model.factor, stimulus->second.texture.factor};
    for (const auto& [name, binding] : stimulus->second.parameters) needed.insert(binding.factor);
    needed.erase("");
    for (const Run* const run : runs_of(block)) {
      const std::set<std::string> given = factors_set_by(block, run);
      for (const std::string& factor : needed) {
        if (given.contains(factor) || presented.with.contains(factor)) continue;
        report(place, "the stimulus " + in_quotes(presented.stimulus) + " needs the factor " +
                          in_quotes(factor) +
                          ", which nothing sets: cross, list or draw it, run the block for_each of "
                          "its levels, or fix it here with \"with\"");
      }
    }
    for (const auto& [factor, level] : presented.with) {
      if (!needed.contains(factor)) {
        report_key(pointer_to(place + "/with", factor),
                   "the stimulus " + in_quotes(presented.stimulus) +
                       " does not depend on the factor " + in_quotes(factor));
      }
    }
  }
}

void Meaning::check_question(const Block& block, const std::string& pointer) {
  const Protocol::TrialQuestionTemplate& question = block.question;
  const std::string place = pointer + "/question";
  for (std::size_t i = 0; i < question.pictures.size(); ++i) {
    const std::string& name = question.pictures[i];
    const std::string at = pointer_to(place + "/pictures", i);
    const auto texture = protocol_.textures.find(name);
    const auto here = question.pictures.begin() + static_cast<std::ptrdiff_t>(i);
    if (texture == protocol_.textures.end()) {
      report(at, unknown("texture", name, protocol_.textures));
    } else if (!texture->second.picture) {
      report(at, "the texture " + in_quotes(name) + " has no \"picture\" to show");
    }
    if (std::find(question.pictures.begin(), here, name) != here) {
      report(at, "the picture of " + in_quotes(name) + " is listed twice");
    }
  }
  if (question.pictures.empty()) {
    for (const char* const key : {"reshuffle_pictures", "pictures_after_feeling"}) {
      if (question.reshuffle_pictures || question.pictures_after_feeling) {
        if (document_.root().at("blocks").at(block.name).at("question").contains(key)) {
          report_key(place + "/" + key, "this question shows no pictures to choose from");
        }
      }
    }
  } else if (question.pictures_after_feeling && question.allow_revisit) {
    report(place + "/pictures_after_feeling",
           "whoever may go back to a surface feels it with the pictures in view; set "
           "allow_revisit to false");
  }
  switch (protocol_.kind) {
    case ProtocolKind::selection:
      if (block.presented.size() < 2) {
        report(pointer + "/presented", "a selection needs at least two surfaces to choose from");
      }
      if (!question.pictures.empty()) {
        report(place + "/pictures",
               "in a selection the options are the surfaces felt; the picture of the texture is "
               "shown when realism_standard is \"photograph\"");
      }
      if (!question.correct_factor.empty()) {
        report(place + "/correct_factor", "no answer of a selection is right or wrong");
      }
      if (protocol_.realism_standard == RealismStandard::physical_sample &&
          question.experimenter_prompt.find("{code}") == std::string::npos) {
        report(place,
               "with the standard \"physical_sample\" the experimenter has to be told which "
               "sample to place: add \"experimenter_prompt\" with {code} in it, such as "
               "\"Place sample {code} beside the device.\"");
      }
      break;
    case ProtocolKind::matching:
      if (block.presented.size() < 2) {
        report(pointer + "/presented", "a matching needs at least two surfaces to assign");
      }
      if (question.pictures.size() != block.presented.size()) {
        report(place + (question.pictures.empty() ? "" : "/pictures"),
               "a matching needs as many pictures as surfaces, but there are " +
                   std::to_string(question.pictures.size()) + " and " +
                   std::to_string(block.presented.size()));
      }
      if (question.allow_cannot_tell) {
        report(place + "/allow_cannot_tell",
               "in a matching every surface gets a picture; there is no \"cannot tell\"");
      }
      if (!question.correct_factor.empty()) {
        report(place + "/correct_factor",
               "in a matching the right answers are the textures felt; take this key out");
      }
      break;
    case ProtocolKind::recognition:
      if (block.presented.size() != 1) {
        report(pointer + "/presented", "a recognition presents exactly one surface per trial");
      }
      if (question.pictures.empty()) {
        report(place, "a recognition needs \"pictures\" to choose from");
      }
      if (question.correct_factor.empty()) {
        report(place,
               "a recognition needs \"correct_factor\": the factor whose level is the right "
               "picture");
        break;
      }
      if (!protocol_.factors.contains(question.correct_factor)) {
        report(place + "/correct_factor",
               unknown("factor", question.correct_factor, protocol_.factors));
        break;
      }
      for (const Run* const run : runs_of(block)) {
        if (!factors_set_by(block, run).contains(question.correct_factor)) {
          report(place + "/correct_factor", "nothing sets the factor " +
                                                in_quotes(question.correct_factor) +
                                                " in the trials of this block");
        }
      }
      break;
  }
  if (block.feedback != Block::Feedback::none && protocol_.kind == ProtocolKind::selection) {
    report(pointer + "/feedback",
           "feedback needs a correct answer, and no answer of a selection is right or wrong");
  }
  check_criterion(block, pointer);
}

void Meaning::check_criterion(const Block& block, const std::string& pointer) {
  if (!block.until) return;
  const Protocol::Criterion& criterion = *block.until;
  const std::string place = pointer + "/until";
  if (protocol_.kind == ProtocolKind::selection) {
    report(place,
           "a criterion needs right answers, and no answer of a selection is right or "
           "wrong");
  }
  if (criterion.correct > criterion.of_last) {
    report(place + "/correct", "nobody can get " + std::to_string(criterion.correct) +
                                   " right of " + std::to_string(criterion.of_last));
  }
  if (criterion.correct > criterion.maximum_trials) {
    report(place + "/maximum_trials",
           "the block ends after " + std::to_string(criterion.maximum_trials) + " trials, before " +
               std::to_string(criterion.correct) + " can be right");
  }
}

void Meaning::check_order(const Block& block, const std::string& pointer) {
  for (const auto& [factor, maximum] : block.maximum_in_a_row) {
    const std::string at = pointer_to(pointer + "/maximum_in_a_row", factor);
    if (!protocol_.factors.contains(factor)) {
      report_key(at, unknown("factor", factor, protocol_.factors));
      return;
    }
    const bool is_row_factor =
        std::find(block.crossed.begin(), block.crossed.end(), factor) != block.crossed.end() ||
        (!block.listed.empty() &&
         std::all_of(block.listed.begin(), block.listed.end(),
                     [&name = factor](const FactorLevels& row) { return row.contains(name); }));
    if (!is_row_factor) {
      report_key(at, "only factors that the block crosses or lists can be kept apart");
      return;
    }
  }
  const auto known = [this](const std::string& name) { return protocol_.factors.contains(name); };
  if (!std::all_of(block.crossed.begin(), block.crossed.end(), known)) return;
  const std::size_t rows = row_count(protocol_, block);
  const std::size_t trials = rows * static_cast<std::size_t>(block.repetitions);
  if (trials > kMaximumTrials) {
    report(pointer, "this block has more than " + std::to_string(kMaximumTrials) +
                        " trials; nobody sits through that");
    return;
  }
  if (block.until && trials < static_cast<std::size_t>(block.until->maximum_trials)) {
    report(pointer + "/until/maximum_trials",
           "up to " + std::to_string(block.until->maximum_trials) +
               " trials may be needed, but the block has " + std::to_string(trials) + "; with " +
               std::to_string(rows) + " per repetition it needs repetitions " +
               std::to_string((static_cast<std::size_t>(block.until->maximum_trials) + rows - 1) /
                              rows));
  }
  if (block.positions == Block::Positions::balanced && !block.until &&
      trials % block.presented.size() != 0) {
    report(pointer + "/positions",
           "balanced positions need a multiple of " + std::to_string(block.presented.size()) +
               " trials, one per surface, but the block has " + std::to_string(trials));
  }
  if (block.maximum_in_a_row.empty()) return;
  const OrderProblem problem = order_problem(block, rows_of(protocol_, block));
  if (block.order == Block::Order::fixed) {
    std::vector<std::size_t> order(problem.trials);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    if (!meets(problem, order)) {
      report(pointer + "/maximum_in_a_row",
             "the fixed order of this block does not keep to it; use \"shuffle\" or write the "
             "rows in another order");
    }
  } else if (!some_order(problem)) {
    report(pointer + "/maximum_in_a_row",
           "no order of the block's " + std::to_string(problem.trials) +
               " trials keeps to it; allow more in a row or add other levels between");
  }
}

void Meaning::check_expectation(const Trial& trial, const std::string& pointer) {
  using Expectation = ObserverDeclaration::Expectation;
  if (protocol_.observer.expectation == Expectation::none) return;
  std::set<std::string> expected{};
  for (const PlannedPresentation& planned : trial.presentations) {
    expected.insert(planned.stimulus.texture);
  }
  const auto& pictures = protocol_.blocks.at(trial.block).question.pictures;
  expected.insert(pictures.begin(), pictures.end());
  expected.erase("");
  for (const std::string& name : expected) {
    const Texture& texture = protocol_.textures.at(name);
    if (protocol_.observer.expectation == Expectation::true_surface && !texture.true_height_field) {
      report(pointer_to("/textures", name),
             "the observer expects the true surface of this texture: give it a "
             "\"true_height_field\"");
    }
    if (protocol_.observer.expectation == Expectation::prior && !texture.prior) {
      report(pointer_to("/textures", name),
             "the observer expects the stated prior of this texture: give it a \"prior\"");
    }
  }
  if (protocol_.kind == ProtocolKind::selection && expected.empty()) {
    report(pointer + "/presented", "nothing can be expected of surfaces without a texture");
  }
}

void Meaning::check_size() {
  std::size_t trials = 0;
  std::size_t rows = 1;
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    if (run == nullptr) continue;
    const Block& block = protocol_.blocks.at(run->block);
    std::size_t runs = 1;
    if (!run->for_each.empty()) {
      runs = protocol_.factors.at(run->for_each).levels.size();
      // At most two rows per level; the product is cut off long before it could wrap.
      if (iterated.insert(run->for_each).second) rows = std::min(rows * 2 * runs, 2 * kMaximumRows);
    }
    trials += runs * row_count(protocol_, block) * static_cast<std::size_t>(block.repetitions);
    if (trials > kMaximumSessionTrials) {
      return report(pointer_to("/flow", i), "up to here the session has more than " +
                                                std::to_string(kMaximumSessionTrials) +
                                                " trials; nobody sits through that");
    }
  }
  if (protocol_.counterbalance != Protocol::Counterbalance::none && rows > kMaximumRows) {
    report("/counterbalance",
           "there would be more orders than people; iterate fewer factors with for_each");
  }
}

/// The protocol with every combination of levels that its blocks can come to, once, without chance.
Protocol Meaning::with_every_possible_trial() {
  Protocol every = protocol_;
  for (auto& [name, block] : every.blocks) {
    block.order = Block::Order::fixed;
    block.positions = Block::Positions::as_listed;
    block.repetitions = 1;
    block.maximum_in_a_row.clear();
    block.until.reset();
    std::size_t combinations = row_count(protocol_, block);
    for (const std::string& factor : block.drawn) {
      combinations =
          std::min(combinations * protocol_.factors.at(factor).levels.size(), kMaximumRows);
    }
    if (combinations > kMaximumSessionTrials) {
      report(pointer_to("/blocks", name) + "/drawn",
             "more than " + std::to_string(kMaximumSessionTrials) +
                 " different trials could be drawn; draw fewer factors or levels");
      continue;
    }
    if (block.listed.empty()) {
      block.crossed.insert(block.crossed.end(), block.drawn.begin(), block.drawn.end());
    }
    for (const std::string& factor : block.drawn) {
      std::vector<FactorLevels> longer{};
      for (const FactorLevels& row : block.listed) {
        for (const Level& level : protocol_.factors.at(factor).levels) {
          longer.push_back(row);
          longer.back()[factor] = level;
        }
      }
      block.listed = std::move(longer);
    }
    block.drawn.clear();
  }
  return every;
}

void Meaning::check_trials() {
  const Protocol every = with_every_possible_trial();
  if (!found_.empty()) return;
  const Plan plan = make_plan(every, Allocation{});
  for (const Trial& trial : plan.trials) {
    const std::string pointer = pointer_to("/blocks", trial.block);
    const std::string presented = pointer + "/presented";
    std::set<std::string> items{};
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.item.empty()) {
        report(presented,
               "a surface without a texture needs an \"item\" as its name in the answers");
      } else if (!items.insert(planned.item).second) {
        report(presented, "two surfaces of a trial count as " + in_quotes(planned.item) +
                              " in the answers; give each an \"item\" of its own");
      }
    }
    const std::string& texture = trial.presentations.front().stimulus.texture;
    std::set<std::string> pictures(trial.question.correct.begin(), trial.question.correct.end());
    for (const Option& option : trial.question.options) pictures.erase(option.value);
    if (!pictures.empty()) {
      report(pointer + "/question/pictures",
             "the right answer " + in_quotes(*pictures.begin()) + " is not among the pictures");
    }
    switch (protocol_.kind) {
      case ProtocolKind::selection:
        for (const PlannedPresentation& planned : trial.presentations) {
          if (planned.stimulus.texture != texture) {
            report(presented, "the surfaces of a trial show different textures (" +
                                  in_quotes(texture) + " and " +
                                  in_quotes(planned.stimulus.texture) +
                                  "); a selection compares renderings of one texture");
          }
        }
        if (protocol_.realism_standard == RealismStandard::photograph &&
            !trial.question.standard_picture) {
          report(texture.empty() ? presented : pointer_to("/textures", texture),
                 "realism is measured against a photograph here: give the texture a \"picture\"");
        }
        if (protocol_.realism_standard == RealismStandard::physical_sample &&
            (texture.empty() || protocol_.textures.at(texture).code.empty())) {
          report(texture.empty() ? presented : pointer_to("/textures", texture),
                 "realism is measured against a physical sample here: give the texture the "
                 "\"code\" on its label");
        }
        break;
      case ProtocolKind::matching:
        break;
      case ProtocolKind::recognition:
        if (!texture.empty() && trial.question.correct.front() != texture) {
          report(pointer + "/question/correct_factor",
                 "the right answer would be " + in_quotes(trial.question.correct.front()) +
                     ", but what is felt is " + in_quotes(texture));
        }
        break;
    }
    check_expectation(trial, pointer);
  }
}

}  // namespace

std::vector<Diagnostic> check_meaning(const Protocol& protocol, const JsonDocument& document,
                                      const std::vector<ModelDeclaration>& models) {
  return Meaning(protocol, document, models).check();
}

}  // namespace asperity
