// The confidence of a virtual observer, from the simulation of a study to the area under the ROC of its ratings.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/choices/rating_roc.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/session/rig/recording_columns.h"
#include "renderers/offline/recorded_force.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using ConfidenceJson = nlohmann::json;

constexpr int kPoints = 4;
constexpr double kNoise = 0.2;
constexpr double kYesAbove = 0.023;  // the standard has 0.0204, and the comparison 0.0262
constexpr double kDifferentAbove = 0.35;
constexpr const char* kRatedLevel = "all|6.5e-05";

/// The logarithms of the judged force in a study: the mean of both kinds of surfaces, and the standard deviation among
/// the strokes on one of them.
struct FeltMagnitudes {
  double standard = 0.0;
  double comparison = 0.0;
  double deviation = 0.0;
};

struct RatedDesign {
  std::string id{};
  /// The probability that the decision variable is above a threshold, in trials of noise and of a signal with this d′.
  /// The variable has the standard deviation 1 in noise trials, without the absolute value.
  std::function<double(double threshold, double dprime, bool is_signal)> above{};
  /// The criterion in units of the standard deviation of the decision variable.
  std::function<double(const FeltMagnitudes& felt, double deviation)> criterion{};
  bool has_equal_variances = true;
  double separation = 1.0;  ///< d_a for d′ = 1
};

std::ostream& operator<<(std::ostream& out, const RatedDesign& design) { return out << design.id; }

/// 30 % above the standard is 0.26 in the logarithm of the force.
ConfidenceJson rated_protocol(const std::string& design) {
  const bool is_pair = design == "same_different";
  ConfidenceJson protocol = ConfidenceJson::parse(
      read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "protocols/library" /
                (is_pair ? "amplitude_same_different.json" : "amplitude_jnd.json")));
  protocol["blocks"].erase("practice");
  protocol.erase("resume");
  protocol.erase("analysis");
  protocol["flow"] = {{{"run", "comparisons"}}};
  // One stroke in place of three; the band of the stroke, which the virtual hand follows, is that of the library.
  ConfidenceJson& stroking = protocol["explorations"]["stroking"];
  stroking["strokes"] = {{"minimum", 1}, {"target", 1}};
  stroking["minimum_contact_s"] = 0.5;
  ConfidenceJson& block = protocol["blocks"]["comparisons"];
  block.erase("procedure");
  block["design"] = design;
  block["vary"]["levels_percent"] = {30};
  block["repetitions"] = design == "two_alternatives" ? 60 : (is_pair ? 15 : 30);
  block.erase("arrangement");
  block["pause_before_trial_s"] = 0;
  block["pause_between_surfaces_s"] = 0;
  if (design == "yes_no") {
    block.erase("positions");
    block["question"]["options"] = {{{"value", "yes"}, {"text", "Yes"}},
                                    {{"value", "no"}, {"text", "No"}}};
    protocol["observer"]["yes_above"] = kYesAbove;
  }
  block["questions"] = {block["question"],
                        {{"name", "sure"},
                         {"prompt", "How sure?"},
                         {"confidence_of", block["question"]["name"]},
                         {"scale", {{"minimum", 1}, {"maximum", kPoints}, {"points", kPoints}}}}};
  block.erase("question");
  protocol["observer"]["feature_noise"] = kNoise;
  protocol["observer"]["lapse"] = 0.0;
  return protocol;
}

FeltMagnitudes felt_magnitudes(const Study& study) {
  std::vector<double> standards{};
  std::vector<double> comparisons{};
  for (const SessionRow& session : study.sessions()) {
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      const std::filesystem::path file = study.folder() / attempt.recording->path;
      const Recording recording = read_recording(file);
      const std::vector<TickRecord> records = records_of(recording, file);
      for (const PresentationRow& surface : attempt.presentations) {
        (surface.role == "standard" ? standards : comparisons)
            .push_back(
                recorded_force_features({records, static_cast<std::uint64_t>(surface.position),
                                         recording.header.rate_Hz})
                    .size);
      }
    }
  }
  FeltMagnitudes felt{};
  double squares = 0.0;
  for (const auto& [values, mean] :
       {std::pair{&standards, &felt.standard}, std::pair{&comparisons, &felt.comparison}}) {
    for (const double value : *values) *mean += value / static_cast<double>(values->size());
    for (const double value : *values) squares += (value - *mean) * (value - *mean);
  }
  felt.deviation =
      std::sqrt(squares / static_cast<double>(standards.size() + comparisons.size() - 2));
  return felt;
}

/// A million trials of both kinds, by response and confidence: the points of the scale are the quarters of the distances
/// that a normal variable has from its mean, which are the quartiles of |z|.
std::vector<RatingCount> expected_ratings(const RatedDesign& design, double dprime,
                                          double criterion, double noise_in_deviations) {
  std::vector<double> thresholds{criterion};
  for (int point = 1; point < kPoints; ++point) {
    const double tail = 0.5 - 0.5 * point / kPoints;
    const double distance = upper_normal_quantile(tail) * noise_in_deviations;
    thresholds.insert(thresholds.begin(), criterion - distance);
    thresholds.push_back(criterion + distance);
  }
  std::vector<RatingCount> expected{};
  const auto count = [&](std::size_t category, bool is_signal) {
    const double from =
        category == 0 ? 1.0 : design.above(thresholds[category - 1], dprime, is_signal);
    const double to =
        category == thresholds.size() ? 0.0 : design.above(thresholds[category], dprime, is_signal);
    return static_cast<std::uint64_t>(std::llround(1e6 * (from - to)));
  };
  for (std::size_t category = 0; category <= thresholds.size(); ++category) {
    expected.push_back({.noise = count(category, false), .signal = count(category, true)});
  }
  return expected;
}

class ObserverConfidence : public testing::TestWithParam<RatedDesign> {
 protected:
  Study simulated(const ConfidenceJson& protocol, const std::string& recordings) {
    const std::filesystem::path file = folder_.path() / "rated.json";
    write_file(file, protocol.dump(1), Overwrite::refuse);
    const std::filesystem::path study = folder_.path() / "study";
    const Outcome outcome =
        asperity({"simulate", file.string(), "--study", study.string(), "--participants", "6",
                  "--seed", "7", "--jobs", "2", "--recordings", recordings});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Study::open(study, Access::read_only);
  }

  static std::vector<Finding> roc_of(const Study& study) {
    std::vector<Finding> roc{};
    for (const AnalysisOutcome& outcome : analyze_study(study, std::nullopt, {})) {
      for (const Finding& finding : outcome.findings) {
        if (finding.analysis == "confidence_roc") roc.push_back(finding);
      }
    }
    return roc;
  }

 private:
  TemporaryFolder folder_{};
};

// 3.29 standard errors contain the area with a probability of 99.9 %.
TEST_P(ObserverConfidence, HasTheAreaUnderTheRocThatItsNoiseImplies) {
  const RatedDesign& design = GetParam();
  const Study study = simulated(rated_protocol(design.id), "all");
  const FeltMagnitudes felt = felt_magnitudes(study);
  const double deviation = std::hypot(kNoise, felt.deviation);
  const double dprime = (felt.comparison - felt.standard) / deviation;
  EXPECT_GT(dprime, 1.0);
  const std::vector<RatingCount> expected =
      expected_ratings(design, dprime, design.criterion(felt, deviation), kNoise / deviation);
  const std::vector<Finding> roc = roc_of(study);
  const FoundNumbers found(roc);
  const auto error = found.value("auc.se.delong", kRatedLevel);
  ASSERT_TRUE(error);
  EXPECT_LT(*error, 0.03) << "the interval is of use";
  EXPECT_NEAR(*found.value("auc", kRatedLevel), roc_area(expected).area, 3.29 * *error);
  const double fitted = fit_roc(expected, RocVariance::free)->area();
  EXPECT_NEAR(*found.value("uv.az", kRatedLevel), fitted, 3.29 * *error);
  if (!design.has_equal_variances) return;
  EXPECT_NEAR(fitted, normal_below(design.separation * dprime / std::numbers::sqrt2), 1e-3);
  EXPECT_GT(*found.value("lr.equal.variance.p", kRatedLevel), 0.001);
}

TEST_P(ObserverConfidence, HasAnAreaOfAHalfIfTheObserverGuesses) {
  ConfidenceJson protocol = rated_protocol(GetParam().id);
  protocol["observer"]["deaf"] = true;
  const std::vector<Finding> roc = roc_of(simulated(protocol, "none"));
  const FoundNumbers found(roc);
  const auto error = found.value("auc.se.delong", kRatedLevel);
  ASSERT_TRUE(error);
  EXPECT_NEAR(*found.value("auc", kRatedLevel), 0.5, 3.29 * *error);
  EXPECT_NEAR(*found.value("uv.az", kRatedLevel), 0.5, 3.29 * *error);
}

std::vector<RatedDesign> rated_designs() {
  return {
      {.id = "two_alternatives",
       // The comparison is surface A in trials of a signal, and surface B in those of noise.
       .above =
           [](double threshold, double dprime, bool is_signal) {
             const double mean = dprime / std::numbers::sqrt2;
             return normal_below((is_signal ? mean : -mean) - threshold);
           },
       .criterion = [](const FeltMagnitudes&, double) { return 0.0; },
       .separation = std::numbers::sqrt2},
      {.id = "yes_no",
       .above = [](double threshold, double dprime,
                   bool is_signal) { return normal_below((is_signal ? dprime : 0.0) - threshold); },
       .criterion =
           [](const FeltMagnitudes& felt, double deviation) {
             return (std::log(kYesAbove) - felt.standard) / deviation;
           }},
      {.id = "same_different",
       .above =
           [](double threshold, double dprime, bool is_signal) {
             if (threshold <= 0.0) return 1.0;
             const double mean = is_signal ? dprime / std::numbers::sqrt2 : 0.0;
             return normal_below(mean - threshold) + normal_below(-mean - threshold);
           },
       .criterion =
           [](const FeltMagnitudes&, double deviation) {
             return std::log1p(kDifferentAbove) / (std::numbers::sqrt2 * deviation);
           },
       .has_equal_variances = false}};
}

INSTANTIATE_TEST_SUITE_P(OfDesigns, ObserverConfidence, testing::ValuesIn(rated_designs()),
                         [](const auto& each) { return each.param.id; });

}  // namespace
}  // namespace asperity::test
