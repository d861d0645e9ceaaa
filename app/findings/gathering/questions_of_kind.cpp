// Assigns each question to the kind of its block, or to the kind of its own form.

#include "app/findings/gathering/questions_of_kind.h"

#include <variant>

#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

const std::string& kind_of_stored_block(const std::string& kind_of_protocol,
                                        const Protocol::Block& block) {
  return block.kind.empty() ? kind_of_protocol : block.kind;
}

std::string kind_of_stored(const std::string& kind_of_protocol, const Protocol::Block& block,
                           const Protocol::TrialQuestionTemplate& question) {
  if (question.is_additional) return {};
  const std::string& of_block = kind_of_stored_block(kind_of_protocol, block);
  const ExperimentKind* const known = find_kind(of_block);
  // The other forms are those of the kind itself.
  if (known == nullptr || !std::holds_alternative<ScaleForm>(question.form)) return of_block;
  const ExperimentKind* const kind = kind_of_question(*known, question);
  return std::string(kind == nullptr ? of_block : kind->id);
}

std::map<std::string, QuestionsOfKind> questions_by_kind(const Protocol& protocol,
                                                         const std::string& kind_of_protocol) {
  std::map<std::string, QuestionsOfKind> kinds{};
  decltype(QuestionsOfKind::additional) additional{};
  for (const auto& [name, block] : protocol.blocks) {
    if (matches_roughness(protocol, block)) continue;  // its own analysis: equal_roughness.h
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      const std::string kind = kind_of_stored(kind_of_protocol, block, question);
      if (kind.empty()) {
        additional[name].insert(question.name);
        continue;
      }
      if (kind != kind_of_stored_block(kind_of_protocol, block)) {
        kinds[kind].accompanied.insert(name);
      }
      if (!question.confidence_of().empty()) {
        kinds[kind_of_stored_block(kind_of_protocol, block)].confidences[name] = question.name;
      }
      auto& names = kinds[kind].by_block[name];
      if (block.questions.size() == 1) continue;
      if (!names) names.emplace();
      names->insert(question.name);
    }
  }
  for (auto& [kind, questions] : kinds) questions.additional = additional;
  // Only where no block is of that kind is there nothing of the protocol's kind.
  if (!kinds.empty() && !kinds.contains(kind_of_protocol)) return kinds;
  auto& others = kinds[kind_of_protocol].others.emplace();
  for (const auto& [name, block] : protocol.blocks) {
    if (!block.questions.empty() && !kinds[kind_of_protocol].by_block.contains(name)) {
      others.insert(name);
    }
  }
  return kinds;
}

}  // namespace asperity
