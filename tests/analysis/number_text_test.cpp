// Holds the text of a number to reading back, and the text of a count to the noun that it needs.

#include "analysis/numbers/number_text.h"

#include <charconv>
#include <limits>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(500.0), "500");
  EXPECT_EQ(number_text(-1.5), "-1.5");
  for (const double number :
       {1.0 / 3.0, -std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
        std::numeric_limits<double>::denorm_min()}) {
    const std::string text = number_text(number);
    double read = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    EXPECT_EQ(read, number);
  }
}

TEST(Fixed, HasNoSignWhereNothingIsLeft) {
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0, 1), "0.0");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(-10.0, 0), "-10");
}

TEST(Counted, ChoosesTheNoun) {
  EXPECT_EQ(counted(0, "vertex", "vertices"), "0 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
  EXPECT_EQ(counted(21, "trial", "trials"), "21 trials");
}

TEST(NumberText, NamesWhatIsNoNumber) {
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

}  // namespace
}  // namespace asperity
