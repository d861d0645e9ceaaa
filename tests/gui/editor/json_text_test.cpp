// Positions, places and brackets of texts that may be broken.

#include "app/gui/editor/json_text.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/gui/editor/json_colors.h"

namespace asperity {
namespace {

QString underlined(const QString& text, int line, int column) {
  const TextRange range = range_to_underline(text, position_of(text, line, column));
  return text.mid(range.start, range.length);
}

// Columns count characters. µ is one UTF-16 unit (and two bytes), the emoji two (and four bytes).
TEST(JsonText, FindsAColumnBehindCharactersOfSeveralBytesOrUnits) {
  const QString text = QString::fromUtf8("{\n  \"µ😀\": 1, \"b\": 2\n}");
  EXPECT_EQ(underlined(text, 2, 3), QString::fromUtf8("\"µ😀\""));
  EXPECT_EQ(underlined(text, 2, 12), "\"b\"");
  EXPECT_EQ(underlined(text, 2, 17), "2");
  EXPECT_EQ(underlined(text, 3, 1), "}");
}

TEST(JsonText, UnderlinesWhatIsBeforeAnEndThatCameTooEarly) {
  EXPECT_EQ(underlined("{\"a\": 12\n\n", 3, 1), "12");
  EXPECT_EQ(underlined("{\"a\": 12", 9, 9), "12");
  EXPECT_EQ(underlined("   ", 1, 4), " ");
  EXPECT_EQ(underlined("", 1, 1), "");
}

TEST(JsonText, UnderlinesTheKeyOfAnObjectOrAList) {
  EXPECT_EQ(underlined("{\"a\": {\"b\": [1]}}", 1, 7), "\"a\"");
  EXPECT_EQ(underlined("{\"a\": {\"b\": [1]}}", 1, 13), "\"b\"");
  EXPECT_EQ(underlined("[{\"b\": 1}]", 1, 2), "{");
}

TEST(JsonText, SaysWhichKeysLeadToAPlace) {
  const QString text = R"({"blocks": {"main": {"crossed": ["a", "b"], "order": )";
  const auto place = [&](const char* at) { return json_place(text, text.indexOf(at) + 1); };
  EXPECT_EQ(place("blocks"), QStringList{"blocks"});
  EXPECT_EQ(place("\"b\""), (QStringList{"blocks", "main", "crossed", "1"}));
  EXPECT_EQ(place("order"), (QStringList{"blocks", "main", "order"}));
  EXPECT_EQ(json_place(text, text.size()), (QStringList{"blocks", "main", "order"}));
  EXPECT_EQ(json_place(text, 0), QStringList{});
}

TEST(JsonText, MatchesBracketsButNotThoseInTexts) {
  const QString text = R"({"a": ["]", {}]})";
  const auto of = [&](qsizetype cursor) { return bracket_pair(text, cursor); };
  EXPECT_EQ(of(0)->other, text.size() - 1);
  EXPECT_EQ(of(text.indexOf('[') + 1)->other, text.lastIndexOf(']'));
  EXPECT_EQ(of(text.size())->other, 0);
  EXPECT_FALSE(of(text.indexOf("]\"") + 1));
  EXPECT_FALSE(bracket_pair(u"{]", 1)->other);
  EXPECT_FALSE(bracket_pair(u"[1", 1)->other);
}

TEST(JsonText, FindsTheValueOfAnOutermostKeyOnly) {
  const QString text = R"({"consent": {"version": "7"}, "version": "1.0.0"})";
  const auto range = string_of_key(text, u"version");
  ASSERT_TRUE(range);
  EXPECT_EQ(text.mid(range->start, range->length), "\"1.0.0\"");
  EXPECT_FALSE(string_of_key(u"[1]", u"version"));
}

TEST(JsonText, TakesAStringThatIsNotEndedToTheEndOfItsLine) {
  const QString text = "{\"a\": \"never\n\"b\": \"\\\"\"}";
  QStringList strings{};
  for (const JsonToken& token : json_tokens(text)) {
    if (token.kind == JsonToken::Kind::string) strings.append(text.mid(token.start, token.length));
  }
  EXPECT_EQ(strings, (QStringList{"\"never", "\"\\\"\""}));
}

double luminance(const QColor& color) {
  const auto linear = [](double part) {
    return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double brighter = std::max(luminance(a), luminance(b));
  const double darker = std::min(luminance(a), luminance(b));
  return (brighter + 0.05) / (darker + 0.05);
}

// WCAG 2.1's relative luminance; `ground` lies behind the line of the cursor.
TEST(JsonColors, HaveTheContrastOfText) {
  Theme light{};
  light.panel = QColor("#FFFFFF");
  light.ground = QColor("#F4F5F7");
  Theme dark{};
  dark.dark = true;
  dark.panel = QColor("#1F2328");
  dark.ground = QColor("#16191D");
  for (const Theme& theme : {light, dark}) {
    for (const auto kind :
         {JsonToken::Kind::string, JsonToken::Kind::number, JsonToken::Kind::word}) {
      EXPECT_GE(contrast(json_color(kind, theme), theme.panel), 4.5);
      EXPECT_GE(contrast(json_color(kind, theme), theme.ground), 4.5);
    }
  }
}

}  // namespace
}  // namespace asperity
