#include "protocols/analysis_declaration.h"

#include <array>

#include <nlohmann/json.hpp>

#include "analysis/number_text.h"
#include "protocols/protocol_from_json.h"

namespace asperity {

namespace {

constexpr std::array kTests{
    TestName{"selection", "pairs", "every pair of items: is one chosen more often than the other"},
    TestName{"selection", "target_pairs", "only the pairs of the target with each other item"},
    TestName{"selection", "preference", "are all items chosen equally often"},
    TestName{"selection", "position", "are all positions chosen equally often"},
    TestName{"selection", "textures", "is the target chosen equally often with every texture"},
    TestName{"matching", "items", "are more items right than by chance"},
    TestName{"matching", "whole", "are more goes wholly right than by chance"},
    TestName{"matching", "textures", "of every texture: is it right more often than by chance"},
    TestName{"matching", "sexes", "do women and men differ"},
    TestName{"recognition", "right", "are more answers right than by chance"},
    TestName{"recognition", "textures",
             "of every texture: is it recognised more often than by chance"},
    TestName{"recognition", "information", "do the answers depend on what was felt"},
    TestName{"recognition", "sexes", "do women and men differ"},
    TestName{"magnitude", "spacing", "do estimates depend on the spacing"},
    TestName{"magnitude", "interaction", "does the curve over spacings depend on the condition"},
    TestName{"magnitude", "condition", "do estimates depend on the condition"},
    TestName{"magnitude", "peaks", "of every two conditions: do their peaks lie apart"}};

}  // namespace

std::span<const TestName> test_names() { return kTests; }

AnalysisDeclaration analysis_declared_in(const nlohmann::json& protocol) {
  AnalysisDeclaration declared{};
  if (!protocol.is_object()) return declared;
  const auto found = protocol.find("analysis");
  if (found == protocol.end() || !found->is_object()) return declared;
  if (const auto target = found->find("target"); target != found->end() && target->is_string()) {
    declared.target = target->get<std::string>();
  }
  const auto family = found->find("family");
  if (family == found->end() || !family->is_array()) return declared;
  for (const nlohmann::json& name : *family) {
    if (name.is_string()) declared.family.push_back(name.get<std::string>());
  }
  return declared;
}

std::optional<EstimationDeclaration> estimation_declared_in(const nlohmann::json& protocol) {
  if (!protocol.is_object()) return {};
  const auto found = protocol.find("estimation");
  if (found == protocol.end() || !found->is_object()) return {};
  const auto text_at = [&found](const char* key) {
    const auto member = found->find(key);
    return member == found->end() || !member->is_string() ? std::string{}
                                                          : member->get<std::string>();
  };
  EstimationDeclaration declared{.spacing = text_at("spacing"), .condition = text_at("condition")};
  const nlohmann::json none = nlohmann::json::object();
  const auto member_of = [&none](const nlohmann::json& object,
                                 const std::string& key) -> const nlohmann::json& {
    const auto member = object.is_object() ? object.find(key) : object.end();
    return member == object.end() ? none : *member;
  };
  const auto levels_of = [&](const std::string& factor) -> const nlohmann::json& {
    return member_of(member_of(member_of(protocol, "factors"), factor), "levels");
  };
  for (const nlohmann::json& level : levels_of(declared.condition)) {
    if (level.is_number()) {
      declared.conditions.push_back(number_text(level.get<double>()));
    } else if (level.is_string()) {
      declared.conditions.push_back(level.get<std::string>());
    }
  }
  const nlohmann::json& textures = member_of(protocol, "textures");
  for (const nlohmann::json& level : levels_of(declared.spacing)) {
    if (level.is_number()) {
      declared.spacing_m.emplace(number_text(level.get<double>()), level.get<double>());
    } else if (level.is_string()) {
      const auto name = level.get<std::string>();
      const nlohmann::json& spacing_m = member_of(member_of(textures, name), "spacing_m");
      if (spacing_m.is_number()) declared.spacing_m.emplace(name, spacing_m.get<double>());
    }
  }
  return declared;
}

AnalysisDeclaration declared_analysis(const std::string& source) {
  return analysis_declared_in(nlohmann::json::parse(source, nullptr, false));
}

std::optional<EstimationDeclaration> declared_estimation(const std::string& source) {
  return estimation_declared_in(nlohmann::json::parse(source, nullptr, false));
}

}  // namespace asperity
