// The shapes of values: the check of form, the valid part, and the schema of each, on parts of the format.

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/keys/schema_of.h"
#include "protocols/keys/valid_part.h"
#include "protocols/shapes/shape.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

json schema_at(const char* pointer) { return protocol_schema().at(json::json_pointer(pointer)); }

/// "POINTER: MESSAGE" of every problem, and the valid part.
std::pair<std::vector<std::string>, std::optional<json>> examined(const ValueShape& shape,
                                                                  const char* text) {
  ValidPart part = valid_part(json::parse(text), shape, "A value.", "/v");
  std::vector<std::string> problems{};
  for (const FormProblem& problem : part.problems) {
    problems.push_back(problem.pointer + ": " + problem.message.english());
  }
  return {std::move(problems), std::move(part.value)};
}

constexpr ValueShape kText = TextShape{.may_be_empty = true};
constexpr ValueShape kNumber = NumberShape{};
constexpr std::array<ValueShape, 2> kNumberOrText{kNumber, kText};
constexpr ValueShape kLevel = FormsShape{kNumberOrText};
constexpr ValueShape kBinding = BoundShape{&kLevel};
constexpr ValueShape kName = NameShape{"blocks"};
constexpr ValueShape kExtent = NumberShape{.above = 0.0, .maximum = 2.0};
constexpr ValueShape kExtents =
    ListShape{.entry = &kExtent, .meaning = "An extent.", .shortest = 2, .longest = 2};

TEST(KeyShapes, AreDecidedByTheTypeOfTheValue) {
  EXPECT_EQ(schema_of(kLevel, "A level: a number or a name."),
            schema_at("/properties/factors/additionalProperties/properties/levels/items"));
  EXPECT_THAT(examined(kLevel, "3").first, IsEmpty());
  EXPECT_THAT(examined(kLevel, R"("stone")").first, IsEmpty());
  EXPECT_THAT(
      examined(kLevel, "[3]").first,
      ElementsAre("/v: a list […] is not permitted here: write a number or text in quotation "
                  "marks. Expected here: A value."));
}

TEST(KeyShapes, CanBeBoundToAFactor) {
  const json schema = schema_at(
      "/properties/stimuli/additionalProperties/properties/parameters/additionalProperties");
  EXPECT_EQ(schema_of(kBinding, schema.at("description").get<std::string>()), schema);
  EXPECT_THAT(examined(kBinding, R"({"factor": "texture"})").first, IsEmpty());
  const auto [problems, value] = examined(kBinding, R"({"facto": "texture"})");
  EXPECT_THAT(problems, ElementsAre(HasSubstr("/v/facto: there is no key \"facto\" here; did you"),
                                    HasSubstr("/v/factor: the key \"factor\" is missing")));
  EXPECT_EQ(value, std::nullopt);
}

TEST(KeyShapes, OfNumbersHaveLimits) {
  constexpr ValueShape kOpen = NumberShape{.above = 0.0, .below = 1.0};
  EXPECT_THAT(examined(kOpen, "0.5").first, IsEmpty());
  EXPECT_THAT(examined(kOpen, "0").first, ElementsAre(HasSubstr("greater than 0")));
  EXPECT_THAT(examined(kOpen, "1").first, ElementsAre(HasSubstr("less than 1")));
  EXPECT_THAT(examined(kExtent, R"("wide")").first,
              ElementsAre("/v: \"wide\" is not permitted here: write a number (greater than 0 and "
                          "at most 2). Expected here: A value."));
}

TEST(KeyShapes, OfNumbersHaveAUnitForDisplay) {
  const NumberShape length{.unit = "m", .display = {.unit = "mm", .power = -3}};
  EXPECT_EQ(number_in_file(length, "2.3"), "0.0023");
  EXPECT_EQ(number_in_file(length, "5e-05"), "5e-8");
  EXPECT_EQ(displayed_number(length, "0.0023"), "2.3");
  EXPECT_EQ(displayed_number(length, "5e-05"), "0.05");
  EXPECT_EQ(number_in_file(length, "2,3"), std::nullopt);
  const NumberShape other{};
  EXPECT_EQ(number_in_file(other, "5e-05"), "5e-05");
  EXPECT_EQ(displayed_number(other, "1.50"), "1.50");
  const NumberShape angle{.unit = "rad", .display = {.unit = "°", .factor = 0.017453292519943295}};
  EXPECT_EQ(number_in_file(angle, "90"), "1.5707963267948966");
  EXPECT_EQ(displayed_number(angle, "1.5707963267948966"), "90");
  EXPECT_EQ(displayed_number(angle, "0.7871434926494426"), "45.1");
  EXPECT_EQ(number_in_file(angle, "45.1"), "0.7871434926494426");
  EXPECT_EQ(displayed_number(angle, "east"), std::nullopt);
}

TEST(KeyShapes, OfTextsCountCharacters) {
  constexpr ValueShape kShort = TextShape{.longest = 3};
  EXPECT_THAT(examined(kShort, R"("äöü")").first, IsEmpty());
  EXPECT_THAT(examined(kShort, R"("abcd")").first, ElementsAre(HasSubstr("longer than 3")));
  EXPECT_THAT(examined(kShort, R"("")").first, ElementsAre(HasSubstr("empty")));
  constexpr ValueShape kTag = TextShape{.longest = 9, .pattern = "^[a-z]{2}$"};
  EXPECT_THAT(examined(kTag, R"("de")").first, IsEmpty());
  EXPECT_THAT(examined(kTag, R"("deu")").first, ElementsAre(HasSubstr("the required form")));
  EXPECT_THAT(examined(kName, R"("Main")").first, ElementsAre(HasSubstr("the required form")));
}

TEST(KeyShapes, OfListsKeepTheValidEntries) {
  constexpr ValueShape kLists = ListShape{.entry = &kName, .shortest = 2, .is_distinct = true};
  EXPECT_EQ(examined(kLists, R"(["a", 1, "b"])").second, json::parse(R"(["a", "b"])"));
  EXPECT_EQ(examined(kLists, R"(["a", 1])").second, std::nullopt);
  EXPECT_THAT(examined(kLists, R"(["a"])").first, ElementsAre(HasSubstr("at least 2")));
  EXPECT_THAT(examined(kLists, R"(["a", "b", "a"])").first,
              ElementsAre("/v/2: \"a\" occurs twice in this list; keep one"));
  json schema = schema_at("/properties/surface/properties/extent_m");
  EXPECT_EQ(schema_of(kExtents, schema.at("description").get<std::string>()), schema);
}

TEST(KeyShapes, OfMapsKeepTheValidEntries) {
  constexpr ValueShape kMap = MapShape{.entry = &kNumber, .shortest = 1};
  const auto [problems, value] = examined(kMap, R"({"a": 1, "B": 2, "c": true, "x-d": 4})");
  EXPECT_THAT(problems, ElementsAre(HasSubstr("/v/B: \"B\" is not a name"),
                                    HasSubstr("/v/c: true is not permitted")));
  EXPECT_EQ(value, json::parse(R"({"a": 1})"));
  EXPECT_THAT(examined(kMap, R"({"$comment": "none"})").first, ElementsAre(HasSubstr("is empty")));
}

constexpr std::array<ProtocolKey, 3> kStepKeys{
    {{.name = "screen", .meaning = "A text.", .shape = kText},
     {.name = "run", .meaning = "A block.", .shape = kName},
     {.name = "for_each",
      .meaning = "A factor.",
      .shape = kName,
      .conditions = {KeyCondition{"run"}}}}};
constexpr std::array<std::string_view, 2> kDecidingKeys{"screen", "run"};
constexpr KeyTable kStep{.meaning = "A step.", .keys = kStepKeys, .deciding = kDecidingKeys};

TEST(KeyShapes, OfObjectsAreDecidedByOneKey) {
  const ValueShape shape = ObjectShape{&kStep};
  EXPECT_THAT(examined(shape, R"({"run": "main", "for_each": "a"})").first, IsEmpty());
  for (const char* const text : {"{}", R"({"screen": "a", "run": "b"})"}) {
    const auto [problems, value] = examined(shape, text);
    EXPECT_THAT(problems,
                ElementsAre("/v: write exactly one of the keys \"screen\" or \"run\" here"));
    EXPECT_EQ(value, std::nullopt);
  }
  const auto [problems, value] = examined(shape, R"({"screen": "a", "for_each": "b"})");
  EXPECT_THAT(problems, ElementsAre(HasSubstr("requires the key \"run\"")));
  EXPECT_EQ(value, json::parse(R"({"screen": "a"})"));
}

TEST(KeyShapes, OfObjectsPermitOtherKeysOnlyInOpenTables) {
  KeyTable open = kStep;
  open.is_open = true;
  EXPECT_TRUE(valid_part(json::parse(R"({"run": "a", "more": 1})"), open, "").problems.empty());
  EXPECT_FALSE(valid_part(json::parse(R"({"run": "a", "more": 1})"), kStep, "").problems.empty());
}

}  // namespace
}  // namespace asperity
