// Selects the response table of each question, and refuses blocks whose power cannot be simulated.

#include "app/power/power_tables.h"

#include <algorithm>
#include <variant>

#include "analysis/words/phrased_error.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"

namespace asperity {

namespace {

[[noreturn]] void refuse(const Protocol::Block& block, const Phrase& why) {
  throw PhrasedError(
      phrase("Responses",
             "studies of the block %1 cannot be simulated from response tables: %2; add --physics "
             "to simulate them on the full physics, with the observers of the protocol")
          .with(quoted_name(block.name), why));
}

void refuse_external_levels(const Protocol::Block& block) {
  if (!block.procedure) return;
  for (const ProcedureSettings& settings : block.procedure->tracks) {
    if (std::holds_alternative<External>(settings)) {
      refuse(block, phrase("Responses", "an external program states its levels"));
    }
  }
}

/// The comparison of groups in the family of which no parameter is the effect: its power would be that of equal groups.
std::string group_test_without_effect(const TabulatedBlock::OfQuestion& made) {
  const std::vector<ResponseParameter> parameters = made.table->parameters(made.asked);
  for (const char* const test : {kGroupsTest, kGroupProfilesTest}) {
    const std::vector<std::string>& family = made.asked.family;
    if (std::find(family.begin(), family.end(), test) == family.end()) continue;
    const bool has_effect =
        std::any_of(parameters.begin(), parameters.end(), [test](const ResponseParameter& one) {
          return one.tests == test || one.tests.starts_with(std::string(test) + ", ");
        });
    if (!has_effect) return test;
  }
  return {};
}

TabulatedBlock::OfQuestion tabulated(const Protocol& protocol, const Protocol::Block& block,
                                     const Protocol::TrialQuestionTemplate& question,
                                     const std::vector<Trial>& possible) {
  const ExperimentKind& of_block = kind_of(block);
  if (question.condition) {
    const auto* const needed = question_named(block, question.condition->question);
    if (needed != nullptr && needed->is_additional) {
      refuse(block, phrase("Responses",
                           "the question %1 depends on the additional question %2, whose responses "
                           "are not simulated")
                        .with(quoted_name(question.name), quoted_name(needed->name)));
    }
  }
  const ExperimentKind& kind = *kind_of_question(of_block, question);
  if (kind.responses == nullptr) {
    refuse(block, phrase("Responses", "the kind \"%1\" has no response table").with(kind.name));
  }
  TabulatedBlock::OfQuestion made{.asked = tabulated_question(protocol, block, question, possible),
                                  .table = kind.responses,
                                  .is_of_block = &kind == &of_block};
  if (made.table->refusal != nullptr) {
    const Phrase why = made.table->refusal(made.asked);
    if (!why.empty()) refuse(block, why);
  }
  const std::string test = group_test_without_effect(made);
  if (!test.empty()) {
    refuse(block,
           phrase("Responses", "response tables have no effect of the groups for the test %1")
               .with(quoted_name(test)));
  }
  return made;
}

ProtocolRow row_of(const Protocol& protocol) {
  return {.id = 1,
          .name = protocol.name,
          .version = protocol.version,
          .kind = protocol.kind,
          .design = text_of(protocol.design),
          .source_sha256 = "simulated",
          .source = protocol.source};
}

}  // namespace

bool has_simulated_responses(const Protocol::Block& block) noexcept {
  return block.phase == Phase::main || block.procedure.has_value();
}

std::map<std::string, TabulatedBlock, std::less<>> tabulated_blocks(const Protocol& protocol) {
  const std::vector<Trial> possible = possible_trials(protocol);
  std::map<std::string, TabulatedBlock, std::less<>> blocks{};
  for (const auto& [name, block] : protocol.blocks) {
    if (!has_simulated_responses(block) || runs_of(protocol, block).empty()) continue;
    refuse_external_levels(block);
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      if (kind_of_question(kind_of(block), question) == nullptr) continue;
      blocks[name].questions.push_back(tabulated(protocol, block, question, possible));
    }
  }
  return blocks;
}

std::string assumption_name(const TabulatedQuestion& asked, const std::string& parameter) {
  return asked.block.name + '.' + asked.question.name + '.' + parameter;
}

PowerTables::PowerTables(const Protocol& of, std::span<const Assumption> assumptions)
    : protocol(of),
      blocks(tabulated_blocks(protocol)),
      gathered(row_of(protocol)),
      rules(rules_of(protocol)) {
  for (const auto& [name, block] : blocks) {
    for (const TabulatedBlock::OfQuestion& question : block.questions) {
      OfQuestion& made = with_values[name].emplace_back(OfQuestion{.tabulated = &question});
      for (const ResponseParameter& parameter : question.table->parameters(question.asked)) {
        const std::string full = assumption_name(question.asked, parameter.name);
        const auto stated =
            std::find_if(assumptions.begin(), assumptions.end(),
                         [&full](const Assumption& each) { return each.name == full; });
        made.values.set(parameter.name, stated->value.value());
      }
    }
  }
}

const std::vector<PowerTables::OfQuestion>* PowerTables::questions_of(
    std::string_view block) const {
  const auto found = with_values.find(block);
  return found == with_values.end() ? nullptr : &found->second;
}

}  // namespace asperity
