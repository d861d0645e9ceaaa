// Implements the lenient reading of stored protocols.

#include "protocols/file/stored_protocol.h"

#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/scale_form.h"
#include "protocols/design/discrimination_design.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/protocol.h"
#include "protocols/file/declared_estimation.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

using Json = nlohmann::json;

const Json& member_of(const Json& object, const std::string& key) {
  static const Json kNone{};
  if (!object.is_object()) return kNone;
  const auto found = object.find(key);
  return found == object.end() ? kNone : *found;
}

std::string text_in(const Json& object, const std::string& key) {
  const Json& value = member_of(object, key);
  return value.is_string() ? value.get<std::string>() : std::string{};
}

std::optional<double> number_at(const Json& object, const std::string& key) {
  const Json& value = member_of(object, key);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// The texts in a list; other entries are skipped.
std::vector<std::string> texts_in(const Json& object, const std::string& key) {
  std::vector<std::string> texts{};
  const Json& list = member_of(object, key);
  if (!list.is_array()) return texts;
  for (const Json& one : list) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
}

/// Calls `use(name, value)` for the members of an object that are objects.
template <class Use>
void for_each_object(const Json& object, const Use& use) {
  if (!object.is_object()) return;
  for (const auto& [name, value] : object.items()) {
    if (value.is_object()) use(name, value);
  }
}

/// A stimulus with the levels that a surface of a block fixes.
Json presented_stimulus(const Json& protocol, const Json& surface) {
  Json stimulus = member_of(member_of(protocol, "stimuli"), text_in(surface, "stimulus"));
  const Json& fixed = member_of(surface, "with");
  Json flat = stimulus.is_object() ? stimulus.flatten() : Json::object();
  for (auto& [place, value] : flat.items()) {
    if (!place.ends_with("/factor") || !value.is_string()) continue;
    const Json& level = member_of(fixed, value.get<std::string>());
    if (!level.is_null()) value = level;
  }
  return flat;
}

/// The factors whose levels determine the surfaces of a block, each once, by name.
std::vector<std::string> surface_factors_in(const Json& protocol, const Json& block) {
  std::set<std::string> factors{};
  const Json& surfaces = member_of(block, "presented");
  if (surfaces.is_array()) {
    for (const Json& surface : surfaces) {
      const Json& stimulus =
          member_of(member_of(protocol, "stimuli"), text_in(surface, "stimulus"));
      if (!stimulus.is_object()) continue;
      const Json flat = stimulus.flatten();
      for (const auto& [place, value] : flat.items()) {
        if (!place.ends_with("/factor") || !value.is_string()) continue;
        const auto factor = value.get<std::string>();
        if (member_of(member_of(surface, "with"), factor).is_null()) factors.insert(factor);
      }
    }
  }
  const Json& vary = member_of(block, "vary");
  if (const std::string parameter = text_in(vary, "parameter"); !parameter.empty()) {
    const std::string factor = text_in(vary, "factor");
    factors.insert(factor.empty() ? parameter : factor);
  }
  return {factors.begin(), factors.end()};
}

/// "friction" for "/parameters/friction" and "/parameters/friction/factor"; nullopt for what is not a parameter.
std::optional<std::string> parameter_at(const std::string& place) {
  for (const std::string_view of : {"/parameters/", "/equal_force/"}) {
    if (!place.starts_with(of)) continue;
    const std::string name = place.substr(of.size());
    return name.substr(0, name.find('/'));
  }
  return std::nullopt;
}

/// The parameters in which the surfaces of a block differ; nullopt if they differ in anything else.
std::optional<std::set<std::string>> parameters_compared(const Json& protocol, const Json& block) {
  const Json& surfaces = member_of(block, "presented");
  const std::string paired = text_in(member_of(block, "all_pairs"), "factor");
  std::map<std::string, std::set<Json>> values{};
  std::map<std::string, std::size_t> present{};
  if (!surfaces.is_array()) return std::nullopt;
  for (const Json& surface : surfaces) {
    const Json stimulus = presented_stimulus(protocol, surface);
    for (const auto& [place, value] : stimulus.items()) {
      values[place].insert(value);
      ++present[place];
    }
  }
  std::set<std::string> parameters{};
  for (const auto& [place, different] : values) {
    const bool varies_in_pairs =
        !paired.empty() && place.ends_with("/factor") && different.contains(Json(paired));
    if (!varies_in_pairs && different.size() == 1 && present[place] == surfaces.size()) continue;
    const std::optional<std::string> parameter = parameter_at(place);
    if (!parameter) return std::nullopt;
    parameters.insert(*parameter);
  }
  return parameters;
}

std::optional<std::string> parameter_compared_in(const Json& protocol) {
  std::set<std::string> parameters{};
  bool are_alone = true;
  for_each_object(member_of(protocol, "blocks"), [&](const std::string&, const Json& block) {
    const std::string own_kind = text_in(block, "kind");
    if ((own_kind.empty() ? text_in(protocol, "kind") : own_kind) != "selection") return;
    const std::string phase = text_in(block, "phase");
    if (!phase.empty() && phase != "main") return;
    const auto own = parameters_compared(protocol, block);
    if (own) parameters.insert(own->begin(), own->end());
    are_alone = are_alone && own;
  });
  return are_alone && parameters.size() == 1 ? std::optional(*parameters.begin()) : std::nullopt;
}

/// The locations of texts in a protocol; "*" matches every name and every list index.
constexpr std::array kTextPlaces{
    "/title",
    "/language",
    "/description",
    "/instructions",
    "/consent/statement",
    "/textures/*/note",
    "/factors/*/meaning",
    "/questions/*/prompt",
    "/questions/*/options/*/text",
    "/questions/*/scale/labels",
    "/blocks/*/question/prompt",
    "/blocks/*/question/options/*/text",
    "/blocks/*/question/scale/labels",
    "/blocks/*/question/tie/text",
    "/blocks/*/questions/*/prompt",
    "/blocks/*/questions/*/options/*/text",
    "/blocks/*/questions/*/scale/labels",
    "/blocks/*/questions/*/tie/text",
    "/blocks/*/page_prompt",
    "/flow/*/screen",
    "/flow/*/break/text",
    "/flow/*/break/drift_check/text",
    "/flow/*/break/drift_check/tip_text",
    "/flow/*/pause/text",
    "/flow/*/pause/drift_check/text",
    "/flow/*/pause/drift_check/tip_text",
    "/resume/screens",
};

/// Removes the value at `place` below `value`.
void remove_at(std::string_view place, Json& value) {
  const std::size_t end = std::min(place.find('/', 1), place.size());
  const std::string name(place.substr(1, end - 1));
  const std::string_view rest = place.substr(end);
  if (name == "*") {
    if (!value.is_structured()) return;
    for (Json& one : value) remove_at(rest, one);
  } else if (value.is_object() && rest.empty()) {
    value.erase(name);
  } else if (value.is_object() && value.contains(name)) {
    remove_at(rest, value.at(name));
  }
}

/// Writes options without a separate shown text in one form: both a plain text and an object are permitted.
void write_options_alike(Json& protocol) {
  if (!member_of(protocol, "questions").is_object()) return;
  for (Json& question : protocol.at("questions")) {
    if (!member_of(question, "options").is_array()) continue;
    for (Json& option : question.at("options")) {
      if (option.is_object() && option.size() == 1 && option.contains("value")) {
        option = Json(option.at("value"));
      }
    }
  }
}

StoredProtocol::TrialQuestion trial_question_in(const Json& asked) {
  const Json& scale = member_of(asked, "scale");
  const std::vector<std::string> labels = texts_in(scale, "labels");
  const auto end_of = [&scale](const char* key, double if_missing) -> std::optional<double> {
    if (!scale.is_object()) return std::nullopt;
    return number_at(scale, key).value_or(if_missing);
  };
  const std::string direction = text_in(asked, "asks_for");
  return {.name = text_in(asked, "name"),
          .prompt = text_in(asked, "prompt"),
          .has_scale = scale.is_object(),
          .low_label = labels.empty() ? std::string() : labels.front(),
          .high_label = labels.empty() ? std::string() : labels.back(),
          .minimum = end_of("minimum", ScaleForm{}.minimum),
          .maximum = end_of("maximum", ScaleForm{}.maximum),
          .points = number_at(scale, "points"),
          .judgement = text_in(asked, "judgement"),
          .asks_for_less = direction.empty() ? std::nullopt : std::optional(direction == "less"),
          .rates = text_in(asked, "rates"),
          .confidence_of = text_in(asked, "confidence_of")};
}

/// The number that the surface with this role has for a parameter.
std::optional<double> stored_standard(const Json& protocol, const Json& block,
                                      const std::string& role, const std::string& parameter) {
  const Json& surfaces = member_of(block, "presented");
  if (!surfaces.is_array() || role.empty()) return std::nullopt;
  for (const Json& surface : surfaces) {
    if (text_in(surface, "role") != role) continue;
    if (parameter == kRelativeAmplitude) return 1.0;
    const Json& stimulus = member_of(member_of(protocol, "stimuli"), text_in(surface, "stimulus"));
    return number_at(member_of(stimulus, "parameters"), parameter);
  }
  return std::nullopt;
}

std::optional<Dimension> stored_dimension(const Json& protocol, const Json& block) {
  const Json& vary = member_of(block, "vary");
  Dimension dimension{.factor = text_in(vary, "factor"),
                      .parameter = text_in(vary, "parameter"),
                      .role = text_in(vary, "of"),
                      .standard_role = text_in(vary, "relative_to")};
  if (dimension.parameter.empty()) return std::nullopt;
  if (dimension.factor.empty()) dimension.factor = dimension.parameter;
  for (const LevelMeasure measure : {LevelMeasure::difference, LevelMeasure::percent,
                                     LevelMeasure::ratio, LevelMeasure::decibels}) {
    if (vary.contains(key_of(measure))) dimension.measure = measure;
  }
  dimension.standard =
      stored_standard(protocol, block, dimension.standard_role, dimension.parameter);
  return dimension;
}

/// The number of alternatives of a block whose judged question allows the response "cannot tell"; otherwise 0.
std::size_t unforced_alternatives(const Json& block) {
  const auto is_unforced = [](const Json& asked) {
    return !text_in(asked, "judgement").empty() &&
           member_of(asked, "allow_cannot_tell") == Json(true);
  };
  const Json& several = member_of(block, "questions");
  const bool is_any =
      is_unforced(member_of(block, "question")) ||
      (several.is_array() && std::any_of(several.begin(), several.end(), is_unforced));
  const std::string id = text_in(block, "design");
  const DiscriminationDesign* const design = id.empty() ? &two_alternatives() : find_design(id);
  return is_any && design != nullptr ? design->alternatives() : 0;
}

/// What the tables of keys declare.
void read_declared(const Json& root, StoredProtocol& read) {
  Protocol protocol{};
  const std::vector<FormProblem> unread = read_keys(kProtocolTable, root, "", protocol);
  if (has_form(unread, "/environment/vision")) read.senses.vision = protocol.vision;
  if (has_form(unread, "/environment/masking_noise/kind")) {
    read.senses.noise = protocol.masking_noise;
  }
  read.title = std::move(protocol.title);
  read.analysis = std::move(protocol.analysis);
  complete_estimation(protocol);
  read.estimation = std::move(protocol.estimation);
  read.questions = std::move(protocol.questions);
  for (auto& [name, question] : read.questions) {
    const std::string condition = pointer_to("/questions", name) + "/if";
    if (!has_form(unread, condition)) question.condition.reset();
  }
  if (protocol.groups) {
    read.group_factor = protocol.groups->factor;
    read.groups = level_texts(protocol.factors[read.group_factor]);
    if (has_form(unread, "/groups") && !read.groups.empty()) {
      read.permuted_blocks = permuted_blocks_of(protocol);
    }
  }
  read.factors = std::move(protocol.factors);
}

std::vector<ProcedureSettings> stored_tracks(const Json& protocol, const Json& block) {
  try {
    const Json& stated = member_of(block, "procedure");
    if (!valid_part(stated, kProcedureTable, "").problems.empty()) return {};  // of another version
    Dimension dimension{};
    read_keys(kDimensionTable, member_of(block, "vary"), "", dimension);
    dimension.standard =
        stored_standard(protocol, block, dimension.standard_role, dimension.parameter);
    const DiscriminationDesign* const design = find_design(text_in(block, "design"));
    std::vector<ProcedureSettings> tracks =
        procedure_in(stated, dimension, design == nullptr ? two_alternatives() : *design).tracks;
    if (const std::size_t alternatives = unforced_alternatives(block); alternatives > 0) {
      declare_unforced(alternatives, tracks);
    }
    const bool can_be_used =
        std::all_of(tracks.begin(), tracks.end(),
                    [](const ProcedureSettings& each) { return problems_of(each).empty(); });
    return can_be_used ? tracks : std::vector<ProcedureSettings>{};
  } catch (const std::exception&) {
    return {};  // of a version of the program with other procedures
  }
}

}  // namespace

std::vector<std::string> StoredProtocol::kinds() const {
  std::vector<std::string> kinds{};
  for (const auto& [name, block] : blocks) {
    if (std::find(kinds.begin(), kinds.end(), block.kind) == kinds.end()) {
      kinds.push_back(block.kind);
    }
  }
  return kinds;
}

std::string without_texts(const std::string& source) {
  Json protocol = Json::parse(source, nullptr, false);
  if (protocol.is_discarded()) return source;
  for (const std::string_view place : kTextPlaces) remove_at(place, protocol);
  write_options_alike(protocol);
  return protocol.dump();
}

std::string language_of(const std::string& source) {
  const std::string stated = text_in(Json::parse(source, nullptr, false), "language");
  return stated.empty() ? "en" : stated;
}

StoredProtocol stored_protocol(const std::string& source) {
  const Json root = Json::parse(source, nullptr, false);
  StoredProtocol read{.compared_parameter = parameter_compared_in(root)};
  read_declared(root, read);
  for_each_object(member_of(root, "blocks"), [&](const std::string& name, const Json& block) {
    StoredProtocol::Block made{};
    made.kind = text_in(block, "kind").empty() ? text_in(root, "kind") : text_in(block, "kind");
    made.phase = text_in(block, "phase").empty() ? "main" : text_in(block, "phase");
    made.vary = stored_dimension(root, block);
    made.design = text_in(block, "design");
    const std::string surfaces = text_in(member_of(block, "arrangement"), "surfaces");
    made.is_sequential = surfaces.empty() || surfaces == "sequential";
    made.drawn = texts_in(block, "drawn");
    made.surface_factors = surface_factors_in(root, block);
    made.matched_in = text_in(member_of(block, "equal_roughness"), "matched_in");
    const Json& procedure = member_of(block, "procedure");
    made.has_procedure =
        procedure.is_object() && text_in(procedure, "method") != "constant_stimuli";
    if (made.has_procedure) made.tracks = stored_tracks(root, block);
    if (const Json& catch_trials = member_of(procedure, "catch_trials"); catch_trials.is_object()) {
      made.catch_type = text_in(catch_trials, "type");
      if (made.catch_type.empty()) made.catch_type = text_of(CatchType::easy);
    }
    if (made.vary) {
      read.factors[made.vary->factor].meaning =
          "Value of the parameter " + made.vary->parameter + " of the " + made.vary->role;
    }
    const Json& derived = member_of(block, "derived");
    if (derived.is_object()) {
      for (const auto& [factor, formula] : derived.items()) {
        if (formula.is_string()) {
          read.factors[factor].meaning = "Computed as " + formula.get<std::string>();
        }
      }
    }
    const auto add = [&](const Json& asked) {
      if (!asked.is_object()) return;
      made.questions.push_back(trial_question_in(asked));
      const std::vector<std::string> own = texts_in(asked, "pictures");
      read.pictures.insert(read.pictures.end(), own.begin(), own.end());
    };
    add(member_of(block, "question"));
    const Json& several = member_of(block, "questions");
    if (several.is_array()) {
      for (const Json& asked : several) add(asked);
    }
    if (!made.questions.empty()) read.blocks[name] = std::move(made);
  });
  for (const auto& [name, factor] : read.factors) {
    for (std::string& level : level_texts(factor)) read.pictures.push_back(std::move(level));
  }
  return read;
}

std::size_t count_protocols(const std::vector<std::string>& sources) {
  std::map<std::string, std::map<std::string, std::size_t>> files_by_language{};
  for (const std::string& source : sources) {
    ++files_by_language[without_texts(source)][language_of(source)];
  }
  std::size_t all = 0;
  for (const auto& [content, languages] : files_by_language) {
    all += std::max_element(
               languages.begin(), languages.end(),
               [](const auto& one, const auto& other) { return one.second < other.second; })
               ->second;
  }
  return all;
}

}  // namespace asperity
