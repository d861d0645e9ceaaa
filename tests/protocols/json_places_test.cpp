// The bytes of every value of a text.

#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/file/json_document.h"
#include "protocols/file/library_protocols.h"

namespace asperity {
namespace {

using nlohmann::json;

std::string value_text(const JsonDocument& document, const std::string& pointer) {
  const JsonPlace place = document.place_of(pointer).value();
  return std::string(document.text().substr(place.value, place.end - place.value));
}

TEST(JsonPlaces, ContainTheCharactersOfAValueAndNoOthers) {
  const std::string text =
      "\n{\"a\" : -5.0e-05 ,\r\n\t\"b~/\":[1,[ ], {} ,\"\\\"}\" ,null],\"c\":{\"d\":true }}\n";
  const JsonDocument document(text, {});
  EXPECT_EQ(value_text(document, "/a"), "-5.0e-05");
  EXPECT_EQ(value_text(document, "/b~0~1"), "[1,[ ], {} ,\"\\\"}\" ,null]");
  EXPECT_EQ(value_text(document, "/b~0~1/0"), "1");
  EXPECT_EQ(value_text(document, "/b~0~1/1"), "[ ]");
  EXPECT_EQ(value_text(document, "/b~0~1/2"), "{}");
  EXPECT_EQ(value_text(document, "/b~0~1/3"), "\"\\\"}\"");
  EXPECT_EQ(value_text(document, "/b~0~1/4"), "null");
  EXPECT_EQ(value_text(document, "/c"), "{\"d\":true }");
  EXPECT_EQ(value_text(document, "/c/d"), "true");
  EXPECT_EQ(value_text(document, "") + '\n', text.substr(1));
  EXPECT_EQ(text.substr(document.place_of("/c/d")->key, 3), "\"d\"");
  EXPECT_EQ(document.place_of("/b~0~1/0")->key, document.place_of("/b~0~1/0")->value);
  EXPECT_FALSE(document.place_of("/b~0~1/5"));
}

TEST(JsonPlaces, OfANumberThatIsTheWholeTextEndWithIt) {
  const JsonDocument document("12e3", {});
  EXPECT_EQ(value_text(document, ""), "12e3");
}

TEST(JsonPlaces, ReadAgainGiveEveryValueOfTheLibrary) {
  for (const LibraryProtocol& each : library_protocols()) {
    const JsonDocument document(each.text, {});
    const std::function<void(const json&, const std::string&)> visit =
        [&](const json& value, const std::string& pointer) {
          const std::string text = value_text(document, pointer);
          EXPECT_EQ(json::parse(text), value) << pointer;
          EXPECT_EQ(text.find_last_not_of(" \t\r\n") + 1, text.size()) << pointer;
          if (!value.is_structured()) return;
          for (const auto& [key, member] : value.items()) visit(member, pointer_to(pointer, key));
        };
    visit(document.root(), "");
  }
}

}  // namespace
}  // namespace asperity
