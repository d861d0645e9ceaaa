// Control characters are shown and not obeyed.

#include "app/words/shown_text.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "app/cli/output/terminal.h"

namespace asperity {
namespace {

TEST(ShownText, HasTheNumbersOfControlCharacters) {
  EXPECT_EQ(shown_in_a_line("\x1b]0;title\x07"), R"(\u001b]0;title\u0007)");
  EXPECT_EQ(shown_in_a_line("a\nasperity: all is well\r\t"),
            R"(a\u000aasperity: all is well\u000d\u0009)");
  EXPECT_EQ(shown_in_a_line(std::string("a\0b", 3)), R"(a\u0000b)");
  EXPECT_EQ(shown_in_a_line("\x9b"
                            "31m|\u061c|\u200e|\u200f"),
            R"(\u009b31m|\u061c|\u200e|\u200f)")
      << "a byte that is not UTF-8, and marks of direction";
  EXPECT_EQ(shown_in_a_line("\x7f|\u009b31m|\u202egnp.exe|\u2066"),
            R"(\u007f|\u009b31m|\u202egnp.exe|\u2066)");
}

TEST(ShownText, HasEveryOtherCharacterUnchanged) {
  const std::string text = "Höhe \u00a0µm – “10 %” 表面 \U0001F600 \\u001b";
  EXPECT_EQ(shown_in_a_line(text), text);
  EXPECT_EQ(shown_in_lines("one\n\ttwo\r\n"), "one\n\ttwo\\u000d\n");
  EXPECT_EQ(shown_in_a_line("Ren\xE9 \xC2"), "Ren\xE9 \xC2") << "not UTF-8";
}

TEST(ShownOutput, ShowsWhatIsWrittenToAStream) {
  std::ostringstream stream{};
  {
    const ShownOutput shown(stream);
    stream << "a\x1b[31m" << '\n' << '\r' << 2.5 << std::flush;
  }
  stream << '\r';
  EXPECT_EQ(stream.str(), "a\\u001b[31m\n\\u000d2.5\r");
}

}  // namespace
}  // namespace asperity
