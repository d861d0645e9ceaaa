// Paired comparisons: each judgement prefers one of two items, or neither.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "analysis/choices/bradley_terry.h"
#include "analysis/choices/circular_triads.h"
#include "analysis/choices/comparison_graph.h"
#include "analysis/choices/thurstone.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/scale_findings.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

constexpr std::string_view kTie = "tie";

struct Paired {
  std::vector<std::string> items{};
  std::vector<std::string> participants{};
  std::vector<Comparison> comparisons{};
  Comparisons counts{};
  double confidence = 0.95;
};

Paired paired_in(const TidyInput& input) {
  const TidyTable& table = input.table();
  Paired read{.items = input.options.texts("items")};
  if (read.items.size() < 2) {
    throw std::runtime_error("the option \"items\" must name at least two items, not " +
                             std::to_string(read.items.size()) + "; add the others");
  }
  if (std::find(read.items.begin(), read.items.end(), kTie) != read.items.end()) {
    throw std::runtime_error(
        "the option \"items\" names \"tie\", but \"tie\" as a winner means that neither item won; "
        "give this item another name");
  }
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn first = table.labels("first", read.items);
  const LabelColumn second = table.labels("second", read.items);
  std::vector<std::string> outcomes = read.items;
  outcomes.emplace_back(kTie);
  const LabelColumn winner = table.labels("winner", outcomes);
  read.participants = participants.names;
  read.confidence = input.options.confidence();
  const std::vector<std::uint64_t> times =
      table.has("times") ? table.counts("times") : std::vector<std::uint64_t>(table.rows(), 1);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (winner.codes[row] == LabelColumn::kMissing) continue;
    Comparison one{.participant = participants.codes[row],
                   .first = first.codes[row],
                   .second = second.codes[row],
                   .times = times[row]};
    if (one.first == LabelColumn::kMissing || one.second == LabelColumn::kMissing ||
        one.first == one.second) {
      table.refuse(row, "second",
                   one.first == LabelColumn::kMissing || one.second == LabelColumn::kMissing
                       ? std::string("first or second is missing; enter both items")
                       : "first and second are both \"" + read.items[one.first] +
                             "\"; enter two different items");
    }
    if (winner.codes[row] < read.items.size()) {
      one.winner = winner.codes[row];
      if (*one.winner != one.first && *one.winner != one.second) {
        table.refuse(
            row, "winner",
            "winner is \"" + read.items[*one.winner] +
                "\", which is not one of the two items compared; it must be one of them or tie");
      }
    }
    read.comparisons.push_back(one);
  }
  read.counts = count_comparisons(read.comparisons, read.items.size());
  return read;
}

ScaleNames scale_names(const Paired& read, const std::string& value, const std::string& error,
                       const std::string& method) {
  return {.value = value,
          .error = error,
          .method = method,
          .n = read.participants.size(),
          .confidence = read.confidence};
}

void add_bradley_terry(const Paired& read, const BradleyTerry& fit, FindingList& findings) {
  const std::size_t n = read.participants.size();
  const auto items = static_cast<Eigen::Index>(read.items.size());
  const std::string method = "Bradley–Terry, ties left out";
  const auto number = [&](const char* quantity, const FindingKey& key, double value,
                          const std::string& how) {
    findings.number(quantity, key, value, {.n = n, .method = how});
  };
  const std::string from_first = method + ", relative to " + read.items.front();
  const std::string centred = method + ", mean 0";
  add_clustered_scale(read.items,
                      {.centred = fit.abilities.about_mean(), .errors = fit.centred_errors},
                      {.prefix = "bt",
                       .value = "bt.ability.sumzero.cluster",
                       .method = method,
                       .n = n,
                       .confidence = read.confidence},
                      findings);
  const Eigen::VectorXd worth = fit.abilities.worth();
  for (Eigen::Index i = 0; i < items; ++i) {
    number("bt.worth", read.items[static_cast<std::size_t>(i)], worth(i), method + ", sum 1");
  }
  add_cluster_errors(read.items, fit.clustered.about_mean(),
                     scale_names(read, "", "bt.se.sumzero.cluster", centred), findings);
  add_cluster_errors(read.items, fit.clustered, scale_names(read, "", "bt.se.cluster", from_first),
                     findings);
  ScaleNames about_mean = scale_names(read, "bt.ability.sumzero", "bt.se.sumzero", centred);
  about_mean.coverage = simulated_coverage({93, 99}, {81, 96});
  add_scale(read.items, fit.abilities.about_mean(), about_mean, findings);
  add_scale(read.items, fit.abilities, scale_names(read, "bt.ability", "bt.se", from_first),
            findings);
  const auto df = static_cast<double>(fit.df);
  number("bt.deviance", "", fit.deviance, method);
  number("bt.df", "", df, method);
  if (fit.df > 0) {
    number("bt.gof.p", "", *upper_tail(ChiSquaredStatistic{.value = fit.deviance, .df = df}),
           "deviance against a separate probability for each pair");
  }
  const double equal_df = static_cast<double>(items - 1);
  number("bt.lr.equal", "", fit.likelihood_ratio,
         "likelihood-ratio statistic against equal abilities");
  number("bt.lr.equal.p", "",
         *upper_tail(ChiSquaredStatistic{.value = fit.likelihood_ratio, .df = equal_df}),
         "likelihood-ratio test against equal abilities");
  for (Eigen::Index i = 0; i < items; ++i) {
    for (Eigen::Index j = i + 1; j < items; ++j) {
      if (read.counts.wins(i, j) + read.counts.wins(j, i) == 0.0) continue;
      const FindingKey key{read.items[static_cast<std::size_t>(i)],
                           read.items[static_cast<std::size_t>(j)]};
      const Eigen::MatrixXd& v = fit.abilities.covariance;
      const double difference = fit.abilities.value(i) - fit.abilities.value(j);
      number("bt.diff", key, difference, method);
      number("bt.diff.se", key, std::sqrt(v(i, i) + v(j, j) - 2.0 * v(i, j)), method);
      number("bt.pij", key, 1.0 / (1.0 + std::exp(-difference)), method);
    }
  }
  const std::string order = "order effect: advantage of the item presented first, in log odds";
  if (fit.order) {
    number("bt.order.beta", "first", fit.order->advantage, order);
    number("bt.order.se", "first", fit.order->standard_error, order);
    number("bt.order.lr", "first", fit.order->likelihood_ratio,
           "likelihood-ratio statistic against no order effect");
    number("bt.order.lr.p", "first",
           *upper_tail(ChiSquaredStatistic{.value = fit.order->likelihood_ratio, .df = 1.0}),
           "likelihood-ratio test against no order effect");
  } else {
    findings.word("bt.order.status", "first", "not_estimable",
                  "the order of presentation is confounded with the items, or determines the "
                  "winner completely: present each pair in both orders",
                  {.n = n, .method = order});
  }
}

void add_thurstone(const Paired& read, FindingList& findings) {
  const std::size_t n = read.participants.size();
  if (const auto fit = thurstone_likelihood(read.counts)) {
    add_scale(
        read.items, fit->abilities,
        scale_names(read, "thurstone.ml", "thurstone.ml.se",
                    "Thurstone Case V by maximum likelihood, relative to " + read.items.front()),
        findings);
    findings.number("thurstone.ml.deviance", "", fit->deviance,
                    {.n = n, .method = "Thurstone Case V by maximum likelihood"});
  }
  const auto fit = thurstone_least_squares(read.counts);
  if (!fit) return;
  const Basis basis{.n = n, .method = "Thurstone Case V by least squares, mean 0"};
  for (std::size_t i = 0; i < read.items.size(); ++i) {
    findings.number("thurstone.ls", read.items[i], fit->scale(static_cast<Eigen::Index>(i)), basis);
  }
  const Basis test{.n = n, .method = "Mosteller's test of fit"};
  findings.number("thurstone.mosteller.chisq", "", fit->chi_squared, test);
  findings.number("thurstone.mosteller.df", "", fit->df, test);
  if (fit->df > 0.0) {
    findings.number("thurstone.mosteller.p", "",
                    *upper_tail(ChiSquaredStatistic{.value = fit->chi_squared, .df = fit->df}),
                    test);
  }
  findings.count("thurstone.clipped.cells", "", fit->clipped,
                 {.n = n, .method = "pairs in which one item always won"});
}

void add_davidson(const Paired& read, FindingList& findings) {
  const auto fit = davidson(read.counts);
  if (!fit) return;
  const Basis basis{.n = read.participants.size(), .method = "Davidson's model with ties"};
  add_scale(read.items, fit->abilities,
            scale_names(read, "davidson.ability", "davidson.se",
                        basis.method + ", relative to " + read.items.front()),
            findings);
  findings.number("davidson.lognu", "", fit->log_tie, basis);
  findings.number("davidson.lognu.se", "", fit->log_tie_standard_error, basis);
  findings.number("davidson.deviance", "", fit->deviance, basis);
  findings.count("davidson.df", "", fit->df, basis);
}

constexpr const char* kModelFit = "model.fit";
/// The status of its p where `PairFit::is_approximately_chi_squared` is false.
constexpr const char* kExpectedCountsTooSmall =
    "expected counts too small: collect more comparisons of each pair";

/// Order effect, ties and fit together, from `paired_model`: `model.order` and `model.tie`; `model.order`, `model.equal`
/// and `model.fit` with their tests (`.lr`, `.df`, `.p`). `model.fit.p` has no value where expected counts are too small.
/// Without a finite estimate `model.status`.
void add_pair_model(const Paired& read, FindingList& findings) {
  const std::size_t items = read.items.size();
  std::size_t n = 0;  // judgements, which count as independent here
  for (const Comparison& one : read.comparisons) n += one.times;
  const bool has_ties = read.counts.ties.sum() > 0.0;
  const PairTerms without_order{.ties = has_ties};
  const PairAnswer plain = paired_model(read.comparisons, items, without_order);
  PairAnswer full = paired_model(read.comparisons, items, {.order = true, .ties = has_ties});
  const bool has_order = full.model.has_value();
  if (!has_order) full = plain;
  const std::string method = std::string("Bradley–Terry") +
                             (has_order ? " with order effect" : "") +
                             (has_ties ? (has_order ? " and ties" : " with ties") : "");
  if (!full.model) {
    findings.word("model.status", "", "not_estimable",
                  "some items always or never won, or were never compared with the others, so that "
                  "the scale has no finite estimate: collect more comparisons, or use bt.firth",
                  {.n = n, .method = method});
    return;
  }
  const double z = upper_normal_quantile(0.5 * (1.0 - read.confidence));
  const auto parameter = [&](const char* quantity, const LogParameter& one, const char* what) {
    findings.number(quantity, "", one.value,
                    {.n = n,
                     .method = method + ": " + what,
                     .interval = ConfidenceInterval{one.value - z * one.standard_error,
                                                    one.value + z * one.standard_error},
                     .confidence = read.confidence});
  };
  const auto test = [&](const std::string& quantity, double statistic, double df,
                        const char* against) {
    const Basis basis{.n = n, .method = method + ": " + against};
    findings.number(quantity + ".lr", "", statistic, basis);
    findings.number(quantity + ".df", "", df, basis);
    if (df > 0.0 && quantity == kModelFit && !full.model->fit.is_approximately_chi_squared()) {
      findings.word(quantity + ".p", "", "NA", kExpectedCountsTooSmall, basis);
    } else if (df > 0.0) {
      findings.number(quantity + ".p", "",
                      *upper_tail(ChiSquaredStatistic{.value = std::max(statistic, 0.0), .df = df}),
                      basis);
    }
  };
  const PairModel& model = *full.model;
  if (model.order) {
    parameter("model.order", *model.order, "advantage of the item presented first, in log odds");
    if (plain.model) {
      test("model.order", 2.0 * (model.log_likelihood - plain.model->log_likelihood), 1.0,
           "likelihood-ratio test against no order effect");
    }
  }
  if (model.tie) parameter("model.tie", *model.tie, "ln ν of ties");
  test("model.equal", model.equal_abilities, static_cast<double>(items - 1),
       "likelihood-ratio test against equal abilities");
  test(kModelFit, model.fit.deviance, static_cast<double>(model.fit.df),
       "deviance from the saturated model");
  const Basis fit{.n = n, .method = method + ": fit"};
  findings.number("model.fit.pearson", "", model.fit.pearson, fit);
  findings.number("model.fit.smallest_expected", "", model.fit.smallest_expected, fit);
  findings.number("model.fit.below_five", "", model.fit.below_five,
                  {.n = n, .method = method + ": proportion of expected counts below 5"});
  findings.truth(
      "model.fit.is_chi_squared", "", model.fit.is_approximately_chi_squared(),
      {.n = n,
       .method =
           "whether the χ² approximation holds: no expected count below 1, at most 20 % below 5"});
}

/// Participants who judged every pair once without a tie.
void add_consistency(const Paired& read, FindingList& findings) {
  const std::size_t items = read.items.size();
  if (items < 3) return;
  std::vector<std::vector<Comparison>> by_participant(read.participants.size());
  for (const Comparison& one : read.comparisons) by_participant[one.participant].push_back(one);
  for (std::size_t person = 0; person < by_participant.size(); ++person) {
    const WinsOfJudge wins = wins_of_judge(by_participant[person], items);
    if (wins.problem) continue;
    const Consistency own = consistency(wins.wins);
    const Basis basis{.n = 1, .method = "Kendall's circular triads"};
    findings.number("circular.triads", read.participants[person], own.circular_triads, basis);
    findings.number("zeta", read.participants[person], own.zeta, basis);
  }
}

}  // namespace

std::vector<Finding> paired_findings(const TidyInput& input) {
  const Paired read = paired_in(input);
  const std::size_t n = read.participants.size();
  FindingList findings{};
  const auto items = static_cast<Eigen::Index>(read.items.size());
  for (Eigen::Index i = 0; i < items; ++i) {
    for (Eigen::Index j = 0; j < items; ++j) {
      if (i == j) continue;
      findings.number(
          "wins",
          {read.items[static_cast<std::size_t>(i)], read.items[static_cast<std::size_t>(j)]},
          read.counts.wins(i, j), {.n = n, .method = "wins of the first over the second item"});
    }
  }
  findings.number("ties", "", read.counts.ties.sum() / 2.0, {.n = n});
  findings.truth("strongly.connected", "", strongly_connected(read.counts.wins),
                 {.n = n, .method = "whether chains of wins connect all items in both directions"});
  if (const auto fit = bradley_terry(read.comparisons, read.items.size())) {
    add_bradley_terry(read, *fit, findings);
  } else {
    findings.word("bt.status", "", "not_estimable",
                  "some items never lost to the others, or were never compared with them, so that "
                  "the scale has no finite estimate: collect more comparisons, or use bt.firth",
                  {.n = n, .method = "Bradley–Terry"});
  }
  if (const auto firth = firth_bradley_terry(read.counts)) {
    add_scale(
        read.items, *firth,
        scale_names(read, "bt.firth.ability", "bt.firth.se",
                    "Bradley–Terry with Firth's bias reduction, relative to " + read.items.front()),
        findings);
  } else {
    findings.word(
        "bt.firth.status", "", "not_estimable",
        "the comparisons do not connect all items, so that there is no common scale: compare "
        "each item with at least one of the others",
        {.n = n, .method = "Bradley–Terry with Firth's bias reduction"});
  }
  add_thurstone(read, findings);
  add_davidson(read, findings);
  add_pair_model(read, findings);
  add_consistency(read, findings);
  return findings.take();
}

}  // namespace asperity
