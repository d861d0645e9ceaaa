// The printed margins of a study with three experiments: the choices among renderings, and the
// numbers of correct matchings and recognitions, by sex. Reports the results that the margins
// determine, and bounds for those that they do not.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/choices/decisive_choices.h"
#include "analysis/choices/equal_error_information.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/choices/matching_null.h"
#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/proportion.h"
#include "analysis/tests/cochran.h"
#include "analysis/tests/contingency.h"
#include "analysis/tests/pooled_share.h"
#include "analysis/tests/two_by_two.h"
#include "analysis/tests/uniform_counts.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

constexpr const char* kPooled = "POOLED";
constexpr const char* kTarget = "image";
constexpr double kConfidence = 0.95;
constexpr std::size_t kTextures = 4;               ///< in the matching experiment
constexpr std::uint64_t kMostChoices = 1'000'000;  ///< in a cell; each becomes a row
constexpr std::size_t kPictures = 6;               ///< in the recognition experiment

/// A proportion with both intervals, named as in a table.
void add_share(const std::string& table, const FindingKey& key, const HitCount& count,
               FindingList& findings) {
  const ConfidenceInterval wilson = wilson_interval(count, kConfidence);
  const ConfidenceInterval cp = clopper_pearson_interval(count, kConfidence);
  const auto n = static_cast<std::size_t>(count.trials);
  findings.number(
      table + ".prop", key, proportion(count),
      {.n = n, .method = "Wilson interval", .interval = wilson, .confidence = kConfidence});
  const Basis of_wilson{.n = n, .method = "Wilson interval"};
  const Basis of_cp{.n = n, .method = "Clopper–Pearson interval"};
  findings.number(table + ".wilson.lower", key, wilson.low, of_wilson);
  findings.number(table + ".wilson.upper", key, wilson.high, of_wilson);
  findings.number(table + ".cp.lower", key, cp.low, of_cp);
  findings.number(table + ".cp.upper", key, cp.high, of_cp);
}

/// Table 1: renderings in rows, experiments in columns.
struct ChoiceTable {
  std::vector<std::string> renderers{};
  std::vector<std::string> experiments{};
  CountMatrix counts{};
  Eigen::Index target = 0;
};

ChoiceTable choice_table(const TidyTable& table) {
  const LabelColumn experiments = table.all_labels("exp");
  const LabelColumn renderers = table.all_labels("renderer");
  const std::vector<std::uint64_t> counts = table.counts("count", kMostChoices);
  ChoiceTable read{.renderers = renderers.names, .experiments = experiments.names};
  read.counts = CountMatrix::Zero(static_cast<Eigen::Index>(renderers.names.size()),
                                  static_cast<Eigen::Index>(experiments.names.size()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    read.counts(static_cast<Eigen::Index>(renderers.codes[row]),
                static_cast<Eigen::Index>(experiments.codes[row])) +=
        static_cast<std::int64_t>(counts[row]);
  }
  const auto target = std::find(read.renderers.begin(), read.renderers.end(), kTarget);
  if (target == read.renderers.end() || read.renderers.size() < 2) {
    throw std::runtime_error(table.name() + " lacks the renderer \"" + kTarget +
                             "\" or another one; add the rows of both");
  }
  read.target = target - read.renderers.begin();
  return read;
}

void add_choices(const ChoiceTable& table, const std::string& block,
                 const Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1>& column,
                 FindingList& findings) {
  const std::vector<std::uint64_t> counts(column.begin(), column.end());
  const auto n = static_cast<std::uint64_t>(column.sum());
  const std::size_t renderers = counts.size();
  for (std::size_t j = 0; j < renderers; ++j) {
    const FindingKey key{block, table.renderers[j]};
    findings.count("t1.count", key, counts[j], {.n = n});
    if (n > 0) add_share("t1", key, {.hits = counts[j], .trials = n}, findings);
  }
  const UniformTest uniform = uniform_test(counts);
  const Basis pearson{.n = n, .method = "Pearson's X² against equal proportions"};
  findings.number("t1.chisq", block, uniform.pearson, pearson);
  findings.number("t1.chisq.p", block, uniform.pearson_p, pearson);
  if (block != kPooled) {
    const MultinomialTest exact = uniform_multinomial_test(counts);
    findings.number("t1.multinom.exact.p", block, exact.by_probability,
                    {.n = n, .method = "exact multinomial test, outcomes ordered by probability"});
    findings.number("t1.multinom.chisqorder.p", block, exact.by_chi_squared,
                    {.n = n, .method = "exact multinomial test, outcomes ordered by Pearson's X²"});
  }
  if (n > 0) {
    findings.number(
        "t1.image.p.greater", block,
        binomial_upper_tail({.hits = counts[static_cast<std::size_t>(table.target)], .trials = n},
                            1.0 / static_cast<double>(renderers)),
        {.n = n,
         .method = "exact binomial test, one-sided against 1/" + std::to_string(renderers)});
  }
  for (std::size_t a = 0; a < renderers; ++a) {
    for (std::size_t b = a + 1; b < renderers; ++b) {
      findings.number("t1.pair.p.two", {block, table.renderers[a], table.renderers[b]},
                      mcnemar_test({.only_first = counts[a], .only_second = counts[b]}),
                      {.n = static_cast<std::size_t>(counts[a] + counts[b]),
                       .method = "exact binomial test, two-sided, choices treated as independent"});
    }
  }
}

/// The results if each participant's choices were as consistent as the margins allow: participants
/// in a row, first those who choose the first rendering in every experiment.
void add_most_consistent(const ChoiceTable& table, FindingList& findings) {
  const Eigen::RowVectorX<std::int64_t> totals = table.counts.colwise().sum();
  if (totals.size() == 0 || totals.minCoeff() != totals.maxCoeff() || totals(0) == 0) return;
  CountMatrix choices = CountMatrix::Zero(totals(0), table.counts.rows());
  for (Eigen::Index experiment = 0; experiment < table.counts.cols(); ++experiment) {
    Eigen::Index participant = 0;
    for (Eigen::Index renderer = 0; renderer < table.counts.rows(); ++renderer) {
      for (std::int64_t i = 0; i < table.counts(renderer, experiment); ++i) {
        ++choices(participant++, renderer);
      }
    }
  }
  const auto n = static_cast<std::size_t>(totals(0));
  const std::string consistent = " if participants were as consistent as the margins allow";
  for (Eigen::Index other = 0; other < choices.cols(); ++other) {
    if (other == table.target) continue;
    std::vector<std::int64_t> differences{};
    for (Eigen::Index row = 0; row < choices.rows(); ++row) {
      differences.push_back(choices(row, table.target) - choices(row, other));
    }
    const SignFlipTest flips = sign_flip_test(differences);
    findings.number(
        std::string("t1.nested.signflip.") + kTarget + '.' +
            table.renderers[static_cast<std::size_t>(other)],
        "", flips.two_sided,
        {.n = n, .method = "sign-flip test, " + way_of_counting(flips.drawn) + ',' + consistent});
  }
  const RelabellingTest relabelling = relabelling_test(choices);
  findings.number("t1.nested.relabel.p", "", relabelling.p,
                  {.n = n,
                   .method = "within-participant permutation test, " +
                             way_of_counting(relabelling.drawn) + ',' + consistent});
  std::vector<HitCount> own{};
  for (Eigen::Index row = 0; row < choices.rows(); ++row) {
    own.push_back({.hits = static_cast<std::uint64_t>(choices(row, table.target)),
                   .trials = static_cast<std::uint64_t>(choices.cols())});
  }
  findings.number(std::string("t1.nested.deff.") + kTarget, "", pooled_share(own).design_effect,
                  {.n = n, .method = "design effect" + consistent});
}

void add_table_1(const ChoiceTable& table, FindingList& findings) {
  for (Eigen::Index experiment = 0; experiment < table.counts.cols(); ++experiment) {
    add_choices(table, table.experiments[static_cast<std::size_t>(experiment)],
                table.counts.col(experiment), findings);
  }
  const Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1> pooled = table.counts.rowwise().sum();
  add_choices(table, kPooled, pooled, findings);
  const auto n = static_cast<std::size_t>(pooled.sum());
  findings.number(
      "t1.homogeneity.fisher.p", "",
      exact_independence_test(table.counts).value_or(std::numeric_limits<double>::quiet_NaN()),
      {.n = n, .method = "Freeman–Halton exact test, experiments treated as independent"});
  add_most_consistent(table, findings);
  // The rendering with the count closest to the target's.
  Eigen::Index rival = table.target == 0 ? 1 : 0;
  for (Eigen::Index other = 0; other < pooled.size(); ++other) {
    if (other != table.target && pooled(other) > pooled(rival)) rival = other;
  }
  const auto decisive = static_cast<double>(pooled(table.target) + pooled(rival));
  const double preference = static_cast<double>(pooled(table.target)) / decisive;
  if (!(preference > 0.5 && preference < 1.0)) return;
  const auto needed =
      decisive_choices({.preference = preference, .error = 0.05, .power = 0.8, .least = 20});
  findings.number(
      "t1.n.decisive.for80", {kTarget, table.renderers[static_cast<std::size_t>(rival)]},
      needed ? static_cast<double>(*needed) : std::numeric_limits<double>::infinity(),
      {.n = n,
       .method = "number of independent choices of either renderer with which the two-sided "
                 "exact test has a power of 80 % at the observed preference"});
}

/// Tables 2 and 3: correct responses by experiment and sex.
struct RightAnswers {
  std::vector<std::string> experiments{};
  std::map<std::pair<std::string, std::string>, HitCount> of{};  ///< (experiment, sex)

  /// The count of one experiment or all, of one sex or both, where the name is empty.
  HitCount count(const std::string& experiment, const std::string& sex) const {
    HitCount sum{};
    for (const auto& [name, own] : of) {
      if (experiment != kPooled && name.first != experiment) continue;
      if (!sex.empty() && name.second != sex) continue;
      sum.hits += own.hits;
      sum.trials += own.trials;
    }
    return sum;
  }
};

RightAnswers read_right_answers(const TidyTable& table) {
  const LabelColumn experiments = table.all_labels("exp");
  const LabelColumn sexes = table.all_labels("sex");
  const std::vector<std::uint64_t> correct = table.counts("correct", kMostChoices);
  const std::vector<std::uint64_t> n = table.counts("n", kMostChoices);
  RightAnswers read{.experiments = experiments.names};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (correct[row] > n[row]) {
      table.refuse(row, "correct",
                   "correct is " + std::to_string(correct[row]) + " and n is " +
                       std::to_string(n[row]) + "; correct must be at most n");
    }
    HitCount& own =
        read.of[{experiments.names[experiments.codes[row]], sexes.names[sexes.codes[row]]}];
    own.hits += correct[row];
    own.trials += n[row];
  }
  return read;
}

struct Chance {
  const char* name = "";
  double value = 0.0;
};

void add_right_answers(const std::string& table, const RightAnswers& right,
                       const std::vector<Chance>& chances, FindingList& findings) {
  std::vector<std::string> blocks = right.experiments;
  blocks.emplace_back(kPooled);
  for (const std::string& block : blocks) {
    const HitCount all = right.count(block, "");
    const auto n = static_cast<std::size_t>(all.trials);
    findings.count(table + ".k", block, all.hits, {.n = n});
    findings.count(table + ".n", block, all.trials, {.n = n});
    if (n == 0) continue;
    add_share(table, block, all, findings);
    for (const Chance& chance : chances) {
      findings.number(table + ".p.greater", {block, std::string("chance=") + chance.name},
                      binomial_upper_tail(all, chance.value),
                      {.n = n, .method = "exact binomial test, one-sided"});
    }
    const TwoByTwo sexes{.first = right.count(block, "F"), .second = right.count(block, "M")};
    if (sexes.first.trials == 0 || sexes.second.trials == 0) continue;
    const ShareDifference difference = newcombe_difference(sexes, kConfidence);
    findings.number(table + ".sex.fisher.p", block, fisher_test(sexes, kConfidence).p_two_sided,
                    {.n = n, .method = "Fisher's exact test, two-sided"});
    findings.number(table + ".sex.diff", block, difference.difference,
                    {.n = n,
                     .method = "difference (F − M); Newcombe interval",
                     .interval = difference.interval,
                     .confidence = kConfidence});
    const Basis newcombe{.n = n, .method = "Newcombe interval"};
    findings.number(table + ".sex.newcombe.lower", block, difference.interval.low, newcombe);
    findings.number(table + ".sex.newcombe.upper", block, difference.interval.high, newcombe);
  }
}

void add_recognition(const RightAnswers& right, FindingList& findings) {
  const ForcedChoice choice{.alternatives = kPictures};
  std::vector<std::string> blocks = right.experiments;
  blocks.emplace_back(kPooled);
  for (const std::string& block : blocks) {
    const HitCount all = right.count(block, "");
    if (all.trials == 0) continue;
    const ConfidenceInterval wilson = wilson_interval(all, kConfidence);
    const auto add = [&](const std::string& quantity, const auto& at, const std::string& method,
                         const std::string& unit) {
      const ConfidenceInterval interval{.low = at(wilson.low), .high = at(wilson.high)};
      const auto n = static_cast<std::size_t>(all.trials);
      const Basis basis{.n = n, .method = method, .unit = unit};
      findings.number(quantity, block, at(proportion(all)),
                      {.n = n,
                       .method = method,
                       .unit = unit,
                       .interval = interval,
                       .confidence = kConfidence});
      findings.number(quantity + ".lower", block, interval.low, basis);
      findings.number(quantity + ".upper", block, interval.high, basis);
    };
    add(
        "t3.dprime" + std::to_string(kPictures), [&](double p) { return choice.dprime(p); },
        "d′ of equally confusable alternatives; limits from the Wilson limits", "1");
    add(
        "t3.IT.equalerrors", [&](double p) { return equal_error_bits(p, kPictures); },
        "equal-error (Fano) estimate of the transmitted information", "bit");
  }
}

void add_matching_against_recognition(const RightAnswers& matching, const RightAnswers& recognition,
                                      FindingList& findings) {
  std::vector<std::string> blocks = matching.experiments;
  blocks.emplace_back(kPooled);
  for (const std::string& block : blocks) {
    const HitCount first = matching.count(block, "");
    const HitCount second = recognition.count(block, "");
    if (first.trials == 0 || first.trials != second.trials) continue;
    const auto n = static_cast<std::size_t>(first.trials);
    const ConfidenceInterval bounds =
        mcnemar_bounds({.first = first.hits, .second = second.hits, .participants = first.trials});
    const std::string method = "exact McNemar test over all tables with these margins";
    findings.number("t2t3.mcnemar.p.min", block, bounds.low, {.n = n, .method = method});
    findings.number("t2t3.mcnemar.p.max", block, bounds.high, {.n = n, .method = method});
    findings.number("t2t3.fisher.p", block,
                    fisher_test({.first = first, .second = second}, kConfidence).p_two_sided,
                    {.n = n, .method = "Fisher's exact test, tables treated as independent"});
  }
}

}  // namespace

std::vector<Finding> seedpaper_findings(const TidyInput& input) {
  FindingList findings{};
  input.table(2);  // checks that all three exist before reading
  add_table_1(choice_table(input.table(0)), findings);
  const RightAnswers matching = read_right_answers(input.table(1));
  const RightAnswers recognition = read_right_answers(input.table(2));
  add_right_answers("t2", matching,
                    {{"all4", whole_chance(kTextures)}, {"one", item_chance(kTextures)}}, findings);
  add_right_answers("t3", recognition, {{"one", 1.0 / kPictures}}, findings);
  add_recognition(recognition, findings);
  add_matching_against_recognition(matching, recognition, findings);
  return findings.take();
}

}  // namespace asperity
