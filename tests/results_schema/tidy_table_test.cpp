// Tables as spreadsheets and statistics programs write them.

#include "results_schema/tables/tidy_table.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/look_alikes.h"
#include "results_schema/study.h"
#include "results_schema/tables/table_words.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

TidyTable table_of(const std::string& text) { return TidyTable(text, "file.csv"); }

template <class Use>
std::string table_refusal(const std::string& text, Use use) {
  return refusal_of<ResultsError>([&] { use(table_of(text)); });
}

std::string table_refusal(const std::string& text) {
  return table_refusal(text, [](const TidyTable&) {});
}

TEST(TidyTable, RefusesLinesThatEndWithCarriageReturnsAlone) {
  EXPECT_EQ(table_refusal("a,b\r1,2\r"),
            "file.csv:1:1: the lines end with carriage returns alone; save the table with line "
            "feeds (LF or CRLF)");
}

TEST(TidyTable, ReadsByteOrderMarksLineEndsOfWindowsAndEmptyLines) {
  const TidyTable table = table_of("\xEF\xBB\xBFid,k\r\na,1\r\n\r\nb,2");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.texts("id"), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_EQ(table.counts("k"), (std::vector<std::uint64_t>{1, 2}));
}

TEST(TidyTable, RefusesWhatIsNotUtf8AndSaysInWhichLine) {
  const std::string words = ": a character of this line is not UTF-8; save the table as UTF-8";
  EXPECT_EQ(table_refusal("id,k\na,1\nRen\xE9,2\n"), "file.csv:3" + words) << "Latin-1";
  EXPECT_EQ(table_refusal("id,k\n\xC0\xAF,1\n"), "file.csv:2" + words) << "longer than need be";
  EXPECT_EQ(table_refusal("id,k\n\xED\xA0\x80,1\n"), "file.csv:2" + words) << "half a pair";
  EXPECT_EQ(table_refusal("id,k\na,\xE2\x82"), "file.csv:2" + words) << "torn";
  const TidyTable table = table_of("id\nRen\xC3\xA9\n\xE2\x82\xAC\n\xF0\x9F\x98\x80\n");
  EXPECT_EQ(table.texts("id"),
            (std::vector<std::string_view>{"Ren\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"}));
}

TEST(TidyTable, ReadsQuotedCells) {
  const TidyTable table =
      table_of("id,\"the note\"\n\"a,b\",\"she said \"\"no\"\"\nand left\"\nc,d\n");
  EXPECT_EQ(table.texts("id"), (std::vector<std::string_view>{"a,b", "c"}));
  EXPECT_EQ(table.texts("the note"),
            (std::vector<std::string_view>{"she said \"no\"\nand left", "d"}));
  EXPECT_EQ(
      table_refusal("id,k\n\"a\nb\",1\nc,x\n", [](const TidyTable& read) { read.numbers("k"); }),
      "file.csv:4:2: k is \"x\", which is not a number; write a number, or leave the cell empty");
}

TEST(TidyTable, ReadsTabs) {
  const TidyTable table = table_of("id\tk\na, b\t 1.5 \n");
  EXPECT_EQ(table.texts("id"), (std::vector<std::string_view>{"a, b"}));
  EXPECT_EQ(table.all_numbers("k"), (std::vector<double>{1.5}));
}

TEST(TidyTable, KnowsThreeWaysToWriteNothing) {
  const TidyTable table = table_of("id,k\na,\nNA,NA\nn/a,n/a\nb,+2e0\n");
  EXPECT_EQ(table.numbers("k"),
            (std::vector<std::optional<double>>{std::nullopt, std::nullopt, std::nullopt, 2.0}));
  const LabelColumn labels = table.labels("id");
  EXPECT_EQ(labels.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(labels.codes,
            (std::vector<std::size_t>{0, LabelColumn::kMissing, LabelColumn::kMissing, 1}));
}

TEST(TidyTable, NamesLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(table_refusal(""),
            "file.csv:1:0: the header line is missing; add a line with the names of the columns");
  EXPECT_EQ(table_refusal("a,b,a\n"),
            "file.csv:1:3: the column name \"a\" occurs twice; rename one of the columns");
  EXPECT_EQ(table_refusal("a,,b\n"), "file.csv:1:2: the column has no name; give it one");
  EXPECT_EQ(table_refusal("a,b\n1,2\n1\n"),
            "file.csv:3:2: the row has 1 cell, the header has 2 columns; give each row one cell "
            "per column");
  EXPECT_EQ(
      table_refusal("a,b\n\"1,2\n"),
      "file.csv:2:1: the quotation mark that opens this cell is not closed; add the closing one");
  EXPECT_EQ(
      table_refusal("a,b\n\"1\"x,2\n"),
      "file.csv:2:1: text follows the quotation mark that closes this cell; write a quotation mark "
      "within the cell twice");
  EXPECT_EQ(table_refusal("a,b\n1,2\n", [](const TidyTable& table) { table.texts("c"); }),
            "file.csv:1:1: there is no column \"c\"; add it, or use one of the columns a, b");
}

TEST(TidyTable, SaysWhatADecimalCommaIs) {
  EXPECT_EQ(table_refusal("id;k\na;1,5\n"),
            "file.csv:1:1: the columns are separated by semicolons; save the table with commas (or "
            "tabs) and decimal points");
  EXPECT_EQ(table_refusal("id,k\na,1,5\n"),
            "file.csv:2:3: the row has 3 cells, the header has 2 columns; put quotation marks "
            "around a text "
            "that contains a comma, and write numbers with a decimal point");
  EXPECT_EQ(table_refusal("id\tk\na\t1,5\n", [](const TidyTable& table) { table.numbers("k"); }),
            "file.csv:2:2: k is \"1,5\", with a decimal comma; write a decimal point");
}

// 1,000 with a point for its comma would be 1.
TEST(TidyTable, SaysWhatAThousandsSeparatorIs) {
  const auto numbers = [](const TidyTable& table) { table.numbers("k"); };
  EXPECT_EQ(table_refusal("id,k\na,20\nb,\"1,000\"\n", numbers),
            "file.csv:3:2: k is \"1,000\", with a thousands separator; write 1000");
  EXPECT_EQ(table_refusal("id\tk\na\t-1 234 567.5\n", numbers),
            "file.csv:2:2: k is \"-1 234 567.5\", with a thousands separator; write -1234567.5");
  EXPECT_EQ(table_refusal("id\tk\na\t1\u202f000\n", numbers),
            "file.csv:2:2: k is \"1\u202f000\", with a thousands separator; write 1000");
  // The 0,5 of another row, and 0,125 itself, have decimal commas.
  EXPECT_EQ(table_refusal("id\tk\na\t1,000\nb\t0,5\n", numbers),
            "file.csv:2:2: k is \"1,000\", with a decimal comma; write a decimal point");
  EXPECT_EQ(table_refusal("id\tk\na\t1 000\nb\t0,5\n", numbers),
            "file.csv:2:2: k is \"1 000\", with a thousands separator; write 1000");
  EXPECT_EQ(table_refusal("id\tk\na\t0,125\n", numbers),
            "file.csv:2:2: k is \"0,125\", with a decimal comma; write a decimal point");
}

TEST(TidyTable, ReadsPastSpacesThatAreNotSeenAndNamesThoseOfNames) {
  const TidyTable table = table_of("id,k\na,\u00a01.5\u200b\nb c,2\n");
  EXPECT_EQ(table.all_numbers("k"), (std::vector<double>{1.5, 2.0}));
  EXPECT_EQ(table_refusal("id\na\na\u00a0\n", [](const TidyTable& read) { read.labels("id"); }),
            "file.csv:3:1: id is \"a\u00a0\", with a no-break space (U+00A0) at an end; delete it");
  EXPECT_EQ(table_refusal("id,k\na,\u22121\n", [](const TidyTable& read) { read.numbers("k"); }),
            "file.csv:2:2: k is \"\u22121\", with a minus sign (U+2212); write a hyphen (-)");
}

// This folder includes no other; what a user reads is the same.
TEST(TidyTable, NamesCharactersAsOtherReadersDo) {
  for (const UnseenCharacter& each : kUnseenCharacters) {
    const auto known = look_alike_at(each.bytes);
    ASSERT_TRUE(known) << each.name;
    EXPECT_EQ(each.name, known->character.english());
  }
  EXPECT_EQ(look_alike_at(kMinusSign)->character.english(), "a minus sign (U+2212)");
}

TEST(TidyTable, SkipsTheLineInWhichASpreadsheetStatesTheSeparator) {
  const TidyTable table = table_of("\xEF\xBB\xBFsep=,\r\nid,k\r\na,1\r\n");
  EXPECT_EQ(table.texts("id"), (std::vector<std::string_view>{"a"}));
  EXPECT_EQ(table_refusal("sep=,\nid,id\n"),
            "file.csv:2:2: the column name \"id\" occurs twice; rename one of the columns");
  EXPECT_EQ(table_refusal("sep=;\nid;k\n"),
            "file.csv:1:1: the columns are separated by semicolons; save the table with commas (or "
            "tabs) and decimal points");
}

TEST(TidyTable, RefusesNumbersThatAreNone) {
  const auto numbers = [](const TidyTable& table) { table.all_numbers("k"); };
  const auto counts = [](const TidyTable& table) { table.counts("k"); };
  EXPECT_NE(table_refusal("id,k\na,NaN\n", numbers), "");
  EXPECT_NE(table_refusal("id,k\na,inf\n", numbers), "");
  EXPECT_EQ(table_refusal("id,k\na,\n", numbers), "file.csv:2:2: k is missing; enter a value");
  EXPECT_EQ(table_refusal("id,k\na,1.5\n", counts),
            "file.csv:2:2: k is 1.5; it must be a whole number from 0");
  EXPECT_EQ(table_refusal("id,k\na,-1\n", counts),
            "file.csv:2:2: k is -1; it must be a whole number from 0");
  EXPECT_EQ(table_refusal("id,k\na,2147483648\n",
                          [](const TidyTable& table) { table.counts("k", 1000); }),
            "file.csv:2:2: k is 2147483648; it must be a whole number from 0 to 1000");
}

// A double has no 2⁵³ + 1: the count would be another one.
TEST(TidyTable, RefusesCountsThatADoubleCannotHold) {
  const auto counts = [](const TidyTable& table) { table.counts("k"); };
  EXPECT_EQ(table_refusal("id,k\na,9007199254740991\n", counts), "");
  for (const char* const count : {"9007199254740992", "9007199254740993", "1e20"}) {
    EXPECT_THAT(table_refusal("id,k\na," + std::string(count) + '\n', counts),
                testing::HasSubstr("it must be a whole number from 0 to 9007199254740991"));
  }
}

// Their squares are infinite or 0: a t of 0, or a p of 1, would be stated.
TEST(TidyTable, RefusesNumbersWhoseSquaresAreNone) {
  const auto numbers = [](const TidyTable& table) { table.numbers("y"); };
  for (const char* const number : {"1e160", "-1e160", "1e-160", "5e-324", "1.1e100"}) {
    EXPECT_THAT(table_refusal("id,y\na," + std::string(number) + '\n', numbers),
                testing::StartsWith("file.csv:2:2: y is " + std::string(number) +
                                    "; numbers from 1e-100 to 1e100 in magnitude"));
  }
  EXPECT_EQ(table_refusal("id,y\na,1e100\nb,-1e-100\nc,0\nd,-0.0\n", numbers), "");
}

TEST(TidyTable, RefusesANameInTwoForms) {
  const auto labels = [](const TidyTable& table) { table.labels("id"); };
  // An accented e as one character and as two; a Korean syllable and its parts; two accents on one letter.
  EXPECT_THAT(table_refusal("id\nRen\u00e9\nJo\nRene\u0301\n", labels),
              testing::StartsWith("file.csv:4:1: id is \"Rene\u0301\", and an earlier row has "
                                  "\"Ren\u00e9\""));
  EXPECT_NE(table_refusal("id\n\uac01\n\u1100\u1161\u11a8\n", labels), "");
  EXPECT_NE(table_refusal("id\n\u1ec7\ne\u0323\u0302\n", labels), "");
  // The same form throughout, whichever it is.
  EXPECT_EQ(table_refusal("id\n\u00e9\n\u00fc\ne\n\u00e9\n", labels), "");
  EXPECT_EQ(table_refusal("id\ne\u0301\nu\u0308\ne\n", labels), "");
}

// Looked for one by one they would take minutes.
TEST(TidyTable, FindsAColumnAmongMany) {
  constexpr std::size_t kColumns = 200'000;
  std::string header;
  std::string row;
  for (std::size_t i = 0; i < kColumns; ++i) {
    header += (i > 0 ? ",c" : "c") + std::to_string(i);
    row += (i > 0 ? "," : "") + std::to_string(i);
  }
  const TidyTable table = table_of(header + '\n' + row + '\n');
  for (std::size_t i = 0; i < kColumns; i += 7) {
    ASSERT_EQ(table.counts('c' + std::to_string(i)).front(), i);
  }
  EXPECT_THAT(table_refusal(header + '\n' + row + '\n',
                            [](const TidyTable& read) { read.counts("absent"); }),
              testing::EndsWith(" c98, c99 and 199900 more"));
}

TEST(TidyTable, TakesOnlyTheNamesThatAreGivenInTheirOrder) {
  const TidyTable table = table_of("choice\nwood\nmetal\n");
  EXPECT_EQ(table.labels("choice", {"metal", "stone", "wood"}).codes,
            (std::vector<std::size_t>{2, 0}));
  EXPECT_EQ(table_refusal("choice\nwood\nmetl\n",
                          [](const TidyTable& read) {
                            read.labels("choice", {"metal", "wood"});
                          }),
            "file.csv:3:1: choice is \"metl\"; it must be one of: metal, wood");
}

TEST(TidyTable, MayBeMovedWithItsCells) {
  std::vector<TidyTable> tables{};
  for (int i = 0; i < 8; ++i) tables.push_back(table_of("a\nx\n"));
  EXPECT_EQ(tables.front().texts("a"), (std::vector<std::string_view>{"x"}));
}

// A table may have hundreds of megabytes.
TEST(TidyTable, KeepsTheTextThatItIsGivenAndNoOther) {
  std::string text = "id,k\nfirst,1\n\"sec\"\"ond\",2";
  const char* const begin = text.data();
  const TidyTable table(std::move(text), "file.csv");
  const std::vector<std::string_view> ids = table.texts("id");
  ASSERT_EQ(ids.size(), 2U);
  EXPECT_EQ(ids[0], "first");
  EXPECT_EQ(ids[0].data(), begin + 5);
  EXPECT_EQ(ids[1], "sec\"ond");
  EXPECT_EQ(ids[1].data(), begin + 13);
}

TEST(TidyTable, IsMadeOfColumnsAsIfItHadBeenRead) {
  std::vector<TidyTable::Column> columns{
      {"who", LabelColumn{.names = {"NA", "b", "c"}, .codes = {2, 0, 2}}},
      {"what", LabelColumn{.names = {"x"}, .codes = {0, LabelColumn::kMissing, 0}}}};
  const TidyTable table(columns, "made");
  EXPECT_EQ(table.rows(), 3U);
  const LabelColumn who = table.all_labels("who");  // a name is a name, whatever it looks like
  EXPECT_EQ(who.names, (std::vector<std::string>{"c", "NA"}));
  EXPECT_EQ(who.codes, (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(table.texts("what")[1], "");
  EXPECT_EQ(refusal_of<ResultsError>([&] { table.all_labels("what"); }),
            "made:3:2: what is missing; enter a value");
  std::get<LabelColumn>(columns[1].cells).codes.pop_back();
  EXPECT_THROW(TidyTable(columns, "made"), std::invalid_argument);
}

// What a program computed goes into a table as it is: a name that a file could not hold, a number to its last digit.
TEST(TidyTable, HoldsValuesAsTheyAre) {
  const double third = 1.0 / 3.0;
  const TidyTable table({{"subject", LabelColumn{{"NA", "a,\"b\""}, {0, 1, 0}}},
                         {"value", NumberColumn{third, std::nullopt, -0.0}}},
                        "made");
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.labels("subject").names, (std::vector<std::string>{"NA", "a,\"b\""}));
  EXPECT_EQ(table.numbers("value"), (NumberColumn{third, std::nullopt, -0.0}));
  EXPECT_THROW(table.all_numbers("value"), ResultsError);
  EXPECT_THROW(table.labels("value"), std::logic_error) << "numbers are not names";
  const auto with = [](NumberColumn numbers) {
    return std::vector<TidyTable::Column>{{"subject", LabelColumn{{"a"}, {0}}},
                                          {"value", std::move(numbers)}};
  };
  EXPECT_THROW(TidyTable(with({1.0, 2.0}), "made"), std::invalid_argument) << "one row too many";
  EXPECT_THROW(TidyTable(with({std::nan("")}), "made"), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
