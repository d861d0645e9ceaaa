// run with a person at a terminal.

#include <csignal>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

Invocation run_at_terminal(const SmallStudy& small, const fs::path& protocol) {
  return {.arguments = {"run", protocol, "--study", small.study(), "--participant", "anna",
                        "--mode", "pilot", "--seed", "4"},
          .on_terminal = true};
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

/// A person who agrees, reads and answers everything with `choice`, until `done` trials are stored.
void answer_everything(Program& program, const std::string& choice, std::size_t done) {
  std::size_t answered = 0;
  const auto prompts = [](const std::string& out) {
    return count_of(out, "Your answer: ") + count_of(out, "Press Return to continue. ");
  };
  while (program.read_until([&](const std::string& out, const std::string& err) {
    return prompts(out) > answered || done_lines(err).size() >= done;
  })) {
    if (done_lines(program.err()).size() >= done) return;
    ++answered;
    const bool is_question = program.out().rfind("Your answer: ") != std::string::npos &&
                             program.out().ends_with("Your answer: ");
    program.type(is_question ? choice + "\n" : "\n");
  }
}

/// A session of two trials in which everything is answered with the first option.
struct WatchedSession {
  explicit WatchedSession(fs::path (SmallStudy::*protocol)() const) {
    Program program(run_at_terminal(small, (small.*protocol)()));
    answer_everything(program, "1", 1000);
    outcome = program.finish();
    EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  }
  SmallStudy small{1};
  Outcome outcome{};
};

const WatchedSession& watched_selection() {
  static const WatchedSession session(&SmallStudy::selection);
  return session;
}

const WatchedSession& watched_recognition() {
  static const WatchedSession session(&SmallStudy::recognition);
  return session;
}

// The terminal is the participant's screen and the experimenter's at the same time.
TEST(Terminal, ShowsNotWhetherAResponseIsCorrectWhereTheProtocolHasNoFeedback) {
  const Outcome& outcome = watched_recognition().outcome;
  EXPECT_EQ((outcome.out + outcome.err).find("correct"), std::string::npos) << outcome.out;
}

TEST(Terminal, TakesAPersonThroughASession) {
  const auto& [small, outcome] = watched_selection();
  EXPECT_EQ(done_lines(outcome.err),
            (std::vector<std::string>{"done anna 1 1 1", "done anna 1 2 1"}));

  const auto tables = exported(small.study(), small.place() / "tables");
  const Tsv sessions = tsv(tables.at("sessions.tsv"));
  EXPECT_EQ(sessions.column("state"), std::vector<std::string>{"completed"});
  EXPECT_EQ(sessions.column("pacing"), std::vector<std::string>{"real_time"});
  EXPECT_EQ(sessions.column("mode"), std::vector<std::string>{"pilot"});
  EXPECT_EQ(sessions.column("virtual"), std::vector<std::string>{"0"});
  EXPECT_EQ(sessions.column("consent_version"), std::vector<std::string>{"1.0"});
  // The first option is surface A, the first one felt.
  const Tsv presentations = tsv(tables.at("presentations.tsv"));
  const Tsv responses = tsv(tables.at("responses.tsv"));
  ASSERT_EQ(responses.rows.size(), 2U);
  EXPECT_EQ(responses.column("answer")[0], presentations.column("item")[0]);
  EXPECT_EQ(responses.column("answer")[1], presentations.column("item")[2]);
  EXPECT_EQ(asperity({"verify", small.study()}).status, 0);
}

TEST(Terminal, ShowsAParticipantNothingOfWhatIsForTheExperimenter) {
  const SmallStudy small(1);
  Invocation invocation = run_at_terminal(small, small.recognition());
  invocation.in_child = [] { ::dup2(STDOUT_FILENO, STDERR_FILENO); };
  Program program(invocation);
  answer_everything(program, "1", 1000);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("session complete"), std::string::npos);
  for (const char* const line : {"done anna", "acknowledged"}) {
    EXPECT_EQ(outcome.out.find(line), std::string::npos) << outcome.out;
  }
}

// A virtual hand holds the simulated device: no answer given meanwhile is study data.
TEST(Terminal, RefusesStudyDataOnTheSimulatedDevice) {
  const SmallStudy small(1);
  const Outcome outcome = run(
      {.arguments = {"run", small.selection(), "--study", small.study(), "--participant", "anna"},
       .on_terminal = true});
  EXPECT_EQ(outcome.status, 1) << outcome.err << outcome.out;
  for (const char* words :
       {"a virtual hand holds the device", "--mode pilot", "device.input_only"}) {
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
  const auto tables = exported(small.study(), small.place() / "tables");
  EXPECT_TRUE(tsv(tables.at("sessions.tsv")).rows.empty());
}

TEST(Terminal, KeepsNothingUnderTheLabelOfAParticipantWhoDeclined) {
  const SmallStudy small(1);
  nlohmann::ordered_json protocol = small_selection(1);
  protocol["environment"]["masking_noise"] = {{"kind", "pink"}, {"level_dBA", 65}};
  write_text(small.selection(), protocol.dump(2));
  Program program(run_at_terminal(small, small.selection()));
  ASSERT_TRUE(program.read_until(
      [](const std::string& out, const std::string&) { return out.ends_with("Your answer: "); }));
  EXPECT_NE(program.err().find("which is not played at a terminal"), std::string::npos)
      << "stated beforehand: " << program.err();
  program.type("2\n");
  EXPECT_EQ(program.finish().status, 1);
  for (const auto& [name, content] : contents_of(small.study())) {
    EXPECT_EQ(name.find("anna"), std::string::npos) << name;
    EXPECT_EQ(content.find("anna"), std::string::npos) << name;
  }
}

TEST(Terminal, NeverShowsANameOfATextureOrModel) {
  for (const WatchedSession* const session : {&watched_selection(), &watched_recognition()}) {
    const std::string shown = session->outcome.out + session->outcome.err;
    EXPECT_NE(shown.find("Feel surface A now."), std::string::npos);
    for (const char* name : {"walnut", "slate", "height_map", "sinusoid", "rendered", "T1", "T2"}) {
      EXPECT_EQ(shown.find(name), std::string::npos) << name << " in:\n" << shown;
    }
  }
}

TEST(Terminal, StatesWhyATrialIsRepeatedAndThatItsFirstAttemptDoesNotCount) {
  const SmallStudy small(1);
  nlohmann::ordered_json strict = small_recognition(1);
  nlohmann::ordered_json& exploration = strict["explorations"]["short"];
  exploration["strokes"] = {{"minimum", 100}};
  exploration["on_failure"] = "repeat_now";
  exploration["maximum_repeats"] = 1;
  write_text(small.recognition(), strict.dump(2));
  Program program(run_at_terminal(small, small.recognition()));
  answer_everything(program, "1", 1);
  EXPECT_NE(program.err().find("stored anna 1 1 1 not_compliant\n"), std::string::npos)
      << program.err();
  EXPECT_NE(
      program.err().find("Trial 1 is repeated: not explored as instructed: strokes of surface 1"),
      std::string::npos)
      << program.err();
  EXPECT_EQ(done_lines(program.err()).front(), "done anna 1 1 2");
}

TEST(Terminal, AsksAgainForWhatIsNoOption) {
  const SmallStudy small(1);
  Program program(run_at_terminal(small, small.selection()));
  const auto shows = [&program](const std::string& text) {
    return program.read_until([&text](const std::string& out, const std::string&) {
      return out.find(text) != std::string::npos;
    });
  };
  ASSERT_TRUE(shows("Your answer: ")) << program.out();  // consent
  program.type("1\n");
  ASSERT_TRUE(shows("Press Return")) << program.out();
  program.type("\n");
  ASSERT_TRUE(shows("Which was most like the picture?"));
  program.type("7\n");
  EXPECT_TRUE(shows("Please enter a number from 1 to 2."));
  program.type("2\n");
  EXPECT_TRUE(program.read_until(
      [](const std::string&, const std::string& err) { return !done_lines(err).empty(); }));
}

// What a terminal does not show matters to who has a device.
TEST(Terminal, SaysThatThereIsNoDeviceBeforeItSpeaksOfGuidance) {
  const SmallStudy small(1);
  nlohmann::ordered_json guided = small_recognition(1);
  guided["explorations"]["short"]["guidance"] = "bars";
  guided["explorations"]["short"]["normal_force_N"] = {{"minimum", 0.2}, {"maximum", 3}};
  write_text(small.recognition(), guided.dump(2));
  Invocation invocation = run_at_terminal(small, small.recognition());
  {
    Program program(invocation);
    EXPECT_TRUE(program.read_until_told("a terminal cannot present them")) << program.err();
  }
  invocation.arguments.insert(invocation.arguments.end(), {"--device", "falcon:9"});
  Program program(invocation);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.find("a terminal cannot present them"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("Falcon"), std::string::npos) << outcome.err;
}

TEST(Terminal, StopsAfterTheTrialAndContinuesLater) {
  const SmallStudy small(2);  // four trials
  Invocation invocation = run_at_terminal(small, small.recognition());
  {
    Program program(invocation);
    answer_everything(program, "1", 1);
    program.type("\x03");  // Ctrl-C
    // The trial under way is finished first.
    answer_everything(program, "1", 2);
    const Outcome stopped = program.finish();
    EXPECT_EQ(stopped.status, 1) << stopped.err;
    EXPECT_EQ(done_lines(stopped.err).size(), 2U) << stopped.err;
    EXPECT_NE(stopped.err.find("on request, after the trial"), std::string::npos);
    EXPECT_NE(stopped.err.find("--resume"), std::string::npos) << stopped.err;
  }
  invocation.arguments.emplace_back("--resume");
  Program program(invocation);
  answer_everything(program, "1", 1000);
  const Outcome resumed = program.finish();
  EXPECT_EQ(resumed.status, 0) << resumed.err << resumed.out;
  EXPECT_EQ(done_lines(resumed.err),
            (std::vector<std::string>{"done anna 1 3 1", "done anna 1 4 1"}));
}

TEST(Terminal, ThatIsClosedLeavesASessionToGoOnWith) {
  const SmallStudy small(1);
  Invocation invocation = run_at_terminal(small, small.recognition());
  {
    Program program(invocation);
    answer_everything(program, "1", 1);
    // At the next question: what is typed before it is thrown away.
    const std::size_t said = program.out().size();
    program.read_until([said](const std::string& out, const std::string&) {
      return out.size() > said && out.ends_with("Your answer: ");
    });
    program.type("\x04");  // end of input
    const Outcome stopped = program.finish();
    EXPECT_EQ(stopped.status, 1);
    EXPECT_NE(stopped.err.find("--resume"), std::string::npos) << stopped.err;
  }
  const auto tables = exported(small.study(), small.place() / "tables");
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"stopped"});
  EXPECT_EQ(tsv(tables.at("attempts.tsv")).column("valid").front(), "1");
  invocation.arguments.emplace_back("--resume");
  Program program(invocation);
  answer_everything(program, "1", 1000);
  EXPECT_EQ(program.finish().status, 0);
}

TEST(Terminal, IsNeededWithoutAVirtualParticipant) {
  const SmallStudy small(1);
  const auto before = contents_of(small.place());
  const Outcome outcome = asperity(run_at_terminal(small, small.recognition()).arguments);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--virtual"), std::string::npos) << outcome.err;
  EXPECT_TRUE(contents_of(small.place()) == before);
}

}  // namespace
}  // namespace asperity::test
