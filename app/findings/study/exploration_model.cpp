#include "app/findings/study/exploration_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/findings/reading_table.h"
#include "app/findings/study/study_findings.h"

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

bool varies(const NumberColumn& numbers) {
  return std::any_of(numbers.begin(), numbers.end(),
                     [&numbers](const auto& one) { return one != numbers.front(); });
}

/// Whether each row has a level: the model of rows without one would be that of the others alone.
bool is_complete(const TrialFactor& factor) {
  const std::vector<std::size_t>& codes = factor.levels.codes;
  return std::find(codes.begin(), codes.end(), LabelColumn::kMissing) == codes.end();
}

/// The table for the family `lmm`. A time of 0 has no logarithm and is left out: the surface was not touched.
TidyInput model_table(const ExploredRows& rows, NumberColumn times) {
  for (std::optional<double>& time : times) {
    if (time && !(*time > 0.0)) time.reset();
  }
  std::vector<TidyTable::Column> columns{{"subject", rows.people()}, {"y", std::move(times)}};
  std::vector<std::pair<std::string, std::vector<std::string>>> conditions{};
  for (const ExploredFactor& one : rows.factors()) {
    if (!one.is_condition || !is_complete(one.factor)) continue;
    conditions.emplace_back(one.factor.name, one.factor.levels.names);
    columns.push_back({one.factor.name, one.factor.levels});
  }
  std::vector<std::string> covariates{};
  const auto add_place = [&](const char* name, NumberColumn places) {
    if (!varies(places)) return;
    covariates.emplace_back(name);
    columns.push_back({name, std::move(places)});
  };
  add_place(kTrialPlace, rows.trial_places());
  add_place(kBlockPlace, rows.block_places());
  add_place(kSessionPlace, rows.session_places());
  TidyInput input{};
  input.options.set("fixed", conditions);
  input.options.set("covariates", covariates);
  input.options.set("scale", std::string("log"));
  input.tables.emplace_back(std::move(columns), "the explored surfaces");
  return input;
}

/// The numbers of one effect, as cells of the table.
struct EffectTest {
  Cell F{};
  Cell df1{};
  Cell df2{};
  Cell p{};
};

EffectTest test_of_factor(const std::string& name, const FoundNumbers& found) {
  return {found.cell("lmm.F", name), found.cell("lmm.F.df1", name), found.cell("lmm.F.df2", name),
          found.cell("lmm.F.p", name)};
}

/// F = t² with one degree of freedom.
EffectTest test_of_place(const std::string& name, const FoundNumbers& found) {
  const std::optional<double> t = found.value("lmm.t", name);
  return {t ? Cell{*t * *t} : Cell{}, t ? Cell{1.0} : Cell{}, found.cell("lmm.df", name),
          found.cell("lmm.p", name)};
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
      if (one.is_condition) add_condition(one.factor, times, found);
    }
    for (const char* const place : {kTrialPlace, kBlockPlace, kSessionPlace}) {
      const Finding* beta = found.find("lmm.beta", place);
      if (beta == nullptr) continue;
      row(times, found, {place, {}, {}}, found.find("lmm.ratio", place),
          test_of_place(place, found), beta->word);
    }
  }
  bool empty() const { return table_.table.rows.empty(); }
  NamedTable take(Phrase note) {
    drop_empty_columns(table_.table, 5);
    table_.note = std::move(note);
    return std::move(table_);
  }

 private:
  struct EffectName {
    std::string factor{};
    Cell level{};
    Cell reference{};
  };

  void add_condition(const TrialFactor& factor, const ModelledTimes& times,
                     const FoundNumbers& found) {
    if (const Finding* beta = found.find("lmm.beta", factor.name)) {
      row(times, found, {factor.name, {}, {}}, nullptr, {}, beta->word);
      return;
    }
    if (found.find("lmm.F", factor.name) == nullptr) return;
    row(times, found, {factor.name, {}, {}}, nullptr, test_of_factor(factor.name, found), {});
    std::optional<std::string> reference{};
    for (const std::string& level : factor.levels.names) {
      const std::string key = factor.name + '|' + level;
      const Finding* ratio = found.find("lmm.ratio", key);
      if (ratio == nullptr) {
        // The first level with measurements; those without any have a word in place of β.
        if (!reference && found.find("lmm.beta", key) == nullptr) reference = level;
        continue;
      }
      row(times, found, {factor.name, level, reference ? Cell{*reference} : Cell{}}, ratio, {}, {});
    }
  }

  /// `status`: a word in place of the numbers; empty where there are numbers.
  void row(const ModelledTimes& times, const FoundNumbers& found, const EffectName& name,
           const Finding* ratio, const EffectTest& test, const std::string& status) {
    const auto count = [&found](const char* quantity) {
      return static_cast<std::int64_t>(found.value(quantity).value_or(0.0));
    };
    const auto cell = [ratio](const std::optional<double> Finding::*of) {
      return ratio == nullptr ? Cell{} : cell_of(ratio->*of);
    };
    table_.table.rows.push_back(
        {std::string(times.measure), name.factor, name.level, count("n.subjects"), count("n.rows"),
         name.reference, cell(&Finding::value), cell(&Finding::low), cell(&Finding::high), test.F,
         test.df1, test.df2, test.p, status.empty() ? Cell{} : Cell{status}});
  }

  NamedTable table_{kExplorationModel,
                    phrase("Analysis", "Contact times and response times: linear mixed models"),
                    {{"measure", "factor", "level", "persons", "measurements", "reference", "ratio",
                      "ratio_low", "ratio_high", "F", "df1", "df2", "p", "status"},
                     {}},
                    {}};
};

/// "Contact time changes by a factor of 0.93 per 10 trials, 95 % CI [0.90, 0.96]."
void add_change_sentence(const ModelledTimes& times, const Phrase& sentence, const Finding* ratio,
                         Phrase& note) {
  if (ratio == nullptr || !ratio->low || !ratio->high) return;
  const auto digits = [](double value) { return reading_signed(value, 2); };
  note = phrase("Analysis", "%1 %2")
             .with(note, Phrase(sentence).with(times.name, digits(*ratio->value),
                                               digits(*ratio->low), digits(*ratio->high)));
}

void add_sentences(const ModelledTimes& times, const FoundNumbers& found, Phrase& note) {
  add_change_sentence(times,
                      phrase("Analysis",
                             "%1 changes by a factor of %2 per 10 trials of a block, 95 % CI "
                             "[%3, %4]."),
                      found.find("lmm.ratio", kTrialPlace), note);
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
               .with(note, times.name, reading_bounded(*icc));
  }
  const auto left_out = static_cast<std::size_t>(found.value("n.left_out").value_or(0.0));
  if (left_out > 0) {
    note = phrase("Analysis", "%1 %2: left out without a time above 0: %3.")
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
      "exploratory and uncorrected; they are liberal where participants differ in these effects, "
      "which the models do not include.");
}

}  // namespace

void add_exploration_models(const ExploredRows& surfaces, const ExploredRows& trials,
                            AnalysisOutcome& outcome) {
  ModelTable table{};
  Phrase note = note_on_models();
  const auto add = [&](const ExploredRows& rows, NumberColumn column, const ModelledTimes& times) {
    const bool has_time = std::any_of(column.begin(), column.end(),
                                      [](const auto& time) { return time && *time > 0.0; });
    if (!has_time) return;
    const std::vector<Finding> findings =
        analysis_of(times.analysis, "lmm", model_table(rows, std::move(column)));
    const FoundNumbers found(findings);
    if (found.find("lmm.status") == nullptr) {  // the family refused the table
      keep_findings(findings, outcome);
      return;
    }
    table.add(rows, times, found);
    add_sentences(times, found, note);
    // Nobody asks whether a time differs from 1 s.
    keep_findings(findings, outcome, [](const Finding& finding) {
      return finding.key != "intercept" ||
             (finding.quantity != "lmm.p" && finding.quantity != "lmm.t");
    });
    for (const Finding& finding : findings) {
      if (finding.quantity.ends_with(".p")) outcome.tests_in_tables.insert(name_of(finding));
    }
  };
  add(surfaces, surfaces.quantity(&SessionAnswers::Exploration::contact_s),
      {kContactTimeModel, "contact_s", phrase("Analysis", "Contact time")});
  add(trials, trials.response_times(),
      {kResponseTimeModel, "response_s", phrase("Analysis", "Response time")});
  if (!table.empty()) outcome.tables.push_back(table.take(std::move(note)));
}

}  // namespace asperity
