#include "protocols/analysis_declaration.h"

#include <array>

#include <nlohmann/json.hpp>

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
    TestName{"recognition", "sexes", "do women and men differ"}};

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

AnalysisDeclaration declared_analysis(const std::string& source) {
  return analysis_declared_in(nlohmann::json::parse(source, nullptr, false));
}

}  // namespace asperity
