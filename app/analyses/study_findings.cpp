#include "app/analyses/study_findings.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/multiplicity.h"
#include "analysis/number_text.h"

namespace asperity {

namespace {

constexpr const char* kTests = "tests";
constexpr std::string_view kParticipants = "participants";

Finding finding_of(const StudyTests::Test& test) {
  Finding finding{};
  finding.quantity = "p";
  finding.key = "test=" + test.name + (test.about.empty() ? "" : " about=" + test.about);
  finding.value = test.p;
  finding.unit = "1";
  finding.method = test.method;
  finding.status = test.status;
  finding.n = test.n;
  finding.analysis = kTests;
  return finding;
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
                     const char* unit) {
  Test& test = tests_.emplace_back(Test{.name = name, .about = about, .unit = unit});
  if (finding == nullptr) {
    test.status = "there are no answers of which this could be tested";
    return;
  }
  test.n = finding->n;
  test.method = finding->method;
  if (test.unit != kParticipants) test.method += "; n counts " + test.unit;
  test.p = finding->value;
  if (!test.p) test.status = finding->status;
}

const StudyTests::Test* StudyTests::find(std::string_view name, std::string_view about) const {
  const auto found = std::find_if(tests_.begin(), tests_.end(), [&](const Test& test) {
    return test.name == name && test.about == about;
  });
  return found == tests_.end() ? nullptr : &*found;
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
  NamedTable made{
      kTests,
      phrase("Analysis", "Tests"),
      {{"test", "about", "n", "unit", "p", "p_holm", "family"}, {}},
      is_declared_
          ? phrase(
                "Analysis",
                "p_holm: adjusted after Holm over the %1 tests of the family that the protocol "
                "declares (%2); one that cannot be made counts as p = 1. Tests outside the family "
                "are not adjusted and show no more than what to ask next time. n counts the units "
                "beside it; answers and goes are pooled as if they "
                "were independent.")
                .with(std::to_string(raw.size()), name_)
          : phrase("Analysis",
                   "The protocol declares no family of tests. p_holm: adjusted after Holm over the "
                   "%1 tests of the family that this kind of protocol has by itself (%2); one that "
                   "cannot be made counts as p = 1. The other tests are not adjusted and show no "
                   "more than what to ask next time. n counts the units beside it; answers and "
                   "goes are pooled as if they "
                   "were independent.")
                .with(std::to_string(raw.size()), name_)};
  const bool some_fail =
      std::any_of(tests_.begin(), tests_.end(), [](const Test& test) { return !test.p; });
  if (some_fail) made.table.columns.push_back("status");
  for (Test& test : tests_) {
    const bool is_in = is_in_family(test.name);
    const double own = is_in ? adjusted[next++] : 1.0;
    if (is_in && test.p) test.adjusted = own;
    std::vector<Cell>& row = made.table.rows.emplace_back();
    row = {test.name,
           test.about.empty() ? Cell{} : Cell{test.about},
           static_cast<std::int64_t>(test.n),
           test.unit,
           cell_of(test.p),
           cell_of(test.adjusted),
           is_in ? Cell{name_} : Cell{}};
    if (some_fail) row.push_back(test.p ? Cell{} : Cell{test.status});
    Finding finding = finding_of(test);
    outcome.findings.push_back(finding);
    if (!test.adjusted) continue;
    finding.quantity = "p.holm";
    finding.value = test.adjusted;
    finding.method += "; Holm over the " + std::to_string(raw.size()) + " tests of the family " +
                      name_ + (is_declared_ ? ", which the protocol declares" : "");
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(made));
}

Phrase percent(double share) { return fixed(100.0 * share, 0) + " %"; }

Phrase p_text(const StudyTests::Test& test) {
  const double p = test.adjusted.value_or(test.p.value_or(1.0));
  const std::string number = p < 0.001 ? "p < 0.001" : "p = " + fixed(p, 3);
  return (test.adjusted ? phrase("Analysis", "%1 after Holm")
                        : phrase("Analysis", "%1 without adjustment"))
      .with(number);
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
        .with(percent(std::max(0.0, *share.low)), percent(std::min(1.0, *share.high)));
  }
  if (share.n < 2) return phrase("Analysis", "one participant has no interval");
  return phrase("Analysis", "all participants alike, which gives no interval");
}

void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding) {
  AnsweredQuestion& added = outcome.questions.emplace_back();
  added.name = name;
  added.question = std::move(question);
  added.answer = std::move(answer);
  added.method = std::move(method);
  added.table = table;
  if (finding != nullptr) {
    added.finding = *finding;
  } else {
    added.finding.status = added.answer.english();
  }
}

void ask_sexes(const Finding* difference, SexesTest how, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("sexes", "F|M");
  if (difference == nullptr || !difference->value || test == nullptr) return;
  const Phrase question = phrase("Analysis", "Do women and men differ?");
  const Phrase method =
      how == SexesTest::all_splits
          ? phrase("Analysis",
                   "The difference of the means of the participants' own results, against all "
                   "ways to split the participants into groups of these sizes.")
          : phrase("Analysis",
                   "The means of the participants' own results, compared by Welch's t: there are "
                   "too many participants to count all ways to split them.");
  if (!test->p) {
    add_question(
        outcome, "sexes", question,
        phrase("Analysis", "Women less men is %1. It is not tested: the table of tests says why.")
            .with(fixed(*difference->value, 2)),
        method, "tests", difference);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(fixed(*difference->value, 2), p_text(*test));
  };
  const Sayings sayings{
      with_numbers(phrase("Analysis", "They do: women less men is %1 (%2).")),
      with_numbers(phrase("Analysis",
                          "Nothing shows that they do: women less men is %1 (%2). That does not "
                          "show that they are alike.")),
      with_numbers(phrase("Analysis", "Women less men is %1 (%2)."))};
  add_question(outcome, "sexes", question, said_of(*test, sayings), method, "tests", difference);
}

void add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                 const std::string& key_column, const std::string& quantity,
                 AnalysisOutcome& outcome) {
  NamedTable made{
      "persons",
      phrase("Analysis", "The person as the unit: each person's own share, over the persons"),
      {{key_column, "persons", "mean", "mean_low", "mean_high", "sd", "minimum", "median",
        "maximum"},
       {}},
      phrase("Analysis", "The interval of the mean is Student's, over the persons.")};
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
    const Cell value = finding->value ? Cell{*finding->value} : Cell{finding->word};
    made.table.rows.push_back({measure.name, value, low, high, finding->unit});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity
