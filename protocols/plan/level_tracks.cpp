// Implements interleaved tracks.

#include "protocols/plan/level_tracks.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/surface_order.h"

namespace asperity {

namespace {

/// The type of the `count`-th trial of a stream where a design has several: all of them in every round, in random order.
/// Otherwise that of the row.
const DesignTrial* type_of_trial(const Protocol::Block& block, const BlockRow& row,
                                 std::size_t count, const Random& draws) {
  const std::span<const DesignTrial> types = block.design()->trials;
  if (types.size() < 2) return row.type;
  std::vector<std::size_t> order(types.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random round = draws.split("types").split(static_cast<std::uint64_t>((count - 1) / types.size()));
  round.shuffle(std::span(order));
  return &types[order[(count - 1) % types.size()]];
}

/// The surfaces with the standard in place of the varied one, which counts as another item in the responses.
std::vector<Protocol::Presented> standards_in_place_of(const Dimension& vary,
                                                       std::vector<Protocol::Presented> surfaces) {
  const auto standard = std::find_if(surfaces.begin(), surfaces.end(), [&vary](const auto& each) {
    return each.role == vary.standard_role;
  });
  if (standard == surfaces.end()) return surfaces;
  const Protocol::Presented second = *standard;
  for (Protocol::Presented& surface : surfaces) {
    if (surface.role != vary.role) continue;
    surface = second;
    surface.item = vary.standard_role + "_2";
  }
  return surfaces;
}

std::vector<LevelRule> rules_of(const Protocol::Block& block) {
  std::vector<LevelRule> rules{};
  for (const ProcedureSettings& settings : block.procedure->tracks) {
    if (std::holds_alternative<External>(settings)) continue;
    rules.push_back(procedure_of(settings).rule(settings));
  }
  return rules;
}

}  // namespace

RulesByBlock rules_of(const Protocol& protocol) {
  RulesByBlock rules{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.procedure) rules[name] = rules_of(block);
  }
  return rules;
}

LevelTracks::LevelTracks(const Protocol& protocol, BlockRun run, const RulesByBlock* rules)
    : protocol_(&protocol), run_(std::move(run)), rows_(rows_of(protocol, *run_.block)) {
  std::vector<Track> of_row{};  // the tracks of all rows share their rules
  const std::vector<LevelRule> of_block =
      rules == nullptr ? rules_of(*run_.block) : rules->at(run_.block->name);
  auto rule = of_block.begin();
  for (const ProcedureSettings& settings : run_.block->procedure->tracks) {
    const Procedure& procedure = procedure_of(settings);
    Track track{.most_trials = procedure.most_trials(settings), .answered = {.settings = settings}};
    if (const auto* const external = std::get_if<External>(&settings)) {
      track.levels = *external;
    } else {
      track.levels = *rule++;
    }
    of_row.push_back(std::move(track));
  }
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (Track track : of_row) {
      track.row = row;
      track.random = run_.random.split("track").split(static_cast<std::uint64_t>(tracks_.size()));
      tracks_.push_back(std::move(track));
    }
  }
}

std::optional<double> LevelTracks::next_level(Track& track) {
  // Trials without an answer repeat their level: a participant who no longer responds must not repeat it for ever.
  if (track.trials >= kMostPresented * track.most_trials) return std::nullopt;
  const auto* const rule = std::get_if<LevelRule>(&track.levels);
  if (rule != nullptr && !track.next) track.next = (*rule)(track.answered.answers, track.random);
  const auto* const next = std::get_if<NextLevel>(&track.next.value());
  return next == nullptr ? std::nullopt : std::optional(next->level);
}

bool LevelTracks::is_open(Track& track) {
  if (std::holds_alternative<LevelRule>(track.levels) || track.next) {
    return next_level(track).has_value();
  }
  return track.answered.answers.size() < track.most_trials &&
         track.trials < kMostPresented * track.most_trials;
}

/// Begins a round where none is under way, and leaves out the tracks that a program has ended.
void LevelTracks::settle_round() {
  for (;;) {
    if (round_.empty()) begin_round();
    if (round_.empty()) return;
    const Track& track = tracks_[round_.back()];
    if (!std::holds_alternative<External>(track.levels) || !track.next ||
        std::holds_alternative<NextLevel>(*track.next)) {
      return;
    }
    round_.pop_back();
  }
}

std::optional<LevelRequest> LevelTracks::request() {
  settle_round();
  if (round_.empty()) return std::nullopt;
  const std::size_t index = round_.back();
  const Track& track = tracks_[index];
  const auto* const external = std::get_if<External>(&track.levels);
  if (external == nullptr || track.next) return std::nullopt;
  LevelRequest request{
      .block_ordinal = run_.ordinal,
      .block = run_.block->name,
      .of = {.track = static_cast<int>(index) + 1, .step = static_cast<int>(track.trials) + 1},
      .tracks = tracks_.size(),
      .factors = run_.outer,
      .settings = *external,
      .answers = answers_};
  request.factors.insert(rows_[track.row].factors.begin(), rows_[track.row].factors.end());
  return request;
}

void LevelTracks::supply(const NextStep& step) {
  Track* const track = round_.empty() ? nullptr : &tracks_[round_.back()];
  const auto* const external = track == nullptr ? nullptr : std::get_if<External>(&track->levels);
  if (external == nullptr || track->next) {
    throw std::logic_error(
        "LevelTracks::supply must not be called: no level is requested; call request() before");
  }
  const auto* const next = std::get_if<NextLevel>(&step);
  const std::vector<double>& levels = external->levels;
  if (next != nullptr && std::find(levels.begin(), levels.end(), next->level) == levels.end()) {
    throw std::invalid_argument("level " + number_text(next->level) +
                                " is not one of the levels of the block " + run_.block->name);
  }
  track->next = step;
  settle_round();
}

void LevelTracks::begin_round() {
  std::vector<std::size_t> open{};
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (is_open(tracks_[i])) open.push_back(i);
  }
  if (run_.block->order == Protocol::Block::Order::fixed) {
    open.resize(std::min<std::size_t>(open.size(), 1));
  } else {
    Random random = run_.random.split("round").split(static_cast<std::uint64_t>(rounds_));
    random.shuffle(std::span(open));
  }
  ++rounds_;
  round_.assign(open.rbegin(), open.rend());
}

std::optional<Trial> LevelTracks::next(const TrialMaker& maker) {
  settle_round();
  if (round_.empty()) return std::nullopt;
  return is_place_of_catch_trial() ? next_catch_trial(maker) : next_of_track(maker);
}

bool LevelTracks::is_place_of_catch_trial() const {
  const auto& catch_trials = run_.block->procedure->catch_trials;
  if (!catch_trials) return false;
  const auto every = static_cast<std::size_t>(catch_trials->every);
  Random place =
      run_.random.split("catch places").split(static_cast<std::uint64_t>(trials_ / every));
  return place.below(every) == trials_ % every;
}

void LevelTracks::answer(const std::optional<LevelAnswer>& answer) {
  if (!answer || !awaited_) return;
  Track& track = tracks_.at(*awaited_);
  track.answered.answers.push_back(*answer);
  track.next.reset();
  if (!std::holds_alternative<External>(track.levels)) return;
  answers_.push_back(
      {.of = {.track = static_cast<int>(*awaited_) + 1, .step = static_cast<int>(track.trials)},
       .answer = *answer});
}

Trial LevelTracks::next_of_track(const TrialMaker& maker) {
  const std::size_t index = round_.back();
  round_.pop_back();
  awaited_ = index;
  Track& track = tracks_[index];
  const double level = next_level(track).value();
  const std::size_t step = ++track.trials;
  Trial trial{};
  trial.track = TrackStep{.track = static_cast<int>(index) + 1, .step = static_cast<int>(step)};
  trial.repetition = static_cast<int>(step);
  trial = made(std::move(trial), track.row, level, step, track.random, maker);
  for (const PlannedPresentation& planned : trial.presentations) {
    if (planned.role != run_.block->vary->role) continue;
    track.answered.stimulus = planned.stimulus_template;
    track.answered.model = planned.stimulus.model;
    track.answered.texture = planned.stimulus.texture;
  }
  return trial;
}

std::vector<AnsweredTrack> LevelTracks::answered() const {
  std::vector<AnsweredTrack> all{};
  for (const Track& track : tracks_) all.push_back(track.answered);
  return all;
}

/// The combinations of the other factors take turns, in an order that is drawn anew for each turn.
Trial LevelTracks::next_catch_trial(const TrialMaker& maker) {
  awaited_.reset();
  const Dimension& dimension = *run_.block->vary;
  const Protocol::Block::LevelProcedure::CatchTrials& catch_trials =
      *run_.block->procedure->catch_trials;
  const double level = catch_trials.level;
  const Random draws = run_.random.split("catch trials");
  std::vector<std::size_t> rows(rows_.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  Random turn = draws.split("rows").split(static_cast<std::uint64_t>(catch_trials_ / rows.size()));
  turn.shuffle(std::span(rows));
  const std::size_t row = rows[catch_trials_ % rows.size()];
  ++catch_trials_;
  Trial trial{};
  trial.repetition = 0;
  trial.catch_trial =
      CatchTrial{.type = catch_trials.type,
                 .is_above_standard = dimension.value_of(level) > dimension.standard.value_or(0.0)};
  return made(std::move(trial), row, level, catch_trials_, draws, maker);
}

Trial LevelTracks::made(Trial trial, std::size_t row, double level, std::size_t count,
                        const Random& draws, const TrialMaker& maker) {
  const Protocol::Block& block = *run_.block;
  BlockRow with = rows_[row];
  with.type = type_of_trial(block, with, count, draws);
  trial.factors = run_.outer;
  trial.factors.insert(with.factors.begin(), with.factors.end());
  trial.factors[block.vary->factor] = block.vary->value_of(level);
  for (const std::string& factor : block.drawn) {
    trial.factors[factor] = balanced_draws(protocol_->factors.at(factor).levels, count,
                                           draws.split("drawn").split(factor))
                                .back();
  }
  const bool is_pair_of_standards = trial.catch_trial && trial.catch_trial->type != CatchType::easy;
  const std::vector<Protocol::Presented> listed =
      is_pair_of_standards ? standards_in_place_of(*block.vary, surfaces_of(block, with))
                           : surfaces_of(block, with);
  std::vector<Protocol::Presented> surfaces{};
  const auto positions =
      positions_of(block.positions, listed.size(), count, draws.split("positions"));
  for (const std::size_t surface : positions.back()) {
    surfaces.push_back(listed[surface]);
  }
  const Random pictures = run_.random.split("pictures").split(static_cast<std::uint64_t>(trials_));
  ++trials_;
  return maker.make(std::move(trial), run_, surfaces, pictures);
}

std::size_t most_trials_of(const Protocol& protocol, const Protocol::Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const std::size_t of_row =
      std::accumulate(tracks.begin(), tracks.end(), std::size_t{0},
                      [](std::size_t sum, const ProcedureSettings& settings) {
                        return sum + procedure_of(settings).most_trials(settings);
                      });
  const std::size_t of_tracks = of_row * row_count(protocol, block);
  const auto& catch_trials = block.procedure->catch_trials;
  if (!catch_trials) return of_tracks;
  const auto others = static_cast<std::size_t>(catch_trials->every - 1);
  return of_tracks + (of_tracks + others - 1) / others;
}

}  // namespace asperity
