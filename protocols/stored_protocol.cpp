#include "protocols/stored_protocol.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/number_text.h"
#include "protocols/protocol_from_json.h"

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

/// The texts of a list; its other entries are left out.
std::vector<std::string> texts_in(const Json& object, const std::string& key) {
  std::vector<std::string> texts{};
  const Json& list = member_of(object, key);
  if (!list.is_array()) return texts;
  for (const Json& one : list) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
}

/// Levels as text; a number with itself.
std::vector<std::pair<std::string, std::optional<double>>> levels_in(const Json& protocol,
                                                                     const std::string& factor) {
  std::vector<std::pair<std::string, std::optional<double>>> levels{};
  const Json& list = member_of(member_of(member_of(protocol, "factors"), factor), "levels");
  if (!list.is_array()) return levels;
  for (const Json& level : list) {
    if (level.is_number()) {
      levels.emplace_back(number_text(level.get<double>()), level.get<double>());
    } else if (level.is_string()) {
      levels.emplace_back(level.get<std::string>(), std::nullopt);
    }
  }
  return levels;
}

/// Calls `use(name, value)` for the members of an object that are objects themselves.
template <class Use>
void for_each_object(const Json& object, const Use& use) {
  if (!object.is_object()) return;
  for (const auto& [name, value] : object.items()) {
    if (value.is_object()) use(name, value);
  }
}

}  // namespace

AnalysisDeclaration analysis_declared_in(const Json& protocol) {
  const Json& analysis = member_of(protocol, "analysis");
  AnalysisDeclaration declared{.family = texts_in(analysis, "family")};
  if (member_of(analysis, "target").is_string()) declared.target = text_in(analysis, "target");
  return declared;
}

std::optional<EstimationDeclaration> estimation_declared_in(const Json& protocol) {
  const Json& estimation = member_of(protocol, "estimation");
  if (!estimation.is_object()) return {};
  EstimationDeclaration declared{.spacing = text_in(estimation, "spacing"),
                                 .condition = text_in(estimation, "condition")};
  for (const auto& [level, number] : levels_in(protocol, declared.condition)) {
    declared.conditions.push_back(level);
  }
  const Json& textures = member_of(protocol, "textures");
  for (const auto& [level, number] : levels_in(protocol, declared.spacing)) {
    const std::optional<double> spacing_m =
        number ? number : number_at(member_of(textures, level), "spacing_m");
    if (spacing_m) declared.spacing_m.emplace(level, *spacing_m);
  }
  return declared;
}

StoredProtocol stored_protocol(const std::string& source) {
  const Json root = Json::parse(source, nullptr, false);
  StoredProtocol read{.title = text_in(root, "title"),
                      .analysis = analysis_declared_in(root),
                      .estimation = estimation_declared_in(root)};
  for_each_object(member_of(root, "factors"), [&](const std::string& name, const Json& factor) {
    read.factors[name] = {.meaning = text_in(factor, "meaning"), .unit = text_in(factor, "unit")};
  });
  for_each_object(member_of(root, "questions"), [&](const std::string& name, const Json& asked) {
    read.questions[name] = {.prompt = text_in(asked, "prompt"),
                            .form = text_in(asked, "form"),
                            .minimum = number_at(asked, "minimum"),
                            .maximum = number_at(asked, "maximum"),
                            .options = texts_in(asked, "options")};
  });
  for_each_object(member_of(root, "blocks"), [&](const std::string& name, const Json& block) {
    const Json& asked = member_of(block, "question");
    if (asked.is_object()) {
      read.trial_questions[name] = {.name = text_in(asked, "name"),
                                    .prompt = text_in(asked, "prompt")};
    }
  });
  return read;
}

}  // namespace asperity
