// Implements the tests, items and scales of main blocks.

#include "protocols/kinds/analysed_names.h"

#include <utility>
#include <variant>

namespace asperity {

namespace {

/// The names among the levels of a factor; none of a factor that does not exist.
std::vector<std::string> names_among_levels(const Protocol& protocol, const std::string& factor) {
  std::vector<std::string> names{};
  const auto found = protocol.factors.find(factor);
  if (found == protocol.factors.end()) return names;
  for (const Level& level : found->second.levels) {
    if (const auto* const name = std::get_if<std::string>(&level)) names.push_back(*name);
  }
  return names;
}

/// What a surface counts as: its item, or the models that it can have.
std::vector<std::string> items_of(const Protocol& protocol, const Protocol::Presented& surface) {
  if (!surface.item.empty()) return {surface.item};
  const auto stimulus = protocol.stimuli.find(surface.stimulus);
  if (stimulus == protocol.stimuli.end()) return {};
  const Binding<std::string>& model = stimulus->second.model;
  if (model.value) return {*model.value};
  const auto fixed = surface.with.find(model.factor);
  if (fixed != surface.with.end()) return {text_of(fixed->second)};
  return names_among_levels(protocol, model.factor);
}

}  // namespace

std::vector<const KindTest*> tests_of(const Protocol& protocol) {
  std::vector<const KindTest*> tests{};
  for (const ExperimentKind* const kind : analysed_kinds_of(protocol)) {
    for (const KindTest& test : kind->tests) tests.push_back(&test);
  }
  return tests;
}

std::set<std::string> chosen_items(const Protocol& protocol) {
  std::set<std::string> items{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main) continue;
    if (block.all_pairs && protocol.factors.contains(block.all_pairs->factor)) {
      for (const Level& level : protocol.factors.at(block.all_pairs->factor).levels) {
        items.insert(text_of(level));
      }
      continue;
    }
    for (const Protocol::Presented& surface : block.presented) {
      for (std::string& item : items_of(protocol, surface)) items.insert(std::move(item));
    }
  }
  return items;
}

std::map<std::string, ScaleForm, std::less<>> rated_scales(const Protocol& protocol) {
  std::map<std::string, ScaleForm, std::less<>> scales{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "rating") continue;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
        scales.emplace(question.name, *scale);
      }
    }
  }
  return scales;
}

}  // namespace asperity
