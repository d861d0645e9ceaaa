// Which numbers are the same.

#include "tests/earlier_studies/numbers.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Numbers kStored = read_numbers(
    "## wide\nparticipant\tmean\nP01\t0.25\nP02\t\n\n##+ "
    "findings\nquantity\tvalue\np\t0.5\nn\t3\n\n");

TEST(Numbers, ReadBackAsTheyAreStored) {
  ASSERT_EQ(kStored.size(), 2U);
  EXPECT_FALSE(kStored[0].may_grow);
  EXPECT_TRUE(kStored[1].may_grow);
  EXPECT_THAT(kStored[0].rows, ElementsAre(ElementsAre("P01", "0.25"), ElementsAre("P02", "")));
  EXPECT_EQ(text_of(read_numbers(text_of(kStored))), text_of(kStored));
}

TEST(Numbers, AreTheSameWhereTablesColumnsAndFindingsWereAdded) {
  const Numbers now = read_numbers(
      "## other\na\n1\n\n## wide\nparticipant\tn\tmean\nP01\t4\t0.25\nP02\t0\t\n\n"
      "##+ findings\nquantity\tvalue\np\t0.5\nd\t1\nn\t3\n\n");
  EXPECT_THAT(differences(kStored, now), IsEmpty());
}

TEST(Numbers, AreTheSameWhereAFindingHasGotAnInterval) {
  const Numbers stored = read_numbers("##+ findings\nquantity\tvalue\tlow\nd\t0.5\t\n\n");
  Numbers now = stored;
  now[0].rows[0][2] = "0.25";
  EXPECT_THAT(differences(stored, now), IsEmpty());
  EXPECT_EQ(differences(now, stored).size(), 1U) << "an interval that is missing is a difference";
  now[0].rows[0][1] = "";
  EXPECT_EQ(differences(stored, now).size(), 1U);
}

TEST(Numbers, AreTheSameToTheLastDigitsOfACompiler) {
  Numbers now = kStored;
  now[0].rows[0][1] = "0.25000000000001";
  EXPECT_THAT(differences(kStored, now), IsEmpty());
}

TEST(Numbers, DifferByANumberThatChangedOrIsMissing) {
  Numbers now = kStored;
  now[0].rows[0][1] = "0.2500001";
  EXPECT_THAT(differences(kStored, now), ElementsAre("wide, row 1, mean: 0.25 became 0.2500001"));
  now[0].rows[0][1] = "";
  EXPECT_THAT(differences(kStored, now), ElementsAre("wide, row 1, mean: 0.25 became "));
  now = kStored;
  now[0].rows[1][1] = "0.25";
  EXPECT_THAT(differences(kStored, now), ElementsAre("wide, row 2, mean:  became 0.25"));
}

TEST(Numbers, DifferByAMissingTableOrColumnAndByAnotherNumberOfRows) {
  Numbers now{kStored[1]};
  EXPECT_THAT(differences(kStored, now), ElementsAre("there is no table wide"));
  now = kStored;
  now[0].columns[1] = "average";
  EXPECT_THAT(differences(kStored, now), ElementsAre("wide has no column mean"));
  now = kStored;
  now[0].rows.push_back({"P03", "1"});
  EXPECT_THAT(differences(kStored, now), ElementsAre("wide: 2 rows became 3"));
  now = kStored;
  std::swap(now[1].rows[0], now[1].rows[1]);
  EXPECT_THAT(differences(kStored, now), IsEmpty()) << "findings have names";
  now[1].rows[0] = now[1].rows[1];
  EXPECT_THAT(differences(kStored, now),
              ElementsAre("findings lacks a row, or has it elsewhere: n, 3"));
}

TEST(Numbers, OfAReportMayHaveOthersBetween) {
  const Numbers stored = numbers_of_report(
      "<tr><th>share</th><td class=\"n\">0.30 [.05, 6.1e-03]</td></tr><tr><td "
      "class=\"n\">–</td></tr>"
      "<tr><td class=\"n\">7</td><td>8</td></tr>");
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_THAT(stored[0].rows, ElementsAre(ElementsAre("0.30 .05 6.1e-03"), ElementsAre("7")));
  EXPECT_THAT(
      differences(stored, numbers_of_report("<tr><td class=\"n\">0.30, 95 % CI [.05, 6.1e-03]</td>"
                                            "</tr><tr><td class=\"n\">1</td></tr><tr><td "
                                            "class=\"n\">7</td></tr>")),
      IsEmpty());
  EXPECT_EQ(
      differences(stored, numbers_of_report("<tr><td class=\"n\">0.31 [.05, 6.1e-03]</td></tr>"
                                            "<tr><td class=\"n\">7</td></tr>"))
          .size(),
      1U);
  EXPECT_THAT(differences(numbers_of_report("<tr><td class=\"n\">-0.30 [-0.05, 6]</td></tr>"),
                          numbers_of_report("<tr><td class=\"n\">−.30 [−.05, 6]</td></tr>")),
              IsEmpty());
}

TEST(Numbers, OfAReportMayHaveMoreOrFewerDigits) {
  const auto differ = [](const std::string& stored, const std::string& now) {
    const auto row = [](const std::string& cell) {
      return numbers_of_report("<tr><td class=\"n\">" + cell + "</td></tr>");
    };
    return !differences(row(stored), row(now)).empty();
  };
  EXPECT_FALSE(differ("0.00388", "0.0039"));
  EXPECT_FALSE(differ("0.01", "0.0094"));
  EXPECT_FALSE(differ("5.2e-04", "0.00052"));
  EXPECT_TRUE(differ("0.00388", "0.0038"));
  EXPECT_TRUE(differ("0.30", "0.306"));
  EXPECT_TRUE(differ("3", "3.4")) << "counts are whole";
}

TEST(Corrections, ChangeOneCellWithAReason) {
  Numbers stored = kStored;
  correct(stored, read_corrections("# TABLE ROW COLUMN WAS IS REASON\n"
                                   "wide\t1\tmean\t0.25\t0.5\tan anchor was counted\n"));
  EXPECT_EQ(stored[0].rows[0][1], "0.5");
}

TEST(Corrections, OfACellThatIsNotThereAreRefused) {
  for (const char* wrong :
       {"wide\t1\tmean\t0.3\t0.5\tit was 0.25\n", "wide\t3\tmean\t0.25\t0.5\tno such row\n",
        "wide\t1\tmode\t0.25\t0.5\tno such column\n",
        "tall\t1\tmean\t0.25\t0.5\tno such table\n"}) {
    Numbers stored = kStored;
    EXPECT_THROW(correct(stored, read_corrections(wrong)), std::runtime_error) << wrong;
  }
  EXPECT_THROW(read_corrections("wide\t1\tmean\t0.25\t0.5\n"), std::runtime_error);
}

}  // namespace
}  // namespace asperity::test
