// Renaming of everything that has a name in a protocol.

#include "protocols/editing/renaming.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "protocols/editing/edits.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/keys/names_in.h"
#include "protocols/keys/tables.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using testing::IsSupersetOf;

using Thing = std::pair<std::string, std::string>;  // registry and name

std::set<Thing> declared_in(std::string_view text) {
  std::set<Thing> declared{};
  for (const NameUse& use : names_in(nlohmann::json::parse(text)).uses) {
    if (use.is_declared) declared.emplace(use.registry, use.name);
  }
  return declared;
}

std::string renamed(const std::string& text, const Thing& thing, std::string_view after) {
  return changed(text, rename(JsonDocument(text, "a.json"), thing.first, thing.second, after));
}

/// nullopt for what the text does not declare: a level that is a force model.
std::optional<std::string> renamed_if_declared(const std::string& text, const Thing& thing,
                                               std::string_view after) {
  std::string other{};
  const std::string refusal = refusal_of([&] { other = renamed(text, thing, after); });
  if (refusal.find("does not declare") != std::string::npos) return {};
  EXPECT_EQ(refusal, "");
  return other;
}

std::string with_all_replaced(std::string text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;) {
    text.replace(at, from.size(), to);
  }
  return text;
}

class Renaming : public testing::TestWithParam<LibraryProtocol> {};

TEST_P(Renaming, OfAnythingIsUndoneByTheReverse) {
  const std::string text(GetParam().text);
  std::size_t count = 0;
  for (const Thing& thing : declared_in(text)) {
    const auto other = renamed_if_declared(text, thing, "another_name");
    if (!other) continue;
    ++count;
    EXPECT_NE(*other, text);
    EXPECT_EQ(with_all_replaced(*other, "another_name", thing.second), text) << thing.second;
    EXPECT_EQ(renamed(*other, {thing.first, "another_name"}, thing.second), text) << thing.second;
  }
  EXPECT_GT(count, 10U);
}

TEST_P(Renaming, OfEverythingGivesAValidProtocol) {
  std::string text(GetParam().text);
  const std::set<Thing> declared = declared_in(text);
  // From the end: levels before their factors, whose names are in the registries of levels. What is the same thing as
  // one before it has its new name already.
  for (auto thing = declared.rbegin(); thing != declared.rend(); ++thing) {
    text = renamed_if_declared(text, *thing, "the_" + thing->second).value_or(text);
  }
  EXPECT_EQ(declared_in(text).size(), declared.size());
  EXPECT_NO_THROW(read_protocol(text, "a.json", test::models_of_library())) << text;
}

INSTANTIATE_TEST_SUITE_P(All, Renaming, testing::ValuesIn(library_protocols()),
                         [](const auto& each) { return std::string(each.param.name); });

/// All references of a protocol; `texture_a` is also a level of two factors and the name of a body.
constexpr const char* kReferences = R"json({
  "kind": "discrimination",
  "x-note": {"textures": "texture_a"},
  "textures": {"texture_a": {"note": "texture_a"}, "b": {}},
  "bodies": {"texture_a": {"texture": "texture_a"}, "b": {}},
  "stimuli": {
    "s": {"model": "sinusoid", "texture": {"factor": "surface"}, "surface": {"factor": "surface"}},
    "t": {"model": {"factor": "model"}, "texture": "texture_a", "parameters": {"gain": {"factor": "speed"}, "mode": "texture_a"}}},
  "factors": {
    "surface": {"levels": ["texture_a", "b"], "hed": {"texture_a": "Item"}},
    "picture": {"levels": ["texture_a"]},
    "model": {"levels": ["sinusoid"]},
    "speed": {"levels": [1, 2]},
    "hand": {"levels": ["Left hand", "texture_a"]}},
  "explorations": {"stroke": {}},
  "questions": {"q": {"if": {"question": "q", "is": "texture_a"}}},
  "blocks": {
    "main": {
      "crossed": ["surface"], "drawn": ["speed"], "exclude": [{"surface": "texture_a", "hand": "Left hand"}],
      "listed": [{"hand": "texture_a"}], "derived": {"twice": "2 * speed - (speed/speed_2)"},
      "repetitions_of": [{"levels": {"twice": 4, "surface": "texture_a"}}], "anchor": {"speed": 1},
      "all_pairs": {"factor": "surface"}, "anchor_pair": ["b", "texture_a"],
      "maximum_in_a_row": {"speed": 1}, "minimum_distance": {"surface": 2},
      "fixed_positions": [{"position": 1, "levels": {"surface": "b"}}],
      "vary": {"parameter": "height_m", "factor": "height", "of": "comparison"},
      "presented": [{"role": "standard", "stimulus": "s", "with": {"hand": "Left hand"}, "item": "it"}],
      "exploration": "stroke",
      "questions": [
        {"name": "rough", "pictures": ["texture_a", "b"], "correct_factor": "picture"},
        {"name": "sure", "confidence_of": "rough"}]},
    "other": {"exploration": {"factor": "way"}, "equal_roughness": {"matched_in": "main"}}},
  "flow": [{"run": "main", "for_each": "hand"}, {"ask": ["q"]}],
  "groups": {"factor": "hand"},
  "estimation": {"factor": "surface", "condition": "hand", "values": {"b": 1}, "modulus": {"standard": "b", "value": 1}},
  "analysis": {"target": "it", "constructs": {"c": {"scales": ["rough", "sure"], "reverse_keyed": ["sure"]}}}
})json";

/// The lines of kReferences that the text has changed, as they are in it.
std::string lines_that_differ(const std::string& written) {
  const auto lines_of = [](const std::string& text) {
    std::vector<std::string> lines{};
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      lines.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    return lines;
  };
  const std::vector<std::string> before = lines_of(kReferences);
  const std::vector<std::string> now = lines_of(written);
  EXPECT_EQ(before.size(), now.size());
  std::string found{};
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
    if (now[i] != before[i]) found += now[i].substr(now[i].find_first_not_of(' ')) + '\n';
  }
  return found;
}
std::string changed_lines(const Thing& thing, std::string_view after) {
  return lines_that_differ(renamed(kReferences, thing, after));
}

TEST(RenamingOf, ATextureChangesTheLevelsAndTheBodyThatAreThisTexture) {
  const std::string expected =
      R"json("textures": {"cork": {"note": "texture_a"}, "b": {}},
"bodies": {"cork": {"texture": "cork"}, "b": {}},
"t": {"model": {"factor": "model"}, "texture": "cork", "parameters": {"gain": {"factor": "speed"}, "mode": "texture_a"}}},
"surface": {"levels": ["cork", "b"], "hed": {"cork": "Item"}},
"picture": {"levels": ["cork"]},
"crossed": ["surface"], "drawn": ["speed"], "exclude": [{"surface": "cork", "hand": "Left hand"}],
"repetitions_of": [{"levels": {"twice": 4, "surface": "cork"}}], "anchor": {"speed": 1},
"all_pairs": {"factor": "surface"}, "anchor_pair": ["b", "cork"],
{"name": "rough", "pictures": ["cork", "b"], "correct_factor": "picture"},
)json";
  EXPECT_EQ(changed_lines({"textures", "texture_a"}, "cork"), expected);
  EXPECT_EQ(changed_lines({"bodies", "texture_a"}, "cork"), expected);
  EXPECT_EQ(changed_lines({levels_of("surface"), "texture_a"}, "cork"), expected);
  EXPECT_EQ(changed_lines({levels_of("picture"), "texture_a"}, "cork"), expected);
  EXPECT_EQ(changed_lines({"textures", "b"}, "wood"),
            R"json("textures": {"texture_a": {"note": "texture_a"}, "wood": {}},
"bodies": {"texture_a": {"texture": "texture_a"}, "wood": {}},
"surface": {"levels": ["texture_a", "wood"], "hed": {"texture_a": "Item"}},
"all_pairs": {"factor": "surface"}, "anchor_pair": ["wood", "texture_a"],
"fixed_positions": [{"position": 1, "levels": {"surface": "wood"}}],
{"name": "rough", "pictures": ["texture_a", "wood"], "correct_factor": "picture"},
"estimation": {"factor": "surface", "condition": "hand", "values": {"wood": 1}, "modulus": {"standard": "wood", "value": 1}},
)json");
}

TEST(RenamingOf, AFactorChangesKeysBindingsAndFormulas) {
  EXPECT_EQ(
      changed_lines({"factors", "speed"}, "v"),
      R"json("t": {"model": {"factor": "model"}, "texture": "texture_a", "parameters": {"gain": {"factor": "v"}, "mode": "texture_a"}}},
"v": {"levels": [1, 2]},
"crossed": ["surface"], "drawn": ["v"], "exclude": [{"surface": "texture_a", "hand": "Left hand"}],
"listed": [{"hand": "texture_a"}], "derived": {"twice": "2 * v - (v/speed_2)"},
"repetitions_of": [{"levels": {"twice": 4, "surface": "texture_a"}}], "anchor": {"v": 1},
"maximum_in_a_row": {"v": 1}, "minimum_distance": {"surface": 2},
)json");
  EXPECT_EQ(
      changed_lines({"factors", "twice"}, "double_speed"),
      R"json("listed": [{"hand": "texture_a"}], "derived": {"double_speed": "2 * speed - (speed/speed_2)"},
"repetitions_of": [{"levels": {"double_speed": 4, "surface": "texture_a"}}], "anchor": {"speed": 1},
)json");
  EXPECT_EQ(changed_lines({"factors", "height"}, "depth"),
            R"json("vary": {"parameter": "height_m", "factor": "depth", "of": "comparison"},
)json");
}

TEST(RenamingOf, AnythingElseChangesItsReferences) {
  EXPECT_EQ(
      changed_lines({"answers", "rough"}, "roughness"),
      R"json({"name": "roughness", "pictures": ["texture_a", "b"], "correct_factor": "picture"},
{"name": "sure", "confidence_of": "roughness"}]},
"analysis": {"target": "it", "constructs": {"c": {"scales": ["roughness", "sure"], "reverse_keyed": ["sure"]}}}
)json");
  EXPECT_EQ(
      changed_lines({"items", "it"}, "chosen"),
      R"json("presented": [{"role": "standard", "stimulus": "s", "with": {"hand": "Left hand"}, "item": "chosen"}],
"analysis": {"target": "chosen", "constructs": {"c": {"scales": ["rough", "sure"], "reverse_keyed": ["sure"]}}}
)json");
  EXPECT_EQ(changed_lines({"blocks", "main"}, "test"),
            R"json("test": {
"other": {"exploration": {"factor": "way"}, "equal_roughness": {"matched_in": "test"}}},
"flow": [{"run": "test", "for_each": "hand"}, {"ask": ["q"]}],
)json");
  EXPECT_EQ(changed_lines({levels_of("hand"), "Left hand"}, "Right \"hand\""),
            R"json("hand": {"levels": ["Right \"hand\"", "texture_a"]}},
"crossed": ["surface"], "drawn": ["speed"], "exclude": [{"surface": "texture_a", "hand": "Right \"hand\""}],
"presented": [{"role": "standard", "stimulus": "s", "with": {"hand": "Right \"hand\""}, "item": "it"}],
)json");
  EXPECT_EQ(changed_lines({"questions", "q"}, "r"),
            R"json("questions": {"r": {"if": {"question": "r", "is": "texture_a"}}},
"flow": [{"run": "main", "for_each": "hand"}, {"ask": ["r"]}],
)json");
  EXPECT_EQ(changed_lines({"textures", "b"}, "b"), "");
}

TEST(RenamingOf, AThingTakesTheNameThatAReferenceStates) {
  const std::string text =
      R"({"blocks": {"main_2": {}}, "flow": [{"run": "main_2"}, {"run": "main"}]})";
  EXPECT_EQ(renamed(text, {"blocks", "main_2"}, "main"),
            R"({"blocks": {"main": {}}, "flow": [{"run": "main"}, {"run": "main"}]})");
}

TEST(RenamingOf, WhatIsTakenOrNotDeclaredIsRefused) {
  const auto refusal = [](const Thing& thing, std::string_view after) {
    return refusal_of([&] { renamed(kReferences, thing, after); });
  };
  EXPECT_EQ(refusal({"textures", "texture_a"}, "b"),
            "a.json:4:57: error: the name \"b\" is used here; choose another name (/textures/b)");
  EXPECT_EQ(refusal({"textures", "texture_a"}, "Cork"),
            "a.json:4:29: error: \"Cork\" is not a name: use lower-case letters, digits and "
            "underscores, starting with a letter (/textures/texture_a)");
  EXPECT_EQ(refusal({levels_of("model"), "sinusoid"}, "wave"),
            "a.json:12:26: error: the protocol does not declare \"sinusoid\" in force models, so "
            "that it cannot be renamed (/factors/model/levels/0)");
  EXPECT_EQ(
      refusal({"factors", "way"}, "w"),
      "a.json:1:1: error: the protocol does not declare \"way\" in factors, so that it cannot "
      "be renamed");
}

TEST(ReplacingOf, ALevelLeavesWhatItIs) {
  const auto changed_by = [](const std::string& registry, const char* name, const char* after) {
    const JsonDocument protocol(kReferences, "a.json");
    return lines_that_differ(
        changed(kReferences, rename_or_replace(protocol, registry, name, after)));
  };
  EXPECT_EQ(changed_by(levels_of("picture"), "texture_a", "b"),
            R"json("picture": {"levels": ["b"]},
)json");
  EXPECT_EQ(changed_by(levels_of("model"), "sinusoid", "height_map"),
            R"json("model": {"levels": ["height_map"]},
)json");
  EXPECT_EQ(changed_by(levels_of("picture"), "texture_a", "cork"),
            R"json("picture": {"levels": ["cork"]},
)json")
      << "the check reports that there is no such texture";
}

// The reference was written before the level.
TEST(RenamingOf, ALevelToTheNameOfAReferenceWithoutOneIsPossible) {
  const std::string text =
      R"({"factors": {"f": {"levels": ["visual"]}}, "groups": {"factor": "f"}, "flow": [{"screen": "s", "groups": ["sight"]}]})";
  const TextChanges changes = rename(JsonDocument(text, ""), levels_of("f"), "visual", "sight");
  EXPECT_EQ(changed(text, changes), replaced(text, "visual", "sight"));
  const std::string with_keys =
      R"({"factors": {"f": {"levels": ["visual"], "hed": {"visual": "See", "sight": "Look"}}}})";
  EXPECT_NE(refusal_of([&] {
              rename(JsonDocument(with_keys, ""), levels_of("f"), "visual", "sight");
            }).find("choose another name"),
            std::string::npos)
      << "the key would be there twice";
}

TEST(ProtocolNames, AreThoseThatTheTablesDeclareAndReferTo) {
  std::set<std::string> declared{};
  std::set<std::string> referred{};
  for (const NameUse& use : names_in(nlohmann::json::parse(kReferences)).uses) {
    (use.is_declared ? declared : referred).insert(use.registry);
  }
  EXPECT_EQ(declared, (std::set<std::string>{
                          "answers", "blocks", "bodies", "explorations", "factors", "items",
                          "levels of hand", "levels of model", "levels of picture",
                          "levels of surface", "questions", "stimuli", "textures"}));
  // With the names that belong to the program.
  declared.insert({"force models", "roles"});
  EXPECT_THAT(declared, IsSupersetOf(referred));
}

/// Registries that shapes refer to, and keys with names that refer to nothing.
struct NamesOfTables {
  std::set<std::string> registries{};
  std::set<std::string> others{};
  std::set<const KeyTable*> seen{};

  void add(const NameShape& name, std::string_view key) {
    (name.registry.empty() ? others.emplace(key) : registries.emplace(name.registry));
    if (!name.levels.empty()) registries.emplace(name.levels);
  }
  void add(const ValueShape& shape, std::string_view key) {
    if (const auto* const name = std::get_if<NameShape>(&shape)) {
      add(*name, key);
    } else if (const auto* const text = std::get_if<TextShape>(&shape)) {
      if (!text->name.registry.empty()) add(text->name, key);
    } else if (const auto* const list = std::get_if<ListShape>(&shape)) {
      add(*list->entry, key);
    } else if (const auto* const map = std::get_if<MapShape>(&shape)) {
      if (map->has_names) add(map->key, key);
      add(*map->entry, key);
    } else if (const auto* const bound = std::get_if<BoundShape>(&shape)) {
      add(*bound->value, key);
    } else if (const auto* const forms = std::get_if<FormsShape>(&shape)) {
      for (const ValueShape& form : forms->forms) add(form, key);
    } else if (const auto* const object = std::get_if<ObjectShape>(&shape)) {
      if (!seen.insert(object->table).second) return;
      for (const ProtocolKey& each : object->table->keys) add(each.shape, each.name);
    }
  }
};

TEST(ProtocolNames, HaveARegistryInTheTables) {
  NamesOfTables names{};
  names.add(ObjectShape{&kProtocolTable}, "");
  std::set<std::string> known{
      "answers", "force models", "groups of participants", "items", "levels", "roles", "tests"};
  // The name of the protocol, the value of an option, and what only has a heading in the report.
  std::set<std::string> alone{"name", "value", "constructs"};
  for (const char* map :
       {"blocks", "bodies", "explorations", "factors", "questions", "stimuli", "textures"}) {
    known.insert(map);
    alone.insert(map);
  }
  EXPECT_EQ(names.registries, known);
  EXPECT_EQ(names.others, alone);
}

}  // namespace
}  // namespace asperity
