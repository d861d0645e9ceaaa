// Implements the conversion: the tables of keys read the document, and what depends on several keys is completed.

#include "protocols/file/protocol_from_json.h"

#include <set>

#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/file/declared_estimation.h"
#include "protocols/file/derived_levels.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/keys/conditions.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

/// What the kind of the block determines unless it is stated.
void complete_by_kind(Block& block, const ExperimentKind& kind) {
  for (Protocol::TrialQuestionTemplate& question : block.questions) {
    const bool is_stated = question.is_additional ||
                           std::holds_alternative<ScaleForm>(question.form) ||
                           std::holds_alternative<LineForm>(question.form);
    if (!is_stated) question.form = kind.form;
  }
  for (Protocol::Presented& presented : block.presented) {
    if (presented.role.empty()) presented.role = kind.roles.front();
  }
  if (block.all_pairs && block.presented.size() == 1 && kind.roles.front() == "alternative") {
    block.presented.push_back(block.presented.front());
  }
}

}  // namespace

void complete_block(Block& block, const nlohmann::json& stated, const Protocol& protocol,
                    const std::vector<ModelDeclaration>& models) {
  if (block.kind.empty()) block.kind = protocol.kind;
  if (const ExperimentKind* const kind = find_kind(block.kind)) complete_by_kind(block, *kind);
  if (!block.vary) return;
  complete_dimension(block, protocol, models);
  const auto procedure = stated.find("procedure");
  if (procedure == stated.end()) return;
  block.procedure = procedure_in(*procedure, *block.vary, *block.design());
  const auto* const judged = judged_question(block);
  if (judged != nullptr && judged->allow_cannot_tell && block.design()->alternatives() > 0) {
    declare_unforced(block.design()->alternatives(), block.procedure->tracks);
  }
}

namespace {

Protocol as_written(const nlohmann::json& stated, const std::vector<ModelDeclaration>& models) {
  // A key that does not apply is a problem or its default, and not read: it would replace what its owner states otherwise.
  const nlohmann::json root = without_keys(stated, inapplicable_keys(stated));
  Protocol protocol{};
  read_keys(kProtocolTable, root, "", protocol);
  complete_estimation(protocol);
  std::set<std::string> factors_of_file{};
  for (const auto& [name, factor] : protocol.factors) factors_of_file.insert(name);
  for (auto& [name, block] : protocol.blocks) {
    complete_block(block, root.at("blocks").at(name), protocol, models);
    if (block.vary) declare_dimension(block, protocol, factors_of_file);
  }
  for (const auto& [name, block] : protocol.blocks) {
    declare_derived(block, protocol, factors_of_file);
  }
  return protocol;
}

}  // namespace

Protocol protocol_from_json(const nlohmann::json& root,
                            const std::vector<ModelDeclaration>& models) {
  Protocol protocol = as_written(root, models);
  // Texts change nothing of the design, from which their values come.
  const auto with_values = with_design_values(root, protocol);
  return with_values ? as_written(*with_values, models) : protocol;
}

}  // namespace asperity
