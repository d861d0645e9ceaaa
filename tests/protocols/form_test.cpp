// The form of a protocol: its pages, its fields, and the texts after its edits.

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/form/form_edits.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"
#include "protocols/form/new_values.h"
#include "protocols/form/offered_names.h"
#include "protocols/keys/tables.h"
#include "tests/protocols/form_values.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

/// On how many pages each key is.
std::map<std::string, int> pages_of_keys(std::string_view of) {
  std::map<std::string, int> counts{};
  for (const FormPage& page : form_pages()) {
    for (const PagePart& part : page.parts) {
      if (of.empty()) {
        if (!part.of_entries.empty() && !part.are_left_out) continue;  // an excerpt of the objects
        ++counts[std::string(part.key)];
      } else if (part.key == of) {
        for (const ProtocolKey& key : kBlockTable.keys) {
          counts[std::string(key.name)] += has_key(part, key.name) ? 1 : 0;
        }
      }
    }
  }
  return counts;
}

TEST(FormPages, HaveEveryKeyOfAProtocolOnce) {
  std::map<std::string, int> counts = pages_of_keys({});
  for (const std::string_view key : keys_of_files()) ++counts[std::string(key)];
  for (const ProtocolKey& key : kProtocolTable.keys) {
    EXPECT_EQ(counts[std::string(key.name)], 1) << key.name;
  }
  EXPECT_EQ(counts.size(), kProtocolTable.keys.size());
}

TEST(FormPages, HaveEveryKeyOfABlockOnce) {
  const std::map<std::string, int> counts = pages_of_keys("blocks");
  for (const auto& [key, count] : counts) EXPECT_EQ(count, 1) << key;
  EXPECT_EQ(counts.size(), kBlockTable.keys.size());
}

TEST(FormPages, AreFoundByThePlaceOfAValue) {
  EXPECT_EQ(form_page_of("/title").id, "question");
  EXPECT_EQ(form_page_of("/textures/brick/code").id, "surfaces");
  EXPECT_EQ(form_page_of("/blocks/main/question/prompt").id, "task");
  EXPECT_EQ(form_page_of("/blocks/main/order").id, "order");
  EXPECT_EQ(form_page_of("/blocks/main").id, "task");
  EXPECT_EQ(form_page_of("").id, "question");
  EXPECT_EQ(form_page_of("/nothing").id, "question");
}

TEST(FormEntries, LeaveOutWhatAnotherKeyExcludes) {
  const auto names = [](const json& object) {
    std::string all{};
    for (const FormEntry& entry : entries_of(kStepTable, object, "/flow/0", {})) {
      all += std::string(entry.key->name) + (entry.is_present ? "+ " : "- ");
    }
    return all;
  };
  EXPECT_EQ(names({{"screen", "Welcome"}}), "screen+ if- groups- ");
  EXPECT_EQ(names({{"run", "main"}, {"for_each", "x"}}),
            "run+ for_each+ break_every_trials- break_every_contact_minutes- pause- ");
  EXPECT_EQ(names(json::object()), "screen- check- break- run- ask- ");
}

TEST(FormEntries, LeaveOutKeysThatDoNotApply) {
  json protocol = {{"kind", "rating"},
                   {"blocks",
                    {{"own", {{"question", json::object()}}},
                     {"pairs", {{"kind", "paired_comparison"}, {"question", json::object()}}}}}};
  const auto has = [&protocol](const KeyTable& table, const std::string& pointer,
                               std::string_view key) {
    const std::vector<FormEntry> entries =
        entries_of(table, protocol.at(json::json_pointer(pointer)), pointer, protocol);
    return std::ranges::any_of(entries,
                               [key](const FormEntry& entry) { return entry.key->name == key; });
  };
  EXPECT_FALSE(has(kOnlyQuestionTable, "/blocks/own/question", "tie"));
  EXPECT_TRUE(has(kOnlyQuestionTable, "/blocks/pairs/question", "tie"));
  EXPECT_FALSE(has(kBlockTable, "/blocks/pairs", "design"));
  EXPECT_FALSE(has(kProtocolTable, "", "estimation"));
  EXPECT_TRUE(has(kProtocolTable, "", "realism_standard")) << "of a block";
  protocol["kind"] = "discrimination";
  EXPECT_TRUE(has(kBlockTable, "/blocks/own", "design"));
  EXPECT_FALSE(has(kOnlyQuestionTable, "/blocks/own/question", "asks_for"));
  protocol["blocks"]["own"]["question"]["judgement"] = "comparison";
  EXPECT_TRUE(has(kOnlyQuestionTable, "/blocks/own/question", "asks_for"));
}

TEST(FormEntries, HaveTheUnitInWhichTheNameOfAKeyEnds) {
  const NumberShape length = displayed_shape({}, "/explorations/stroking/stroke_length_m/target");
  EXPECT_EQ(length.display.unit, "mm");
  EXPECT_EQ(displayed_number(length, "0.06"), "60");
  EXPECT_EQ(number_in_file(length, "2.3"), "0.0023");
  EXPECT_EQ(displayed_shape({}, "/explorations/stroking/speed_m_per_s/target").display.unit,
            "mm/s");
  EXPECT_EQ(displayed_shape({}, "/explorations/stroking/normal_force_N/target").unit, "N");
  EXPECT_EQ(displayed_shape({}, "/explorations/stroking/strokes/target").unit, "");
  const NumberShape stiffness = displayed_shape({}, "/stimuli/one/parameters/stiffness_N_per_m");
  EXPECT_EQ(stiffness.unit, "N/m");
  EXPECT_EQ(displayed_number(stiffness, "500"), "500") << "not a length";
  EXPECT_EQ(displayed_shape({}, "/stimuli/one/parameters/friction_damping_N_s_per_m").unit,
            "N s/m");
}

TEST(FormEntries, AreNamedByLabelsAndNames) {
  const json protocol = test::library_file("semantic_differential");
  const auto path = [&](const std::string& pointer) {
    std::string text{};
    for (const PathPart& part : path_of(protocol, pointer)) {
      text += (text.empty() ? "" : " › ") + part.text;
    }
    return text;
  };
  EXPECT_EQ(path("/blocks/ratings/questions/0/prompt"),
            "Blocks › ratings › Questions › rough › Question");
  EXPECT_EQ(path("/flow/0/screen"), "Flow › 1 › Text");
  EXPECT_EQ(path("/nothing/x"), "nothing › x");
}

TEST(FormEntries, AreSummarisedInTheOrderOfTheirTable) {
  const json scale = json::parse(
      R"({"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 7}})");
  const auto summary_at = [](const KeyTable& table, const json& value, const char* pointer) {
    return summary_of(ObjectShape{&table}, value, pointer);
  };
  EXPECT_EQ(summary_at(kListedQuestionTable, scale, "/q"), "How rough? · 1 · 7");
  EXPECT_EQ(summary_at(kExplorationTable, json::parse(R"({"speed_m_per_s": {"target": 0.08}})"),
                       "/explorations/slow"),
            "80 mm/s");
  EXPECT_EQ(summary_at(kStepTable, json::parse(R"({"screen": "Look.", "groups": ["visual"]})"),
                       "/flow/1"),
            "visual · Look.");
  const std::string summary =
      summary_at(kListedQuestionTable, {{"prompt", std::string(300, 'x') + "ä"}}, "/q");
  EXPECT_EQ(summary, std::string(120, 'x') + "…");
}

TEST(FormEdits, WriteTheObjectsAroundANewValue) {
  const std::string text = "{\n  \"title\": \"T\"\n}";
  const FormEdit edit = with_value(JsonDocument(text, ""), "/device/limits/latency_s", "0.01");
  EXPECT_EQ(json::parse(edit.text),
            json::parse(R"({"title": "T", "device": {"limits": {"latency_s": 0.01}}})"));
}

TEST(FormEdits, AddAnEntryLikeTheOneBefore) {
  const std::string text = test::library_text("semantic_differential");
  const JsonDocument protocol(text, "");
  const FormEdit scale = with_entry(protocol, "/blocks/ratings/questions");
  EXPECT_EQ(scale.pointer, "/blocks/ratings/questions/8");
  json expected = protocol.root().at("/blocks/ratings/questions/7"_json_pointer);
  expected["name"] = "wet_2";
  EXPECT_EQ(json::parse(scale.text).at(json::json_pointer(scale.pointer)), expected);
  const FormEdit texture = with_entry(protocol, "/textures");
  EXPECT_EQ(texture.pointer, "/textures/cones_35_2");
  const FormEdit step = with_entry(protocol, "/flow", "break");
  EXPECT_EQ(json::parse(step.text).at(json::json_pointer(step.pointer)),
            json::parse(R"({"break": {"minimum_s": 0.0}})"));
}

TEST(FormEdits, RenameWithAllReferences) {
  const std::string text = test::library_text("semantic_differential");
  const std::string renamed =
      with_name(JsonDocument(text, ""), "/textures/cones_05", Named::by_key, "fine_cones").text;
  EXPECT_EQ(renamed.find("\"cones_05\""), std::string::npos);
  EXPECT_EQ(
      with_name(JsonDocument(renamed, ""), "/textures/fine_cones", Named::by_key, "cones_05").text,
      text);
  EXPECT_NE(refusal_of([&] {
              with_name(JsonDocument(text, ""), "/textures/cones_05", Named::by_key, "metal");
            }).find("choose another name"),
            std::string::npos);
}

TEST(FormEdits, AddASurfaceWithAnItemOfItsOwn) {
  const std::string text =
      R"({"stimuli": {"s": {}}, "blocks": {"a": {"presented": [{"stimulus": "s", "item": "one"}]}}})";
  const FormEdit surface = with_entry(JsonDocument(text, ""), "/blocks/a/presented");
  EXPECT_EQ(json::parse(surface.text)["blocks"]["a"]["presented"][1],
            json::parse(R"({"stimulus": "s", "item": "one_2"})"));
}

TEST(FormEdits, AddAValueForAKeyThatWasChosen) {
  const std::string text =
      R"({"factors": {"f": {"levels": [1]}, "g": {"levels": [2]}}, "blocks": {"a": {"maximum_in_a_row": {"f": 3}}}})";
  const FormEdit edit = with_entry(JsonDocument(text, ""), "/blocks/a/maximum_in_a_row", "g");
  EXPECT_EQ(json::parse(edit.text)["blocks"]["a"]["maximum_in_a_row"],
            json::parse(R"({"f": 3, "g": 1})"));
  // Without one, the copy is under the first free name that the keys can have.
  EXPECT_EQ(with_entry(JsonDocument(text, ""), "/blocks/a/maximum_in_a_row").text,
            replaced(edit.text, "\"g\": 1", "\"g\": 3"));
}

TEST(FormEdits, TakeNoCommentForAnEntry) {
  const std::string text =
      R"({"textures": {"brick": {"code": "T1"}, "$comment": "mine", "x-note": 1}})";
  const FormEdit edit = with_entry(JsonDocument(text, ""), "/textures");
  EXPECT_EQ(edit.pointer, "/textures/brick_2");
  EXPECT_EQ(json::parse(edit.text)["textures"]["brick_2"], json::parse(R"({"code": "T2"})"));
}

TEST(FormEdits, StateANameThatIsAbsent) {
  const std::string text = R"({"blocks": {"a": {"vary": {"parameter": "amplitude_m"}}}})";
  const FormEdit edit =
      with_name(JsonDocument(text, ""), "/blocks/a/vary/factor", Named::by_value, "amplitude");
  EXPECT_EQ(edit.text,
            R"({"blocks": {"a": {"vary": {"parameter": "amplitude_m", "factor": "amplitude"}}}})");
}

TEST(FormEdits, AddTheFirstReferenceThatIsMissing) {
  const std::string text = R"({"questions": {"age": {}, "sex": {}}, "flow": [{"ask": ["sex"]}]})";
  EXPECT_EQ(json::parse(with_entry(JsonDocument(text, ""), "/flow/0/ask").text)["flow"][0]["ask"],
            json::parse(R"(["sex", "age"])"));
}

/// The levels of the factor f after one was added.
std::string levels_after_adding(const std::string& levels) {
  const std::string text = R"({"factors": {"f": {"levels": )" + levels + "}}}";
  const FormEdit edit = with_entry(JsonDocument(text, ""), "/factors/f/levels");
  return json::parse(edit.text)["factors"]["f"]["levels"].dump();
}

TEST(FormEdits, AddALevelThatIsNotInTheList) {
  EXPECT_EQ(levels_after_adding("[1]"), "[1,2]");
  EXPECT_EQ(levels_after_adding("[5, 10, 15]"), "[5,10,15,20]");
  EXPECT_EQ(levels_after_adding("[0.1, 0.2]"), "[0.1,0.2,0.3]");
  EXPECT_EQ(levels_after_adding("[3, 2, 1]"), "[3,2,1,0]");
  EXPECT_EQ(levels_after_adding("[1, 3, 2]"), "[1,3,2,0]") << "1 is a level";
  EXPECT_EQ(levels_after_adding("[2, 2]"), "[2,2,3]");
  EXPECT_EQ(levels_after_adding("[-1e308, 1e308]"), "[-1e+308,1e+308,1e+308]") << "there is none";
  EXPECT_EQ(levels_after_adding(R"(["haptic"])"), R"(["haptic","haptic_2"])");
  EXPECT_EQ(levels_after_adding(R"(["haptic", "haptic_2"])"),
            R"(["haptic","haptic_2","haptic_3"])");
  EXPECT_EQ(levels_after_adding(R"(["group_1", "group_2"])"), R"(["group_1","group_2","group_3"])");
  EXPECT_EQ(levels_after_adding(R"(["cones_35"])"), R"(["cones_35","cones_35_2"])");
  EXPECT_EQ(levels_after_adding("[]"), "[0.0]");
}

TEST(FormEdits, DuplicateALevelUnderAnotherName) {
  const std::string text = R"({"factors": {"f": {"levels": ["a", "b"]}, "g": {"levels": [1, 2]}}})";
  EXPECT_EQ(
      json::parse(
          with_copy(JsonDocument(text, ""), "/factors/f/levels/0").text)["factors"]["f"]["levels"],
      json::parse(R"(["a", "a_2", "b"])"));
  EXPECT_EQ(
      json::parse(
          with_copy(JsonDocument(text, ""), "/factors/g/levels/0").text)["factors"]["g"]["levels"],
      json::parse("[1, 3, 2]"));
}

TEST(FormEdits, AddATextureThatIsNotALevel) {
  json protocol = test::library_file("semantic_differential");
  json& levels = protocol["factors"]["texture"]["levels"];
  const std::size_t all = levels.size();
  levels.erase(1);
  const std::string second =
      test::library_file("semantic_differential")["factors"]["texture"]["levels"][1];
  const auto added = [](const json& file) {
    const FormEdit edit = with_entry(JsonDocument(file.dump(), ""), "/factors/texture/levels");
    return json::parse(edit.text)["factors"]["texture"]["levels"].back().get<std::string>();
  };
  EXPECT_EQ(added(protocol), second);
  levels.push_back(second);
  ASSERT_EQ(levels.size(), all);
  EXPECT_EQ(added(protocol), second + "_2");
}

TEST(FormEdits, AddOnlyWhatAListCanHave) {
  const std::string text = R"({"factors": {"f": {"levels": [1, 2.5]}}, "groups": {"factor": "f"},
    "blocks": {"a": {"anchor_at": ["end"]}},
    "flow": [{"screen": "1", "groups": ["1"]}, {"screen": "2"}]})";
  const FormEdit group = with_entry(JsonDocument(text, ""), "/flow/0/groups");
  EXPECT_EQ(json::parse(group.text)["flow"][0]["groups"], json::parse(R"(["1", "2.5"])"));
  EXPECT_NE(refusal_of([&] {
              with_entry(JsonDocument(group.text, ""), "/flow/0/groups");
            }).find("every possible entry is in this list already"),
            std::string::npos);
  const FormEdit groups =
      with_new_value(JsonDocument(text, ""), "/flow/1/groups", *kStepTable.find("groups"));
  EXPECT_EQ(json::parse(groups.text)["flow"][1]["groups"], json::parse(R"(["2.5"])"))
      << "the one with the fewest texts";
  const FormEdit place = with_entry(JsonDocument(text, ""), "/blocks/a/anchor_at");
  EXPECT_EQ(json::parse(place.text)["blocks"]["a"]["anchor_at"],
            json::parse(R"(["end", "start"])"));
}

// Groups that are added begin with a valid state in every protocol.
TEST(FormEdits, AddGroupsWithAFactor) {
  int added = 0;
  for (const LibraryProtocol& library : library_protocols()) {
    const std::string text(library.text);
    const JsonDocument protocol(text, "");
    if (protocol.root().contains("groups")) continue;
    const FormEdit edit = with_new_value(protocol, "/groups", *kProtocolTable.find("groups"));
    EXPECT_EQ(edit.pointer, "/groups");
    EXPECT_NO_THROW(test::valid(json::parse(edit.text), test::models_of_library())) << library.name;
    ++added;
  }
  EXPECT_GT(added, 10);
}

TEST(FormEdits, AddAFactorOfGroups) {
  const std::string text = R"({"factors": {"group": {"levels": [1]}}, "groups": {"factor": ""}})";
  const FormEdit edit = with_factor_of_groups(JsonDocument(text, ""));
  EXPECT_EQ(edit.pointer, "/factors/group_2");
  EXPECT_EQ(json::parse(edit.text), json::parse(R"({
    "factors": {"group": {"levels": [1]}, "group_2": {"levels": ["group_1", "group_2"]}},
    "groups": {"factor": "group_2"}})"));
}

TEST(FormEdits, RemoveSeveralEntriesAtOnce) {
  const std::string text = R"({"flow": [{"a": 1}, {"b": 2}, {"c": 3}], "x": 1})";
  const std::array<std::string, 3> pointers{"/flow/0", "/x", "/flow/2"};
  EXPECT_EQ(without(JsonDocument(text, ""), pointers).text, R"({"flow": [{"b": 2}]})");
  const std::array<std::string, 3> nested{"/flow/1", "/flow/1/b", "/flow/2"};
  EXPECT_EQ(without(JsonDocument(text, ""), nested).text, R"({"flow": [{"a": 1}], "x": 1})");
  const std::array<std::string, 3> all{"/flow/0", "/flow/1", "/flow/2"};
  EXPECT_EQ(without(JsonDocument(text, ""), all).text, R"({"flow": [], "x": 1})");
}

std::vector<std::string> entries_of_names_in(const JsonDocument& protocol,
                                             const std::vector<std::string>& pointers) {
  return entries_naming(protocol, names_in(protocol.root()), pointers);
}

TEST(FormEdits, KnowTheEntriesOfListsThatAreGoneWithAName) {
  const JsonDocument protocol(test::library_text("attributes_of_textures"), "");
  const auto without_texture = entries_of_names_in(protocol, {"/textures/metal"});
  EXPECT_THAT(without_texture,
              ElementsAre("/factors/texture/levels/0", "/blocks/recognition/question/pictures/0"));
  EXPECT_THAT(entries_of_names_in(protocol, {"/blocks/recognition"}), ElementsAre("/flow/11"))
      << "a block without a run";
  EXPECT_THAT(entries_of_names_in(protocol, {"/factors/texture/levels/0"}), IsEmpty())
      << "the texture stays without the level";
}

TEST(FormEdits, RemoveListedTrialsWithATextureAndNoStepThatDoesSomethingElse) {
  const JsonDocument differential(test::library_text("semantic_differential"), "");
  EXPECT_THAT(entries_of_names_in(differential, {"/textures/metal"}),
              ElementsAre("/factors/texture/levels/0", "/blocks/range/listed/2"));
  const JsonDocument sweep(test::library_text("roughness_speed"), "");
  const std::string factor = "/factors/speed";
  ASSERT_TRUE(sweep.root().contains(json::json_pointer(factor)));
  for (const std::string& entry : entries_of_names_in(sweep, {factor})) {
    EXPECT_FALSE(entry.starts_with("/flow")) << entry << ": the run of a block for each speed";
  }
}

TEST(FormEdits, NameAListedTrialOnceThatHasATextureTwice) {
  json file = json::parse(test::library_text("map_of_textures"));
  json& block = file["blocks"]["familiarisation"];
  block.erase("crossed");
  block.erase("drawn");
  block["listed"] = json::parse(R"([{"familiar_1": "metal", "familiar_2": "metal"}])");
  const std::string text = file.dump();
  const auto entries = entries_of_names_in(JsonDocument(text, ""), {"/textures/metal"});
  EXPECT_EQ(std::ranges::count(entries, "/blocks/familiarisation/listed/0"), 1);
}

TEST(FormEdits, GiveACopiedTextureItsOwnCode) {
  const std::string text = test::library_text("semantic_differential");
  const FormEdit edit = with_copy(JsonDocument(text, ""), "/textures/brick");
  const json copy = json::parse(edit.text)[json::json_pointer(edit.pointer)];
  EXPECT_EQ(copy["code"], "T11");
  EXPECT_EQ(copy["height_field"], "stimuli/brick.png");
}

TEST(FormEdits, RemoveTheTestsOfABlockWithIt) {
  const std::string text = test::library_text("attributes_of_textures");
  const JsonDocument protocol(text, "");
  const json one = json::parse(with_removed(protocol, {"/blocks/recognition"}).text);
  EXPECT_EQ(one["analysis"]["family"], json::array({"ratings"}));
  EXPECT_EQ(one["flow"].size(), protocol.root()["flow"].size() - 1);
  const json none =
      json::parse(with_removed(protocol, {"/blocks/recognition", "/blocks/ratings"}).text);
  EXPECT_EQ(none["analysis"], json::object());
}

TEST(FormEdits, KeepTheEntriesOfANameThatAnotherValueDeclaresToo) {
  const JsonDocument protocol(test::library_text("semantic_differential"), "");
  const std::string practised = "/blocks/range/questions/0";
  const std::string rated = "/blocks/ratings/questions/0";
  EXPECT_THAT(entries_of_names_in(protocol, {rated}), IsEmpty());
  EXPECT_THAT(entries_of_names_in(protocol, {practised, rated}),
              ElementsAre("/analysis/constructs/coarseness/scales/0"));
}

TEST(OfferedNames, AreOfMainBlocksOnly) {
  const auto offered = [](const char* protocol, const NameShape& shape) {
    return offered_names(names_of_form(JsonDocument(test::library_text(protocol), "")), shape);
  };
  constexpr NameShape kScale{.registry = kAnswerNames, .among = kRatedScales};
  constexpr NameShape kItem{.registry = kItemNames, .among = kChosenItems};
  EXPECT_THAT(offered("semantic_differential", kScale), testing::SizeIs(8));
  EXPECT_THAT(offered("improved_selection", kItem), testing::Not(IsEmpty()));
  EXPECT_THAT(offered("improved_selection", kScale), IsEmpty()) << "nothing is rated";
}

// What a form writes for a new key has the form of the key.
TEST(NewValues, HaveTheFormOfTheirShape) {
  const json protocol = test::library_file("semantic_differential");
  const ProtocolNames names = names_in(protocol);
  for (const test::ShownValue& shown : test::values_of_form(protocol)) {
    const auto* const typed = std::get_if<TextShape>(&shown.shape);
    if (shown.is_present || (typed != nullptr && !typed->pattern.empty())) continue;
    if (shown.pointer == "/groups") continue;  // every factor is set by a block
    const json value = json::parse(new_value(shown.shape, names).dump());
    const ValidPart part = valid_part(value, shown.shape, "", shown.pointer);
    for (const FormProblem& problem : part.problems) {
      if (problem.message.english().find("empty") != std::string::npos)
        continue;  // a text that the author has to write
      ADD_FAILURE() << shown.pointer << ": " << problem.message.english() << " " << value.dump();
    }
  }
}

// Groups begin with a factor that can be theirs, or with none.
TEST(NewValues, HaveAFactorOfGroupsThatNoBlockSets) {
  json protocol = test::library_file("semantic_differential");
  const ProtocolKey& groups = *kProtocolTable.find("groups");
  EXPECT_EQ(json::parse(new_value(groups.shape, names_in(protocol)).dump()),
            (json{{"factor", ""}}));
  protocol["factors"]["instruction"] = {{"levels", {"brief", "detailed"}}};
  EXPECT_EQ(json::parse(new_value(groups.shape, names_in(protocol)).dump()),
            (json{{"factor", "instruction"}}));
}

TEST(NewValues, HaveTheGroupWithTheFewestTexts) {
  const json protocol =
      json::parse(R"({"factors": {"f": {"levels": ["a", "b"]}}, "groups": {"factor": "f"},
    "flow": [{"screen": "1", "groups": ["a"]}, {"screen": "2"}]})");
  const ProtocolKey& groups = *kStepTable.find("groups");
  EXPECT_EQ(new_value(groups.shape, names_in(protocol)), json::parse(R"(["b"])"));
}

TEST(NewValues, AreNamedWithoutClashes) {
  EXPECT_EQ(free_name({}, "brick"), "brick");
  EXPECT_EQ(free_name({"brick", "brick_2"}, "brick"), "brick_3");
}

}  // namespace
}  // namespace asperity
