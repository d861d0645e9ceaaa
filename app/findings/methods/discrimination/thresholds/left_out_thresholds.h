// The thresholds that a mean leaves out, and what the mean of the others then is.

#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// What the mean of the estimated thresholds is of all thresholds. A t-based interval over the others alone describes other
/// participants than those of the study: in simulations with 27 and 34 % of thresholds left out it contained the true mean
/// in 75 and 48 % of the studies.
enum class MeanOfThresholds {
  complete,     ///< none is left out
  upper_bound,  ///< all that are left out lie below the presented levels
  lower_bound,  ///< all lie above
  no_bound,     ///< neither: there is no mean
};
/// "upper_bound", a code of cell_words.h; empty if complete.
std::string code_of(MeanOfThresholds mean);

/// Estimates of a threshold that means leave out, by the side of the presented levels on which they lie.
struct LeftOutThresholds {
  std::size_t of = 0;
  std::size_t below = 0;
  std::size_t above = 0;
  std::map<std::string, std::size_t> others{};  ///< on an unknown side, by the code of the reason

  std::size_t other() const;
  std::size_t missing() const { return below + above + other(); }
  MeanOfThresholds mean() const;
};

/// Of the findings of the analysis `thresholds` with this quantity, of one condition.
LeftOutThresholds left_out_thresholds(std::span<const Finding> thresholds, QuantityName quantity,
                                      std::string_view condition);
/// The same of the mean of the analysis `mean_thresholds`: mean.pse, geomean.jnd.
LeftOutThresholds left_out_of_mean(std::span<const Finding> thresholds, const Finding& mean);

/// "at most 12.9 µm" of an upper bound, "12.9 µm (95 % CI …)" where no threshold is left out. The mean has a value.
Phrase mean_with_bound(const Finding& mean, const LeftOutThresholds& left_out);

/// The answer, and after it, for each condition, how many thresholds the mean leaves out and on which side of the presented
/// levels they lie, with the reasons where the side is unknown, and what the mean of the others is.
Phrase with_left_out_thresholds(Phrase answer, const DiscriminationResults& results,
                                QuantityName quantity);

/// " The mean JND of 8 participants is an upper bound: the thresholds of five lie below the presented levels.": the same of the
/// thresholds of this quantity, for a paper; empty where none is left out, and where there is none.
std::string bound_sentences(const std::vector<Finding>& findings, QuantityName quantity,
                            const std::string& measure);

}  // namespace asperity
