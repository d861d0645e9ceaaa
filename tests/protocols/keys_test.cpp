// The tables of keys: what is read of their objects, what is refused, and the agreement with schema and page.
//
// To write the present rows into docs/formats/protocol.md after a key or a test of a kind was meant to change, run
//   ASPERITY_STORE_PAGE=1 build/release/bin/asperity_protocols_tests --gtest_filter='Keys.AreThoseOfThePage'
// A new table needs a section with the two lines of its header and an empty line after them.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "protocols/design/json_pointer.h"
#include "protocols/keys/conditions.h"
#include "protocols/keys/page_of.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"
#include "protocols/kinds/experiment_kind.h"
#include "tests/protocols/both_checks.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::Pair;

/// A value for every key that tables declare.
const json kEverything = json::parse(R"({
  "$schema": "protocol-1.schema.json", "format": "asperity.protocol/1", "kind": "rating",
  "design": "improved", "name": "every_key", "version": "1.2.3", "title": "Every key",
  "language": "de-CH", "description": "For tests.", "license": "CC0",
  "authors": [{"name": "A. Author", "orcid": "0000-0002-1825-0097", "affiliation": "Here"}],
  "realism_standard": "memory",
  "questions": {
    "age": {
      "prompt": "How old?", "form": "number", "minimum": 18, "maximum": 99, "unit": "years",
      "optional": true},
    "hand": {"prompt": "Which?", "form": "choice", "options": ["left", {"value": "right", "text": "R"}]},
    "ease": {
      "prompt": "How easy?", "form": "scale",
      "scale": {"minimum": 1, "maximum": 7, "points": 7, "labels": ["hard", "easy"]},
      "if": {"question": "hand", "is": "left"}},
    "why": {"prompt": "Why?", "form": "line", "line": {"longest": 0.5}, "if": {"question": "hand", "in": ["left", 3]}},
    "what": {"prompt": "What?", "form": "text", "if": {"question": "hand", "includes": "left"}},
    "when": {"prompt": "When?", "form": "text", "if": {"question": "age", "at_least": 20, "at_most": 30}}},
  "blocks": {
    "main": {
      "kind": "discrimination", "phase": "practice", "crossed": ["a"],
      "exclude": [{"a": 2}], "derived": {"d": "a / 2"},
      "repetitions_of": [{"levels": {"a": 1}, "repetitions": 3}],
      "all_pairs": {"factor": "a", "in_both_orders": true, "with_identical": true, "parts": 2},
      "design": "yes_no", "repetitions": 2, "drawn": ["c"], "order": "fixed", "maximum_in_a_row": {"a": 2},
      "minimum_distance": {"a": 3}, "fixed_positions": [{"position": 2, "levels": {"a": 1}}],
      "presented": [{"role": "target", "stimulus": "rendered", "with": {"a": "x"}, "item": "it"}],
      "positions": "balanced",
      "questions": [
        {"name": "first", "prompt": "Which?", "pictures": ["stone", "metal"],
         "reshuffle_pictures": true, "allow_cannot_tell": true, "correct_factor": "a",
         "if": {"question": "z", "is": "y", "in": ["y", 3], "includes": "y", "at_least": 1, "at_most": 2}},
        {"name": "second", "prompt": "How long?", "line": {"longest": 0.5}},
        {"name": "third", "prompt": "Which?", "judgement": "comparison", "asks_for": "less",
         "options": [{"value": "y", "text": "Yes"}, {"value": "n", "text": "No"}]},
        {"name": "fourth", "prompt": "Sure?", "scale": {"minimum": 1}, "confidence_of": "third"},
        {"name": "fifth", "prompt": "Alike?", "scale": {}, "rates": "similarity"},
        {"name": "sixth", "prompt": "Which?", "tie": {"text": "Same"}},
        {"name": "seventh", "prompt": "?", "form": "number", "minimum": 1, "maximum": 9, "unit": "mm"}],
      "question_order": "shuffle", "question_layout": "one_page", "page_prompt": "All",
      "experimenter_prompt": "Sample {code}", "pictures_after_feeling": true, "allow_revisit": false,
      "exploration": {"factor": "e"},
      "arrangement": {
        "surfaces": "on_request", "visits": {"minimum": 2, "maximum": 3},
        "interval_s": {"shortest": 1, "longest": 2}, "exposure": {"strokes": 4},
        "phase": "drawn"},
      "equal_roughness": {"matched_in": "other"},
      "rove": {"stiffness_N_per_m": [400, 500], "friction": [0.1], "raised_m": [-0.01, 0.01]},
      "pause_before_trial_s": 1, "pause_between_surfaces_s": 2, "response_deadline_s": 3,
      "feedback": "correctness",
      "until": {"correct": 4, "of_last": 5, "maximum_trials": 20, "on_failure": "end_session"}},
    "tracks": {
      "listed": [{"a": 1, "b": "x"}], "all_pairs": {"factor": "a"},
      "vary": {
        "parameter": "gain_N", "factor": "g", "of": "comparison", "relative_to": "standard",
        "levels_percent": {"lowest": 1, "highest": 10, "step": 2, "scale": "ratio"}},
      "procedure": {
        "method": "psi", "target": 0.8,
        "prior": {
          "threshold": {"lowest": 1, "highest": 2, "count": 3},
          "slope": {"lowest": 2, "highest": 3, "count": 4},
          "lapse": {"lowest": 0, "highest": 0.1, "count": 5}},
        "marginalise": ["lapse"],
        "stop": {"trials": 40, "interval": {"ratio": 2.5, "minimum_trials": 10, "minimum_of_each": 4}},
        "tracks": [{}, {}], "timed_out": "incorrect", "catch_trials": {"type": "no_signal", "every": 10}},
      "anchor": {"a": 2}, "anchor_pair": [1, "x"], "anchor_at": ["end", "start"],
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "arrangement": {"interval_s": 0.4, "exposure": {"contact_s": 5}},
      "question": {"name": "only", "prompt": "Which?"}},
    "other": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "arrangement": {"surfaces": "side_by_side", "gap_m": 0.01, "axis": "y"},
      "vary": {"parameter": "gain_N", "of": "comparison", "levels": [1, 2]},
      "procedure": {
        "method": "transformed_up_down", "down": 2, "up": 3, "start": 4, "steps": [2], "steps_up": [1],
        "steps_down": [3, 4], "stop": {"trials": 40, "reversals": 8, "clipped_moves": 3},
        "tracks": [{"start": 5}, {}], "catch_trials": {"level": 7, "every": 10}},
      "question": {
        "name": "only", "prompt": "Which?", "pictures": ["stone", "metal"], "reshuffle_pictures": true,
        "allow_cannot_tell": true, "correct_factor": "a", "if": {"question": "z", "is": 4},
        "experimenter_prompt": "E", "pictures_after_feeling": true, "allow_revisit": true}},
    "constant": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "vary": {"parameter": "gain_N", "of": "comparison", "levels_difference": [3]},
      "procedure": {"method": "constant_stimuli", "repetitions": 3},
      "question": {
        "name": "only", "prompt": "Which?", "judgement": "comparison", "asks_for": "more",
        "options": [{"value": "y", "text": "Yes"}, {"value": "n", "text": "No"}]}},
    "outside": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "vary": {"parameter": "gain_N", "of": "comparison", "levels_decibels": [5, 6]},
      "procedure": {"method": "external", "settings": {"x-a": 1, "b": [2]}, "answer_within_s": 60},
      "question": {"name": "only", "prompt": "Alike?", "scale": {}, "rates": "dissimilarity", "confidence_of": "z"}},
    "paired": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "question": {"name": "only", "prompt": "Which?", "tie": {"text": "Same"}}},
    "drawn": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "question": {"name": "only", "prompt": "How long?", "line": {}}},
    "counted": {
      "presented": [{"stimulus": "matched"}], "exploration": "stroke",
      "question": {"name": "only", "prompt": "?", "form": "number", "minimum": 1, "maximum": 9, "unit": "mm"}}},
  "estimation": {
    "spacing": "s", "factor": "model", "predictor": "values", "values": {"2": 0.5},
    "unit": "mm", "modulus": {"standard": 2, "value": 10}, "normalisation": "standard",
    "condition": "tip"},
  "analysis": {
    "target": "stone", "family": ["pairs"], "equivalence_margin": 0.1,
    "exclude": {"more_catch_errors_than": 2},
    "constructs": {"feel": {"scales": ["ease", "roughness"], "reverse_keyed": ["ease"]}}},
  "flow": [
    {"screen": "Welcome.", "if": {"question": "hand", "is": "left"}, "groups": ["haptic"]}, {"check": "force_zero"},
    {"break": {
      "minimum_s": 30, "text": "Rest.", "zero_force": false,
      "drift_check": {"text": "Let go.", "tip_text": "Hold.", "duration_s": 3}}},
    {"run": "main", "for_each": "tip", "break_every_trials": 12, "break_every_contact_minutes": 1.5,
     "pause": {"minimum_s": 10}},
    {"ask": ["age", "hand"]}],
  "participants": {"planned": 12, "sessions": 2, "questions": ["age"]},
  "consent": {"version": "2", "statement": "I agree."},
  "textures": {
    "stone": {
      "code": "A", "height_field": "stimuli/stone.png", "picture": "stimuli/stone.jpg",
      "true_height_field": "stimuli/true.png", "assets": {"recording": "stimuli/stone.csv"},
      "spacing_m": 0.002, "note": "of a quarry",
      "prior": {"spectrum": [1, 2, 3, 4, 5, -1, -2, -3, -4, -5], "size": 0.5, "roughness": -0.5}},
    "$comment": "one of two"},
  "bodies": {
    "ball": {
      "mesh": "stimuli/ball.mesh", "shape": "cylinder", "size_m": [0.1, 0.2, 0.3],
      "diameter_m": 0.02, "length_m": 0.05, "axis": "x", "texture": "stone"}},
  "stimuli": {
    "rendered": {
      "model": {"factor": "model"}, "texture": "stone", "surface": "plate", "tool": {"factor": "held"},
      "parameters": {"stiffness": 3, "mode": "soft", "gain": {"factor": "gain"}},
      "equal_force": {"rms_N": 0.1, "band_low_Hz": 10, "band_high_Hz": 400},
      "material": {"stiffness_N_per_m": 700, "friction": 0.1}},
    "matched": {"model": "height_map", "equal_force": {"to_model": "bump_map"}}},
  "factors": {
    "model": {
      "levels": ["height_map", 2], "meaning": "The model.", "unit": "N",
      "hed": {"height_map": "Item"}}},
  "explorations": {
    "stroke": {
      "direction_rad": 1.5, "stroke_length_m": {"minimum": 0.01, "target": 0.02, "maximum": 0.03},
      "speed_m_per_s": {"target": 0.1}, "normal_force_N": {"maximum": 2}, "strokes": {"minimum": 2},
      "minimum_contact_s": 2, "maximum_contact_s": 20, "required_fraction_in_band": 0.8,
      "on_failure": "repeat_now", "maximum_repeats": 2, "guidance": "tones"}},
  "resume": {"screens": ["Welcome back."], "maximum_age_hours": 24, "practice_trials": 3},
  "counterbalance": "williams",
  "groups": {
    "factor": "training", "assigned": "permuted_blocks", "block_sizes": [4, 6],
    "seed": 9007199254740991},
  "observer": {
    "expectation": "prior", "gaussian_wavelength_m": 0.004, "deaf": true, "feature_noise": 0.2,
    "position_bias": 0.3, "lapse": 0.04, "magnitude_of": "held_tool", "exponent": 0.9,
    "effect": "decreases", "yes_above": 1.5, "different_above": 0.25, "unsure_within": 0.05},
  "environment": {
    "vision": "hand_occluded", "scene": {"visual_texture": "neutral"}, "pictures": {"show": "grey"},
    "speech": {"next": "speech/next.wav"}, "masking_noise": {"kind": "pink", "level_dBA": 60}},
  "instability": {"buzz_max": 0.4, "on": "repeat_now"},
  "surface": {
    "centre_m": [0.01, 0.02, 0.03], "extent_m": [0.06, 0.04], "tiling": "mirror", "edge": "wall",
    "edge_width_m": 0.01, "motion_scale": 2},
  "material": {"stiffness_N_per_m": 800, "friction": 0.5},
  "recording": {"every_tick": false},
  "device": {
    "rate_Hz": 2000, "force_limit_N": 3.5, "maximum_missed_deadlines": 1, "maximum_gaps_in_contact": 2,
    "maximum_lost_records": 3, "profile_maximum_age_days": 30, "refuse_rehearsal_warnings": true,
    "compute": "gpu", "input_only": true,
    "limits": {
      "rate_Hz": 1900, "lateness_p50_s": 0.1, "lateness_p99_s": 0.2, "lateness_max_s": 0.3,
      "missed_deadlines": 4, "position_noise_m": 1e-5, "friction_N": 0.25, "damping_N_s_per_m": 0,
      "position_resolution_m": 1e-4, "latency_s": 0.01, "moving_mass_kg": 0.1, "resonance_Hz": 20,
      "stiffness_N_per_m": 1000, "force_resolution_N": 0.02, "workspace_reached": 0.9,
      "$comment": "of the manual"},
    "x-serial": "12"}
})");

/// Calls `visit(table, value, pointer)` for every object of a table in a value with this shape.
using Visit = std::function<void(const KeyTable&, const json&, const std::string&)>;
void for_each_object(const ValueShape& shape, const json& value, const std::string& pointer,
                     const Visit& visit) {
  if (const auto* const object = std::get_if<ObjectShape>(&shape)) {
    visit(*object->table, value, pointer);
    for (const ProtocolKey& key : object->table->keys) {
      const std::string name(key.name);
      if (!value.is_object() || !value.contains(name)) continue;
      for_each_object(key.shape, value.at(name), pointer_to(pointer, name), visit);
    }
  } else if (const auto* const map = std::get_if<MapShape>(&shape)) {
    if (!value.is_object()) return;
    for (const auto& [name, entry] : value.items()) {
      if (!is_comment(name)) {
        for_each_object(*map->entry, entry, pointer_to(pointer, name), visit);
      }
    }
  } else if (const auto* const list = std::get_if<ListShape>(&shape)) {
    if (!value.is_array()) return;
    for (std::size_t i = 0; i < value.size(); ++i) {
      for_each_object(*list->entry, value[i], pointer_to(pointer, i), visit);
    }
  } else if (const auto* const several = std::get_if<FormsShape>(&shape)) {
    for (const ValueShape& form : several->forms) {
      const bool is_that = is_of_type(value, types_of(form).front());
      if (is_that) for_each_object(form, value, pointer, visit);
    }
  }
}

/// Every table but that of the protocol itself.
std::set<const KeyTable*> tables() {
  std::set<const KeyTable*> found{};
  for_each_object(ObjectShape{&kProtocolTable}, kEverything, "",
                  [&found](const KeyTable& table, const json&, const std::string& pointer) {
                    if (!pointer.empty() && !table.keys.empty()) found.insert(&table);
                  });
  return found;
}

Protocol read_of(const json& root, std::vector<std::string>* pointers = nullptr) {
  Protocol protocol{};
  for (const FormProblem& problem : read_keys(kProtocolTable, root, "", protocol)) {
    if (pointers != nullptr) pointers->push_back(problem.pointer);
  }
  return protocol;
}

std::string source_file(const std::string& path) {
  std::ifstream stream(std::string(ASPERITY_SOURCE_DIR) + '/' + path, std::ios::binary);
  EXPECT_TRUE(stream) << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Keys, OfEverythingHaveTheForm) {
  std::vector<std::string> pointers{};
  (void)read_of(kEverything, &pointers);
  EXPECT_THAT(pointers, IsEmpty());
  std::map<const KeyTable*, std::set<std::string>> stated{};
  for_each_object(ObjectShape{&kProtocolTable}, kEverything, "",
                  [&stated](const KeyTable& table, const json& object, const std::string&) {
                    for (const auto& [key, value] : object.items()) stated[&table].insert(key);
                  });
  for (const auto& [table, keys] : stated) {
    for (const ProtocolKey& key : table->keys) {
      const bool is_one_of_several = std::find(table->deciding.begin(), table->deciding.end(),
                                               key.name) != table->deciding.end();
      EXPECT_TRUE(is_one_of_several || keys.contains(std::string(key.name)))
          << table->meaning << ' ' << key.name;
    }
  }
}

TEST(Keys, OfTheDeviceGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  EXPECT_EQ(protocol.rate_Hz, 2000.0);
  EXPECT_EQ(protocol.force_limit_N, 3.5);
  EXPECT_EQ(protocol.maximum_missed_deadlines, 1);
  EXPECT_EQ(protocol.maximum_gaps_in_contact, 2);
  EXPECT_EQ(protocol.maximum_lost_records, 3);
  EXPECT_EQ(protocol.profile_maximum_age_days, 30.0);
  EXPECT_TRUE(protocol.refuses_rehearsal_warnings);
  EXPECT_TRUE(protocol.computes_on_gpu);
  EXPECT_TRUE(protocol.input_only);
  EXPECT_EQ(protocol.device_limits.size(), 15U);
  EXPECT_EQ(protocol.device_limits.at("friction_N"), 0.25);
}

TEST(Keys, OfTheSettingGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  EXPECT_EQ(protocol.vision, Vision::hand_occluded);
  EXPECT_EQ(protocol.scene, VisualTexture::neutral);
  EXPECT_TRUE(protocol.shows_pictures_in_grey);
  EXPECT_THAT(protocol.speech, ElementsAre(Pair("next", "speech/next.wav")));
  EXPECT_EQ(protocol.masking_noise.kind, Protocol::Noise::Kind::pink);
  EXPECT_EQ(protocol.masking_noise.level_dBA, 60.0);
  ASSERT_TRUE(protocol.instability);
  EXPECT_EQ(protocol.instability->buzz_max, 0.4);
  EXPECT_EQ(protocol.instability->on, InstabilityRule::OnExcess::repeat_now);
  EXPECT_EQ(protocol.patch.centre_m, glm::dvec3(0.01, 0.02, 0.03));
  EXPECT_EQ(protocol.patch.extent_m, glm::dvec2(0.06, 0.04));
  EXPECT_EQ(protocol.patch.tiling, Tiling::mirror);
  EXPECT_EQ(protocol.patch.edge, PatchEdge::wall);
  EXPECT_EQ(protocol.patch.edge_width_m, 0.01);
  EXPECT_EQ(protocol.patch.motion_scale, 2.0);
  EXPECT_EQ(protocol.material.stiffness_N_per_m, 800.0);
  EXPECT_EQ(protocol.material.friction, 0.5);
  EXPECT_FALSE(protocol.record);
}

TEST(Keys, OfParticipantsGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  EXPECT_EQ(protocol.planned_participants, 12);
  EXPECT_EQ(protocol.sessions, 2);
  EXPECT_THAT(protocol.participant_questions, ElementsAre("age"));
  EXPECT_EQ(protocol.consent_version, "2");
  EXPECT_EQ(protocol.consent_statement, "I agree.");
  ASSERT_TRUE(protocol.resume.screens);
  EXPECT_THAT(*protocol.resume.screens, ElementsAre("Welcome back."));
  EXPECT_EQ(protocol.resume.maximum_age_hours, 24.0);
  EXPECT_EQ(protocol.resume.practice_trials, 3);
  EXPECT_EQ(protocol.counterbalance, Protocol::Counterbalance::williams);
  ASSERT_TRUE(protocol.groups);
  EXPECT_EQ(protocol.groups->factor, "training");
  EXPECT_EQ(protocol.groups->assigned, Protocol::Groups::Assignment::permuted_blocks);
  EXPECT_THAT(protocol.groups->block_sizes, ElementsAre(4, 6));
  EXPECT_EQ(protocol.groups->seed, 9007199254740991U);
}

TEST(Keys, OfStimuliGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  ASSERT_EQ(protocol.textures.size(), 1U);
  const Texture& stone = protocol.textures.at("stone");
  EXPECT_EQ(stone.name, "stone");
  EXPECT_EQ(stone.code, "A");
  EXPECT_EQ(stone.height_field, "stimuli/stone.png");
  EXPECT_EQ(stone.picture, "stimuli/stone.jpg");
  EXPECT_EQ(stone.true_height_field, "stimuli/true.png");
  EXPECT_THAT(stone.assets, ElementsAre(Pair("recording", "stimuli/stone.csv")));
  EXPECT_EQ(stone.spacing_m, 0.002);
  EXPECT_EQ(stone.note, "of a quarry");
  ASSERT_TRUE(stone.prior);
  EXPECT_THAT(stone.prior->spectrum, ElementsAre(1, 2, 3, 4, 5, -1, -2, -3, -4, -5));
  EXPECT_EQ(stone.prior->size, 0.5);
  EXPECT_EQ(stone.prior->roughness, -0.5);
  const StimulusTemplate& rendered = protocol.stimuli.at("rendered");
  EXPECT_EQ(rendered.name, "rendered");
  EXPECT_EQ(rendered.model.factor, "model");
  EXPECT_FALSE(rendered.model.value);
  EXPECT_EQ(rendered.texture.value, "stone");
  EXPECT_EQ(rendered.surface.value, "plate");
  EXPECT_EQ(rendered.tool.factor, "held");
  EXPECT_EQ(rendered.parameters.at("stiffness").value, ParameterValue(3.0));
  EXPECT_EQ(rendered.parameters.at("mode").value, ParameterValue("soft"));
  EXPECT_EQ(rendered.parameters.at("gain").factor, "gain");
  EXPECT_EQ(rendered.equal_force,
            (EqualForce{.rms_N = 0.1, .band_low_Hz = 10.0, .band_high_Hz = 400.0}));
  EXPECT_EQ(rendered.stiffness_N_per_m, 700.0);
  EXPECT_EQ(rendered.friction, 0.1);
  EXPECT_EQ(protocol.stimuli.at("matched").equal_force, (EqualForce{.to_model = "bump_map"}));
  const Factor& model = protocol.factors.at("model");
  EXPECT_EQ(model.name, "model");
  EXPECT_THAT(model.levels, ElementsAre(Level("height_map"), Level(2.0)));
  EXPECT_EQ(model.meaning, "The model.");
  EXPECT_EQ(model.unit, "N");
  EXPECT_THAT(model.hed, ElementsAre(Pair("height_map", "Item")));
}

TEST(Keys, OfBodiesMakeTheirShape) {
  const auto body = [](const char* text) {
    Protocol protocol{};
    EXPECT_TRUE(valid_part(json::parse(text), kBodyTable, "").problems.empty()) << text;
    read_keys(kProtocolTable, {{"bodies", {{"it", json::parse(text)}}}}, "", protocol);
    return protocol.bodies.at("it");
  };
  const BodyDescription roll = body(
      R"({"shape": "cylinder", "diameter_m": 0.02, "length_m": 0.05, "axis": "y", "texture": "t"})");
  EXPECT_EQ(roll.name, "it");
  EXPECT_EQ(roll.axis, BodyAxis::y);
  EXPECT_EQ(roll.texture, "t");
  ASSERT_TRUE(roll.shape);
  EXPECT_EQ(std::get<CylinderShape>(*roll.shape).diameter_m, 0.02);
  EXPECT_EQ(std::get<CylinderShape>(*roll.shape).length_m, 0.05);
  const BodyDescription disc = body(R"({"shape": "disc", "diameter_m": 0.02})");
  EXPECT_DOUBLE_EQ(std::get<CylinderShape>(disc.shape.value()).length_m, 0.002);
  const BodyDescription plate = body(R"({"shape": "plate", "size_m": [0.1, 0.2, 0.01]})");
  EXPECT_EQ(std::get<PlateShape>(plate.shape.value()).size_m, glm::dvec3(0.1, 0.2, 0.01));
  const BodyDescription box = body(R"({"shape": "box", "size_m": [0.1, 0.2, 0.3]})");
  EXPECT_EQ(std::get<BoxShape>(box.shape.value()).size_m, glm::dvec3(0.1, 0.2, 0.3));
  const BodyDescription ball = body(R"({"shape": "sphere", "diameter_m": 0.01})");
  EXPECT_EQ(std::get<SphereShape>(ball.shape.value()).diameter_m, 0.01);
  const BodyDescription mesh = body(R"({"mesh": "a.mesh"})");
  EXPECT_EQ(mesh.mesh, "a.mesh");
  EXPECT_FALSE(mesh.shape);
}

TEST(Keys, OfExplorationsGoToTheirMembers) {
  const Exploration stroke = read_of(kEverything).explorations.at("stroke");
  EXPECT_EQ(stroke.name, "stroke");
  EXPECT_EQ(stroke.direction_rad, 1.5);
  EXPECT_EQ(stroke.stroke_length_m.minimum, 0.01);
  EXPECT_EQ(stroke.stroke_length_m.target, 0.02);
  EXPECT_EQ(stroke.stroke_length_m.maximum, 0.03);
  EXPECT_EQ(stroke.speed_m_per_s.target, 0.1);
  EXPECT_EQ(stroke.normal_force_N.maximum, 2.0);
  EXPECT_EQ(stroke.strokes.minimum, 2.0);
  EXPECT_EQ(stroke.minimum_contact_s, 2.0);
  EXPECT_EQ(stroke.maximum_contact_s, 20.0);
  EXPECT_EQ(stroke.required_fraction_in_band, 0.8);
  EXPECT_EQ(stroke.on_failure, Exploration::OnFailure::repeat_now);
  EXPECT_EQ(stroke.maximum_repeats, 2);
  EXPECT_EQ(stroke.guidance, Exploration::Guidance::tones);
}

TEST(Keys, OfTheHeadGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  EXPECT_EQ(protocol.kind, "rating");
  EXPECT_EQ(protocol.design, ProtocolDesign::improved);
  EXPECT_EQ(protocol.name, "every_key");
  EXPECT_EQ(protocol.version, "1.2.3");
  EXPECT_EQ(protocol.title, "Every key");
  EXPECT_EQ(protocol.language, "de-CH");
  EXPECT_EQ(protocol.description, "For tests.");
  EXPECT_EQ(protocol.license, "CC0");
  EXPECT_THAT(protocol.authors, ElementsAre("A. Author"));
  EXPECT_EQ(protocol.realism_standard, RealismStandard::memory);
}

TEST(Keys, OfQuestionsGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  const Question& age = protocol.questions.at("age");
  EXPECT_EQ(age.name, "age");
  EXPECT_EQ(age.prompt, "How old?");
  EXPECT_EQ(std::get<NumberForm>(age.form),
            (NumberForm{.minimum = 18.0, .maximum = 99.0, .unit = "years"}));
  EXPECT_TRUE(age.optional);
  EXPECT_FALSE(age.condition);
  const Question& hand = protocol.questions.at("hand");
  EXPECT_THAT(hand.options, ElementsAre(Option{.value = "left", .text = "left"},
                                        Option{.value = "right", .text = "R"}));
  const Question& ease = protocol.questions.at("ease");
  EXPECT_EQ(std::get<ScaleForm>(ease.form),
            (ScaleForm{.minimum = 1.0, .maximum = 7.0, .points = 7, .labels = {"hard", "easy"}}));
  EXPECT_EQ(ease.condition, (AnswerCondition{"hand", AnswerIsOneOf{{"left"}}}));
  EXPECT_EQ(protocol.questions.at("why").condition,
            (AnswerCondition{"hand", AnswerIsOneOf{{"left", 3.0}}}));
  EXPECT_EQ(protocol.questions.at("what").condition,
            (AnswerCondition{"hand", AnswerIncludes{"left"}}));
  EXPECT_EQ(protocol.questions.at("when").condition,
            (AnswerCondition{"age", AnswerWithin{20.0, 30.0}}));
}

TEST(Keys, OfTheFlowMakeItsSteps) {
  const std::vector<Protocol::Step> flow = read_of(kEverything).flow;
  ASSERT_EQ(flow.size(), 5U);
  const auto& screen = std::get<Protocol::Screen>(flow[0]);
  EXPECT_EQ(screen.text, "Welcome.");
  EXPECT_EQ(screen.condition, (AnswerCondition{"hand", AnswerIsOneOf{{"left"}}}));
  EXPECT_THAT(screen.groups, ElementsAre("haptic"));
  EXPECT_EQ(std::get<Protocol::Check>(flow[1]).what, Protocol::Check::What::force_zero);
  const auto& rest = std::get<Protocol::Break>(flow[2]);
  EXPECT_EQ(rest.minimum_s, 30.0);
  EXPECT_EQ(rest.text, "Rest.");
  EXPECT_FALSE(rest.zero_force);
  ASSERT_TRUE(rest.drift_check);
  EXPECT_EQ(rest.drift_check->text, "Let go.");
  EXPECT_EQ(rest.drift_check->tip_text, "Hold.");
  EXPECT_EQ(rest.drift_check->duration_s, 3.0);
  const auto& run = std::get<Protocol::Run>(flow[3]);
  EXPECT_EQ(run.block, "main");
  EXPECT_EQ(run.for_each, "tip");
  EXPECT_EQ(run.break_every_trials, 12);
  EXPECT_EQ(run.break_every_contact_s, 90.0);
  ASSERT_TRUE(run.pause);
  EXPECT_EQ(run.pause->minimum_s, 10.0);
  EXPECT_THAT(std::get<Protocol::Ask>(flow[4]).questions, ElementsAre("age", "hand"));
}

TEST(Keys, OfBlocksGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  const Protocol::Block& block = protocol.blocks.at("main");
  using Levels = std::map<std::string, Level, std::less<>>;
  using Block = Protocol::Block;
  EXPECT_EQ(block.name, "main");
  EXPECT_EQ(block.kind, "discrimination");
  EXPECT_EQ(block.phase, Phase::practice);
  EXPECT_THAT(block.crossed, ElementsAre("a"));
  EXPECT_THAT(block.exclude, ElementsAre(Levels{{"a", 2.0}}));
  EXPECT_THAT(block.derived, ElementsAre(Pair("d", "a / 2")));
  ASSERT_EQ(block.repetitions_of.size(), 1U);
  EXPECT_EQ(block.repetitions_of[0].levels, (Levels{{"a", 1.0}}));
  EXPECT_EQ(block.repetitions_of[0].repetitions, 3);
  ASSERT_TRUE(block.all_pairs);
  EXPECT_EQ(block.all_pairs->factor, "a");
  EXPECT_TRUE(block.all_pairs->in_both_orders);
  EXPECT_TRUE(block.all_pairs->with_identical);
  EXPECT_EQ(block.all_pairs->parts, 2);
  EXPECT_EQ(block.design(), find_design("yes_no"));
  EXPECT_EQ(block.repetitions, 2);
  EXPECT_THAT(block.drawn, ElementsAre("c"));
  EXPECT_EQ(block.order, Block::Order::fixed);
  EXPECT_THAT(block.maximum_in_a_row, ElementsAre(Pair("a", 2)));
  EXPECT_THAT(block.minimum_distance, ElementsAre(Pair("a", 3)));
  ASSERT_EQ(block.fixed_positions.size(), 1U);
  EXPECT_EQ(block.fixed_positions[0].position, 2);
  EXPECT_EQ(block.fixed_positions[0].levels, (Levels{{"a", 1.0}}));
  ASSERT_EQ(block.presented.size(), 1U);
  EXPECT_EQ(block.presented[0].role, "target");
  EXPECT_EQ(block.presented[0].stimulus, "rendered");
  EXPECT_EQ(block.presented[0].with, (Levels{{"a", "x"}}));
  EXPECT_EQ(block.presented[0].item, "it");
  EXPECT_EQ(block.positions, Block::Positions::balanced);
  EXPECT_TRUE(block.has_question_list);
  EXPECT_TRUE(block.shuffles_questions);
  EXPECT_TRUE(block.on_one_page);
  EXPECT_EQ(block.page_prompt, "All");
  EXPECT_EQ(block.experimenter_prompt, "Sample {code}");
  EXPECT_TRUE(block.pictures_after_feeling);
  EXPECT_EQ(block.exploration.factor, "e");
  ASSERT_TRUE(block.equal_roughness);
  EXPECT_EQ(block.equal_roughness->matched_in, "other");
  EXPECT_THAT(block.rove.stiffness_N_per_m, ElementsAre(400.0, 500.0));
  EXPECT_THAT(block.rove.friction, ElementsAre(0.1));
  EXPECT_THAT(block.rove.raised_m, ElementsAre(-0.01, 0.01));
  EXPECT_EQ(block.pause_before_trial_s, 1.0);
  EXPECT_EQ(block.pause_between_surfaces_s, 2.0);
  EXPECT_EQ(block.response_deadline_s, 3.0);
  EXPECT_EQ(block.feedback, Block::Feedback::correctness);
  ASSERT_TRUE(block.until);
  EXPECT_EQ(block.until->correct, 4);
  EXPECT_EQ(block.until->of_last, 5);
  EXPECT_EQ(block.until->maximum_trials, 20);
  EXPECT_EQ(block.until->on_failure, Protocol::Criterion::OnFailure::end_session);
  const Protocol::Block& tracks = protocol.blocks.at("tracks");
  EXPECT_THAT(tracks.listed, ElementsAre(Levels{{"a", 1.0}, {"b", "x"}}));
  EXPECT_EQ(tracks.anchor, (Levels{{"a", 2.0}}));
  EXPECT_THAT(tracks.anchor_pair, ElementsAre(Level(1.0), Level("x")));
  EXPECT_THAT(tracks.anchor_places, ElementsAre(AnchorPlace::start, AnchorPlace::end));
}

TEST(Keys, OfArrangementsGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  const Arrangement& stated = protocol.blocks.at("main").arrangement;
  EXPECT_EQ(stated.surfaces, Arrangement::Surfaces::on_request);
  EXPECT_EQ(stated.minimum_visits, 2);
  EXPECT_EQ(stated.maximum_visits, 3);
  ASSERT_TRUE(stated.interval);
  EXPECT_EQ(stated.interval->shortest_s, 1.0);
  EXPECT_EQ(stated.interval->longest_s, 2.0);
  EXPECT_EQ(stated.strokes, 4);
  EXPECT_TRUE(stated.draws_phase);
  const Arrangement& sequence = protocol.blocks.at("tracks").arrangement;
  ASSERT_TRUE(sequence.interval);
  EXPECT_EQ(sequence.interval->shortest_s, 0.4);
  EXPECT_EQ(sequence.interval->longest_s, 0.4);
  EXPECT_EQ(sequence.contact_s, 5.0);
  const Arrangement& other = protocol.blocks.at("other").arrangement;
  EXPECT_EQ(other.gap_m, 0.01);
  EXPECT_EQ(other.axis, Arrangement::Axis::y);
}

TEST(Keys, OfQuestionsOfTrialsGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  const auto& questions = protocol.blocks.at("main").questions;
  ASSERT_EQ(questions.size(), 7U);
  EXPECT_EQ(questions[0].name, "first");
  EXPECT_EQ(questions[0].prompt, "Which?");
  EXPECT_THAT(questions[0].pictures, ElementsAre("stone", "metal"));
  EXPECT_TRUE(questions[0].reshuffle_pictures);
  EXPECT_TRUE(questions[0].allow_cannot_tell);
  EXPECT_EQ(questions[0].own_as<RecognitionQuestion>()->correct_factor, "a");
  EXPECT_EQ(questions[2].judgement(), DiscriminationJudgement::comparison);
  EXPECT_TRUE(questions[2].asks_for_less());
  ASSERT_EQ(questions[2].options.size(), 2U);
  EXPECT_EQ(questions[2].options[1].value, "n");
  EXPECT_EQ(questions[2].options[1].text, "No");
  EXPECT_EQ(questions[3].confidence_of(), "third");
  EXPECT_EQ(std::get<ScaleForm>(questions[3].form).minimum, 1.0);
  EXPECT_EQ(questions[4].own_as<SimilarityQuestion>()->rates, RatedQuantity::similarity);
  EXPECT_EQ(questions[5].own_as<PairQuestion>()->tie, "Same");
  EXPECT_EQ(std::get<NumberForm>(questions[6].form).maximum, 9.0);
  EXPECT_EQ(std::get<LineForm>(questions[1].form).longest, 0.5);
  const Protocol::Block& other = protocol.blocks.at("other");
  EXPECT_FALSE(other.has_question_list);
  ASSERT_EQ(other.questions.size(), 1U);
  EXPECT_EQ(other.questions[0].name, "only");
  EXPECT_EQ(other.questions[0].own_as<RecognitionQuestion>()->correct_factor, "a");
  const auto& judged = protocol.blocks.at("constant").questions[0];
  EXPECT_EQ(judged.judgement(), DiscriminationJudgement::comparison);
  EXPECT_FALSE(judged.asks_for_less());
  EXPECT_EQ(other.questions[0].condition, (AnswerCondition{"z", AnswerIsOneOf{{4.0}}}));
  EXPECT_EQ(other.experimenter_prompt, "E");
  EXPECT_TRUE(other.pictures_after_feeling);
}

TEST(Keys, OfLevelsGoToTheirMembers) {
  const auto dimension = [](const char* key, const json& levels) {
    Dimension made{};
    const json object{{"parameter", "gain_N"}, {"of", "comparison"}, {key, levels}};
    EXPECT_THAT(read_keys(kDimensionTable, object, "", made), IsEmpty());
    return made;
  };
  const Dimension grid = dimension(
      "levels_percent", {{"lowest", 1}, {"highest", 10}, {"step", 2}, {"scale", "ratio"}});
  EXPECT_EQ(grid.parameter, "gain_N");
  EXPECT_EQ(grid.factor, "gain_N");
  EXPECT_EQ(grid.role, "comparison");
  EXPECT_EQ(grid.measure, LevelMeasure::percent);
  EXPECT_EQ(grid.grid, (LevelGrid{LevelScale::ratio, 1.0, 10.0, 2.0}));
  for (const LevelMeasure measure :
       {LevelMeasure::value, LevelMeasure::difference, LevelMeasure::percent, LevelMeasure::ratio,
        LevelMeasure::decibels}) {
    const Dimension list = dimension(std::string(key_of(measure)).c_str(), {1, 2});
    EXPECT_EQ(list.measure, measure);
    EXPECT_THAT(list.list, ElementsAre(1.0, 2.0));
  }
  const Dimension stated = *read_of(kEverything).blocks.at("tracks").vary;
  EXPECT_EQ(stated.factor, "g");
  EXPECT_EQ(stated.standard_role, "standard");
}

TEST(Keys, OfAProcedureGoToTheirMembers) {
  const auto procedure_of = [](const char* block) {
    ProcedureDeclaration stated{};
    const json& object = kEverything.at("blocks").at(block).at("procedure");
    EXPECT_THAT(read_keys(kProcedureTable, object, "", stated), IsEmpty());
    return stated;
  };
  const ProcedureDeclaration psi = procedure_of("tracks");
  EXPECT_EQ(psi.method, "psi");
  EXPECT_EQ(psi.target, 0.8);
  EXPECT_EQ(psi.prior.threshold, (ValueRange{1.0, 2.0, 3}));
  EXPECT_EQ(psi.prior.slope, (ValueRange{2.0, 3.0, 4}));
  EXPECT_EQ(psi.prior.lapse, (ValueRange{0.0, 0.1, 5}));
  EXPECT_THAT(psi.marginalised, ElementsAre(NuisanceParameter::lapse));
  EXPECT_EQ(psi.stop.interval, (IntervalRule{2.5, 10, 4}));
  EXPECT_TRUE(psi.timeouts_are_incorrect);
  ASSERT_TRUE(psi.catch_trials);
  EXPECT_EQ(psi.catch_trials->type, CatchType::no_signal);
  EXPECT_EQ(psi.catch_trials->every, 10);

  const ProcedureDeclaration up_down = procedure_of("other");
  EXPECT_EQ(up_down.down, 2U);
  EXPECT_EQ(up_down.up, 3U);
  EXPECT_EQ(up_down.start, 4.0);
  EXPECT_THAT(up_down.steps, ElementsAre(2.0));
  EXPECT_THAT(up_down.steps_up, ElementsAre(1.0));
  EXPECT_THAT(up_down.steps_down, ElementsAre(3.0, 4.0));
  EXPECT_EQ(up_down.stop.trials, 40U);
  EXPECT_EQ(up_down.stop.reversals, 8U);
  EXPECT_EQ(up_down.stop.clipped_moves, 3U);
  ASSERT_EQ(up_down.tracks.size(), 2U);
  EXPECT_EQ(up_down.tracks[0].start, 5.0);
  EXPECT_FALSE(up_down.tracks[1].start);
  EXPECT_EQ(up_down.catch_trials->level, 7.0);

  EXPECT_EQ(procedure_of("constant").repetitions, 3U);
  const ProcedureDeclaration outside = procedure_of("outside");
  EXPECT_EQ(outside.settings_json, R"({"b":[2],"x-a":1})") << "unchanged, comments included";
  EXPECT_EQ(outside.answer_within_s, 60.0);
}

TEST(Keys, ApplyWhereTheirConditionsHold) {
  json protocol = kEverything;
  const auto keys_of_block = [&protocol](const char* block) {
    std::set<std::string> pointers{};
    for (const InapplicableKey& key : inapplicable_keys(protocol)) {
      if (key.pointer.starts_with(pointer_to("/blocks", block))) pointers.insert(key.pointer);
    }
    return pointers;
  };
  // The protocol is a rating; the block a discrimination.
  EXPECT_THAT(keys_of_block("main"),
              IsSupersetOf({"/blocks/main/all_pairs", "/blocks/main/questions/4/rates",
                            "/blocks/main/questions/5/tie"}));
  EXPECT_THAT(keys_of_block("main"), Not(Contains("/blocks/main/questions/2/judgement")));
  EXPECT_THAT(keys_of_block("constant"), Contains("/blocks/constant/question/judgement"));
  protocol["kind"] = "discrimination";
  EXPECT_THAT(keys_of_block("constant"), IsEmpty());
  EXPECT_THAT(keys_of_block("paired"), ElementsAre("/blocks/paired/question/tie"));
  // The method of a procedure is stated around its stopping rule.
  protocol["blocks"]["tracks"]["procedure"]["stop"]["reversals"] = 4;
  EXPECT_THAT(keys_of_block("tracks"), Contains("/blocks/tracks/procedure/stop/reversals"));
  EXPECT_THAT(keys_of_block("other"), Not(Contains("/blocks/other/procedure/stop/reversals")));
  // A default is equivalent to the absence of the key, and comments are not blocks.
  protocol["blocks"]["paired"] = {{"kind", "paired_comparison"},
                                  {"question", {{"allow_cannot_tell", false}}}};
  ASSERT_THAT(keys_of_block("paired"), ElementsAre("/blocks/paired/question/allow_cannot_tell"));
  const auto is_permitted = [&protocol] {
    return std::ranges::any_of(inapplicable_keys(protocol), [](const InapplicableKey& key) {
      return key.is_permitted && key.pointer.starts_with("/blocks/paired/");
    });
  };
  EXPECT_TRUE(is_permitted());
  protocol["blocks"]["paired"]["question"]["allow_cannot_tell"] = true;
  EXPECT_FALSE(is_permitted());
  EXPECT_THAT(keys_of_block("paired"), ElementsAre("/blocks/paired/question/allow_cannot_tell"));
  const json only = {{"kind", "rating"},
                     {"blocks", {{"$comment", "one"}, {"main", {{"kind", "similarity"}}}}}};
  EXPECT_EQ(kinds_at(only, "/analysis"), (std::set<std::string>{"similarity"}));
}

TEST(Keys, OfTheAnalysisGoToTheirMembers) {
  const Protocol protocol = read_of(kEverything);
  EXPECT_EQ(protocol.analysis,
            (AnalysisDeclaration{.target = "stone",
                                 .family = {"pairs"},
                                 .equivalence_margin = 0.1,
                                 .constructs = {{"feel", {{"ease", "roughness"}, {"ease"}}}},
                                 .exclude = CatchExclusion{.more_errors_than = 2}}));
  ASSERT_TRUE(protocol.estimation);
  EXPECT_EQ(protocol.estimation->spacing, "s");
  EXPECT_EQ(protocol.estimation->items, "model");
  EXPECT_EQ(protocol.estimation->predictor, "values");
  EXPECT_THAT(protocol.estimation->predictor_values, ElementsAre(Pair("2", 0.5)));
  EXPECT_EQ(protocol.estimation->predictor_unit, "mm");
  EXPECT_EQ(protocol.estimation->modulus, (EstimationModulus{"2", 10.0}));
  EXPECT_EQ(protocol.estimation->stated_normalisation, EstimateNormalisation::standard);
  EXPECT_EQ(protocol.estimation->condition, "tip");
}

TEST(Keys, OfTheObserverGoToTheirMembers) {
  const ObserverDeclaration observer = read_of(kEverything).observer;
  EXPECT_EQ(observer.expectation, ObserverDeclaration::Expectation::prior);
  EXPECT_EQ(observer.gaussian_wavelength_m, 0.004);
  EXPECT_TRUE(observer.deaf);
  EXPECT_EQ(observer.feature_noise, 0.2);
  EXPECT_EQ(observer.position_bias, 0.3);
  EXPECT_EQ(observer.lapse, 0.04);
  EXPECT_EQ(observer.magnitude_of, ObserverDeclaration::MagnitudeOf::held_tool);
  EXPECT_EQ(observer.magnitude.exponent, 0.9);
  EXPECT_TRUE(observer.discrimination.magnitude_decreases);
  EXPECT_EQ(observer.discrimination.yes_above, 1.5);
  EXPECT_EQ(observer.discrimination.different_above, 0.25);
  EXPECT_EQ(observer.discrimination.unsure_within, 0.05);
}

TEST(Keys, AreReadExceptForThoseInAnotherForm) {
  json root = kEverything;
  json& device = root.at("device");
  device["rate_Hz"] = "fast";
  device["maximum_lost_records"] = 1.5;
  device["compute"] = "cpus";
  device["limits"] = {{"friction_N", -1}, {"colour", 1}, {"missed_deadlines", 4}};
  device["later"] = true;
  std::vector<std::string> pointers{};
  const Protocol protocol = read_of(root, &pointers);
  EXPECT_THAT(pointers, ElementsAre("/device/compute", "/device/later", "/device/limits/colour",
                                    "/device/limits/friction_N", "/device/maximum_lost_records",
                                    "/device/rate_Hz"));
  EXPECT_EQ(protocol.rate_Hz, 1000.0);
  EXPECT_EQ(protocol.maximum_lost_records, 0);
  EXPECT_FALSE(protocol.computes_on_gpu);
  EXPECT_EQ(protocol.force_limit_N, 3.5);
  EXPECT_EQ(protocol.device_limits, (std::map<std::string, double>{{"missed_deadlines", 4.0}}));
}

TEST(Keys, AreNotReadFromAnotherValue) {
  std::vector<std::string> pointers{};
  EXPECT_EQ(read_of({{"device", json::array({1})}}, &pointers).rate_Hz, 1000.0);
  EXPECT_THAT(pointers, Contains("/device"));
}

constexpr const char* kPage = "docs/formats/protocol.md";
constexpr std::string_view kHeadOfRows = "| --- | --- | --- | --- |\n";

/// The page with these rows in place of those that have the most of their keys and are not current.
std::string with_rows(const KeyTable& table, const std::set<std::string>& current,
                      std::string page) {
  std::pair<std::size_t, std::size_t> place{};  // of the rows that are replaced
  std::size_t most = 0;
  for (std::size_t head = page.find(kHeadOfRows); head != std::string::npos;
       head = page.find(kHeadOfRows, head + 1)) {
    const std::size_t start = head + kHeadOfRows.size();
    const std::string rows = page.substr(start, page.find("\n\n", start - 1) + 1 - start);
    const auto common =
        static_cast<std::size_t>(std::ranges::count_if(table.keys, [&rows](const ProtocolKey& key) {
          return rows.find("| `" + std::string(key.name) + "` |") != std::string::npos;
        }));
    const bool is_other = common == 0 && !rows.empty();
    if (current.contains(rows) || is_other || common < most) continue;
    most = common;
    place = {start, rows.size()};
  }
  return page.replace(place.first, place.second, page_rows_of(table));
}

/// A row for every kind of experiment, with its tests.
std::string rows_of_tests() {
  std::string rows{};
  for (const ExperimentKind* const kind : experiment_kinds()) {
    rows += "| " + std::string(kind->id) + " | ";
    for (const KindTest& test : kind->tests) {
      if (&test != &kind->tests.front()) rows += ", ";
      rows += '`' + std::string(test.name) + "` (" + std::string(test.meaning);
      if (!test.estimated_by.empty())
        rows += "; only with `" + std::string(test.estimated_by) + '`';
      rows += ')';
    }
    rows += " |\n";
  }
  return rows;
}

TEST(Keys, StateWhichOthersTheyNeedInTheirConditionsAlone) {
  EXPECT_NE(page_rows_of(kStepTable).find("a break. Only with `run`. |"), std::string::npos);
  for (const KeyTable* const table : tables()) {
    for (const ProtocolKey& key : table->keys) {
      for (const KeyCondition& condition : key.conditions) {
        if (condition.key.empty()) continue;
        EXPECT_NE(key.meaning.substr(0, 5), "With ") << key.name << ": " << key.meaning;
      }
    }
  }
}

TEST(Keys, AreThoseOfThePage) {
  std::string page = source_file(kPage);
  std::set<const KeyTable*> all = tables();
  all.erase(&kListedQuestionTable);  // its keys are also those of the one question
  all.insert(&kProtocolTable);
  std::set<std::string> current{};
  for (const KeyTable* const table : all) current.insert(page_rows_of(*table));
  const bool is_stored = std::getenv("ASPERITY_STORE_PAGE") != nullptr;
  for (const KeyTable* const table : all) {
    const std::string rows = page_rows_of(*table);
    const bool is_there = page.find(std::string(kHeadOfRows) + rows + '\n') != std::string::npos;
    if (is_stored && !is_there) page = with_rows(*table, current, page);
    EXPECT_TRUE(is_stored || is_there) << rows;
  }
  constexpr std::string_view kHeadOfTests = "| kind | tests |\n| --- | --- |\n";
  const std::size_t tests = page.find(kHeadOfTests) + kHeadOfTests.size();
  const std::size_t length = page.find("\n\n", tests) + 1 - tests;
  EXPECT_TRUE(is_stored || page.substr(tests, length) == rows_of_tests()) << rows_of_tests();
  if (is_stored) page.replace(tests, length, rows_of_tests());
  if (is_stored) std::ofstream(std::string(ASPERITY_SOURCE_DIR) + "/" + kPage) << page;
}

/// A misspelt key, word or kind in a condition would hide its key, or permit it nowhere.
TEST(Keys, HaveConditionsOnExistingKeysAndWords) {
  const auto words_in = [](const ValueShape& shape) {
    std::set<std::string_view> words{kAbsent};
    if (const auto* const listed = std::get_if<WordShape>(&shape)) {
      for (const KeyWord& word : listed->words) words.insert(word.name);
    }
    return words;
  };
  std::size_t conditions = 0;
  std::set<const KeyTable*> all = tables();
  all.insert(&kProtocolTable);
  for (const KeyTable* const table : all) {
    for (const ProtocolKey& key : table->keys) {
      for (const KeyCondition& condition : key.conditions) {
        if (condition.key.empty()) continue;
        ++conditions;
        SCOPED_TRACE(std::string(key.name) + " and " + std::string(condition.key));
        const KeyTable* owner = table;  // of the other key
        if (condition.of == KeyCondition::Of::around) owner = &kProcedureTable;
        if (condition.of == KeyCondition::Of::kind) owner = &kProtocolTable;
        const ProtocolKey* const other = owner->find(condition.key);
        ASSERT_NE(other, nullptr);
        for (const std::string_view value : condition.values()) {
          EXPECT_TRUE(words_in(other->shape).contains(value)) << value;
        }
      }
    }
  }
  EXPECT_GT(conditions, 60U);
}

/// The unit of a quantity ends its name.
TEST(Keys, HaveALabelAndTheUnitOfTheirName) {
  for (const KeyTable* const table : tables()) {
    EXPECT_TRUE(table->meaning.ends_with('.')) << table->meaning;
    for (const ProtocolKey& key : table->keys) {
      EXPECT_FALSE(key.label.empty()) << key.name;
      EXPECT_TRUE(meaning_of(key).ends_with('.')) << key.name;
      const auto* const number = std::get_if<NumberShape>(&key.shape);
      if (number == nullptr || number->unit.empty()) continue;
      std::string ending = "_";
      for (const char c : number->unit) {
        ending += c == ' ' ? std::string("_") : c == '/' ? std::string("_per_") : std::string(1, c);
      }
      EXPECT_TRUE(key.name.ends_with(ending)) << key.name << ' ' << ending;
    }
  }
}

/// A protocol with everything that tables declare.
json full_protocol() {
  json file = json::parse(test::example_selection());
  file.update(kEverything);
  return file;
}

TEST(KeysAndSchema, AgreeOnLibraryProtocols) {
  for (const LibraryProtocol& each : library_protocols()) {
    test::expect_that_both_checks_agree(std::string(each.text));
  }
  test::expect_that_both_checks_agree(full_protocol().dump(1));
  EXPECT_THAT(check_form(JsonDocument(full_protocol().dump(1), "p.json")), IsEmpty());
}

TEST(KeysAndSchema, AgreeOnRandomEdits) {
  constexpr int kEdits = 800;
  const std::vector<json> values{nullptr,
                                 true,
                                 0,
                                 -1,
                                 1,
                                 50,
                                 1.5,
                                 -0.5,
                                 1e9,
                                 "1000",
                                 "",
                                 "gp",
                                 "x",
                                 {},
                                 json{},
                                 {1, 2},
                                 "gpu",
                                 "A name",
                                 20,
                                 20.5,
                                 100,
                                 1e4,
                                 10001,
                                 1000000,
                                 1000001,
                                 8000.5,
                                 json::array(),
                                 {0, 0.1},
                                 0.05,
                                 1e-4,
                                 "pink",
                                 {"x"},
                                 json::array({"a", "a"}),
                                 {{"rate_Hz", 1}},
                                 json::object(),
                                 {{"factor", "model"}},
                                 std::string(250, 'a')};
  Random random = Random(20261129).split("keys");
  const auto drawn = [&random](std::size_t n) { return static_cast<std::size_t>(random.below(n)); };
  for (int i = 0; i < kEdits && !testing::Test::HasFailure(); ++i) {
    json file = full_protocol();
    for (std::size_t edits = 1 + drawn(3); edits > 0; --edits) {
      std::vector<std::pair<const KeyTable*, std::string>> objects{};
      for_each_object(ObjectShape{&kProtocolTable}, file, "",
                      [&](const KeyTable& table, const json& object, const std::string& pointer) {
                        if (object.is_object() && !table.keys.empty()) {
                          objects.emplace_back(&table, pointer);
                        }
                      });
      const auto& [table, pointer] = objects[drawn(objects.size())];
      json& object = file.at(json::json_pointer(pointer));
      const std::string key(table->keys[drawn(table->keys.size())].name);
      const json& value = values[drawn(values.size())];
      switch (drawn(4)) {
        case 0:
          object[key] = value;
          break;
        case 1:
          object[(pointer.empty() ? "x-" : "") + key + 's'] = value;
          break;
        case 2:
          object.erase(key);
          break;
        default:
          object["x-" + key] = value;
          break;
      }
    }
    test::expect_that_both_checks_agree(file.dump(1));
  }
}

}  // namespace
}  // namespace asperity
