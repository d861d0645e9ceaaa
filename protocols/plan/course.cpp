// Implements the course of a session: the flow in order, from the protocol, the seed, the row and the outcomes.

#include "protocols/plan/course.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "protocols/design/block_factors.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/squares.h"
#include "protocols/plan/surface_order.h"
#include "protocols/plan/trial_order.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

namespace {

Square square_of(Protocol::Counterbalance how, std::size_t levels) {
  switch (how) {
    case Protocol::Counterbalance::none:
      break;
    case Protocol::Counterbalance::latin:
      return latin_square(levels);
    case Protocol::Counterbalance::williams:
      return williams_square(levels);
  }
  return {latin_square(levels).front()};
}

/// The factors that are iterated outside blocks, in the order of the flow, without duplicates.
std::vector<std::string> iterated_factors(const Protocol& protocol) {
  std::vector<std::string> factors{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const run = std::get_if<Run>(&step);
    if (run == nullptr || run->for_each.empty()) continue;
    if (std::find(factors.begin(), factors.end(), run->for_each) == factors.end()) {
      factors.push_back(run->for_each);
    }
  }
  return factors;
}

/// The row of the square that the allocation assigns to this factor. With several factors the row number is
/// decomposed like the digits of a number, so that no two orders always occur together.
std::vector<std::size_t> counterbalanced(const Protocol& protocol, const Allocation& allocation,
                                         const std::string& factor, std::size_t levels) {
  const Square square = square_of(protocol.counterbalance, levels);
  const int rows = counterbalance_rows(protocol);
  auto row = static_cast<std::size_t>(((allocation.counterbalance_row % rows) + rows) % rows);
  for (const std::string& before : iterated_factors(protocol)) {
    if (before == factor) break;
    row /= square_of(protocol.counterbalance, protocol.factors.at(before).levels.size()).size();
  }
  return square[row % square.size()];
}

std::vector<BlockTrial> in_order(const Block& block, const std::vector<BlockRow>& rows,
                                 std::vector<BlockTrial> trials, const Random& random) {
  if (block.order == Block::Order::fixed) return trials;
  const auto order = random_order(order_problem(block, rows, trials), random);
  if (!order) {
    throw std::runtime_error(
        "block " + block.name +
        ": no order of its trials satisfies its constraints; relax maximum_in_a_row, "
        "minimum_distance or fixed_positions");
  }
  std::vector<BlockTrial> ordered{};
  for (const std::size_t trial : *order) ordered.push_back(trials[trial]);
  return ordered;
}

/// The probability of an answer that leads to a lower level: a logistic function of the place among the levels, from chance
/// to certainty.
double example_chance(const Block& block, double value) {
  const Dimension& dimension = *block.vary;
  const std::vector<double> values = dimension.values();
  const auto place = std::lower_bound(values.begin(), values.end(), value) - values.begin();
  const double middle = 0.5 * static_cast<double>(values.size() - 1);
  const double from_middle = (static_cast<double>(place) - middle) / std::max(middle, 0.5);
  const double chance = values.front() < dimension.standard.value_or(values.front())
                            ? 0.0
                            : block.design()->guess_rate();
  return chance + (1.0 - chance) / (1.0 + std::exp(-5.0 * from_middle));
}

/// As `Procedure::rule` of an external program.
NextStep example_step(const LevelRequest& request, const Random& random) {
  std::vector<LevelAnswer> answers{};
  for (const TrackAnswer& each : request.answers) {
    if (each.of.track == request.of.track) answers.push_back(each.answer);
  }
  return next_step(request.settings, answers,
                   random.split(static_cast<std::uint64_t>(request.block_ordinal))
                       .split(static_cast<std::uint64_t>(request.of.track)));
}

double expected_trials_without_anchors(const Protocol& protocol, const Block& block) {
  const auto rows = static_cast<double>(row_count(protocol, block));
  if (!block.procedure) {
    const auto planned = static_cast<double>(trial_count(protocol, block));
    return block.until ? std::min(planned, static_cast<double>(block.until->maximum_trials))
                       : planned;
  }
  const Dimension& dimension = *block.vary;
  double of_tracks = 0.0;
  for (const ProcedureSettings& settings : block.procedure->tracks) {
    of_tracks += rows * expected_trials(settings, [&](double level) {
                   return example_chance(block, dimension.value_of(level));
                 });
  }
  const auto& catch_trials = block.procedure->catch_trials;
  return catch_trials ? of_tracks * catch_trials->every / (catch_trials->every - 1) : of_tracks;
}

/// The number of trials of a procedure before an anchor in the middle: half of the largest number, because the number of
/// trials is not known yet. Tracks that end before have no such anchor.
std::size_t middle_of_tracks(const Protocol& protocol, const Block& block) {
  return most_trials_of(protocol, block) / 2;
}

double expected_trials_of_run(const Protocol& protocol, const Block& block) {
  double trials = expected_trials_without_anchors(protocol, block);
  if (!block.has_anchors()) return trials;
  const bool is_short = block.procedure && block.has_anchor_at(AnchorPlace::middle) &&
                        trials <= static_cast<double>(middle_of_tracks(protocol, block));
  trials += static_cast<double>(block.anchor_places.size());
  return is_short ? trials - 1.0 : trials;
}

/// The first type of trial that presents the comparison, or else the first one; null where there are none.
const DesignTrial* type_of_anchor(const Block& block) {
  const std::span<const DesignTrial> types = trial_types(block);
  const auto signal = std::find_if(types.begin(), types.end(), [&block](const DesignTrial& type) {
    return type.is_signal && type.presents(block.vary->role);
  });
  if (signal != types.end()) return &*signal;
  return types.empty() ? nullptr : &types.front();
}

/// The rows of the squares of all iterated factors.
std::size_t order_rows(const Protocol& protocol) {
  std::size_t rows = 1;
  for (const std::string& factor : iterated_factors(protocol)) {
    rows *= square_of(protocol.counterbalance, protocol.factors.at(factor).levels.size()).size();
  }
  return rows;
}

/// The parts of the pairs: 1, or the number that all blocks with parts have.
std::size_t pair_parts(const Protocol& protocol) {
  int parts = 1;
  for (const auto& [name, block] : protocol.blocks) {
    if (block.all_pairs) parts = std::max(parts, block.all_pairs->parts);
  }
  return static_cast<std::size_t>(parts);
}

/// The part of the pairs. The row number is decomposed as in `counterbalanced`, so that each part occurs with every order.
std::size_t part_of(const Protocol& protocol, const Allocation& allocation) {
  const int rows = counterbalance_rows(protocol);
  const auto row = static_cast<std::size_t>(((allocation.counterbalance_row % rows) + rows) % rows);
  return row / order_rows(protocol);
}

}  // namespace

int counterbalance_rows(const Protocol& protocol) {
  return static_cast<int>(order_rows(protocol) * pair_parts(protocol));
}

Course::Course(const Protocol& protocol, const Allocation& allocation, const RulesByBlock* rules)
    : protocol_(&protocol),
      rules_(rules),
      random_(Random(allocation.seed).split("plan")),
      maker_(protocol, random_) {
  expand_flow(allocation);
  proceed();
}

void Course::expand_flow(const Allocation& allocation) {
  const FactorLevels group = group_factor(*protocol_, allocation.group);
  const std::string name = group.empty() ? std::string() : text_of(group.begin()->second);
  for (const Protocol::Step& step : protocol_->flow) {
    if (const auto* const run = std::get_if<Run>(&step)) {
      expand(*run, group, allocation);
    } else if (const auto* const screen = std::get_if<Protocol::Screen>(&step)) {
      if (is_for_group(screen->groups, name)) units_.emplace_back(PlanStep(*screen));
    } else if (const auto* const check = std::get_if<Protocol::Check>(&step)) {
      units_.emplace_back(PlanStep(*check));
    } else if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
      units_.emplace_back(PlanStep(*pause));
    } else {
      units_.emplace_back(PlanStep(std::get<Protocol::Ask>(step)));
    }
  }
  for (Unit& unit : units_) {
    auto* const run = std::get_if<BlockRun>(&unit);
    if (run == nullptr) continue;
    run->ordinal = ++plan_.blocks;
    run->random = random_.split(run->block->name).split(static_cast<std::uint64_t>(run->ordinal));
  }
}

void Course::expand(const Run& run, const FactorLevels& group, const Allocation& allocation) {
  const Block& block = protocol_->blocks.at(run.block);
  const std::size_t part = part_of(*protocol_, allocation);
  if (run.for_each.empty()) {
    units_.emplace_back(BlockRun{.run = &run, .block = &block, .outer = group, .part = part});
    return;
  }
  const std::vector<Level>& levels = protocol_->factors.at(run.for_each).levels;
  bool is_first = true;
  for (const std::size_t index :
       counterbalanced(*protocol_, allocation, run.for_each, levels.size())) {
    if (!is_first && run.pause) units_.emplace_back(PlanStep(*run.pause));
    is_first = false;
    FactorLevels outer = group;
    outer[run.for_each] = levels[index];
    units_.emplace_back(
        BlockRun{.run = &run, .block = &block, .outer = std::move(outer), .part = part});
  }
}

void Course::proceed() {
  if (add_next_of_tracks()) return;
  while (next_unit_ < units_.size()) {
    const Unit& unit = units_[next_unit_++];
    if (const auto* const step = std::get_if<PlanStep>(&unit)) {
      plan_.steps.push_back(*step);
      continue;
    }
    BlockRun run = with_matches(std::get<BlockRun>(unit));
    if (!run.block->procedure) {
      add_block(run);
      continue;
    }
    tracks_.emplace(*protocol_, std::move(run), rules_);
    if (add_next_of_tracks()) return;
  }
}

/// False where no track is under way, or the last one is finished. Adds nothing where a level is requested.
bool Course::add_next_of_tracks() {
  if (!tracks_) return false;
  requested_ = tracks_->request();
  if (requested_) return true;
  const std::size_t before = tracks_->trials();
  std::optional<Trial> trial = tracks_->next(maker_);
  if (!trial) {
    add_anchor(tracks_->run(), AnchorPlace::end);
    const Block& block = *tracks_->run().block;
    // Such a block is run once (check_equal_roughness).
    if (matches_roughness(*protocol_, block)) {
      matches_[block.name] = roughness_matches(*block.vary, tracks_->answered());
    }
    tracks_.reset();
    return false;
  }
  add_pause(*tracks_->run().run, before);
  const Block& block = *tracks_->run().block;
  if (block.has_anchors()) {
    add_anchor_before(tracks_->run(), before, middle_of_tracks(*protocol_, block));
  }
  add(std::move(*trial));
  return true;
}

BlockRun Course::with_matches(BlockRun run) const {
  const auto& equal = run.block->equal_roughness;
  if (!equal) return run;
  if (const auto known = matches_.find(equal->matched_in); known != matches_.end()) {
    run.matches = known->second;
  }
  return run;
}

void Course::add_block(const BlockRun& run) {
  const Block& block = *run.block;
  const std::vector<BlockRow> rows = rows_of_part(*protocol_, block, run.part);
  const std::vector<BlockTrial> ordered_trials =
      in_order(block, rows, trials_of(block, rows), run.random.split("order"));
  const std::size_t trials =
      block.until
          ? std::min(ordered_trials.size(), static_cast<std::size_t>(block.until->maximum_trials))
          : ordered_trials.size();
  std::map<std::string, std::vector<Level>, std::less<>> drawn{};
  for (const std::string& factor : block.drawn) {
    drawn[factor] = balanced_draws(protocol_->factors.at(factor).levels, trials,
                                   run.random.split("drawn").split(factor));
  }
  const Random of_positions = run.random.split("positions");
  const SurfaceOrders positions =
      balances_every_row(block, rows, ordered_trials)
          ? positions_within_rows(block, rows, ordered_trials, of_positions)
          : positions_of(block.positions, surfaces_of(block, rows.front()).size(), trials,
                         of_positions);
  std::size_t ordered = 0;  // trials whose order of surfaces can be noticed
  for (std::size_t i = 0; i < trials; ++i) {
    add_pause(*run.run, i);
    add_anchor_before(run, i, trials / 2);
    Trial trial{};
    trial.repetition = ordered_trials[i].repetition;
    trial.factors = run.outer;
    const BlockRow& row = rows[ordered_trials[i].row];
    trial.factors.insert(row.factors.begin(), row.factors.end());
    for (const auto& [factor, levels] : drawn) trial.factors[factor] = levels[i];
    const std::vector<Protocol::Presented> listed = surfaces_of(block, row);
    std::vector<Protocol::Presented> surfaces{};
    // Positions are balanced over the trials with a signal: the surfaces of the others are equal.
    const bool is_ordered = row.type == nullptr || row.type->is_signal;
    for (const std::size_t index : positions[is_ordered ? ordered++ : 0]) {
      surfaces.push_back(listed[index]);
    }
    add(maker_.make(std::move(trial), run, surfaces, run.random.split("pictures").split(i)));
  }
  add_anchor(run, AnchorPlace::end);
}

/// The anchor at the start or in the middle, before the trial that follows `trials` other trials of the run.
void Course::add_anchor_before(const BlockRun& run, std::size_t trials, std::size_t middle) {
  if (trials == 0) {
    add_anchor(run, AnchorPlace::start);
  } else if (trials == middle) {
    add_anchor(run, AnchorPlace::middle);
  }
}

/// The anchors of a run are alike in everything that is drawn: surfaces in the listed order, one stream.
void Course::add_anchor(const BlockRun& run, AnchorPlace place) {
  const Block& block = *run.block;
  if (!block.has_anchor_at(place)) return;
  Trial anchor{};
  anchor.repetition = 0;
  anchor.anchor = place;
  anchor.factors = run.outer;
  anchor.factors.insert(block.anchor.begin(), block.anchor.end());
  if (block.vary) {
    Level& level = anchor.factors.at(block.vary->factor);
    level = block.vary->value_of(std::get<double>(level));
  }
  add_derived_levels(block, anchor.factors);
  const BlockRow row{.pair = block.anchor_pair, .type = type_of_anchor(block)};
  anchor = maker_.make(std::move(anchor), run, surfaces_of(block, row), run.random.split("anchor"));
  const std::string_view role = kind_of(block).anchor_role;
  if (!role.empty() && anchor.presentations.size() == 1) anchor.presentations.front().role = role;
  add(std::move(anchor));
}

/// The break within a block, before the trial that follows `trials` trials of it.
void Course::add_pause(const Run& run, std::size_t trials) {
  if (trials > 0 && run.pause && run.break_every_trials > 0 &&
      trials % static_cast<std::size_t>(run.break_every_trials) == 0) {
    plan_.steps.emplace_back(*run.pause);
  }
}

void Course::add(Trial trial) {
  trial.ordinal = static_cast<int>(plan_.trials.size()) + 1;
  plan_.steps.emplace_back(TrialStep{plan_.trials.size()});
  plan_.trials.push_back(std::move(trial));
}

const Trial* Course::awaited() const noexcept {
  return tracks_ && !requested_ ? &plan_.trials.back() : nullptr;
}

const Run& Course::run_of(int block_ordinal) const {
  for (const Unit& unit : units_) {
    const auto* const run = std::get_if<BlockRun>(&unit);
    if (run != nullptr && run->ordinal == block_ordinal) return *run->run;
  }
  throw std::out_of_range("the session has no block " + std::to_string(block_ordinal) +
                          "; use the ordinal of one of its blocks");
}

std::size_t Course::trials_before_last_outcome() const noexcept {
  return trials_before_.value_or(plan_.trials.size());
}

std::vector<Trial> Course::possible_next() const {
  const Trial* const trial = awaited();
  if (trial == nullptr) return {};
  std::vector<TrialOutcome> outcomes{TrialOutcome{}};
  if (!trial->catch_trial) {
    const Dimension& dimension = *tracks_->run().block->vary;
    const double value = std::get<double>(trial->factors.at(dimension.factor));
    std::vector<LevelOutcome> possible{LevelOutcome::incorrect, LevelOutcome::correct};
    const auto* const judged = judged_question(*tracks_->run().block);
    if (judged != nullptr && judged->allow_cannot_tell) possible.push_back(LevelOutcome::unsure);
    for (const LevelOutcome outcome : possible) {
      outcomes.insert(outcomes.begin(), {TrialOutcome::Answer{value, outcome}});
    }
  }
  std::vector<Trial> next{};
  std::set<std::string> known{};
  for (const TrialOutcome& outcome : outcomes) {
    Course after = *this;
    after.advance(outcome);
    if (after.plan_.trials.size() == plan_.trials.size()) continue;  // the session ends
    Trial& following = after.plan_.trials[plan_.trials.size()];
    if (known.insert(json_of(following)).second) next.push_back(std::move(following));
  }
  return next;
}

void Course::advance(const TrialOutcome& outcome) {
  if (awaited() == nullptr)
    throw std::logic_error(
        "Course::advance must not be called: no trial of the session is awaited; call it only "
        "while "
        "awaited() returns one");
  std::optional<LevelAnswer> answer{};
  if (outcome.answer) {
    const Dimension& dimension = *tracks_->run().block->vary;
    answer = {.level = dimension.level_of(outcome.answer->value),
              .outcome = outcome.answer->outcome};
  }
  tracks_->answer(answer);
  trials_before_ = plan_.trials.size();
  proceed();
}

LevelOutcome level_outcome_of(const Protocol::Block& block,
                              const Protocol::TrialQuestionTemplate& judged,
                              const std::string& varied_item, const AnsweredItem& response) {
  if (response.answer == kCannotTellOption) return LevelOutcome::unsure;
  // Of three surfaces, the varied one is not always the correct response.
  const bool chose_varied = block.design()->is_choice_of_three() ? response.correct.value_or(false)
                                                                 : response.answer == varied_item;
  return forced_outcome(chose_varied != judged.asks_for_less());
}

void Course::supply(const NextStep& step) {
  if (!requested_) {
    throw std::logic_error(
        "Course::supply must not be called: no level is requested; call it only while requested() "
        "has one");
  }
  tracks_->supply(step);
  requested_.reset();
  trials_before_ = plan_.trials.size();
  proceed();
}

Plan make_plan(const Protocol& protocol, const Allocation& allocation) {
  return Course(protocol, allocation).plan();
}

bool has_estimated_trials(const Protocol& protocol) {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(), [&protocol](const auto& each) {
    const auto& procedure = each.second.procedure;
    if (!procedure) return false;
    if (!has_tracks_of_fixed_length(each.second)) return true;
    // The trials after the last complete group of `every` contain a catch trial or not.
    const double trials = expected_trials_of_run(protocol, each.second);
    return procedure->catch_trials && trials != std::round(trials);
  });
}

int expected_trials(const Protocol& protocol) {
  double trials = 0.0;
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const run = std::get_if<Run>(&step);
    if (run == nullptr) continue;
    const std::size_t runs =
        run->for_each.empty() ? 1 : protocol.factors.at(run->for_each).levels.size();
    trials += static_cast<double>(runs) *
              expected_trials_of_run(protocol, protocol.blocks.at(run->block));
  }
  return static_cast<int>(std::lround(trials));
}

Plan example_plan(const Protocol& protocol, const Allocation& allocation) {
  Course course(protocol, allocation);
  Random observer = Random(allocation.seed).split("example observer");
  while (!course.is_complete()) {
    if (const auto& request = course.requested()) {
      course.supply(example_step(*request, observer.split("levels")));
      continue;
    }
    const Trial* const trial = course.awaited();
    if (trial->catch_trial) {
      course.advance({});
      continue;
    }
    const Block& block = protocol.blocks.at(trial->block);
    const double value = std::get<double>(trial->factors.at(block.vary->factor));
    const LevelOutcome outcome = forced_outcome(observer.uniform() < example_chance(block, value));
    course.advance({.answer = TrialOutcome::Answer{.value = value, .outcome = outcome}});
  }
  return course.plan();
}

}  // namespace asperity
