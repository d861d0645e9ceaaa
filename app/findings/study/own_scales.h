// Computes the factors that remove each participant's scale from magnitude estimates.

#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <tuple>

#include "app/findings/gathering/gathered_answers.h"
#include "results_schema/study.h"

namespace asperity {

/// Factors c_p by which the numbers of participants p are multiplied, so that all use one scale:
///
///   log c_p = mean over participants q and cells of log x_q − mean over cells of log x_p
///
/// x_p is the geometric mean of a participant's numbers in a cell, a spacing under a condition: of
/// the numbers that `analyze` uses (main phase, valid attempts, nothing excluded, no anchors). The
/// geometric mean of a participant's numbers in a cell, times c_p, is what `analyze` reports as
/// normalised.
///
/// Computed by protocol, version and group (AnswerGroup), which have separate scales.
class OwnScales final {
 public:
  OwnScales() = default;
  /// Analyses the study's magnitudes. Errors: as analyze_study.
  explicit OwnScales(const Study& study, const std::stop_token& stop = {});

  /// Nothing for a participant without a number in every cell, and in protocols that ask for no
  /// magnitude.
  std::optional<double> of(const ParticipantRow& participant, const SessionRow& session,
                           const ProtocolRow& protocol) const;

 private:
  using Key = std::tuple<std::string, std::string, AnswerGroup, std::string>;
  std::map<Key, double> factors_{};
};

}  // namespace asperity
