// Implements the sequence of the checks of meaning.

#include "protocols/file/meaning.h"

#include <algorithm>

#include "protocols/file/meaning_checks.h"

namespace asperity {

std::vector<Diagnostic> Meaning::check() {
  check_head();
  check_device_limits();
  check_instability();
  check_senses();
  check_textures();
  check_bodies();
  check_factors();
  check_explorations();
  check_questions();
  for (const auto& [name, stimulus] : protocol_.stimuli) {
    check_stimulus(stimulus, pointer_to("/stimuli", name));
  }
  check_groups();
  check_flow();
  check_conditions();
  for (const auto& [name, block] : protocol_.blocks) {
    check_block(block, pointer_to("/blocks", name));
  }
  for (const ExperimentKind* const kind : kinds_) {
    if (kind->check != nullptr) kind->check(protocol_, *this);
  }
  check_analysis();
  check_texts();
  // Trials can be checked only if all references are valid.
  if (found_.empty()) check_size();
  if (found_.empty()) check_trials();
  std::stable_sort(found_.begin(), found_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return std::move(found_);
}

std::vector<Diagnostic> check_meaning(const Protocol& protocol, const JsonDocument& document,
                                      const std::vector<ModelDeclaration>& models) {
  return Meaning(protocol, document, models).check();
}

}  // namespace asperity
