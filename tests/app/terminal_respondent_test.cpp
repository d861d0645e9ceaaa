// A person at a terminal: after a fault, and before pictures.

#include "app/session/respondents/terminal_respondent.h"

#include <array>
#include <csignal>
#include <optional>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>

#include "app/study_files/height_field_files.h"
#include "tests/support/replies.h"
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
  person_.hear_of_fault("A fault occurred between trials.");
  EXPECT_THAT(said_.str(), HasSubstr("A fault occurred between trials.\n"));
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

Trial trial_of_two(Question question) {
  Trial trial{.presentations = {{.position = 1, .code = "A"}, {.position = 2, .code = "B"}}};
  trial.questions = {std::move(question)};
  return trial;
}

// The values of the options are hidden, and can be numbers in another order.
TEST_F(AtTerminal, ChoosesAnOptionByTheNumberThatIsShown) {
  const Trial trial =
      trial_of_two({.name = "best",
                    .prompt = "Which was rougher?",
                    .options = {{.value = "2", .label = "A"}, {.value = "1", .label = "B"}}});
  type("1\n");
  const Reply reply = person_.ask(trial, trial.questions, {}, {}, [](double) {});
  ASSERT_NE(reply.answer(), nullptr);
  EXPECT_EQ(std::get<ChosenOption>(*reply.answer()).option, 0U);
}

TEST_F(AtTerminal, TakesATextThatBeginsWithTheWordForFeeling) {
  const Trial trial = trial_of_two({.name = "words", .prompt = "Describe it.", .form = TextForm{}});
  type("feels like sand\n");
  const Reply reply = person_.ask(trial, trial.questions, {}, {}, [](double) {});
  ASSERT_NE(reply.answer(), nullptr);
  EXPECT_EQ(std::get<WrittenText>(*reply.answer()).text, "feels like sand");
  type("feel B\n");
  const Reply wish = person_.ask(trial, trial.questions, {}, {}, [](double) {});
  ASSERT_NE(wish.feel_again(), nullptr);
  EXPECT_EQ(wish.feel_again()->position, 2);
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
  trial.questions.resize(1);
  trial.questions.front().options = {{.label = "1", .picture = "red.png"},
                                     {.label = "2", .picture = "blue.png"}};
  const auto type_when_asked = [&](double) { EXPECT_EQ(write(ends[1], "2\n", 2), 2); };
  EXPECT_EQ(options_of(person.ask(trial, trial.questions, {}, {}, type_when_asked)),
            std::vector<std::size_t>{1});
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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGSEGV, SIGPIPE, SIGALRM, SIGXCPU,
                           SIGXFSZ, SIGSYS, SIGUSR1}) {
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

TEST(TerminalInContact, EchoesAgainAfterAnErrorThatIsHandledElsewhere) {
  const PseudoTerminal terminal{};
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGSEGV, [](int) { _exit(7); });
    const UnechoedInput unechoed(terminal.program);
    if (!terminal.echoes()) raise(SIGSEGV);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 7) << "the other handler";
  EXPECT_TRUE(terminal.echoes());
}

/// The exit status of a child, or nothing where it did not end in half a minute.
std::optional<int> status_of(pid_t child) {
  constexpr int kLooks = 1500;
  for (int i = 0; i < kLooks; ++i) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == child) return status;
    usleep(20'000);
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return {};
}

// A terminal whose output is stopped (Ctrl-S), while another thread writes to it.
TEST(TerminalInContact, DoesNotKeepAProgramThatASignalEndsWhileItsOutputIsStopped) {
  const PseudoTerminal terminal{};
  const pid_t child = fork();
  if (child == 0) {
    const UnechoedInput unechoed(terminal.program);
    std::thread([&terminal] {
      const std::string more(1'000'000, '.');
      while (write(terminal.program, more.data(), more.size()) >= 0) {
      }
    }).detach();
    pollfd full{terminal.program, POLLOUT, 0};
    while (::poll(&full, 1, 0) > 0) {
    }
    raise(SIGTERM);
    _exit(0);
  }
  const std::optional<int> status = status_of(child);
  ASSERT_TRUE(status) << "the program waits for the terminal";
  EXPECT_TRUE(WIFSIGNALED(*status) && WTERMSIG(*status) == SIGTERM);
  EXPECT_TRUE(terminal.echoes());
}

/// A screen on which the participant types a line as soon as something is shown.
class TypedWhenShown final : public std::stringbuf {
 public:
  TypedWhenShown(const PseudoTerminal& terminal, std::string line)
      : terminal_(terminal), line_(std::move(line)) {}
  int sync() override {
    if (!line_.empty()) terminal_.type(std::exchange(line_, {}));
    return 0;
  }

 private:
  const PseudoTerminal& terminal_;
  std::string line_{};
};

TEST(TerminalInContact, TakesTheAnswerThatIsTypedWhileThePicturesAreRead) {
  const TemporaryFolder folder;
  const GreyImage grey{2, 2, std::vector<float>(4, 0.5F)};
  save_color_picture(folder.path() / "a.png", {grey, grey, grey}, Overwrite::refuse);
  const PseudoTerminal terminal{};
  std::ostringstream before{};
  TypedWhenShown screen(terminal, "2\n");
  std::ostream shown(&screen);
  TerminalRespondent person(terminal.program, shown, folder.path(), folder.path() / "sheet.png");
  shown.rdbuf(before.rdbuf());
  person.announce({}, {});
  shown.rdbuf(&screen);
  Trial trial{};
  trial.questions.resize(1);
  trial.questions.front().options = {{.label = "1", .picture = "a.png"},
                                     {.label = "2", .picture = "a.png"}};
  const auto type_again = [&](double) {
    ADD_FAILURE() << "the answer was discarded";
    terminal.type("1\n");
  };
  EXPECT_EQ(options_of(person.ask(trial, trial.questions, {}, {}, type_again)),
            std::vector<std::size_t>{1});
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
