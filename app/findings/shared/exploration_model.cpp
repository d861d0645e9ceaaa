// Calls the family `lmm` on logarithms of times, with complete conditions as factors and places as covariates.

#include "app/findings/shared/exploration_model.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/tidy/mixed_rows.h"

namespace asperity {

namespace {

/// Covariates: columns of the tidy table, and words of the column `factor`.
constexpr const char* kTrialPlace = "trial_place";
constexpr const char* kBlockPlace = "block_place";
constexpr const char* kSessionPlace = "session_place";

struct ModelledTimes {
  const char* analysis = "";
  const char* measure = "";  ///< as in the table `exploration`
  Phrase name{};             ///< begins a sentence
};

/// Trials per unit of `trial_place`.
constexpr double kTrialsPerPlace = 10.0;

/// A place of the trial in its block, of the block in its session, or of the session.
struct ExploredPlace {
  const char* name = "";
  double (*of)(const GatheredAnswer& answer) = nullptr;
};

constexpr std::array kExploredPlaces{
    ExploredPlace{kTrialPlace,
                  [](const GatheredAnswer& answer) {
                    return static_cast<double>(answer.trial_of_block - 1) / kTrialsPerPlace;
                  }},
    ExploredPlace{
        kBlockPlace,
        [](const GatheredAnswer& answer) { return static_cast<double>(answer.block_ordinal); }},
    ExploredPlace{kSessionPlace, [](const GatheredAnswer& answer) {
                    return static_cast<double>(answer.session);
                  }}};

bool varies(const ExploredRows& rows, const ExploredPlace& place) {
  std::optional<double> first{};
  bool has_others = false;
  rows.for_each([&](const ExploredRow& row) {
    if (!first) first = place.of(row.answer);
    has_others = has_others || *first != place.of(row.answer);
  });
  return has_others;
}

/// Whether a change per ten trials of a block is no extrapolation.
bool has_ten_trials(const ExploredRows& rows) {
  bool has = false;
  rows.for_each([&has](const ExploredRow& row) {
    has = has || static_cast<double>(row.answer.trial_of_block) >= kTrialsPerPlace;
  });
  return has;
}

using TimeOfRow = std::function<std::optional<double>(const ExploredRow&)>;

/// The rows for the family `lmm`. A time of 0 has no logarithm and is left out: the surface was not touched. So is a
/// condition without a level in some rows: the model would be of the others alone.
MixedRows model_rows(const GatheredAnswers& gathered, const ExploredRows& rows,
                     const TimeOfRow& time_s) {
  MixedRows model{
      .participants = gathered.people.size(), .rows = rows.size(), .is_logarithmic = true};
  std::vector<const ExploredFactor*> conditions{};
  for (const ExploredFactor& one : rows.factors()) {
    if (!one.is_condition || !one.is_complete) continue;
    conditions.push_back(&one);
    model.factors.push_back({one.name, one.levels});
  }
  std::vector<const ExploredPlace*> places{};
  for (const ExploredPlace& place : kExploredPlaces) {
    if (!varies(rows, place)) continue;
    places.push_back(&place);
    model.covariates.emplace_back(place.name);
  }
  model.for_each = [=, &rows](const std::function<void(const MixedRows::Row&)>& visit) {
    MixedRows::Row made{.levels = std::vector<std::size_t>(conditions.size()),
                        .covariates = std::vector<std::optional<double>>(places.size())};
    rows.for_each([&](const ExploredRow& row) {
      made.y = time_s(row);
      if (made.y && !(*made.y > 0.0)) made.y.reset();
      made.participant = row.answer.person;
      for (std::size_t i = 0; i < conditions.size(); ++i)
        made.levels[i] = conditions[i]->level(row);
      for (std::size_t i = 0; i < places.size(); ++i) {
        made.covariates[i] = places[i]->of(row.answer);
      }
      visit(made);
    });
  };
  return model;
}

/// The test of one effect; nothing for numbers that could not be computed.
struct EffectTest {
  std::optional<double> F{};
  std::optional<double> df1{};
  std::optional<double> df2{};
  std::optional<double> p{};

  /// "F(2, 35.37) = 2.45"
  ResultCell statistic() const {
    if (!F && !df1 && !df2) return {};
    const auto stored = [](const std::optional<double>& number) {
      return number ? Cell{*number} : Cell{};
    };
    return JoinedCell{
        {stored(F), stored(df1), stored(df2)},
        F && df1 && df2 ? Phrase(statistic_text("F", std::array{*df1, *df2}, *F)) : Phrase{}};
  }
};

EffectTest test_of_factor(const std::string& name, const FoundNumbers& found) {
  return {found.value("lmm.F", name), found.value("lmm.F.df1", name),
          found.value("lmm.F.df2", name), found.value("lmm.F.p", name)};
}

/// F = t² with one degree of freedom.
EffectTest test_of_place(const std::string& name, const FoundNumbers& found) {
  const std::optional<double> t = found.value("lmm.t", name);
  return {t ? std::optional(*t * *t) : std::nullopt, t ? std::optional(1.0) : std::nullopt,
          found.value("lmm.df", name), found.value("lmm.p", name)};
}

class ModelTable final {
 public:
  void add(const ExploredRows& rows, const ModelledTimes& times, const FoundNumbers& found) {
    const Finding& status = *found.find("lmm.status");
    if (status.word != "ok") {
      row(times, found, {"all", {}, {}}, nullptr, {}, status.word);
      return;
    }
    for (const ExploredFactor& one : rows.factors()) {
      if (one.is_condition) add_condition(one, times, found);
    }
    for (const char* const place : {kTrialPlace, kBlockPlace, kSessionPlace}) {
      const Finding* beta = found.find("lmm.beta", place);
      if (beta == nullptr) continue;
      if (std::string_view(place) == kTrialPlace && !has_ten_trials(rows)) continue;
      row(times, found, {place, {}, {}}, found.find("lmm.ratio", place),
          test_of_place(place, found), beta->word);
    }
  }
  bool empty() const { return table_.rows.empty(); }
  ResultTable take(Phrase note) {
    table_.drop_empty_columns(5);
    table_.note = std::move(note);
    return std::move(table_);
  }

 private:
  struct EffectName {
    std::string factor{};
    ResultCell level{};
    ResultCell reference{};
  };

  void add_condition(const ExploredFactor& factor, const ModelledTimes& times,
                     const FoundNumbers& found) {
    if (const Finding* beta = found.find("lmm.beta", factor.name)) {
      row(times, found, {factor.name, {}, {}}, nullptr, {}, beta->word);
      return;
    }
    if (found.find("lmm.F", factor.name) == nullptr) return;
    row(times, found, {factor.name, {}, {}}, nullptr, test_of_factor(factor.name, found), {});
    std::optional<std::string> reference{};
    for (const std::string& level : factor.levels) {
      const FindingKey key{factor.name, level};
      const Finding* ratio = found.find("lmm.ratio", key);
      if (ratio == nullptr) {
        // The first level with measurements; those without any have a word in place of β.
        if (!reference && found.find("lmm.beta", key) == nullptr) reference = level;
        continue;
      }
      row(times, found, {factor.name, level, reference ? ResultCell{*reference} : ResultCell{}},
          ratio, {}, {});
    }
  }

  /// `status`: a word in place of the numbers; empty where there are numbers.
  void row(const ModelledTimes& times, const FoundNumbers& found, const EffectName& name,
           const Finding* ratio, const EffectTest& test, const std::string& status) {
    const auto count = [&found](QuantityName quantity) {
      return static_cast<std::int64_t>(found.value(quantity).value_or(0.0));
    };
    table_.add({times.measure, name.factor, name.level, count("n.subjects"), count("n.rows"),
                name.reference, ratio == nullptr ? ResultCell{} : cell_of(ratio->value),
                ratio == nullptr ? ResultCell{} : interval_cell(ratio->low, ratio->high),
                test.statistic(), cell_of(test.p), word_cell(status)});
  }

  ResultTable table_{
      kExplorationModel,
      phrase("Analysis", "Contact times and response times: linear mixed models"),
      {columns::kMeasure, columns::kFactor, columns::kFactorLevel, columns::kPersons,
       columns::kMeasurements, columns::kReference, columns::kRatio, interval_of(columns::kRatio),
       kExplorationStatistic, columns::kP, columns::kStatus},
      {}};
};

/// "Contact time changes by a factor of 0.93 per 10 trials, 95 % CI [0.90, 0.96]."
void add_change_sentence(const ModelledTimes& times, const Phrase& sentence, const Finding* ratio,
                         Phrase& note) {
  if (ratio == nullptr || !ratio->low || !ratio->high) return;
  const int decimals = decimals_of(*ratio->high - *ratio->low);
  const auto digits = [decimals](double value) { return display_signed(value, decimals); };
  note = phrase("Analysis", "%1 %2")
             .with(note, Phrase(sentence).with(times.name, digits(*ratio->value),
                                               digits(*ratio->low), digits(*ratio->high)));
}

void add_sentences(const ExploredRows& rows, const ModelledTimes& times, const FoundNumbers& found,
                   Phrase& note) {
  if (has_ten_trials(rows)) {
    add_change_sentence(times,
                        phrase("Analysis",
                               "%1 changes by a factor of %2 per 10 trials of a block, 95 % CI "
                               "[%3, %4]."),
                        found.find("lmm.ratio", kTrialPlace), note);
  }
  add_change_sentence(
      times,
      phrase("Analysis", "%1 changes by a factor of %2 from block to block, 95 % CI [%3, %4]."),
      found.find("lmm.ratio", kBlockPlace), note);
  add_change_sentence(
      times,
      phrase("Analysis", "%1 changes by a factor of %2 from session to session, 95 % CI [%3, %4]."),
      found.find("lmm.ratio", kSessionPlace), note);
  if (const auto icc = found.value("lmm.icc")) {
    note = phrase("Analysis", "%1 %2: the intraclass correlation is %3.")
               .with(note, times.name, display_bounded(*icc));
  }
  const auto left_out = static_cast<std::size_t>(found.value("n.left_out").value_or(0.0));
  if (left_out > 0) {
    note = phrase("Analysis", "%1 %2: measurements without a time above 0, which are left out: %3.")
               .with(note, times.name, std::to_string(left_out));
  }
}

Phrase note_on_models() {
  return phrase(
      "Analysis",
      "Linear mixed models of the natural logarithms [Laird & Ware, 1982], fitted by restricted "
      "maximum likelihood (REML), with random intercepts of participants; F tests and t-based 95 % "
      "CIs with Satterthwaite’s degrees of freedom [Satterthwaite, 1946]. Ratios: to the reference "
      "level of a condition, per 10 trials of a block, per block or per session. The tests are "
      "exploratory and uncorrected. Tests are liberal and CIs too narrow where participants differ "
      "in these effects, which the models do not include: in simulations of ratings whose effects "
      "varied over participants (SDs of half and one residual SD) the F test had Type I error "
      "rates "
      "of up to 25 and 54 % at α = .05, and the CIs contained the true difference in 68 to 90 % "
      "of the studies. The position in a block is a covariate; its ratio is reported "
      "for "
      "blocks of ten trials or more, because it would otherwise be an extrapolation.");
}

}  // namespace

void add_exploration_models(const GatheredAnswers& gathered, const ExploredRows& surfaces,
                            const ExploredRows& trials, AnalysisOutcome& outcome) {
  ModelTable table{};
  Phrase note = note_on_models();
  const auto add = [&](const ExploredRows& rows, const TimeOfRow& time_s,
                       const ModelledTimes& times) {
    bool has_time = false;
    rows.for_each([&](const ExploredRow& row) { has_time = has_time || time_s(row) > 0.0; });
    if (!has_time) return;
    const std::vector<Finding> findings = analysis_of(
        times.analysis, [&] { return findings_of(model_rows(gathered, rows, time_s)); });
    const FoundNumbers found(findings);
    if (found.find("lmm.status") == nullptr) {  // the family refused the table
      keep_findings(findings, outcome);
      return;
    }
    table.add(rows, times, found);
    add_sentences(rows, times, found, note);
    // Nobody asks whether a time differs from 1 s.
    const bool is_per_ten_trials = has_ten_trials(rows);
    keep_findings(findings, outcome, [is_per_ten_trials](const Finding& finding) {
      if (finding.key == kTrialPlace && !is_per_ten_trials) return false;
      return finding.key != "intercept" || (!is(finding, "lmm.p") && !is(finding, "lmm.t"));
    });
    for (const Finding& finding : findings) {
      if (finding.quantity.ends_with(".p")) outcome.tests_in_tables.insert(name_of(finding));
    }
  };
  add(surfaces,
      [&gathered](const ExploredRow& row) { return gathered.exploration.contact_s(row.surface); },
      {kContactTimeModel, "contact_s", phrase("Analysis", "Contact time")});
  add(trials, [](const ExploredRow& row) { return row.answer.response_time_s; },
      {kResponseTimeModel, "response_s", phrase("Analysis", "Response time")});
  if (!table.empty()) outcome.tables.push_back(table.take(std::move(note)));
}

}  // namespace asperity
