// analyze: one table of a study's responses, by its name.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class AnalyzeOnly : public testing::Test {
 protected:
  /// Simulated once; each test has a copy.
  static const SmallStudy& simulated() {
    static const SmallStudy made = simulated_study(2, 3);
    return made;
  }
  Outcome analyze(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"analyze", small_.study()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  }

  SmallStudy small_{simulated()};
};

TEST_F(AnalyzeOnly, PrintsOneTableWithItsHeadingAndItsRemarks) {
  const Outcome one = analyze({"--only", "table_1"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("small_selection 1.0.0 (selection, improved): virtual\n"),
                             HasSubstr("\n! These participants are virtual"),
                             HasSubstr("\nChoices (counts)\n")));
  EXPECT_THAT(one.out, AllOf(Not(HasSubstr("small_recognition")), Not(HasSubstr("?\n"))))
      << "an analysis without this table, and questions";
  const std::size_t title = one.out.find("\n---");
  EXPECT_EQ(one.out.find("\n---", title + 1), std::string::npos) << "a second table";
  const std::string table = one.out.substr(title);
  EXPECT_THAT(analyze({"--protocol", "small_selection"}).out, HasSubstr(table));

  EXPECT_THAT(analyze({"--only", "shares"}).out,
              AllOf(HasSubstr("small_selection 1.0.0"), HasSubstr("small_recognition 1.0.0")));
}

TEST_F(AnalyzeOnly, ListsTheNamesIfItHasNoTableOfTheName) {
  const Outcome unknown = analyze({"--protocol", "small_selection", "--only", "table_3"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_EQ(unknown.out, "");
  EXPECT_THAT(unknown.err, HasSubstr("--only table_3: the analysis has no table of this name; "
                                     "choose one of "));
  EXPECT_THAT(unknown.err, HasSubstr(", shares, shares_by_texture, table_1, tests"));
  EXPECT_EQ(analyze({"--only", "table_1", "--json"}).status, 2);
}

}  // namespace
}  // namespace asperity::test
