// Tracks of up-down staircases: the levels from the responses, and the mean of the reversals.

#include "analysis/psychometric/staircase.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"
#include "protocols/design/wording.h"

namespace asperity {
namespace {

/// The rule of one track, and which of its reversals are averaged.
struct TrackRule {
  Staircase staircase{};
  ReversalQuestion question{};
};

/// The responses of one track in the order of its trials.
struct TrackOfTable {
  std::string name{};
  std::vector<std::uint64_t> trials{};
  std::vector<bool> is_correct{};
};

LevelScale scale_named(const std::string& name) {
  for (const LevelScale scale :
       {LevelScale::linear, LevelScale::log10, LevelScale::decibel, LevelScale::ratio}) {
    if (name == name_of(scale)) return scale;
  }
  throw std::runtime_error("the option \"scale\" is \"" + name +
                           "\"; it must be linear, log10, db or ratio");
}

std::size_t whole_number(const FamilyOptions& options, const std::string& name) {
  constexpr double kMost = 1e6;
  const double number = options.number(name);
  if (number >= 0.0 && number <= kMost &&
      number == static_cast<double>(static_cast<std::size_t>(number))) {
    return static_cast<std::size_t>(number);
  }
  throw std::runtime_error("the option \"" + name + "\" is " + number_text(number) +
                           "; it must be a whole number from 0 to 1000000");
}

void refuse_unknown(const FamilyOptions& options) {
  const std::vector<std::string> known{"start", "n_down", "n_up", "step",    "step_up_ratio",
                                       "scale", "min",    "max",  "discard", "even"};
  for (const std::string& name : options.names()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = did_you_mean(name, known);
    throw std::runtime_error("there is no option \"" + name + '"' +
                             (meant.empty() ? "; use one of: " + listed_words(known) : meant));
  }
}

TrackRule rule_of(const FamilyOptions& options) {
  refuse_unknown(options);
  const LevelScale scale = scale_named(options.text("scale"));
  constexpr double kNoBound = std::numeric_limits<double>::infinity();
  TrackRule rule{.staircase = {.start = options.number("start"),
                               .rule = {.up = whole_number(options, "n_up"),
                                        .down = whole_number(options, "n_down")},
                               .scale = scale,
                               .steps = options.numbers("step"),
                               .up_over_down = options.number_or("step_up_ratio", 1.0),
                               .lowest = options.number_or("min", -kNoBound),
                               .highest = options.number_or("max", kNoBound)},
                 .question = {.scale = scale,
                              .discard = whole_number(options, "discard"),
                              .even_number = options.truth_or("even", false)}};
  try {
    replay_staircase(rule.staircase, {});
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(std::string(error.what()) + "; correct the rule");
  }
  return rule;
}

std::vector<std::pair<std::string, TrackRule>> rules_of(const FamilyOptions& options) {
  std::vector<std::pair<std::string, TrackRule>> rules{};
  for (const auto& [name, of_track] : options.objects("tracks")) {
    try {
      rules.emplace_back(name, rule_of(of_track));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("tracks." + name + ": " + error.what());
    }
  }
  return rules;
}

/// One per rule, in its order. A row without a response has no trial.
std::vector<TrackOfTable> answered_tracks(
    const TidyTable& table, const std::vector<std::pair<std::string, TrackRule>>& rules) {
  std::vector<std::string> names{};
  for (const auto& [name, rule] : rules) names.push_back(name);
  const LabelColumn tracks = table.all_labels("track");
  const std::vector<std::uint64_t> trials = table.counts("trial");
  const NumberColumn responses = table.numbers("response");
  std::vector<std::vector<std::size_t>> rows(rules.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = tracks.names[tracks.codes[row]];
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      table.refuse(row, "track",
                   "the track \"" + name + "\" has no rule; add it to the option \"tracks\"");
    }
    if (responses[row] && *responses[row] != 0.0 && *responses[row] != 1.0) {
      table.refuse(row, "response",
                   "response is " + number_text(*responses[row]) +
                       "; it must be 1 (correct) or 0 (incorrect), or empty");
    }
    rows[static_cast<std::size_t>(found - names.begin())].push_back(row);
  }
  std::vector<TrackOfTable> answered{};
  for (std::size_t track = 0; track < rules.size(); ++track) {
    std::vector<std::size_t>& own = rows[track];
    if (own.empty()) {
      throw std::runtime_error("tracks." + names[track] +
                               ": the table has no trial of this track; remove its rule, or "
                               "correct its name");
    }
    std::stable_sort(own.begin(), own.end(),
                     [&trials](std::size_t a, std::size_t b) { return trials[a] < trials[b]; });
    const auto same = std::adjacent_find(
        own.begin(), own.end(),
        [&trials](std::size_t a, std::size_t b) { return trials[a] == trials[b]; });
    if (same != own.end()) {
      table.refuse(*(same + 1), "trial",
                   "the track " + names[track] + " already has a trial " +
                       std::to_string(trials[*same]) + "; number the trials of a track in order");
    }
    TrackOfTable one{.name = names[track]};
    for (const std::size_t row : own) {
      if (!responses[row]) continue;
      one.trials.push_back(trials[row]);
      one.is_correct.push_back(*responses[row] == 1.0);
    }
    answered.push_back(std::move(one));
  }
  return answered;
}

/// The numbers of one track.
class TrackFindings final {
 public:
  TrackFindings(const TrackRule& rule, const TrackOfTable& answered, FindingList& findings)
      : rule_(rule),
        answered_(answered),
        track_(replay_staircase(rule.staircase, answered.is_correct)),
        findings_(findings) {}

  void add() {
    levels();
    bounds();
    reversals();
    threshold();
    target();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = answered_.trials.size(), .method = std::move(method)};
  }
  void number(const char* quantity, double value, std::string method) {
    findings_.number(quantity, answered_.name, value, basis(std::move(method)));
  }

  void levels() {
    for (std::size_t i = 0; i < track_.trials.size(); ++i) {
      findings_.number("level", {answered_.name, std::to_string(answered_.trials[i])},
                       track_.trials[i].level,
                       {.n = 1, .method = "level of a trial, from the rule and the responses"});
    }
    number("next.level", track_.next_level, "level of the next trial");
  }

  /// A track that stays at a bound of its levels.
  void bounds() {
    const auto at = [this](double bound) {
      return std::count_if(track_.trials.begin(), track_.trials.end(),
                           [bound](const auto& trial) { return trial.level == bound; });
    };
    const auto state = [this](auto count, const char* which, const char* where) {
      if (2 * static_cast<std::size_t>(count) <= track_.trials.size()) return;
      findings_.word("bound.status", answered_.name, std::string("at_") + which,
                     std::to_string(count) + " of " + std::to_string(track_.trials.size()) +
                         " trials are at the " + which +
                         " level, so that the mean of the reversals depends on this bound, and the "
                         "threshold may lie " +
                         where + ": extend the levels, and run the track again",
                     basis("trials at a bound of the levels"));
    };
    state(at(rule_.staircase.lowest), "lowest", "below it");
    state(at(rule_.staircase.highest), "highest", "above it");
  }

  void reversals() {
    std::string trials{};
    std::size_t count = 0;
    std::size_t clipped = 0;
    for (std::size_t i = 0; i < track_.trials.size(); ++i) {
      if (track_.trials[i].is_clipped) ++clipped;
      if (!track_.trials[i].is_reversal) continue;
      trials += (count++ == 0 ? "" : ";") + std::to_string(answered_.trials[i]);
    }
    findings_.count("n.reversals", answered_.name, count,
                    basis("reversals: responses after which the level changes its direction"));
    findings_.count("n.clipped", answered_.name, clipped,
                    basis("moves that a bound shortened or prevented"));
    findings_.word("reversal.trials", answered_.name, trials,
                   count == 0 ? "the track has no reversal: run more trials" : "ok",
                   basis("trials of the reversals"));
  }

  void threshold() {
    const auto mean = mean_of_reversals(track_, rule_.question);
    if (!mean) {
      findings_.word("threshold", answered_.name, "insufficient_reversals",
                     "the track has no reversal after the discarded ones: run more trials, or "
                     "discard fewer",
                     basis("mean of the levels of the reversals"));
      return;
    }
    const bool is_linear = rule_.question.scale == LevelScale::linear;
    const std::string unit = is_linear ? "" : ", in log10 units";
    findings_.count("n.used", answered_.name, mean->used,
                    basis("reversals after the discarded ones"));
    number("threshold", mean->mean,
           std::string(is_linear ? "mean" : "geometric mean") +
               " of the levels of the reversals: the level at which target.p of the responses are "
               "correct");
    number("threshold.median", mean->median, "median of the levels of the reversals");
    if (mean->sd) number("reversal.sd", *mean->sd, "SD of the levels of the reversals" + unit);
    if (mean->midpoint_error) {
      number("threshold.se.midpoints", *mean->midpoint_error,
             "SD of the midpoints of runs over √(number of midpoints)" + unit);
    }
  }

  void target() {
    const Staircase& staircase = rule_.staircase;
    const double performance = balanced_performance(staircase.rule, staircase.up_over_down);
    const std::string method =
        "proportion correct to which the track converges: moves up and down are in balance";
    if (staircase.rule.up == 1) {
      number("target.p", performance, method);
      return;
    }
    Basis none = basis("closed form of target.p.balance for rules with 1 up");
    none.undefined = "there is a closed form only for rules with 1 up; use target.p.balance";
    findings_.number("target.p", answered_.name, kUndefined, none);
    number("target.p.balance", performance, method);
  }

  const TrackRule& rule_;
  const TrackOfTable& answered_;
  StaircaseTrack track_{};
  FindingList& findings_;
};

}  // namespace

std::vector<Finding> staircase_findings(const TidyInput& input) {
  const auto rules = rules_of(input.options);
  const std::vector<TrackOfTable> answered = answered_tracks(input.table(), rules);
  FindingList findings{};
  for (std::size_t track = 0; track < rules.size(); ++track) {
    TrackFindings(rules[track].second, answered[track], findings).add();
  }
  return findings.take();
}

}  // namespace asperity
