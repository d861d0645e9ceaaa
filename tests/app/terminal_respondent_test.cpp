// A person at a terminal: after a fault, and before pictures.

#include "app/conductor/terminal_respondent.h"

#include <array>
#include <csignal>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>

#include "app/height_field_files.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using AfterFault = Respondent::AfterFault;

class AtTerminal : public testing::Test {
 protected:
  ~AtTerminal() override {
    close(ends_[0]);
    hang_up();
  }
  void type(const std::string& text) {
    EXPECT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void hang_up() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

  static std::array<int, 2> opened_pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    return ends;
  }

  std::array<int, 2> ends_ = opened_pipe();
  std::ostringstream said_{};
  TerminalRespondent person_{ends_[0], said_, {}, {}};
};

TEST_F(AtTerminal, IsToldOfAFaultAndWhatToDo) {
  person_.hear_of_fault("The device failed between trials.");
  EXPECT_THAT(said_.str(), HasSubstr("The device failed between trials.\n"));
  EXPECT_THAT(said_.str(), HasSubstr("press Return to continue"));
  EXPECT_EQ(person_.after_fault(), AfterFault::nothing);
}

TEST_F(AtTerminal, SaysByReturnThatItIsMended) {
  person_.hear_of_fault("It failed.");
  type("\n");
  EXPECT_EQ(person_.after_fault(), AfterFault::go_on);
  EXPECT_EQ(person_.after_fault(), AfterFault::nothing);
}

TEST_F(AtTerminal, EndsTheSessionInAWordAndIsAskedAgainForAnyOther) {
  person_.hear_of_fault("It failed.");
  type("what?\n");
  EXPECT_EQ(person_.after_fault(), AfterFault::nothing);
  type("en");
  EXPECT_EQ(person_.after_fault(), AfterFault::nothing);
  type("d\n");
  EXPECT_EQ(person_.after_fault(), AfterFault::end);
  EXPECT_NE(said_.str().find("press Return"), said_.str().rfind("press Return"));
}

TEST_F(AtTerminal, IsGoneWhenItsTerminalIsClosedInAFault) {
  person_.hear_of_fault("It failed.");
  hang_up();
  EXPECT_THROW(person_.after_fault(), RespondentGone);
}

TEST_F(AtTerminal, TakesNoReturnOfABreakForTheNextConfirmation) {
  int waits = 0;
  const Wait wait = [&](double duration_s) {
    if (duration_s == 30.0) type("\n\n");  // typed while the break lasts
    if (duration_s < 1.0 && ++waits == 3) type("\n");
  };
  person_.read("Please rest.", 30.0, wait);
  EXPECT_EQ(waits, 3) << "it waits for a Return after the break";
}

/// A red and a blue picture, as the sheet shows them.
ColorPlanes sheet_of_a_question(bool in_grey) {
  const TemporaryFolder folder;
  const GreyImage dark{2, 2, std::vector<float>(4, 0.0F)};
  const GreyImage bright{2, 2, std::vector<float>(4, 1.0F)};
  save_color_picture(folder.path() / "red.png", {bright, dark, dark}, Overwrite::refuse);
  save_color_picture(folder.path() / "blue.png", {dark, dark, bright}, Overwrite::refuse);
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  std::ostringstream shown{};
  TerminalRespondent person(ends[0], shown, folder.path(), folder.path() / "sheet.png");
  if (in_grey) person.show_in_grey();
  Trial trial{};
  trial.question.options = {{.label = "1", .picture = "red.png"},
                            {.label = "2", .picture = "blue.png"}};
  const auto type_when_asked = [&](double) { EXPECT_EQ(write(ends[1], "2\n", 2), 2); };
  EXPECT_EQ(person.ask(trial, {}, {}, type_when_asked).options, std::vector<std::size_t>{1});
  close(ends[0]);
  close(ends[1]);
  return load_color_picture(folder.path() / "sheet.png");
}

/// A terminal of which a test is the person: it types on one side, and the program reads the other.
struct PseudoTerminal {
  PseudoTerminal() { EXPECT_EQ(::openpty(&person, &program, nullptr, nullptr, nullptr), 0); }
  ~PseudoTerminal() {
    close(person);
    close(program);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  bool echoes() const {
    termios now{};
    EXPECT_EQ(::tcgetattr(program, &now), 0);
    return (now.c_lflag & ECHO) != 0;
  }
  /// A line, and waits until the program could read it.
  void type(const std::string& text) const {
    EXPECT_EQ(write(person, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    pollfd typed{program, POLLIN, 0};
    EXPECT_EQ(::poll(&typed, 1, 10'000), 1);
  }

  int person = -1;
  int program = -1;
};

TEST(TerminalInContact, ShowsNothingOfWhatIsTypedAndDiscardsIt) {
  const PseudoTerminal terminal{};
  std::ostringstream said{};
  {
    TerminalRespondent person(terminal.program, said, {}, {});
    EXPECT_TRUE(terminal.echoes());
    person.announce({}, {});
    EXPECT_FALSE(terminal.echoes());
    terminal.type("typed in contact\n");
    bool is_open = false;
    person.read("Thank you.", 0.0, [&](double) {
      if (std::exchange(is_open, true)) return;
      EXPECT_TRUE(terminal.echoes());
      terminal.type("\n");
    });
    EXPECT_TRUE(is_open) << "what was typed in contact was taken for a confirmation";
    person.announce({}, {});
  }
  EXPECT_TRUE(terminal.echoes());
}

TEST(TerminalInContact, EchoesAgainAfterAnySignalThatEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGSEGV}) {
    const PseudoTerminal terminal{};
    const pid_t child = fork();
    if (child == 0) {
      const UnechoedInput unechoed(terminal.program);
      if (!terminal.echoes()) raise(signal);
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_TRUE(terminal.echoes()) << signal;
  }
}

TEST(PictureSheet, HasTheColoursOfThePictures) {
  const ColorPlanes sheet = sheet_of_a_question(false);
  const std::size_t left = 200 * sheet[0].columns + 200;
  const std::size_t right = 201 * sheet[0].columns - 200;
  EXPECT_NEAR(sheet[0].values.at(left), 1.0, 1e-6);
  EXPECT_NEAR(sheet[2].values.at(left), 0.0, 1e-6);
  EXPECT_NEAR(sheet[0].values.at(right), 0.0, 1e-6);
  EXPECT_NEAR(sheet[2].values.at(right), 1.0, 1e-6);
}

TEST(PictureSheet, IsGreyWhereTheProtocolShowsPicturesSo) {
  const ColorPlanes sheet = sheet_of_a_question(true);
  EXPECT_EQ(sheet[0].values, sheet[1].values);
  EXPECT_EQ(sheet[1].values, sheet[2].values);
  EXPECT_NEAR(sheet[0].values.at(200 * sheet[0].columns + 200), 0.299, 0.003);
}

}  // namespace
}  // namespace asperity
