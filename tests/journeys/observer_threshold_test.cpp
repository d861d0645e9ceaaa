// The noise of a virtual observer implies a threshold, and the analysis of its responses finds it.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_maximum.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "app/session/rig/recording_columns.h"
#include "renderers/offline/recorded_force.h"
#include "results_schema/analysis_use.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

/// A protocol of the library, and what its observer judges.
struct JudgedProtocol {
  std::string name{};
  std::string parameter{};
  double ForceFeatures::*feature = nullptr;
  bool increases = true;  ///< the feature, with the parameter
};

std::ostream& operator<<(std::ostream& out, const JudgedProtocol& protocol) {
  return out << protocol.name;
}

/// The main block of a protocol of the library.
nlohmann::json main_block_of(const std::string& name) {
  nlohmann::json protocol = nlohmann::json::parse(read_file(
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "protocols/library" / (name + ".json")));
  protocol["blocks"].erase("practice");
  protocol.erase("resume");
  protocol["flow"] = {{{"run", "comparisons"}}};
  return protocol;
}

struct ObserverNoise {
  double feature_noise = 0.0;
  double lapse = 0.0;
};

/// One judgement, as it was recorded.
struct JudgedForces {
  double x = 0.0;  ///< the parameter of the comparison, minus that of the standard
  double difference =
      0.0;  ///< of the judged features, likewise; positive where no noise leads to a correct response
};

/// Those of the trials from which thresholds are estimated.
std::vector<JudgedForces> judged_forces(const Study& study, const JudgedProtocol& protocol) {
  std::vector<JudgedForces> judged{};
  for (const SessionRow& session : study.sessions()) {
    std::map<int, PlannedTrialRow> planned{};
    for (const PlannedTrialRow& trial : study.plan(session.id)) planned[trial.trial] = trial;
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (use_in_analyses(planned.at(attempt.trial), attempt) != AnalysisUse::counted) continue;
      const std::filesystem::path file = study.folder() / attempt.recording->path;
      const Recording recording = read_recording(file);
      const std::vector<TickRecord> records = records_of(recording, file);
      std::map<std::string, double> judged_feature{};
      std::map<std::string, double> value{};
      for (const PresentationRow& surface : attempt.presentations) {
        judged_feature[surface.role] =
            recorded_force_features(
                {records, static_cast<std::uint64_t>(surface.position), recording.header.rate_Hz}).*
            protocol.feature;
        value[surface.role] =
            nlohmann::json::parse(surface.parameters_json).at(protocol.parameter).get<double>();
      }
      const double more = judged_feature.at("comparison") - judged_feature.at("standard");
      // Rounded to nanometres: the same level in every attempt.
      judged.push_back(
          {.x = std::round(1e9 * (value.at("comparison") - value.at("standard"))) * 1e-9,
           .difference = protocol.increases ? more : -more});
    }
  }
  return judged;
}

/// The observer compares r₁ + ε₁ with r₂ + ε₂, r being the judged feature and ε ~ N(0, σ²), and guesses in a lapse:
/// P(correct) = λ/2 + (1 − λ)·Φ(Δr/(σ√2)).
double chance_of_correct(double difference, const ObserverNoise& noise) {
  const double judged = noise.feature_noise > 0.0
                            ? 0.5 * std::erfc(-difference / (2.0 * noise.feature_noise))
                            : (difference > 0.0 ? 1.0 : 0.0);
  return 0.5 * noise.lapse + (1.0 - noise.lapse) * judged;
}

/// The difference of the parameter at 75 % correct, if every trial were judged 1000 times with this noise.
double implied_threshold(const std::vector<JudgedForces>& judged, const ObserverNoise& noise) {
  constexpr std::uint64_t kJudgements = 1000;
  std::map<double, PsychometricBlock> blocks{};
  for (const JudgedForces& each : judged) {
    const double p = chance_of_correct(each.difference, noise);
    PsychometricBlock& block = blocks[each.x];
    block.x = each.x;
    block.trials += kJudgements;
    block.hits += static_cast<std::uint64_t>(std::llround(p * static_cast<double>(kJudgements)));
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

/// The just-noticeable differences that have an interval.
std::vector<Finding> estimated_thresholds(const Study& study) {
  std::vector<Finding> thresholds{};
  for (const AnalysisOutcome& outcome : analyze_study(study, std::nullopt, {})) {
    for (const Finding& finding : outcome.findings) {
      if (finding.analysis == "thresholds" && finding.quantity == "jnd" && finding.low) {
        thresholds.push_back(finding);
      }
    }
  }
  return thresholds;
}

std::string interval_text(const Finding& finding) {
  const auto micrometres = [](double value_m) {
    return std::to_string(static_cast<int>(std::lround(1e6 * value_m)));
  };
  return finding.key.text() + ": " + micrometres(*finding.value) + " µm [" +
         micrometres(*finding.low) + ", " + micrometres(*finding.high) + "]";
}

class ObserverThreshold : public testing::TestWithParam<JudgedProtocol> {
 protected:
  Study simulated(const nlohmann::json& protocol, int participants) {
    const std::filesystem::path file = folder_.path() / "main.json";
    write_file(file, protocol.dump(1), Overwrite::refuse);
    const std::filesystem::path study = folder_.path() / "study";
    const Outcome outcome = asperity({"simulate", file.string(), "--study", study.string(),
                                      "--participants", std::to_string(participants), "--seed", "5",
                                      "--jobs", "2", "--recordings", "all"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Study::open(study, Access::read_only);
  }

 private:
  TemporaryFolder folder_{};
};

// An observer without noise has a threshold as well, because no stroke is like another. The noise has at least two and a half
// times that effect, so that responses without it would have thresholds far below the implied one.
TEST_P(ObserverThreshold, IsTheOneThatItsNoiseImplies) {
  constexpr int kParticipants = 4;
  const nlohmann::json protocol = main_block_of(GetParam().name);
  const Study study = simulated(protocol, kParticipants);
  const std::vector<JudgedForces> judged = judged_forces(study, GetParam());
  const ObserverNoise noise{.feature_noise = protocol["observer"]["feature_noise"],
                            .lapse = protocol["observer"]["lapse"]};
  const double implied_m = implied_threshold(judged, noise);
  const double of_strokes_m = implied_threshold(judged, {});
  const std::string about = "; the noise implies " + std::to_string(1e6 * implied_m) +
                            " µm, the strokes alone " + std::to_string(1e6 * of_strokes_m) + " µm";
  EXPECT_GT(implied_m, 2.5 * of_strokes_m) << about;
  const std::vector<Finding> thresholds = estimated_thresholds(study);
  int holding = 0;
  double sum_of_logs = 0.0;
  std::string intervals{};
  for (const Finding& finding : thresholds) {
    holding += *finding.low <= implied_m && implied_m <= *finding.high ? 1 : 0;
    sum_of_logs += std::log(*finding.value);
    intervals += interval_text(finding) + ' ';
  }
  // The interval of one participant may be wide.
  EXPECT_GT(std::exp(sum_of_logs / static_cast<double>(thresholds.size())), 2.0 * of_strokes_m)
      << intervals << about;
  EXPECT_EQ(thresholds.size(), static_cast<std::size_t>(kParticipants));
  EXPECT_GE(holding, kParticipants - 1) << intervals << about;
}

INSTANTIATE_TEST_SUITE_P(OfTheLibrary, ObserverThreshold,
                         testing::Values(JudgedProtocol{"amplitude_jnd", "amplitude_m",
                                                        &ForceFeatures::size, true},
                                         JudgedProtocol{"spacing_jnd", "wavelength_m",
                                                        &ForceFeatures::roughness, false}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace asperity::test
