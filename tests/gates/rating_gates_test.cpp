// Gates of ratings: the plan of the library's protocol, its observer with known features, and the analysis.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/methods/rating/rating_analysis.h"
#include "app/findings/outcome/found_numbers.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"
#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

constexpr double kGreatestRating = 100.0;  // the scale's maximum

/// The library's protocol without its familiarisation, which presents all textures.
Protocol rated_photographs() {
  return library_protocol("roughness_of_photographs", [](nlohmann::ordered_json& protocol) {
    protocol["flow"] = nlohmann::ordered_json::array({{{"run", "ratings"}}});
    protocol["blocks"].erase("range");
  });
}

/// The natural logarithms of the normal forces over their mean, in the range of the demonstration's textures.
std::map<std::string, double> planted_sizes() {
  return {{"brick", -3.4}, {"wood", -4.0}, {"stone", -4.4}, {"metal", -5.0}};
}

/// A study of a number of participants who rate surfaces with planted sizes.
GatheredAnswers textures_rated_by(const ObserverDeclaration& declared, std::uint32_t participants,
                                  std::uint64_t seed) {
  const Protocol protocol = rated_photographs();
  const std::map<std::string, double> planted = planted_sizes();
  const ExperimentKind& kind = kind_named("rating");
  const Expectations none{};
  GatheredAnswers gathered{};
  gathered.kind = "rating";
  gathered.words.place("");
  gathered.questions.emplace_back().name = "rough";
  gathered.questions.back().form = ScaleForm{.minimum = 0.0, .maximum = kGreatestRating};
  gathered.factor_levels.emplace_back();
  for (std::uint32_t person = 0; person < participants; ++person) {
    gathered.people.push_back({.label = "P" + std::to_string(person)});
    const Random of_person = Random(seed).split(person);
    const Plan plan = make_plan(protocol, {.seed = seed + person});
    for (const Trial& trial : plan.trials) {
      const Random of_trial = of_person.split(static_cast<std::uint64_t>(trial.ordinal));
      VirtualObserver observer(declared, of_trial.split("observer"));
      const std::string& item = trial.presentations.front().item;
      const std::vector<ForceFeatures> felt{{.size = planted.at(item)}};
      GatheredAnswer answer{.person = person,
                            .question = gathered.words.place("rough"),
                            .repetition = trial.repetition,
                            .surface_count = 1,
                            .reply_count = 1,
                            .first_surface = gathered.surfaces.size(),
                            .first_reply = gathered.replies.size()};
      gathered.surfaces.push_back({.item = gathered.words.place(item)});
      const Question& question = trial.questions.front();
      const VirtualResponse response =
          kind.judge({protocol, trial, question, felt, none, observer, of_trial, of_person});
      gathered.replies.push_back(
          {.number = items_of(question, response.answer).front().number.value()});
      gathered.answers.push_back(answer);
    }
  }
  return gathered;
}

AnalysisOutcome outcome_of_ratings(const GatheredAnswers& gathered) {
  AnalysisOutcome outcome{};
  analyze_rating(gathered, outcome);
  return outcome;
}

/// The observer of a rating (docs/authoring-protocols.md) marks the logistic function of 3·l·(r + ε + 4.3) + b + η, with
/// the loading l of the scale, ε ~ N(0, σ²), b ~ N(0, 0.3²) and η ~ N(0, 0.4²); in a lapse r + ε is standard normal.
constexpr double kLoadingOfRough = 0.61895420601297246;
constexpr double kSlopeOfRough = 3.0 * kLoadingOfRough;
constexpr double kMediumSize = -4.3;
constexpr double kResponseVariance = 0.3 * 0.3 + 0.4 * 0.4;

/// 100·E[1/(1 + exp(−x))] for x ~ N(mean, variance), by the trapezium rule.
double mean_mark(double mean, double variance) {
  constexpr int kSteps = 400;
  constexpr double kFurthest = 8.0;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double z = kFurthest * (2.0 * i / kSteps - 1.0);
    const double weight = std::exp(-0.5 * z * z);
    sum += weight / (1.0 + std::exp(-mean - std::sqrt(variance) * z));
    weights += weight;
  }
  return kGreatestRating * sum / weights;
}

double planted_mean(double size, const ObserverDeclaration& declared) {
  const double noise = kSlopeOfRough * declared.feature_noise;
  const double judged =
      mean_mark(kSlopeOfRough * (size - kMediumSize), noise * noise + kResponseVariance);
  const double lapsed =
      mean_mark(-kSlopeOfRough * kMediumSize, kSlopeOfRough * kSlopeOfRough + kResponseVariance);
  return (1.0 - declared.lapse) * judged + declared.lapse * lapsed;
}

ObserverDeclaration observer_of_normal_force(double noise, double lapse) {
  ObserverDeclaration declared{};
  declared.magnitude_of = ObserverDeclaration::MagnitudeOf::normal_force;
  declared.feature_noise = noise;
  declared.lapse = lapse;
  return declared;
}

// The means of the participants are nearly normal, so that the t interval of the analysis has its confidence; the 95 % interval
// is widened to 99.9 %.
TEST(ObserverOfStatedNoise, RatesTexturesAtTheirPlantedMeans) {
  constexpr std::uint32_t kParticipants = 100;
  const ObserverDeclaration declared = observer_of_normal_force(0.3, 0.05);
  const AnalysisOutcome outcome =
      outcome_of_ratings(textures_rated_by(declared, kParticipants, 31));
  const FoundNumbers found(outcome.findings);
  const double df = kParticipants - 1.0;
  const double wider = t_limit({.confidence = kGateConfidence, .df = df}).value() /
                       t_limit({.confidence = 0.95, .df = df}).value();
  for (const auto& [texture, size] : planted_sizes()) {
    const Finding* const mean = found.find("mean.score", "rough|" + texture);
    ASSERT_NE(mean, nullptr) << texture;
    EXPECT_EQ(mean->n, kParticipants);
    const double planted = planted_mean(size, declared);
    std::cout << texture << ": planted " << planted << ", mean " << *mean->value << " ["
              << *mean->low << ", " << *mean->high << "]\n";
    EXPECT_LE(std::abs(planted - *mean->value), 0.5 * wider * (*mean->high - *mean->low))
        << texture;
  }
}

// Without noise and lapses, only the participants' biases and the variation of the responses are left, which are smaller
// than the differences between the textures.
TEST(NoiselessObserver, RatesTexturesInTheirOrder) {
  const AnalysisOutcome outcome =
      outcome_of_ratings(textures_rated_by(observer_of_normal_force(0.0, 0.0), 6, 32));
  const FoundNumbers found(outcome.findings);
  std::vector<std::pair<double, double>> rated{};  // size, mean
  for (const auto& [texture, size] : planted_sizes()) {
    rated.emplace_back(size, found.value("mean.score", "rough|" + texture).value());
  }
  std::sort(rated.begin(), rated.end());
  for (std::size_t i = 1; i < rated.size(); ++i) {
    EXPECT_GT(kLoadingOfRough * (rated[i].second - rated[i - 1].second), 0.0) << rated[i].first;
  }
}

}  // namespace
}  // namespace asperity
