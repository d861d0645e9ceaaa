// Chooses the tests that a paper reports, and joins methods, statistics, results and references.

#include "app/report/text/report_paper.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/references.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/test_methods.h"
#include "app/report/text/report_exploration.h"
#include "app/study_files/program.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// Of one kind of test. More of them are counted in one sentence, which a reader can take in.
constexpr std::size_t kMostAlike = 12;
/// Of all exploratory tests. A kind that does not fit is counted in one sentence.
constexpr std::size_t kMostExploratory = 24;

bool is_of_family(const TestSentence& each) { return each.role != TestRole::exploratory; }

/// The tests of one kind in one role, in their order.
struct TestsOfKind {
  std::vector<const TestSentence*> all{};
  std::size_t made = 0;  ///< those that could be made
};
using KindOfTest = std::pair<std::string, TestRole>;

KindOfTest kind_of(const TestSentence& each) { return {each.test, each.role}; }

/// The tests of an outcome that a paper reports. Refers to the outcome.
struct ReportedTests {
  /// Those of the family first. Without the kinds of exploratory tests of which none could be made.
  std::vector<const TestSentence*> in_order{};
  std::map<KindOfTest, TestsOfKind> kinds{};
};

ReportedTests reported_tests(const AnalysisOutcome& outcome) {
  ReportedTests reported{};
  for (const TestSentence& each : outcome.test_sentences) {
    TestsOfKind& kind = reported.kinds[kind_of(each)];
    kind.all.push_back(&each);
    kind.made += each.is_untested ? 0 : 1;
    if (is_of_family(each)) reported.in_order.push_back(&each);
  }
  for (const TestSentence& each : outcome.test_sentences) {
    const bool is_made = reported.kinds[kind_of(each)].made > 0;
    if (!is_of_family(each) && is_made) reported.in_order.push_back(&each);
  }
  return reported;
}

/// Where no analysis is shown.
std::string withheld_text(const ReportFacts& facts) {
  return display_count(facts.attempts) +
         (facts.attempts == 1 ? " attempt at a trial is" : " attempts at trials are") +
         " stored; there are no results.";
}

/// "The 18 attempts at trials were analysed", "Two of the 18 …", "None of the 18 …"
/// `excluded`: participants without attempts in the results, by a rule of the protocol.
std::string analysed_text(const ReportFacts& facts, const std::set<std::string>& excluded) {
  const std::string all = facts.attempts == 1
                              ? "the only attempt at a trial"
                              : "the " + display_count(facts.attempts) + " attempts at trials";
  if (facts.counted == 0) {
    return facts.attempts == 1 ? "The only attempt at a trial was not included in the analysis."
                               : "None of " + all + " was included in the analysis.";
  }
  std::vector<std::string> fates = fates_of_attempts(facts);
  std::size_t of_excluded = 0;
  for (const ReportedSession& session : facts.sessions) {
    if (excluded.contains(session.row.participant)) of_excluded += session.counted_attempts;
  }
  if (of_excluded > 0) {
    fates.push_back(count_in_words(of_excluded) + (of_excluded == 1 ? " was" : " were") +
                    " made by " + participants_text(facts.group, excluded.size()) +
                    " whom the rule of the protocol for errors in catch trials excludes");
  }
  const std::size_t counted = facts.counted - of_excluded;
  const bool is_all = counted == facts.attempts;
  const std::string others = is_all ? "" : " (of the others, " + listed(fates) + ')';
  const auto analysed = static_cast<std::size_t>(
      std::count_if(facts.counted_participants.begin(), facts.counted_participants.end(),
                    [&excluded](const std::string& each) { return !excluded.contains(each); }));
  const std::string of_participants =
      analysed == facts.participants.size()
          ? ""
          : " They were made by " + count_in_words(analysed) + " of the " +
                participants_text(facts.group, facts.participants.size()) + '.';
  return (is_all ? capitalised(all) : capitalised(count_in_words(counted)) + " of " + all) +
         (counted == 1 ? " was" : " were") + " analysed" + others + ", with Asperity " +
         program_version() + '.' + of_participants;
}

/// Of one of several kinds of responses: that its results leave out the participants whom a rule excludes.
std::string excluded_text(const ReportFacts& facts, const AnalysisOutcome& outcome) {
  const std::size_t excluded = excluded_participants(outcome).size();
  if (excluded == 0) return {};
  return "The analysis of the " + name_of_kind(outcome.kind) +
         " does not include the attempts of " + participants_text(facts.group, excluded) +
         " whom the rule of the protocol for errors in catch trials excludes.";
}

std::string declaration_text(FamilyDeclaration family) {
  switch (family) {
    case FamilyDeclaration::none:
      return "No test was declared in advance: all tests are exploratory.";
    case FamilyDeclaration::of_other_kinds:
      return "No test of these responses was declared in advance: all of them are exploratory.";
    case FamilyDeclaration::differs_between_files:
      return "The files of the protocol declare different tests: all tests are treated as "
             "exploratory.";
    case FamilyDeclaration::declared:
      break;
  }
  return {};
}

std::string correction_text(const AnalysisOutcome& outcome, Sources& sources) {
  if (outcome.test_sentences.empty()) return {};
  std::vector<std::string> names{};  // of the tests in the family
  std::size_t family = 0;
  std::size_t made = 0;
  for (const TestSentence& each : outcome.test_sentences) {
    if (!is_of_family(each)) continue;
    ++family;
    if (!each.is_untested) ++made;
    const std::string name = words_of_test(each.test).english();
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const bool is_declared = outcome.family == FamilyDeclaration::declared;
  const std::string declaration = declaration_text(outcome.family);
  if (family < 2 || made == 0) return declaration;
  return with_sentences(
      {declaration,
       "The p values of the " + display_count(family) +
           (is_declared ? " confirmatory tests" : " tests") + " (" + listed(names) +
           ") were Holm-corrected" + cited("Holm 1979", sources) +
           (made < family ? "; a test that could not be computed counts as p = 1." : ".")});
}

/// A name followed by its citation: "Cohen’s d (Cohen, 1988)".
std::string cited_name(const Phrase& name, std::string_view source, Sources& sources) {
  return name.english() + (source.empty() ? "" : cited(std::string(source), sources));
}

/// "Tests: one-sample t test, effect size Cohen’s d (Cohen, 1988); …": each once.
std::string methods_text(const ReportedTests& reported, Sources& sources) {
  struct Used {
    const TestMethod* method = nullptr;
    std::vector<std::string> effects{};
  };
  std::vector<Used> all{};
  for (const TestSentence* const each : reported.in_order) {
    if (each->made_by == nullptr) continue;
    const TestMethod& by = *each->made_by;
    auto used = std::find_if(all.begin(), all.end(),
                             [&by](const Used& one) { return one.method->code == by.code; });
    if (used == all.end()) used = all.insert(all.end(), {.method = &by});
    if (!each->has_effect || by.effect_name.empty()) continue;
    const std::string effect = cited_name(by.effect_name, by.sources[1], sources);
    if (std::find(used->effects.begin(), used->effects.end(), effect) == used->effects.end()) {
      used->effects.push_back(effect);
    }
  }
  std::string text{};
  for (const Used& used : all) {
    text += (text.empty() ? "" : "; ") +
            cited_name(used.method->name, used.method->sources[0], sources);
    if (used.effects.empty()) continue;
    text +=
        (used.effects.size() == 1 ? ", effect size " : ", effect sizes ") + listed(used.effects);
  }
  if (text.empty()) return {};
  return (all.size() == 1 ? "Test: " : "Tests: ") + text + '.';
}

/// The statistics of one kind of responses.
std::string paper_statistics(const ReportFacts& facts, const AnalysisOutcome& outcome,
                             const ReportedTests& reported, Sources& sources) {
  std::vector<std::string> sentences{};
  const StudyAnalysis* const analysis = find_analysis(outcome.kind);
  if (analysis != nullptr && analysis->fit_for_paper != nullptr && facts.file.protocol) {
    sentences.push_back(
        with_citations(analysis->fit_for_paper(*facts.file.protocol, outcome), sources));
  }
  sentences.push_back(correction_text(outcome, sources));
  const auto is_any = [&reported](const auto& is_so) {
    return std::any_of(reported.in_order.begin(), reported.in_order.end(),
                       [&is_so](const TestSentence* each) { return is_so(*each); });
  };
  if (is_any([](const TestSentence& each) { return !each.is_untested; })) {
    sentences.emplace_back("The significance level was .05.");
  }
  if (!outcome.transformation.empty()) {
    sentences.push_back(outcome.transformation);
  } else if (analysis != nullptr) {
    const bool is_stated = analysis->transformation_of != nullptr && facts.file.protocol;
    sentences.push_back(is_stated ? analysis->transformation_of(*facts.file.protocol)
                                  : std::string(analysis->transformation));
  }
  if (estimate_sentence(outcome).has_mean_interval ||
      is_any([](const TestSentence& each) { return each.has_mean_interval; })) {
    sentences.emplace_back(
        "Confidence intervals (CI) of mean proportions are based on Student's t over participants "
        "on the logit scale.");
  }
  sentences.push_back(methods_text(reported, sources));
  sentences.push_back(exploration_method(outcome, sources));
  return with_sentences(sentences);
}

/// "; with these participants none of them could be significant: the smallest attainable p is .352, and at least 11 participants
/// whose difference is not zero are required" of tests none of which could be; empty otherwise.
std::string unattainable_text(std::span<const TestSentence* const> alike) {
  std::optional<double> smallest{};
  std::size_t required = 0;
  for (const TestSentence* each : alike) {
    if (each->is_untested || !each->p) continue;
    if (!each->unattainable_p) return {};
    smallest = std::min(smallest.value_or(1.0), *each->unattainable_p);
    required = std::max(required, each->required_n.value_or(0));
  }
  if (!smallest) return {};
  std::string text =
      "; with these participants none of them could be significant: the smallest attainable p is " +
      display_p_cell(*smallest);
  if (required > 0) {
    text += ", and at least " + display_count(required) +
            " participants whose difference is not zero are required";
  }
  return text;
}

/// "38 of the 45 tests of pairs were significant (largest of these p values, Holm-corrected: .034). …"
std::string counted_sentence(std::span<const TestSentence* const> alike) {
  const TestSentence& first = *alike.front();
  std::size_t significant = 0;
  std::size_t untested = 0;
  double largest = 0.0;
  double smallest = 1.0;
  for (const TestSentence* each : alike) {
    if (each->is_untested || !each->p) {
      ++untested;
      continue;
    }
    smallest = std::min(smallest, *each->p);
    if (!each->is_significant) continue;
    ++significant;
    largest = std::max(largest, *each->p);
  }
  const bool is_confirmatory = first.role == TestRole::confirmatory;
  const std::string corrected = is_of_family(first) ? "Holm-corrected" : "uncorrected";
  const std::string all = "the " + display_count(alike.size()) +
                          (is_confirmatory ? " tests of " : " exploratory tests of ") +
                          words_of_test(first.test).english();
  const std::string size = is_confirmatory ? " significant" : " below .05";
  std::string text = significant == 0 ? "None of " + all + " was" + size + " (smallest p value, " +
                                            corrected + ": " + display_p_cell(smallest) + ')'
                                      : capitalised(count_in_words(significant)) + " of " + all +
                                            (significant == 1 ? " was" : " were") + size +
                                            " (largest of these p values, " + corrected + ": " +
                                            display_p_cell(largest) + ')';
  text += unattainable_text(alike);
  if (untested > 0) {
    text += "; " + count_in_words(untested) + " could not be computed";
  }
  return text + ". The table of tests contains them with their effect sizes.";
}

/// The sentences of the tests in their order; of many tests of one kind, one sentence, which counts all of them.
std::vector<TestSentence> counted_where_many(const ReportedTests& reported) {
  std::vector<TestSentence> told{};
  std::set<KindOfTest> single{};  // kinds whose tests have a sentence each
  std::size_t exploratory = 0;
  for (const TestSentence* const each : reported.in_order) {
    const bool of_family = is_of_family(*each);
    const TestsOfKind& kind = reported.kinds.at(kind_of(*each));
    if (kind.all.front() == each) {
      const bool fits = of_family ? kind.all.size() <= kMostAlike
                                  : kind.made == 1 || (kind.made <= kMostAlike &&
                                                       exploratory + kind.made <= kMostExploratory);
      if (fits) single.insert(kind_of(*each));
      if (fits && !of_family) exploratory += kind.made;
      if (!fits) {
        told.push_back(*each);
        told.back().text = counted_sentence(kind.all);
      }
    }
    const bool is_told = of_family || !each->is_untested;
    if (is_told && single.contains(kind_of(*each))) told.push_back(*each);
  }
  return told;
}

std::string results_paragraph(const AnalysisOutcome& outcome, const ReportedTests& reported) {
  std::vector<std::string> sentences{estimate_sentence(outcome).text};
  // Without a declaration all tests are exploratory, as the methods section states.
  bool follows_confirmatory = false;
  for (const TestSentence& each : counted_where_many(reported)) {
    const bool is_confirmatory = each.role == TestRole::confirmatory;
    if (follows_confirmatory && !is_confirmatory) {
      sentences.emplace_back("The following tests are exploratory.");
    }
    follows_confirmatory = is_confirmatory;
    sentences.push_back(each.text);
  }
  sentences.push_back(exploration_results(outcome));
  return with_sentences(sentences);
}

}  // namespace

std::string cited(const std::string& key, Sources& sources) {
  sources.insert(key);
  return " (" + std::string(reference(key).cited) + ')';
}

std::string with_citations(std::string text, Sources& sources) {
  for (const Reference& each : references()) {
    const std::string mark = " [" + std::string(each.key) + ']';
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
      const std::string shown = cited(std::string(each.key), sources);
      text.replace(at, mark.size(), shown);
      at += shown.size();
    }
  }
  return text;
}

std::string with_sentences(const std::vector<std::string>& sentences) {
  std::string text{};
  for (const std::string& sentence : sentences) {
    if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

ReportSection paper_section(const ReportFacts& facts,
                            std::span<const AnalysisOutcome* const> outcomes,
                            const StudyMetadata& metadata) {
  ReportSection section{"Text for a paper", {}};
  Sources sources{};
  const auto add = [&section](const std::string& heading,
                              const std::vector<std::string>& paragraphs) {
    bool has_heading = false;
    for (const std::string& text : paragraphs) {
      if (text.empty()) continue;
      if (!has_heading) section.parts.emplace_back(ReportText{heading, ReportText::Tone::lead});
      has_heading = true;
      section.parts.emplace_back(ReportText{text});
    }
  };
  const auto of_kind = [&outcomes](const AnalysisOutcome& outcome) {
    return outcomes.size() > 1 ? " (" + name_of_kind(outcome.kind) + ")" : std::string();
  };
  std::vector<ReportedTests> tests{};  // by outcome
  for (const AnalysisOutcome* const outcome : outcomes) tests.push_back(reported_tests(*outcome));
  std::vector<std::string> methods = paper_procedure(facts, metadata, sources);
  std::vector<std::string> analysis{};
  if (outcomes.empty()) analysis.push_back(withheld_text(facts));
  if (!outcomes.empty() && facts.attempts > 0) {
    analysis.push_back(analysed_text(facts, outcomes.size() == 1
                                                ? excluded_participants(*outcomes.front())
                                                : std::set<std::string>{}));
    for (const AnalysisOutcome* const outcome : outcomes) {
      if (outcomes.size() > 1) analysis.push_back(excluded_text(facts, *outcome));
    }
  }
  if (outcomes.size() == 1) {
    analysis.push_back(paper_statistics(facts, *outcomes.front(), tests.front(), sources));
  }
  methods.push_back(with_sentences(analysis));
  add("Methods", methods);
  for (std::size_t i = 0; outcomes.size() > 1 && i < outcomes.size(); ++i) {
    add("Statistics" + of_kind(*outcomes[i]),
        {paper_statistics(facts, *outcomes[i], tests[i], sources)});
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    add("Results" + of_kind(*outcomes[i]), {results_paragraph(*outcomes[i], tests[i])});
  }
  if (!sources.empty()) {
    ReportList entries{};
    for (const std::string& key : sources) entries.items.emplace_back(reference(key).entry);
    section.parts.emplace_back(ReportText{"References", ReportText::Tone::lead});
    section.parts.emplace_back(std::move(entries));
  }
  return section;
}

}  // namespace asperity
