// run with a participant's label that is already in the study, or differs from one only in letter case or
// leading zeros.

#include <csignal>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome virtual_run(const SmallStudy& small, const std::string& label,
                    const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments{"run",         small.selection(), "--study",
                                     small.study(), "--participant",   label,
                                     "--virtual",   "--seed",          "9"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return asperity(arguments);
}

std::vector<std::string> participants_with_sessions(const SmallStudy& small) {
  const fs::path tables = small.place() / "tables";
  fs::remove_all(tables);
  return tsv(exported(small.study(), tables).at("sessions.tsv")).column("participant");
}

TEST(Label, WithASessionAlreadyIsStatedToAScriptWhichContinues) {
  const SmallStudy small(1);
  const Outcome first = virtual_run(small, "standin1");
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.err, Not(HasSubstr("warning")));
  const Outcome second = virtual_run(small, "standin1");
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_THAT(second.err,
              HasSubstr("asperity: warning: standin1 has completed session 1 of this protocol "
                        "(simulated data, version 1.0.0, on a simulated clock); a further session "
                        "begins; for another participant, use another --participant\n"));
}

TEST(Label, ThatDiffersInLetterCaseOrLeadingZerosIsRefusedToAScript) {
  const SmallStudy small(1);
  ASSERT_EQ(virtual_run(small, "standin1").status, 0);
  for (const char* label : {"StandIn1", "standin01"}) {
    const Outcome other = virtual_run(small, label);
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(
        other.err,
        HasSubstr("asperity: " + std::string(label) +
                  " is a new participant; standin1, whose label differs only in letter case or "
                  "leading zeros, is in the study already (virtual participant); for standin1, use "
                  "--participant standin1. For another participant, use another label, or "
                  "--allow-similar-label. Nothing was stored\n"));
  }
  EXPECT_EQ(participants_with_sessions(small), std::vector<std::string>{"standin1"});
}

TEST(Label, ThatIsSimilarIsAcceptedOnRequest) {
  const SmallStudy small(1);
  ASSERT_EQ(virtual_run(small, "standin1").status, 0);
  const Outcome other = virtual_run(small, "StandIn1", {"--allow-similar-label"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_THAT(other.err,
              HasSubstr("asperity: warning: StandIn1 is a new participant; standin1, whose label "
                        "differs only in letter case or leading zeros, is in the study already "));
  // Both are there now, so that neither is a slip.
  const Outcome again = virtual_run(small, "standin1");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, Not(HasSubstr("letter case")));
}

/// A person at a terminal, up to the first prompt.
class PilotRun final {
 public:
  PilotRun(const SmallStudy& small, const std::string& label)
      : program_({.arguments = {"run", small.selection(), "--study", small.study(), "--participant",
                                label, "--mode", "pilot", "--seed", "4"},
                  .on_terminal = true}) {
    EXPECT_TRUE(shows_prompt()) << program_.err();
  }
  Program& program() { return program_; }
  bool shows_prompt() {
    const bool is_shown = program_.read_until([this](const std::string& out, const std::string&) {
      return out.size() > seen_ &&
             (out.ends_with("Press Return to continue. ") || out.ends_with("Your answer: "));
    });
    seen_ = program_.out().size();
    return is_shown;
  }
  void complete() {
    do {
      program_.type(program_.out().ends_with("Your answer: ") ? "1\n" : "\n");
    } while (shows_prompt());
  }

 private:
  Program program_;
  std::size_t seen_ = 0;
};

TEST(Label, WithASessionAlreadyIsConfirmedAtATerminal) {
  const SmallStudy small(1);
  {
    PilotRun first(small, "anna");
    EXPECT_THAT(first.program().err(), Not(HasSubstr("asperity: warning: anna")));
    first.complete();
    ASSERT_EQ(first.program().finish().status, 0);
  }
  {
    PilotRun second(small, "anna");
    EXPECT_THAT(second.program().err(),
                HasSubstr("asperity: warning: anna has completed session 1 of this protocol (pilot "
                          "data, version 1.0.0, less than an hour ago); a further session begins; "
                          "for another participant, use another --participant\n"));
    EXPECT_THAT(second.program().out(),
                HasSubstr("Ctrl-C ends the program; nothing has been stored."));
    second.program().type("\x03");
    EXPECT_EQ(second.program().finish().status, 1);
  }
  EXPECT_EQ(participants_with_sessions(small), std::vector<std::string>{"anna"});
  {
    PilotRun other(small, "Anna");
    EXPECT_THAT(other.program().err(),
                HasSubstr("Anna is a new participant; anna, whose label differs only in letter "
                          "case or leading zeros, is in the study already (added less than an hour "
                          "ago); for anna, use --participant anna\n"));
    other.complete();
    EXPECT_EQ(other.program().finish().status, 0);
  }
  EXPECT_EQ(participants_with_sessions(small), (std::vector<std::string>{"Anna", "anna"}));
}

TEST(Label, WithAnUnfinishedSessionIsStated) {
  const SmallStudy small(40);
  {
    Invocation invocation{};
    invocation.arguments = {"run",         small.selection(), "--study",
                            small.study(), "--participant",   "standin1",
                            "--virtual",   "--seed",          "9"};
    Program program(invocation);
    program.read_until(
        [](const std::string&, const std::string& err) { return !done_lines(err).empty(); });
    program.send(SIGINT);
    ASSERT_EQ(program.finish().status, 1);
  }
  Program again({.arguments = {"run", small.selection(), "--study", small.study(), "--participant",
                               "standin1", "--virtual"}});
  EXPECT_TRUE(
      again.read_until_told("asperity: warning: session 1 of standin1 with this protocol is "
                            "unfinished (simulated data, version 1.0.0, on a simulated clock); a "
                            "further session begins; to resume it, use --resume\n"))
      << again.err();
}

}  // namespace
}  // namespace asperity::test
