// Made-up discriminations: observers with a known psychometric function, and what the analysis makes of their choices.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "tests/app/analysed_study.h"
#include "tests/app/made_up_study.h"

namespace asperity {

inline constexpr double kStandard_m = 50e-6;

nlohmann::json discrimination_protocol(const std::string& judgement,
                                       double standard_m = kStandard_m);

/// One response of a discrimination.
struct MadeUpChoice {
  double value_m = 0.0;
  bool chose_comparison = false;
  bool comparison_first = false;
  std::string texture{};  ///< a level of another factor; empty: none
  bool is_performance = true;
  std::string block = "only";
};

MadeUpTrial discriminated(const MadeUpChoice& choice);

/// An observer whose proportion of choices of the comparison is a psychometric function.
class MadeUpObserver {
 public:
  MadeUpObserver(PsychometricFunction function, unsigned seed)
      : function_(function), random_(seed) {}

  /// The first positions are balanced within each level.
  std::vector<MadeUpChoice> choices(const std::vector<double>& values_m, int per_level,
                                    bool is_performance) {
    std::vector<MadeUpChoice> all{};
    for (const double value_m : values_m) {
      const double x = is_performance ? std::abs(value_m - standard_m) : value_m;
      for (int i = 0; i < per_level; ++i) {
        const bool first = i % 2 == 0;
        const double p = function_.value(x) + (first ? bias_to_first : -bias_to_first);
        const double drawn = static_cast<double>(random_()) / 4294967296.0;
        all.push_back({.value_m = value_m,
                       .chose_comparison = drawn < p,
                       .comparison_first = first,
                       .is_performance = is_performance});
      }
    }
    return all;
  }

  double bias_to_first = 0.0;
  double standard_m = kStandard_m;

 private:
  PsychometricFunction function_;
  std::mt19937 random_;
};

std::vector<MadeUpTrial> trials_of(const std::vector<MadeUpChoice>& choices);

inline const std::vector<double> kAbove_m{52.5e-6, 55e-6, 60e-6, 65e-6, 75e-6};
inline const std::vector<double> kAround_m{35e-6, 40e-6, 45e-6, 50e-6, 55e-6, 60e-6, 65e-6};
inline constexpr PsychometricFunction kPerformer{
    .shape = PsychometricShape::weibull, .alpha = 10e-6, .beta = 2.0, .gamma = 0.5, .lambda = 0.02};
inline constexpr PsychometricFunction kComparer{.shape = PsychometricShape::normal,
                                                .alpha = 54e-6,
                                                .beta = 1.0 / 6e-6,
                                                .gamma = 0.02,
                                                .lambda = 0.02};

/// Of the only analysis of the study.
AnalysisOutcome outcome_of_discrimination(MadeUpStudy& made);

/// Of one protocol.
AnalysisOutcome outcome_of_choices(const nlohmann::json& protocol, const MadeUpParticipants& people,
                                   const TrialsOfParticipant& trials_of);

/// `people` observers with the same function.
struct MadeUpObservers {
  PsychometricFunction function{};
  int people = 1;
  bool is_performance = true;
  int per_level = 40;
  double bias_to_first = 0.0;
};

/// Their outcome at the levels above or around the standard, computed once in this process.
const AnalysisOutcome& outcome_of_observers(const MadeUpObservers& observers);

/// Of twelve observers with kPerformer, and of twelve with kComparer.
const AnalysisOutcome& outcome_of_performers();
const AnalysisOutcome& outcome_of_comparers();

/// The lines of the exported wide table by name of their columns.
std::vector<std::map<std::string, std::string>> wide_rows(MadeUpStudy& made);

/// A 3-down/1-up staircase from 2 to 100 % above the standard, as in the library's amplitude_jnd.
nlohmann::json staircase_protocol(int trials);

/// The trials of the tracks of the staircase by this observer.
std::vector<MadeUpTrial> staircase_trials(const PsychometricFunction& observer,
                                          const nlohmann::json& protocol, std::uint64_t seed);

/// Of the first `kept` trials of each performer.
AnalysisOutcome outcome_of_staircases(const nlohmann::json& protocol, int people, std::size_t kept);

/// Of twelve performers with all 80 trials of the staircase, computed once in this process.
const AnalysisOutcome& outcome_of_twelve_staircases();

/// The same levels with psi, in two tracks.
nlohmann::json psi_protocol(int trials);

}  // namespace asperity
