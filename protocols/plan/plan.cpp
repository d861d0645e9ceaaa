// Implements the planning of a session: every trial in order, from the protocol, the seed and the row.

#include "protocols/plan/plan.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/random.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/squares.h"
#include "protocols/plan/trial_order.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using Run = Protocol::Run;

const Level& presented_level(const FactorLevels& factors, const FactorLevels& with,
                             const std::string& name) {
  const auto own = with.find(name);
  return own == with.end() ? factors.at(name) : own->second;
}

std::string resolved(const Binding<std::string>& binding, const FactorLevels& factors,
                     const FactorLevels& with) {
  if (binding.value) return *binding.value;
  return binding.factor.empty() ? std::string{}
                                : text_of(presented_level(factors, with, binding.factor));
}

/// A body of the protocol with the paths of its files. `texture` is applied to a surface without one.
std::optional<BodyDescription> planned_body(const Protocol& protocol, const std::string& name,
                                            const std::string& texture) {
  if (name.empty()) return {};
  BodyDescription body = protocol.bodies.at(name);
  if (!body.mesh && !body.texture && !texture.empty()) body.texture = texture;
  if (body.texture) body.height_field = protocol.textures.at(*body.texture).height_field;
  return body;
}

PlannedPresentation presentation_of(const Protocol& protocol, const ExperimentKind& kind,
                                    const Protocol::Presented& presented,
                                    const FactorLevels& factors) {
  const StimulusTemplate& source = protocol.stimuli.at(presented.stimulus);
  PlannedPresentation planned{};
  planned.role = presented.role;
  planned.stimulus_template = source.name;
  planned.stimulus.model = resolved(source.model, factors, presented.with);
  planned.stimulus.texture = resolved(source.texture, factors, presented.with);
  planned.stimulus.name = source.name;
  const std::string surface = resolved(source.surface, factors, presented.with);
  const std::string tool = resolved(source.tool, factors, presented.with);
  for (const std::string& part : {planned.stimulus.texture, planned.stimulus.model,
                                  source.surface.factor.empty() ? std::string{} : surface,
                                  source.tool.factor.empty() ? std::string{} : tool}) {
    if (!part.empty()) planned.stimulus.name += "_" + part;
  }
  if (!planned.stimulus.texture.empty()) {
    planned.stimulus.height_field = protocol.textures.at(planned.stimulus.texture).height_field;
    planned.stimulus.declared_assets = protocol.textures.at(planned.stimulus.texture).assets;
  }
  planned.stimulus.surface = planned_body(protocol, surface, planned.stimulus.texture);
  planned.stimulus.tool = planned_body(protocol, tool, {});
  for (const auto& [name, binding] : source.parameters) {
    if (binding.value) {
      planned.stimulus.parameters[name] = *binding.value;
    } else {
      const Level& level = presented_level(factors, presented.with, binding.factor);
      planned.stimulus.parameters[name] = level;
      planned.stimulus.name += "_" + text_of(level);
    }
  }
  planned.stimulus.material = protocol.material;
  planned.stimulus.patch = protocol.patch;
  planned.equal_force = source.equal_force;
  planned.item = presented.item.empty() ? kind.item_of(planned.stimulus) : presented.item;
  return planned;
}

/// `count` draws from `levels` in random order, each level equally often as far as possible.
std::vector<Level> balanced_draws(const std::vector<Level>& levels, std::size_t count,
                                  Random random) {
  std::vector<Level> draws{};
  while (draws.size() < count) {
    std::vector<Level> round = levels;
    random.shuffle(std::span<Level>(round));
    const std::size_t wanted = std::min(round.size(), count - draws.size());
    draws.insert(draws.end(), round.begin(), round.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
  return draws;
}

/// The order of the surfaces in every trial.
std::vector<std::vector<std::size_t>> positions_of(Block::Positions how, std::size_t surfaces,
                                                   std::size_t trials, Random random) {
  std::vector<std::vector<std::size_t>> orders{};
  std::vector<std::size_t> listed(surfaces);
  for (std::size_t i = 0; i < surfaces; ++i) listed[i] = i;
  switch (how) {
    case Block::Positions::as_listed:
      orders.assign(trials, listed);
      break;
    case Block::Positions::shuffle:
      for (std::size_t trial = 0; trial < trials; ++trial) {
        orders.push_back(listed);
        random.shuffle(std::span<std::size_t>(orders.back()));
      }
      break;
    case Block::Positions::balanced: {
      // Complete Latin squares follow each other, each shuffled separately. The two halves of an odd Williams square
      // alternate, so that orders are balanced too as far as possible.
      const Square williams = williams_square(surfaces);
      const std::size_t halves = williams.size() / surfaces;
      std::size_t half = static_cast<std::size_t>(random.below(halves));
      while (orders.size() < trials) {
        Square rows(williams.begin() + static_cast<std::ptrdiff_t>(half * surfaces),
                    williams.begin() + static_cast<std::ptrdiff_t>((half + 1) * surfaces));
        random.shuffle(std::span<std::vector<std::size_t>>(rows));
        const std::size_t wanted = std::min(rows.size(), trials - orders.size());
        orders.insert(orders.end(), rows.begin(),
                      rows.begin() + static_cast<std::ptrdiff_t>(wanted));
        half = (half + 1) % halves;
      }
      break;
    }
  }
  return orders;
}

std::string place_code(std::size_t index) { return std::string(1, static_cast<char>('A' + index)); }

std::string with_code(std::string prompt, const std::string& code) {
  constexpr std::string_view kPlaceholder = "{code}";
  for (std::size_t at = prompt.find(kPlaceholder); at != std::string::npos;
       at = prompt.find(kPlaceholder, at + code.size())) {
    prompt.replace(at, kPlaceholder.size(), code);
  }
  return prompt;
}

/// The texture of the first surface, where it has one.
const Texture* texture_of(const Protocol& protocol, const Trial& trial) {
  const auto texture = protocol.textures.find(trial.presentations.front().stimulus.texture);
  return texture == protocol.textures.end() ? nullptr : &texture->second;
}

TrialQuestion planned_question(const Protocol& protocol,
                               const Protocol::TrialQuestionTemplate& source, const Trial& trial,
                               const std::vector<std::string>& pictures) {
  TrialQuestion question{};
  question.name = source.name;
  question.prompt = source.prompt;
  question.form = source.form;
  if (!has_options(question.form)) return question;
  if (!source.words.empty()) {
    for (const Protocol::TrialQuestionTemplate::Word& word : source.words) {
      const std::string label = std::to_string(question.options.size() + 1);
      question.options.push_back({word.value, label, std::nullopt, word.text});
    }
  } else if (pictures.empty()) {
    for (const PlannedPresentation& planned : trial.presentations) {
      question.options.push_back({planned.item, planned.code, std::nullopt, {}});
    }
    if (!source.tie.empty()) {
      const std::string label = std::to_string(question.options.size() + 1);
      question.options.push_back({kTieOption, label, std::nullopt, source.tie});
    }
  } else {
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      question.options.push_back(
          {pictures[i], std::to_string(i + 1), protocol.textures.at(pictures[i]).picture, {}});
    }
  }
  if (source.allow_cannot_tell) {
    question.options.push_back({"cannot_tell", "I cannot tell", std::nullopt, {}});
  }
  const ExperimentKind& kind = kind_named(trial.kind);
  if (kind.correct_of != nullptr) question.correct = kind.correct_of(source, trial);
  return question;
}

class Planner {
 public:
  Planner(const Protocol& protocol, const Allocation& allocation)
      : protocol_(protocol),
        allocation_(allocation),
        group_(group_factor(protocol, allocation.group)),
        random_(Random(allocation.seed).split("plan")) {}

  Plan make() {
    for (const Protocol::Step& step : protocol_.flow) {
      if (const auto* const run = std::get_if<Run>(&step)) {
        add(*run);
      } else if (const auto* const screen = std::get_if<Protocol::Screen>(&step)) {
        plan_.steps.emplace_back(*screen);
      } else if (const auto* const check = std::get_if<Protocol::Check>(&step)) {
        plan_.steps.emplace_back(*check);
      } else if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
        plan_.steps.emplace_back(*pause);
      } else {
        plan_.steps.emplace_back(std::get<Protocol::Ask>(step));
      }
    }
    return std::move(plan_);
  }

 private:
  void add(const Run& run) {
    const Block& block = protocol_.blocks.at(run.block);
    if (run.for_each.empty()) {
      add(run, block, group_);
      return;
    }
    const std::vector<Level>& levels = protocol_.factors.at(run.for_each).levels;
    bool is_first = true;
    for (const std::size_t index : counterbalanced(run.for_each, levels.size())) {
      if (!is_first && run.pause) plan_.steps.emplace_back(*run.pause);
      is_first = false;
      FactorLevels outer = group_;
      outer[run.for_each] = levels[index];
      add(run, block, outer);
    }
  }

  /// The row of the square that the allocation assigns to this factor. With several factors the row number is
  /// decomposed like the digits of a number, so that no two orders always occur together.
  std::vector<std::size_t> counterbalanced(const std::string& factor, std::size_t levels) const;

  void add(const Run& run, const Block& block, const FactorLevels& outer) {
    ++block_ordinal_;
    const Random random =
        random_.split(block.name).split(static_cast<std::uint64_t>(block_ordinal_));
    const std::vector<BlockRow> rows = rows_of(protocol_, block);
    const std::vector<std::size_t> order = order_of(block, rows, random.split("order"));
    const std::size_t trials =
        block.until ? std::min(order.size(), static_cast<std::size_t>(block.until->maximum_trials))
                    : order.size();
    std::map<std::string, std::vector<Level>, std::less<>> drawn{};
    for (const std::string& factor : block.drawn) {
      drawn[factor] = balanced_draws(protocol_.factors.at(factor).levels, trials,
                                     random.split("drawn").split(factor));
    }
    const auto positions =
        positions_of(block.positions, block.presented.size(), trials, random.split("positions"));
    if (!block.anchor.empty()) {
      Trial anchor{};
      anchor.repetition = 0;
      anchor.factors = outer;
      anchor.factors.insert(block.anchor.begin(), block.anchor.end());
      add(std::move(anchor), block, {block.presented.front()}, random.split("anchor"));
      plan_.trials.back().presentations.front().role = "anchor";
    }
    for (std::size_t i = 0; i < trials; ++i) {
      if (i > 0 && run.pause && run.break_every_trials > 0 &&
          i % static_cast<std::size_t>(run.break_every_trials) == 0) {
        plan_.steps.emplace_back(*run.pause);
      }
      Trial trial{};
      trial.repetition = static_cast<int>(order[i] / rows.size()) + 1;
      trial.factors = outer;
      const BlockRow& row = rows[order[i] % rows.size()];
      trial.factors.insert(row.factors.begin(), row.factors.end());
      for (const auto& [factor, levels] : drawn) trial.factors[factor] = levels[i];
      std::vector<Protocol::Presented> surfaces{};
      for (const std::size_t index : positions[i])
        surfaces.push_back(surface_of(block, row, index));
      add(std::move(trial), block, surfaces, random.split("pictures").split(i));
    }
  }

  /// A surface of a trial: where the block has pairs, with the level of the pair, which names it.
  static Protocol::Presented surface_of(const Block& block, const BlockRow& row,
                                        std::size_t index) {
    Protocol::Presented surface = block.presented[index];
    if (row.pair.empty()) return surface;
    surface.with[block.all_pairs->factor] = row.pair[index];
    surface.item = text_of(row.pair[index]);
    return surface;
  }

  /// Adds a trial whose factors are set, with its surfaces in order.
  void add(Trial trial, const Block& block, const std::vector<Protocol::Presented>& surfaces,
           const Random& pictures) {
    trial.ordinal = static_cast<int>(plan_.trials.size()) + 1;
    trial.block = block.name;
    trial.kind = block.kind;
    trial.block_ordinal = block_ordinal_;
    trial.phase = block.phase;
    for (const Protocol::Presented& surface : surfaces) {
      trial.presentations.push_back(
          presentation_of(protocol_, kind_of(block), surface, trial.factors));
      trial.presentations.back().position = static_cast<int>(trial.presentations.size());
      trial.presentations.back().code = place_code(trial.presentations.size() - 1);
    }
    const Texture* const texture = texture_of(protocol_, trial);
    trial.experimenter_prompt = texture == nullptr
                                    ? block.experimenter_prompt
                                    : with_code(block.experimenter_prompt, texture->code);
    if (texture != nullptr && protocol_.realism_standard == RealismStandard::photograph) {
      trial.standard_picture = texture->picture;
    }
    trial.allow_revisit = block.allow_revisit;
    trial.pictures_after_feeling = block.pictures_after_feeling;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      // The first question has the stream that it had when it was the only one.
      const Random of_question = trial.questions.empty() ? pictures : pictures.split(question.name);
      trial.questions.push_back(
          planned_question(protocol_, question, trial, pictures_of(question, of_question)));
    }
    trial.on_one_page = block.on_one_page;
    trial.page_prompt = block.page_prompt;
    if (block.shuffles_questions) {
      Random order = pictures.split("question order");
      order.shuffle(std::span<TrialQuestion>(trial.questions));
    }
    plan_.steps.emplace_back(TrialStep{plan_.trials.size()});
    plan_.trials.push_back(std::move(trial));
  }

  static std::vector<std::size_t> order_of(const Block& block, const std::vector<BlockRow>& rows,
                                           const Random& random) {
    const OrderProblem problem = order_problem(block, rows);
    if (block.order == Block::Order::fixed) {
      std::vector<std::size_t> order(problem.trials);
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      return order;
    }
    auto order = random_order(problem, random);
    if (!order) {
      throw std::runtime_error(
          "block " + block.name +
          ": no order of its trials satisfies maximum_in_a_row; allow more in a row");
    }
    return std::move(*order);
  }

  /// Questions with the same pictures show them at the same positions, unless they are reshuffled.
  std::vector<std::string> pictures_of(const Protocol::TrialQuestionTemplate& question,
                                       Random of_trial) const {
    std::vector<std::string> pictures = question.pictures;
    std::sort(pictures.begin(), pictures.end());
    if (question.reshuffle_pictures) {
      of_trial.shuffle(std::span<std::string>(pictures));
    } else {
      Random of_session = random_.split("pictures of the session");
      for (const std::string& picture : pictures) of_session = of_session.split(picture);
      of_session.shuffle(std::span<std::string>(pictures));
    }
    return pictures;
  }

  const Protocol& protocol_;
  Allocation allocation_{};
  FactorLevels group_{};  // the factor of the participant's group
  Random random_;
  Plan plan_{};
  int block_ordinal_ = 0;
};

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

std::vector<std::size_t> Planner::counterbalanced(const std::string& factor,
                                                  std::size_t levels) const {
  const Square square = square_of(protocol_.counterbalance, levels);
  const int rows = counterbalance_rows(protocol_);
  auto row = static_cast<std::size_t>(((allocation_.counterbalance_row % rows) + rows) % rows);
  for (const std::string& before : iterated_factors(protocol_)) {
    if (before == factor) break;
    row /= square_of(protocol_.counterbalance, protocol_.factors.at(before).levels.size()).size();
  }
  return square[row % square.size()];
}

}  // namespace

const Exploration& exploration_of(const Protocol& protocol, const Trial& trial) {
  const Binding<std::string>& named = protocol.blocks.at(trial.block).exploration;
  return protocol.explorations.at(named.value ? *named.value
                                              : text_of(trial.factors.at(named.factor)));
}

bool are_of_one_stimulus(const Trial& one, const Trial& other) {
  return one.factors == other.factors &&
         one.presentations.front().stimulus.name == other.presentations.front().stimulus.name;
}

Plan make_plan(const Protocol& protocol, const Allocation& allocation) {
  return Planner(protocol, allocation).make();
}

std::vector<Trial> possible_trials(const Protocol& protocol) {
  Protocol every = protocol;
  for (auto& [name, block] : every.blocks) {
    block.order = Block::Order::fixed;
    block.positions = Block::Positions::as_listed;
    block.repetitions = 1;
    block.maximum_in_a_row.clear();
    block.until.reset();
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
  }
  std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) groups.emplace_back();
  std::vector<Trial> trials{};
  for (const std::string& group : groups) {
    std::vector<Trial> own = make_plan(every, {.group = group}).trials;
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

int counterbalance_rows(const Protocol& protocol) {
  std::size_t rows = 1;
  for (const std::string& factor : iterated_factors(protocol)) {
    rows *= square_of(protocol.counterbalance, protocol.factors.at(factor).levels.size()).size();
  }
  return static_cast<int>(rows);
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
