// Simulates one study of a protocol from its response tables, and analyses a simulated study as the protocol declares.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "app/findings/gathering/gathered_answers.h"

namespace asperity {

class PowerModel;

/// What one declared test of a family, or the family after its correction, gave in one simulated study.
///
/// The tests of a family follow each other, in the order of the analysis, and the family itself follows them: its row has
/// no `test` and no `p`, and its `corrected_p` is the smallest one of its tests, so that the family has a significant test
/// exactly where this is below the level of significance.
struct SimulatedOutcome {
  std::string family{};  ///< the names of its tests, sorted: "ratings", "pairs, preference"
  std::string
      test{};  ///< name of the test in it, with its subject: "rated_pairs rough: metal|stone"
  std::string
      method{};  ///< code of the statistical test (TestMethod::code): "paired_t"; empty where none was made
  std::optional<double>
      p{};  ///< as the analysis states it, uncorrected; none where it gave a status
  std::optional<double> corrected_p{};  ///< after the family's correction
  /// The effect with its 95 % confidence interval, in the unit of the analysis; none where it states none.
  std::optional<double> estimate{};
  std::optional<double> lower{};
  std::optional<double> upper{};
  /// The symbol of an effect size ("d_z"), or the name of a proportion or of an effect in the unit of the responses; empty of a
  /// study that was read from a file.
  std::string measure{};
  std::string status{};  ///< code of the status, empty where there is none
};

/// The outcomes of the analysis of a study, from its responses to one protocol.
std::vector<SimulatedOutcome> outcomes_of(std::span<const GatheredAnswers> of_study);

/// The random numbers of study number `run` of a power analysis.
Random random_of_study(std::uint64_t seed, std::int64_t run);

/// Simulates study number `run` with so many participants, and analyses it. Deterministic: a function of the model, the number
/// of participants, the seed and the run, whichever other runs are simulated. Safe to call from several threads.
///
/// Errors: std::invalid_argument for fewer than one participant or a run below 0.
std::vector<SimulatedOutcome> simulate_and_analyse(const PowerModel& model, int participants,
                                                   std::uint64_t seed, std::int64_t run);

/// A number of the response tables, such as a threshold, as the responses of one simulated study show it.
struct RecoveredNumber {
  std::string name{};  ///< of the assumption
  double value = 0.0;
};

/// What one simulated study shows.
struct SimulatedStudyResults {
  std::vector<SimulatedOutcome> outcomes{};  ///< those of `simulate_and_analyse`
  /// What `calibrated` takes from the responses, except standard deviations.
  std::vector<RecoveredNumber> recovered{};
};

/// The same as `simulate_and_analyse`, with the numbers that the responses show of the response tables: the longer computation,
/// because psychometric functions are fitted for them.
SimulatedStudyResults simulate_and_recover(const PowerModel& model, int participants,
                                           std::uint64_t seed, std::int64_t run);

}  // namespace asperity
