// Texts taken apart into lines.

#include "app/words/text_parts.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(WrappedText, BreaksBetweenWords) {
  EXPECT_EQ(wrapped_text("Feel each surface with your own hand.", 12),
            "Feel each\nsurface with\nyour own\nhand.");
  EXPECT_EQ(wrapped_text("One\n\ntwo three", 80), "One\n\ntwo three");
  EXPECT_EQ(wrapped_text("Oberflächenstruktur", 8), "Oberflächenstruktur");
  EXPECT_EQ(wrapped_text("größte Höhe", 11), "größte Höhe") << "letters are counted, not bytes";
  EXPECT_EQ(wrapped_text("", 80), "");
}

TEST(WrappedText, LeavesRoomBeforeTheFollowingLines) {
  EXPECT_EQ(wrapped_text("one two three", 9, "! "), "! one two\n  three");
  EXPECT_EQ(wrapped_text("größte Höhe", 13, "– "), "– größte Höhe") << "as wide as its letters";
  EXPECT_EQ(wrapped_text("one\n\ntwo", 80, "  "), "  one\n\n  two") << "no line ends in a blank";
}

TEST(TextParts, JoinWordsToALine) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"1"}), "1");
  EXPECT_EQ(listed({"1", "2"}), "1 and 2");
  EXPECT_EQ(listed({"0.5", "1", "2"}), "0.5, 1 and 2");
  EXPECT_EQ(comma_separated(std::vector<std::string>{}), "");
  EXPECT_EQ(comma_separated(std::set<std::string>{"sinusoid", "height_map"}),
            "height_map, sinusoid");
}

}  // namespace
}  // namespace asperity
