// Holds numbers, counts and units of names to their texts: what reads back, which noun, which ending.

#include "analysis/numbers/number_text.h"

#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "analysis/numbers/unit_of_name.h"

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

TEST(UnitOfName, IsThatOfTheLongestEnding) {
  EXPECT_EQ(named_quantity("stiffness_N_per_m").quantity, "stiffness");
  EXPECT_EQ(named_quantity("stiffness_N_per_m").unit, "N/m");
  EXPECT_EQ(named_quantity("torque_N_m").unit, "N m") << "not a length";
  EXPECT_EQ(named_quantity("tool_inertia_kg_m2").unit, "kg m²");
  EXPECT_EQ(unit_in_files("tool_inertia_kg_m2"), "kg m2");
  EXPECT_EQ(named_quantity("strokes").quantity, "strokes");
  EXPECT_EQ(named_quantity("_m").unit, "") << "there is no quantity";
  EXPECT_EQ(unit_in_files("strokes"), "1");
}

TEST(ShiftedDecimal, ConvertsBetweenUnits) {
  EXPECT_EQ(shifted_decimal("2.3", -3), "0.0023");  // mm in m
  EXPECT_EQ(shifted_decimal("0.0023", 3), "2.3");   // m in mm
  EXPECT_EQ(shifted_decimal("5e-05", 6), "50");     // m in µm
  EXPECT_EQ(shifted_decimal("50", -6), "0.00005");  // µm in m
  EXPECT_EQ(shifted_decimal("1.1", -1), "0.11");    // 1.1 · 0.1 is 0.11000000000000001
  EXPECT_EQ(shifted_decimal("1.1", 3), "1100");     // 1.1 · 1000 is 1100.0000000000002
  EXPECT_EQ(shifted_decimal("-0.25", 2), "-25");    // 1 in %
  EXPECT_EQ(shifted_decimal("12.50", 0), "12.50");
  EXPECT_EQ(shifted_decimal("12.50", 1), "125");
  EXPECT_EQ(shifted_decimal("1200", -1), "120");
}

TEST(ShiftedDecimal, KeepsEveryDigit) {
  EXPECT_EQ(shifted_decimal("0.12345678901234567", 3), "123.45678901234567");
  EXPECT_EQ(shifted_decimal("0.10000000000000001", 0), "0.10000000000000001");
  EXPECT_EQ(shifted_decimal("-12345678901234567890123.4567", -3), "-12345678901234567890.1234567");
  EXPECT_EQ(shifted_decimal("9.007199254740993E+15", -3), "9007199254740.993");
}

TEST(ShiftedDecimal, WritesAnExponentOnlyFarFromThePoint) {
  EXPECT_EQ(shifted_decimal("1", -6), "0.000001");
  EXPECT_EQ(shifted_decimal("1", -7), "1e-7");
  EXPECT_EQ(shifted_decimal("-15", -9), "-1.5e-8");
  EXPECT_EQ(shifted_decimal("1", 20), "100000000000000000000");
  EXPECT_EQ(shifted_decimal("1", 21), "1e21");
  EXPECT_EQ(shifted_decimal("1.25e300", 3), "1.25e303");
}

TEST(ShiftedDecimal, HasNoSignOrExponentForZero) {
  EXPECT_EQ(shifted_decimal("0", 3), "0");
  EXPECT_EQ(shifted_decimal("-0.000", -3), "0");
  EXPECT_EQ(shifted_decimal("0e9999", -9), "0");
}

TEST(ShiftedDecimal, ThereAndBackIsTheSameNumber) {
  for (const char* number : {"5e-05", "0.1", "-2.75", "3.0", "1e21", "123456.789", "2.5e-300"}) {
    for (int places = -30; places <= 30; ++places) {
      const std::string back =
          shifted_decimal(shifted_decimal(number, places).value(), -places).value();
      EXPECT_EQ(std::stod(back), std::stod(number)) << number << ' ' << places;
    }
  }
}

TEST(ShiftedDecimal, RefusesWhatIsNotANumberOfJson) {
  for (const char* text : {"", "-", "+1", ".5", "5.", "01", "1,5", "1e", "1e+", "1e5x", " 1", "1 ",
                           "0x1", "inf", "nan", "1e12345", "--1", "1.2.3"}) {
    EXPECT_EQ(shifted_decimal(text, 3), std::nullopt) << text;
    EXPECT_EQ(shifted_decimal(text, 0), std::nullopt) << text;
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
