// The digits of the tables that people read.

#include "app/findings/outcome/displayed_table.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/display_number.h"

namespace asperity {
namespace {

using testing::ElementsAre;

const ResultColumn kOne{.id = "one", .heading = "one"};

ResultColumn with_digits(Digits digits) {
  return {.id = "one", .heading = "one", .digits = digits};
}

/// The texts of the column at this place.
std::vector<std::string> shown(const std::vector<ResultColumn>& columns,
                               const std::vector<ResultRow>& rows, std::size_t at = 0) {
  const DisplayedTable table = displayed({.columns = columns, .rows = rows}, Reader::report);
  std::vector<std::string> texts;
  for (const std::vector<Phrase>& row : table.rows) texts.push_back(row.at(at).english());
  return texts;
}

TEST(DisplayedTable, PrintsAColumnAndItsIntervalsWithTheDecimalsOfTheNarrowest) {
  const std::vector<ResultColumn> columns{kOne, interval_of(kOne)};
  const std::vector<ResultRow> rows{{12.0, Interval{8.09, 15.9}}, {3.25, Interval{3.2, 3.3}}};
  EXPECT_THAT(shown(columns, rows), ElementsAre("12.00", "3.25"));
  EXPECT_THAT(shown(columns, rows, 1), ElementsAre("[8.09, 15.90]", "[3.20, 3.30]"));
  EXPECT_THAT(shown(columns, {{1.0012, Interval{0.9993, 1.0031}}}), ElementsAre("1.0012"));
}

TEST(DisplayedTable, PrintsStandardErrorsWithTheDecimalsOfTheirNumbers) {
  const std::vector<ResultColumn> columns{kOne, standard_error_of(kOne, "its standard error")};
  const std::vector<ResultRow> rows{{0.5, 0.0042}, {1.0, 0.011}};
  EXPECT_THAT(shown(columns, rows), ElementsAre("0.5000", "1.0000"));
  EXPECT_THAT(shown(columns, rows, 1), ElementsAre("0.0042", "0.0110"));
}

TEST(DisplayedTable, PrintsDifferentSmallNumbersDifferently) {
  for (const Digits digits : {Digits::length, Digits::of_column}) {
    const std::vector<std::string> texts = shown(
        {with_digits(digits)}, {{4.6e-05}, {5e-05}, {digits == Digits::length ? 5.25e-05 : 2e-04}});
    EXPECT_NE(texts[0], texts[1]);
    EXPECT_NE(texts[1], texts[2]);
  }
}

TEST(DisplayedTable, PrintsStatisticsWithTwoDecimals) {
  EXPECT_THAT(shown({with_digits(Digits::statistic)}, {{73.7512}, {0.001}}),
              ElementsAre("73.75", "0.00"));
}

TEST(DisplayedTable, PrintsEachKindOfNumberWithItsDigits) {
  const auto one = [](Digits digits, double value) {
    return shown({with_digits(digits)}, {{value}}).front();
  };
  EXPECT_EQ(one(Digits::p, 0.0312), ".031");
  EXPECT_EQ(one(Digits::p, 0.0003), "< .001");
  EXPECT_EQ(one(Digits::chance, 1.0 / 3.0), ".333");
  EXPECT_EQ(one(Digits::bounded, 0.7123), ".71");
  EXPECT_EQ(one(Digits::force, 0.98765), "0.988");
  EXPECT_EQ(one(Digits::length, 0.00123456), "0.00123");
  EXPECT_EQ(one(Digits::estimate, 0.0456), "0.0456");
  EXPECT_EQ(one(Digits::of_column, 0.0456), "0.05");
  EXPECT_THAT(shown({interval_of(with_digits(Digits::chance))}, {{Interval{0.2, 0.4667}}}),
              ElementsAre("[.20, .47]"));
  EXPECT_THAT(shown({interval_of(kOne)}, {{Interval{1.5e-6, 2.5e-6, "m"}}}),
              ElementsAre("[1.5 µm, 2.5 µm]"));
}

// Rows of different quantities do not share their decimals.
TEST(DisplayedTable, PrintsEachRowOfAMixedColumnWithTheDecimalsOfItsInterval) {
  const ResultColumn mixed = with_digits(Digits::of_row);
  EXPECT_THAT(shown({mixed, interval_of(mixed)},
                    {{1.001, Interval{0.999, 1.003}}, {12.5, Interval{10.0, 15.0}}}),
              ElementsAre("1.0010", "12.50"));
}

TEST(DisplayedTable, NamesAColumnForEachReader) {
  const ResultColumn force{.id = "force_N", .heading = "force", .unit = "N"};
  EXPECT_EQ(heading_for(force, Reader::window).english(), "force, N");
  EXPECT_EQ(heading_for(force, Reader::report).english(), "force (N)");
  EXPECT_EQ(heading_for(force, Reader::terminal).english(), "force_N");
  const ResultColumn interval = interval_of(force);
  EXPECT_EQ(heading_for(interval, Reader::window).english(), "force, N, 95 % CI");
  EXPECT_EQ(heading_for(interval, Reader::report).english(), "95 % CI (N)");
  EXPECT_EQ(heading_for(interval, Reader::terminal).english(), "force_N 95 %");
  const ResultColumn wilson = interval_of(force, "Wilson 95 % CI");
  EXPECT_EQ(heading_for(wilson, Reader::window).english(), "Wilson 95 % CI, N");
}

TEST(DisplayedTable, HidesWhatIsForFilesAndColumnsWithoutValues) {
  const ResultColumn unit = for_files({.id = "unit"});
  const ResultTable table{.columns = {{.id = "name", .heading = "name"}, kOne, unit, {.id = "no"}},
                          .rows = {{"a", Quantity{1.5e-6, "m"}, "m", JoinedCell{{Cell{}}, {}}}}};
  const DisplayedTable shown = displayed(table, Reader::window);
  ASSERT_EQ(shown.columns.size(), 2U);
  EXPECT_TRUE(shown.columns[0].holds_words);
  EXPECT_FALSE(shown.columns[1].holds_words);
  EXPECT_EQ(shown.rows[0][1].english(), "1.5 µm");
  const Table stored = stored_table(table);
  EXPECT_THAT(stored.columns, ElementsAre("name", "one", "unit", "no"));
  EXPECT_EQ(stored.rows[0][1], Cell{1.5e-6});
}

TEST(DisplayedTable, IsTheTableForReadersWhereThereIsOne) {
  const ResultTable table{
      .columns = {kOne}, .rows = {{0.5}}, .for_readers = [](const ResultTable& stored) {
        return ResultTable{.columns = stored.columns, .rows = {{"half"}}};
      }};
  EXPECT_EQ(displayed(table, Reader::terminal).rows[0][0].english(), "half");
  EXPECT_EQ(stored_table(table).rows[0][0], Cell{0.5});
}

TEST(StoredTable, RefusesCellsWithoutAColumn) {
  ResultTable table{.columns = {kOne}};
  EXPECT_THROW(table.add({0.5, 0.6}), std::logic_error);
  table.add({JoinedCell{{Cell{0.5}, Cell{0.6}}, "both"}});
  EXPECT_THROW(stored_table(table), std::logic_error);
}

TEST(StoredTable, HasEveryValueInAColumnOfItsOwn) {
  const ResultColumn test{.id = "test", .stored_as = {"test", "first", "second"}};
  const ResultTable table{
      .columns = {test, kOne, interval_of(kOne)},
      .rows = {
          {JoinedCell{{std::string("pairs"), std::string("a"), std::string("b")}, "pairs: a / b"},
           0.5, Interval{0.25, {}}}}};
  const Table stored = stored_table(table);
  EXPECT_THAT(stored.columns, ElementsAre("test", "first", "second", "one", "one_low", "one_high"));
  EXPECT_EQ(stored.rows[0], (std::vector<Cell>{std::string("pairs"), std::string("a"),
                                               std::string("b"), 0.5, 0.25, Cell{}}));
  EXPECT_EQ(displayed(table, Reader::window).rows[0][0].english(), "pairs: a / b");
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
