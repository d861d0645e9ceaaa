// Implements the lenient reading of stored protocols.

#include "protocols/file/stored_protocol.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/file/declared_estimation.h"
#include "protocols/file/protocol_from_json.h"
#include "protocols/keys/conditions.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"
#include "protocols/kind_keys/discrimination_design.h"
#include "protocols/texts/protocol_texts.h"
#include "protocols/texts/translatable_texts.h"

namespace asperity {

namespace {

using Json = nlohmann::json;
using Block = Protocol::Block;

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

/// Removes the texts, and empties those in lists.
void remove_texts(Json& protocol) {
  for (const TranslatableText& each : translatable_texts(protocol)) {
    if (each.shape.is_value) continue;
    const Json::json_pointer place(each.pointer);
    Json& owner = protocol.at(place.parent_pointer());
    if (owner.is_object()) {
      owner.erase(place.back());
    } else {
      protocol.at(place) = "";
    }
  }
  if (protocol.is_object()) protocol.erase("language");
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

/// What this version does not know of a block is not replaced by a default.
void keep_unknown(Block& block, const Json& stated, const std::vector<FormProblem>& unread) {
  const std::string at = pointer_to("/blocks", block.name);
  if (!has_form(unread, at + "/design")) block.own = DiscriminationBlock{nullptr};
  if (!has_form(unread, at + "/kind")) block.kind = text_in(stated, "kind");
  if (!has_form(unread, at + "/phase")) block.phase = Phase::practice;  // not analysed
}

/// A procedure that this version cannot run has no tracks.
void complete_stored_block(Block& block, const Json& stated, const Protocol& protocol,
                           const std::vector<FormProblem>& unread) {
  const DiscriminationDesign* const design = block.design();
  if (design == nullptr) block.own = DiscriminationBlock{};
  complete_block(block, stated, protocol, {});
  if (design == nullptr) block.own = DiscriminationBlock{nullptr};
  if (!block.procedure) return;
  const std::string at = pointer_to("/blocks", block.name) + "/procedure";
  const bool is_read =
      std::none_of(unread.begin(), unread.end(), [&at](const FormProblem& problem) {
        const bool is_of_procedure = problem.pointer == at || problem.pointer.starts_with(at + '/');
        return is_of_procedure && !problem.is_at_key;  // a key of another version is in addition
      });
  std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const bool can_be_run = std::all_of(tracks.begin(), tracks.end(),
                                      [](const auto& each) { return problems_of(each).empty(); });
  const bool is_needed = chooses_levels_from_answers(block);
  if (design == nullptr || !is_read || (!can_be_run && is_needed)) tracks.clear();
}

}  // namespace

StoredProtocol::Senses StoredProtocol::senses() const {
  Senses senses{};
  if (has_form(unread, "/environment/vision")) senses.vision = protocol.vision;
  if (has_form(unread, "/environment/masking_noise/kind")) senses.noise = protocol.masking_noise;
  return senses;
}

std::string without_texts(const std::string& source) {
  Json protocol = Json::parse(source, nullptr, false);
  if (protocol.is_discarded()) return source;
  remove_texts(protocol);
  write_options_alike(protocol);
  return protocol.dump();
}

std::string language_of(const std::string& source) {
  const std::string stated = text_in(Json::parse(source, nullptr, false), "language");
  return stated.empty() ? "en" : stated;
}

namespace {

StoredProtocol as_written(const Json& stored) {
  std::vector<InapplicableKey> permitted = inapplicable_keys(stored);
  std::erase_if(permitted, [](const InapplicableKey& key) { return !key.is_permitted; });
  const Json root = without_keys(stored, permitted);
  StoredProtocol read{.compared_parameter = parameter_compared_in(root)};
  Protocol& protocol = read.protocol;
  read.unread = read_keys(kProtocolTable, root, "", protocol);
  if (!has_form(read.unread, "/kind")) protocol.kind = text_in(root, "kind");
  complete_estimation(protocol);
  for (auto& [name, question] : protocol.questions) {
    const std::string condition = pointer_to("/questions", name) + "/if";
    if (!has_form(read.unread, condition)) question.condition.reset();
  }
  if (protocol.groups && !protocol.factors.contains(protocol.groups->factor)) {
    protocol.groups.reset();
  } else if (protocol.groups) {
    const std::string levels = pointer_to("/factors", protocol.groups->factor) + "/levels";
    if (!has_form(read.unread, "/groups") || !has_form(read.unread, levels)) {
      protocol.groups->assigned = Protocol::Groups::Assignment::by_experimenter;  // in no blocks
    }
  }
  for (auto& [name, block] : protocol.blocks) {
    const Json& stated = member_of(member_of(root, "blocks"), name);
    keep_unknown(block, stated, read.unread);
    complete_stored_block(block, stated, protocol, read.unread);
    read.surface_factors[name] = surface_factors_in(root, stated);
  }
  return read;
}

}  // namespace

StoredProtocol stored_protocol(const std::string& source) {
  const Json root = Json::parse(source, nullptr, false);
  StoredProtocol read = as_written(root);
  const auto with_values = with_design_values(root, read.protocol);
  return with_values ? as_written(*with_values) : read;
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
