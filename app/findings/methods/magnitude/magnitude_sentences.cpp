// Reads the peaks from their table, and states exponents only of conditions without one.

#include "app/findings/methods/magnitude/magnitude_sentences.h"

#include <map>
#include <string>
#include <vector>

#include "app/findings/methods/magnitude/roughness_peaks.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// Of the conditions with a reported peak: "1.23 mm, 95 % CI [1.17 mm, 1.29 mm], p < .001".
std::map<std::string, std::string> reported_peaks(const AnalysisOutcome& outcome) {
  std::map<std::string, std::string> peaks{};
  const ResultTable* const table = table_named(outcome, kPeaks);
  if (table == nullptr) return peaks;
  for (const ResultRow& cells : table->rows) {
    const RowReader row(*table, cells);
    const auto peak = row.number(kPeakSpacing);
    if (!peak) continue;
    std::string text = display_quantity(*peak, "m");
    const Interval interval = row.interval(kPeakSpacing);
    if (interval.low && interval.high) {
      text += ", 95 % CI [" + display_quantity(*interval.low, "m") + ", " +
              display_quantity(*interval.high, "m") + ']';
    }
    if (const auto p = row.number(kInteriorP)) text += ", " + display_p(*p);
    peaks[row.text(columns::kCondition)] = text;
  }
  return peaks;
}

/// "The spacings of maximum roughness (…) were at 1.23 mm, … (small) and at … (large); these curves are not power functions."
std::string peaks_text(const std::map<std::string, std::string>& peaks) {
  std::vector<std::string> parts{};
  for (const auto& [condition, text] : peaks) {
    parts.push_back("at " + text +
                    (condition == "all" ? "" : " (" + words_of_condition(condition) + ")"));
  }
  if (parts.empty()) return {};
  return "The spacings of maximum roughness (significant interior maxima, test of Lind and Mehlum) "
         "were " +
         listed(parts) + "; " +
         (parts.size() == 1 ? "this curve is not a power function."
                            : "these curves are not power functions.");
}

}  // namespace

EstimateSentence exponents_sentence(const AnalysisOutcome& outcome) {
  std::vector<const Finding*> means = estimates_among(outcome, kRoughness, "exponent.mean");
  const bool is_of_spacings = !means.empty();
  if (!is_of_spacings) means = estimates_among(outcome, kStimulusEstimates, "exponent.mean");
  // A curve with a maximum among the tested spacings is not a power function.
  const std::map<std::string, std::string> peaks = reported_peaks(outcome);
  std::erase_if(means, [&peaks](const Finding* one) { return peaks.contains(one->key.last()); });
  std::string text = peaks_text(peaks);
  if (means.empty()) return {.text = text};
  if (!text.empty()) text += ' ';
  constexpr int kDecimals = 2;
  return {.text = text +
                  (means.size() == 1 ? std::string("The mean slope") : std::string("Mean slopes")) +
                  " of log estimate on " + (is_of_spacings ? "log spacing" : "log predictor") +
                  " (exponent of a power function) " + (means.size() == 1 ? "was " : "were ") +
                  all_estimates(means, "all",
                                [](double value) { return display_signed(value, kDecimals); }) +
                  '.'};
}

}  // namespace asperity
