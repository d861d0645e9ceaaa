// The noise of a virtual observer implies a threshold, and the analysis of its responses finds it.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric_maximum.h"
#include "app/findings/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/study/discrimination_thresholds.h"
#include "app/session/rig/recording_columns.h"
#include "renderers/offline/recorded_force.h"
#include "results_schema/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

const std::filesystem::path kProtocolOfJnd =
    std::filesystem::path(ASPERITY_SOURCE_DIR) / "protocols/library/amplitude_jnd.json";

struct ObserverNoise {
  double feature_noise = 0.0;
  double lapse = 0.0;
};

ObserverNoise noise_in(const std::filesystem::path& protocol) {
  const auto observer = nlohmann::json::parse(read_file(protocol)).at("observer");
  return {.feature_noise = observer.at("feature_noise"), .lapse = observer.at("lapse")};
}

/// The observer compares r₁ + ε₁ with r₂ + ε₂, r being the roughness of the recorded lateral force and ε ~ N(0, σ²), and
/// guesses in a lapse: P(correct) = λ/2 + (1 − λ)·Φ((r_c − r_s)/(σ√2)).
double chance_of_correct(double difference, const ObserverNoise& noise) {
  const double certain = 0.5 * std::erfc(-difference / (2.0 * noise.feature_noise));
  return 0.5 * noise.lapse + (1.0 - noise.lapse) * certain;
}

double amplitude_of(const PresentationRow& surface) {
  return nlohmann::json::parse(surface.parameters_json).at("amplitude_m");
}

/// Adds the expected responses to the recorded surfaces of an attempt, as if it had been judged 1000 times.
void add_expected(const std::filesystem::path& study, const AttemptRow& attempt,
                  const ObserverNoise& noise, std::map<double, PsychometricBlock>& blocks) {
  constexpr std::uint64_t kJudgements = 1000;
  const std::filesystem::path file = study / attempt.recording->path;
  const Recording recording = read_recording(file);
  const std::vector<TickRecord> records = records_of(recording, file);
  std::map<std::string, double> roughness{};
  std::map<std::string, double> amplitude_m{};
  for (const PresentationRow& surface : attempt.presentations) {
    roughness[surface.role] =
        recorded_force_features(
            {records, static_cast<std::uint64_t>(surface.position), recording.header.rate_Hz})
            .roughness;
    amplitude_m[surface.role] = amplitude_of(surface);
  }
  const double p = chance_of_correct(roughness.at("comparison") - roughness.at("standard"), noise);
  // Rounded to nanometres: the same level in every attempt.
  const double x =
      std::round(1e9 * (amplitude_m.at("comparison") - amplitude_m.at("standard"))) * 1e-9;
  PsychometricBlock& block = blocks[x];
  block.x = x;
  block.trials += kJudgements;
  block.hits += static_cast<std::uint64_t>(std::llround(p * static_cast<double>(kJudgements)));
}

/// The difference in amplitude at 75 % correct that the noise implies for the recorded strokes of all participants.
double implied_threshold(const Study& study, const ObserverNoise& noise) {
  std::map<double, PsychometricBlock> blocks{};
  for (const SessionRow& session : study.sessions()) {
    std::map<int, std::string> phases{};
    for (const PlannedTrialRow& trial : study.plan(session.id)) phases[trial.trial] = trial.phase;
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (phases.at(attempt.trial) != "main" || !attempt.valid || !attempt.recording) continue;
      add_expected(study.folder(), attempt, noise, blocks);
    }
  }
  std::vector<PsychometricBlock> all{};
  for (const auto& [x, block] : blocks) all.push_back(block);
  const PsychometricMaximum maximum =
      maximise_psychometric(all, {.shape = PsychometricShape::weibull,
                                  .gamma = 0.5,
                                  .lambda = std::nullopt,
                                  .greatest_lambda = kGreatestLapseRate});
  return maximum.function.inverse(kProportionAtThreshold);
}

// With the seeds 1 to 6, 22 of the 24 intervals contain the implied threshold (11 to 16 µm, with the strokes).
TEST(ObserverThreshold, IsWithinTheIntervalsOfMostParticipants) {
  constexpr int kParticipants = 4;
  const TemporaryFolder folder;
  const std::filesystem::path place = folder.path() / "study";
  const Outcome simulated = asperity(
      {"simulate", kProtocolOfJnd.string(), "--study", place.string(), "--participants",
       std::to_string(kParticipants), "--seed", "5", "--jobs", "2", "--recordings", "all"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Study study = Study::open(place, Access::read_only);
  ObserverNoise noise = noise_in(kProtocolOfJnd);
  const double implied_m = implied_threshold(study, noise);
  noise.feature_noise *= 15.0;
  const double of_more_noise_m = implied_threshold(study, noise);
  const std::vector<AnalysisOutcome> outcomes = analyze_study(study, std::nullopt, {});
  ASSERT_EQ(outcomes.size(), 1U);
  int thresholds = 0;
  int holding = 0;
  for (const Finding& finding : outcomes.front().findings) {
    if (finding.analysis != "thresholds" || finding.quantity != "jnd" || !finding.low) continue;
    ++thresholds;
    holding += *finding.low <= implied_m && implied_m <= *finding.high ? 1 : 0;
    EXPECT_LT(*finding.high, of_more_noise_m) << finding.key << ": of an observer with other noise";
  }
  EXPECT_EQ(thresholds, kParticipants);
  EXPECT_GE(holding, kParticipants - 1) << "the implied threshold is " << 1e6 * implied_m << " µm";
}

}  // namespace
}  // namespace asperity::test
