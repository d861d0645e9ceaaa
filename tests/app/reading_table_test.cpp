// The digits of the tables of a report.

#include "app/findings/outcome/reading_table.h"

#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/reading_number.h"

namespace asperity {
namespace {

using testing::ElementsAre;

/// The texts of a column of the reading table.
std::vector<std::string> shown(const Table& table, const std::string& column) {
  const Table reading = reading_table(table);
  const auto at = column_of(reading, column);
  std::vector<std::string> texts;
  if (!at) return texts;
  for (const std::vector<Cell>& row : reading.rows) {
    const auto* const text = std::get_if<std::string>(&row[*at]);
    texts.push_back(text == nullptr ? "" : *text);
  }
  return texts;
}

TEST(ReadingTable, PrintsAColumnAndItsIntervalsWithTheDecimalsOfTheNarrowest) {
  const Table table{
      .columns = {"participant", "jnd", "jnd_low", "jnd_high"},
      .rows = {{std::string("p1"), 12.0, 8.09, 15.9}, {std::string("p2"), 3.25, 3.2, 3.3}}};
  EXPECT_THAT(shown(table, "jnd"), ElementsAre("12.00", "3.25"));
  const Table narrow{.columns = {"ratio", "ratio_low", "ratio_high"},
                     .rows = {{1.0012, 0.9993, 1.0031}}};
  EXPECT_THAT(shown(narrow, "ratio"), ElementsAre("1.0012"));
}

TEST(ReadingTable, PrintsStandardErrorsWithTheDecimalsOfTheirNumbers) {
  const Table table{.columns = {"slope", "slope_se"}, .rows = {{0.5, 0.0042}, {1.0, 0.011}}};
  EXPECT_THAT(shown(table, "slope"), ElementsAre("0.5000", "1.0000"));
  EXPECT_THAT(shown(table, "slope_se"), ElementsAre("0.0042", "0.0110"));
}

TEST(ReadingTable, PrintsDifferentSmallNumbersDifferently) {
  const std::vector<std::vector<Cell>> rows{{4.6e-05, 4.6e-05}, {5e-05, 5e-05}, {5.25e-05, 2e-04}};
  const Table table{.columns = {"amplitude_m", "predictor"}, .rows = rows};
  for (const char* const column : {"amplitude_m", "predictor"}) {
    const std::vector<std::string> texts = shown(table, column);
    EXPECT_NE(texts[0], texts[1]) << column;
    EXPECT_NE(texts[1], texts[2]) << column;
  }
}

TEST(ReadingTable, PrintsStatisticsWithTwoDecimals) {
  const Table table{.columns = {"F", "p"}, .rows = {{73.7512, 0.0004}, {0.001, 0.97}}};
  EXPECT_THAT(shown(table, "F"), ElementsAre("73.75", "0.00"));
}

// Rows of different quantities do not share their decimals.
TEST(ReadingTable, PrintsEachRowOfAMixedColumnWithTheDecimalsOfItsInterval) {
  const Table table{.columns = {"effect", "effect_low", "effect_high"},
                    .rows = {{1.001, 0.999, 1.003}, {12.5, 10.0, 15.0}}};
  EXPECT_THAT(shown(table, "effect"), ElementsAre("1.0010", "12.50"));
}

TEST(ReadingNumber, ShowsThreeDigitsOfAReliefOfNanometres) {
  EXPECT_EQ(decimals_of_height(0.00141, 1), 5);  // 0.00141 µm
  EXPECT_EQ(decimals_of_height(1.0, 1), 2);
  EXPECT_EQ(decimals_of_height(9.99, 0), 2);
  EXPECT_EQ(decimals_of_height(10.0, 0), 0);
  EXPECT_EQ(decimals_of_height(1e-9, 1), 9);
  EXPECT_EQ(decimals_of_height(0.0, 1), 1);
}

TEST(ReadingNumber, ShowsTwoDigitsOfAnInterval) {
  EXPECT_EQ(decimals_of(0.12), 2);
  EXPECT_EQ(decimals_of(0.0038), 4);
  EXPECT_EQ(decimals_of(0.1), 2);
  EXPECT_EQ(decimals_of(0.01), 3);
  EXPECT_EQ(decimals_of(40.0), 2);
  EXPECT_EQ(decimals_of(1e-9), 5);
  EXPECT_EQ(decimals_of(0.0), 2);
}

}  // namespace
}  // namespace asperity
