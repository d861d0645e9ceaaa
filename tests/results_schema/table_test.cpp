// Tab-separated text says exactly what the table does.

#include "results_schema/tables/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <locale.h>
#include <stdlib.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/tables/sav_file.h"
#include "results_schema/tables/table_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::string refusal_of_tsv(std::string_view text) {
  return refusal_of<ResultsError>([&] { read_tsv(text, "file.tsv"); });
}

TEST(Table, IsWrittenAsTabsWithMissingCellsNamed) {
  const Table table{.columns = {"name", "count", "force_N", "note"},
                    .rows = {{std::string("wood"), std::int64_t{3}, 0.1, Cell{}},
                             {std::string(""), std::int64_t{-1}, 1e-300, std::string("=cmd")}}};
  EXPECT_EQ(tsv_of(table), "name\tcount\tforce_N\tnote\nwood\t3\t0.1\tn/a\n\t-1\t1e-300\t=cmd\n");
}

TEST(Table, CountsTheCellsThatDoNotReadBackAsTheyWere) {
  const Table table{.columns = {"note", "other"},
                    .rows = {{std::string("a\tb\nc"), std::string("plain")},
                             {std::string("n/a"), std::string("\r")},
                             {Cell{}, std::string("N/A")}}};
  std::size_t replaced = 99;
  EXPECT_EQ(tsv_of(table, &replaced), "note\tother\na b c\tplain\nn/a\t \nn/a\tN/A\n");
  EXPECT_EQ(replaced, 3U);
}

TEST(Table, ReadsBackWhatItWrote) {
  const Table table{
      .columns = {"a", "b"},
      .rows = {{std::string("x y"), Cell{}}, {std::string(""), std::string("ü🙂\"q\"")}}};
  const Table read = read_tsv(tsv_of(table), "file.tsv");
  EXPECT_EQ(read.columns, table.columns);
  EXPECT_EQ(read.rows, table.rows);
}

TEST(Table, ReadsLineEndsAndByteOrderMarksOfOtherTools) {
  const Table table = read_tsv(
      "\xEF\xBB\xBF"
      "a\tb\r\n1\tn/a\r\n2\t3",
      "file.tsv");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1], Cell{});
  EXPECT_EQ(table.rows[1][1], Cell{std::string("3")});
}

TEST(Table, SaysWhereItIsWrong) {
  EXPECT_EQ(refusal_of_tsv("a\tb\n1\t2\n3\n"),
            "file.tsv:3:2: the row has 1 cell, the header has 2 columns; give each row one cell "
            "per column");
  EXPECT_EQ(refusal_of_tsv("a\n1\t2\n"),
            "file.tsv:2:2: the row has 2 cells, the header has 1 column; give each row one cell "
            "per column");
  EXPECT_EQ(refusal_of_tsv("a\tb\ta\n"),
            "file.tsv:1:3: the column name \"a\" occurs twice; rename one of the columns");
  EXPECT_EQ(refusal_of_tsv("a\t\n"), "file.tsv:1:2: the column has no name; give it one");
  EXPECT_EQ(refusal_of_tsv("a\tb\r1\t2\r"),
            "file.tsv:1:1: the lines end with carriage returns alone; save the table with line "
            "feeds (LF or CRLF)");
  EXPECT_EQ(refusal_of_tsv(""),
            "file.tsv:1:1: the header line is missing; add a line with the names of the columns");
}

TEST(Table, RefusesARowOfAnotherLength) {
  const Table table{.columns = {"a"}, .rows = {{Cell{}, Cell{}}}};
  EXPECT_THROW(tsv_of(table), std::invalid_argument);
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(text_of_number(0.1), "0.1");
  EXPECT_EQ(text_of_number(1.0), "1");
  EXPECT_EQ(text_of_number(-0.0), "-0");
  EXPECT_EQ(text_of_number(1.0 / 3.0), "0.3333333333333333");
  for (const double value : {5e-324, 1.7976931348623157e308, 123456789.123, 2.5e-7}) {
    EXPECT_EQ(number_in(text_of_number(value)), value);
  }
}

TEST(NumberText, NamesWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(text_of_number(infinity), "inf");
  EXPECT_EQ(text_of_number(-infinity), "-inf");
  EXPECT_EQ(text_of_number(std::nan("")), "nan");
  EXPECT_EQ(text_of_number(-std::nan("")), "nan");
}

TEST(NumberText, TakesAllOfTheTextOrNothing) {
  EXPECT_EQ(number_in("1.5"), 1.5);
  for (const char* const text : {"", "1,5", "1.5 ", " 1.5", "1.5N", "1e999", "n/a", "0x10"}) {
    EXPECT_EQ(number_in(text), std::nullopt) << text;
  }
}

TEST(NumberText, DoesNotHeedTheLocale) {
  const std::string before = ::setlocale(LC_ALL, nullptr);
  ::setenv("LOCPATH", ASPERITY_LOCALE_FOLDER, 1);
  ASSERT_NE(::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
  ASSERT_STREQ(::localeconv()->decimal_point, ",");
  EXPECT_EQ(text_of_number(1.5), "1.5");
  EXPECT_EQ(number_in("1.5"), 1.5);
  ::setlocale(LC_ALL, before.c_str());
  ::unsetenv("LOCPATH");
}

TEST(TableFile, WritesWhatReadsBackAndMarksWhatWouldBeAFormula) {
  const TemporaryFolder folder;
  TableFile file(folder / "a.tsv", TableFile::Format::tsv, {"text", "number"});
  file.add({Cell{"=1+1"}, Cell{-1.5}});
  file.add({Cell{"'quoted'"}, Cell{std::int64_t{-3}}});
  file.add({Cell{"n/a"}, Cell{}});
  file.add({Cell{"two\nlines"}, Cell{0.1}});
  file.add({Cell{"-2.5"}, Cell{1.0}});
  file.add({Cell{"-2+1"}, Cell{1.0}});
  const WrittenTable written = file.finish();
  EXPECT_EQ(
      read_file(folder / "a.tsv"),
      "text\tnumber\n'=1+1\t-1.5\n''quoted'\t-3\n'n/a\tn/a\ntwo lines\t0.1\n-2.5\t1\n'-2+1\t1\n");
  EXPECT_EQ(written.rows, 6U);
  EXPECT_EQ(written.marked_cells, 4U);
  EXPECT_EQ(written.spaced_cells, 1U);
  EXPECT_EQ(written.sha256, sha256_of_file(folder / "a.tsv"));
  EXPECT_THROW(TableFile(folder / "a.tsv", TableFile::Format::tsv, {"text"}), ResultsError);
}

TEST(TableFile, WritesCsvByTheRules) {
  const TemporaryFolder folder;
  TableFile file(folder / "a.csv", TableFile::Format::csv, {"a", "b, c"});
  file.add({Cell{"say \"x\"\nand y"}, Cell{}});
  file.add({Cell{""}, Cell{"@home"}});
  EXPECT_EQ(file.finish().marked_cells, 1U);
  EXPECT_EQ(read_file(folder / "a.csv"),
            "a,\"b, c\"\r\n\"say \"\"x\"\"\nand y\",\r\n\"\",'@home\r\n");
  EXPECT_THROW(file.add({Cell{}}), std::invalid_argument);
}

TEST(SavFile, GivesNamesThatSpssTakes) {
  const std::string long_name(80, 'x');
  EXPECT_EQ(sav_names({"a b", "A_b", "with", "1st", "", long_name, long_name + "y"}),
            (std::vector<std::string>{"a_b", "A_b_2", "v_with", "v_1st", "v", std::string(64, 'x'),
                                      std::string(62, 'x') + "_2"}));
}

TEST(SavFile, CutsOnlyWhatSpssCannotHoldAndSaysSo) {
  const TemporaryFolder folder;
  SavFile file(
      folder / "a.sav",
      {{.name = "words", .label = std::string(400, 'l'), .is_text = true, .width_bytes = 40'000}},
      2, "a title");
  file.add({Cell{std::string(40'000, 'w')}});
  file.add({Cell{std::string(32'000, 'w')}});
  EXPECT_EQ(file.finish().cut_cells, 1U);
  const std::string bytes = read_file(folder / "a.sav");
  EXPECT_EQ(bytes.substr(0, 4), "$FL2");
  EXPECT_EQ(bytes.substr(92, 17), "01 Jan 7000:00:00");
}

TEST(Names, AreOrderedByValueWhereTheyAreNumbers) {
  std::vector<std::string> names{"wood", "5e-05", "brick", "0.001", "4.6e-05", "5.3e-05"};
  std::sort(names.begin(), names.end(), precedes_by_value);
  EXPECT_EQ(names,
            (std::vector<std::string>{"4.6e-05", "5e-05", "5.3e-05", "0.001", "brick", "wood"}));
}

}  // namespace
}  // namespace asperity
