// Chooses the claim by significance and sign, and qualifies it by role, interval and attainable p.

#include "app/findings/outcome/test_sentences.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// "the ratings differed between the items", from "The ratings differed significantly …".
std::string plain_claim(std::string claim, bool is_significant) {
  constexpr std::string_view kSignificantly = "significantly ";
  const std::size_t at = is_significant ? claim.find(kSignificantly) : std::string::npos;
  if (at != std::string::npos) claim.erase(at, kSignificantly.size());
  if (!claim.empty() && claim.front() >= 'A' && claim.front() <= 'Z') {
    claim.front() = static_cast<char>(claim.front() - 'A' + 'a');
  }
  return claim;
}

/// The claim as it is, "In an exploratory test, the ratings differed …", or "It was not established that …".
std::string qualified_claim(const StudyTest& test, const std::string& claim) {
  const bool is_confirmatory = test.role == TestRole::confirmatory;
  if (test.contradicts_interval()) {
    return std::string(is_confirmatory ? "It" : "In an exploratory test, it") +
           " was not established that " + plain_claim(claim, true);
  }
  if (is_confirmatory) return claim;
  return "In an exploratory test, " + plain_claim(claim, test.is_significant());
}

std::string claim_of(const StudyTest& test, std::string_view kind) {
  const StudyAnalysis* const analysis = find_analysis(kind);
  if (analysis == nullptr) return {};
  const auto claim = std::find_if(
      analysis->claims.begin(), analysis->claims.end(), [&test](const TestClaim& each) {
        return each.test == test.name && (each.method.empty() || each.method == test.made_by->code);
      });
  if (claim == analysis->claims.end()) return {};
  const bool is_negative = test.direction() < 0.0 && !claim->lower.empty();
  const std::string_view words = !test.is_significant() ? claim->nothing
                                 : is_negative          ? claim->lower
                                                        : claim->higher;
  const auto& [of, one, second] = test.about;
  const bool is_pair_of_scale = !of.empty() && !one.empty();
  const std::string on_scale = is_pair_of_scale ? " on the scale “" + of + "”" : "";
  const std::string of_these = is_pair_of_scale ? " (" + words_of_condition(of) + ')' : "";
  const std::string& first = one.empty() ? of : one;
  const std::string chance = !test.chance ? ""
                                          : " of " + display_percent(*test.chance) +
                                                (test.chance_varies ? " on average" : "");
  const std::string chosen = qualified_claim(test, std::string(words));
  std::string named = test.name == "properties" ? words_of_property(first).english() : first;
  // The predictor: a parameter, or a property, whose unit follows a comma.
  if (test.name == "exponent") named = words_of_subject(first).english();
  for (const std::string_view unit : {", N", ", m/s"}) {
    if (test.name == "exponent" && named.ends_with(unit)) named.erase(named.size() - unit.size());
  }
  return Phrase(chosen).with(named, second, chance, on_scale, of_these).english();
}

std::string size_text(const StudyTest& test) {
  const std::string n = display_count(test.n);
  if (test.unit == kUnitOfParticipants) {
    std::vector<std::string> without{};
    if (test.left_out > 0) without.push_back(count_in_words(test.left_out) + " left out");
    if (test.ties > 0) {
      without.push_back(count_in_words(test.ties) + " with a difference of zero left out");
    }
    return "N = " + n + (without.empty() ? "" : " (" + listed(without) + ')');
  }
  return "n = " + words_of_count(test.n, test.unit).english();
}

std::string estimate_text(const StudyTest& test) {
  if (!test.estimate) return {};
  std::string text(test.made_by->estimate_name);
  text += " = " + display_percent(test.estimate->value);
  if (test.estimate->low && test.estimate->high) {
    text += ", 95 % CI [" + display_percent(*test.estimate->low) + ", " +
            display_percent(*test.estimate->high) + ']';
  }
  return text + ", " + size_text(test) + "; ";
}

std::string method_text(const StudyTest& test) {
  return words_of_method(std::string(test.made_by->code), permutations_text(test)).english() +
         (test.permutes_within_blocks ? ", within the blocks of the assignment" : "");
}

}  // namespace

std::string permutations_text(const StudyTest& test) {
  if (!test.random_permutations) return {};
  return *test.random_permutations == 0 ? "exact" : std::to_string(*test.random_permutations);
}

std::string statistic_text(std::string_view symbol, std::span<const double> degrees, double value,
                           std::optional<double> epsilon) {
  std::string inner{};
  for (const double of_design : degrees) {
    const double df = of_design * epsilon.value_or(1.0);
    inner += (inner.empty() ? "" : ", ") + fixed(df, !epsilon && df == std::round(df) ? 0 : 2);
  }
  const bool is_count = symbol == "k" || symbol == "D";
  return std::string(symbol) + (inner.empty() ? "" : '(' + inner + ')') + " = " +
         display_signed(value, is_count ? 0 : 2) +
         (epsilon ? ", ε = " + display_bounded(*epsilon) : "");
}

std::string effect_text(std::string_view symbol, double value, const EffectInterval& interval) {
  const auto shown = [is_bounded = is_bounded_effect(symbol)](double number) {
    return is_bounded ? display_bounded(number) : display_signed(number, 2);
  };
  std::string text = std::string(symbol) + " = " + shown(value);
  if (!interval.low || !interval.high) return text;
  return text + std::string(interval.before) + '[' + shown(*interval.low) + ", " +
         shown(*interval.high) + ']';
}

TestSentence sentence_of_test(const StudyTest& test, std::string_view kind) {
  TestSentence sentence{.test = test.name, .about = test.about, .role = test.role};
  if (!test.p || test.made_by == nullptr) {
    sentence.is_untested = true;
    const std::string about = words_of_test(test.name, test.about).english();
    sentence.text = Phrase("The test of %1 could not be computed: %2")
                        .with(about, words_of_status(test.status))
                        .as_sentence()
                        .english();
    return sentence;
  }
  const std::string estimate = estimate_text(test);
  sentence.text = claim_of(test, kind) + ": " + estimate + method_text(test);
  if (test.statistic) {
    sentence.text +=
        ", " + statistic_text(test.made_by->symbol, test.degrees, *test.statistic, test.epsilon);
  }
  if (estimate.empty()) sentence.text += ", " + size_text(test);
  sentence.text += ", " + p_text(test).english();
  if (test.effect) {
    const TestMethod& by = *test.made_by;
    const EffectInterval interval{
        .low = test.effect->low, .high = test.effect->high, .before = ", 95 % CI "};
    const std::string text = effect_text(by.effect_symbol, test.effect->value, interval);
    const std::string name = by.effect_name.english();
    sentence.text += "; " + (name.empty() ? text : name + text.substr(by.effect_symbol.size()));
    if (test.effect->takes_trials_as_independent) {
      sentence.text += " (trials treated as independent)";
    }
  }
  if (test.pools_participants) {
    sentence.text += " (responses of all participants pooled as independent)";
  }
  if (test.contradicts_interval()) sentence.text += "; " + contradiction_text(test).english();
  sentence.text += '.';
  sentence.is_significant = test.is_significant() && !test.contradicts_interval();
  sentence.p = test.adjusted ? test.adjusted : test.p;
  sentence.unattainable_p = test.unattainable_p();
  sentence.required_n = test.required_n;
  sentence.made_by = test.made_by;
  sentence.has_effect = test.effect.has_value();
  sentence.has_mean_interval = test.estimate && test.estimate->low;
  return sentence;
}

void state_means(AnalysisOutcome& outcome, std::string_view test, const std::string& means,
                 const TestSubject& about) {
  for (TestSentence& one : outcome.test_sentences) {
    const bool is_stated = one.test == test && one.about == about &&
                           one.role == TestRole::confirmatory && !one.is_untested;
    if (is_stated) one.text.insert(one.text.size() - 1, "; " + means);
  }
}

Phrase p_text(const StudyTest& test) {
  const double p = test.adjusted.value_or(test.p.value_or(1.0));
  const Phrase how = test.adjusted && !test.is_alone_in_family
                         ? phrase("Analysis", "%1, Holm-corrected")
                     : test.adjusted && test.role == TestRole::confirmatory
                         ? phrase("Analysis", "%1, the only test of its family")
                         : phrase("Analysis", "%1, uncorrected");
  const Phrase text = how.with(display_p(p));
  const std::optional<double> smallest = test.unattainable_p();
  if (!smallest) return text;
  const std::string shown = display_p_cell(*smallest);
  if (!test.required_n) {
    return phrase("Analysis", "%1; the smallest attainable p is %2").with(text, shown);
  }
  const std::size_t differing = test.differing.value_or(test.n);
  if (differing == 1) {
    return phrase(
               "Analysis",
               "%1; the smallest attainable p is %2, so that no result could be significant with "
               "one participant whose difference is not zero; at least %3 such participants are "
               "required")
        .with(text, shown, std::to_string(*test.required_n));
  }
  return phrase("Analysis",
                "%1; the smallest attainable p is %2, so that no result could be significant with "
                "%3 participants whose difference is not zero; at least %4 such participants are "
                "required")
      .with(text, shown, std::to_string(differing), std::to_string(*test.required_n));
}

Phrase with_zero_differences(const Phrase& answer, const StudyTest& test) {
  if (test.zero_differences() == 0) return answer;
  if (test.ties == 0) {  // a sign-flip test
    return phrase("Analysis",
                  "%1 Participants with a difference of zero, who do not affect p: %2 of %3.")
        .with(answer, std::to_string(test.zero_differences()), std::to_string(test.n));
  }
  const std::string compared = std::to_string(test.n + test.ties);
  if (test.ties == 1) {
    return phrase("Analysis",
                  "%1 One of %2 participants has a difference of zero and is left out of the test.")
        .with(answer, compared);
  }
  return phrase("Analysis",
                "%1 %2 of %3 participants have a difference of zero and are left out of the test.")
      .with(answer, std::to_string(test.ties), compared);
}

Phrase chance_in_interval() {
  return phrase("Analysis", "the 95 % CI of the mean contains the chance level");
}

Phrase contradiction_text(const StudyTest& test) {
  if (!test.contradicts_interval()) return {};
  return test.objection.empty() ? chance_in_interval() : test.objection;
}

Phrase with_contradiction(const Phrase& answer, const StudyTest& test) {
  if (!test.contradicts_interval()) return answer;
  return phrase("Analysis",
                "%1 Nothing is established: p is below .05, but %2; more participants are needed.")
      .with(answer, contradiction_text(test));
}

TestStatements statements_of(const StudyTest& test, const StatedNumbers& stated) {
  const Phrase& numbers = stated.numbers;
  const Phrase p = p_text(test);
  const Phrase nothing = stated.not_significant.with(numbers, p);
  const Phrase told =
      stated.exploratory.empty() ? numbers.as_sentence() : stated.exploratory.with(numbers, p);
  return {!stated.claim.empty() ? stated.claim
          : test.contradicts_interval()
              ? stated.not_established.with(numbers, p, contradiction_text(test))
              : stated.significant.with(numbers, p),
          stated.compares
              ? phrase("Analysis", "%1 This does not show that they are equal.").with(nothing)
              : nothing,
          with_contradiction(told, test)};
}

Phrase said_of(const StudyTest& test, const TestStatements& statements) {
  const Phrase answer =
      test.shows() ? statements.claim
      : test.adjusted && !test.is_significant()
          ? statements.nothing
          : phrase("Analysis", "%1 This test is exploratory.").with(statements.told);
  // The answer can concern several sign-flip tests, each with its own differences of zero.
  return test.ties == 0 ? answer : with_zero_differences(answer, test);
}

}  // namespace asperity
