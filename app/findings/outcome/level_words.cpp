// Sentences by procedure: up-down tracks, psi and QUEST+, external programs, and constant stimuli.

#include "app/findings/outcome/level_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

std::string level_text(const Block& block, double level) {
  switch (block.vary->measure) {
    case LevelMeasure::value:
    case LevelMeasure::difference:
      return stated_quantity(level, unit_of_varied(block));
    case LevelMeasure::percent:
      return stated_quantity(level, "%");
    case LevelMeasure::ratio:
      return stated_quantity(level, "");
    case LevelMeasure::decibels:
      return stated_quantity(level, "dB");
  }
  return {};
}

/// "differs from it by 5 %", after the varied quantity of the comparison. `standard`: "it"; `of_several`: the values are
/// several.
std::string differing_by(const Block& block, const std::string& values, const std::string& standard,
                         bool of_several) {
  const auto has = [of_several](const std::string& one) {
    return of_several ? "has " + one + 's' : "has a " + one;
  };
  switch (block.vary->measure) {
    case LevelMeasure::value:
      return has("value") + " of " + values;
    case LevelMeasure::difference:
    case LevelMeasure::percent:
      return "differs from " + standard + " by " + values;
    case LevelMeasure::ratio:
      return has("ratio") + " to " + standard + " of " + values;
    case LevelMeasure::decibels:
      return "differs from " + standard + " by " + values;
  }
  return {};
}

/// A step of the grid's scale: "16 %", "2 dB", "a factor of 1.2".
std::string step_text(const Block& block, LevelScale scale, double step) {
  switch (scale) {
    case LevelScale::linear:
      return level_text(block, step);
    case LevelScale::log10:
      return stated_quantity(step, "") + " log10 units";
    case LevelScale::decibel:
      return stated_quantity(step, "dB");
    case LevelScale::ratio:
      return "a factor of " + stated_quantity(step, "");
  }
  return {};
}

std::string ordinal(std::size_t number) {
  constexpr std::array<std::string_view, 6> kWords{"first",  "second", "third",
                                                   "fourth", "fifth",  "sixth"};
  return number <= kWords.size() ? std::string(kWords[number - 1]) : std::to_string(number) + "th";
}

/// "16 % of the standard up to the first reversal, 8 % up to the second and 4 % thereafter".
std::string steps_text(const Block& block, LevelScale scale, const StepList& steps) {
  const std::string of_what =
      scale == LevelScale::linear && block.vary->measure == LevelMeasure::percent
          ? " of the standard"
          : "";
  if (steps.size() == 1) return step_text(block, scale, steps.front()) + of_what;
  std::vector<std::string> parts{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    parts.push_back(step_text(block, scale, steps[i]) + (i == 0 ? of_what : "") +
                    (i + 1 == steps.size()
                         ? " thereafter"
                         : " up to the " + ordinal(i + 1) + (i == 0 ? " reversal" : "")));
  }
  return listed(parts);
}

/// The common ratio of the steps upwards to those downwards; 0 where it is not the same for all.
double ratio_of_steps(const UpDownTrack& track) {
  if (track.steps_up.size() != track.steps_down.size()) return 0.0;
  const double first = track.steps_up.front() / track.steps_down.front();
  for (std::size_t i = 0; i < track.steps_up.size(); ++i) {
    if (std::abs(track.steps_up[i] / track.steps_down[i] - first) > 1e-6 * first) return 0.0;
  }
  return first;
}

std::string all_steps_text(const Block& block, const UpDownTrack& track) {
  const std::string down = steps_text(block, track.grid.scale, track.steps_down);
  const char* const verb = track.steps_down.size() == 1 ? "was " : "were ";
  if (track.steps_up == track.steps_down) {
    return (track.steps_down.size() == 1 ? "The step was " : "Steps were ") + down + '.';
  }
  const std::string of_down =
      (track.steps_down.size() == 1 ? "The step downwards " : "Steps downwards ") + (verb + down);
  const double ratio = ratio_of_steps(track);
  if (ratio > 0.0 && track.grid.scale == LevelScale::linear) {
    return of_down + ", and " + (track.steps_down.size() == 1 ? "that" : "those") + " upwards " +
           verb + number_text(std::round(1000.0 * ratio) / 1000.0) + " times as large.";
  }
  return of_down + "; " +
         (track.steps_up.size() == 1 ? "the step upwards was " : "steps upwards were ") +
         steps_text(block, track.grid.scale, track.steps_up) + '.';
}

/// " After the response “cannot tell” the level moved up by 8 % of the standard, the mean step of a guess."; nothing where a
/// choice is forced.
std::string unsure_steps_text(const Block& block, const UpDownTrack& track) {
  if (track.steps_unsure.empty()) return {};
  return " After the response “cannot tell” the level moved up by " +
         steps_text(block, track.grid.scale, track.steps_unsure) + ", the mean step of a guess.";
}

/// "after 60 trials", "after 8 reversals, or at the latest after 60 trials"
std::string end_text(const StopRules& stop) {
  const std::string trials =
      std::to_string(stop.trials) + (stop.trials == 1 ? " trial" : " trials");
  std::vector<std::string> ends{};
  if (stop.reversals) {
    ends.push_back("after " + std::to_string(*stop.reversals) +
                   (*stop.reversals == 1 ? " reversal" : " reversals"));
  }
  if (stop.clipped_moves) {
    ends.push_back(*stop.clipped_moves == 1
                       ? "when an end of the range of levels had limited a step"
                       : "when an end of the range of levels had limited " +
                             std::to_string(*stop.clipped_moves) + " steps in succession");
  }
  if (ends.empty()) return "after " + trials;
  ends.push_back("at the latest after " + trials);
  std::string text = ends.front();
  for (std::size_t i = 1; i < ends.size(); ++i) text += ", or " + ends[i];
  return text;
}

/// What moves a track down, of which the target is a proportion: "correct responses".
std::string downward_responses(const Block& block) {
  const auto* const judged = judged_question(block);
  if (judged == nullptr || judged->judgement() == DiscriminationJudgement::performance) {
    return "correct responses";
  }
  return judged->asks_for_less() ? "choices of the standard" : "choices of the comparison";
}

/// "A 3-down/1-up staircase [Levitt 1971] with a target of 79.4 % correct responses"
std::string rule_text(const Block& block, const ProcedureSettings& first) {
  std::string text{};
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&first)) {
    text = "A " + std::to_string(transformed->track.rule.down) + "-down/" +
           std::to_string(transformed->track.rule.up) + "-up staircase [Levitt 1971]";
  } else {
    const auto* const weighted = std::get_if<WeightedUpDown>(&first);
    text = weighted != nullptr && weighted->unforced_alternatives
               ? "An unforced weighted up-down staircase [Kaernbach 2001]"
               : "A weighted up-down staircase [Kaernbach 1991]";
  }
  if (const std::optional<double> target = procedure_of(first).target(first)) {
    text += " with a target of " + fixed(100.0 * *target, 1) + " % " + downward_responses(block);
  }
  return text + " chose the " + words_of_parameter(block.vary->parameter) + " of the comparison";
}

/// Nothing for a procedure without a track of steps.
std::optional<UpDownTrack> up_down_track(const ProcedureSettings& settings) {
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&settings)) {
    return transformed->track;
  }
  if (const auto* const weighted = std::get_if<WeightedUpDown>(&settings)) {
    return track_of(*weighted);
  }
  return {};
}

/// Tracks differ in their start only.
std::string up_down_sentences(const Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  std::vector<std::string> starts{};
  for (const ProcedureSettings& each : tracks) {
    const std::optional<UpDownTrack> track = up_down_track(each);
    if (track) starts.push_back(level_text(block, track->start));
  }
  const std::optional<UpDownTrack> first = up_down_track(tracks.front());
  if (!first) return {};
  std::string text = rule_text(block, tracks.front()) + " from the responses";
  if (tracks.size() > 1) {
    const std::string count = count_in_words(tracks.size());
    text += (block.order == Block::Order::fixed ? ", in " + count + " tracks one after the other"
                                                : ", in " + count + " randomly interleaved tracks");
  }
  const bool is_one_start =
      std::all_of(starts.begin(), starts.end(),
                  [&starts](const std::string& start) { return start == starts.front(); });
  text += tracks.size() == 1 ? ". It began at " : ". The tracks began at ";
  text += is_one_start ? starts.front() : listed(starts);
  text += ", and levels remained between " + level_text(block, first->grid.lowest) + " and " +
          level_text(block, levels_of(first->grid).back()) + ". " + all_steps_text(block, *first) +
          unsure_steps_text(block, *first) +
          (tracks.size() == 1 ? " The staircase ended " : " Each track ended ") +
          end_text(first->stop) + '.';
  return text;
}

/// ", with slope and lapse rate marginalised [Prins 2013],"; nothing where none is.
std::string marginalised_text(const ProcedureSettings& settings) {
  const auto* const psi = std::get_if<Psi>(&settings);
  if (psi == nullptr || psi->marginalised.empty()) return {};
  std::vector<std::string> names{};
  for (const NuisanceParameter parameter : psi->marginalised) {
    names.emplace_back(parameter == NuisanceParameter::slope ? "slope" : "lapse rate");
  }
  return ", with " + listed(names) + " marginalised [Prins 2013],";
}

std::string values_text(const ValueRange& range) {
  return std::to_string(range.count) + (range.count == 1 ? " value" : " values");
}

/// "after 60 trials", "when the 95 % credible interval …, or at the latest after 60 trials"
std::string end_of_posterior_text(const PosteriorStop& stop) {
  const std::string trials =
      std::to_string(stop.trials) + (stop.trials == 1 ? " trial" : " trials");
  if (!stop.interval) return "after " + trials;
  const IntervalRule& rule = *stop.interval;
  return "when the upper end of the 95 % credible interval of the threshold was at most " +
         number_text(rule.ratio) + " times the lower end, after at least " +
         std::to_string(rule.minimum_trials) + " trials with at least " +
         std::to_string(rule.minimum_of_each) +
         " correct and as many incorrect responses, or at the latest after " + trials;
}

/// Of psi and QUEST+; tracks have the same settings.
std::string posterior_sentences(const Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const PosteriorTrack* const track = posterior_track_of(tracks.front());
  if (track == nullptr) return {};
  const bool is_psi = std::holds_alternative<Psi>(tracks.front());
  const ThresholdPrior& prior = track->prior;
  std::string text = is_psi ? "The psi procedure [Kontsevich 1999]" : "QUEST+ [Watson 2017]";
  text += marginalised_text(tracks.front()) + " chose the " +
          words_of_parameter(block.vary->parameter) + " of the comparison from the responses";
  if (tracks.size() > 1) {
    const std::string count = count_in_words(tracks.size());
    text += (block.order == Block::Order::fixed ? ", in " + count + " tracks one after the other"
                                                : ", in " + count + " randomly interleaved tracks");
  }
  const std::vector<double> levels = levels_of(track->grid);
  text += ". Levels remained between " + level_text(block, levels.front()) + " and " +
          level_text(block, levels.back()) +
          ". Before the first response, a Weibull function of the difference from the standard had "
          "equally probable values of its threshold at " +
          fixed(100.0 * prior.performance, 1) + " % correct responses (" +
          values_text(prior.thresholds) + " between " +
          level_text(block, track->origin + prior.thresholds.lowest) + " and " +
          level_text(block, track->origin + prior.thresholds.highest) +
          ", in steps of equal ratio), its slope (" + values_text(prior.slopes) + " between " +
          number_text(prior.slopes.lowest) + " and " + number_text(prior.slopes.highest) +
          ") and its lapse rate (" + values_text(prior.lapses) + " between " +
          number_text(100.0 * prior.lapses.lowest) + " % and " +
          number_text(100.0 * prior.lapses.highest) + " %). " +
          (tracks.size() == 1 ? "The track ended " : "Each track ended ") +
          end_of_posterior_text(track->stop) + '.';
  return text;
}

/// Of the levels that a program stated; tracks have the same settings.
std::string external_sentences(const Block& block) {
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  const auto* const method = std::get_if<External>(&tracks.front());
  if (method == nullptr) return {};
  std::string text = "An external program chose the " + words_of_parameter(block.vary->parameter) +
                     " of the comparison";
  if (tracks.size() > 1) {
    const std::string count = count_in_words(tracks.size());
    text += (block.order == Block::Order::fixed ? ", in " + count + " tracks one after the other"
                                                : ", in " + count + " randomly interleaved tracks");
  }
  return text + ". Levels remained between " + level_text(block, method->levels.front()) + " and " +
         level_text(block, method->levels.back()) + ". " +
         (tracks.size() == 1 ? "The track" : "Each track") +
         " ended when the program ended it, or at the latest after " +
         std::to_string(method->trials) + (method->trials == 1 ? " trial." : " trials.");
}

std::string catch_sentences(const Block& block) {
  if (!has_catch_trials(block)) return {};
  const std::string easy = catch_level_text(block);
  return " One in every " + std::to_string(block.procedure->catch_trials->every) +
         " trials, at a random place, was a catch trial, in which " +
         (easy.empty() ? std::string("two standards were presented and “cannot tell” was the "
                                     "correct response")
                       : "the comparison " + in_past(easy)) +
         "; no threshold was estimated from catch trials.";
}

}  // namespace

std::string unit_of_varied(const Block& block) {
  return block.vary->unit.empty() ? unit_of_parameter(block.vary->parameter) : block.vary->unit;
}

std::string levels_text(const Block& block, const std::string& standard) {
  constexpr std::size_t kMostListed = 12;
  const std::vector<double> levels = block.vary->levels();
  std::vector<std::string> texts{};
  for (const double level : levels) texts.push_back(level_text(block, level));
  const std::string values = texts.size() > kMostListed
                                 ? texts.front() + " to " + texts.back() + " in " +
                                       std::to_string(texts.size()) + " levels"
                                 : listed(texts);
  return differing_by(block, values, standard, levels.size() > 1);
}

bool has_catch_trials(const Block& block) {
  return block.procedure && block.procedure->catch_trials;
}

std::string catch_level_text(const Block& block) {
  if (!has_catch_trials(block)) return {};
  if (block.procedure->catch_trials->type != CatchType::easy) return {};
  return differing_by(block, level_text(block, block.procedure->catch_trials->level),
                      "the standard", false);
}

std::string in_past(std::string differing) {
  differing.replace(0, differing.find(' '), differing.starts_with("differs") ? "differed" : "had");
  return differing;
}

std::string as_possible(std::string differing) {
  differing.replace(0, differing.find(' '),
                    differing.starts_with("differs") ? "could differ" : "could have");
  return differing;
}

std::string procedure_sentences(const Block& block) {
  if (!block.procedure || block.procedure->tracks.empty()) {
    return "The levels were presented by the method of constant stimuli.";
  }
  std::string text = up_down_sentences(block);
  if (text.empty()) text = posterior_sentences(block);
  if (text.empty()) text = external_sentences(block);
  if (text.empty()) {
    const ProcedureSettings& first = block.procedure->tracks.front();
    const auto& constant = std::get<ConstantStimuli>(first);
    text = "The levels were presented by the method of constant stimuli, " +
           (constant.repetitions == 1 ? std::string("each once")
                                      : "each " + count_in_words(constant.repetitions) + " times") +
           (block.procedure->tracks.size() > 1
                ? " in each of " + count_in_words(block.procedure->tracks.size()) + " tracks"
                : "") +
           '.';
  }
  if (block.procedure->timeouts_are_incorrect && block.response_deadline_s) {
    text += " A missed deadline counted as an incorrect response.";
  }
  return text + catch_sentences(block);
}

}  // namespace asperity
