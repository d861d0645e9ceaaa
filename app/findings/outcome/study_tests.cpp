// Finds each test by the name of its p, then applies Holm's correction to p and to the smallest attainable p.

#include "app/findings/outcome/study_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/multiplicity.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/group_figures.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

std::string TestSubject::text() const {
  return FindingKey{(of.empty() || first.empty() ? of : of + ": ") + first, second}.text();
}

namespace {

Finding finding_of(const StudyTests::Test& test) {
  Finding finding{};
  finding.quantity = "p";
  finding.key = "test=" + test.name;
  if (!test.about.empty()) finding.key = finding.key.text() + " about=" + test.about.text();
  finding.value = test.p;
  finding.unit = "1";
  finding.method = test.method;
  finding.status = test.status;
  finding.n = test.n;
  finding.analysis = StudyTests::kTable;
  return finding;
}

std::optional<StudyTests::Test::Effect> effect_in(const FoundNumbers& found, QuantityName quantity,
                                                  const FindingKey& key) {
  const Finding* finding = found.find(quantity, key);
  if (finding == nullptr || !finding->value) return std::nullopt;
  return StudyTests::Test::Effect{
      .value = *finding->value, .low = finding->low, .high = finding->high};
}

/// Marks an effect size that treats single trials as independent in a test of participants; with
/// one participant its interval would not generalise to participants.
void judge_effect(const FoundNumbers& found, const FindingKey& key, StudyTests::Test& test) {
  if (!test.effect || test.unit != kUnitOfParticipants) return;
  const Finding* finding = found.find(test.made_by->effect, key);
  test.effect->takes_trials_as_independent = finding->n != test.n;
  if (test.n > 1) return;
  test.effect->low.reset();
  test.effect->high.reset();
}

/// Why a test that the protocol declares was not added: a code of cell_words.h.
std::string reason_for(const std::string& name) {
  using WhyNot = std::pair<std::string_view, std::string_view>;
  constexpr std::array kReasons{WhyNot{"accompanying_scales", "no_correct_responses"},
                                WhyNot{"condition", "one_condition"},
                                WhyNot{"exponent", "no_predictor"},
                                WhyNot{kGroupProfilesTest, "one_group"},
                                WhyNot{kGroupsTest, "one_group"},
                                WhyNot{"identical", "no_identical_pairs"},
                                WhyNot{"information", "pictures_differ"},
                                WhyNot{"interaction", "one_condition"},
                                WhyNot{"pairs", "no_pair_offered"},
                                WhyNot{"peaks", "no_two_peaks"},
                                WhyNot{"position", "trials_of_different_sizes"},
                                WhyNot{"properties", "no_properties"},
                                WhyNot{"right", "pictures_differ"},
                                WhyNot{"sexes", "one_sex"},
                                WhyNot{"stimuli_by_condition", "one_condition"},
                                WhyNot{"target_pairs", "target_not_offered"},
                                WhyNot{"textures", "no_target_or_one_texture"}};
  const auto* known = std::find_if(kReasons.begin(), kReasons.end(),
                                   [&name](const WhyNot& each) { return each.first == name; });
  return std::string(known == kReasons.end() ? "no_responses" : known->second);
}

const ResultColumn kTest{.id = "test",
                         .heading = phrase("AnalysisWords", "test"),
                         .stored_as = {"test", "about", "first", "second"}};
const ResultColumn kMethod{
    .id = "method", .heading = phrase("AnalysisWords", "method"), .stored_as = {"method"}};
const ResultColumn kN{
    .id = "n", .heading = phrase("AnalysisWords", "n"), .stored_as = {"n", "unit"}};
const ResultColumn kStatistic{.id = "statistic",
                              .heading = phrase("AnalysisWords", "statistic"),
                              .stored_as = {"statistic", "value", "df1", "df2", "epsilon"}};
const ResultColumn kPermutations{.id = "permutations", .is_for_files = true};
const ResultColumn kEffectSize{.id = "effect_size",
                               .heading = phrase("AnalysisWords", "effect size [95 % CI]"),
                               .stored_as = {"effect_size", "effect", "effect_low", "effect_high"}};
const ResultColumn kPHolm{
    .id = "p_holm", .heading = phrase("AnalysisWords", "p, Holm"), .digits = Digits::p};
const ResultColumn kPSmallest{.id = "p_smallest",
                              .heading = phrase("AnalysisWords", "smallest attainable p"),
                              .digits = Digits::p};
const ResultColumn kFamily{.id = "family", .is_for_files = true};
const ResultColumn kRole{
    .id = "role", .heading = phrase("AnalysisWords", "role"), .words = words_of_role};

Cell stored(std::string_view text) { return text.empty() ? Cell{} : Cell{std::string(text)}; }
Cell stored(const std::optional<double>& number) { return number ? Cell{*number} : Cell{}; }

/// "pairs: a / b"
ResultCell test_cell(const StudyTests::Test& test) {
  const TestSubject& about = test.about;
  return JoinedCell{
      {stored(test.name), stored(about.of), stored(about.first), stored(about.second)},
      words_of_test(test.name, about)};
}

/// "sign-flip test, exact"
ResultCell method_cell(const StudyTests::Test& test, const TestMethod& by) {
  if (by.code.empty()) return {};
  return JoinedCell{{stored(by.code)},
                    words_of_method(std::string(by.code), permutations_text(test))};
}

/// "20 participants"; nothing to read where nothing was tested.
ResultCell n_cell(const StudyTests::Test& test) {
  return JoinedCell{{static_cast<std::int64_t>(test.n), stored(test.unit)},
                    test.n > 0 ? words_of_count(test.n, test.unit) : Phrase{}};
}

/// "F(2, 38) = 5.17", "F(1.54, 29.18) = 5.17, ε = .77"
ResultCell statistic_cell(const StudyTests::Test& test, const TestMethod& by) {
  if (!test.statistic) return {};
  const auto degrees = [&test](std::size_t place) {
    return place < test.degrees.size() ? Cell{test.degrees[place]} : Cell{};
  };
  return JoinedCell{
      {stored(by.symbol), *test.statistic, degrees(0), degrees(1), stored(test.epsilon)},
      statistic_text(by.symbol, test.degrees, *test.statistic, test.epsilon)};
}

/// "d = 2.74 [1.75, 3.71]"
ResultCell effect_cell(const StudyTests::Test& test, const TestMethod& by) {
  if (!test.effect) return {};
  return JoinedCell{{stored(by.effect_symbol), test.effect->value, stored(test.effect->low),
                     stored(test.effect->high)},
                    effect_text(by.effect_symbol, test.effect->value,
                                {.low = test.effect->low, .high = test.effect->high})};
}

/// The columns of the table of tests.
std::vector<ResultColumn> columns_of_tests() {
  return {kTest,
          kMethod,
          kN,
          kStatistic,
          kPermutations,
          kEffectSize,
          for_files(columns::kLeftOut),
          columns::kP,
          kPHolm,
          kPSmallest,
          kFamily,
          kRole,
          columns::kStatus};
}

/// The row of a test in these columns. `family`: the family of the test; may be empty.
ResultRow row_of(const StudyTests::Test& test, const std::string& family) {
  static const TestMethod kNone{};
  const TestMethod& by = test.p && test.made_by != nullptr ? *test.made_by : kNone;
  return {test_cell(test),
          method_cell(test, by),
          n_cell(test),
          statistic_cell(test, by),
          word_cell(permutations_text(test)),
          effect_cell(test, by),
          count_cell(test.left_out + test.ties),
          cell_of(test.p),
          cell_of(test.adjusted),
          cell_of(test.unattainable_p()),
          word_cell(family),
          std::string(test.role == TestRole::confirmatory ? "confirmatory" : "exploratory"),
          test.p ? ResultCell{} : ResultCell{test.status}};
}

/// Records the smallest attainable p; that of a single participant is 1, which is not a test. `people`: all participants, of
/// whom a signed-rank test does not count those with a difference of zero in n.
void note_smallest_p(std::optional<double> smallest, std::size_t people, StudyTests::Test& test) {
  if (!test.p || !smallest) return;
  constexpr double kRounding = 1e-9;  // of a sum over all permutations
  if (compares_groups(test.name) && *smallest > 1.0 - kRounding) {
    test.p.reset();
    constexpr std::size_t kOneInEachGroup = 2;
    test.status = test.n > kOneInEachGroup ? "no_block_of_both" : "one_in_each_group";
    return;
  }
  if (test.n > 1 || *smallest < 1.0 - kRounding) {
    test.smallest_p = smallest;
    return;
  }
  const bool drops_zeros = test.made_by->code == "wilcoxon";
  test.p.reset();
  test.status = people < 2 || !drops_zeros ? StudyTests::kOneParticipantAlone
                : test.n == 0              ? StudyTests::kNoDifference
                                           : StudyTests::kOneDifference;
}

}  // namespace

StudyTests::StudyTests(const GatheredAnswers& gathered)
    : kind_(gathered.kind), people_(gathered.people.size()), family_(gathered.declared.family) {
  const ExperimentKind* const kind = find_kind(gathered.kind);
  const std::vector<std::string>& declared = gathered.declared.family;
  if (kind != nullptr) {
    family_ = family_of(*kind, gathered.declared, gathered.estimation, gathered.only_accompanies);
  }
  is_declared_ = std::any_of(declared.begin(), declared.end(),
                             [this](const std::string& name) { return is_in_family(name); });
  is_of_other_kinds_ = !is_declared_ && !declared.empty();
  name_family();
}

const ResultColumn& StudyTests::test_column() { return kTest; }

void StudyTests::name_family() {
  name_.clear();
  for (const std::string& name : family_) name_ += (name_.empty() ? "" : ", ") + name;
}

void StudyTests::set_default_family(std::vector<std::string> names) {
  if (is_declared_ || family_.empty()) return;
  family_ = std::move(names);
  name_family();
}

bool StudyTests::is_in_family(std::string_view name) const {
  return std::find(family_.begin(), family_.end(), name) != family_.end();
}

void StudyTests::add(const std::string& name, const TestSubject& about, const FoundNumbers& found,
                     QuantityName p, const FindingKey& key) {
  const Finding* finding = found.find(p, key);
  if (finding == nullptr) {
    add_untested(name, about, reason_for(name));
    return;
  }
  Test& test = tests_.emplace_back(Test{.name = name, .about = about});
  test.made_by = test_method(p);
  test.n = finding->n;
  test.method = finding->method;
  test.p = finding->value;
  test.source = name_of(*finding);
  if (!test.p) test.status = finding->status;
  if (test.made_by == nullptr) return;
  const TestMethod& by = *test.made_by;
  test.unit = by.unit;
  test.pools_participants = test.unit == kUnitOfAnswers && people_ > 1;
  if (test.unit != kUnitOfParticipants) test.method += "; n counts " + test.unit;
  if (found.value(by.degrees.front(), key) == 0.0) {  // no hypothesis was tested
    test.p.reset();
    test.status = "nothing_varies";
    return;
  }
  if (!by.smallest.empty()) note_smallest_p(found.value(by.smallest, key), people_, test);
  if (!test.p) return;  // without a p there is no statistic either
  if (const auto differing = found.value(by.differing, key)) {
    test.differing = static_cast<std::size_t>(*differing);
  }
  test.statistic = found.value(by.statistic, key);
  for (const QuantityName quantity : by.degrees) {
    if (const auto df = found.value(quantity, key)) test.degrees.push_back(*df);
  }
  if (!by.epsilon.empty()) test.epsilon = found.value(by.epsilon, key);
  if (!by.draws.empty()) {
    test.random_permutations = static_cast<std::size_t>(found.value(by.draws, key).value_or(0.0));
  }
  test.effect = effect_in(found, by.effect, key);
  judge_effect(found, key, test);
  if (by.estimate.empty()) return;
  test.estimate = effect_in(found, by.estimate, key);
  if (test.estimate && found.find(by.estimate, key)->n != test.n) {  // an interval over trials
    test.estimate->low.reset();
    test.estimate->high.reset();
  }
}

void StudyTests::add_untested(const std::string& name, const TestSubject& about,
                              const std::string& reason) {
  tests_.push_back(Test{.name = name, .about = about, .status = reason});
}

void StudyTests::state_chance(double chance, bool varies) {
  tests_.back().chance = chance;
  tests_.back().chance_varies = varies;
}

void StudyTests::state_effect(const Finding* effect, std::string_view name) {
  if (effect == nullptr || !effect->value) return;
  tests_.back().in_units =
      Test::Effect{.value = *effect->value, .low = effect->low, .high = effect->high};
  tests_.back().name_in_units = name;
}

void StudyTests::state_compared(const Finding* compared, double none, const Phrase& contained) {
  if (compared == nullptr || !holds_in_interval(*compared, none)) return;
  tests_.back().objection = contained;
}

void StudyTests::state_difference(const Finding* difference) {
  state_compared(difference, 0.0, phrase("Analysis", "the 95 % CI of the difference contains 0"));
}

void StudyTests::state_ratio(const Finding* ratio) {
  state_compared(ratio, 1.0, phrase("Analysis", "the 95 % CI of the ratio contains 1"));
}

void StudyTests::state_mean_share(const Finding* mean, double chance) {
  state_compared(mean, chance, chance_in_interval());
}

void StudyTests::state_direction(std::optional<double> difference) {
  Test& test = tests_.back();
  if (!difference || *difference * test.direction() > 0.0) return;
  test.objection = phrase("Analysis", "the means do not differ in the direction of the test");
}

void StudyTests::leave_out(std::size_t participants, const Phrase& why) {
  tests_.back().left_out = participants;
  tests_.back().why_left_out = why;
}

const StudyTests::Test* StudyTests::find(std::string_view name, const TestSubject& about) const {
  const auto found = std::find_if(tests_.begin(), tests_.end(), [&](const Test& test) {
    return test.name == name && test.about == about;
  });
  return found == tests_.end() ? nullptr : &*found;
}

Phrase StudyTests::note_on_family(std::size_t tests, std::string_view left_out) const {
  const Phrase family = words_of_tests(name_);
  const bool is_any_adjusted =
      std::any_of(tests_.begin(), tests_.end(), [](const Test& test) { return test.adjusted; });
  const Phrase undeclared =
      is_of_other_kinds_
          ? phrase(
                "Analysis",
                "The protocol declares only tests of its other tasks, so that no test of this one "
                "is confirmatory.")
          : phrase("Analysis",
                   "The protocol declares no family of tests, so that no test is confirmatory.");
  Phrase note =
      family_.empty() ? undeclared
      : !is_any_adjusted
          ? phrase("Analysis", "No test of the family (%1) could be computed.").with(family)
      : tests == 1 && is_declared_
          ? phrase("Analysis",
                   "The family that the protocol declares has one test (%1), the only confirmatory "
                   "one; no correction is needed.")
                .with(family)
      : tests == 1
          ? phrase(
                "Analysis",
                "%1 The default family of this kind of protocol has one test (%2); no correction "
                "is needed.")
                .with(undeclared, family)
      : is_declared_
          ? phrase("Analysis",
                   "p, Holm: Holm-corrected over the %1 confirmatory tests, the family that the "
                   "protocol declares (%2); a test that cannot be computed counts as p = 1.")
                .with(std::to_string(tests), family)
          : phrase("Analysis",
                   "%1 p, Holm: Holm-corrected over the %2 tests of the default family of this "
                   "kind of "
                   "protocol (%3); a test that cannot be computed counts as p = 1.")
                .with(undeclared, std::to_string(tests), family);
  note =
      (is_declared_ ? phrase("Analysis",
                             "%1 All other tests are exploratory and uncorrected. Where n counts "
                             "responses or trials, they are pooled as if they were independent. %2")
       : family_.empty()
           ? phrase("Analysis",
                    "%1 The p values of the tests are uncorrected. Where n counts responses or "
                    "trials, they are pooled as if they were independent. %2")
           : phrase(
                 "Analysis",
                 "%1 The p values of all other tests are uncorrected. Where n counts responses or "
                 "trials, they are pooled as if they were independent. %2"))
          .with(note, note_on_columns(left_out));
  for (const Test& test : tests_) {
    if (test.left_out == 0 || test.why_left_out.empty()) continue;
    note = phrase("Analysis", "%1 %2: %3 of %4.")
               .with(note, test.why_left_out, std::to_string(test.left_out),
                     std::to_string(test.n + test.left_out));
  }
  const Phrase zero = note_on_zero_differences();
  return zero.empty() ? note : phrase("Analysis", "%1 %2").with(note, zero);
}

Phrase StudyTests::note_on_zero_differences() const {
  constexpr std::size_t kMostNamed = 4;
  struct Named {
    std::size_t tests = 0;
    Phrase names{};
  };
  Named left_out{};  // by signed-rank tests
  Named counted{};   // by sign-flip tests
  for (const Test& test : tests_) {
    const std::size_t zero = test.zero_differences();
    if (zero == 0) continue;
    Named& named = test.ties > 0 ? left_out : counted;
    ++named.tests;
    const Phrase one = phrase("Analysis", "%1 (%2 of %3)")
                           .with(words_of_test(test.name, test.about), std::to_string(zero),
                                 std::to_string(test.n + test.ties));
    named.names = named.names.empty() ? one : phrase("Analysis", "%1; %2").with(named.names, one);
  }
  const Phrase of_left_out =
      left_out.tests == 0 ? Phrase{}
      : left_out.tests > kMostNamed
          ? phrase("Analysis",
                   "Signed-rank tests leave out participants with a difference of zero, so that n "
                   "differs between the tests.")
          : phrase(
                "Analysis",
                "Signed-rank tests leave out participants with a difference of zero, whom n does "
                "not count: %1.")
                .with(left_out.names);
  const Phrase of_counted =
      counted.tests == 0 ? Phrase{}
      : counted.tests > kMostNamed
          ? phrase("Analysis",
                   "Participants with a difference of zero do not affect the p of sign-flip tests, "
                   "although n counts them.")
          : phrase("Analysis",
                   "Participants with a difference of zero do not affect the p of sign-flip tests, "
                   "although n counts them: %1.")
                .with(counted.names);
  if (of_left_out.empty()) return of_counted;
  if (of_counted.empty()) return of_left_out;
  return phrase("Analysis", "%1 %2").with(of_left_out, of_counted);
}

Phrase StudyTests::note_on_columns(std::string_view left_out) const {
  std::vector<std::pair<std::string_view, Phrase>> symbols{};
  std::string pooled{};
  bool has_interval = false;
  bool has_epsilon = false;
  std::vector<Phrase> simulated{};
  const auto add_simulated = [&simulated](const Phrase& sentence) {
    if (sentence.empty()) return;
    if (std::find(simulated.begin(), simulated.end(), sentence) == simulated.end()) {
      simulated.push_back(sentence);
    }
  };
  const auto add_symbol = [&symbols](std::string_view symbol, const Phrase& name) {
    const bool is_known = std::any_of(symbols.begin(), symbols.end(),
                                      [symbol](const auto& one) { return one.first == symbol; });
    if (!name.empty() && !is_known) symbols.emplace_back(symbol, name);
  };
  for (const Test& test : tests_) {
    if (!test.p || test.made_by == nullptr || test.name == left_out) continue;
    if (test.statistic) add_symbol(test.made_by->symbol, test.made_by->symbol_name);
    has_epsilon = has_epsilon || test.epsilon;
    if (!test.effect) continue;
    const std::string_view symbol = test.made_by->effect_symbol;
    add_symbol(symbol, test.made_by->effect_name);
    has_interval = has_interval || test.effect->low;
    if (test.effect->low) add_simulated(test.made_by->coverage);
    const bool is_named = pooled.find(symbol) != std::string::npos;
    if (!test.effect->takes_trials_as_independent || is_named) continue;
    pooled += (pooled.empty() ? "" : ", ") + std::string(symbol);
  }
  Phrase note{};
  for (const auto& [symbol, name] : symbols) {
    const Phrase one = phrase("Analysis", "%1: %2").with(std::string(symbol), name);
    note = note.empty() ? one : phrase("Analysis", "%1; %2").with(note, one);
  }
  if (!note.empty()) note = phrase("Analysis", "%1.").with(note);
  const auto add = [&note](const Phrase& sentence) {
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (has_epsilon) {
    add(phrase(
        "Analysis",
        "ε: factor by which both degrees of freedom are multiplied (Greenhouse and Geisser)."));
  }
  if (has_interval) add(phrase("Analysis", "Brackets: 95 % CI."));
  for (const Phrase& sentence : simulated) add(sentence);
  if (!pooled.empty()) {
    add(phrase("Analysis", "Estimated from trials as if they were independent: %1.").with(pooled));
  }
  return note;
}

std::size_t StudyTests::tests_in_family() const {
  return static_cast<std::size_t>(std::count_if(
      tests_.begin(), tests_.end(), [this](const Test& test) { return is_in_family(test.name); }));
}

// A test that was declared but cannot be made still counts in the family: with p = 1 it leaves the
// other tests' correction unchanged. Holm's adjusted p do not decrease when any raw p increases:
// the adjusted values of all smallest p are therefore the smallest adjusted value that each test
// can reach.
void StudyTests::adjust() {
  std::vector<Test*> family{};
  for (Test& test : tests_) {
    if (!is_in_family(test.name)) continue;
    test.role = is_declared_ ? TestRole::confirmatory : TestRole::usual_family;
    family.push_back(&test);
  }
  const auto holm_of = [&family](const auto& p_of) {
    std::vector<double> raw(family.size());
    std::transform(family.begin(), family.end(), raw.begin(),
                   [&p_of](const Test* test) { return test->p ? p_of(*test) : 1.0; });
    return holm_adjusted(raw);
  };
  const std::vector<double> adjusted = holm_of([](const Test& test) { return *test.p; });
  const std::vector<double> smallest =
      holm_of([](const Test& test) { return test.smallest_p.value_or(0.0); });
  for (std::size_t i = 0; i < family.size(); ++i) {
    Test& test = *family[i];
    if (!test.p) continue;
    test.adjusted = adjusted[i];
    test.is_alone_in_family = family.size() == 1;
    if (test.smallest_p) test.smallest_p = smallest[i];
  }
  for (Test& test : tests_) {
    if (test.unattainable_p()) test.required_n = required_participants(test);
  }
}

// With k participants whose difference is not zero the smallest p of a test that permutes signs is 2^(1 − k): all signs
// equal, in either of two directions. For the other tests of this kind in the family the correction takes the smallest p of
// their own k or of the k that is required here, whichever is greater; 0 for tests of another kind, whose smallest p may
// decrease faster; and 1 for tests that cannot be made.
std::optional<std::size_t> StudyTests::required_participants(const Test& test) const {
  if (!test.differing || test.random_permutations.value_or(0) > 0) return std::nullopt;
  constexpr std::size_t kMost = 64;
  const auto smallest_of = [](std::size_t differing) {
    return std::ldexp(1.0, 1 - static_cast<int>(differing));
  };
  const auto raw_of = [&](const Test& each, std::size_t required) {
    if (!each.p) return 1.0;
    return each.differing ? smallest_of(std::max(*each.differing, required)) : 0.0;
  };
  for (std::size_t required = *test.differing + 1; required <= kMost; ++required) {
    if (!test.adjusted) {
      if (smallest_of(required) < Test::kLevel) return required;
      continue;
    }
    std::vector<double> raw{};
    std::size_t own = 0;
    for (const Test& each : tests_) {
      if (!is_in_family(each.name)) continue;
      if (&each == &test) own = raw.size();
      raw.push_back(raw_of(each, required));
    }
    if (holm_adjusted(raw)[own] < Test::kLevel) return required;
  }
  return std::nullopt;
}

void StudyTests::add_missing() {
  for (const std::string& name : family_) {
    const bool is_added = std::any_of(tests_.begin(), tests_.end(),
                                      [&name](const Test& test) { return test.name == name; });
    if (!is_added) add_untested(name, "", reason_for(name));
  }
}

std::vector<StudyTests::Test> StudyTests::take_family() && {
  std::erase_if(tests_, [this](const Test& test) { return !is_in_family(test.name); });
  add_missing();
  adjust();
  return std::move(tests_);
}

void StudyTests::finish(AnalysisOutcome& outcome) {
  if (family_.empty() && tests_.empty()) return;
  add_missing();
  adjust();
  const std::size_t in_family = tests_in_family();
  ResultTable made{StudyTests::kTable, phrase("Analysis", "Tests"), columns_of_tests(),
                   note_on_family(in_family)};
  made.figures = figures_of_comparisons;
  for (const Test& test : tests_) {
    made.add(row_of(test, is_in_family(test.name) ? name_ : ""));
    Finding finding = finding_of(test);
    if (!test.p) finding.status = words_of_status(test.status).english();
    outcome.findings.push_back(finding);
    outcome.test_sentences.push_back(sentence_of_test(test, kind_));
    if (test.p) outcome.tests_in_tables.insert({name_of(finding), test.source});
    if (!is_in_family(test.name)) continue;
    finding.quantity = "p.holm";
    finding.value = test.adjusted;
    const std::string family =
        " of the family " + name_ + (is_declared_ ? ", which the protocol declares" : "");
    finding.method += in_family == 1 ? "; the only test" + family + ", uncorrected"
                                     : "; Holm-corrected over the " + std::to_string(in_family) +
                                           " tests" + family;
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(made));
  outcome.note_of_tests_without_sexes = note_on_family(in_family, kSexesTest);
}

}  // namespace asperity
