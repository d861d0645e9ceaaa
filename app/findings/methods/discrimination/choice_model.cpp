// A binary cumulative link model of choices; columns that depend linearly on earlier ones are left out.

#include "app/findings/methods/discrimination/choice_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "analysis/models/cumulative_link.h"
#include "analysis/models/linear_mixed.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr double kConfidenceOfEffects = 0.95;

/// A trial whose two surfaces have a mean force and a mean speed.
struct ExploredChoice {
  std::size_t person = 0;
  std::size_t condition = 0;
  bool chose_comparison = false;
  double level = 0.0;
  double force_N = 0.0;  ///< of the comparison minus that of the standard
  double speed_m_per_s = 0.0;
  double comparison_first = 0.0;
};

struct ChoiceCovariate {
  const char* name = "";  ///< as in the column `factor`
  double ExploredChoice::*value = nullptr;
  const char* unit = nullptr;  ///< null: that of the varied parameter
  bool is_position = false;    ///< 0 or 1, whose effect is that of the whole step
};
constexpr std::array kChoiceCovariates{
    ChoiceCovariate{"level_difference", &ExploredChoice::level},
    ChoiceCovariate{"force_difference", &ExploredChoice::force_N, "N"},
    ChoiceCovariate{"speed_difference", &ExploredChoice::speed_m_per_s, "m/s"},
    ChoiceCovariate{"comparison_first", &ExploredChoice::comparison_first, "1", true}};

/// Between the levels of a measure of ratios, a ratio: ln(value/standard).
double level_difference(const DiscriminationTask& task, double value) {
  const LevelMeasure measure = task.varied.measure;
  const bool is_ratio = measure == LevelMeasure::ratio || measure == LevelMeasure::decibels;
  return is_ratio && value > 0.0 ? std::log(value / task.standard()) : value - task.standard();
}

std::vector<ExploredChoice> explored_choices(const GatheredAnswers& gathered,
                                             const DiscriminationStudy& study) {
  std::vector<ExploredChoice> choices{};
  std::map<std::uint32_t, std::size_t> people{};
  for (const DiscriminationTrial& trial : study.trials) {
    if (trial.is_unsure) continue;  // no surface was chosen
    const std::size_t comparison = trial.first_surface + (trial.comparison_first ? 0 : 1);
    const std::size_t standard = trial.first_surface + (trial.comparison_first ? 1 : 0);
    const GatheredExploration& explored = gathered.exploration;
    const std::array forces{explored.force_N(comparison), explored.force_N(standard)};
    const std::array speeds{explored.speed_m_per_s(comparison), explored.speed_m_per_s(standard)};
    if (!forces[0] || !forces[1] || !speeds[0] || !speeds[1]) continue;
    const std::size_t person = people.try_emplace(trial.person, people.size()).first->second;
    choices.push_back({.person = person,
                       .condition = trial.condition,
                       .chose_comparison = trial.chose_comparison,
                       .level = level_difference(study.task, trial.value),
                       .force_N = *forces[0] - *forces[1],
                       .speed_m_per_s = *speeds[0] - *speeds[1],
                       .comparison_first = trial.comparison_first ? 1.0 : 0.0});
  }
  return choices;
}

/// The conditions, then the covariates that vary, in units of their standard deviation, without those that follow from the
/// ones before. Conditions that differ in the proportion of choices and in the exploration would otherwise look like an effect
/// of the exploration.
struct ChoiceDesign {
  std::size_t conditions = 0;  ///< the first columns: of all conditions but the first
  std::vector<const ChoiceCovariate*> covariates{};
  std::vector<double> deviations{};  ///< 1 for the position
  Eigen::MatrixXd columns{};
};

ChoiceDesign choice_design(const std::vector<ExploredChoice>& choices) {
  const auto rows = static_cast<Eigen::Index>(choices.size());
  ChoiceDesign design{};
  Eigen::MatrixXd all = Eigen::MatrixXd::Ones(rows, 1);
  const auto add = [&](const Eigen::VectorXd& column) {
    Eigen::MatrixXd with(rows, all.cols() + 1);
    with << all, column;
    if (!dependent_columns(with).empty()) return false;
    all = with;
    return true;
  };
  std::size_t last_condition = 0;
  for (const ExploredChoice& choice : choices) {
    last_condition = std::max(last_condition, choice.condition);
  }
  for (std::size_t condition = 1; condition <= last_condition; ++condition) {
    Eigen::VectorXd column(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      column(row) = choices[static_cast<std::size_t>(row)].condition == condition ? 1.0 : 0.0;
    }
    if (add(column)) ++design.conditions;
  }
  for (const ChoiceCovariate& covariate : kChoiceCovariates) {
    Eigen::VectorXd column(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      column(row) = choices[static_cast<std::size_t>(row)].*covariate.value;
    }
    const double deviation = std::sqrt((column.array() - column.mean()).square().mean());
    if (!(deviation > 0.0)) continue;
    const double unit = covariate.is_position ? 1.0 : deviation;
    if (!add(column / unit)) continue;
    design.covariates.push_back(&covariate);
    design.deviations.push_back(unit);
  }
  design.columns = all.rightCols(all.cols() - 1);
  return design;
}

const char* word_of_problem(CumulativeLinkProblem problem) {
  switch (problem) {
    case CumulativeLinkProblem::unused_category:
    case CumulativeLinkProblem::separated:
      return "separated_choices";
    case CumulativeLinkProblem::unbounded_variance:
    case CumulativeLinkProblem::not_converged:
    case CumulativeLinkProblem::no_participant_variance:
    case CumulativeLinkProblem::no_item_variance:
    case CumulativeLinkProblem::no_variance:
      break;
  }
  return "not_converged";
}

std::vector<Finding> findings_of_choices(const std::vector<ExploredChoice>& choices,
                                         const ChoiceDesign& design, std::size_t people) {
  FindingList list{};
  const Basis basis{.n = people,
                    .method =
                        "logistic mixed model, random intercepts of participants, maximum "
                        "likelihood (Laplace)"};
  list.count("n.subjects", "", people, basis);
  list.count("n.rows", "", choices.size(), basis);
  std::vector<OrdinalResponse> responses{};
  for (const ExploredChoice& choice : choices) {
    responses.push_back(
        {.category = choice.chose_comparison ? 1U : 0U, .participant = choice.person});
  }
  CumulativeLinkModel model{.categories = 2, .design = design.columns};
  model.participants_vary = people > 1;
  CumulativeLinkAnswer answer = cumulative_link_fit(responses, model);
  if (!answer.fit && answer.problem == CumulativeLinkProblem::no_participant_variance) {
    model.participants_vary = false;
    answer = cumulative_link_fit(responses, model);
  }
  if (!answer.fit) {
    list.word("status", "", word_of_problem(answer.problem), "the effects cannot be estimated",
              basis);
    return list.take();
  }
  list.word("status", "", "ok", "ok", basis);
  const Eigen::VectorXd errors = answer.fit->standard_error();
  for (std::size_t i = 0; i < design.covariates.size(); ++i) {
    const FindingKey key = design.covariates[i]->name;
    const std::size_t effect = design.conditions + i;
    const auto column = static_cast<Eigen::Index>(effect);
    const double beta = answer.fit->beta(column);
    const double reach = normal_limit(kConfidenceOfEffects) * errors(column);
    Basis ratio = basis;
    ratio.interval = {.low = std::exp(beta - reach), .high = std::exp(beta + reach)};
    ratio.confidence = kConfidenceOfEffects;
    list.number("odds_ratio", key, std::exp(beta), ratio);
  }
  list.number("sigma", "subject", answer.fit->sigma_participants, basis);
  return list.take();
}

Phrase note_on_model() {
  return phrase(
      "Analysis",
      "Logistic mixed model of the choices of the comparison, with the conditions and random "
      "intercepts of participants. Differences are those of the comparison from the standard: of "
      "the level, and of the mean normal force and the mean speed during contact. Odds ratios per "
      "SD over the trials, and of the position, with Wald’s 95 % CIs. Exploratory: participants "
      "chose force and speed themselves, and the CIs are too narrow where they differ in these "
      "effects.");
}

const ResultColumn kOddsRatio{.id = "odds_ratio", .heading = phrase("AnalysisWords", "odds ratio")};

}  // namespace

void add_choice_model(const GatheredAnswers& gathered,
                      const std::vector<DiscriminationStudy>& studies, AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable shown{kChoiceModel,
                    phrase("Analysis", "Choices and exploration: logistic mixed model"),
                    {kBlock, kFactor, kPersons, kAnswers, kSd, for_files(kUnit), kOddsRatio,
                     interval_of(kOddsRatio), kStatus},
                    note_on_model()};
  for (const DiscriminationStudy& study : studies) {
    if (study.task.design != &two_alternatives()) continue;
    const std::vector<ExploredChoice> choices = explored_choices(gathered, study);
    if (choices.empty()) continue;
    std::size_t people = 0;
    for (const ExploredChoice& choice : choices) people = std::max(people, choice.person + 1);
    const ChoiceDesign design = choice_design(choices);
    const std::string task = studies.size() > 1 ? study.task.name : std::string();
    const std::string analysis = task.empty() ? kChoiceModel : kChoiceModel + (':' + task);
    const std::vector<Finding> findings =
        analysis_of(analysis.c_str(), [&] { return findings_of_choices(choices, design, people); });
    keep_findings(findings, outcome);
    const FoundNumbers found(findings);
    const std::string status = found.find("status") ? found.find("status")->word : "not_converged";
    const auto counts = [&](const std::string& factor) {
      return ResultRow{word_cell(task), factor, count_cell(people), count_cell(choices.size())};
    };
    if (status != "ok") {
      ResultRow row = counts("all");
      row.resize(shown.columns.size() - 1);
      row.emplace_back(status);
      shown.add(std::move(row));
      continue;
    }
    for (std::size_t i = 0; i < design.covariates.size(); ++i) {
      const ChoiceCovariate& covariate = *design.covariates[i];
      const Finding& ratio = *found.find("odds_ratio", covariate.name);
      const std::string unit =
          covariate.unit == nullptr ? study.task.varied.unit : std::string(covariate.unit);
      ResultRow row = counts(covariate.name);
      row.push_back(covariate.is_position
                        ? ResultCell{}
                        : quantity_cell(design.deviations[i], unit.empty() ? "1" : unit));
      row.emplace_back(unit);
      row.push_back(cell_of(ratio.value));
      row.push_back(interval_cell(ratio.low, ratio.high));
      shown.add(std::move(row));
    }
  }
  if (shown.rows.empty()) return;
  shown.drop_empty_columns(0);
  outcome.tables.push_back(std::move(shown));
}

}  // namespace asperity
