// Implements the sequence of the checks of meaning.

#include "protocols/file/meaning/meaning.h"

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/file/protocol_problems.h"

namespace asperity {

std::vector<Diagnostic> check_meaning(const Protocol& protocol, const JsonDocument& document,
                                      const std::vector<ModelDeclaration>& models) {
  CheckedDocument checked(protocol, document, models);
  check_applicability(checked);
  check_head(checked);
  check_device_limits(checked);
  check_instability(checked);
  check_senses(checked);
  check_textures(checked);
  check_bodies(checked);
  check_factors(checked);
  check_explorations(checked);
  check_questions(checked);
  for (const auto& [name, stimulus] : checked.protocol.stimuli) {
    check_stimulus(checked, stimulus, pointer_to("/stimuli", name));
  }
  check_groups(checked);
  check_flow(checked);
  check_conditions(checked);
  for (const auto& [name, block] : checked.protocol.blocks) {
    check_block(checked, block, pointer_to("/blocks", name));
  }
  for (const ExperimentKind* const kind : checked.kinds) {
    if (kind->check != nullptr) kind->check(checked.protocol, checked);
  }
  check_analysis(checked);
  check_texts(checked);
  // Trials can be checked only if all references are valid.
  if (checked.found().empty()) check_size(checked);
  if (checked.found().empty()) check_trials(checked);
  std::vector<Diagnostic> found = checked.found();
  sort_by_line(found);
  return found;
}

}  // namespace asperity
