// Three tasks in one session, two groups of participants, and five scales in a trial; pairs of the levels of a factor;
// rated pairs; interleaved staircases; the psi procedure; magnitude estimates: from check to report, and through kills.

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/journeys/small_tasks.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

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

class PsiTrack : public Tasks {
 protected:
  PsiTrack() : Tasks(psi_track()) {}
};

class MagnitudeEstimates : public Tasks {
 protected:
  MagnitudeEstimates() : Tasks(magnitude_estimates()) {}
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

TEST_F(PsiTrack, ResumesAfterAKillAtEveryTrial) { expect_same_answers_after_kills(8); }

TEST_F(MagnitudeEstimates, ResumeAfterAKillAtEveryTrial) { expect_same_answers_after_kills(6); }

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
