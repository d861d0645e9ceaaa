// The sections with the results: answers, tables with their figures, and the numbers that could not be computed.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/methods/discrimination/choice_model.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/displayed_table.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_methods.h"
#include "app/findings/shared/exploration.h"
#include "app/findings/shared/exploration_model.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/quantity_name.h"
#include "app/report/text/report_numbers.h"
#include "app/report/text/report_sections.h"
#include "app/report/text/report_tests.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

constexpr std::size_t kMostSentences = 16;  // the table lists more
constexpr std::size_t kMostKeys = 6;        // of one refusal

/// Reports the same estimate and p only once.
using Told = std::set<std::pair<double, double>>;

/// The rows for all data of a table of counted proportions with intervals, as text.
std::vector<std::string> answers_in(const ResultTable& table, Told& told) {
  using namespace columns;
  const std::optional<std::size_t> of = table.find(kOf);
  if (!table.has(kShare) || !table.has(kWilson) || !of || *of == 0) return {};
  const std::size_t hits = *of - 1;  // the counted column; the keys precede it
  struct Proportion {
    std::vector<std::string> keys{};
    std::string text{};
    std::pair<double, double> numbers{};
  };
  std::vector<Proportion> answers{};
  std::set<std::size_t> whole_places{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const auto value = row.number(kShare);
    if (!value) continue;
    const auto count = [&row](const ResultColumn& column) {
      return display_whole(std::llround(row.number(column).value_or(0.0)));
    };
    Proportion& answer = answers.emplace_back();
    std::string key{};
    for (std::size_t i = 0; i < hits; ++i) {
      answer.keys.push_back(row.text(table.columns[i]));
      if (answer.keys.back() == "all" || answer.keys.back() == "Total") whole_places.insert(i);
      key += (key.empty() ? "" : " ") + table.columns[i].id + '=' + answer.keys.back();
    }
    const std::string about = words_of_key(key);
    const Interval interval = row.interval(kWilson);
    // Names from the study are unchanged.
    answer.text = (about.starts_with("all ") ? capitalised(about) : about) + ": " +
                  count(table.columns[hits]) + ' ' + table.columns[hits].id + " of " + count(kOf) +
                  " (" + display_percent(*value) + "; 95 % CI [" +
                  display_percent(interval.low.value_or(0.0)) + ", " +
                  display_percent(interval.high.value_or(1.0)) + "])";
    if (const auto by_chance = row.number(kChance)) {
      answer.text += ", compared with a chance level of " + display_percent(*by_chance);
    }
    if (const auto p = row.number(kP)) {
      answer.text += "; " + display_p(*p);
      answer.numbers = {*value, *p};
    }
    if (table.has(kPersons)) answer.text += " (n = " + count(kPersons) + ')';
    answer.text += '.';
  }
  std::vector<std::string> sentences{};
  for (const Proportion& answer : answers) {
    const bool is_part =
        std::any_of(whole_places.begin(), whole_places.end(), [&answer](std::size_t place) {
          return answer.keys[place] != "all" && answer.keys[place] != "Total";
        });
    if (is_part) continue;
    told.insert(answer.numbers);
    sentences.push_back(answer.text);
  }
  return sentences;
}

/// The tests that are in no table of the outcome.
std::vector<ReportedTest> other_tests(const AnalysisOutcome& outcome) {
  std::vector<ReportedTest> others = tests_among(outcome.findings);
  std::erase_if(others, [&outcome](const ReportedTest& test) {
    return outcome.tests_in_tables.contains(name_of(*test.p));
  });
  return others;
}

/// For an analysis without a table of tests and questions: the tests that are adjusted for their
/// family, or that concern all data.
std::vector<std::string> tests_in_words(const AnalysisOutcome& outcome, const Told& told) {
  std::vector<std::string> sentences{};
  for (const ReportedTest& test : tests_among(outcome.findings)) {
    if (sentences.size() == kMostSentences) break;
    const bool is_told =
        !test.estimates.empty() && told.contains({*test.estimates.front()->value, *test.p->value});
    const bool is_of_all = test.is_of_whole && !outcome.tests_in_tables.contains(name_of(*test.p));
    if (!is_told && (test.holm != nullptr || is_of_all)) sentences.push_back(sentence_of(test));
  }
  return sentences;
}

/// Keeps "95 %" on one line.
std::string unbroken(std::string heading) {
  constexpr std::string_view kPercent = " %";
  const std::size_t at = heading.find(kPercent);
  if (at != std::string::npos) heading.replace(at, kPercent.size(), "\u00A0%");
  return heading;
}

ReportTable report_table(const ResultTable& result) {
  const DisplayedTable displayed_table = displayed(result, Reader::report);
  ReportTable table{};
  table.title = result.title.english();
  table.note = result.note.english();
  for (const DisplayedColumn& column : displayed_table.columns) {
    table.columns.push_back({unbroken(column.heading.english()), !column.holds_words});
  }
  for (const std::vector<Phrase>& row : displayed_table.rows) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (const Phrase& cell : row) cells.push_back(cell.empty() ? "–" : cell.english());
  }
  return table;
}

/// The subject of a finding that can lack a number; its name as text where there is no other.
std::string words_of_unanswered(const std::string& quantity) {
  struct Words {
    QuantityName name{};
    const char* words = "";
  };
  static constexpr Words kWords[]{
      {"auc", "the area under the ROC"},
      {"bt.cluster.status", "the CIs of the scale of the items"},
      {"bt.firth.status", "the scale of the items with Firth’s correction"},
      {"bt.order.status", "the order effect on the scale of the items"},
      {"bt.se.cluster", "the cluster-robust standard errors of the scale of the items"},
      {"bt.se.sumzero.cluster", "the cluster-robust standard errors of the scale of the items"},
      {"bt.status", "the scale of the items (Bradley–Terry)"},
      {"cochran.Q", "Cochran’s Q"},
      {"dprime", "the sensitivity d′"},
      {"ev.mu", "the normal model of the ROC with equal variances"},
      {"exponent.t", "the test of the exponent"},
      {"friedman.chisq", "Friedman’s test"},
      {"glm.se.cluster", "the cluster-robust standard errors of the logistic regression"},
      {"geomean.jnd", "the mean just-noticeable difference"},
      {"geomean.jnd.dprime1", "the mean just-noticeable difference at d′ = 1"},
      {"geomean.jnd.posterior", "the mean of the posterior just-noticeable differences"},
      {"geomean.weber", "the mean Weber fraction"},
      {"mean.pse", "the mean point of subjective equality"},
      {"geomean.status", "the CI of the geometric mean response time"},
      {"glm.status", "the logistic regression"},
      {"glmm.status", "the mixed model with participants and textures crossed"},
      {"half.difference.status", "the CI of the change of the proportion correct over the trials"},
      {"half.ratio.status", "the CI of the change of response times over the trials"},
      {"icc", "the reliability over repetitions"},
      {"icc.mean", "the reliability over repetitions"},
      {"hclust.average.height", "the dendrogram"},
      {"property.r2", "the relation to the configuration"},
      {"region.major", "the ellipses of the positions"},
      {"stress.ordinal", "the configuration"},
      {"jnd", "the just-noticeable difference"},
      {"jnd.dprime1", "the just-noticeable difference at d′ = 1"},
      {"jnd.posterior", "the posterior mean of the just-noticeable difference"},
      {"lmm.beta", "the effect on times"},
      {"lmm.status", "the linear mixed model of times"},
      {"mallows.theta", "Mallows’ θ"},
      {"mauchly.W", "Mauchly’s test of sphericity"},
      {"mixed.status", "the logistic regression with random intercepts"},
      {"model.fit.p", "the goodness of fit of the scale of the items"},
      {"p", "the test"},
      {"peak.status", "the peak of the curve"},
      {"pl.cluster.status", "the CIs of the scale of the items"},
      {"pl.status", "the scale of the items (Plackett–Luce)"},
      {"pse", "the point of subjective equality"},
      {"quad.c.t", "the test of the curvature"},
      {"recall", "the recall"},
      {"relabel.W", "Kendall’s W"},
      {"scm.G2", "the goodness of fit of the similarity choice model"},
      {"scm.X2", "the goodness of fit of the similarity choice model"},
      {"scm.p", "the goodness of fit of the similarity choice model"},
      {"scm.status", "the similarity choice model"},
      {"signflip.d", "Cohen’s d of paired differences"},
      {"slope.ratio.status", "the CI of the change of response times per 10 trials"},
      {"subj.ci.lower", "the CI of the mean proportion"},
      {"subj.ci.upper", "the CI of the mean proportion"},
      {"subj.mean", "the mean proportion"},
      {"subj.sd", "the SD of the participants’ proportions"},
      {"subj.t", "the test of the mean proportion"},
      {"subj.t.p.two", "the test of the mean proportion"},
      {"tost.p", "the equivalence test"},
      {"trend.t", "the test of the trend"},
      {"uv.mu", "the normal model of the ROC with unequal variances"},
      {"weber", "the Weber fraction"},
      {"welch.t", "Welch’s test"}};
  for (const auto& [name, words] : kWords) {
    if (name == quantity) return words;
  }
  if (const TestMethod* method = test_method(quantity)) return "the " + method->name.english();
  const std::string words = words_of_number(quantity);
  const bool is_noun =
      !words.empty() && words.front() >= 'a' && words.front() <= 'z' && words[1] >= 'a';
  return (is_noun ? "the " : "") + words;
}

/// The subject of other findings; the two limits of an interval count as one.
std::string refused_quantity(std::string quantity) {
  bool is_end = false;
  for (const std::string_view ending : {".morey", ".upper", ".lower", ".ci"}) {
    if (!quantity.ends_with(ending)) continue;
    quantity.erase(quantity.rfind(ending));
    is_end = true;
  }
  std::string words = words_of_unanswered(quantity);
  if (words.empty()) words = (is_end ? "the " : "") + words_of_quantity(quantity);
  return (is_end ? "the CI of " : "") + words;
}

/// The subject of a complete analysis that could not be made.
std::string words_of_analysis_without_numbers(const std::string& analysis) {
  if (analysis == "anova") return "the analysis of variance";
  // With several tasks each has its own.
  if (analysis.starts_with(kChoiceModel)) return "the logistic mixed model of the choices";
  return analysis == "roughness" ? "the roughness curves" : "a part of the analysis";
}

/// Contact times and response times have the same quantities: "the linear mixed model of times" becomes that of contact times.
std::string with_modelled_times(std::string words, const std::string& analysis) {
  const std::string_view times = analysis == kContactTimeModel    ? " contact times"
                                 : analysis == kResponseTimeModel ? " response times"
                                                                  : "";
  constexpr std::string_view kTimes = " times";
  if (!times.empty() && words.ends_with(kTimes)) {
    words.replace(words.size() - kTimes.size(), kTimes.size(), times);
  }
  return words;
}

/// "62.5 µm, virtual0003" for all, 6.25e-05 and virtual0003: a key of condition, level and perhaps participant, with the unit of
/// the table that states the level.
std::string words_of_level_key(const Finding& finding, std::span<const ResultTable> tables) {
  const auto unit_of = [&](double value) {
    for (const ResultTable& table : tables) {
      for (const ResultRow& row : table.rows) {
        const auto* const level = std::get_if<Quantity>(&RowReader(table, row).cell(kLevelColumn));
        if (level != nullptr && level->value == value) return level->unit;
      }
    }
    return std::string();
  };
  std::vector<std::string> parts{};
  const std::vector<std::string>& key = finding.key.names();
  for (std::size_t i = 0; i < key.size(); ++i) {
    constexpr std::size_t kCondition = 0;
    constexpr std::size_t kLevel = 1;
    if (i == kCondition && key[i] == "all") continue;
    const auto value = i == kLevel ? number_in(key[i]) : std::nullopt;
    parts.push_back(value             ? stated_quantity(*value, unit_of(*value))
                    : i == kCondition ? words_of_condition(key[i])
                                      : key[i]);
  }
  std::string text{};
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// "the test of the mean proportion of height_map", or empty for an intermediate result.
std::string subject_of(const Finding& finding, std::span<const ResultTable> tables) {
  std::string words =
      is(finding, "status") ? words_of_analysis_without_numbers(finding.analysis)
      : is(finding, "icc") && finding.analysis == "agreement"
          ? "the agreement of the participants (ICC)"
          : with_modelled_times(words_of_unanswered(finding.quantity), finding.analysis);
  if (words.empty()) return {};
  const bool is_place = finding.analysis == "position" && number_in(finding.key.text());
  const bool is_level = finding.analysis == kSensitivity || finding.analysis == kConfidenceRoc;
  const std::string about = is_place   ? "position " + finding.key.text()
                            : is_level ? words_of_level_key(finding, tables)
                                       : words_of_key(finding.key);
  const bool says_whole = is(finding, "bt.order.status");
  return about.empty() || says_whole ? words : words + " of " + about;
}

/// Whether a remark reports it: rows were omitted or averaged, and no number is missing.
bool is_said_in_remarks(const Finding& finding) {
  return is(finding, "replicates") || is(finding, "subjects.incomplete") ||
         is(finding, "subjects.dropped");
}

/// The numbers that the analysis could not compute, one sentence for each reason.
std::vector<std::string> refusals_in(const AnalysisOutcome& outcome) {
  std::vector<std::string> reasons{};
  std::map<std::string, std::vector<std::string>> subjects{};
  std::size_t further = 0;
  for (const Finding& finding : outcome.findings) {
    if (finding.status == "ok" || is_said_in_remarks(finding)) continue;
    if (finding.analysis == StudyTests::kTable) continue;  // the table of tests contains the reason
    // A d′ that is infinite without a correction: the corrected one is in the table and the answer.
    if (finding.analysis == kSensitivity && finding.quantity.starts_with("dprime")) continue;
    // Stimuli without spacings have no peak, and the tables with the excluded participants contain their reasons.
    const bool is_of_stimuli = finding.analysis == kStimulusEstimates;
    if (is_of_stimuli && finding.quantity.starts_with("peak")) continue;
    if (finding.analysis.ends_with(kWithExcluded)) continue;
    std::string subject = subject_of(finding, outcome.tables);
    if (subject.empty() && finding.status == kNotDefined) {
      ++further;
      continue;
    }
    if (subject.empty()) {  // a specific reason is reported regardless of its subject
      const std::string about = words_of_key(finding.key);
      subject = refused_quantity(finding.quantity) + (about.empty() ? "" : " of " + about);
    }
    std::vector<std::string>& same = subjects[finding.status];
    if (same.empty()) reasons.push_back(finding.status);
    if (std::find(same.begin(), same.end(), subject) == same.end()) {
      same.push_back(std::move(subject));
    }
  }
  std::vector<std::string> sentences{};
  for (const std::string& reason : reasons) {
    std::vector<std::string> same = subjects[reason];
    if (same.size() > kMostKeys + 1) {
      const std::size_t more = same.size() - kMostKeys;
      same.resize(kMostKeys);
      same.push_back(display_count(more) + " more");
    }
    sentences.push_back(stopped(capitalised(listed(same)) + ": " + reason));
  }
  if (further > 0) {
    sentences.push_back(
        (further == 1 ? "One number of the appendix or of a table is"
                      : display_count(further) + " numbers of the appendix or of "
                                                 "tables are") +
        std::string(
            " not defined for these data; asperity analyze STUDY --json lists each by name."));
  }
  return sentences;
}

bool is_of_question(const Figure& figure, const AnalysisOutcome& outcome) {
  return std::any_of(outcome.questions.begin(), outcome.questions.end(),
                     [&figure](const AnsweredQuestion& question) {
                       return !question.name.empty() && question.name == figure.question;
                     });
}

/// The tables of the main text: counts and tests.
bool is_in_body(const ResultTable& table, const AnalysisOutcome& outcome) {
  return &table == &outcome.tables.front() || table.name == StudyTests::kTable;
}

void add_answer(const AnsweredQuestion& question, std::span<const Figure> figures,
                ReportSection& section) {
  section.parts.emplace_back(
      ReportText{question.question.english() + ' ' + question.answer.as_sentence().english(),
                 ReportText::Tone::lead});
  std::string method = question.method.as_sentence().english();
  if (!question.counted.empty()) {
    method += (method.empty() ? "n = " : " n = ") + question.counted.english() + '.';
  }
  if (!method.empty()) section.parts.emplace_back(ReportText{method});
  for (const Figure& figure : figures) {
    if (figure.question == question.name) section.parts.emplace_back(ReportFigure{0, figure});
  }
}

}  // namespace

ReportSection results_section(const AnalysisOutcome& outcome, std::span<const Figure> figures) {
  ReportSection section{"Results", {}};
  for (const AnsweredQuestion& question : outcome.questions) {
    add_answer(question, figures, section);
  }
  Told told{};
  if (outcome.questions.empty()) {
    for (const ResultTable& named : outcome.tables) {
      const std::vector<std::string> answers = answers_in(named, told);
      if (answers.empty()) continue;
      for (const std::string& answer : answers) {
        section.parts.emplace_back(ReportText{answer, ReportText::Tone::lead});
      }
      break;  // the first table is that of the main question
    }
    std::vector<std::string> sentences = tests_in_words(outcome, told);
    if (!sentences.empty()) section.parts.emplace_back(ReportList{std::move(sentences)});
  }
  for (const Phrase& remark : outcome.remarks) {
    section.parts.emplace_back(ReportText{remark.english(), ReportText::Tone::notice});
  }
  for (const ResultTable& named : outcome.tables) {
    if (is_in_body(named, outcome)) section.parts.emplace_back(report_table(named));
  }
  std::vector<std::string> refusals = refusals_in(outcome);
  if (!refusals.empty()) {
    section.parts.emplace_back(ReportText{"Results that could not be computed, with reasons:"});
    section.parts.emplace_back(ReportList{std::move(refusals)});
  }
  return section;
}

ReportSection tables_section(const AnalysisOutcome& outcome, std::span<const Figure> figures) {
  ReportSection section{"Further tables and figures", {}};
  const auto belongs_to = [&outcome](const Figure& figure, const ResultTable* table) {
    if (is_of_question(figure, outcome)) return false;
    if (table != nullptr) return figure.table == table->name;
    return std::none_of(outcome.tables.begin(), outcome.tables.end(),
                        [&figure](const ResultTable& each) { return each.name == figure.table; });
  };
  const auto add_figures_of = [&](const ResultTable* table) {
    for (const Figure& figure : figures) {
      if (belongs_to(figure, table)) section.parts.emplace_back(ReportFigure{0, figure});
    }
  };
  add_figures_of(nullptr);
  for (const ResultTable& named : outcome.tables) {
    add_figures_of(&named);
    // Every trial is in the exports, and drawn in figures.
    if (named.lists_trials) continue;
    // Numbers that a figure shows in its cells are not repeated.
    const bool is_drawn = std::any_of(figures.begin(), figures.end(), [&named](const Figure& one) {
      return one.table == named.name && !one.cells.empty();
    });
    if (!is_drawn && !is_in_body(named, outcome)) section.parts.emplace_back(report_table(named));
  }
  return section;
}

ReportSection numbers_section(const AnalysisOutcome& outcome) {
  ReportSection section{"Further tests and numbers", {}};
  if (outcome.findings.empty()) {
    section.parts.emplace_back(ReportText{"The analysis yielded no results."});
    return section;
  }
  const std::vector<ReportedTest> others = other_tests(outcome);
  ReportTable tests = further_tests_table(others);
  if (!tests.rows.empty()) section.parts.emplace_back(std::move(tests));
  ReportTable numbers = further_numbers_table(outcome.findings);
  if (!numbers.rows.empty()) section.parts.emplace_back(std::move(numbers));
  section.parts.emplace_back(ReportText{
      "Not all numbers are printed: asperity analyze STUDY --protocol " + outcome.protocol +
      " --json prints each number at full precision with its n, and with its interval and method "
      "where it has them."});
  return section;
}

}  // namespace asperity
