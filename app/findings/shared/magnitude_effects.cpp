// Reports the effects of spacing and condition on estimates.

#include "app/findings/shared/magnitude_effects.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

const ResultColumn kEffectOfFactor{
    .id = "effect", .heading = phrase("AnalysisWords", "effect"), .words = words_of_test};
const ResultColumn kFOfEffect{
    .id = "F", .heading = phrase("AnalysisWords", "F"), .digits = Digits::statistic};
const ResultColumn kGreenhouseGeisser{.id = "epsilon", .heading = phrase("AnalysisWords", "ε")};
const ResultColumn kPartialEtaSquared{.id = "partial_eta_squared",
                                      .heading = phrase("AnalysisWords", "partial η²")};

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
      const Finding* one = found.find("pair.diff", {factor, levels[i], levels[j]});
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
      if (const auto spacing_m = number_in(*name)) *name = display_quantity(*spacing_m, "m");
    }
  }
  const double times = std::pow(10.0, std::abs(*most->value));
  const std::string ratio = fixed(times, 2);
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
  const int decimals = decimals_of(high - low);
  return phrase("Analysis", "%1 was rougher than %2 by a factor of %3 (%4 % CI [%5, %6])")
      .with(names.first, names.second, fixed(times, decimals), fixed(100.0 * *most->confidence, 0),
            fixed(low, decimals), fixed(high, decimals));
}

/// "F(1, 3) = 20.30, partial η² = .87, p = .020, Holm-corrected". Nothing where one of the numbers
/// is absent.
Phrase effect_in_numbers(const std::string& effect, const FoundNumbers& found,
                         const StudyTests::Test& test) {
  const std::optional<double> pes = found.value("pes", effect);
  if (test.degrees.size() != 2 || !test.statistic || !pes) return {};
  return phrase("Analysis", "%1, partial η² = %2, %3")
      .with(statistic_text(test.made_by->symbol, test.degrees, *test.statistic, test.epsilon),
            display_bounded(*pes), p_text(test));
}

Phrase method_of_effect(bool is_corrected, bool states_factor) {
  const Phrase anova = is_corrected
                           ? phrase("Analysis",
                                    "Repeated-measures ANOVA of the log estimates, the degrees of "
                                    "freedom corrected by Greenhouse–Geisser ε.")
                           : phrase("Analysis", "Repeated-measures ANOVA of the log estimates.");
  if (!states_factor) return anova;
  return phrase("Analysis",
                "%1 Roughness ratios are computed from the participants' mean log estimates; the "
                "ratio of two levels has a t-based CI, the ratio of the extremes of several levels "
                "has none.")
      .with(anova);
}

}  // namespace

QuantityName p_of(const FoundNumbers& found, const std::string& effect) {
  return found.find("p.GG", effect) != nullptr ? QuantityName("p.GG") : "p";
}

void add_anova(const FoundNumbers& found, AnalysisOutcome& outcome, const EffectNames& effects) {
  using namespace columns;
  ResultTable table{
      kAnova,
      phrase("Analysis", "Repeated-measures ANOVA of the log estimates"),
      {kEffectOfFactor, kDf1, kDf2, kFOfEffect, kGreenhouseGeisser, kP, kPartialEtaSquared},
      phrase("Analysis",
             "Each participant has a value in every cell; repetitions are averaged. p: "
             "Greenhouse–Geisser-corrected where an effect has more than one degree of freedom.")};
  for (const auto& [name, effect] : effects) {
    const Finding* p = found.find(p_of(found, effect), effect);
    if (p == nullptr) continue;
    for (const QuantityName quantity : std::initializer_list<QuantityName>{"p", "p.GG", "p.HF"}) {
      if (const Finding* of_it = found.find(quantity, effect)) {
        outcome.tests_in_tables.insert(name_of(*of_it));
      }
    }
    table.add({name, found.count("df1", effect), found.count("df2", effect),
               found.cell("F", effect), found.cell("eps.GG", effect), cell_of(p->value),
               found.cell("pes", effect)});
  }
  if (!table.rows.empty()) outcome.tables.push_back(std::move(table));
}

void add_effect_tests(const FoundNumbers& found, std::size_t conditions, const EffectNames& effects,
                      StudyTests& tests) {
  for (const auto& [name, effect] : effects) {
    const bool is_of_condition = std::string_view(effect).starts_with("condition");
    if (conditions < 2 && is_of_condition) continue;
    if (found.find("status") != nullptr) {
      tests.add(name, "", found, "status");
    } else {
      tests.add(name, "", found, p_of(found, effect), effect);
    }
  }
}

void ask_effect(const EffectQuestion& asked, const FoundNumbers& found, const StudyTests& tests,
                AnalysisOutcome& outcome) {
  const auto& [name, question, table, levels, effects] = asked;
  const StudyTests::Test* test = tests.find(name);
  if (test == nullptr || !test->p) return;
  const auto named = std::find_if(effects.begin(), effects.end(), [&](const auto& one) {
    return std::string_view(one.first) == asked.name;
  });
  const std::string effect = named->second;
  Phrase numbers = effect_in_numbers(effect, found, *test);
  if (numbers.empty()) return;
  const Phrase roughest = roughest_of(name, levels, test->is_significant(), found);
  if (!roughest.empty()) numbers = phrase("Analysis", "%1; %2").with(numbers, roughest);
  const TestStatements statements =
      statements_of(*test, {.numbers = phrase("Analysis", "%1.").with(numbers), .exploratory = {}});
  add_question(outcome, name, question, said_of(*test, statements),
               method_of_effect(found.find("p.GG", effect) != nullptr, !roughest.empty()), table,
               found.find("F", effect));
}

}  // namespace asperity
