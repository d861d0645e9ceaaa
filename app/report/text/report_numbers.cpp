// Prints the findings whose quantity has words and that no table or answer contains.

#include "app/report/text/report_numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/shared/group_equivalence.h"
#include "app/findings/tidy/quantity_name.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

enum class PrintedForm { count, share, number };

struct NumberWords {
  std::string words{};
  PrintedForm form = PrintedForm::number;
};

/// By quantity. Others are in a table, are the limits of an interval, are lists, or require more
/// words than a row has.
const std::map<QuantityName, NumberWords, std::less<>>& known_numbers() {
  using enum PrintedForm;
  static const std::map<QuantityName, NumberWords, std::less<>> kKnown{
      {"balanced.pc", {"proportion correct, mean over the textures", share}},
      {"cochran.n.complete", {"participants with a response to every texture", count}},
      {"cohen.d", {"Cohen’s d of the participants’ proportions", number}},
      {"correct", {"correct responses", count}},
      {"cramer.w", {"Cohen’s w of the choices", number}},
      {"diff", {"difference of proportions of all responses (first − second)", number}},
      {"dprime.corrected", {"d′, corrected for an extreme proportion", number}},
      {"dprime.se", {"standard error of d′", number}},
      {"fisher.or.cond", {"odds ratio of all responses", number}},
      {"glmm.beta", {"fixed effect (logit)", number}},
      {"glmm.proportion",
       {"proportion of a participant and a texture with random intercepts of 0", share}},
      {"glmm.sigma", {"SD of the random intercepts (logit)", number}},
      {"H.response", {"response entropy H(R)", number}},
      {"hclust.shepard.average.cophcor", {"cophenetic correlation of the dendrogram", number}},
      {"hedges.g", {"Hedges’ g of the participants’ proportions", number}},
      {"agreement.mean",
       {"correlation of a participant with the mean of the others, mean", number}},
      {"cv.chosen", {"number of dimensions chosen by cross-validation", count}},
      {"dimensions", {"number of dimensions of the configuration", count}},
      {"hclust.average.cophcor", {"cophenetic correlation of the dendrogram", number}},
      {"identical.difference", {"dissimilarity of different minus identical surfaces", number}},
      {"identical.mean", {"mean dissimilarity of identical surfaces", number}},
      {"indscal.fit.mean", {"fit of the INDSCAL model, mean over participants", number}},
      {"orders.mean",
       {"correlation of the ratings in both orders, mean over participants", number}},
      {"protest.r2", {"Procrustes r² of the configuration and the measured properties", number}},
      {"retest.mean", {"test–retest correlation, mean over participants", number}},
      {"stress.perm.mean", {"stress-1 of permuted ratings, mean", number}},
      {"stress.perm.p05", {"stress-1 of permuted ratings, 5 % quantile", number}},
      {"IT.items", {"discriminable items, 2^IT (plug-in)", number}},
      {"IT.relative", {"relative transmitted information IT/H(S) (plug-in)", share}},
      {"mallows.lr", {"likelihood-ratio statistic of Mallows’ θ against θ = 0", number}},
      {"mallows.se", {"standard error of Mallows’ θ", number}},
      {"mds.shepard.gof2", {"fit of the MDS configuration in two dimensions", number}},
      {"mixed.sigma", {"SD of the random intercepts", number}},
      {"n", {"trials with a response", count}},
      {"n.missing", {"trials without a response, left out", count}},
      {"n.stages", {"choices on which the scale is based", count}},
      {"n.trials", {"trials", count}},
      {"n.trials.permutation", {"trials in which every picture was assigned once", count}},
      {"n.valid", {"choices", count}},
      {"null.lower",
       {"correctly matched items, lower limit of the 95 % range under guessing, trials treated as "
        "independent",
        count}},
      {"null.sd",
       {"correctly matched items, SD under guessing, trials treated as independent", number}},
      {"null.upper",
       {"correctly matched items, upper limit of the 95 % range under guessing, trials treated as "
        "independent",
        count}},
      {"pc.se.cluster", {"cluster-robust standard error of the proportion correct", number}},
      {"pl.loglik", {"log-likelihood of the scale", number}},
      {"pooled.deff", {"design effect of pooling the choices", number}},
      {"pooled.k", {"correct responses", count}},
      {"pooled.n", {"responses", count}},
      {"pooled.se.cluster", {"cluster-robust standard error of the proportion chosen", number}},
      {"precision", {"precision (positive predictive value)", share}},
      {"scm.bias", {"response bias b (sum 1)", number}},
      {"signflip.diff", {"difference in the number of choices (first − second)", count}},
      {"subj.diff", {"difference of mean proportions correct (first − second)", number}},
      {"subj.n", {"participants with at least one choice", count}},
      {"thurstone.firstchoice.mu", {"Thurstone scale value of first choices (mean 0)", number}},
      {"total.items", {"items", count}}};
  return kKnown;
}

/// Alternatives of a test that is also listed.
bool is_another_form(const std::string& quantity) {
  static const std::set<QuantityName, std::less<>> kAlternatives{"G.p",
                                                                 "exact.midp.greater",
                                                                 "exact.p.greater",
                                                                 "exact.p.less",
                                                                 "fisher.p.greater",
                                                                 "fisher.p.less",
                                                                 "glmm.p",
                                                                 "mauchly.p.car",
                                                                 "mauchly.p.firstorder",
                                                                 "mixed.lr.group.p",
                                                                 "multinom.exact.p",
                                                                 "tost.p.lower",
                                                                 "tost.p.upper",
                                                                 "p.lower",
                                                                 "pairwise.binom.p.two",
                                                                 "perfect.p.greater",
                                                                 "texture.p.greater",
                                                                 "values.welch.p.two"};
  return kAlternatives.contains(quantity);
}

/// The subject of a part of the analysis; its name where there is no text for it.
std::string words_of_analysis(const std::string& analysis) {
  static const std::map<std::string, std::string> kWords{
      {"anova", "analysis of variance"},
      {"choice", "choices"},
      {"glmm", "mixed model"},
      {kGroupsTest, "groups"},
      {kGroupsEquivalence, "groups"},
      {kGroupProfilesTest, "profiles of the groups"},
      {"position", "positions"},
      {"sexes", "women, men"},
      {"sexes_equivalence", "women, men"},
      {"similarity", "similarity"},
      {"texture", "textures"},
      {"textures", "textures"}};
  const std::string name = analysis.substr(0, analysis.find(':'));  // before a pair of groups
  const auto found = kWords.find(name);
  const std::string words = found == kWords.end() ? name : found->second;
  if (name.size() == analysis.size()) return words;
  FindingKey subject{};
  for (const std::string& part : parts_of(analysis.substr(name.size() + 1), '|')) {
    subject = {subject, part};
  }
  return words + ": " + words_of_key(subject);
}

std::string subject_of_row(const FindingKey& key) {
  std::string words = words_of_key(key);
  if (words == "F") return "women";
  if (words == "M") return "men";
  if (words == "subject") return "participants";
  if (words == "item") return "textures";
  if (words == "F, M" || words == "F-M") return "women, men";
  return words.empty() ? "–" : words;
}

std::string number_in_form(double value, PrintedForm form) {
  switch (form) {
    case PrintedForm::count:
      return display_signed(value, 0);
    case PrintedForm::share:
      return display_percent(value);
    case PrintedForm::number:
      break;
  }
  const double size = std::abs(value);
  constexpr double kRounding = 1e-12;  // of sums
  if (size < kRounding) return fixed(0.0, 2);
  if (size >= 0.095) return display_signed(value, 2);
  return size >= 0.0095 ? display_signed(value, 3) : display_number(value);
}

/// " (90 %)"; empty for the usual 95 %.
std::string other_confidence(const Finding& finding) {
  const double confidence = finding.confidence.value_or(0.95);
  return confidence == 0.95 ? "" : " (" + display_percent(confidence) + ')';
}

/// Removes the first column, where all rows have the same value in it.
void drop_lone_part(ReportTable& table) {
  std::set<std::string> parts{};
  for (const std::vector<std::string>& row : table.rows) parts.insert(row.front());
  if (parts.size() > 1) return;
  table.columns.erase(table.columns.begin());
  for (std::vector<std::string>& row : table.rows) row.erase(row.begin());
}

/// Removes the columns, except the first, that are empty in every row.
void drop_columns_of_dashes(ReportTable& table) {
  for (std::size_t i = table.columns.size(); i-- > 1;) {
    const bool is_empty = std::all_of(table.rows.begin(), table.rows.end(),
                                      [i](const auto& row) { return row[i] == "–"; });
    if (!is_empty) continue;
    const auto offset = static_cast<std::ptrdiff_t>(i);
    table.columns.erase(table.columns.begin() + offset);
    for (std::vector<std::string>& row : table.rows) row.erase(row.begin() + offset);
  }
}

std::string note_on_columns(const ReportTable& table) {
  const auto has = [&table](const std::string& heading) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [&heading](const auto& column) { return column.heading == heading; });
  };
  std::string note =
      has("Holm") ? "Holm: p value, Holm-corrected over the tests of the same name." : "";
  if (has("n")) {
    note += std::string(note.empty() ? "" : " ") +
            "n: number of participants, responses or trials in the analysis, as in the output of "
            "analyze STUDY --json.";
  }
  return note;
}

}  // namespace

std::string words_of_number(const std::string& quantity) {
  const auto known = known_numbers().find(quantity);
  return known == known_numbers().end() ? std::string() : known->second.words;
}

ReportTable further_tests_table(std::span<const ReportedTest> tests) {
  ReportTable table{};
  table.is_reference = true;
  table.title = "Further tests (exploratory)";
  table.columns = {{"analysis", false}, {"test", false}, {"factor or level", false},
                   {"statistic", true}, {"p", true},     {"Holm", true},
                   {"n", true}};
  for (const ReportedTest& test : tests) {
    const Finding& p = *test.p;
    if (is_another_form(p.quantity) || p.quantity.starts_with("subject.")) continue;
    const std::string statistic = statistic_of(test);
    table.rows.push_back(
        {words_of_analysis(p.analysis), p.method.empty() ? words_of_quantity(p.quantity) : p.method,
         subject_of_row(p.key), statistic.empty() ? "–" : statistic, display_p_cell(*p.value),
         test.holm == nullptr ? "–" : display_p_cell(*test.holm->value), display_count(p.n)});
  }
  drop_lone_part(table);
  drop_columns_of_dashes(table);
  table.note = note_on_columns(table);
  return table;
}

ReportTable further_numbers_table(std::span<const Finding> findings) {
  ReportTable table{};
  table.is_reference = true;
  table.title = "Further numbers";
  table.columns = {{"analysis", false}, {"quantity", false}, {"factor or level", false},
                   {"value", true},     {"95 % CI", true},   {"n", true}};
  for (const Finding& finding : findings) {
    const auto known = known_numbers().find(finding.quantity);
    if (known == known_numbers().end() || !finding.value) continue;
    if (finding.analysis == kSexesEquivalence || finding.analysis.starts_with(kGroupsEquivalence)) {
      continue;  // reported in its answer
    }
    const auto& [words, form] = known->second;
    std::string value = number_in_form(*finding.value, form);
    if (!finding.unit.empty() && finding.unit != "1") value += ' ' + finding.unit;
    table.rows.push_back({words_of_analysis(finding.analysis), words, subject_of_row(finding.key),
                          value,
                          finding.low && finding.high
                              ? number_in_form(*finding.low, form) + " to " +
                                    number_in_form(*finding.high, form) + other_confidence(finding)
                              : "–",
                          finding.n == 0 ? "–" : display_count(finding.n)});
  }
  drop_lone_part(table);
  drop_columns_of_dashes(table);
  table.note = note_on_columns(table);
  return table;
}

}  // namespace asperity
