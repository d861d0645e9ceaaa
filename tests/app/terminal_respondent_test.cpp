// A person at a terminal, after a fault.

#include "app/conductor/terminal_respondent.h"

#include <array>
#include <sstream>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  EXPECT_THAT(said_.str(), HasSubstr("press Return to go on"));
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

}  // namespace
}  // namespace asperity
