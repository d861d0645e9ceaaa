// Reports the spacings of maximum roughness of a magnitude estimation.

#include "app/findings/methods/magnitude/roughness_peaks.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

namespace {

/// An interval that contains every tested spacing does not locate the peak.
constexpr const char* kTooFew = "too_few_to_say";
/// The test for an interior maximum is not significant.
constexpr const char* kNoInterior = "no_interior_maximum";

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

const ResultColumn kFieller =
    interval_of({.id = "fieller_m", .unit = "m", .digits = Digits::length},
                phrase("AnalysisWords", "Fieller 95 % CI"));
const ResultColumn kDescending{.id = "descending",
                               .heading = phrase("AnalysisWords", "descending")};
const ResultColumn kInvertedU{.id = "inverted_u", .heading = phrase("AnalysisWords", "inverted U")};

}  // namespace

bool has_interior_maximum(const FoundNumbers& found, const std::string& condition) {
  const Finding* significant = found.find("invU.significant", condition);
  return significant != nullptr && significant->word == "TRUE";
}

void add_peaks(const std::vector<std::string>& conditions, const std::vector<std::string>& spacings,
               const FoundNumbers& found, AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable peaks{
      kPeaks,
      phrase("Analysis", "Spacing of maximum roughness: one parabola per condition"),
      {kCondition, kStatus, kPeakSpacing, interval_of(kPeakSpacing), kFieller, kHeight, kDescending,
       kInvertedU, kOther, kInteriorP, kRSquared},
      phrase(
          "Analysis",
          "Parabolas of log estimate on log spacing, one per participant; "
          "the maximum is that of their mean, with CIs by the delta method and by Fieller's "
          "method. It is reported where the test for an interior maximum (Lind and Mehlum: the "
          "mean curve rises at the smallest and falls at the largest spacing, one-sided t tests "
          "over participants, the larger p) has p < .05. R²: fit of the mean parabola to the cell "
          "means. “Descending”, “inverted U” and “other” count the participants' own curves.")};
  for (const std::string& condition : conditions) {
    const std::string status = peak_status(found, condition, spacings);
    if (status.empty()) continue;
    const bool is_reported = status != kTooFew && status != kNoInterior;
    const auto reported = [&](QuantityName quantity) {
      return is_reported ? found.value(quantity, condition) : std::nullopt;
    };
    peaks.add({condition, status == "ok" ? ResultCell{} : ResultCell{status},
               cell_of(reported("peak")),
               is_reported ? found.interval("peak", condition) : ResultCell{},
               interval_cell(reported("peak.fieller.lower"), reported("peak.fieller.upper")),
               cell_of(reported("peak.height")), found.count("curve.descending", condition),
               found.count("curve.inverted_u", condition), found.count("curve.other", condition),
               found.cell("invU.p", condition), found.cell("pooled.quad.r2", condition)});
  }
  if (!peaks.rows.empty()) outcome.tables.push_back(std::move(peaks));
  ResultTable shifts{
      "peak_ratios",
      phrase("Analysis", "Ratios of the peaks"),
      {kFirst, kSecond, kRatio, interval_of(kRatio), kP, kStatus},
      phrase("Analysis",
             "Ratio of the spacing of the first peak to that of the second, with the "
             "same participants in both; delta method. p is uncorrected.")};
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (std::size_t j = i + 1; j < conditions.size(); ++j) {
      for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
        const FindingKey key{conditions[a], conditions[b]};
        if (found.find("peakratio", key) == nullptr) continue;
        if (const Finding* p = found.find("peakratio.p", key)) {
          outcome.tests_in_tables.insert(name_of(*p));
        }
        ResultRow& row = shifts.rows.emplace_back(ResultRow{conditions[a], conditions[b]});
        if (has_interior_maximum(found, conditions[a]) &&
            has_interior_maximum(found, conditions[b])) {
          row.insert(row.end(), {found.cell("peakratio", key), found.interval("peakratio", key),
                                 found.cell("peakratio.p", key), ResultCell{}});
        } else {
          row.resize(shifts.columns.size());
          row.back() = kNotBothPeaks;
        }
      }
    }
  }
  if (!shifts.rows.empty()) outcome.tables.push_back(std::move(shifts));
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
                    .with(condition, display_p(*p))
              : phrase("Analysis",
                       "%1 without a test for an interior maximum, because all "
                       "participants have the same curve")
                    .with(condition);
    } else if (peak != nullptr && peak->value && peak->low && peak->high) {
      one = phrase("Analysis",
                   "%1 at %2 (95 % CI [%3, %4]; test for an interior maximum %5; "
                   "R² of the mean parabola %6)")
                .with(condition, display_quantity(*peak->value, "m"),
                      display_quantity(*peak->low, "m"), display_quantity(*peak->high, "m"),
                      display_p(found.value("invU.p", condition).value_or(1.0)),
                      display_bounded(found.value("pooled.quad.r2", condition).value_or(0.0)));
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
      kPeaks, first);
}

void ask_peak_ratios(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome) {
  Phrase answer{};
  const Finding* first = nullptr;
  for (const StudyTests::Test& test : tests.tests()) {
    if (test.name != "peaks" || !test.p || test.degrees.empty() || !test.statistic) continue;
    const Finding* ratio = found.find("peakratio", {test.about.first, test.about.second});
    if (ratio == nullptr || !ratio->value || !ratio->low || !ratio->high) continue;
    const int decimals = decimals_of(*ratio->high - *ratio->low);
    const Phrase numbers =
        phrase("Analysis",
               "the peak of %1 is at %2 times the spacing of the peak of %3 (95 % CI [%4, %5])")
            .with(test.about.first, fixed(*ratio->value, decimals), test.about.second,
                  fixed(*ratio->low, decimals), fixed(*ratio->high, decimals));
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
               "peak_ratios", first);
}

void ask_types(const std::vector<std::string>& conditions, const FoundNumbers& found,
               AnalysisOutcome& outcome) {
  constexpr std::array<QuantityName, 3> kTypes{"curve.descending", "curve.inverted_u",
                                               "curve.other"};
  std::array<double, 3> counts{};
  for (const std::string& condition : conditions) {
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
      counts[i] += found.value(kTypes[i], condition).value_or(0.0);
    }
  }
  if (counts[0] + counts[1] + counts[2] <= 0.0) return;
  add_question(outcome, "types",
               phrase("Analysis", "Which shapes do the participants' own curves have?"),
               phrase("Analysis",
                      "Shapes of the participants' curves, all conditions together: descending %1, "
                      "inverted U %2, other %3.")
                   .with(fixed(counts[0], 0), fixed(counts[1], 0), fixed(counts[2], 0)),
               phrase("Analysis",
                      "The shape is determined by the slopes of each participant's own parabola at "
                      "the smallest and the largest spacing; there is no test."),
               kPeaks, found.find(kTypes[0], conditions.front()));
}

}  // namespace asperity
