// Characters that look like others are found and named.

#include "analysis/numbers/look_alikes.h"

#include <string>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

TEST(LookAlikes, AreNamedWithWhatToWriteInstead) {
  const auto space = look_alike_at("\xC2\xA0x");
  ASSERT_TRUE(space);
  EXPECT_EQ(space->character.english(), "a no-break space (U+00A0)");
  EXPECT_EQ(space->correction.english(), "write a space instead");
  EXPECT_EQ(space->bytes.size(), 2U);
  const auto german = [](const char* context, const char* words) {
    return context == nullptr ? std::string(words) : "<" + std::string(words) + ">";
  };
  EXPECT_EQ(space->character.translated(german), "<a no-break space> (U+00A0)");
  EXPECT_EQ(space->correction.translated(german), "<write a space instead>");
  EXPECT_EQ(first_look_alike("ab\xE2\x80\x8B\xC2\xA0")->character.english(),
            "a zero-width space (U+200B)");
}

TEST(LookAlikes, AreTheReasonWhyACellIsNotANumber) {
  EXPECT_EQ(number_correction("0,5"), "with a decimal comma; write a decimal point");
  EXPECT_EQ(number_correction("1\xC2\xA0"), "with a no-break space (U+00A0); delete it");
  EXPECT_EQ(number_correction("\xE2\x88\x92"
                              "1"),
            "with a minus sign (U+2212); write a hyphen (-) instead");
  for (const char* const other : {"", "one", "1,2,3", "inf"}) {
    EXPECT_EQ(number_correction(other), "which is not a finite number; correct it") << other;
  }
}

TEST(LookAlikes, AreNotTheLettersOfNames) {
  EXPECT_FALSE(look_alike_at("a\xC2\xA0"));
  EXPECT_FALSE(first_look_alike("Ren\xC3\xA9, \xC3\x96l, \xE6\x9C\xA8"));
  EXPECT_FALSE(first_look_alike(""));
}

TEST(ByteOrderMark, IsLeftOutAtTheBeginningOnly) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx\xEF\xBB\xBF"), "x\xEF\xBB\xBF");
  EXPECT_EQ(without_byte_order_mark("x"), "x");
  EXPECT_EQ(without_byte_order_mark(""), "");
}

}  // namespace
}  // namespace asperity::test
