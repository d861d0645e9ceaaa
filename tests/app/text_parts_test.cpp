// Texts taken apart into lines.

#include "app/words/text_parts.h"

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

}  // namespace
}  // namespace asperity
