// Three tasks in one session, two groups of participants, and five scales in a trial; pairs of the levels of a factor;
// rated pairs; interleaved staircases: from check to report, and through kills.

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

/// Ratings on five scales, then a recognition, then a selection with a rating of confidence; 10 trials.
nlohmann::ordered_json three_tasks() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["format"] = "asperity.protocol/2";
  protocol["kind"] = "rating";
  protocol["name"] = "three_tasks";
  protocol["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
  protocol["groups"] = {{"factor", "training"}, {"assigned", "balanced"}};
  protocol["stimuli"]["plain"] =
      nlohmann::ordered_json::parse(R"({"model": "height_map", "texture": {"factor": "texture"}})");
  nlohmann::ordered_json selection = protocol["blocks"]["main"];
  selection["kind"] = "selection";
  const nlohmann::ordered_json asked = selection["question"];
  selection.erase("question");
  selection["questions"] = {
      asked,
      {{"name", "sure"}, {"prompt", "How sure?"}, {"scale", nlohmann::ordered_json::object()}}};
  nlohmann::ordered_json recognition = small_recognition(2)["blocks"]["main"];
  recognition["kind"] = "recognition";
  recognition["presented"] = {{{"stimulus", "plain"}}};
  nlohmann::ordered_json ratings = recognition;
  ratings.erase("kind");
  ratings.erase("question");
  ratings["repetitions"] = 1;
  ratings["question_layout"] = "one_page";
  ratings["question_order"] = "shuffle";
  for (const char* const name : {"rough", "hard", "slippery", "coarse", "pleasant"}) {
    ratings["questions"].push_back({{"name", name},
                                    {"prompt", std::string("How ") + name + "?"},
                                    {"scale", {{"minimum", 1}, {"maximum", 7}, {"points", 7}}}});
  }
  protocol["blocks"] = {
      {"ratings", ratings}, {"recognition", recognition}, {"selection", selection}};
  protocol["flow"] = nlohmann::ordered_json::parse(
      R"([{"run": "ratings"}, {"run": "recognition"}, {"run": "selection"}])");
  return protocol;
}

/// Both orders of two models with two textures, with a tie, twice; 8 trials.
nlohmann::ordered_json pairs_of_models() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["kind"] = "paired_comparison";
  protocol["name"] = "pairs_of_models";
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("positions");
  block["all_pairs"] = {{"factor", "model"}, {"in_both_orders", true}};
  block["presented"] = {{{"stimulus", "rendered"}}};
  block["question"]["tie"] = {{"text", "Neither"}};
  return protocol;
}

/// The dissimilarity of five models on one texture, with identical pairs, side by side; 15 trials, or 11 or 9 in two parts.
nlohmann::ordered_json rated_pairs_of_models(int parts) {
  nlohmann::ordered_json protocol = small_selection(1);
  protocol["format"] = "asperity.protocol/2";
  protocol["kind"] = "similarity";
  protocol["name"] = "rated_pairs";
  protocol.erase("realism_standard");
  protocol["factors"] = nlohmann::ordered_json::parse(
      R"({"model": {"levels": ["height_map", "bump_map", "normal_map", "lateral_gradient", "sinusoid"]}})");
  protocol["stimuli"] = nlohmann::ordered_json::parse(
      R"({"rendered": {"model": {"factor": "model"}, "texture": "walnut"}})");
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("crossed");
  block["positions"] = "shuffle";
  block["all_pairs"] = {{"factor", "model"}, {"with_identical", true}, {"parts", parts}};
  block["presented"] = {{{"stimulus", "rendered"}}};
  block["question"] = nlohmann::ordered_json::parse(
      R"({"name": "different", "prompt": "How different were they?",
          "scale": {"minimum": 0, "maximum": 100, "labels": ["identical", "completely different"]}})");
  return protocol;
}

/// Two interleaved staircases of four trials.
nlohmann::ordered_json staircases() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["format"] = "asperity.protocol/2";
  protocol["kind"] = "discrimination";
  protocol["name"] = "staircases";
  for (const char* const key : {"textures", "factors", "realism_standard", "analysis"})
    protocol.erase(key);
  protocol["stimuli"] = nlohmann::ordered_json::parse(
      R"({"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}})");
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  for (const char* const key :
       {"crossed", "listed", "drawn", "repetitions", "order", "maximum_in_a_row"}) {
    block.erase(key);
  }
  block["vary"] = nlohmann::ordered_json::parse(
      R"({"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
          "levels_percent": {"lowest": 5, "highest": 100, "step": 5}})");
  block["procedure"] = nlohmann::ordered_json::parse(
      R"({"method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10], "stop": {"trials": 4},
          "tracks": [{"start": 50}, {"start": 25}]})");
  block["presented"] = nlohmann::ordered_json::parse(
      R"([{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}])");
  block["positions"] = "balanced";
  block["question"] = {
      {"name", "rougher"}, {"prompt", "Which is rougher?"}, {"judgement", "performance"}};
  return protocol;
}

/// Two levels of a same–different task, each as four pairs.
nlohmann::ordered_json same_different() {
  nlohmann::ordered_json protocol = staircases();
  protocol["name"] = "same_different";
  protocol["observer"]["different_above"] = 0.2;
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("procedure");
  block["design"] = "same_different";
  block["vary"].erase("levels_percent");
  block["vary"]["levels_percent"] = {20, 60};
  block["question"] = nlohmann::ordered_json::parse(
      R"({"name": "different", "prompt": "Same or different?", "judgement": "performance",
          "options": [{"value": "same", "text": "The same"}, {"value": "different", "text": "Different"}]})");
  return protocol;
}

/// Three levels of a choice among three surfaces: of oddity trials with both types of every level.
nlohmann::ordered_json choice_of_three(const std::string& design) {
  nlohmann::ordered_json protocol = staircases();
  protocol["name"] = "choice_of_three";
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("procedure");
  block["design"] = design;
  block["vary"].erase("levels_percent");
  block["vary"]["levels_percent"] = {20, 60, 90};
  return protocol;
}

/// The interleaved staircases with oddity trials.
nlohmann::ordered_json tracks_of_oddity() {
  nlohmann::ordered_json protocol = staircases();
  protocol["blocks"]["main"]["design"] = "oddity";
  return protocol;
}

/// A protocol in a small study.
class Tasks : public testing::Test {
 protected:
  explicit Tasks(const nlohmann::ordered_json& protocol)
      : file_(small_.study() / "protocols" /
              (protocol["name"].template get<std::string>() + ".json")) {
    write_text(file_, protocol.dump(2));
  }

  std::vector<std::string> run_of(const fs::path& study, bool resumes) const {
    std::vector<std::string> words{"run",      file_,       "--study", study, "--participant",
                                   "standin1", "--virtual", "--seed",  "9"};
    if (resumes) words.emplace_back("--resume");
    return words;
  }

  /// Killed after every trial, the session goes on with the next one, to the same answers.
  void expect_same_answers_after_kills(int trials) const {
    const fs::path never_killed = small_.place() / "never_killed";
    copy_stimuli(small_, never_killed);
    ASSERT_EQ(asperity(run_of(never_killed, false)).status, 0);
    const auto expected = exported(never_killed, small_.place() / "expected");
    for (int trial = 0; trial + 1 < trials; ++trial) {
      Invocation invocation{};
      invocation.arguments = run_of(small_.study(), trial > 0);
      Program program(invocation);
      program.read_until(
          [](const std::string&, const std::string& err) { return !done_lines(err).empty(); });
      program.send(SIGKILL);
      program.finish();
    }
    const Outcome finished = asperity(run_of(small_.study(), true));
    // A program that was killed late may have ended the session.
    EXPECT_TRUE(finished.status == 0 || finished.status == 1) << finished.err;
    const auto tables = exported(small_.study(), small_.place() / "tables");
    for (const char* const column : {"question", "answer"}) {
      EXPECT_EQ(tsv(tables.at("responses.tsv")).column(column),
                tsv(expected.at("responses.tsv")).column(column));
    }
    for (const char* const column : {"block", "repetition", "track", "step"}) {
      EXPECT_EQ(tsv(tables.at("trials.tsv")).column(column),
                tsv(expected.at("trials.tsv")).column(column));
    }
    EXPECT_EQ(tsv(tables.at("presentations.tsv")).column("stimulus"),
              tsv(expected.at("presentations.tsv")).column("stimulus"))
        << "the levels";
    EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"),
              std::vector<std::string>{"completed"});
  }

  SmallStudy small_{1};
  fs::path file_{};
};

class ThreeTasks : public Tasks {
 protected:
  ThreeTasks() : Tasks(three_tasks()) {}
};

class PairsOfModels : public Tasks {
 protected:
  PairsOfModels() : Tasks(pairs_of_models()) {}
};

class RatedPairsOfModels : public Tasks {
 protected:
  RatedPairsOfModels() : Tasks(rated_pairs_of_models(1)) {}
};

class PartOfRatedPairs : public Tasks {
 protected:
  PartOfRatedPairs() : Tasks(rated_pairs_of_models(2)) {}
};

class Staircases : public Tasks {
 protected:
  Staircases() : Tasks(staircases()) {}
};

class SameDifferent : public Tasks {
 protected:
  SameDifferent() : Tasks(same_different()) {}
};

class ThreeAlternatives : public Tasks {
 protected:
  ThreeAlternatives() : Tasks(choice_of_three("three_alternatives")) {}
};

class OddityTask : public Tasks {
 protected:
  OddityTask() : Tasks(choice_of_three("oddity")) {}
};

class TracksOfOddity : public Tasks {
 protected:
  TracksOfOddity() : Tasks(tracks_of_oddity()) {}
};

TEST_F(ThreeTasks, AreSimulatedVerifiedAnalysedExportedAndReported) {
  ASSERT_EQ(asperity({"check", file_, "--study", small_.study()}).status, 0);
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "4", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  EXPECT_EQ(asperity({"verify", small_.study()}).status, 0);

  const std::string analysed = asperity({"analyze", small_.study()}).out;
  EXPECT_THAT(analysed, HasSubstr("three_tasks 1.0.0 (rating, improved)"));
  EXPECT_THAT(analysed, HasSubstr("three_tasks 1.0.0 (recognition, improved)"));
  EXPECT_THAT(analysed, HasSubstr("three_tasks 1.0.0 (selection, improved)"));

  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> kinds = tsv(tables.at("trials.tsv")).column("kind");
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), "rating"), 8);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), "recognition"), 16);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), "selection"), 16);
  // 2 × 5 ratings, 4 recognitions, and 4 selections with a confidence, of each participant.
  EXPECT_EQ(tsv(tables.at("responses.tsv")).rows.size(), 4U * (10U + 4U + 8U));
  const std::vector<std::string> groups = tsv(tables.at("participants.tsv")).column("group");
  EXPECT_EQ(std::count(groups.begin(), groups.end(), "haptic"), 2);

  const fs::path report = small_.place() / "report.html";
  EXPECT_EQ(asperity({"report", small_.study(), "--out", report}).status, 0);
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("Task of the rating: in each trial"));
  EXPECT_THAT(text, HasSubstr("Task of the absolute identification: in each trial"));
  for (const char* const kind : {"rating", "absolute identification", "best-of-n choice"}) {
    EXPECT_THAT(text, HasSubstr("Results (" + std::string(kind) + ")"));
    EXPECT_THAT(text, HasSubstr("Statistics (" + std::string(kind) + ")")) << "for a paper";
  }
}

TEST_F(ThreeTasks, ResumeAfterAKillAtEveryTrial) { expect_same_answers_after_kills(10); }

TEST_F(PairsOfModels, AreSimulatedVerifiedAnalysedExportedAndReported) {
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "4", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  EXPECT_EQ(asperity({"verify", small_.study()}).status, 0);
  const std::string analysed = asperity({"analyze", small_.study()}).out;
  EXPECT_THAT(analysed, HasSubstr("pairs_of_models 1.0.0 (paired_comparison, improved)"));
  EXPECT_THAT(analysed, HasSubstr("Which item of a pair is chosen more often?"));

  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> answers = tsv(tables.at("responses.tsv")).column("answer");
  EXPECT_EQ(answers.size(), 4U * 8U);
  for (const std::string& answer : answers) {
    EXPECT_THAT(answer, testing::AnyOf("height_map", "sinusoid", "tie"));
  }
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  EXPECT_EQ(std::count(items.begin(), items.end(), "sinusoid"), 4 * 8);

  const fs::path report = small_.place() / "report.html";
  EXPECT_EQ(asperity({"report", small_.study(), "--out", report}).status, 0);
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("all pairs of the levels of model in both orders"));
  EXPECT_THAT(text, HasSubstr("one of them, or a tie, is to be chosen"));
}

TEST_F(PairsOfModels, ResumeAfterAKillAtEveryTrial) { expect_same_answers_after_kills(8); }

TEST_F(RatedPairsOfModels, AreCheckedSimulatedVerifiedAnalysedExportedAndReported) {
  const Outcome checked = asperity({"check", file_, "--study", small_.study()});
  ASSERT_EQ(checked.status, 0) << checked.err;
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "4", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  const std::string analysed = asperity({"analyze", small_.study()}).out;
  EXPECT_THAT(analysed, HasSubstr("rated_pairs 1.0.0 (similarity, improved)"));
  EXPECT_THAT(analysed, HasSubstr("Do the ratings have a structure, and in how many dimensions?"));

  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> answers = tsv(tables.at("responses.tsv")).column("answer");
  ASSERT_EQ(answers.size(), 4U * 15U);
  for (const std::string& answer : answers) {
    EXPECT_GE(std::stod(answer), 0.0);
    EXPECT_LE(std::stod(answer), 100.0);
  }
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  EXPECT_EQ(std::count(items.begin(), items.end(), "sinusoid"), 4 * (4 + 2));

  const fs::path report = small_.place() / "report.html";
  EXPECT_EQ(asperity({"report", small_.study(), "--out", report}).status, 0);
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("two surfaces are presented, and their dissimilarity is rated on"));
  EXPECT_THAT(text, HasSubstr("all pairs of the levels of model and identical pairs"));
  EXPECT_THAT(text,
              HasSubstr("2 dimensions require at least 9 items, and the number of items is 5"));
  for (const char* const figure :
       {"Configuration of the items (non-metric MDS)", "Shepard diagram",
        "Stress by the number of dimensions", "Dendrogram of the rated dissimilarities",
        "Weights of the dimensions for each participant (INDSCAL)"}) {
    EXPECT_THAT(text, HasSubstr(figure));
  }
}

TEST_F(PartOfRatedPairs, IsResumedAfterAKillAtEveryTrial) { expect_same_answers_after_kills(11); }

TEST_F(Staircases, AreCheckedSimulatedVerifiedAnalysedExportedAndReported) {
  const Outcome checked = asperity({"check", file_, "--study", small_.study()});
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out,
              HasSubstr("block main: two-interval forced choice, one surface after the "
                        "other, 2-down/1-up staircase (70.7 %), 4 trials × 2 "
                        "interleaved tracks, about "));
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "3", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(asperity({"analyze", small_.study()}).out,
              HasSubstr("staircases 1.0.0 (discrimination, improved)"));
  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> steps = tsv(tables.at("trials.tsv")).column("step");
  EXPECT_EQ(std::count(steps.begin(), steps.end(), "4"), 3 * 2);
  const fs::path report = small_.place() / "report.html";
  EXPECT_EQ(asperity({"report", small_.study(), "--out", report}).status, 0);
  EXPECT_THAT(text_of(report), HasSubstr("2-down/1-up staircase"));
}

TEST_F(Staircases, ResumeAfterAKillAtEveryTrial) { expect_same_answers_after_kills(8); }

TEST_F(SameDifferent, IsCheckedSimulatedVerifiedAnalysedExportedAndReported) {
  const Outcome checked = asperity({"check", file_, "--study", small_.study()});
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out,
              HasSubstr("block main: same–different task, one surface after the other, constant "
                        "stimuli, 2 levels × 4 presentations, half of them without a difference"));
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "3", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(asperity({"analyze", small_.study()}).out,
              HasSubstr("How large is the sensitivity (d′) at each level?"));
  const auto tables = exported(small_.study(), small_.place() / "tables");
  for (const std::string& answer : tsv(tables.at("responses.tsv")).column("answer")) {
    EXPECT_THAT(answer, testing::AnyOf("same", "different"));
  }
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  EXPECT_EQ(std::count(items.begin(), items.end(), "standard_2"), 3 * 2);
  const fs::path report = small_.place() / "report.html";
  EXPECT_EQ(asperity({"report", small_.study(), "--out", report}).status, 0);
  EXPECT_THAT(text_of(report), HasSubstr("same–different task. In each trial, two surfaces are "
                                         "presented one after the other"));
}

TEST_F(SameDifferent, ResumesAfterAKillAtEveryTrial) { expect_same_answers_after_kills(8); }

TEST_F(ThreeAlternatives, IsCheckedSimulatedVerifiedAnalysedAndExported) {
  const Outcome checked = asperity({"check", file_, "--study", small_.study()});
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out,
              HasSubstr("block main: three-alternative forced choice, one surface after the "
                        "other, constant stimuli, 3 levels × 1 presentation"));
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "3", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(asperity({"analyze", small_.study()}).out, HasSubstr("Choices by position"));
  const auto tables = exported(small_.study(), small_.place() / "tables");
  for (const std::string& answer : tsv(tables.at("responses.tsv")).column("answer")) {
    EXPECT_THAT(answer, testing::AnyOf("comparison", "standard", "standard_2"));
  }
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  for (const char* const item : {"comparison", "standard", "standard_2"}) {
    EXPECT_EQ(std::count(items.begin(), items.end(), item), 3 * 3) << item;
  }
}

TEST_F(ThreeAlternatives, ResumesAfterAKillAtEveryTrial) { expect_same_answers_after_kills(3); }

TEST_F(OddityTask, IsSimulatedVerifiedAnalysedAndExported) {
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "3", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(asperity({"analyze", small_.study()}).out,
              HasSubstr("Sensitivity by level, from the proportion correct"));
  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  for (const char* const item : {"standard_2", "comparison_2"}) {
    EXPECT_EQ(std::count(items.begin(), items.end(), item), 3 * 3) << item;
  }
}

TEST_F(OddityTask, ResumesAfterAKillAtEveryTrial) { expect_same_answers_after_kills(6); }

TEST_F(TracksOfOddity, AreSimulatedVerifiedAndAnalysed) {
  const Outcome simulated = asperity(
      {"simulate", file_, "--study", small_.study(), "--participants", "2", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Outcome verified = asperity({"verify", small_.study(), "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_EQ(asperity({"analyze", small_.study()}).status, 0);
  const auto tables = exported(small_.study(), small_.place() / "tables");
  const std::vector<std::string> items = tsv(tables.at("presentations.tsv")).column("item");
  EXPECT_EQ(std::count(items.begin(), items.end(), "standard_2"), 2 * 4);
  EXPECT_EQ(std::count(items.begin(), items.end(), "comparison_2"), 2 * 4);
}

TEST_F(TracksOfOddity, ResumeAfterAKillAtEveryTrial) { expect_same_answers_after_kills(8); }

}  // namespace
}  // namespace asperity::test
