// Implements the registry of the kinds of experiment.

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <tuple>

#include "protocols/kinds/kind_list.h"

namespace asperity {

std::span<const ExperimentKind* const> experiment_kinds() {
  static const std::array kKinds =
      std::apply([](const auto... kind) { return std::array{&kind()...}; }, kKindFunctions);
  return kKinds;
}

const ExperimentKind* find_kind(std::string_view id) noexcept {
  const auto kinds = experiment_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [id](const ExperimentKind* kind) { return kind->id == id; });
  return found == kinds.end() ? nullptr : *found;
}

const KindTest* find_test(const ExperimentKind& kind, std::string_view name) noexcept {
  const auto found = std::find_if(kind.tests.begin(), kind.tests.end(),
                                  [name](const KindTest& test) { return test.name == name; });
  return found == kind.tests.end() ? nullptr : &*found;
}

std::string_view default_test_of(const ExperimentKind& kind,
                                 const EstimationDeclaration& estimation) noexcept {
  if (estimation.items.empty()) return kind.tests.front().name;
  return estimation.predictor.empty() ? "stimuli" : "exponent";
}

std::vector<std::string> family_of(const ExperimentKind& kind, const AnalysisDeclaration& analysis,
                                   const EstimationDeclaration& estimation, bool only_accompanies) {
  std::vector<std::string> family = analysis.family;
  std::erase_if(family, [&](const std::string& name) {
    return find_test(kind, name) == nullptr || (only_accompanies && compares_groups(name));
  });
  if (family.empty() && !only_accompanies) {
    family.emplace_back(default_test_of(kind, estimation));
  }
  return family;
}

const ExperimentKind& kind_named(std::string_view id) {
  if (const ExperimentKind* const kind = find_kind(id)) return *kind;
  throw std::logic_error("there is no kind of experiment \"" + std::string(id) +
                         "\"; name one of experiment_kinds()");
}

const ExperimentKind& kind_of(const Protocol::Block& block) { return kind_named(block.kind); }

const ExperimentKind* kind_of_question(const ExperimentKind& of_block,
                                       const Question& question) noexcept {
  if (question.is_additional) return nullptr;
  if (of_block.form.index() == question.form.index()) return &of_block;
  if (of_block.other_form && of_block.other_form->index() == question.form.index()) {
    return &of_block;
  }
  for (const ExperimentKind* const kind : experiment_kinds()) {
    if (kind->asks_several && kind->form.index() == question.form.index()) return kind;
  }
  return nullptr;
}

std::vector<const ExperimentKind*> analysed_kinds_of(const Protocol& protocol) {
  std::set<const ExperimentKind*> asked{};
  for (const auto& [name, block] : protocol.blocks) {
    const ExperimentKind* const of_block = find_kind(block.kind);
    if (of_block == nullptr || block.phase != Phase::main) continue;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      asked.insert(kind_of_question(*of_block, question));
    }
  }
  std::vector<const ExperimentKind*> kinds{};
  for (const ExperimentKind* const kind : experiment_kinds()) {
    if (asked.contains(kind)) kinds.push_back(kind);
  }
  return kinds;
}

std::vector<const ExperimentKind*> kinds_of(const Protocol& protocol) {
  std::vector<const ExperimentKind*> kinds{};
  for (const ExperimentKind* const kind : experiment_kinds()) {
    const bool is_used =
        std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                    [kind](const auto& each) { return each.second.kind == kind->id; });
    if (is_used) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace asperity
