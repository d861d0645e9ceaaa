// Computes the results of participants that rows of an export state.

#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <tuple>

#include "app/findings/gathering/gathered_answers.h"
#include "results_schema/study.h"

namespace asperity {

/// What depends on the responses of all sessions and is stated in the rows of each.
struct ParticipantResult {
  /// The factor c_p by which the numbers of participant p are multiplied, so that all use one scale:
  ///
  ///   log c_p = mean over participants q and cells of log x_q − mean over cells of log x_p
  ///
  /// x_p is the geometric mean of a participant's numbers in a cell, a spacing under a condition: of
  /// the numbers that `analyze` uses (main phase, valid attempts, nothing excluded, no anchors). The
  /// geometric mean of a participant's numbers in a cell, times c_p, is what `analyze` reports as
  /// normalised. Nothing for a participant without a number in every cell, and in protocols that ask
  /// for no magnitude.
  std::optional<double> own_scale{};
  /// Whether the declared rule for errors in catch trials excludes the participant, also where it excludes all. Nothing for a
  /// protocol without a rule, and for a participant without a catch trial.
  std::optional<bool> is_excluded_by_catch{};
};

/// By protocol, version and group (AnswerGroup), which are analysed separately. Reads the sessions of protocols that have such
/// results, those of each protocol once.
class ParticipantResults final {
 public:
  /// Errors: those of `gather_answers`.
  explicit ParticipantResults(const Study& study, const std::stop_token& stop = {});

  ParticipantResult of(const ParticipantRow& participant, const SessionRow& session,
                       const ProtocolRow& protocol) const;

 private:
  using Key = std::tuple<std::string, std::string, AnswerGroup, std::string>;
  void add_own_scales(const GatheredAnswers& gathered);

  std::map<Key, ParticipantResult> results_{};
};

}  // namespace asperity
