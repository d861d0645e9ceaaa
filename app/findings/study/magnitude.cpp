// Magnitude estimation: perceived roughness by spacing and by the condition that is constant within
// a block.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/answer_columns.h"
#include "app/findings/study/kinds/magnitude_analysis.h"
#include "app/findings/study/repetition_reliability.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/test_sentences.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kAnova = "anova";
// The condition of all estimates where a protocol has none.
constexpr const char* kOneCondition = "all";

/// One estimate with the names of its factors' levels as in the tables.
struct Estimated {
  std::uint32_t person = 0;
  std::string condition{};
  std::string spacing{};  ///< metres
  int repetition = 1;
  double estimate = 0.0;
};

std::vector<Estimated> estimates_in(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Estimated> estimates{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<double> spacing_m = gathered.spacing_m(answer);
    const std::optional<double> estimate =
        number_in(gathered.word(gathered.reply_of(answer).answer));
    if (!spacing_m || !estimate || *spacing_m <= 0.0 || *estimate <= 0.0) continue;
    const std::string& condition = gathered.word(answer.column);
    estimates.push_back({.person = answer.person,
                         .condition = condition.empty() ? kOneCondition : condition,
                         .spacing = number_text(*spacing_m),
                         .repetition = answer.repetition,
                         .estimate = *estimate});
  }
  const std::size_t left_out = gathered.answers.size() - estimates.size();
  if (left_out > 0) {
    outcome.remarks.push_back(phrase("Analysis",
                                     "Responses left out because they are not numbers above 0, or "
                                     "because the protocol does not state their spacing: %1.")
                                  .with(std::to_string(left_out)));
  }
  if (gathered.count.anchors > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Estimates of anchors, which are not analysed: %1.")
            .with(std::to_string(gathered.count.anchors)));
  }
  return estimates;
}

/// In ascending numerical order, followed by levels that are not numbers.
std::vector<std::string> levels_of(const std::vector<Estimated>& estimates,
                                   std::string Estimated::*name) {
  std::vector<std::string> levels{};
  for (const Estimated& one : estimates) levels.push_back(one.*name);
  std::sort(levels.begin(), levels.end(), [](const std::string& a, const std::string& b) {
    const auto first = number_in(a);
    const auto second = number_in(b);
    if (first.has_value() != second.has_value()) return first.has_value();
    return first && second ? *first < *second : a < b;
  });
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

/// In the protocol's order; conditions that it does not list come last.
std::vector<std::string> conditions_of(const std::vector<Estimated>& estimates,
                                       const std::vector<std::string>& declared) {
  std::vector<std::string> conditions = levels_of(estimates, &Estimated::condition);
  std::stable_sort(conditions.begin(), conditions.end(),
                   [&declared](const std::string& one, const std::string& other) {
                     return std::find(declared.begin(), declared.end(), one) <
                            std::find(declared.begin(), declared.end(), other);
                   });
  return conditions;
}

/// The names of two of the columns: that of the conditions and that of the values.
struct EstimateColumns {
  const char* condition = "";
  const char* value = "";
};

TidyTable estimates_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                          const EstimateColumns& names, double (*value_of)(double)) {
  LabelRows subjects{};
  LabelRows conditions{};
  LabelRows spacings{};
  NumberColumn values{};
  for (const Estimated& one : estimates) {
    subjects.add(gathered.people[one.person].label);
    conditions.add(one.condition);
    spacings.add(one.spacing);
    values.push_back(value_of(one.estimate));
  }
  return {std::vector<TidyTable::Column>{{"subject", std::move(subjects).take()},
                                         {names.condition, std::move(conditions).take()},
                                         {"spacing", std::move(spacings).take()},
                                         {names.value, std::move(values)}},
          "the estimates"};
}

TidyInput curves_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates) {
  TidyInput input{};
  input.tables.push_back(estimates_table(gathered, estimates, {"probe", "estimate"},
                                         [](double estimate) { return estimate; }));
  input.options.set("zero_rule", std::string("exclude"));
  input.options.set("normalisation", std::string("geomean"));
  return input;
}

/// Raw logarithms: a participant's scale is a constant and part of no effect.
TidyInput anova_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                      const std::vector<std::string>& conditions,
                      const std::vector<std::string>& spacings) {
  TidyInput input{};
  input.tables.push_back(estimates_table(gathered, estimates, {"condition", "y"},
                                         [](double estimate) { return std::log10(estimate); }));
  std::vector<std::pair<std::string, std::vector<std::string>>> within{};
  if (conditions.size() > 1) within.emplace_back("condition", conditions);
  within.emplace_back("spacing", spacings);
  input.options.set("within", within);
  return input;
}

std::string cell_key(const std::string& condition, const std::string& spacing) {
  return condition + '|' + spacing;
}

/// By condition and spacing: logarithms of the estimates of each participant.
using Cells = std::map<std::tuple<std::uint32_t, std::string, std::string>, std::vector<double>>;

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void add_estimates(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                   const std::vector<std::string>& conditions,
                   const std::vector<std::string>& spacings, const FoundNumbers& found,
                   AnalysisOutcome& outcome) {
  Cells cells{};
  for (const Estimated& one : estimates) {
    cells[{one.person, one.condition, one.spacing}].push_back(std::log10(one.estimate));
  }
  NamedTable curves{
      kRoughness,
      phrase("Analysis", "Roughness by spacing and condition"),
      {{"condition", "spacing_m", "persons", "left_out", "normalised", "normalised_low",
        "normalised_high", "raw"},
       {}},
      phrase("Analysis",
             "Geometric means of the estimates. normalised: each participant's scale removed (the "
             "mean of the logarithms of all cells). raw: not normalised. left out: number of "
             "participants without an estimate in some cell; only raw includes them.")};
  if (gathered.people.size() > 1) {
    curves.note =
        phrase(
            "Analysis",
            "%1 The CI of the normalised mean is a within-participant CI (Cousineau and Morey): it "
            "serves to compare cells and does not include the differences between participants.")
            .with(curves.note);
  }
  NamedTable persons{
      kEstimatesOfPersons,
      phrase("Analysis", "Estimates of each participant"),
      {{"person", "condition", "spacing_m", "answers", "raw", "normalised"}, {}},
      phrase("Analysis",
             "Geometric means over repetitions. The estimates of participants with an empty cell "
             "are not normalised and are left out of curves and tests.")};
  for (const std::string& condition : conditions) {
    for (const std::string& spacing : spacings) {
      std::vector<double> raw{};
      for (std::uint32_t person = 0; person < gathered.people.size(); ++person) {
        const auto cell = cells.find({person, condition, spacing});
        if (cell == cells.end()) continue;
        raw.push_back(mean_of(cell->second));
        const std::string& label = gathered.people[person].label;
        persons.table.rows.push_back(
            {label, condition, *number_in(spacing), static_cast<std::int64_t>(cell->second.size()),
             std::pow(10.0, raw.back()),
             found.cell("norm.estimate", label + '|' + cell_key(condition, spacing))});
      }
      if (raw.empty()) continue;
      const std::string cell = cell_key(condition, spacing);
      const auto [low, high] = found.interval("geomean", cell);
      const Finding* mean = found.find("geomean", cell);
      const std::size_t counted = mean == nullptr || !mean->value ? 0 : mean->n;
      curves.table.rows.push_back(
          {condition, *number_in(spacing), static_cast<std::int64_t>(raw.size()),
           static_cast<std::int64_t>(raw.size() - std::min(counted, raw.size())),
           found.cell("geomean", cell), low, high, std::pow(10.0, mean_of(raw))});
    }
  }
  outcome.tables.push_back(std::move(curves));
  outcome.tables.push_back(std::move(persons));
}

/// A count, which is displayed without decimals.
Cell whole_cell(const FoundNumbers& found, const char* quantity, const std::string& key) {
  const std::optional<double> value = found.value(quantity, key);
  return value ? Cell{static_cast<std::int64_t>(std::llround(*value))} : Cell{};
}

/// An interval that contains every tested spacing does not locate the peak.
constexpr const char* kTooFew = "too_few_to_say";
/// The test for an interior maximum is not significant.
constexpr const char* kNoInterior = "no_interior_maximum";
constexpr const char* kNotBoth = "at least one condition has no interior maximum";

bool has_interior_maximum(const FoundNumbers& found, const std::string& condition) {
  const Finding* significant = found.find("invU.significant", condition);
  return significant != nullptr && significant->word == "TRUE";
}

/// The status of the peak of a condition: "ok", or why none is reported.
std::string peak_status(const FoundNumbers& found, const std::string& condition,
                        const std::vector<std::string>& spacings) {
  const Finding* status = found.find("peak.status", condition);
  if (status == nullptr) return {};
  const Finding* peak = found.find("peak", condition);
  if (peak == nullptr) return status->word;
  const bool says_nothing = peak->low && peak->high && *peak->low < *number_in(spacings.front()) &&
                            *peak->high > *number_in(spacings.back());
  if (says_nothing) return kTooFew;
  return has_interior_maximum(found, condition) ? status->word : kNoInterior;
}

void add_peaks(const std::vector<std::string>& conditions, const std::vector<std::string>& spacings,
               const FoundNumbers& found, AnalysisOutcome& outcome) {
  NamedTable peaks{
      "peaks",
      phrase("Analysis", "Spacing of maximum roughness: one parabola per condition"),
      {{"condition", "status", "peak_m", "peak_m_low", "peak_m_high", "fieller_m_low",
        "fieller_m_high", "height", "descending", "inverted_u", "other", "p_interior", "r_squared"},
       {}},
      phrase(
          "Analysis",
          "Parabolas of the logarithms over the logarithm of the spacing, one per participant; "
          "the maximum is that of their mean, with CIs by the delta method and by Fieller's "
          "method. It is reported where the test for an interior maximum (Lind and Mehlum: the "
          "mean curve rises at the smallest and falls at the largest spacing, one-sided t tests "
          "over participants, the larger p) has p < .05. R²: fit of the mean parabola to the cell "
          "means. “Descending”, “inverted U” and “other” count the participants' own curves.")};
  for (const std::string& condition : conditions) {
    const std::string status = peak_status(found, condition, spacings);
    if (status.empty()) continue;
    const bool is_told = status != kTooFew && status != kNoInterior;
    const auto [low, high] = found.interval("peak", condition);
    const auto told = [&](const char* quantity) {
      return is_told ? found.cell(quantity, condition) : Cell{};
    };
    peaks.table.rows.push_back(
        {condition, status == "ok" ? Cell{} : Cell{status}, told("peak"), is_told ? low : Cell{},
         is_told ? high : Cell{}, told("peak.fieller.lower"), told("peak.fieller.upper"),
         told("peak.height"), whole_cell(found, "curve.descending", condition),
         whole_cell(found, "curve.inverted_u", condition),
         whole_cell(found, "curve.other", condition), found.cell("invU.p", condition),
         found.cell("pooled.quad.r2", condition)});
  }
  if (!peaks.table.rows.empty()) outcome.tables.push_back(std::move(peaks));
  NamedTable shifts{"peak_ratios",
                    phrase("Analysis", "Ratios of the peaks"),
                    {{"first", "second", "ratio", "ratio_low", "ratio_high", "p", "status"}, {}},
                    phrase("Analysis",
                           "Ratio of the spacing of the first peak to that of the second, with the "
                           "same participants in both; delta method. p is uncorrected.")};
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (std::size_t j = i + 1; j < conditions.size(); ++j) {
      for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
        const std::string key = conditions[a] + '|' + conditions[b];
        if (found.find("peakratio", key) == nullptr) continue;
        if (const Finding* p = found.find("peakratio.p", key)) {
          outcome.tests_in_tables.insert(name_of(*p));
        }
        std::vector<Cell>& row =
            shifts.table.rows.emplace_back(std::vector<Cell>{conditions[a], conditions[b]});
        if (has_interior_maximum(found, conditions[a]) &&
            has_interior_maximum(found, conditions[b])) {
          const auto [low, high] = found.interval("peakratio", key);
          row.insert(row.end(), {found.cell("peakratio", key), low, high,
                                 found.cell("peakratio.p", key), Cell{}});
        } else {
          row.resize(shifts.table.columns.size());
          row.back() = kNotBoth;
        }
      }
    }
  }
  if (!shifts.table.rows.empty()) outcome.tables.push_back(std::move(shifts));
}

/// With the Greenhouse–Geisser correction, where it applies.
const char* p_of(const FoundNumbers& found, const std::string& effect) {
  return found.find("p.GG", effect) != nullptr ? "p.GG" : "p";
}

constexpr std::array<std::pair<const char*, const char*>, 3> kEffects{
    {{"condition", "condition"}, {"spacing", "spacing"}, {"interaction", "condition:spacing"}}};

void add_anova(const FoundNumbers& found, AnalysisOutcome& outcome) {
  NamedTable table{
      kAnova,
      phrase("Analysis", "Analysis of variance of the logarithms"),
      {{"effect", "df1", "df2", "F", "epsilon", "p", "partial_eta_squared"}, {}},
      phrase("Analysis",
             "Each participant has a value in every cell; replicates are averaged. p: "
             "Greenhouse–Geisser-corrected where an effect has more than one degree of freedom.")};
  for (const auto& [name, effect] : kEffects) {
    const Finding* p = found.find(p_of(found, effect), effect);
    if (p == nullptr) continue;
    for (const char* quantity : {"p", "p.GG", "p.HF"}) {
      if (const Finding* of_it = found.find(quantity, effect)) {
        outcome.tests_in_tables.insert(name_of(*of_it));
      }
    }
    table.table.rows.push_back({name, whole_cell(found, "df1", effect),
                                whole_cell(found, "df2", effect), found.cell("F", effect),
                                found.cell("eps.GG", effect), cell_of(p->value),
                                found.cell("pes", effect)});
  }
  if (!table.table.rows.empty()) outcome.tables.push_back(std::move(table));
}

/// Which of the levels of a factor was felt as the roughest and which as the least rough, by the
/// participants' mean logarithms, where the difference is significant (`shows`); for two levels
/// with the interval of their ratio, in any case. Nothing where they are equal.
Phrase roughest_of(const char* factor, const std::vector<std::string>& levels, bool shows,
                   const FoundNumbers& found) {
  // Of several levels one is always the greatest, even without an effect.
  if (levels.size() > 2 && !shows) return {};
  const Finding* most = nullptr;
  std::pair<std::string, std::string> names{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      const Finding* one = found.find("pair.diff", both(factor, both(levels[i], levels[j])));
      if (one == nullptr || !one->value) continue;
      if (most != nullptr && std::abs(*one->value) <= std::abs(*most->value)) continue;
      most = one;
      names = {levels[i], levels[j]};
    }
  }
  if (most == nullptr || *most->value == 0.0) return {};
  const bool is_turned = *most->value < 0.0;
  if (is_turned) std::swap(names.first, names.second);
  if (std::string_view(factor) == "spacing") {
    for (std::string* name : {&names.first, &names.second}) {
      if (const auto spacing_m = number_in(*name)) *name = reading_quantity(*spacing_m, "m");
    }
  }
  const std::string ratio = fixed(std::pow(10.0, std::abs(*most->value)), 2);
  if (levels.size() > 2) {
    return phrase("Analysis", "%1 was roughest and %2 least rough (ratio of geometric means: %3)")
        .with(names.first, names.second, ratio);
  }
  if (!most->low || !most->high || !most->confidence) {
    return phrase("Analysis", "%1 was rougher than %2 by a factor of %3")
        .with(names.first, names.second, ratio);
  }
  const double low = std::pow(10.0, is_turned ? -*most->high : *most->low);
  const double high = std::pow(10.0, is_turned ? -*most->low : *most->high);
  return phrase("Analysis", "%1 was rougher than %2 by a factor of %3 (%4 CI [%5, %6])")
      .with(names.first, names.second, ratio, percent(*most->confidence), fixed(low, 2),
            fixed(high, 2));
}

/// "F(1, 3) = 20.30, partial η² = .87, p = .020, Holm-corrected". Nothing where one of the numbers
/// is absent.
Phrase effect_in_numbers(const std::string& effect, const FoundNumbers& found,
                         const StudyTests::Test& test) {
  const std::optional<double> pes = found.value("pes", effect);
  if (test.degrees.size() != 2 || !test.statistic || !pes) return {};
  return phrase("Analysis", "%1, partial η² = %2, %3")
      .with(statistic_text(test.made_by->symbol, test.degrees, *test.statistic, test.epsilon),
            reading_bounded(*pes), p_text(test));
}

Phrase method_of_effect(bool is_corrected, bool states_factor) {
  const Phrase anova = is_corrected
                           ? phrase("Analysis",
                                    "Repeated-measures ANOVA of the logarithms, the degrees of "
                                    "freedom corrected by Greenhouse–Geisser ε.")
                           : phrase("Analysis", "Repeated-measures ANOVA of the logarithms.");
  if (!states_factor) return anova;
  return phrase("Analysis",
                "%1 Roughness ratios are computed from the participants' mean logarithms; the "
                "ratio of two levels has a t-based CI, the ratio of the extremes of several levels "
                "has none.")
      .with(anova);
}

/// `levels`: of the factor, whose order of roughness is reported; empty where there is none.
void ask_effect(const char* name, const Phrase& question, const char* table,
                const std::vector<std::string>& levels, const FoundNumbers& found,
                const StudyTests& tests, AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find(name);
  if (test == nullptr || !test->p) return;
  const std::string effect =
      std::string_view(name) == "interaction" ? "condition:spacing" : std::string(name);
  Phrase numbers = effect_in_numbers(effect, found, *test);
  if (numbers.empty()) return;
  const Phrase roughest = roughest_of(name, levels, test->shows(), found);
  if (!roughest.empty()) numbers = phrase("Analysis", "%1; %2").with(numbers, roughest);
  const Sayings sayings{phrase("Analysis", "Yes: %1.").with(numbers),
                        phrase("Analysis", "Not significantly: %1.").with(numbers),
                        phrase("Analysis", "%1.").with(numbers)};
  add_question(outcome, name, question, said_of(*test, sayings),
               method_of_effect(found.find("p.GG", effect) != nullptr, !roughest.empty()), table,
               found.find("F", effect));
}

void ask_peaks(const std::vector<std::string>& conditions, const std::vector<std::string>& spacings,
               const FoundNumbers& found, AnalysisOutcome& outcome) {
  Phrase answer{};
  const Finding* first = nullptr;
  for (const std::string& condition : conditions) {
    const Finding* peak = found.find("peak", condition);
    const Finding* status = found.find("peak.status", condition);
    if (status == nullptr) continue;
    if (first == nullptr) first = peak != nullptr ? peak : status;
    Phrase one{};
    if (peak_status(found, condition, spacings) == kTooFew) {
      one = phrase("Analysis",
                   "%1 cannot be determined, because with %2 participants its CI is wider than the "
                   "range of the tested spacings")
                .with(condition, std::to_string(peak->n));
    } else if (peak_status(found, condition, spacings) == kNoInterior) {
      const std::optional<double> p = found.value("invU.p", condition);
      one = p ? phrase("Analysis", "%1 without a significant interior maximum (%2)")
                    .with(condition, reading_p(*p))
              : phrase("Analysis",
                       "%1 without a test for an interior maximum, because the "
                       "participants do not differ")
                    .with(condition);
    } else if (peak != nullptr && peak->value && peak->low && peak->high) {
      one = phrase("Analysis",
                   "%1 at %2 (95 % CI [%3, %4]; test for an interior maximum %5; "
                   "R² of the mean parabola %6)")
                .with(condition, reading_quantity(*peak->value, "m"),
                      reading_quantity(*peak->low, "m"), reading_quantity(*peak->high, "m"),
                      reading_p(found.value("invU.p", condition).value_or(1.0)),
                      reading_bounded(found.value("pooled.quad.r2", condition).value_or(0.0)));
    } else if (status->word == "outside_range") {
      one = phrase("Analysis", "%1 outside the range of the tested spacings").with(condition);
    } else {
      one = phrase("Analysis", "%1 without a peak, because the parabola opens upwards")
                .with(condition);
    }
    answer = answer.empty() ? one : phrase("Analysis", "%1; %2").with(answer, one);
  }
  if (answer.empty()) return;
  add_question(
      outcome, "peaks", phrase("Analysis", "Which spacing is judged roughest?"),
      phrase("Analysis", "Peaks of the curves: %1.").with(answer),
      phrase("Analysis",
             "The maximum of the mean of the participants' parabolas, in logarithms; CI by the "
             "delta method. It is reported where the test for an interior maximum by Lind and "
             "Mehlum is significant: the mean curve rises at the smallest and falls at the largest "
             "spacing."),
      "peaks", first);
}

/// Whether any two conditions have their peaks at different spacings.
void ask_peak_ratios(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome) {
  Phrase answer{};
  const Finding* first = nullptr;
  for (const StudyTests::Test& test : tests.tests()) {
    if (test.name != "peaks" || !test.p || test.degrees.empty() || !test.statistic) continue;
    const Finding* ratio = found.find("peakratio", test.about);
    if (ratio == nullptr || !ratio->value || !ratio->low || !ratio->high) continue;
    const std::size_t bar = test.about.find('|');
    const Phrase numbers =
        phrase("Analysis",
               "the peak of %1 is at %2 times the spacing of the peak of %3 (95 % CI [%4, %5])")
            .with(test.about.substr(0, bar), fixed(*ratio->value, 2), test.about.substr(bar + 1),
                  fixed(*ratio->low, 2), fixed(*ratio->high, 2));
    const Phrase one =
        phrase("Analysis", "%1, %2, %3")
            .with(numbers, statistic_text("t", test.degrees, *test.statistic), p_text(test));
    answer = answer.empty() ? one : phrase("Analysis", "%1; %2").with(answer, one);
    if (first == nullptr) first = ratio;
  }
  if (answer.empty()) return;
  add_question(outcome, "peak_ratios",
               phrase("Analysis", "Do the conditions differ in the spacing judged roughest?"),
               phrase("Analysis", "Ratios of the peaks: %1.").with(answer),
               phrase("Analysis",
                      "The ratio of the peaks of two conditions that both have an interior "
                      "maximum, with a t-based CI over participants on the logarithmic scale."),
               "peaks", first);
}

void ask_types(const std::vector<std::string>& conditions, const FoundNumbers& found,
               AnalysisOutcome& outcome) {
  constexpr std::array kTypes{"curve.descending", "curve.inverted_u", "curve.other"};
  std::array<double, 3> counts{};
  for (const std::string& condition : conditions) {
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
      counts[i] += found.value(kTypes[i], condition).value_or(0.0);
    }
  }
  if (counts[0] + counts[1] + counts[2] <= 0.0) return;
  add_question(
      outcome, "types", phrase("Analysis", "Which shapes do the participants' own curves have?"),
      phrase("Analysis",
             "Shapes of the participants' curves, all conditions together: descending %1, inverted "
             "U %2, other %3.")
          .with(fixed(counts[0], 0), fixed(counts[1], 0), fixed(counts[2], 0)),
      phrase("Analysis",
             "The shape is determined by the slopes of each participant's own parabola at the "
             "smallest and the largest spacing; there is no test."),
      "peaks", found.find(kTypes[0], conditions.front()));
}

}  // namespace

void analyze_magnitude(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Estimated> estimates = estimates_in(gathered, outcome);
  if (estimates.empty()) return;
  const std::vector<std::string> conditions =
      conditions_of(estimates, gathered.estimation.conditions);
  // Findings, tables and figures list the conditions in one order, independent of the order of
  // sessions.
  std::stable_sort(estimates.begin(), estimates.end(),
                   [&conditions](const Estimated& one, const Estimated& other) {
                     const auto place = [&conditions](const Estimated& estimate) {
                       return std::find(conditions.begin(), conditions.end(), estimate.condition);
                     };
                     return place(one) < place(other);
                   });
  const std::vector<std::string> spacings = levels_of(estimates, &Estimated::spacing);
  const std::vector<Finding> roughness =
      analysis_of(kRoughness, "magnitude", curves_table(gathered, estimates));
  const std::vector<Finding> anova =
      analysis_of(kAnova, "rmanova", anova_table(gathered, estimates, conditions, spacings));
  const FoundNumbers found(roughness);
  const FoundNumbers found_anova(anova);
  add_estimates(gathered, estimates, conditions, spacings, found, outcome);
  add_peaks(conditions, spacings, found, outcome);
  add_anova(found_anova, outcome);
  if (const Finding* incomplete = found.find("subjects.incomplete");
      incomplete != nullptr && incomplete->word != "none") {
    std::string names{};
    for (const char sign : incomplete->word) names += sign == ';' ? ", " : std::string(1, sign);
    outcome.remarks.push_back(
        phrase("Analysis",
               "Participants with an empty cell, who are left out of curves and tests: %1.")
            .with(names));
  }
  if (const Finding* replicates = found_anova.find("replicates");
      replicates != nullptr && replicates->word == "unequal") {
    std::size_t least = 0;
    std::size_t greatest = 0;
    for (const Finding* cells : found_anova.all("cells.with.k")) {
      const auto k = static_cast<std::size_t>(number_in(cells->key).value_or(0.0));
      least = least == 0 ? k : std::min(least, k);
      greatest = std::max(greatest, k);
    }
    outcome.remarks.push_back(phrase("Analysis",
                                     "The participants' cells contain %1 to %2 estimates; each "
                                     "cell is averaged first, so that all cells have equal weight.")
                                  .with(std::to_string(least), std::to_string(greatest)));
  }
  StudyTests tests(gathered);
  for (const auto& [name, effect] : kEffects) {
    if (conditions.size() < 2 && std::string_view(name) != "spacing") continue;
    if (found_anova.find("status") != nullptr) {
      tests.add(name, "", found_anova, "status");
    } else {
      tests.add(name, "", found_anova, p_of(found_anova, effect), effect);
    }
  }
  for (const Finding* ratio : found.all("peakratio.p")) {
    const std::size_t bar = ratio->key.find('|');
    const bool has_both = has_interior_maximum(found, ratio->key.substr(0, bar)) &&
                          has_interior_maximum(found, ratio->key.substr(bar + 1));
    if (has_both) {
      tests.add("peaks", ratio->key, found, ratio->quantity, ratio->key);
    } else {
      tests.add_untested("peaks", ratio->key, kNotBoth);
    }
  }
  tests.finish(outcome);
  ask_effect("spacing", phrase("Analysis", "Does roughness depend on the spacing?"), kRoughness,
             spacings, found_anova, tests, outcome);
  ask_effect("condition", phrase("Analysis", "Does roughness depend on the condition?"), kAnova,
             conditions, found_anova, tests, outcome);
  ask_effect("interaction",
             phrase("Analysis", "Does the curve over spacings depend on the condition?"), kAnova,
             {}, found_anova, tests, outcome);
  ask_peaks(conditions, spacings, found, outcome);
  ask_peak_ratios(found, tests, outcome);
  ask_types(conditions, found, outcome);
  std::vector<RepeatedEstimate> repeated{};
  for (const Estimated& one : estimates) {
    repeated.push_back({.person = one.person,
                        .surface = cell_key(one.condition, one.spacing),
                        .repetition = one.repetition,
                        .logarithm = std::log10(one.estimate)});
  }
  ask_reliability_of_estimates(gathered, repeated, outcome);
  keep_findings(roughness, outcome);
  keep_findings(anova, outcome);
}

}  // namespace asperity
