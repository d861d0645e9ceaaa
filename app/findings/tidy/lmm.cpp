// Measurements of participants by a linear mixed model with a random intercept per participant.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/linear_mixed.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// A factor with treatment contrasts, or a covariate: adjacent columns of the design.
struct MixedTerm {
  std::string name{};
  std::vector<std::string> keys{};  ///< of its columns: "texture|wood", "trial"
  LinearMixedFit::Columns columns{};
  bool is_factor = false;
};

struct MixedTable {
  GroupedMeasurements data{};
  std::vector<MixedTerm> terms{};
  /// Terms that cannot be distinguished from the terms before them, and are not in the design.
  std::vector<std::string> dependent{};
  /// Levels without a measurement, as keys.
  std::vector<std::string> without_rows{};
  std::size_t participants = 0;
  std::size_t left_out = 0;  ///< rows without a measurement, a level or the number of a covariate
  bool is_logarithmic = false;
};

bool is_logarithmic(const FamilyOptions& options) {
  const std::string scale = options.text_or("scale", "linear");
  if (scale == "linear") return false;
  if (scale == "log") return true;
  throw std::runtime_error("the option \"scale\" is \"" + scale + "\"; it must be linear or log");
}

/// The columns that a model uses, with the rows that have a value in all of them.
struct MixedColumns {
  NumberColumn y{};
  LabelColumn participants{};
  std::vector<std::pair<std::string, LabelColumn>> factors{};
  std::vector<std::pair<std::string, NumberColumn>> covariates{};
  std::vector<std::size_t> complete{};
};

MixedColumns mixed_columns(const TidyTable& table, const FamilyOptions& options) {
  MixedColumns read{.y = table.numbers("y"), .participants = table.all_labels("subject")};
  for (auto& [name, levels] : options.levels("fixed")) {
    read.factors.emplace_back(name, table.labels(name, levels));
  }
  if (options.has("covariates")) {
    for (const std::string& name : options.texts("covariates")) {
      read.covariates.emplace_back(name, table.numbers(name));
    }
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool has_factors = std::all_of(
        read.factors.begin(), read.factors.end(),
        [row](const auto& factor) { return factor.second.codes[row] != LabelColumn::kMissing; });
    const bool has_covariates =
        std::all_of(read.covariates.begin(), read.covariates.end(),
                    [row](const auto& covariate) { return covariate.second[row].has_value(); });
    if (read.y[row] && has_factors && has_covariates) read.complete.push_back(row);
  }
  return read;
}

/// A column of the design: the indicator of a level, or a covariate.
struct DesignColumn {
  const LabelColumn* factor = nullptr;  ///< null: a covariate
  std::size_t level = 0;
  const NumberColumn* covariate = nullptr;

  double at(std::size_t row) const {
    if (factor == nullptr) return *(*covariate)[row];
    return factor->codes[row] == level ? 1.0 : 0.0;
  }
};

/// The terms with their columns, as if all could be distinguished; levels without a row are left out.
std::vector<MixedTerm> terms_of(const MixedColumns& read, std::vector<DesignColumn>& columns,
                                std::vector<std::string>& without_rows) {
  std::vector<MixedTerm> terms{};
  const auto add_column = [&](const std::string& key, const DesignColumn& column) {
    terms.back().keys.push_back(key);
    ++terms.back().columns.count;
    columns.push_back(column);
  };
  for (const auto& [name, column] : read.factors) {
    std::vector<std::size_t> rows_of_level(column.names.size());
    for (const std::size_t row : read.complete) ++rows_of_level[column.codes[row]];
    terms.push_back({.name = name,
                     .columns = {.first = static_cast<Eigen::Index>(columns.size()), .count = 0},
                     .is_factor = true});
    bool is_reference = true;
    for (std::size_t level = 0; level < column.names.size(); ++level) {
      if (rows_of_level[level] == 0) {
        without_rows.push_back(both(name, column.names[level]));
        continue;
      }
      if (!std::exchange(is_reference, false)) {
        add_column(both(name, column.names[level]), {.factor = &column, .level = level});
      }
    }
    if (terms.back().keys.empty()) terms.pop_back();  // one level: there is nothing to compare
  }
  for (const auto& [name, column] : read.covariates) {
    terms.push_back({.name = name,
                     .columns = {.first = static_cast<Eigen::Index>(columns.size()), .count = 0}});
    add_column(name, {.covariate = &column});
  }
  return terms;
}

/// `columns` without the intercept.
Eigen::MatrixXd design_of(const std::vector<std::size_t>& rows,
                          const std::vector<DesignColumn>& columns) {
  Eigen::MatrixXd design(static_cast<Eigen::Index>(rows.size()),
                         static_cast<Eigen::Index>(columns.size()) + 1);
  design.col(0).setOnes();
  for (std::size_t column = 0; column < columns.size(); ++column) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      design(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column) + 1) =
          columns[column].at(rows[i]);
    }
  }
  return design;
}

MixedTable mixed_table(const TidyInput& input) {
  const TidyTable& table = input.table();
  const MixedColumns read = mixed_columns(table, input.options);
  MixedTable made{.left_out = table.rows() - read.complete.size(),
                  .is_logarithmic = is_logarithmic(input.options)};
  std::vector<DesignColumn> columns{};
  const std::vector<MixedTerm> terms = terms_of(read, columns, made.without_rows);
  Eigen::MatrixXd full = design_of(read.complete, columns);
  const std::vector<Eigen::Index> dependent = dependent_columns(full);
  std::vector<Eigen::Index> kept{0};
  for (MixedTerm term : terms) {
    const Eigen::Index first = term.columns.first + 1;
    const bool is_dependent =
        std::any_of(dependent.begin(), dependent.end(), [&](Eigen::Index column) {
          return column >= first && column < first + term.columns.count;
        });
    if (is_dependent) {
      made.dependent.push_back(term.name);
      continue;
    }
    term.columns.first = static_cast<Eigen::Index>(kept.size());
    for (Eigen::Index i = 0; i < term.columns.count; ++i) kept.push_back(first + i);
    made.terms.push_back(std::move(term));
  }
  // Without a copy where all columns are kept: there may be millions of rows.
  if (made.dependent.empty()) {
    made.data.design = std::move(full);
  } else {
    made.data.design = full(Eigen::all, kept);
  }
  made.data.y.resize(made.data.design.rows());
  std::vector<std::optional<std::size_t>> number_of(read.participants.names.size());
  for (std::size_t i = 0; i < read.complete.size(); ++i) {
    const std::size_t row = read.complete[i];
    if (made.is_logarithmic && !(*read.y[row] > 0.0)) {
      table.refuse(row, "y", "a number without a logarithm; with scale=log all must be above 0");
    }
    made.data.y(static_cast<Eigen::Index>(i)) =
        made.is_logarithmic ? std::log(*read.y[row]) : *read.y[row];
    std::optional<std::size_t>& number = number_of[read.participants.codes[row]];
    if (!number) number = made.participants++;
    made.data.participant.push_back(*number);
  }
  return made;
}

struct NoFitWords {
  const char* word;
  const char* status;
};
NoFitWords no_fit_words(NoLinearMixed why) {
  switch (why) {
    case NoLinearMixed::too_few_participants:
      return {"too_few_participants",
              "the model requires at least 2 participants, and more than there are fixed effects "
              "between participants"};
    case NoLinearMixed::too_few_rows:
      return {"too_few_rows",
              "the model requires several measurements of a participant, and more measurements "
              "than fixed effects"};
    case NoLinearMixed::dependent_effects:
      return {"dependent_effects", "a fixed effect is a combination of the others"};
    case NoLinearMixed::no_participant_variance:
      return {"no_participant_variance",
              "the variance between participants is estimated as 0 (singular fit)"};
    case NoLinearMixed::no_residual_variance:
      return {"no_residual_variance",
              "participants and fixed effects determine every measurement, so that there is no "
              "error variance"};
  }
  return {"", ""};
}

class MixedFindings final {
 public:
  MixedFindings(const MixedTable& table, double confidence)
      : table_(table),
        confidence_(confidence),
        method_(std::string("linear mixed model") +
                (table.is_logarithmic ? " of the natural logarithms" : "") +
                ", random intercept per participant, REML") {}

  std::vector<Finding> findings() {
    list_.count("n.subjects", "", table_.participants, basis("participants"));
    list_.count("n.rows", "", table_.data.participant.size(), basis("measurements"));
    list_.count("n.left_out", "", table_.left_out,
                basis("rows without a measurement, a level or the number of a covariate"));
    for (const std::string& term : table_.dependent) {
      list_.word("lmm.beta", term, "dependent",
                 "cannot be distinguished from the effects before it, or does not vary: it is not in "
                 "the model",
                 basis(method_));
    }
    for (const std::string& key : table_.without_rows) {
      list_.word("lmm.beta", key, "no_data", "the level has no measurement", basis(method_));
    }
    const std::variant<LinearMixedFit, NoLinearMixed> answer = linear_mixed(table_.data);
    if (const auto* const why = std::get_if<NoLinearMixed>(&answer)) {
      const NoFitWords words = no_fit_words(*why);
      list_.word("lmm.status", "", words.word, words.status, basis(method_));
      return list_.take();
    }
    const auto& fit = std::get<LinearMixedFit>(answer);
    list_.word("lmm.status", "", "ok", "ok", basis(method_));
    coefficient(fit, "intercept", 0);
    for (const MixedTerm& term : table_.terms) {
      for (std::size_t i = 0; i < term.keys.size(); ++i) {
        coefficient(fit, term.keys[i], term.columns.first + static_cast<Eigen::Index>(i));
      }
      if (term.is_factor) factor(fit, term);
    }
    number("lmm.variance", "subject", fit.participant_variance(),
           "variance of the participants' intercepts");
    number("lmm.variance", "residual", fit.residual_variance(), "residual variance");
    number("lmm.icc", "", fit.intraclass_correlation(),
           "intraclass correlation: proportion of the variance that is between participants");
    number("lmm.loglik", "", fit.log_likelihood(), "restricted log-likelihood");
    return list_.take();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = table_.participants, .method = std::move(method)};
  }
  void number(const char* quantity, const std::string& key, double value, std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }

  void coefficient(const LinearMixedFit& fit, const std::string& key, Eigen::Index column) {
    const LinearMixedFit::Combination effect = fit.effect(column, confidence_);
    const char* const interval = "; interval with Satterthwaite's degrees of freedom";
    Basis shown = basis(method_ + interval);
    shown.interval = effect.interval;
    shown.confidence = confidence_;
    list_.number("lmm.beta", key, effect.estimate, shown);
    if (table_.is_logarithmic) {
      Basis ratio = basis(method_ + ", as a ratio" + interval);
      ratio.interval = {.low = std::exp(effect.interval.low),
                        .high = std::exp(effect.interval.high)};
      ratio.confidence = confidence_;
      list_.number("lmm.ratio", key, std::exp(effect.estimate), ratio);
    }
    number("lmm.se", key, effect.standard_error, "standard error of a fixed effect");
    number("lmm.t", key, effect.t, "t of a fixed effect");
    number("lmm.df", key, effect.df, "Satterthwaite's degrees of freedom");
    number("lmm.p", key, effect.p, "t test of a fixed effect, two-sided, Satterthwaite");
  }

  void factor(const LinearMixedFit& fit, const MixedTerm& term) {
    const LinearMixedFit::JointTest test = fit.joint_test(term.columns);
    number("lmm.F", term.name, test.F, "F of all levels of a factor");
    number("lmm.F.df1", term.name, test.df1, "degrees of freedom of the effect");
    number("lmm.F.df2", term.name, test.df2, "Satterthwaite's degrees of freedom");
    number("lmm.F.p", term.name, test.p, "F test of all levels of a factor, Satterthwaite");
  }

  const MixedTable& table_;
  double confidence_ = 0.95;
  std::string method_{};
  FindingList list_{};
};

}  // namespace

std::vector<Finding> lmm_findings(const TidyInput& input) {
  const double confidence = input.options.confidence();
  const MixedTable table = mixed_table(input);
  if (table.data.participant.empty()) {
    FindingList findings{};
    findings.word("lmm.status", "", "no_data", "no row has a measurement and all its predictors");
    return findings.take();
  }
  return MixedFindings(table, confidence).findings();
}

}  // namespace asperity
