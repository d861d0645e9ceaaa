// Discriminations with the designs yes/no and same–different: plans, what a file cannot ask, and the virtual observer.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/choices/signal_detection.h"
#include "analysis/psychometric/detection_function.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using DesignJson = nlohmann::json;
using ::testing::HasSubstr;

constexpr int kLevels = 5;
constexpr int kRepetitions = 4;

DesignJson& design_block(DesignJson& protocol) { return protocol["blocks"]["comparisons"]; }

/// amplitude_jnd with constant stimuli and another design.
DesignJson with_design(const std::string& design) {
  const bool is_pair = design == "same_different";
  DesignJson protocol = test::without_practice(test::library_file("amplitude_jnd"));
  DesignJson& block = design_block(protocol);
  block.erase("procedure");
  block["design"] = design;
  block["vary"]["levels_percent"] = {5, 10, 20, 30, 50};
  block["repetitions"] = kRepetitions;
  if (!is_pair) block.erase("positions");
  block["question"]["options"] =
      is_pair ? DesignJson{{{"value", "same"}, {"text", "The same"}},
                           {{"value", "different"}, {"text", "Different"}}}
              : DesignJson{{{"value", "yes"}, {"text", "Yes"}}, {{"value", "no"}, {"text", "No"}}};
  protocol["observer"][is_pair ? "different_above" : "yes_above"] = is_pair ? 0.03 : 0.1;
  protocol["analysis"]["family"] = {"conditions"};
  return protocol;
}

/// "standard, comparison"
std::string roles_of(const Trial& trial) {
  std::string roles{};
  for (const PlannedPresentation& planned : trial.presentations) {
    roles += (roles.empty() ? "" : ", ") + planned.role;
  }
  return roles;
}

double amplitude_of(const PlannedPresentation& planned) {
  return std::get<double>(planned.stimulus.parameters.at("amplitude_m"));
}

TEST(YesNoDesign, PresentsTheStandardAndTheComparisonEquallyOften) {
  const Protocol protocol = test::valid(with_design("yes_no"));
  std::map<std::string, int> by_level{};
  int standards = 0;
  for (const Trial& trial : test::main_trials(protocol)) {
    ASSERT_EQ(trial.presentations.size(), 1U);
    const PlannedPresentation& surface = trial.presentations.front();
    const bool is_signal = surface.role == "comparison";
    EXPECT_EQ(trial.questions.front().correct, std::vector<std::string>{is_signal ? "yes" : "no"});
    EXPECT_EQ(std::get<double>(trial.factors.at("amplitude_m")), amplitude_of(surface));
    if (is_signal) ++by_level[text_of(trial.factors.at("amplitude_m"))];
    standards += is_signal ? 0 : 1;
  }
  EXPECT_EQ(standards, kLevels * kRepetitions);
  ASSERT_EQ(by_level.size(), static_cast<std::size_t>(kLevels));
  for (const auto& [level, trials] : by_level) EXPECT_EQ(trials, kRepetitions) << level;
}

TEST(SameDifferentDesign, PresentsEveryPairInBothOrdersAndBothEqualPairs) {
  const Protocol protocol = test::valid(with_design("same_different"));
  std::map<std::string, int> by_roles{};
  for (const Trial& trial : test::main_trials(protocol)) {
    ASSERT_EQ(trial.presentations.size(), 2U);
    const bool differs = trial.presentations[0].role != trial.presentations[1].role;
    EXPECT_EQ(amplitude_of(trial.presentations[0]) != amplitude_of(trial.presentations[1]),
              differs);
    EXPECT_EQ(trial.questions.front().correct,
              std::vector<std::string>{differs ? "different" : "same"});
    EXPECT_NE(trial.presentations[0].item, trial.presentations[1].item);
    ++by_roles[roles_of(trial)];
  }
  EXPECT_EQ(by_roles["standard, comparison"], kLevels * kRepetitions);
  EXPECT_EQ(by_roles["comparison, standard"], kLevels * kRepetitions);
  EXPECT_EQ(by_roles["standard, standard"], kLevels * kRepetitions);
  EXPECT_EQ(by_roles["comparison, comparison"], kLevels * kRepetitions);
}

TEST(DetectionDesigns, CountTheirRowsAsTheyMakeThem) {
  for (const char* const design : {"yes_no", "same_different"}) {
    const Protocol protocol = test::valid(with_design(design));
    const Protocol::Block& block = protocol.blocks.at("comparisons");
    EXPECT_EQ(row_count(protocol, block), rows_of(protocol, block).size());
  }
}

TEST(DetectionDesigns, AreStatedInTheDesignOfTheBlock) {
  const Protocol protocol = test::valid(with_design("same_different"));
  const std::string design =
      design_of(protocol, protocol.blocks.at("comparisons"), make_plan(protocol, {1, 0})).english();
  EXPECT_THAT(design, HasSubstr("same–different task, one surface after the other"));
  EXPECT_THAT(design, HasSubstr("5 levels × 16 presentations, half of them without a difference"));
  EXPECT_THAT(design, ::testing::Not(HasSubstr("conditions")));
}

TEST(DetectionDesigns, AreStored) {
  const Protocol stored = stored_protocol(with_design("yes_no").dump()).protocol;
  EXPECT_EQ(stored.blocks.at("comparisons").design(), find_design("yes_no"));
}

struct FaultOfDesign {
  const char* design = "";
  const char* pointer = "";
  const char* message = "";
  std::function<void(DesignJson& protocol)> change{};
};

TEST(DetectionDesigns, RefuseWhatTheyCannotAsk) {
  const std::vector<FaultOfDesign> faults{
      {"yes_no", "/question", "has the \"options\" \"yes\" and \"no\"",
       [](DesignJson& p) { design_block(p)["question"].erase("options"); }},
      {"same_different", "/question", "has the \"options\" \"different\" and \"same\"",
       [](DesignJson& p) { design_block(p)["question"]["options"][0]["value"] = "equal"; }},
      {"yes_no", "/question/judgement", "one response is correct",
       [](DesignJson& p) {
         design_block(p)["question"]["judgement"] = "comparison";
         design_block(p)["vary"]["levels_percent"] = {-10, 10};
       }},
      {"yes_no", "/positions", "presents one surface in each trial",
       [](DesignJson& p) { design_block(p)["positions"] = "balanced"; }},
      {"same_different", "/presented", "the same surface would always be presented first",
       [](DesignJson& p) { design_block(p).erase("positions"); }},
      {"yes_no", "/design", "needs a criterion; state \"yes_above\"",
       [](DesignJson& p) { p["observer"].erase("yes_above"); }},
      {"same_different", "/design", "needs a criterion; state \"different_above\"",
       [](DesignJson& p) { p["observer"].erase("different_above"); }},
      {"same_different", "/procedure", "presents every level equally often",
       [](DesignJson& p) {
         design_block(p).erase("repetitions");
         design_block(p)["procedure"] = {{"method", "constant_stimuli"}, {"repetitions", 4}};
       }},
      {"same_different", "/repetitions_of", "the levels of vary are presented equally often",
       [](DesignJson& p) {
         design_block(p)["repetitions_of"] = {
             {{"levels", {{"amplitude_m", 55e-6}}}, {"repetitions", 8}}};
       }},
      {"same_different", "/question/options", "the options are the surfaces felt",
       [](DesignJson& p) { design_block(p).erase("design"); }}};
  for (const FaultOfDesign& fault : faults) {
    SCOPED_TRACE(fault.message);
    DesignJson protocol = with_design(fault.design);
    fault.change(protocol);
    EXPECT_THAT(test::problems_at(protocol, std::string("/blocks/comparisons") + fault.pointer),
                HasSubstr(fault.message));
  }
}

/// The counts of "yes" or "different" of an observer whose magnitude is proportional to the amplitude, by the relative
/// difference of the surfaces.
std::vector<PsychometricBlock> judged(const Protocol& protocol, std::uint64_t seed) {
  const ExperimentKind& kind = kind_named("discrimination");
  const Protocol::Block& block = protocol.blocks.at("comparisons");
  constexpr double kStandard_m = 50e-6;
  std::map<double, PsychometricBlock> by_difference{};
  VirtualObserver observer(protocol.observer, Random(seed));
  for (const Trial& trial : test::main_trials(protocol)) {
    std::vector<ForceFeatures> felt{};
    double difference = 0.0;
    std::size_t comparisons = 0;
    for (const PlannedPresentation& planned : trial.presentations) {
      const double ratio = amplitude_of(planned) / kStandard_m;
      felt.push_back({.size = std::log(0.1 * ratio), .roughness = 0.0});
      comparisons += planned.role == "comparison" ? 1 : 0;
      difference = std::max(difference, ratio - 1.0);
    }
    const Expectations none{};
    const Question& question = trial.questions.front();
    const VirtualResponse response = kind.judge({.protocol = protocol,
                                                 .trial = trial,
                                                 .question = question,
                                                 .felt = felt,
                                                 .expectations = none,
                                                 .observer = observer,
                                                 .of_attempt = Random(seed),
                                                 .of_participant = Random(seed)});
    const std::string& said =
        question.options.at(std::get<ChosenOption>(response.answer).option).value;
    const double x =
        block.design()->is_signal(comparisons) ? std::round(100.0 * difference) / 100.0 : 0.0;
    PsychometricBlock& count = by_difference[x];
    count.x = x;
    ++count.trials;
    count.hits += said == block.design()->yes ? 1 : 0;
  }
  std::vector<PsychometricBlock> blocks{};
  for (const auto& [x, count] : by_difference) blocks.push_back(count);
  return blocks;
}

struct JudgedDesign {
  const char* design = "";
  DetectionTask task = DetectionTask::yes_no;
  const char* criterion = "";
  double exact = 0.0;  ///< a criterion between no difference and the smallest one
};
const std::vector<JudgedDesign>& judged_designs() {
  static const std::vector<JudgedDesign> kDesigns{
      {"yes_no", DetectionTask::yes_no, "yes_above", 0.1025},
      {"same_different", DetectionTask::same_different, "different_above", 0.025}};
  return kDesigns;
}

Protocol judged_protocol(const JudgedDesign& design, double noise, double criterion,
                         int repetitions) {
  DesignJson protocol = with_design(design.design);
  protocol["observer"]["feature_noise"] = noise;
  protocol["observer"]["lapse"] = 0.0;
  protocol["observer"]["magnitude_of"] = "normal_force";
  protocol["observer"][design.criterion] = criterion;
  design_block(protocol)["repetitions"] = repetitions;
  return test::valid(protocol);
}

TEST(DetectionDesigns, AreJudgedWithoutErrorByANoiselessObserver) {
  for (const JudgedDesign& design : judged_designs()) {
    const auto blocks = judged(judged_protocol(design, 0.0, design.exact, 4), 1);
    for (const PsychometricBlock& block : blocks) {
      EXPECT_EQ(block.hits, block.x > 0.0 ? block.trials : 0U) << design.design << ' ' << block.x;
    }
    const DetectionFit fit = fit_detection(blocks, {.task = design.task, .lambda = 0.02});
    EXPECT_EQ(fit.status, DetectionStatus::separated);
  }
}

// z of the difference between hits and false alarms is within ±3.29 with a probability of 99.9 %.
TEST(DetectionDesigns, AreGuessedByADeafObserver) {
  for (const JudgedDesign& design : judged_designs()) {
    DesignJson file = with_design(design.design);
    file["observer"]["deaf"] = true;
    design_block(file)["repetitions"] = 40;
    DetectionCounts counts{};
    for (const PsychometricBlock& block : judged(test::valid(file), 2)) {
      HitCount& count = block.x > 0.0 ? counts.signal : counts.noise;
      count.trials += block.trials;
      count.hits += block.hits;
    }
    const auto found = yes_no_sensitivity(loglinear_rates(counts));
    EXPECT_LT(std::abs(found->dprime), 3.29 * found->standard_error) << design.design;
  }
}

// The magnitude is proportional to the amplitude, and its logarithm has noise of 0.2: d′ = ln(1 + x)/0.2, and d′ = 1 at
// x = e^0.2 − 1 = 0.221.
TEST(DetectionDesigns, RecoverThePlantedDifferenceOfAnObserverWithNoise) {
  for (const JudgedDesign& design : judged_designs()) {
    const double criterion = design.task == DetectionTask::yes_no ? 0.1 * std::exp(0.1) : 0.35;
    const auto blocks = judged(judged_protocol(design, 0.2, criterion, 60), 3);
    const DetectionFit fit =
        fit_detection(blocks, {.task = design.task, .lambda = 0.0, .confidence = 0.999});
    ASSERT_EQ(fit.status, DetectionStatus::ok);
    ASSERT_TRUE(fit.alpha) << design.design;
    const double planted = std::exp(0.2) - 1.0;
    EXPECT_LT(fit.alpha->low, planted) << design.design;
    EXPECT_GT(fit.alpha->high, planted) << design.design;
    EXPECT_LT(fit.alpha->high - fit.alpha->low, 2.0 * planted) << "the interval is of use";
  }
}

TEST(DetectionDesigns, HaveOneProblemWithAProcedure) {
  DesignJson protocol = with_design("yes_no");
  design_block(protocol)["procedure"] = {{"method", "psi"}, {"stop", {{"trials", 40}}}};
  EXPECT_THAT(test::problems_in(protocol),
              ::testing::ElementsAre(
                  HasSubstr("presents every level equally often, because a proportion correct")))
      << "the key is to be removed, whatever it states";
}

}  // namespace
}  // namespace asperity
