// Proportion correct with participants and items as crossed random intercepts.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/models/crossed_binomial.h"
#include "analysis/models/linear_mixed.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// A fixed effect: its columns of the design and their keys. A factor has treatment contrasts, a column for each level but
/// the first; a covariate has one column.
struct FixedEffect {
  std::string name{};
  std::vector<FindingKey> keys{};
  std::vector<std::string> levels{};  ///< of a factor; the first has no column
  Eigen::Index first_column = 1;

  Eigen::Index columns() const { return static_cast<Eigen::Index>(keys.size()); }
};

struct CrossedTable {
  std::vector<CrossedHits> responses{};
  CrossedModel model{};
  std::vector<FixedEffect> effects{};
  std::size_t participants = 0;
  std::size_t items = 0;
  bool participants_are_sampled = true;  ///< to generalise to others
  bool items_are_sampled = true;
};

BinomialLink link_of(const FamilyOptions& options) {
  const std::string link = options.text_or("link", "logit");
  if (link == "logit") return BinomialLink::logit;
  if (link == "probit") return BinomialLink::probit;
  throw std::runtime_error("the option \"link\" is \"" + link + "\"; it must be logit or probit");
}

void read_random(const FamilyOptions& options, CrossedModel& model) {
  if (!options.has("random")) return;
  const std::vector<std::string> random = options.texts("random");
  for (const std::string& one : random) {
    if (one == "subject" || one == "item") continue;
    throw std::runtime_error("the option \"random\" names \"" + one +
                             "\"; it must be subject, item, or both");
  }
  const auto has = [&random](const char* name) {
    return std::find(random.begin(), random.end(), name) != random.end();
  };
  model.participants_vary = has("subject");
  model.items_vary = has("item");
  if (random.empty()) {
    throw std::runtime_error("the option \"random\" is empty; it must be subject, item, or both");
  }
}

/// The factors to whose other levels the intercept generalises: those with random intercepts, or those of the option.
void read_sampled(const FamilyOptions& options, CrossedTable& read) {
  read.participants_are_sampled = read.model.participants_vary;
  read.items_are_sampled = read.model.items_vary;
  if (!options.has("sampled")) return;
  for (const std::string& one : options.texts("sampled")) {
    if (one != "subject" && one != "item") {
      throw std::runtime_error("the option \"sampled\" names \"" + one +
                               "\"; it must be subject, item, or both");
    }
    (one == "subject" ? read.participants_are_sampled : read.items_are_sampled) = true;
  }
}

MarginalLikelihood likelihood_of(const FamilyOptions& options, const CrossedModel& model) {
  const std::string likelihood = options.text_or("likelihood", "laplace");
  if (likelihood == "laplace") return MarginalLikelihood::laplace;
  if (likelihood != "quadrature") {
    throw std::runtime_error("the option \"likelihood\" is \"" + likelihood +
                             "\"; it must be laplace or quadrature");
  }
  if (model.participants_vary && model.items_vary) {
    throw std::runtime_error(
        "the option \"likelihood\" is quadrature, which requires that \"random\" names one of "
        "subject and item");
  }
  return MarginalLikelihood::quadrature;
}

/// Counts of a row. Throws for counts that are not of trials.
HitCount counted_responses(const TidyTable& table, std::size_t row, std::uint64_t hits,
                           std::uint64_t trials) {
  if (trials == 0 || hits > trials) {
    table.refuse(row, "correct",
                 "correct is " + std::to_string(hits) + " and trials is " + std::to_string(trials) +
                     "; trials must be at least 1, and correct at most trials: correct the counts, "
                     "or leave out rows without trials");
  }
  return {.hits = hits, .trials = trials};
}

/// Collects the columns of the design.
class EffectsDesign final {
 public:
  explicit EffectsDesign(const TidyTable& table)
      : table_(table), columns_{Eigen::VectorXd::Ones(static_cast<Eigen::Index>(table.rows()))} {}

  void add_factor(const std::string& name, const std::vector<std::string>& levels) {
    if (levels.size() < 2) {
      throw std::runtime_error("the option \"fixed\" names one level of " + name +
                               "; name at least two levels of each factor");
    }
    const LabelColumn codes = table_.labels(name, levels);
    std::vector<FindingKey> keys{};
    for (std::size_t level = 1; level < levels.size(); ++level) {
      keys.push_back({name, levels[level]});
    }
    begin(name, std::move(keys));
    effects_.back().levels = levels;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const std::size_t level = codes.codes[row];
      if (level == LabelColumn::kMissing) {
        table_.refuse(row, name, "the level of " + name + " is missing; enter it");
      }
      if (level > 0) value(row, level - 1) = 1.0;
    }
  }

  void add_covariate(const std::string& name) {
    const std::vector<std::optional<double>> numbers = table_.numbers(name);
    begin(name, {name});
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (!numbers[row])
        table_.refuse(row, name, name + " is missing; enter it, or remove the row");
      value(row, 0) = *numbers[row];
    }
  }

  const std::vector<FixedEffect>& effects() const { return effects_; }

  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd made(columns_.front().size(), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      made.col(static_cast<Eigen::Index>(i)) = columns_[i];
    }
    return made;
  }

 private:
  void begin(const std::string& name, std::vector<FindingKey> keys) {
    effects_.push_back({.name = name,
                        .keys = std::move(keys),
                        .first_column = static_cast<Eigen::Index>(columns_.size())});
    columns_.resize(columns_.size() + effects_.back().keys.size(),
                    Eigen::VectorXd::Zero(columns_.front().size()));
  }
  double& value(std::size_t row, std::size_t column_of_effect) {
    const auto first = static_cast<std::size_t>(effects_.back().first_column);
    return columns_[first + column_of_effect](static_cast<Eigen::Index>(row));
  }

  const TidyTable& table_;
  std::vector<Eigen::VectorXd> columns_{};
  std::vector<FixedEffect> effects_{};
};

CrossedTable crossed_table(const TidyInput& input) {
  const TidyTable& table = input.table();
  CrossedTable read{.model = {.link = link_of(input.options)}};
  read_random(input.options, read.model);
  read_sampled(input.options, read);
  read.model.likelihood = likelihood_of(input.options, read.model);
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn items = read.items_are_sampled || table.has("item")
                                ? table.all_labels("item")
                                : LabelColumn{.codes = std::vector<std::size_t>(table.rows())};
  const std::vector<std::uint64_t> hits = table.counts("correct");
  const std::vector<std::uint64_t> trials = table.counts("trials");
  EffectsDesign design(table);
  for (const auto& [name, levels] : input.options.levels("fixed")) design.add_factor(name, levels);
  if (input.options.has("covariates")) {
    for (const std::string& name : input.options.texts("covariates")) design.add_covariate(name);
  }
  read.model.design = design.matrix();
  read.effects = design.effects();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    read.responses.push_back({.count = counted_responses(table, row, hits[row], trials[row]),
                              .participant = participants.codes[row],
                              .item = items.codes[row]});
  }
  read.participants = participants.names.size();
  read.items = items.names.size();
  return read;
}

double linked(double proportion, BinomialLink link) {
  if (link == BinomialLink::logit) return std::log(proportion / (1.0 - proportion));
  // Φ⁻¹ by the limit that |Z| exceeds with the probability of both tails.
  if (proportion == 0.5) return 0.0;
  const double z = normal_limit(std::abs(2.0 * proportion - 1.0));
  return proportion > 0.5 ? z : -z;
}

double proportion_at(double predictor, BinomialLink link) {
  return link == BinomialLink::logit ? 1.0 / (1.0 + std::exp(-predictor)) : normal_below(predictor);
}

struct ProblemWords {
  const char* word;
  const char* status;
};
/// What can be done depends on the intercepts that the model has.
ProblemWords crossed_problem_words(CrossedProblem problem, const CrossedModel& model) {
  const bool both_vary = model.participants_vary && model.items_vary;
  switch (problem) {
    case CrossedProblem::no_maximum:
      if (!both_vary) {
        return {"no_maximum",
                "the random intercepts can predict every response, so that the likelihood has no "
                "maximum: collect more responses"};
      }
      return {"no_maximum",
              "the intercepts of participants and items can predict every response, so that the "
              "likelihood has no maximum: collect more responses, or fit with the option "
              "random=subject or random=item"};
    case CrossedProblem::no_participant_variance:
      if (!both_vary) {
        return {"no_participant_variance",
                "the standard deviation of the participants' intercepts is estimated as 0: "
                "participants do not differ more than expected by chance; use the family "
                "proportion, or group for two groups"};
      }
      return {
          "no_participant_variance",
          "the standard deviation of the participants' intercepts is estimated as 0: fit with the "
          "option random=item"};
    case CrossedProblem::no_item_variance:
      if (!both_vary) {
        return {"no_item_variance",
                "the standard deviation of the items' intercepts is estimated as 0: items do not "
                "differ more than expected by chance; use the family proportion, or group for two "
                "groups"};
      }
      return {
          "no_item_variance",
          "the standard deviation of the items' intercepts is estimated as 0: fit with the option "
          "random=subject"};
    case CrossedProblem::no_variance:
      return {"no_variance",
              "both standard deviations are estimated as 0: neither participants nor items differ "
              "more than expected by chance; use the family proportion, or group for two groups"};
  }
  return {"", ""};
}

/// A sentence on a level of a factor with correct or incorrect responses only; empty where there is none. The likelihood grows
/// without limit with the linear predictor of that level: at the first one, which has no column, with the intercept while all
/// coefficients of the factor fall by the same.
std::string separated_level(const CrossedTable& table) {
  for (const FixedEffect& effect : table.effects) {
    std::vector<HitCount> of_level(effect.levels.size());
    for (std::size_t row = 0; row < table.responses.size() && !effect.levels.empty(); ++row) {
      std::size_t level = 0;
      for (Eigen::Index column = 0; column < effect.columns(); ++column) {
        const auto at = static_cast<Eigen::Index>(row);
        if (table.model.design(at, effect.first_column + column) == 1.0) {
          level = static_cast<std::size_t>(column) + 1;
        }
      }
      of_level[level].hits += table.responses[row].count.hits;
      of_level[level].trials += table.responses[row].count.trials;
    }
    for (std::size_t level = 0; level < of_level.size(); ++level) {
      const HitCount& count = of_level[level];
      if (count.trials == 0 || (count.hits > 0 && count.hits < count.trials)) continue;
      return "every response at the level \"" + effect.levels[level] + "\" of " + effect.name +
             (count.hits == 0 ? " is incorrect" : " is correct") + ", so that the effect of " +
             effect.name +
             " has no finite estimate: leave out the level, or collect more responses at it";
    }
  }
  return {};
}

class CrossedFindings final {
 public:
  CrossedFindings(const TidyInput& input, const CrossedTable& table)
      : table_(table),
        confidence_(input.options.confidence()),
        method_(std::string(table.model.link == BinomialLink::logit ? "logit" : "probit") +
                (table.model.likelihood == MarginalLikelihood::laplace
                     ? " mixed model, maximum likelihood with the Laplace approximation"
                     : " mixed model, maximum likelihood by numerical integration")) {
    if (const std::optional<double> chance = input.options.number_if("chance")) {
      if (!(*chance > 0.0 && *chance < 1.0)) {
        throw std::runtime_error("the option \"chance\" is " + number_text(*chance) +
                                 "; it must lie between 0 and 1");
      }
      null_ = linked(*chance, table.model.link);
    }
  }

  std::vector<Finding> findings() {
    list_.count("n.subjects", "", table_.participants, basis("participants"));
    if (table_.items > 0) list_.count("n.items", "", table_.items, basis("items"));
    if (!dependent_columns(table_.model.design).empty()) {
      list_.word("glmm.status", "", "dependent_effects",
                 "a fixed effect does not vary, or is a combination of the others: remove one of "
                 "them",
                 basis(method_));
      return list_.take();
    }
    if (const std::string separated = separated_level(table_); !separated.empty()) {
      list_.word("glmm.status", "", "separated_level", separated, basis(method_));
      return list_.take();
    }
    const CrossedAnswer answer = crossed_fit(table_.responses, table_.model);
    if (!answer.fit) {
      const ProblemWords why = crossed_problem_words(answer.problem, table_.model);
      list_.word("glmm.status", "", why.word, why.status, basis(method_));
      return list_.take();
    }
    list_.word("glmm.status", "", "ok", "ok", basis(method_));
    coefficients(*answer.fit);
    if (table_.model.participants_vary) {
      number("glmm.sigma", "subject", answer.fit->sigma_participants,
             "standard deviation of the participants' intercepts");
    }
    if (table_.model.items_vary) {
      number("glmm.sigma", "item", answer.fit->sigma_items,
             "standard deviation of the items' intercepts");
    }
    number("glmm.loglik", "", answer.fit->log_likelihood, "binomial coefficients included");
    for (const FixedEffect& effect : table_.effects) likelihood_ratio(effect, *answer.fit);
    return list_.take();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = table_.participants, .method = std::move(method)};
  }
  void number(const char* quantity, const FindingKey& key, double value, std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }

  void coefficients(const CrossedFit& fit) {
    const double z = normal_limit(confidence_);
    const auto add = [&](const FindingKey& key, Eigen::Index at, double null,
                         const std::string& size) {
      const double beta = fit.beta(at);
      const double error = fit.standard_error(at);
      Basis shown = basis(method_ + "; Wald interval");
      shown.interval = {.low = beta - z * error, .high = beta + z * error};
      shown.confidence = confidence_;
      list_.number("glmm.beta", key, beta, shown);
      number("glmm.se", key, error, "observed information");
      const double statistic = (beta - null) / error;
      number("glmm.z", key, statistic, "Wald's z");
      number("glmm.p", key, std::erfc(std::abs(statistic) / std::sqrt(2.0)),
             "Wald's z test, two-sided" + size);
    };
    add("intercept", 0, null_,
        "; in simulations with four items the Type I error rate at α = .05 was up to 11 %");
    average_proportion(fit);
    for (const FixedEffect& effect : table_.effects) {
      for (Eigen::Index column = 0; column < effect.columns(); ++column) {
        add(effect.keys[static_cast<std::size_t>(column)], effect.first_column + column, 0.0, "");
      }
    }
  }

  /// The proportion for other participants and other items of the same kind: t instead of Wald's z,
  /// unless there are fixed effects: the intercept is then that of the reference levels, of which fewer
  /// participants may have trials.
  void average_proportion(const CrossedFit& fit) {
    if (!table_.effects.empty()) {
      proportion(fit, normal_limit(confidence_) * fit.standard_error(0), "Wald's");
      return;
    }
    const SampledError error =
        intercept_error(fit, table_.participants_are_sampled ? table_.participants : 0,
                        table_.items_are_sampled ? table_.items : 0);
    const std::string method =
        "t with the degrees of freedom of the smaller sample (participants or items); standard "
        "error corrected for the bias of the variances";
    const TLimit limit{.confidence = confidence_, .df = error.df};
    proportion(fit, error.standard_error * t_limit(limit).value_or(kUndefined), method);
    const double t = (fit.beta(0) - null_) / error.standard_error;
    number("glmm.t", "intercept", t, method);
    number("glmm.t.df", "intercept", error.df, method);
    number("glmm.t.p", "intercept",
           two_sided_tail({.value = t, .df = error.df}).value_or(kUndefined),
           method + ", two-sided");
  }

  /// `half_width`: of the interval of the intercept.
  void proportion(const CrossedFit& fit, double half_width, const std::string& interval) {
    Basis shown = basis(
        "proportion correct of a participant and an item with random intercepts of 0, at the "
        "reference levels and at covariates of 0; interval: " +
        interval);
    shown.interval = {.low = proportion_at(fit.beta(0) - half_width, table_.model.link),
                      .high = proportion_at(fit.beta(0) + half_width, table_.model.link)};
    shown.confidence = confidence_;
    list_.number("glmm.proportion", "", proportion_at(fit.beta(0), table_.model.link), shown);
  }

  /// The likelihood-ratio test against the model without the effect.
  void likelihood_ratio(const FixedEffect& effect, const CrossedFit& full) {
    CrossedModel without = table_.model;
    const Eigen::Index behind = without.design.cols() - effect.first_column - effect.columns();
    without.design.resize(table_.model.design.rows(),
                          table_.model.design.cols() - effect.columns());
    without.design << table_.model.design.leftCols(effect.first_column),
        table_.model.design.rightCols(behind);
    const CrossedAnswer answer = crossed_fit(table_.responses, without);
    if (!answer.fit) {
      const ProblemWords why = crossed_problem_words(answer.problem, without);
      list_.word("glmm.lr", effect.name, why.word, why.status, basis("model without the effect"));
      return;
    }
    const double ratio = std::max(0.0, 2.0 * (full.log_likelihood - answer.fit->log_likelihood));
    const auto df = static_cast<double>(effect.columns());
    number("glmm.lr", effect.name, ratio,
           "likelihood-ratio statistic against the model without the effect");
    number("glmm.lr.df", effect.name, df, "degrees of freedom of χ²");
    number("glmm.lr.p", effect.name, *upper_tail(ChiSquaredStatistic{.value = ratio, .df = df}),
           "likelihood-ratio test (χ²); in simulations with covariates the Type I error rate at "
           "α = .05 was up to 7 %, and up to 9 % with fewer than five participants");
  }

  const CrossedTable& table_;
  double confidence_ = 0.95;
  std::string method_{};
  double null_ = 0.0;
  FindingList list_{};
};

}  // namespace

std::vector<Finding> glmm_findings(const TidyInput& input) {
  const CrossedTable table = crossed_table(input);
  if (table.responses.empty()) {
    FindingList findings{};
    findings.word("glmm.status", "", "no_data", "the table has no rows: add the responses");
    return findings.take();
  }
  return CrossedFindings(input, table).findings();
}

}  // namespace asperity
