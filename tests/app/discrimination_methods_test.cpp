// The text for a paper of discriminations with the response "cannot tell", with d′ and with ratings of confidence.

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/references.h"
#include "app/findings/outcome/study_analysis.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "tests/app/made_up_choices.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The block of the library's protocol with constant levels and the option "cannot tell".
Protocol unforced_library_protocol(DiscriminationJudgement judgement) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name != "amplitude_jnd") continue;
    Protocol protocol =
        read_protocol(each.text, "amplitude_jnd.json", declarations_of(built_in_models()));
    Protocol::Block& block = protocol.blocks.at("comparisons");
    block.procedure.reset();
    for (auto& question : block.questions) {
      question.allow_cannot_tell = true;
      if (question.judgement()) question.own = DiscriminationQuestion{judgement};
    }
    return protocol;
  }
  ADD_FAILURE() << "the library has no such protocol";
  return {};
}

/// p1, p2, …: `unsure` of 20 responses at each level are "cannot tell". Computed once in this process.
const AnalysisOutcome& outcome_with_unsure(const std::vector<int>& unsure, bool is_performance) {
  const auto trials_of_person = [&](int person) {
    MadeUpObserver observer(is_performance ? kPerformer : kComparer,
                            static_cast<unsigned>(person + 1));
    std::vector<MadeUpTrial> trials =
        trials_of(observer.choices(is_performance ? kAbove_m : kAround_m, 20, is_performance));
    for (std::size_t i = 0; i < trials.size(); ++i) {
      trials[i].options = {"standard", "comparison", "cannot_tell"};
      if (static_cast<int>(i % 20) < unsure[static_cast<std::size_t>(person)]) {
        trials[i].answers = {"cannot_tell"};
      }
    }
    return trials;
  };
  return outcome_once(outcome_key("unsure", unsure.at(0), unsure.at(1), is_performance), [&] {
    return outcome_of_choices(
        discrimination_protocol(is_performance ? "performance" : "comparison"),
        {.number = 2, .first = 1}, trials_of_person);
  });
}

std::string methods_of(const AnalysisOutcome& outcome, DiscriminationJudgement judgement) {
  return find_analysis("discrimination")
      ->fit_for_paper(unforced_library_protocol(judgement), outcome);
}

TEST(DiscriminationMethods, StateTheBootstrapWhereResponsesAreCannotTell) {
  const auto performance = DiscriminationJudgement::performance;
  const std::string all = methods_of(outcome_with_unsure({4, 2}, true), performance);
  EXPECT_THAT(all, HasSubstr("Each response “cannot tell” counted as the mean of a guess, one half "
                             "of a correct response [Kaernbach 2001]."));
  EXPECT_THAT(all, HasSubstr("Confidence intervals (CI) of single participants are bootstrap "
                             "percentiles (400 resamples of the three outcomes at each level)."));
  EXPECT_THAT(all, Not(HasSubstr("delta method")));
  const std::string mixed = methods_of(outcome_with_unsure({4, 0}, true), performance);
  EXPECT_THAT(mixed, HasSubstr("single participants with responses “cannot tell” are bootstrap"));
  EXPECT_THAT(mixed, HasSubstr("those of the other participants are by the delta method."));
  const std::string none = methods_of(outcome_with_unsure({0, 0}, true), performance);
  EXPECT_THAT(none, HasSubstr("single participants are by the delta method."));
  EXPECT_THAT(none, Not(HasSubstr("cannot tell")));
}

TEST(DiscriminationMethods, StateTheRateOfCannotTell) {
  const std::string text = estimate_sentence(outcome_with_unsure({4, 2}, true)).text;
  EXPECT_THAT(text, HasSubstr("The rate of the response “cannot tell” was 15 % (10 % to 20 % for "
                              "single participants)."));
  EXPECT_THAT(estimate_sentence(outcome_with_unsure({0, 0}, true)).text,
              Not(HasSubstr("cannot tell")));
}

TEST(DiscriminationMethods, StateTheCoverageOfTheJndWithSplitCounts) {
  for (const bool is_performance : {false, true}) {
    const AnalysisOutcome& outcome = outcome_with_unsure({4, 2}, is_performance);
    const std::string coverage = note_on_unforced_jnd(is_performance).english();
    const std::string of_others = note_on_unforced_jnd(!is_performance).english();
    const auto judgement =
        is_performance ? DiscriminationJudgement::performance : DiscriminationJudgement::comparison;
    EXPECT_THAT(methods_of(outcome, judgement), HasSubstr(coverage));
    const std::string note = table_of(outcome, "thresholds").note.english();
    EXPECT_THAT(note, HasSubstr(coverage));
    EXPECT_THAT(note, Not(HasSubstr(of_others)));
  }
  const AnalysisOutcome& forced = outcome_with_unsure({0, 0}, true);
  EXPECT_THAT(table_of(forced, "thresholds").note.english(),
              Not(HasSubstr("In simulations of responses “cannot tell”")));
}

/// A yes/no trial with a rating of confidence from 1 to 3.
MadeUpTrial rated_detection(bool is_signal, double impression) {
  MadeUpTrial trial{};
  trial.factors_json = nlohmann::json{{"amplitude_m", is_signal ? 55e-6 : kStandard_m}}.dump();
  const std::string role = is_signal ? "comparison" : "standard";
  trial.surfaces = {surface_of(role, "sinusoid", "")};
  trial.surfaces.back().role = role;
  trial.options = {"yes", "no"};
  const bool is_yes = impression > 0.5;
  const double distance = std::abs(impression - 0.5);
  trial.questions = {"which", "sure"};
  trial.answers = {is_yes ? "yes" : "no", distance > 1.0 ? "3" : distance > 0.5 ? "2" : "1"};
  trial.right = {is_signal ? "yes" : "no"};
  return trial;
}

AnalysisOutcome outcome_of_rated_detections() {
  nlohmann::json protocol = discrimination_protocol("performance");
  nlohmann::json& block = protocol["blocks"]["only"];
  block["design"] = "yes_no";
  const nlohmann::json asked = block["question"];
  block.erase("question");
  block["questions"] = {asked,
                        {{"name", "sure"},
                         {"prompt", "How sure?"},
                         {"scale", {{"minimum", 1}, {"maximum", 3}, {"points", 3}}},
                         {"confidence_of", asked.at("name")}}};
  return outcome_of_choices(protocol, {.number = 6, .first = 1}, [](int person) {
    Random random(static_cast<std::uint64_t>(300 + person));
    std::vector<MadeUpTrial> trials{};
    for (int i = 0; i < 60; ++i) {
      trials.push_back(rated_detection(false, random.normal()));
      trials.push_back(rated_detection(true, 1.0 + random.normal()));
    }
    return trials;
  });
}

TEST(DiscriminationMethods, StateSensitivityAndRocWithTheirSources) {
  const AnalysisOutcome outcome = outcome_of_rated_detections();
  Protocol protocol = unforced_library_protocol(DiscriminationJudgement::performance);
  protocol.blocks.at("comparisons").own = DiscriminationBlock{&yes_no_task()};
  const std::string methods = find_analysis("discrimination")->fit_for_paper(protocol, outcome);
  EXPECT_THAT(methods, HasSubstr("with the log-linear correction [Hautus 1995]"));
  EXPECT_THAT(methods, HasSubstr("expanded percentiles of a bootstrap over participants "
                                 "[Hesterberg 2015]"));
  EXPECT_THAT(methods, HasSubstr("unequal variances was fitted by maximum likelihood over the "
                                 "responses of all participants [Dorfman 1969]"));
  EXPECT_THAT(methods, HasSubstr("[Simpson 1973]"));
  for (const char* const key : {"Dorfman 1969", "Frijters 1979", "Hacker 1979", "Hautus 1995",
                                "Hesterberg 2015", "Macmillan 2005", "Simpson 1973"}) {
    EXPECT_FALSE(reference(key).entry.empty());
  }
  const std::string results = estimate_sentence(outcome).text;
  EXPECT_THAT(results, HasSubstr("Mean d′ by the amplitude of the comparison: 55 µm: "));
  EXPECT_THAT(results, HasSubstr("A_z = 0."));
  EXPECT_THAT(results, HasSubstr("d_a = "));
  // Without such results their methods are not described.
  EXPECT_THAT(find_analysis("discrimination")->fit_for_paper(protocol, {}),
              Not(HasSubstr("Hautus")));
}

// d′ of three alternatives and of an oddity task: the means are those of a column of the table.
TEST(DiscriminationMethods, StateTheSensitivityOfChoicesAmongThree) {
  Protocol protocol = unforced_library_protocol(DiscriminationJudgement::performance);
  AnalysisOutcome outcome{};
  AnsweredQuestion& asked = outcome.questions.emplace_back();
  asked.name = "sensitivity";
  asked.answer = Phrase("Mean d′ by the amplitude of the comparison: 55 µm: 1.2.");
  asked.finding.value = 1.2;
  for (const auto& [design, source] : {std::pair{&three_alternatives(), "[Hacker 1979]"},
                                       std::pair{&oddity_task(), "[Frijters 1979]"}}) {
    protocol.blocks.at("comparisons").own = DiscriminationBlock{design};
    const std::string methods = find_analysis("discrimination")->fit_for_paper(protocol, outcome);
    EXPECT_THAT(methods, HasSubstr(source));
    EXPECT_THAT(methods, HasSubstr("(correct responses + 1/3)/(trials + 1)"));
  }
}

}  // namespace
}  // namespace asperity
