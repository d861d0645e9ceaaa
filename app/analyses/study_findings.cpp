#include "app/analyses/study_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/multiplicity.h"
#include "analysis/number_text.h"
#include "analysis/two_samples.h"
#include "app/analyses/cell_words.h"
#include "app/analyses/reading_number.h"

namespace asperity {

namespace {

constexpr std::string_view kParticipants = "participants";
constexpr double kAlpha = 0.05;

Finding finding_of(const StudyTests::Test& test) {
  Finding finding{};
  finding.quantity = "p";
  finding.key = "test=" + test.name + (test.about.empty() ? "" : " about=" + test.about);
  finding.value = test.p;
  finding.unit = "1";
  finding.method = test.method;
  finding.status = test.status;
  finding.n = test.n;
  finding.analysis = StudyTests::kTable;
  return finding;
}

/// "20 participants"
Phrase counted_units(std::size_t n, CountedUnit unit) {
  const std::string number = std::to_string(n);
  switch (unit) {
    case CountedUnit::participants:
      return n == 1 ? phrase("Analysis", "one participant")
                    : phrase("Analysis", "%1 participants").with(number);
    case CountedUnit::answers:
      return n == 1 ? phrase("Analysis", "one answer")
                    : phrase("Analysis", "%1 answers").with(number);
    case CountedUnit::goes:
      return n == 1 ? phrase("Analysis", "one go") : phrase("Analysis", "%1 goes").with(number);
  }
  return {};
}

/// With a minus that is as broad as a plus; what rounds to nothing has no sign.
std::string signed_number(double value, int digits) {
  const std::string text = fixed(std::abs(value), digits);
  const bool is_nothing = text.find_first_of("123456789") == std::string::npos;
  return (value < 0.0 && !is_nothing ? "−" : "") + text;
}

/// "95 % interval 2.10 to 2.90" of what is no share.
Phrase plain_interval(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "95 % interval %1 to %2")
        .with(signed_number(*finding.low, digits), signed_number(*finding.high, digits));
  }
  return phrase("Analysis", "without an interval");
}

/// The same of a difference, whose p is of another method than its interval.
Phrase interval_of_difference(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "95 % interval after Welch %1 to %2")
        .with(signed_number(*finding.low, digits), signed_number(*finding.high, digits));
  }
  return phrase("Analysis", "without an interval");
}

}  // namespace

std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input) {
  std::vector<Finding> findings{};
  try {
    findings = tidy_family(family).findings(input);
  } catch (const std::exception& error) {
    Finding refused{};
    refused.quantity = "status";
    refused.word = "not_applicable";
    refused.status = error.what();
    findings.push_back(std::move(refused));
  }
  for (Finding& finding : findings) finding.analysis = analysis;
  return findings;
}

std::string json_text(const std::string& text) { return nlohmann::json(text).dump(); }

std::string json_list(std::span<const std::string> texts) {
  return nlohmann::json(std::vector<std::string>(texts.begin(), texts.end())).dump();
}

void keep_findings(std::span<const Finding> findings, AnalysisOutcome& outcome,
                   const KeepFinding& keep) {
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(outcome.findings), keep);
}

StudyTests::StudyTests(const GatheredAnswers& gathered) : family_(gathered.declared.family) {
  is_declared_ = !family_.empty();
  for (const TestName& test : test_names()) {
    if (family_.empty() && test.kind == gathered.kind) family_.emplace_back(test.name);
  }
  for (const std::string& name : family_) name_ += (name_.empty() ? "" : ", ") + name;
}

bool StudyTests::is_in_family(std::string_view name) const {
  return std::find(family_.begin(), family_.end(), name) != family_.end();
}

void StudyTests::add(const std::string& name, const std::string& about, const Finding* finding,
                     const char* unit, const Finding* smallest) {
  Test& test = tests_.emplace_back(Test{.name = name, .about = about, .unit = unit});
  if (finding == nullptr) {
    test.status = "there are no answers of which this could be tested";
    return;
  }
  test.n = finding->n;
  test.method = finding->method;
  if (test.unit != kParticipants) test.method += "; n counts " + test.unit;
  test.p = finding->value;
  test.source = name_of(*finding);
  if (!test.p) test.status = finding->status;
  if (!test.p || smallest == nullptr || !smallest->value || *smallest->value <= kAlpha) return;
  constexpr double kRounding = 1e-9;  // of a sum over all relabellings
  if (*smallest->value < 1.0 - kRounding || test.n > 1) {
    test.smallest_p = smallest->value;
    return;
  }
  test.p.reset();
  test.status = kOneParticipantAlone;
}

const StudyTests::Test* StudyTests::find(std::string_view name, std::string_view about) const {
  const auto found = std::find_if(tests_.begin(), tests_.end(), [&](const Test& test) {
    return test.name == name && test.about == about;
  });
  return found == tests_.end() ? nullptr : &*found;
}

Phrase StudyTests::note_on_family(std::size_t tests) const {
  if (tests == 1) {
    const Phrase one =
        is_declared_
            ? phrase("Analysis",
                     "The family that the protocol declares is a single test (%1), whose p Holm's "
                     "method leaves as it is. Tests outside the family are not adjusted and show "
                     "no more than what to ask next time. n counts the units beside it; answers "
                     "and goes are pooled as if they were independent.")
            : phrase("Analysis",
                     "The protocol declares no family of tests. The family that this kind of "
                     "protocol has by itself is a single test (%1), whose p Holm's method leaves "
                     "as it is. The other tests are not adjusted and show no more than what to "
                     "ask next time. n counts the units beside it; answers and goes are pooled as "
                     "if they were independent.");
    return one.with(words_of_cell("family", name_));
  }
  const Phrase several =
      is_declared_
          ? phrase("Analysis",
                   "p, Holm: adjusted after Holm over the %1 tests of the family that the protocol "
                   "declares (%2); one that cannot be made counts as p = 1. Tests outside the "
                   "family are not adjusted and show no more than what to ask next time. n counts "
                   "the units beside it; answers and goes are pooled as if they were independent.")
          : phrase(
                "Analysis",
                "The protocol declares no family of tests. p, Holm: adjusted after Holm over the "
                "%1 tests of the family that this kind of protocol has by itself (%2); one that "
                "cannot be made counts as p = 1. The other tests are not adjusted and show no "
                "more than what to ask next time. n counts the units beside it; answers and "
                "goes are pooled as if they were independent.");
  return several.with(std::to_string(tests), words_of_cell("family", name_));
}

void StudyTests::finish(AnalysisOutcome& outcome) {
  for (const std::string& name : family_) {
    const bool is_added = std::any_of(tests_.begin(), tests_.end(),
                                      [&name](const Test& test) { return test.name == name; });
    if (!is_added) add(name, "", nullptr);
  }
  // What was declared is not fewer tests because one of them cannot be made: as p = 1 it leaves the
  // others what they would have been, and its own place in the family.
  std::vector<double> raw{};
  for (const Test& test : tests_) {
    if (is_in_family(test.name)) raw.push_back(test.p.value_or(1.0));
  }
  const std::vector<double> adjusted = holm_adjusted(raw);
  std::size_t next = 0;
  NamedTable made{StudyTests::kTable,
                  phrase("Analysis", "Tests"),
                  {{"test", "about", "n", "unit", "p", "p_holm", "family"}, {}},
                  note_on_family(raw.size())};
  const bool some_fail =
      std::any_of(tests_.begin(), tests_.end(), [](const Test& test) { return !test.p; });
  const bool some_cannot_show = std::any_of(
      tests_.begin(), tests_.end(), [](const Test& test) { return test.smallest_p.has_value(); });
  if (some_cannot_show) made.table.columns.push_back("p_smallest");
  if (some_fail) made.table.columns.push_back("status");
  for (Test& test : tests_) {
    const bool is_in = is_in_family(test.name);
    const double own = is_in ? adjusted[next++] : 1.0;
    if (is_in && test.p) test.adjusted = own;
    if (is_in) test.family_size = raw.size();
    std::vector<Cell>& row = made.table.rows.emplace_back();
    row = {test.name,
           test.about.empty() ? Cell{} : Cell{test.about},
           static_cast<std::int64_t>(test.n),
           test.unit,
           cell_of(test.p),
           cell_of(test.adjusted),
           is_in ? Cell{name_} : Cell{}};
    if (some_cannot_show) row.push_back(cell_of(test.smallest_p));
    if (some_fail) row.push_back(test.p ? Cell{} : Cell{test.status});
    Finding finding = finding_of(test);
    outcome.findings.push_back(finding);
    if (test.p) outcome.tests_in_tables.insert({name_of(finding), test.source});
    if (!is_in) continue;
    finding.quantity = "p.holm";
    finding.value = test.adjusted;
    const std::string family =
        " of the family " + name_ + (is_declared_ ? ", which the protocol declares" : "");
    finding.method += raw.size() == 1
                          ? "; the only test" + family + ", without adjustment"
                          : "; Holm over the " + std::to_string(raw.size()) + " tests" + family;
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(made));
}

Phrase percent(double share) { return reading_percent(share); }

Phrase p_text(const StudyTests::Test& test) {
  const double p = test.adjusted.value_or(test.p.value_or(1.0));
  const Phrase text =
      (!test.adjusted          ? phrase("Analysis", "%1, uncorrected")
       : test.family_size == 1 ? phrase("Analysis", "%1, the only confirmatory test")
                               : phrase("Analysis", "%1, Holm-corrected"))
          .with(reading_p(p));
  if (!test.smallest_p) return text;
  return phrase("Analysis", "%1; the smallest attainable is %2")
      .with(text, reading_p(*test.smallest_p));
}

Phrase said_of(const StudyTests::Test& test, const Sayings& sayings) {
  if (test.adjusted) return test.shows() ? sayings.claim : sayings.nothing;
  return phrase("Analysis",
                "%1 This test is not of the study's family and shows no more than what to ask next "
                "time.")
      .with(sayings.told);
}

Phrase interval_text(const Finding& share) {
  if (share.low && share.high) {
    return phrase("Analysis", "95 % interval %1 to %2")
        .with(percent(*share.low), percent(*share.high));
  }
  return phrase("Analysis", "one participant has no interval");
}

void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding, CountedUnit unit) {
  AnsweredQuestion& added = outcome.questions.emplace_back();
  added.name = name;
  added.question = std::move(question);
  added.answer = std::move(answer);
  added.method = std::move(method);
  added.table = table;
  if (finding == nullptr) {
    added.finding.status = added.answer.english();
    return;
  }
  added.finding = *finding;
  added.counted = counted_units(finding->n, unit);
}

void ask_sexes(const SexesComparison& sexes, const StudyTests& tests, AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("sexes", "F|M");
  const auto has_value = [](const std::optional<Finding>& one) { return one && one->value; };
  if (!has_value(sexes.women) || !has_value(sexes.men) || !has_value(sexes.difference) ||
      test == nullptr) {
    return;
  }
  const bool are_shares = sexes.scale != SexesScale::items;
  const auto mean = [are_shares](const Finding& of) {
    return phrase("Analysis", "%1 (%2, n = %3)")
        .with(are_shares ? percent(*of.value) : Phrase(signed_number(*of.value, 2)),
              are_shares ? interval_text(of) : plain_interval(of, 2), std::to_string(of.n));
  };
  const Phrase means =
      (sexes.scale == SexesScale::shares_of_answers
           ? phrase("Analysis", "women are right in %1 of their answers on average, men in %2")
       : sexes.scale == SexesScale::shares_of_items
           ? phrase("Analysis", "women have %1 of their items right on average, men %2")
           : phrase("Analysis", "women have %1 items of a go right on average, men %2"))
          .with(mean(*sexes.women), mean(*sexes.men));
  Finding shown = *sexes.difference;
  for (std::optional<double>* number : {&shown.value, &shown.low, &shown.high}) {
    if (*number && are_shares) **number *= 100.0;
  }
  const int digits = are_shares ? 1 : 2;
  const Phrase difference =
      (are_shares ? phrase("Analysis", "%1 percentage points (%2)")
                  : phrase("Analysis", "%1 items (%2)"))
          .with(signed_number(*shown.value, digits), interval_of_difference(shown, digits));
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(means, difference, p_text(*test));
  };
  const Sayings sayings{
      with_numbers(phrase("Analysis",
                          "They do: %1; women less men is %2. Splitting the participants anew "
                          "gives %3.")),
      with_numbers(phrase("Analysis",
                          "Nothing shows that they do: %1; women less men is %2. Splitting the "
                          "participants anew gives %3. That does not show that they are alike.")),
      with_numbers(phrase("Analysis",
                          "Of these participants %1; women less men is %2. Splitting the "
                          "participants anew gives %3."))};
  add_question(
      outcome, "sexes", phrase("Analysis", "Do women and men differ?"), said_of(*test, sayings),
      sexes.women->n + sexes.men->n <= kMostPermuted
          ? phrase("Analysis",
                   "Means of the participants' own results with CIs by Student's t, of proportions "
                   "on the logit scale; their difference with Welch's CI. The p is of another "
                   "method, which assumes less: all "
                   "ways to split the participants into groups of these sizes. Where one just "
                   "excludes that there is no difference, the other need not.")
          : phrase("Analysis",
                   "Means of the participants' own results with CIs by Student's t, of proportions "
                   "on the logit scale; their difference with Welch's CI. The p is of another "
                   "method, which assumes less: %1 "
                   "random ways to split the participants into groups of these sizes, of which "
                   "there are too many to count all. Where one just excludes that there is no "
                   "difference, the other need not.")
                .with(std::to_string(kRandomSplits)),
      "tests", &*sexes.difference);
}

void add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                 const std::string& key_column, const std::string& quantity,
                 AnalysisOutcome& outcome, const char* name) {
  NamedTable made{
      name,
      phrase("Analysis", "The person as the unit: each person's own share, over the persons"),
      {{key_column, "persons", "mean", "mean_low", "mean_high", "sd", "minimum", "median",
        "maximum"},
       {}},
      phrase("Analysis",
             "95 % CI of the mean: Student's t over the participants on the logit scale. In "
             "simulations with 2 to 20 participants it contained the true mean in 91 % or more of "
             "the studies.")};
  for (const PersonsRow& row : rows) {
    const Finding* mean = found.find("subj.mean", row.key);
    if (mean == nullptr || !mean->value) continue;
    const auto [low, high] = found.interval("subj.mean", row.key);
    made.table.rows.push_back(
        {row.name, static_cast<std::int64_t>(mean->n), *mean->value, low, high,
         found.cell("subj.sd", row.key), found.cell("subj.minimum", row.key),
         found.cell("subj.median", row.key), found.cell("subj.maximum", row.key)});
    Finding finding = *mean;
    finding.quantity = "mean_of_persons_" + quantity;
    finding.key = key_column + '=' + row.name;
    finding.analysis.clear();
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(made));
}

void add_measures(const FoundNumbers& found, std::span<const Measure> measures,
                  AnalysisOutcome& outcome) {
  NamedTable made{"measures",
                  phrase("Analysis", "Measures of all answers together"),
                  {{"measure", "value", "value_low", "value_high", "unit"}, {}},
                  {}};
  for (const Measure& measure : measures) {
    const Finding* finding = found.find(measure.quantity);
    if (finding == nullptr) continue;
    const auto [low, high] = found.interval(measure.quantity);
    Cell value = finding->value ? Cell{*finding->value} : Cell{finding->word};
    if (finding->value && measure.form == Measure::Form::count) {
      value = static_cast<std::int64_t>(std::llround(*finding->value));
    }
    made.table.rows.push_back({measure.name, value, low, high, finding->unit});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity
