// Proportions of right answers, choices of the best, groups.

#include <array>
#include <cmath>
#include <numeric>

#include "analysis/choices/forced_choice.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

constexpr std::array kSpreads{0.0, 1.0};

// --- recognition: one of four pictures -----------------------------------------------------------

constexpr std::array<std::string_view, 4> kPictures{"a", "b", "c", "d"};
constexpr double kChance = 0.25;
constexpr std::array kProportions{0.05, 0.25, 0.5, 0.71, 0.87, 0.95, 0.98};

/// A participant's own probability of a right answer: its logit is normal.
double own_probability(const CoverageSetting& setting, double mu, Random& random) {
  return 1.0 / (1.0 + std::exp(-(mu + setting.spread * random.normal())));
}

TidyInput draw_recognition(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,stimulus,response");
  const double mu = mu_of_mean(setting.effect, setting.spread);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const std::string subject = participant_label(i);
    const double p = own_probability(setting, mu, random);
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t shown = (trial + i) % kPictures.size();
      std::size_t said = shown;
      if (random.uniform() >= p) {
        said = (shown + 1 + random.below(kPictures.size() - 1)) % kPictures.size();
      }
      table.add({subject, kPictures[shown], kPictures[said]});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("labels", "a,b,c,d");
  return input;
}

std::vector<CheckedInterval> recognition_intervals(const CoverageSetting& setting) {
  const double p = setting.effect;
  return {{.quantity = "subj.mean", .truth = p},
          {.quantity = "pc", .truth = p, .lower = "pc.wilson.lower", .upper = "pc.wilson.upper"},
          {.quantity = "dprime",
           .truth = ForcedChoice{.alternatives = kPictures.size()}.dprime(p),
           .lower = "dprime.lower",
           .upper = "dprime.upper"}};
}

std::vector<CheckedTest> recognition_tests(const CoverageSetting& setting) {
  if (setting.effect != kChance || setting.spread > 0.0) return {};
  return {{.quantity = "subj.t.p.two"},
          {.quantity = "pc.p.greater"},
          {.quantity = "G.p"},
          {.quantity = "G.perm.p"}};
}

// --- selection: the best of three --------------------------------------------------------------------

constexpr std::array<std::string_view, 3> kModels{"A", "B", "C"};
constexpr std::array kAdvantages{-2.0, 0.0, 1.0, 2.5, 4.0};

/// Of A, B and C.
ThreeItems mean_utilities(const CoverageSetting& setting) { return {setting.effect, 0.0, 0.0}; }

TidyInput draw_selection(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,sample,choice");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const ThreeItems weights = own_weights(mean_utilities(setting), setting.spread, random);
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      table.add({participant_label(i), "s", kModels[drawn_by_weight(weights, random)]});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("renderers", "A,B,C");
  input.options.add("target", "A");
  return input;
}

std::vector<CheckedInterval> selection_intervals(const CoverageSetting& setting) {
  const ThreeItems chosen = mean_choices(mean_utilities(setting), setting.spread);
  return {{.quantity = "subj.mean", .key = "A", .truth = chosen[0]}};
}

std::vector<CheckedTest> selection_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "relabel.exact.p"},
          {.quantity = "signflip.p.two", .key = "A|B"},
          {.quantity = "subj.t.p.two", .key = "A"}};
}

/// What the counts of a participant are like.
struct MomentsOfCounts {
  double difference = 0.0;  ///< mean of the count of A minus that of B
  double square = 0.0;      ///< mean of its square
  ThreeItems ranks{};  ///< means of the counts' ranks about the middle, equal counts in the middle
  double rank_squares = 0.0;
};

/// By all counts that a participant can have, and a grid of utilities.
MomentsOfCounts moments_of_counts(const CoverageSetting& setting) {
  MomentsOfCounts sum{};
  double all = 0.0;
  const int steps = setting.spread > 0.0 ? 30 : 0;
  constexpr double kFurthest = 5.0;
  const auto place = [steps](int i) {
    return steps == 0 ? 0.0 : kFurthest * (2.0 * i / steps - 1.0);
  };
  const auto above = [](int count, int other) {
    return count > other ? 0.5 : count < other ? -0.5 : 0.0;
  };
  const auto trials = static_cast<int>(setting.trials);
  const ThreeItems means = mean_utilities(setting);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k <= steps; ++k) {
        const ThreeItems z{place(i), place(j), place(k)};
        ThreeItems own{};
        for (std::size_t item = 0; item < own.size(); ++item) {
          own[item] = std::exp(means[item] + setting.spread * z[item]);
        }
        const double total = own[0] + own[1] + own[2];
        const double density = std::exp(-0.5 * (z[0] * z[0] + z[1] * z[1] + z[2] * z[2]));
        all += density;
        double of_a = density * std::pow(own[2] / total, trials);  // of a times A, the rest C
        for (int a = 0; a <= trials; ++a) {
          double weight = of_a;
          for (int b = 0; a + b <= trials; ++b) {
            const int c = trials - a - b;
            const ThreeItems ranks{above(a, b) + above(a, c), above(b, a) + above(b, c),
                                   above(c, a) + above(c, b)};
            sum.difference += weight * (a - b);
            sum.square += weight * (a - b) * (a - b);
            for (std::size_t item = 0; item < ranks.size(); ++item) {
              sum.ranks[item] += weight * ranks[item];
              sum.rank_squares += weight * ranks[item] * ranks[item];
            }
            weight *= own[1] / own[2] * c / (b + 1.0);
          }
          of_a *= own[0] / own[2] * (trials - a) / (a + 1.0);
        }
      }
    }
  }
  sum.difference /= all;
  sum.square /= all;
  sum.rank_squares /= all;
  for (double& rank : sum.ranks) rank /= all;
  return sum;
}

/// W of n participants whose mean rank correlation is that of two participants' expected ranks.
std::vector<CheckedInterval> choice_effect_intervals(const CoverageSetting& setting) {
  const MomentsOfCounts moments = moments_of_counts(setting);
  double of_means = 0.0;
  for (const double rank : moments.ranks) of_means += rank * rank;
  const auto n = static_cast<double>(setting.participants);
  const double variance = moments.square - moments.difference * moments.difference;
  return {
      {.quantity = "relabel.W", .truth = (1.0 + (n - 1.0) * of_means / moments.rank_squares) / n},
      {.quantity = "signflip.d", .key = "A|B", .truth = moments.difference / std::sqrt(variance)}};
}

// --- two groups ------------------------------------------------------------------------------------

TidyInput draw_groups(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,group,correct,trials");
  const double mu = mu_of_mean(setting.effect, setting.spread);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double p = own_probability(setting, mu, random);
    std::size_t correct = 0;
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      correct += random.uniform() < p ? 1 : 0;
    }
    table.add({participant_label(i), i % 2 == 0 ? "F" : "M", std::to_string(correct),
               std::to_string(setting.trials)});
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("groups", "F,M");
  return input;
}

std::vector<CheckedInterval> group_intervals(const CoverageSetting& setting) {
  return {{.quantity = "subj.mean", .key = "F", .truth = setting.effect},
          {.quantity = "subj.diff", .truth = 0.0}};
}

std::vector<CheckedTest> group_tests(const CoverageSetting&) {
  return {{.quantity = "perm.p.two"},
          {.quantity = "welch.p.two"},
          {.quantity = "mannwhitney.exact.p.two"},
          {.quantity = "mixed.lr.group.p"},
          {.quantity = "mixed.lr.group.F.p"}};
}

}  // namespace

std::span<const CoveragePart> choice_parts() {
  static const auto kOfProportions = all_designs(kProportions, kSpreads);
  static const auto kOfAdvantages = all_designs(kAdvantages, kSpreads);
  static const std::array kParts{
      CoveragePart{.name = "recognition",
                   .model = "one of four pictures; a participant's logit of a correct response is "
                            "normal, incorrect responses are equally likely",
                   .effect = "mean proportion correct",
                   .spread = "SD of the logits",
                   .settings = kOfProportions,
                   .draw = draw_recognition,
                   .findings = recognition_findings,
                   .intervals = recognition_intervals,
                   .tests = recognition_tests},
      CoveragePart{.name = "selection",
                   .model = "the best of three; a participant's utilities are normal, and the "
                            "choice follows Luce's rule",
                   .effect = "mean utility of the target minus that of the others",
                   .spread = "SD of the utilities",
                   .settings = kOfAdvantages,
                   .draw = draw_selection,
                   .findings = selection_findings,
                   .intervals = selection_intervals,
                   .tests = selection_tests},
      CoveragePart{.name = "choice_effects",
                   .model = "choices as in `selection`; the effect sizes of its tests",
                   .effect = "mean utility of the target minus that of the others",
                   .spread = "SD of the utilities",
                   .settings = kOfAdvantages,
                   .draw = draw_selection,
                   .findings = selection_findings,
                   .intervals = choice_effect_intervals,
                   .tests = no_tests,
                   .tables = 2000},
      CoveragePart{.name = "groups",
                   .model = "two identical groups of half the participants each; a participant's "
                            "logit of a correct response is normal",
                   .effect = "mean proportion correct in both groups",
                   .spread = "SD of the logits",
                   .settings = kOfProportions,
                   .draw = draw_groups,
                   .findings = group_findings,
                   .intervals = group_intervals,
                   .tests = group_tests}};
  return kParts;
}

}  // namespace asperity
