// The gates of the two protocols for thresholds: an observer that guesses has none, one without noise a low one.

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/findings/study/analyze_study.h"
#include "app/tasks/simulation/simulation.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "results_schema/analysis_use.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

struct ThresholdProtocol {
  std::string_view name{};
  std::size_t trials = 0;  ///< of a participant, without catch trials
  /// Of a participant: one in every 20 trials, and in some sessions one among the last few.
  std::size_t fewest_catch_trials = 0;
};

std::ostream& operator<<(std::ostream& out, const ThresholdProtocol& protocol) {
  return out << protocol.name;
}

/// Responses and thresholds of a simulated study.
struct ThresholdCounts {
  HitCount responses{};
  HitCount catch_responses{};
  std::size_t guess_sources = 0;  ///< of both
  std::vector<Finding>
      jnds{};  ///< one for each participant, with a number or with a word in place of it
};

void count_responses(const Study& study, ThresholdCounts& counts) {
  for (const SessionRow& session : study.sessions()) {
    std::map<int, PlannedTrialRow> planned{};
    for (const PlannedTrialRow& trial : study.plan(session.id)) planned[trial.trial] = trial;
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (!attempt.valid || attempt.responses.empty()) continue;
      const AnalysisUse use = use_in_analyses(planned.at(attempt.trial), attempt);
      HitCount& hits = use == AnalysisUse::catch_trial ? counts.catch_responses : counts.responses;
      const ResponseRow& response = attempt.responses.front();
      ++hits.trials;
      hits.hits += response.correct.value() ? 1 : 0;
      counts.guess_sources += response.source == "virtual_guess" ? 1 : 0;
    }
  }
}

/// The JNDs that have a number.
std::vector<double> numbers_of(const ThresholdCounts& counts) {
  std::vector<double> numbers{};
  for (const Finding& jnd : counts.jnds) {
    if (jnd.value) numbers.push_back(*jnd.value);
  }
  return numbers;
}

double mean_of(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

class ThresholdGates : public testing::TestWithParam<ThresholdProtocol> {
 protected:
  /// The main block of the library's protocol with these members of the observer changed.
  ThresholdCounts simulated(const std::string& name, int participants,
                            const nlohmann::ordered_json& observer) {
    nlohmann::ordered_json protocol{};
    for (const LibraryProtocol& each : library_protocols()) {
      if (each.name == GetParam().name) protocol = nlohmann::ordered_json::parse(each.text);
    }
    protocol.at("blocks").erase("practice");
    protocol.erase("resume");
    protocol["flow"] = {{{"run", "comparisons"}}};
    protocol.at("observer").update(observer);
    const std::filesystem::path file = folder_ / (name + ".json");
    write_file(file, protocol.dump(1), Overwrite::refuse);
    SimulationInputs inputs{};
    inputs.protocols = {file};
    inputs.study = folder_ / name;
    inputs.participants = participants;
    inputs.seed = 5;
    inputs.jobs = 2;
    inputs.recordings = Recordings::none;
    (void)simulate(inputs, built_in_models(), {}, {}, {});
    const Study study = Study::open(inputs.study, Access::read_only);
    ThresholdCounts counts{};
    count_responses(study, counts);
    for (const AnalysisOutcome& outcome : analyze_study(study, std::nullopt, {})) {
      for (const Finding& finding : outcome.findings) {
        if (finding.analysis == "thresholds" && finding.quantity == "jnd") {
          counts.jnds.push_back(finding);
        }
      }
    }
    return counts;
  }

 private:
  TemporaryFolder folder_{};
};

TEST_P(ThresholdGates, AGuessingObserverHasNoThreshold) {
  constexpr int kParticipants = 4;
  const ThresholdCounts counts = simulated("deaf", kParticipants, {{"deaf", true}});
  EXPECT_EQ(counts.responses.trials, kParticipants * GetParam().trials);
  EXPECT_GE(counts.catch_responses.trials, kParticipants * GetParam().fewest_catch_trials);
  EXPECT_EQ(counts.guess_sources, counts.responses.trials + counts.catch_responses.trials);
  // A procedure that always ends after the same number of trials has no effect on the proportion correct of guesses.
  expect_by_chance("guessed", counts.responses, 0.5, 1.0);
  ASSERT_EQ(counts.jnds.size(), static_cast<std::size_t>(kParticipants));
  for (const Finding& jnd : counts.jnds) {
    EXPECT_FALSE(jnd.value) << jnd.key << ": " << *jnd.value;
    EXPECT_FALSE(jnd.low) << jnd.key;
    EXPECT_TRUE(jnd.word == "above_levels" || jnd.word == "not_increasing")
        << jnd.key << ": " << jnd.word;
  }
}

TEST_P(ThresholdGates, AnObserverWithoutNoiseHasALowerOne) {
  constexpr int kParticipants = 2;
  const ThresholdCounts noisy = simulated("noisy", kParticipants, nlohmann::ordered_json::object());
  const ThresholdCounts noiseless =
      simulated("noiseless", kParticipants, {{"feature_noise", 0.0}, {"lapse", 0.0}});
  EXPECT_EQ(noiseless.guess_sources, 0U);
  EXPECT_GE(noiseless.catch_responses.trials, kParticipants * GetParam().fewest_catch_trials);
  EXPECT_EQ(noiseless.catch_responses.hits, noiseless.catch_responses.trials);
  const std::vector<double> high_m = numbers_of(noisy);
  ASSERT_EQ(high_m.size(), static_cast<std::size_t>(kParticipants));
  // Without noise the threshold may lie below the lowest level, and so below every threshold within the levels.
  ASSERT_EQ(noiseless.jnds.size(), static_cast<std::size_t>(kParticipants));
  for (const Finding& jnd : noiseless.jnds) {
    EXPECT_TRUE(jnd.value || jnd.word == "below_levels") << jnd.key << ": " << jnd.word;
  }
  const std::vector<double> low_m = numbers_of(noiseless);
  if (low_m.empty()) return;
  EXPECT_LT(std::ranges::max(low_m), std::ranges::min(high_m));
  EXPECT_LT(mean_of(low_m), 0.5 * mean_of(high_m));
}

INSTANTIATE_TEST_SUITE_P(OfTheLibrary, ThresholdGates,
                         testing::Values(ThresholdProtocol{"amplitude_jnd", 80, 4},
                                         ThresholdProtocol{"spacing_jnd", 60, 0}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace asperity
