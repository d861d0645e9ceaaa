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

#include "analysis/psychometric_function.h"
#include "app/findings/study/analyze_study.h"
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

/// `people` observers with the same function.
AnalysisOutcome outcome_of_observers(const PsychometricFunction& function, int people,
                                     const std::vector<double>& values_m, bool is_performance,
                                     int per_level = 40, double bias_to_first = 0.0);

std::vector<Finding> part_of(const AnalysisOutcome& outcome, const std::string& analysis);

const NamedTable& discrimination_table(const AnalysisOutcome& outcome, const std::string& name);

std::string answer_to(const AnalysisOutcome& outcome, const std::string& name);

std::string sentence_about(const AnalysisOutcome& outcome, const std::string& test,
                           const std::string& about = {});

/// The first line of the exported wide table by name of its column, and that of the given row.
std::map<std::string, std::string> wide_row(MadeUpStudy& made, std::size_t row);

/// A 3-down/1-up staircase from 2 to 100 % above the standard, as in the library's amplitude_jnd.
nlohmann::json staircase_protocol(int trials);

/// The trials of the tracks of the staircase by this observer.
std::vector<MadeUpTrial> staircase_trials(const PsychometricFunction& observer,
                                          const nlohmann::json& protocol, std::uint64_t seed);

AnalysisOutcome outcome_of_staircases(const nlohmann::json& protocol, int people, std::size_t kept);

/// The same levels with psi, in two tracks.
nlohmann::json psi_protocol(int trials);

}  // namespace asperity
