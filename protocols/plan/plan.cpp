// Implements what a plan contains: explorations, possible trials, criteria.

#include "protocols/plan/plan.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "protocols/plan/groups.h"

namespace asperity {

const Exploration& exploration_of(const Protocol& protocol, const Trial& trial) {
  const Binding<std::string>& named = protocol.blocks.at(trial.block).exploration;
  return protocol.explorations.at(named.value ? *named.value
                                              : text_of(trial.factors.at(named.factor)));
}

bool are_of_one_stimulus(const Trial& one, const Trial& other) {
  return one.factors == other.factors &&
         one.presentations.front().stimulus.name == other.presentations.front().stimulus.name;
}

std::vector<Trial> possible_trials(const Protocol& protocol) {
  Protocol every = protocol;
  for (auto& [name, block] : every.blocks) {
    block.order = Protocol::Block::Order::fixed;
    block.positions = Protocol::Block::Positions::as_listed;
    block.repetitions = 1;
    block.repetitions_of.clear();
    block.maximum_in_a_row.clear();
    block.minimum_distance.clear();
    block.fixed_positions.clear();
    block.until.reset();
    if (block.all_pairs) block.all_pairs->parts = 1;
    if (block.procedure && block.procedure->catch_trials && block.vary) {
      std::vector<double> levels = block.vary->levels();
      const double easy = block.procedure->catch_trials->level;
      if (std::find(levels.begin(), levels.end(), easy) == levels.end()) levels.push_back(easy);
      std::sort(levels.begin(), levels.end());
      block.vary->list = std::move(levels);
      block.vary->grid.reset();
    }
    block.procedure.reset();
    if (block.listed.empty()) {
      block.crossed.insert(block.crossed.end(), block.drawn.begin(), block.drawn.end());
    }
    for (const std::string& factor : block.drawn) {
      std::vector<FactorLevels> longer{};
      for (const FactorLevels& row : block.listed) {
        for (const Level& level : protocol.factors.at(factor).levels) {
          longer.push_back(row);
          longer.back()[factor] = level;
        }
      }
      block.listed = std::move(longer);
    }
    block.drawn.clear();
    // The greatest requirement on a device stands for all.
    for (std::vector<double>* const levels :
         {&block.rove.stiffness_N_per_m, &block.rove.friction}) {
      if (!levels->empty()) *levels = {*std::max_element(levels->begin(), levels->end())};
    }
    block.rove.raised_m.clear();
  }
  std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) groups.emplace_back();
  std::vector<Trial> trials{};
  for (const std::string& group : groups) {
    std::deque<Trial> own = make_plan(every, {.group = group}).trials;
    trials.insert(trials.end(), std::make_move_iterator(own.begin()),
                  std::make_move_iterator(own.end()));
  }
  return trials;
}

std::map<std::string, StimulusDescription, std::less<>> stimuli_on_bodies(
    const std::vector<Trial>& possible, const std::set<std::string, std::less<>>& body_models) {
  std::map<std::string, StimulusDescription, std::less<>> found{};
  std::set<std::string> elsewhere{};
  for (const Trial& trial : possible) {
    for (const PlannedPresentation& planned : trial.presentations) {
      const StimulusDescription& stimulus = planned.stimulus;
      if (body_models.contains(stimulus.model)) {
        found.emplace(stimulus.texture, stimulus);
      } else {
        elsewhere.insert(stimulus.texture);
      }
    }
  }
  for (const std::string& texture : elsewhere) found.erase(texture);
  found.erase("");
  return found;
}

BlockState state_of(const Protocol::Criterion& criterion, const std::vector<bool>& correct) {
  const auto window = static_cast<std::size_t>(criterion.of_last);
  int right = 0;
  for (std::size_t i = 0; i < correct.size(); ++i) {
    right += correct[i] ? 1 : 0;
    if (i >= window && correct[i - window]) --right;
    if (right >= criterion.correct) return BlockState::criterion_met;
  }
  return correct.size() >= static_cast<std::size_t>(criterion.maximum_trials)
             ? BlockState::criterion_failed
             : BlockState::go_on;
}

}  // namespace asperity
