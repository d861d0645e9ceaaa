// Labels that are one name to a reader.

#include "results_schema/tables/name_forms.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LabelForm, HasNeitherLetterCaseNorLeadingZeros) {
  EXPECT_EQ(label_form("P01"), "p1");
  EXPECT_EQ(label_form("p1"), "p1");
  EXPECT_EQ(label_form("01"), label_form("1"));
  EXPECT_EQ(label_form("A00b007"), "a0b7");
  EXPECT_EQ(label_form("000"), "0");
}

TEST(LabelForm, KeepsTheZerosOfNumbers) {
  EXPECT_EQ(label_form("p10"), "p10");
  EXPECT_EQ(label_form("P100"), "p100");
  EXPECT_NE(label_form("p10"), label_form("p1"));
}

}  // namespace
}  // namespace asperity
