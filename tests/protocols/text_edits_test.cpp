// Edits of small texts, of which every byte is stated.

#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "protocols/editing/edits.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, 4> kOrder{"model", "amplitude_m", "period_m", "place"};

std::string set(const std::string& text, const std::string& pointer, std::string_view value) {
  return changed(text, set_value(JsonDocument(text, "a.json"), pointer, value));
}

std::string inserted(const std::string& text, const std::string& object, std::string_view key,
                     std::string_view value) {
  return changed(text, insert_member(JsonDocument(text, "a.json"), object, key, value, kOrder));
}

std::string inserted_at(const std::string& text, const std::string& array, std::size_t index,
                        std::string_view value) {
  return changed(text, insert_entry(JsonDocument(text, "a.json"), array, index, value));
}

std::string removed(const std::string& text, const std::string& pointer) {
  return changed(text, remove_entry(JsonDocument(text, "a.json"), pointer));
}

std::string moved(const std::string& text, const std::string& pointer, std::size_t index) {
  return changed(text, move_entry(JsonDocument(text, "a.json"), pointer, index));
}

std::string duplicated(const std::string& text, const std::string& pointer,
                       std::string_view key = {}) {
  return changed(text, duplicate_entry(JsonDocument(text, "a.json"), pointer, key));
}

TEST(TextEdits, SettingReplacesTheCharactersOfTheValue) {
  EXPECT_EQ(set("{\"a\" :\t5e-05 , \"b\": [1, 2]}", "/a", " 6E-05\n"),
            "{\"a\" :\t6E-05 , \"b\": [1, 2]}");
  EXPECT_EQ(set(R"({"b": [1, "x\"]", 3]})", "/b/1", json_string("µ \"y\"")),
            R"({"b": [1, "µ \"y\"", 3]})");
  EXPECT_EQ(set(R"({"b": [1, 2], "c": {} })", "/b", "0.10000000000000001"),
            R"({"b": 0.10000000000000001, "c": {} })");
}

TEST(TextEdits, SettingTheSameValueChangesNothing) {
  const std::string text = R"({"a": 5e-05, "b": {"c": 1.50, "d": "\u00b5"}})";
  const JsonDocument document(text, "a.json");
  EXPECT_TRUE(set_value(document, "/a", "0.00005").empty());
  EXPECT_TRUE(set_value(document, "/b/c", "1.5").empty());
  EXPECT_TRUE(set_value(document, "/b/d", json_string("µ")).empty());
  EXPECT_TRUE(set_value(document, "/b", R"({"d": "µ", "c": 1.5})").empty());
  EXPECT_FALSE(set_value(document, "/a", "0.00005000000000000001").empty());
}

TEST(TextEdits, AMemberIsInsertedInTheOrderOfItsTable) {
  const std::string text = R"({"model": "sinusoid", "x-note": 1, "place": 2})";
  EXPECT_EQ(inserted(text, "", "amplitude_m", "5e-05"),
            R"({"model": "sinusoid", "amplitude_m": 5e-05, "x-note": 1, "place": 2})");
  EXPECT_EQ(inserted(R"({"$comment": "", "place": 2})", "", "period_m", "1"),
            R"({"$comment": "", "period_m": 1, "place": 2})");
  EXPECT_EQ(inserted(R"({"place": 2})", "", "model", "1"), R"({"model": 1, "place": 2})");
  EXPECT_EQ(inserted(text, "", "unknown", "1"),
            R"({"model": "sinusoid", "x-note": 1, "place": 2, "unknown": 1})");
}

TEST(TextEdits, AMemberHasTheLineOfItsSiblings) {
  EXPECT_EQ(inserted("{\n  \"model\": 1,\n\n  \"place\": 2\n}\n", "", "period_m", "3"),
            "{\n  \"model\": 1,\n  \"period_m\": 3,\n\n  \"place\": 2\n}\n");
  EXPECT_EQ(inserted("{\r\n\t\"place\" : 2\r\n}", "", "model", "3"),
            "{\r\n\t\"model\" : 3,\r\n\t\"place\" : 2\r\n}");
  EXPECT_EQ(
      inserted("{\n  \"model\": 1, \"period_m\": 2,\n  \"place\": 3\n}", "", "amplitude_m", "4"),
      "{\n  \"model\": 1, \"amplitude_m\": 4, \"period_m\": 2,\n  \"place\": 3\n}");
  EXPECT_EQ(inserted(R"({"model":1,"a":{}})", "", "period_m", R"([1, {"b": 2}])"),
            R"({"model":1,"period_m":[1,{"b":2}],"a":{}})");
  EXPECT_EQ(inserted("{\n  \"a\": {\n  }\n}", "/a", "model", "1"),
            "{\n  \"a\": {\n    \"model\": 1\n  }\n}");
  EXPECT_EQ(inserted("{\n  \"a\": { }\n}", "/a", "model", "1"), "{\n  \"a\": { \"model\": 1 }\n}");
}

TEST(TextEdits, AValueThatIsTooLongForALineHasLines) {
  const std::string words = json_string(std::string(100, 'w'));
  const std::string value = R"({"text":)" + words + R"(,"list":[1.50,2],"none":{}})";
  EXPECT_EQ(inserted("{\n\t\"model\": 1\n}", "", "place", value),
            "{\n\t\"model\": 1,\n\t\"place\": {\n\t\t\"text\": " + words +
                ",\n\t\t\"list\": [1.50, 2],\n\t\t\"none\": {}\n\t}\n}");
  EXPECT_EQ(
      inserted("{\"model\": 1}", "", "place", value),
      "{\"model\": 1, \"place\": {\"text\": " + words + ", \"list\": [1.50, 2], \"none\": {}}}");
}

TEST(TextEdits, AnEntryIsInsertedAtItsIndex) {
  EXPECT_EQ(inserted_at("[1, 2]", "", 0, "3"), "[3, 1, 2]");
  EXPECT_EQ(inserted_at("[1, 2]", "", 1, "3"), "[1, 3, 2]");
  EXPECT_EQ(inserted_at("[1, 2 ]", "", 2, "3"), "[1, 2, 3 ]");
  EXPECT_EQ(inserted_at("[]", "", 0, "3"), "[3]");
  EXPECT_EQ(inserted_at("[\n  1\n]", "", 1, "3"), "[\n  1,\n  3\n]");
}

TEST(TextEdits, AnEntryIsRemovedWithItsCommaAndItsLine) {
  const std::string text = "{\n  \"a\": 1,\n  \"b\": [2] ,\n  \"c\": 3\n}";
  EXPECT_EQ(removed(text, "/a"), "{\n  \"b\": [2] ,\n  \"c\": 3\n}");
  EXPECT_EQ(removed(text, "/b"), "{\n  \"a\": 1 ,\n  \"c\": 3\n}");
  EXPECT_EQ(removed(text, "/c"), "{\n  \"a\": 1,\n  \"b\": [2]\n}");
  EXPECT_EQ(removed(text, "/b/0"), "{\n  \"a\": 1,\n  \"b\": [] ,\n  \"c\": 3\n}");
}

TEST(TextEdits, AnEmptyObjectIsTheSameAfterAnInsertionAndARemoval) {
  for (const std::string empty : {"{}", "{ }", "{\n}", "{\r\n\t}"}) {
    EXPECT_EQ(removed(inserted(empty, "", "model", "1"), "/model"), empty);
  }
}

TEST(TextEdits, AnEntryMovesAmongItsSiblings) {
  const std::string text = "[1,\n  22 , {\"a\": 3}, 4]";
  EXPECT_EQ(moved(text, "/0", 2), "[22,\n  {\"a\": 3} , 1, 4]");
  EXPECT_EQ(moved(text, "/3", 1), "[1,\n  4 , 22, {\"a\": 3}]");
  EXPECT_EQ(moved(text, "/2", 2), text);
  EXPECT_EQ(moved("{\n  \"a\": 1,\n  \"b\": 2\n}", "/b", 0), "{\n  \"b\": 2,\n  \"a\": 1\n}");
}

TEST(TextEdits, ACopyHasTheSameCharacters) {
  EXPECT_EQ(duplicated("{\n  \"a\": {\"b\":1.0},\n  \"c\": 2\n}", "/a", "a_2"),
            "{\n  \"a\": {\"b\":1.0},\n  \"a_2\": {\"b\":1.0},\n  \"c\": 2\n}");
  EXPECT_EQ(duplicated("[1.0, 2]", "/0"), "[1.0, 1.0, 2]");
}

TEST(TextEdits, AMemberOfAProtocolIsInsertedInTheOrderOfItsTable) {
  const std::string text = R"({
  "device": {"rate_Hz": 1000, "limits": {"x-note": 1, "latency_s": 1}},
  "textures": {"b": {"picture": "b.png"}},
  "blocks": {"main": {"vary": {"parameter": "a", "levels": {"lowest": 1, "step": 2}}, "exploration": {}}}
})";
  const auto inserted_by_table = [&text](const std::string& object, std::string_view key) {
    return changed(text, insert_member(JsonDocument(text, "a.json"), object, key, "3"));
  };
  EXPECT_EQ(inserted_by_table("", "bodies"),
            replaced(text, "\n  \"blocks\"", "\n  \"bodies\": 3,\n  \"blocks\""));
  EXPECT_EQ(inserted_by_table("/device", "force_limit_N"),
            replaced(text, "1000,", "1000, \"force_limit_N\": 3,"));
  EXPECT_EQ(inserted_by_table("/device/limits", "friction_N"),
            replaced(text, "\"latency_s\"", "\"friction_N\": 3, \"latency_s\""));
  EXPECT_EQ(inserted_by_table("/textures", "a"),
            replaced(text, "\"b.png\"}", "\"b.png\"}, \"a\": 3"));
  EXPECT_EQ(inserted_by_table("/textures/b", "code"),
            replaced(text, "\"picture\"", "\"code\": 3, \"picture\""));
  EXPECT_EQ(inserted_by_table("/blocks/main/vary/levels", "highest"),
            replaced(text, "\"lowest\": 1,", "\"lowest\": 1, \"highest\": 3,"));
  EXPECT_EQ(inserted_by_table("/blocks/main/exploration", "factor"),
            replaced(text, "\"exploration\": {", "\"exploration\": {\"factor\": 3"));
}

TEST(TextEdits, AreRefusedWithThePlace) {
  const std::string text = "{\n  \"a\": 1,\n  \"b\": [2]\n}";
  EXPECT_EQ(
      refusal_of([&] { set("{\n  \"a\": 1,\n}", "/a", "2"); }),
      "a.json:3:1: error: unexpected '}'; delete the comma before it: the last entry has none");
  EXPECT_EQ(refusal_of([&] { set(text, "/b/1", "2"); }),
            "a.json:3:8: error: there is no value here; name one that the text contains (/b/1)");
  EXPECT_EQ(
      refusal_of([&] { inserted(text, "", "a", "2"); }),
      "a.json:2:3: error: the key \"a\" occurs already in this object; choose another name (/a)");
  EXPECT_EQ(refusal_of([&] { inserted(text, "/a", "b", "2"); }),
            "a.json:2:8: error: this value has no entries; name an object {…} or a list […] (/a)");
  EXPECT_EQ(refusal_of([&] { inserted(text, "/b", "b", "2"); }),
            "a.json:3:8: error: this is a list; name an object {…} (/b)");
  EXPECT_EQ(refusal_of([&] { inserted_at(text, "", 0, "2"); }),
            "a.json:1:1: error: this is an object; name a list […]");
  EXPECT_EQ(refusal_of([&] { inserted_at(text, "/b", 2, "2"); }),
            "a.json:3:8: error: there is no position 2 here; choose one from 0 to 1 (/b)");
  EXPECT_EQ(refusal_of([&] { moved(text, "/a", 2); }),
            "a.json:1:1: error: there is no position 2 here; choose one from 0 to 1");
  EXPECT_EQ(
      refusal_of([&] { removed(text, ""); }),
      "a.json:1:1: error: the complete document is not an entry; name a member or an entry of "
      "a list");
}

TEST(TextEdits, ANewValueOrKeyIsRefusedAsAReaderRefusesIt) {
  const std::string text = R"({"a": 1})";
  EXPECT_EQ(refusal_of([&] { set(text, "/a", "2, 3"); }).substr(0, 25),
            "the new value:1:2: error:");
  EXPECT_EQ(
      refusal_of([&] { set(text, "/a", "1e400"); }),
      "the new value:1:1: error: the number '1e400' is too large to be read; write a smaller one");
  EXPECT_EQ(refusal_of([&] { set(text, "/a", std::string(100, '[')); }).substr(0, 26),
            "the new value:1:65: error:");
  EXPECT_EQ(refusal_of([&] { inserted(text, "", std::string(257, 'k'), "2"); }),
            "the new key:1:2: error: this key is longer than 256 bytes; shorten it");
  EXPECT_EQ(refusal_of([&] { json_string("\xff"); }), "a new text is not UTF-8; enter it again");
}

}  // namespace
}  // namespace asperity
