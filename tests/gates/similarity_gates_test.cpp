// Gates of rated dissimilarities: the plan of the library's protocol, its observer with known features, and the analysis.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/dissimilarity/procrustes.h"
#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "app/findings/methods/similarity/similarity_analysis.h"
#include "app/findings/outcome/found_numbers.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"
#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

/// The library's protocol with a fine scale, without its familiarisation.
Protocol rated_models() {
  return library_protocol("map_of_renderings", [](nlohmann::ordered_json& protocol) {
    protocol["flow"] = nlohmann::ordered_json::array({{{"run", "ratings"}}});
    protocol["blocks"].erase("familiarisation");
    for (const char* const factor : {"familiar_1", "familiar_2"}) {
      protocol["factors"].erase(factor);
      protocol["stimuli"].erase(factor);
    }
  });
}

/// Features of the ten models: size and roughness are places on an ellipse, all others are equal. Their distances are
/// therefore those of a plane (squared_distance). The angles between neighbours differ, so that no two distances are equal.
std::map<std::string, ForceFeatures> planted_features(const Protocol& protocol) {
  std::map<std::string, ForceFeatures> planted{};
  double angle_rad = 0.0;
  double step_rad = 0.4;
  for (const Level& level : protocol.factors.at("model").levels) {
    planted[text_of(level)] = {.size = std::cos(angle_rad), .roughness = 0.6 * std::sin(angle_rad)};
    angle_rad += step_rad;
    step_rad += 0.05;
  }
  return planted;
}

/// A study of a number of participants who judge planted features.
GatheredAnswers rated_by(const ObserverDeclaration& declared, std::uint32_t participants,
                         std::uint64_t seed) {
  const Protocol protocol = rated_models();
  const std::map<std::string, ForceFeatures> planted = planted_features(protocol);
  const ExperimentKind& kind = kind_named("similarity");
  const Expectations none{};
  GatheredAnswers gathered{};
  gathered.kind = "similarity";
  gathered.words.place("");
  gathered.questions.emplace_back().name = "different";
  gathered.questions.back().form = ScaleForm{.minimum = 0.0, .maximum = 100.0};
  gathered.factor_levels.emplace_back();
  for (std::uint32_t person = 0; person < participants; ++person) {
    gathered.people.push_back({.label = "P" + std::to_string(person)});
    const Random of_person = Random(seed).split(person);
    const Plan plan = make_plan(protocol, {.seed = seed + person});
    for (const Trial& trial : plan.trials) {
      const Random of_trial = of_person.split(static_cast<std::uint64_t>(trial.ordinal));
      VirtualObserver observer(declared, of_trial.split("observer"));
      std::vector<ForceFeatures> felt{};
      GatheredAnswer answer{.person = person,
                            .question = gathered.words.place("different"),
                            .surface_count = 2,
                            .reply_count = 1};
      answer.first_surface = gathered.surfaces.size();
      answer.first_reply = gathered.replies.size();
      for (const PlannedPresentation& surface : trial.presentations) {
        felt.push_back(planted.at(surface.item));
        gathered.surfaces.push_back({.item = gathered.words.place(surface.item)});
      }
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

AnalysisOutcome analysed_ratings(const GatheredAnswers& gathered) {
  AnalysisOutcome outcome{};
  analyze_similarity(gathered, outcome);
  return outcome;
}

struct RatedPair {
  std::string first{};
  std::string second{};
  double rating = 0.0;
};
std::vector<RatedPair> ratings_in(const GatheredAnswers& gathered) {
  std::vector<RatedPair> ratings{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const auto surfaces = gathered.surfaces_of(answer);
    ratings.push_back({gathered.word(surfaces[0].item), gathered.word(surfaces[1].item),
                       *gathered.reply_of(answer).number});
  }
  return ratings;
}

TEST(NoiselessObserver, RatesDissimilaritiesInTheOrderOfTheirDistances) {
  const GatheredAnswers gathered = rated_by({.feature_noise = 0.0, .lapse = 0.0}, 3, 21);
  const auto planted = planted_features(rated_models());
  std::vector<std::pair<double, double>> rated{};  // distance, rating
  for (const RatedPair& pair : ratings_in(gathered)) {
    rated.emplace_back(squared_distance(planted.at(pair.first), planted.at(pair.second)),
                       pair.rating);
  }
  ASSERT_EQ(rated.size(), 3U * 55U);
  std::sort(rated.begin(), rated.end());
  for (std::size_t i = 1; i < rated.size(); ++i) {
    EXPECT_GE(rated[i].second, rated[i - 1].second) << "distance² " << rated[i].first;
  }
  EXPECT_EQ(rated[29].second, 0.0) << "three participants rate ten identical pairs";
  EXPECT_GT(rated[30].second, 0.0);

  const AnalysisOutcome outcome = analysed_ratings(gathered);
  const FoundNumbers found(outcome.findings);
  EXPECT_LT(found.value("stress.ordinal", "2").value(), 0.01)
      << "the ratings are rounded to points";
  EXPECT_EQ(found.value("stress.perm.p"), 1.0 / 200.0) << "below all permutations";
}

/// The positions of the planted features and of the configuration, in one order of the items.
struct Planes {
  std::vector<std::string> items{};
  Eigen::MatrixXd planted{};
  Eigen::MatrixXd found{};
};
Planes planes_of(const FoundNumbers& found) {
  Planes planes{};
  const auto planted = planted_features(rated_models());
  planes.planted.resize(static_cast<Eigen::Index>(planted.size()), 2);
  planes.found.resize(planes.planted.rows(), 2);
  for (const auto& [item, features] : planted) {
    const auto row = static_cast<Eigen::Index>(planes.items.size());
    planes.items.push_back(item);
    planes.planted.row(row) << features.size, features.roughness;
    planes.found.row(row) << found.value("position", item + "|1").value(),
        found.value("position", item + "|2").value();
  }
  return planes;
}

/// The squared radius of Hotelling's T² in a plane for n participants, from the closed quantile of F with 2 and n − 2
/// degrees of freedom; n/(n − 1) corrects the variance of the bootstrap.
double squared_radius(double n, double confidence) {
  const double f = 0.5 * (n - 2.0) * (std::pow(1.0 - confidence, -2.0 / (n - 2.0)) - 1.0);
  return n / (n - 1.0) * 2.0 * (n - 1.0) / (n - 2.0) * f;
}

// The expected rating of a pair is a monotone function of its distance, because the noise is equal in all directions. The
// planted plane, brought onto the configuration, is therefore within its ellipses, here widened from 95 % of a normal
// distribution, whose squared radius is −2·ln 0.05, to 99.9 %. Order alone determines ten items only to some per cent, so
// that with many participants the ellipses become smaller than this.
TEST(ObserverOfStatedNoise, LeavesThePlantedPlaneWithinItsEllipses) {
  constexpr std::uint32_t kParticipants = 12;
  ObserverDeclaration declared{};
  declared.feature_noise = 0.05;
  declared.lapse = 0.02;
  const AnalysisOutcome outcome = analysed_ratings(rated_by(declared, kParticipants, 22));
  const FoundNumbers found(outcome.findings);
  EXPECT_EQ(found.value("cv.chosen"), 2.0);
  EXPECT_EQ(found.value("stress.perm.p"), 1.0 / 200.0);
  const Planes planes = planes_of(found);
  const auto rotation = procrustes(planes.found, planes.planted);
  ASSERT_TRUE(rotation);
  std::cout << "Procrustes r² of the planted plane: " << rotation->r_squared << '\n';
  EXPECT_GE(rotation->r_squared, 0.97);
  const double wider =
      std::sqrt(squared_radius(kParticipants, kGateConfidence) / (-2.0 * std::log(0.05)));
  for (std::size_t i = 0; i < planes.items.size(); ++i) {
    const std::string& item = planes.items[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double x = rotation->fitted(row, 0) - planes.found(row, 0);
    const double y = rotation->fitted(row, 1) - planes.found(row, 1);
    const double angle_rad = found.value("region.angle", item).value();
    const double along = (x * std::cos(angle_rad) + y * std::sin(angle_rad)) /
                         found.value("region.major", item).value();
    const double across = (y * std::cos(angle_rad) - x * std::sin(angle_rad)) /
                          found.value("region.minor", item).value();
    EXPECT_LE(std::hypot(along, across), wider) << item;
  }
}

// Every point of 0 … 100 is equally probable: mean 50, variance (101² − 1)/12.
TEST(DeafObserver, RatesPairsByChance) {
  const double sd = std::sqrt((101.0 * 101.0 - 1.0) / 12.0);
  constexpr double kZ = 3.2905;  // of 99.9 %
  const GatheredAnswers gathered = rated_by({.deaf = true}, 40, 23);
  std::map<bool, std::pair<double, double>> sums{};  // identical or not: sum and number
  for (const RatedPair& pair : ratings_in(gathered)) {
    auto& [sum, number] = sums[pair.first == pair.second];
    sum += pair.rating;
    number += 1.0;
  }
  ASSERT_EQ(sums.size(), 2U);
  for (const auto& [is_identical, of] : sums) {
    EXPECT_NEAR(of.first / of.second, 50.0, kZ * sd / std::sqrt(of.second)) << is_identical;
  }
  const AnalysisOutcome outcome = analysed_ratings(gathered);
  const FoundNumbers found(outcome.findings);
  EXPECT_GT(found.value("t.p.two", "identical").value(), 0.001);
}

// With 39 permutations p ≤ .05 has the probability 2/40.
TEST(DeafObserver, HasNoMoreConfigurationThanPermutedRatings) {
  constexpr std::size_t kStudies = 60;
  HitCount significant{.trials = kStudies};
  for (std::uint64_t study = 0; study < kStudies; ++study) {
    const GatheredAnswers gathered = rated_by({.deaf = true}, 6, 1000 + 100 * study);
    std::map<std::string, Eigen::Index> places{};
    for (const auto& [item, features] : planted_features(rated_models()))
      places.emplace(item, static_cast<Eigen::Index>(places.size()));
    std::vector<RatedPairs> raters(
        6, RatedPairs{Eigen::MatrixXd::Zero(10, 10), Eigen::MatrixXd::Zero(10, 10)});
    const std::vector<RatedPair> ratings = ratings_in(gathered);
    for (std::size_t i = 0; i < ratings.size(); ++i) {
      const Eigen::Index first = places.at(ratings[i].first);
      const Eigen::Index second = places.at(ratings[i].second);
      if (first == second) continue;
      RatedPairs& rater = raters[gathered.answers[i].person];
      for (const auto& [a, b] : {std::pair(first, second), std::pair(second, first)}) {
        rater.values(a, b) = ratings[i].rating;
        rater.weights(a, b) = 1.0;
      }
    }
    const StressByChance stress =
        stress_by_chance(raters, {.permutations = 39, .random_starts = 2}, Random(study));
    if (stress.p <= 0.05) ++significant.hits;
  }
  expect_by_chance("configurations of deaf ratings with p ≤ .05", significant, 0.05, 1.0);
}

}  // namespace
}  // namespace asperity
