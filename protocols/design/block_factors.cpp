// Implements the search for a block's factors and runs.

#include "protocols/design/block_factors.h"

#include <algorithm>
#include <variant>

#include "protocols/procedures/procedure.h"

namespace asperity {

std::vector<const Protocol::Run*> runs_of(const Protocol& protocol, const Protocol::Block& block) {
  std::vector<const Protocol::Run*> runs{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const run = std::get_if<Protocol::Run>(&step);
    if (run != nullptr && run->block == block.name) runs.push_back(run);
  }
  return runs;
}

std::set<std::string> factors_set_by(const Protocol::Block& block, const Protocol::Run* run) {
  std::set<std::string> names(block.crossed.begin(), block.crossed.end());
  names.insert(block.drawn.begin(), block.drawn.end());
  if (block.vary) names.insert(block.vary->factor);
  for (const auto& [name, formula] : block.derived) names.insert(name);
  for (const auto& row : block.listed) {
    for (const auto& [name, level] : row) names.insert(name);
  }
  if (run != nullptr && !run->for_each.empty()) names.insert(run->for_each);
  return names;
}

bool is_varied(const Protocol& protocol, const std::string& factor) {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(), [&factor](const auto& each) {
    return each.second.vary && each.second.vary->factor == factor;
  });
}

const Protocol::TrialQuestionTemplate* judged_question(const Protocol::Block& block) noexcept {
  for (const Protocol::TrialQuestionTemplate& question : block.questions) {
    if (question.judgement()) return &question;
  }
  return nullptr;
}

const Protocol::TrialQuestionTemplate* question_named(const Protocol::Block& block,
                                                      const std::string& name) noexcept {
  const auto named = std::find_if(block.questions.begin(), block.questions.end(),
                                  [&name](const auto& question) { return question.name == name; });
  return named == block.questions.end() ? nullptr : &*named;
}

std::size_t surfaces_in_trial(const Protocol::Block& block) noexcept {
  return block.design() == &two_alternatives() ? block.presented.size()
                                               : block.design()->surfaces();
}

bool chooses_levels_from_answers(const Protocol::Block& block) {
  if (!block.procedure) return false;
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  return tracks.empty() || !std::holds_alternative<ConstantStimuli>(tracks.front());
}

bool has_tracks_of_fixed_length(const Protocol::Block& block) {
  return !block.procedure ||
         std::all_of(block.procedure->tracks.begin(), block.procedure->tracks.end(),
                     [](const ProcedureSettings& settings) {
                       return procedure_of(settings).has_fixed_length(settings);
                     });
}

}  // namespace asperity
