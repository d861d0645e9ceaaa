// Power of planned tests: one scenario per row.

#include "analysis/power/power.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

using NumbersByColumn = std::map<std::string, std::vector<std::optional<double>>>;

/// One row, with access to the columns that its kind requires.
class Scenario final {
 public:
  Scenario(const TidyTable& table, std::size_t row, NumbersByColumn& columns)
      : table_(table), row_(row), columns_(columns) {}

  double number(const char* column) const {
    auto found = columns_.find(column);
    if (found == columns_.end()) {
      found = columns_.emplace(column, table_.numbers(column)).first;
    }
    const std::optional<double> value = found->second[row_];
    if (!value)
      table_.refuse(
          row_, column,
          std::string(column) + " is missing; enter it, because this kind of plan requires it");
    return *value;
  }
  std::size_t whole(const char* column) const {
    const double value = number(column);
    constexpr double kMost = 1e6;
    if (value != std::round(value) || value < 0.0 || value > kMost) {
      table_.refuse(row_, column,
                    std::string(column) + " is " + number_text(value) +
                        "; it must be a whole number from 0 to 1000000");
    }
    return static_cast<std::size_t>(value);
  }
  /// Numbers separated by semicolons.
  std::vector<double> numbers(const char* column) const {
    std::vector<double> list{};
    const std::string text(table_.texts(column)[row_]);
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(';', begin), text.size());
      const TidyTable one("p\n" + text.substr(begin, end - begin) + '\n', table_.name());
      list.push_back(one.rows() == 1 ? one.all_numbers("p").front() : kUndefined);
      begin = end + 1;
    }
    return list;
  }
  [[noreturn]] void refuse(const std::string& sentence) const {
    table_.refuse(row_, "kind", sentence);
  }

 private:
  const TidyTable& table_;
  std::size_t row_ = 0;
  NumbersByColumn& columns_;  // read once, when a kind first requests them
};

class PowerList final {
 public:
  PowerList(std::string id, std::size_t n) : id_(std::move(id)), n_(n) {}

  void number(const char* quantity, double value, const std::string& method) {
    list_.number(quantity, id_, value, {.n = n_, .method = method});
  }
  void critical(const ExactPower& power) {
    const Basis basis{.n = n_,
                      .method = "smallest count at which the test rejects the null hypothesis"};
    if (power.critical) {
      list_.count("critical", id_, *power.critical, basis);
    } else {
      list_.word("critical", id_, "NA",
                 "this test can never reject the null hypothesis: plan more trials", basis);
    }
  }
  void exact(const ExactPower& power, const std::string& method) {
    number("alpha.actual", power.actual_error,
           "size: probability that the test rejects a true null hypothesis");
    number("power", power.power, method);
  }
  std::vector<Finding> take() { return list_.take(); }

 private:
  std::string id_{};
  std::size_t n_ = 0;
  FindingList list_{};
};

void uniform(const Scenario& plan, double error, PowerList& list) {
  const UniformPower power =
      uniform_power({.choices = plan.whole("n"), .truth = plan.numbers("probs"), .error = error});
  list.number("alpha.actual", power.actual_error,
              "size: probability that the χ² test rejects a true null hypothesis");
  list.number("power", power.power, "exact power of Pearson's X² against equal proportions");
  list.number("power.noncentral", power.noncentral_power, "from the noncentral χ² distribution");
}

void within(const Scenario& plan, double error, PowerList& list) {
  const WithinPower power = within_power({.participants = plan.whole("n"),
                                          .levels = plan.whole("k"),
                                          .f = plan.number("f"),
                                          .correlation = plan.number("rho"),
                                          .epsilon = plan.number("eps"),
                                          .error = error});
  list.number("lambda", power.noncentrality, "f²·n·K·ε/(1 − ρ)");
  list.number("power", power.power,
              "repeated-measures ANOVA of one factor, noncentral F distribution");
}

void forced_choice(const Scenario& plan, double error, PowerList& list) {
  const ForcedChoice choice{.alternatives = plan.whole("k")};
  const double share = choice.share(plan.number("d"));
  list.number("pc", share, "proportion correct at this d′");
  const double chance = 1.0 / static_cast<double>(choice.alternatives);
  list.number(
      "power",
      binomial_power({.trials = plan.whole("n"), .chance = chance, .truth = share, .error = error})
          .power,
      "exact binomial test, one-sided against 1/m");
}

void pooled(const Scenario& plan, double error, PowerList& list) {
  const PooledRejection rejection = pooled_rejection({.participants = plan.whole("n"),
                                                      .trials_each = plan.whole("k"),
                                                      .chance = plan.number("p0"),
                                                      .truth = plan.number("p1"),
                                                      .correlation = plan.number("rho"),
                                                      .error = error});
  list.number("reject.rate", rejection.rate,
              "pooled binomial test of participants whose proportions are beta-distributed");
  list.number("deff", rejection.design_effect, "1 + (m − 1)·ρ");
}

void plan_findings(const Scenario& plan, const std::string& kind, PowerList& list) {
  const double error = plan.number("alpha");
  const auto binomial = [&] {
    return BinomialPlan{.trials = plan.whole("n"),
                        .chance = plan.number("p0"),
                        .truth = plan.number("p1"),
                        .error = error};
  };
  const auto matching = [&] {
    return MatchingPlan{.assignments = plan.whole("n"), .items = plan.whole("k"), .error = error};
  };
  if (kind == "binom_greater") {
    const ExactPower power = binomial_power(binomial());
    list.critical(power);
    list.exact(power, "exact binomial test, one-sided");
  } else if (kind == "binom_two") {
    list.exact(binomial_two_sided_power(binomial()), "exact binomial test, two-sided");
  } else if (kind == "chisq_uniform_exact") {
    uniform(plan, error, list);
  } else if (kind == "matching_mallows") {
    const MatchingPower power = mallows_power(matching(), plan.number("theta"));
    list.critical(power.exact);
    list.exact(power.exact, "exact; permutations from Mallows' model");
    list.number("mean.correct", power.mean_right, "correctly matched items of one assignment");
  } else if (kind == "matching_known") {
    list.number(
        "power",
        known_items_power(matching(), static_cast<std::size_t>(std::llround(plan.number("d"))))
            .exact.power,
        "exact; some items known, the others assigned at random");
  } else if (kind == "paired_t") {
    list.number("power",
                paired_t_power({.pairs = plan.whole("n"), .d = plan.number("d"), .error = error}),
                "two-sided paired t test, noncentral t distribution");
  } else if (kind == "rm_anova") {
    within(plan, error, list);
  } else if (kind == "fisher_two") {
    list.exact(fisher_power({.first_trials = plan.whole("n"),
                             .second_trials = plan.whole("k"),
                             .first_truth = plan.number("p0"),
                             .second_truth = plan.number("p1"),
                             .error = error}),
               "Fisher's exact test, two-sided");
  } else if (kind == "mafc_dprime") {
    forced_choice(plan, error, list);
  } else if (kind == "betabinom_pool") {
    pooled(plan, error, list);
  } else {
    plan.refuse("the kind of plan \"" + kind +
                "\" is unknown; it must be one of binom_greater, binom_two, chisq_uniform_exact, "
                "matching_mallows, matching_known, paired_t, rm_anova, fisher_two, mafc_dprime, "
                "betabinom_pool");
  }
}

}  // namespace

std::vector<Finding> power_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  refuse_repeated(table, "id", "one row per plan");
  const std::vector<std::string_view> ids = table.texts("id");
  const std::vector<std::string_view> kinds = table.texts("kind");
  NumbersByColumn columns{};
  std::vector<Finding> findings{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Scenario plan(table, row, columns);
    PowerList list(std::string(ids[row]), plan.whole("n"));
    try {
      plan_findings(plan, std::string(kinds[row]), list);
    } catch (const std::invalid_argument& error) {
      plan.refuse(error.what());
    }
    for (Finding& finding : list.take()) findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace asperity
