// Measurements of participants by a linear mixed model with a random intercept per participant.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/models/linear_mixed.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/mixed_rows.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// A factor with treatment contrasts, or a covariate: adjacent columns of the design.
struct MixedTerm {
  std::string name{};
  std::vector<FindingKey> keys{};  ///< of its columns: "texture|wood", "trial"
  LinearMixedFit::Columns columns{};
  bool is_factor = false;
};

struct MixedTable {
  GroupedMeasurements data{};
  std::vector<MixedTerm> terms{};
  /// Terms that cannot be distinguished from the terms before them, and are not in the design.
  std::vector<std::string> dependent{};
  /// Levels without a measurement, as keys.
  std::vector<FindingKey> without_rows{};
  std::size_t participants = 0;
  std::size_t left_out = 0;  ///< rows without a measurement, a level or the number of a covariate
  bool is_logarithmic = false;
};

/// Whether a row has a value in all columns that the model uses.
bool has_all_values(const MixedRows::Row& row) {
  return row.y &&
         std::find(row.levels.begin(), row.levels.end(), LabelColumn::kMissing) ==
             row.levels.end() &&
         std::find(row.covariates.begin(), row.covariates.end(), std::nullopt) ==
             row.covariates.end();
}

/// A column of the design: the indicator of a level, or a covariate.
struct DesignColumn {
  std::optional<std::size_t> factor{};  ///< nothing: a covariate
  std::size_t level = 0;
  std::size_t covariate = 0;

  double in(const MixedRows::Row& row) const {
    if (!factor) return *row.covariates[covariate];
    return row.levels[*factor] == level ? 1.0 : 0.0;
  }
};

/// The number of complete rows, of all and by factor and level.
struct CompleteRows {
  std::size_t all = 0;
  std::vector<std::vector<std::size_t>> by_level{};
};

CompleteRows count_complete(const MixedRows& rows) {
  CompleteRows counted{};
  for (const MixedRows::Factor& factor : rows.factors) {
    counted.by_level.emplace_back(factor.levels.size());
  }
  rows.for_each([&counted](const MixedRows::Row& row) {
    if (!has_all_values(row)) return;
    ++counted.all;
    for (std::size_t i = 0; i < row.levels.size(); ++i) ++counted.by_level[i][row.levels[i]];
  });
  return counted;
}

/// The terms with their columns, as if all could be distinguished; levels without a row are left out.
std::vector<MixedTerm> terms_of(const MixedRows& rows, const CompleteRows& complete,
                                std::vector<DesignColumn>& columns,
                                std::vector<FindingKey>& without_rows) {
  std::vector<MixedTerm> terms{};
  const auto add_column = [&](const FindingKey& key, const DesignColumn& column) {
    terms.back().keys.push_back(key);
    ++terms.back().columns.count;
    columns.push_back(column);
  };
  for (std::size_t factor = 0; factor < rows.factors.size(); ++factor) {
    const auto& [name, levels] = rows.factors[factor];
    terms.push_back({.name = name,
                     .columns = {.first = static_cast<Eigen::Index>(columns.size()), .count = 0},
                     .is_factor = true});
    bool is_reference = true;
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (complete.by_level[factor][level] == 0) {
        without_rows.push_back({name, levels[level]});
        continue;
      }
      if (!std::exchange(is_reference, false)) {
        add_column({name, levels[level]}, {.factor = factor, .level = level});
      }
    }
    if (terms.back().keys.empty()) terms.pop_back();  // one level: there is nothing to compare
  }
  for (std::size_t covariate = 0; covariate < rows.covariates.size(); ++covariate) {
    const std::string& name = rows.covariates[covariate];
    terms.push_back({.name = name,
                     .columns = {.first = static_cast<Eigen::Index>(columns.size()), .count = 0}});
    add_column(name, {.covariate = covariate});
  }
  return terms;
}

/// `columns` without the intercept.
Eigen::MatrixXd design_of(const MixedRows& rows, std::size_t complete,
                          const std::vector<DesignColumn>& columns) {
  Eigen::MatrixXd design(static_cast<Eigen::Index>(complete),
                         static_cast<Eigen::Index>(columns.size()) + 1);
  design.col(0).setOnes();
  Eigen::Index at = 0;
  rows.for_each([&](const MixedRows::Row& row) {
    if (!has_all_values(row)) return;
    for (std::size_t column = 0; column < columns.size(); ++column) {
      design(at, static_cast<Eigen::Index>(column) + 1) = columns[column].in(row);
    }
    ++at;
  });
  return design;
}

MixedTable mixed_table(const MixedRows& rows) {
  const CompleteRows complete = count_complete(rows);
  MixedTable made{.left_out = rows.rows - complete.all, .is_logarithmic = rows.is_logarithmic};
  std::vector<DesignColumn> columns{};
  const std::vector<MixedTerm> terms = terms_of(rows, complete, columns, made.without_rows);
  made.data.design = design_of(rows, complete.all, columns);
  const std::vector<Eigen::Index> dependent = dependent_columns(made.data.design);
  std::vector<DesignColumn> kept{};
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
    const auto from = columns.begin() + term.columns.first;
    term.columns.first = static_cast<Eigen::Index>(kept.size()) + 1;
    kept.insert(kept.end(), from, from + term.columns.count);
    made.terms.push_back(std::move(term));
  }
  if (!made.dependent.empty()) {
    made.data.design.resize(0, 0);  // there may be millions of rows: one design at a time
    made.data.design = design_of(rows, complete.all, kept);
  }
  made.data.y.resize(static_cast<Eigen::Index>(complete.all));
  made.data.participant.reserve(complete.all);
  std::vector<std::optional<std::size_t>> number_of(rows.participants);
  rows.for_each([&](const MixedRows::Row& row) {
    if (!has_all_values(row)) return;
    if (made.is_logarithmic && !(*row.y > 0.0)) {
      throw std::invalid_argument("y is " + number_text(*row.y) +
                                  "; it must be above 0 with scale=log");
    }
    made.data.y(static_cast<Eigen::Index>(made.data.participant.size())) =
        made.is_logarithmic ? std::log(*row.y) : *row.y;
    std::optional<std::size_t>& number = number_of[row.participant];
    if (!number) number = made.participants++;
    made.data.participant.push_back(*number);
  });
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
              "between participants: add participants, or remove such effects"};
    case NoLinearMixed::too_few_rows:
      return {"too_few_rows",
              "the model requires several measurements of a participant, and more measurements "
              "than fixed effects: add measurements, or remove fixed effects"};
    case NoLinearMixed::dependent_effects:
      return {"dependent_effects",
              "a fixed effect is a combination of the others: remove one of them"};
    case NoLinearMixed::no_participant_variance:
      return {
          "no_participant_variance",
          "the variance between participants is estimated as 0 (singular fit): add participants "
          "or measurements, or use a model without random intercepts"};
    case NoLinearMixed::no_residual_variance:
      return {"no_residual_variance",
              "participants and fixed effects determine every measurement, so that there is no "
              "error variance: add measurements, or remove fixed effects"};
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
      list_.word(
          "lmm.beta", term, "dependent",
          "cannot be distinguished from the effects before it, or does not vary, so that it is "
          "not in the model: remove it, or one of the effects before it",
          basis(method_));
    }
    for (const FindingKey& key : table_.without_rows) {
      list_.word("lmm.beta", key, "no_data",
                 "the level has no measurement: add one, or remove the level", basis(method_));
    }
    const std::variant<LinearMixedFit, NoLinearMixed> answer = linear_mixed(table_.data);
    if (const auto* const why = std::get_if<NoLinearMixed>(&answer)) {
      const NoFitWords words = no_fit_words(*why);
      list_.word("lmm.status", "", words.word, words.status, basis(method_));
      return list_.take();
    }
    const auto& fit = std::get<LinearMixedFit>(answer);
    list_.word("lmm.status", "", "ok", "ok", basis(method_));
    coefficient(fit, "intercept", 0, "");
    for (const MixedTerm& term : table_.terms) {
      for (std::size_t i = 0; i < term.keys.size(); ++i) {
        coefficient(fit, term.keys[i], term.columns.first + static_cast<Eigen::Index>(i),
                    term.is_factor ? coverage_of_levels() : "");
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
  void number(const char* quantity, const FindingKey& key, double value, std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }

  static std::string coverage_of_levels() {
    return simulated_coverage({92, 96}) +
           " where the differences between levels are the same for all participants, and " +
           text_of(CoverageSpan{68, 90}) + " where they vary over participants";
  }

  void coefficient(const LinearMixedFit& fit, const FindingKey& key, Eigen::Index column,
                   const std::string& coverage) {
    const LinearMixedFit::Combination effect = fit.effect(column, confidence_);
    const std::string interval = "; interval with Satterthwaite's degrees of freedom" + coverage;
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
    number(
        "lmm.F.p", term.name, test.p,
        "F test of all levels of a factor, Satterthwaite; in simulations in which neither "
        "levels nor participants differed the Type I error rate at α = .05 was up to 7 %, and with "
        "effects that vary over participants (SDs of half and one residual SD) up to 25 and "
        "54 %");
  }

  const MixedTable& table_;
  double confidence_ = 0.95;
  std::string method_{};
  FindingList list_{};
};

bool is_logarithmic(const FamilyOptions& options) {
  const std::string scale = options.text_or("scale", "linear");
  if (scale == "linear") return false;
  if (scale == "log") return true;
  throw std::runtime_error("the option \"scale\" is \"" + scale + "\"; it must be linear or log");
}

/// The columns of a table that a model uses.
struct MixedColumns {
  NumberColumn y{};
  LabelColumn participants{};
  std::vector<LabelColumn> factors{};
  std::vector<NumberColumn> covariates{};

  void visit(const std::function<void(std::size_t, const MixedRows::Row&)>& visitor) const {
    MixedRows::Row row{.levels = std::vector<std::size_t>(factors.size()),
                       .covariates = std::vector<std::optional<double>>(covariates.size())};
    for (std::size_t at = 0; at < y.size(); ++at) {
      row.y = y[at];
      row.participant = participants.codes[at];
      for (std::size_t i = 0; i < factors.size(); ++i) row.levels[i] = factors[i].codes[at];
      for (std::size_t i = 0; i < covariates.size(); ++i) row.covariates[i] = covariates[i][at];
      visitor(at, row);
    }
  }
};

}  // namespace

std::vector<Finding> findings_of(const MixedRows& rows) {
  const MixedTable table = mixed_table(rows);
  if (table.data.participant.empty()) {
    FindingList findings{};
    findings.word("lmm.status", "", "no_data",
                  "no row has a measurement and all its predictors: "
                  "complete the rows, or remove predictors");
    return findings.take();
  }
  return MixedFindings(table, rows.confidence).findings();
}

std::vector<Finding> lmm_findings(const TidyInput& input) {
  MixedRows rows{.confidence = input.options.confidence()};
  const TidyTable& table = input.table();
  MixedColumns read{.y = table.numbers("y"), .participants = table.all_labels("subject")};
  for (auto& [name, levels] : input.options.levels("fixed")) {
    read.factors.push_back(table.labels(name, levels));
    rows.factors.push_back({name, levels});
  }
  if (input.options.has("covariates")) rows.covariates = input.options.texts("covariates");
  for (const std::string& name : rows.covariates) read.covariates.push_back(table.numbers(name));
  rows.participants = read.participants.names.size();
  rows.rows = table.rows();
  rows.is_logarithmic = is_logarithmic(input.options);
  if (rows.is_logarithmic) {
    read.visit([&table](std::size_t at, const MixedRows::Row& row) {
      if (has_all_values(row) && !(*row.y > 0.0)) {
        table.refuse(at, "y",
                     "y is " + number_text(*row.y) +
                         "; it must be above 0 with scale=log. Correct it, or use scale=linear");
      }
    });
  }
  rows.for_each = [&read](const std::function<void(const MixedRows::Row&)>& visitor) {
    read.visit([&visitor](std::size_t, const MixedRows::Row& row) { visitor(row); });
  };
  return findings_of(rows);
}

}  // namespace asperity
