// Faults planted in good protocols: each is refused at its place, in words that help.

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "protocols/file/protocol_reader.h"
#include "protocols/warnings/warnings.h"
#include "tests/protocols/both_checks.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

/// `from` is replaced by `to` in a good text; the complaint is expected where `at` then first
/// stands, with this pointer and these words.
struct Fault {
  const char* name;
  const char* from;
  const char* to;
  const char* at;
  const char* pointer;
  const char* words;
};

void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.name; }

std::string planted(std::string text, const Fault& fault) {
  const std::size_t at = text.find(fault.from);
  EXPECT_NE(at, std::string::npos) << "the example no longer contains " << fault.from;
  return text.replace(at, std::string(fault.from).size(), fault.to);
}

std::pair<int, int> place_in(const std::string& text, const std::string& what) {
  const std::size_t offset = text.find(what);
  EXPECT_NE(offset, std::string::npos) << what;
  const std::string before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
  return {static_cast<int>(line), static_cast<int>(offset - start) + 1};
}

std::vector<Diagnostic> problems_of(const std::string& text) {
  try {
    (void)read_protocol(text, "p.json", test::example_models());
  } catch (const ProtocolError& error) {
    test::expect_translatable(error.diagnostics());
    return error.diagnostics();
  }
  return {};
}

/// But for the fault the examples are right: what is reported of the meaning of one whose form is wrong is a mere
/// consequence of that.
void expect_no_follow_ups(const std::string& text, const std::string& all) {
  try {
    test::expect_that_both_checks_agree(text);
    const std::size_t of_form = check_form(JsonDocument(text, "p.json")).size();
    if (of_form > 0) {
      EXPECT_EQ(problems_of(text).size(), of_form) << all;
    }
  } catch (const ProtocolError&) {  // of the syntax, which alone is reported
  }
}

void expect_complaint(const std::string& text, const Fault& fault) {
  const std::vector<Diagnostic> problems = problems_of(text);
  const auto [line, column] = place_in(text, fault.at);
  const bool found = std::any_of(
      problems.begin(), problems.end(), [&, l = line, c = column](const Diagnostic& problem) {
        return problem.line == l && problem.column == c && problem.pointer == fault.pointer &&
               problem.message.english().find(fault.words) != std::string::npos;
      });
  std::string all{};
  for (const Diagnostic& problem : problems) all += text_of(problem) + "\n";
  EXPECT_TRUE(found) << "expected " << line << ":" << column << " " << fault.pointer << " … "
                     << fault.words << "\nfound:\n"
                     << all;
  expect_no_follow_ups(text, all);
}

class PlantedInSelection : public testing::TestWithParam<Fault> {};
class PlantedInBodies : public testing::TestWithParam<Fault> {};
class PlantedInMatching : public testing::TestWithParam<Fault> {};
class PlantedInRecognition : public testing::TestWithParam<Fault> {};

TEST_P(PlantedInBodies, IsRefusedAtItsPlace) {
  expect_complaint(planted(test::example_bodies(), GetParam()), GetParam());
}
INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedInBodies,
    testing::Values(
        Fault{"NoTool", R"("surface": "plate",
      "tool": {"factor": "held"})",
              R"("surface": "plate")", R"({
      "model": "pd_gradient")",
              "/stimuli/felt",
              R"(needs two bodies: give the stimulus the object that the hand holds)"},
        Fault{"NoSurface", R"("surface": "plate",)", "", R"({
      "model": "pd_gradient")",
              "/stimuli/felt", "the object that is touched, one of the bodies, as \"surface\""},
        Fault{"AToolOfAPoint", R"("model": "pd_gradient")", R"("model": "height_map")",
              R"("tool": {"factor")", "/stimuli/felt/tool", "touches a surface with a point"},
        Fault{"AnUnknownBody", R"("surface": "plate")", R"("surface": "plaet")", R"("plaet")",
              "/stimuli/felt/surface", "did you mean \"plate\"?"},
        Fault{"AnUnknownBodyAsALevel", R"(["ball", "roll", "rasp"])", R"(["ball", "roll", "file"])",
              R"("file"])", "/factors/held/levels/2", "there is no body \"file\""},
        Fault{"MeshAndShape", R"("mesh": "stimuli/rasp.mesh")",
              R"("mesh": "stimuli/rasp.mesh", "shape": "sphere", "diameter_m": 0.01)", R"({"mesh")",
              "/bodies/rasp", "not both"},
        Fault{"NeitherMeshNorShape", R"({"mesh": "stimuli/rasp.mesh"})", R"({"axis": "x"})",
              R"({"axis")", "/bodies/rasp", "either a \"mesh\""},
        Fault{"AMeshOutsideTheStudy", "stimuli/rasp.mesh", "../rasp.mesh", R"("../rasp.mesh")",
              "/bodies/rasp/mesh", "points outside the study"},
        Fault{"AMeshWithASize", R"("mesh": "stimuli/rasp.mesh")",
              R"("mesh": "stimuli/rasp.mesh", "length_m": 0.1)", R"("length_m": 0.1)",
              "/bodies/rasp/length_m", "determines its size"},
        Fault{"AMissingSize", R"("diameter_m": 0.008, "length_m": 0.01)", R"("diameter_m": 0.008)",
              R"({"shape": "cylinder")", "/bodies/roll", "needs \"length_m\", in metres"},
        Fault{"ASizeOfAnotherShape", R"("diameter_m": 0.01})",
              R"("diameter_m": 0.01, "length_m": 0.02})", R"("length_m": 0.02)",
              "/bodies/ball/length_m", "use \"diameter_m\" instead"},
        Fault{"ASizeBelowAMillimetre", R"("diameter_m": 0.01})", R"("diameter_m": 0.0005})",
              "0.0005", "/bodies/ball/diameter_m", "0.001"},
        Fault{"AnAxisOfAPlate", R"("size_m": [0.08, 0.06, 0.01])",
              R"("size_m": [0.08, 0.06, 0.01], "axis": "x")", R"("axis": "x"})",
              "/bodies/plate/axis", "has no axis; remove this key"},
        Fault{"AnUnknownReliefOnABody", R"("texture": "stone"})", R"("texture": "stoen"})",
              R"("stoen")", "/bodies/roll/texture", "did you mean \"stone\"?"},
        Fault{"AReliefThatCannotBeFelt", R"("texture": "stone"})", R"("texture": "rasp"})",
              R"("rasp"})", "/bodies/roll/texture", "has no \"height_field\""},
        Fault{"ATextureThatIsOnNoBody", R"("size_m": [0.08, 0.06, 0.01])",
              R"("size_m": [0.08, 0.06, 0.01], "texture": "stone")", R"("metal", "stone"])",
              "/factors/ground/levels/0", "is on neither body"},
        Fault{"EqualForceOfBodies", R"("surface": "plate",)",
              R"("surface": "plate", "equal_force": {"rms_N": 0.1},)", R"("pd_gradient")",
              "/stimuli/felt/model", ", and state the strength as \"texture_gain\""},
        Fault{"ParametersThatContradictEachOther", R"("surface": "plate",)",
              R"("surface": "plate", "parameters": {"step": 1},)", R"(1},
      "tool")",
              "/stimuli/felt/parameters/step", "at least a cell"},
        Fault{"ADefaultThatContradictsAParameter", R"("surface": "plate",)",
              R"("surface": "plate", "parameters": {"cell": 3},)", R"(3},
      "tool")",
              "/stimuli/felt/parameters/cell", "at least a cell"},
        Fault{"EqualForceToBodies", R"("surface": "plate",)",
              R"("surface": "plate", "equal_force": {"to_model": "pd_gradient"},)",
              R"("pd_gradient"})", "/stimuli/felt/equal_force/to_model", "rms_N"},
        Fault{"AScaledMotion", R"("realism_standard": "memory",)",
              R"("realism_standard": "memory", "surface": {"motion_scale": 2},)", "2},",
              "/surface/motion_scale", "set \"motion_scale\" to 1"},
        Fault{"AFactorThatTheBlockDoesNotSet", R"("with": {"held": "rasp"}, "item": "rasp")",
              R"("item": "rasp")", R"({"stimulus": "felt", "item": "rasp"})",
              "/blocks/main/presented/2", "held"}),
    [](const auto& given) { return given.param.name; });

TEST_P(PlantedInSelection, IsRefusedAtItsPlace) {
  expect_complaint(planted(test::example_selection(), GetParam()), GetParam());
}
TEST_P(PlantedInMatching, IsRefusedAtItsPlace) {
  expect_complaint(planted(test::library_text("improved_matching"), GetParam()), GetParam());
}
TEST_P(PlantedInRecognition, IsRefusedAtItsPlace) {
  expect_complaint(planted(test::library_text("improved_recognition"), GetParam()), GetParam());
}

const auto fault_name = [](const auto& each) { return std::string(each.param.name); };

const Fault kSyntax[] = {
    {"trailing_comma", R"("version": "1.0.0",)", R"("version": "1.0.0",,)", ",\n  \"title\"", "",
     "unexpected ','"},
    {"nan", R"("force_limit_N": 5)", R"("force_limit_N": NaN)", "NaN", "/device",
     "'NaN' is not JSON"},
    {"infinite_number", R"("force_limit_N": 5)", R"("force_limit_N": 1e999)", "1e999", "/device",
     "too large"},
    {"cut_off", R"("version": "1.0.0",)", "\"version\": \"1.0.0", "\n  \"title\": \"Which", "",
     "contains a line break"},
    {"duplicate_key", R"("version": "1.0.0",)", R"("version": "1.0.0", "version": "2.0.0",)",
     R"("version": "2.0.0")", "/version", "occurs twice"},
    {"zero_in_a_text", R"("version": "1.0.0",)", R"("version": "1.0\u0000",)", R"("1.0\u0000")",
     "/version", "this text contains U+0000 (\\u0000); delete this character"},
    {"zero_in_a_level", R"("levels": ["metal", "stone"])", R"("levels": ["metal", "st\u0000"])",
     R"("st\u0000")", "/factors/texture/levels/1", "this text contains U+0000"},
    {"zero_in_a_key", R"("version": "1.0.0",)", R"("version": "1.0.0", "x-a\u0000": 1,)",
     R"("x-a\u0000")", "", "the key 'x-a?' contains U+0000 (\\u0000); delete"},
};

const Fault kForm[] = {
    {"other_format", "asperity.protocol/1", "asperity.protocol/2", R"("asperity.protocol/2")",
     "/format", R"("asperity.protocol/2" is not supported: write "asperity.protocol/1")"},
    {"misspelt_key", R"("repetitions": 3)", R"("repetitons": 3)", R"("repetitons")",
     "/blocks/main/repetitons", R"(did you mean "repetitions"?)"},
    {"unknown_key", R"("version": "1.0.0",)", R"("version": "1.0.0", "zebra": 1,)", R"("zebra")",
     "/zebra", "there is no key"},
    {"instructions", R"("version": "1.0.0",)", R"("version": "1.0.0", "instructions": "Feel.",)",
     R"("instructions")", "/instructions", "participants read the screens of the flow: write"},
    {"unknown_kind", R"("kind": "selection")", R"("kind": "ranking")", R"("ranking")", "/kind",
     R"("ranking" is not permitted here: write "selection", "matching")"},
    {"near_choice", R"("order": "shuffle")", R"("order": "shufle")", R"("shufle")",
     "/blocks/main/order", R"(did you mean "shuffle"?)"},
    {"version", R"("version": "1.0.0")", R"("version": "1.0")", R"("1.0")", "/version",
     "three numbers"},
    {"missing_key", R"(  "title": "Which rendering feels most like the picture?",)", "", "{",
     "/title", R"(the key "title" is missing)"},
    {"wrong_type", R"("rate_Hz": 1000)", R"("rate_Hz": "1000")", R"("1000")", "/device/rate_Hz",
     R"("1000" is not permitted here: write a number, without quotation marks)"},
    {"negative", R"("rate_Hz": 1000)", R"("rate_Hz": -1)", "-1,", "/device/rate_Hz",
     "at least 100"},
    {"zero_force", R"("force_limit_N": 5)", R"("force_limit_N": 0)", "0}", "/device/force_limit_N",
     "greater than 0"},
    {"too_strong", R"("force_limit_N": 5)", R"("force_limit_N": 500)", "500",
     "/device/force_limit_N", "at most 20"},
    {"no_buzz_max", R"("device": {"rate_Hz": 1000,)",
     R"("instability": {"on": "flag"}, "device": {"rate_Hz": 1000,)", R"({"on": "flag"})",
     "/instability/buzz_max", R"(the key "buzz_max" is missing)"},
    {"buzz_of_zero", R"("device": {"rate_Hz": 1000,)",
     R"("instability": {"buzz_max": 0}, "device": {"rate_Hz": 1000,)", "0}",
     "/instability/buzz_max", "greater than 0"},
    {"buzz_misspelt", R"("device": {"rate_Hz": 1000,)",
     R"("instability": {"buzz_max": 0.4, "on": "repeat"}, "device": {"rate_Hz": 1000,)",
     R"("repeat"})", "/instability/on", R"("repeat_now")"},
    {"negative_limit", R"("force_limit_N": 5)",
     R"("force_limit_N": 5, "limits": {"friction_N": -0.2})", "-0.2", "/device/limits/friction_N",
     "at least 0. Expected here: Largest friction"},
    {"misspelt_limit", R"("force_limit_N": 5)",
     R"("force_limit_N": 5, "limits": {"fricton_N": 0.2})", R"("fricton_N")",
     "/device/limits/fricton_N", R"(did you mean "friction_N"?)"},
    {"unknown_limit", R"("force_limit_N": 5)", R"("force_limit_N": 5, "limits": {"colour": 1})",
     R"("colour")", "/device/limits/colour", R"("lateness_p99_s")"},
    {"limit_in_words", R"("force_limit_N": 5)",
     R"("force_limit_N": 5, "limits": {"latency_s": "3 ms"})", R"("3 ms")",
     "/device/limits/latency_s", "write a number"},
    {"bad_name", R"("stone": {)", R"("Stone": {)", R"("Stone")", "/textures/Stone",
     "lower-case letters"},
    {"empty_list", R"("levels": ["metal", "stone"])", R"("levels": [])", "[]",
     "/factors/texture/levels", "too few"},
    {"two_steps_in_one", R"({"check": "device"})", R"({"check": "device", "screen": "x"})",
     R"({"check": "device", )", "/flow/1", R"(exactly one of the keys "screen", "check")"},
    {"no_step", R"({"check": "device"})", R"({"$comment": "device"})", R"({"$comment")", "/flow/1",
     "exactly one of the keys"},
    {"pause_without_run", R"({"screen": "Welcome."})",
     R"({"screen": "Welcome.", "break_every_trials": 3})", R"("break_every_trials")",
     "/flow/0/break_every_trials", R"("run", which is missing)"},
    {"two_targets", R"("equal_force": {)", R"("equal_force": {"rms_N": 1, )", R"({"rms_N")",
     "/stimuli/rendered/equal_force", R"(exactly one of the keys "rms_N" or "to_model")"},
    {"binding", R"({"factor": "model"})", R"({"facto": "model"})", R"({"facto")",
     "/stimuli/rendered/model/factor", R"("factor" is missing)"},
    {"empty_text", R"({"screen": "Welcome."})", R"({"screen": ""})", R"(""})", "/flow/0/screen",
     "this text is empty"},
};

const Fault kMeaning[] = {
    {"buzz_at_a_low_rate", R"("device": {"rate_Hz": 1000,)",
     R"("instability": {"buzz_max": 0.4}, "device": {"rate_Hz": 250,)", R"({"buzz_max": 0.4})",
     "/instability", "above 150 Hz cannot be judged at a servo rate of 250 Hz"},
    {"question_order_without_questions", R"("repetitions": 3)",
     R"("repetitions": 3, "question_order": "shuffle")", R"("question_order")",
     "/blocks/main/question_order", "requires the key \"questions\""},
    {"unknown_model", R"(["height_map", "sinusoid")", R"(["height_mapp", "sinusoid")",
     R"("height_mapp")", "/factors/model/levels/0", R"(did you mean "height_map"?)"},
    {"unknown_texture", R"("levels": ["metal", "stone"])", R"("levels": ["metal", "stome"])",
     R"("stome")", "/factors/texture/levels/1", R"(did you mean "stone"?)"},
    {"unknown_parameter", R"("equal_force")", R"("parameters": {"lawn": 1}, "equal_force")",
     R"("lawn")", "/stimuli/rendered/parameters/lawn", "there is no parameter"},
    {"parameter_out_of_range", R"("model": {"factor": "model"})",
     R"("model": "sinusoid", "parameters": {"amplitude_m": 0.5})", "0.5}",
     "/stimuli/rendered/parameters/amplitude_m", "0.01"},
    {"parameter_not_a_choice", R"("model": {"factor": "model"})",
     R"("model": "height_map", "parameters": {"law": "correct"})", R"("correct"})",
     "/stimuli/rendered/parameters/law", "literal"},
    {"solved_parameter_given", R"("model": {"factor": "model"})",
     R"("model": "sinusoid", "parameters": {"amplitude_m": 0.001})", R"("amplitude_m")",
     "/stimuli/rendered/parameters/amplitude_m", "\"equal_force\" determines"},
    {"amplitude_of_the_reference_given", R"("model": {"factor": "model"})",
     R"("model": "height_map", "parameters": {"height_scale": 3})", R"("height_scale")",
     "/stimuli/rendered/parameters/height_scale", "at its default"},
    {"no_amplitude", R"("model": {"factor": "model"})", R"("model": "plain")", R"("plain")",
     "/stimuli/rendered/model", "no amplitude"},
    {"equal_to_unknown_model", R"("to_model": "height_map")", R"("to_model": "height")",
     R"("height"})", "/stimuli/rendered/equal_force/to_model", "no force model"},
    {"band_above_half_the_rate", R"("rate_Hz": 1000)", R"("rate_Hz": 500)",
     R"({"to_model": "height_map"})", "/stimuli/rendered/equal_force", "half the servo rate"},
    {"absolute_path", R"("stimuli/metal.png")", R"("/etc/passwd")", R"("/etc/passwd")",
     "/textures/metal/height_field", "not a path relative to the study"},
    {"path_that_climbs", R"("stimuli/metal.png")", R"("stimuli/../../metal.png")",
     R"("stimuli/../../metal.png")", "/textures/metal/height_field", "points outside the study"},
    {"windows_path", R"("stimuli/metal.png")", R"("C:\\metal.png")", R"("C:\\metal.png")",
     "/textures/metal/height_field", "not a path relative"},
    {"force_band_above_limit", R"("target": 1, "maximum": 2)", R"("target": 1, "maximum": 9)",
     "9},", "/explorations/stroking/normal_force_N/maximum", "limit is 5 N"},
    {"band_upside_down", R"({"minimum": 0.5, "target": 1)", R"({"minimum": 1.5, "target": 1)",
     R"({"minimum": 1.5)", "/explorations/stroking/normal_force_N", "minimum ≤ target"},
    {"stroke_off_the_patch", R"("stroke_length_m": {"target": 0.06})",
     R"("stroke_length_m": {"target": 0.3})", "0.3}",
     "/explorations/stroking/stroke_length_m/target", "does not fit"},
    {"contact_too_long", R"("minimum_contact_s": 2)", R"("minimum_contact_s": 20)", "20,",
     "/explorations/stroking/minimum_contact_s", "removed after 15 s"},
    {"repeats_never", R"("maximum_contact_s": 15)",
     R"("maximum_contact_s": 15, "on_failure": "repeat_now")", R"("repeat_now")",
     "/explorations/stroking/on_failure", "maximum_repeats"},
    {"flagged_and_repeated", R"("maximum_contact_s": 15)",
     R"("maximum_contact_s": 15, "maximum_repeats": 9)", "9",
     "/explorations/stroking/maximum_repeats", "nothing is repeated"},
    {"fraction_of_no_band",
     R"("normal_force_N": {"minimum": 0.5, "target": 1, "maximum": 2},
      "speed_m_per_s": {"minimum": 0.03, "target": 0.06, "maximum": 0.12},)",
     R"("required_fraction_in_band": 0.7, "normal_force_N": {"target": 1},)", R"(0.7, "normal)",
     "/explorations/stroking/required_fraction_in_band",
     "no band to which the fraction could refer"},
    {"guidance_of_no_band",
     R"("normal_force_N": {"minimum": 0.5, "target": 1, "maximum": 2},
      "speed_m_per_s": {"minimum": 0.03, "target": 0.06, "maximum": 0.12},)",
     R"("guidance": "bars",)", R"("bars")", "/explorations/stroking/guidance",
     "no band to indicate"},
    {"target_without_speed", R"("target": 0.06, "maximum": 0.12},)",
     R"("maximum": 0.12}, "guidance": "moving_target",)", R"("moving_target")",
     "/explorations/stroking/guidance", "a speed and a length"},
    {"bars_behind_a_mask", R"("explorations": {
    "stroking": {)",
     R"("environment": {"vision": "blindfold"}, "explorations": {"stroking": {"guidance": "bars",)",
     R"("bars")", "/explorations/stroking/guidance", "sees neither bars"},
    {"impossible_order", R"("maximum_in_a_row": {"texture": 2})",
     R"("listed": [{"texture": "metal"}, {"texture": "metal"}, {"texture": "stone"}], "maximum_in_a_row": {"texture": 1})",
     R"("listed")", "/blocks/main/listed", "exclude each other"},
    {"constraint_on_other_factor", R"("maximum_in_a_row": {"texture": 2})",
     R"("maximum_in_a_row": {"model": 2})", R"("model": 2})", "/blocks/main/maximum_in_a_row/model",
     "applies only to factors that the block crosses, lists or varies"},
    {"unknown_factor", R"("crossed": ["texture"])", R"("crossed": ["textur"])", R"("textur"])",
     "/blocks/main/crossed/0", R"(did you mean "texture"?)"},
    {"unset_factor", R"("crossed": ["texture"],)", "",
     R"({"stimulus": "rendered", "with": {"model": "height_map"}})", "/blocks/main/presented/0",
     R"(needs the factor "texture")"},
    {"unknown_level", R"("with": {"model": "height_map"})", R"("with": {"model": "height"})",
     R"("height"})", "/blocks/main/presented/0/with/model", "is not a level of the factor"},
    {"factor_without_effect", R"("with": {"model": "sinusoid"})",
     R"("with": {"model": "sinusoid", "finger": 1})", R"("finger": 1)",
     "/blocks/main/presented/1/with/finger", R"(no factor "finger")"},
    {"unknown_stimulus", R"({"stimulus": "rendered", "with": {"model": "height_map"}})",
     R"({"stimulus": "render"})", R"("render"})", "/blocks/main/presented/0/stimulus",
     R"(did you mean "rendered"?)"},
    {"unknown_exploration", R"("exploration": "stroking")", R"("exploration": "stroke")",
     R"("stroke")", "/blocks/main/exploration", "no exploration"},
    {"block_never_run", R"({"run": "main", "break_every_trials": 3, "pause": {"minimum_s": 60}})",
     R"({"check": "force_zero"})", R"("main": {)", "/blocks/main", "is never run"},
    {"unknown_block", R"({"run": "main",)", R"({"run": "mian",)", R"("mian")", "/flow/2/run",
     R"(did you mean "main"?)"},
    {"unknown_question", R"({"check": "device"})", R"({"ask": ["mood"]})", R"("mood")",
     "/flow/1/ask/0", "no question"},
    {"nothing_to_counterbalance", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "counterbalance": "williams",)", R"("williams")",
     "/counterbalance", "for_each"},
    {"for_each_of_a_set_factor", R"({"run": "main",)", R"({"run": "main", "for_each": "texture",)",
     R"("texture", "break_every)", "/flow/2/for_each", "already set inside"},
    {"break_without_pause", R"(, "pause": {"minimum_s": 60}})", "}", R"({"run")", "/flow/2",
     R"(needs a "pause")"},
    {"feedback_in_a_selection", R"("positions": "balanced")",
     R"("positions": "balanced", "feedback": "correctness")", R"("correctness")",
     "/blocks/main/feedback", "feedback needs a correct response"},
    {"criterion_in_a_selection", R"("positions": "balanced")",
     R"("positions": "balanced", "until": {"correct": 1, "of_last": 1, "maximum_trials": 6})",
     R"({"correct")", "/blocks/main/until", "needs correct responses"},
    {"blindfold_photograph", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "environment": {"vision": "blindfold"},)",
     R"("photograph")", "/realism_standard", "a blindfolded participant sees no photograph"},
    {"analysis_of_another_kind", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"family": ["pairs", "whole"]},)",
     R"("whole"]})", "/analysis/family/1", "a selection has no test \"whole\"; use \"pairs\""},
    {"analysis_of_no_kind", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"family": ["pears"]},)", R"("pears")",
     "/analysis/family/0",
     "use \"pairs\", \"target_pairs\", \"preference\", \"position\", \"textures\", \"groups\" or "
     "\"group_profiles\""},
    {"analysis_without_target", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"family": ["target_pairs"]},)",
     R"("target_pairs")", "/analysis/family/0", "name it with \"target\""},
    {"analysis_of_nothing_chosen", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"target": "height_mop"},)",
     R"("height_mop")", "/analysis/target", "cannot be chosen"},
    {"equivalence_of_a_selection", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"equivalence_margin": 0.1},)",
     R"("equivalence_margin")", "/analysis/equivalence_margin",
     "only a matching or a recognition has this key"},
    {"analysis_misspelt", R"("realism_standard": "photograph",)",
     R"("realism_standard": "photograph", "analysis": {"familly": ["pairs"], "primary": "text"},)",
     R"("familly")", "/analysis/familly", "did you mean \"family\"?"},
    {"no_standard", R"(  "realism_standard": "photograph",)", "", R"("selection")", "/kind",
     "realism_standard"},
    {"physical_sample_without_prompt", R"("realism_standard": "photograph")",
     R"("realism_standard": "physical_sample")", R"({"name": "most_realistic")",
     "/blocks/main/question", "which sample to place"},
    {"unbalanceable", R"("repetitions": 3)", R"("repetitions": 2)", R"("balanced")",
     "/blocks/main/positions", "multiple of 3"},
    {"picture_missing", R"(, "picture": "stimuli/stone_photo.png")", "",
     R"({"height_field": "stimuli/stone.png")", "/textures/stone", R"(a "picture")"},
    {"same_surface_twice", R"("with": {"model": "sinusoid"})", R"("with": {"model": "height_map"})",
     R"([
        {"stimulus")",
     "/blocks/main/presented", R"(count as "height_map")"},
    {"texture_without_height_field", R"({"height_field": "stimuli/stone.png", )", "{",
     R"("stone"]})", "/factors/texture/levels/1", "cannot be felt"},
    {"observer_without_truth", R"("device": {)",
     R"("observer": {"expectation": "true_surface"}, "device": {)",
     R"({"height_field": "stimuli/metal.png")", "/textures/metal", "true_height_field"},
    {"hed_of_no_level", R"("levels": ["metal", "stone"])",
     R"("levels": ["metal", "stone"], "hed": {"stome": "Sensory-event"})", R"("stome")",
     "/factors/texture/hed/stome", R"(did you mean "stone"?)"},
    {"hed_without_a_tag", R"("levels": ["metal", "stone"])",
     R"("levels": ["metal", "stone"], "hed": {"stone": "Sensory-event, , Item"})",
     R"("Sensory-event, , Item")", "/factors/texture/hed/stone", "a HED tag is missing"},
    {"hed_with_an_open_group", R"("levels": ["metal", "stone"])",
     R"("levels": ["metal", "stone"], "hed": {"stone": "Sensory-event, (Item"})",
     R"("Sensory-event, (Item")", "/factors/texture/hed/stone",
     "an opening parenthesis has no closing one"},
    {"mixed_levels", R"("levels": ["metal", "stone"])", R"("levels": ["metal", 2])", "2]",
     "/factors/texture/levels/1", "all numbers or all names"},
    {"too_many_trials", R"("repetitions": 3)", R"("repetitions": 3000)", "{\n      \"crossed\"",
     "/blocks/main", "too many for a participant"},
};

const Fault kMatching[] = {
    {"too_few_pictures", R"("pictures": ["metal", "stone", "wood", "brick"])",
     R"("pictures": ["metal", "stone", "wood"])", R"(["metal", "stone", "wood"])",
     "/blocks/familiarisation/question/pictures", "as many pictures as surfaces"},
    {"criterion_beyond_reach", R"("correct": 2, "of_last": 3)", R"("correct": 4, "of_last": 3)",
     R"(4, "of_last")", "/blocks/practice/until/correct",
     "the criterion cannot be met: it requires 4 correct of 3"},
    {"criterion_beyond_the_block", R"("maximum_trials": 6)", R"("maximum_trials": 9)", "9,",
     "/blocks/practice/until/maximum_trials", R"(set "repetitions" to 9)"},
    {"blindfold_scene", R"("vision": "blindfold",)",
     R"("vision": "blindfold", "scene": {"visual_texture": "on"},)", R"("scene")",
     "/environment/scene", "a blindfolded participant sees no scene"},
    {"blindfold_pictures", R"("pictures_after_feeling": true)",
     R"("pictures_after_feeling": false)",
     R"(["metal", "stone", "wood", "brick"],
        "reshuffle)",
     "/blocks/familiarisation/question/pictures", "set \"pictures_after_feeling\" to true"},
    {"noise_without_level", R"("kind": "pink", "level_dBA": 65)", R"("kind": "pink")",
     R"({"kind": "pink"})", "/environment/masking_noise", R"(add the key "level_dBA")"},
    {"level_of_no_noise", R"("kind": "pink")", R"("kind": "none")", R"("level_dBA")",
     "/environment/masking_noise/level_dBA", "the noise \"none\" has no level; remove this key"},
    {"speech_for_no_cue", R"("vision": "blindfold",)",
     R"("vision": "blindfold", "speech": {"surfaces_1": "speech/a.wav"},)", R"("surfaces_1")",
     "/environment/speech/surfaces_1", R"(did you mean "surface_1"?)"},
    {"speech_outside_the_study", R"("vision": "blindfold",)",
     R"("vision": "blindfold", "speech": {"surface_1": "../a.wav"},)", R"("../a.wav")",
     "/environment/speech/surface_1", "points outside the study"},
    {"former_vision", R"("vision": "blindfold")", R"("vision": "full")", R"("full")",
     "/environment/vision", R"("free", "hand_occluded" or "blindfold")"},
    {"scene_without_texture", R"("vision": "blindfold",)", R"("vision": "free", "scene": {},)",
     R"({},)", "/environment/scene/visual_texture", "visual_texture"},
    {"mask_with_revisits", R"("allow_revisit": false)", R"("allow_revisit": true)",
     "true,\n        \"allow_revisit\"", "/blocks/familiarisation/question/pictures_after_feeling",
     R"("allow_revisit" to false)"},
};

const Fault kRecognition[] = {
    {"answer_not_shown", R"("pictures": ["metal", "stone")", R"("pictures": ["stone")",
     R"(["stone")", "/blocks/familiarisation/question/pictures",
     R"(correct response "metal" is not among)"},
    {"no_correct_factor", R"("correct_factor": "texture",)", "", R"({
        "name": "recognised")",
     "/blocks/familiarisation/question", "correct_factor"},
    {"unknown_correct_factor", R"("correct_factor": "texture")", R"("correct_factor": "textures")",
     R"("textures",)", "/blocks/familiarisation/question/correct_factor", "did you mean"},
    {"impossible_order", R"("maximum_in_a_row": {"texture": 1})",
     R"("maximum_in_a_row": {"texture": -7})", "-7}", "/blocks/practice/maximum_in_a_row/texture",
     "at least 1"},
    {"condition_on_the_question_of_the_kind", R"("correct_factor": "texture",)",
     R"("correct_factor": "texture", "if": {"question": "recognised", "is": "metal"},)",
     R"("if": {)", "/blocks/familiarisation/question/if",
     "a recognition needs the response to this question in every trial; remove this key"},
    {"condition_without_a_test", R"("correct_factor": "texture",)",
     R"("correct_factor": "texture", "if": {"question": "recognised"},)", R"({"question": "recogn)",
     "/blocks/familiarisation/question/if", "keep one of them"},
    {"condition_with_an_unknown_key", R"("correct_factor": "texture",)",
     R"("correct_factor": "texture", "if": {"question": "recognised", "equals": "metal"},)",
     R"("equals")", "/blocks/familiarisation/question/if/equals", "equals"},
};

INSTANTIATE_TEST_SUITE_P(Syntax, PlantedInSelection, testing::ValuesIn(kSyntax), fault_name);
INSTANTIATE_TEST_SUITE_P(Form, PlantedInSelection, testing::ValuesIn(kForm), fault_name);
INSTANTIATE_TEST_SUITE_P(Meaning, PlantedInSelection, testing::ValuesIn(kMeaning), fault_name);
INSTANTIATE_TEST_SUITE_P(Meaning, PlantedInMatching, testing::ValuesIn(kMatching), fault_name);
INSTANTIATE_TEST_SUITE_P(Meaning, PlantedInRecognition, testing::ValuesIn(kRecognition),
                         fault_name);

TEST(PlantedFaults, AreReportedAllAtOnce) {
  std::string text = test::example_selection();
  const auto plant = [&text](const char* from, const char* to) {
    text.replace(text.find(from), std::string(from).size(), to);
  };
  plant(R"("rate_Hz": 1000)", R"("rate_Hz": "fast")");
  plant(R"("stone": {"height_field")", R"("stone": {"hight": 1, "wide": 2, "height_field")");
  plant(R"("repetitions": 3)", R"("repetitions": 0)");
  plant(R"("minimum_contact_s": 2)", R"("minimum_contact_s": -2)");
  plant(R"({"check": "device"})", R"({"check": "devise"})");
  const std::vector<Diagnostic> problems = problems_of(text);
  std::vector<std::string> pointers{};
  for (const Diagnostic& problem : problems) pointers.push_back(problem.pointer);
  EXPECT_EQ(pointers, (std::vector<std::string>{"/device/rate_Hz", "/textures/stone/hight",
                                                "/textures/stone/wide",
                                                "/explorations/stroking/minimum_contact_s",
                                                "/blocks/main/repetitions", "/flow/1/check"}));
}

TEST(PlantedFaults, OneMistakeGetsOneComplaint) {
  for (const char* const step :
       {R"({"scren": "hi"})", R"({"for_each": "texture"})", "3",
        R"({"check": "device", "screen": "x"})", R"({"chek": "device"})"}) {
    std::string text = test::example_selection();
    const std::string from = R"({"check": "device"})";
    text.replace(text.find(from), from.size(), step);
    EXPECT_EQ(problems_of(text).size(), 1U) << step;
  }
}

TEST(PlantedFaults, AnotherObjectWithAKeyOfTheSameNameIsCheckedStill) {
  nlohmann::json file = test::library_file("roughness_force");
  file["explorations"]["light"]["maximum_contact_s"] = "soon";
  file["explorations"]["medium"]["minimum_contact_s"] = 60;
  std::vector<std::string> places{};
  for (const Diagnostic& problem : problems_of(file.dump(1))) places.push_back(problem.pointer);
  EXPECT_THAT(places, testing::UnorderedElementsAre("/explorations/light/maximum_contact_s",
                                                    "/explorations/medium/minimum_contact_s"));
}

TEST(PlantedFaults, ANumberIsStatedAsItIsWritten) {
  nlohmann::json file = test::library_file("roughness_force");
  file["device"]["rate_Hz"] = 300000;
  const auto problems = problems_of(file.dump(1));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message.english(), testing::StartsWith("300000 is too large"));
}

TEST(PlantedFaults, WhatMayBeDrawnIsCheckedEvenIfItSeldomIs) {
  // A session draws three of the four textures: a lucky one would not come across brick.
  std::string text = test::library_text("chapter_recognition");
  const std::string from = R"("pictures": ["metal", "stone", "wood", "brick", )";
  ASSERT_NE(text.find(from), std::string::npos);
  text.replace(text.find(from), from.size(), R"("pictures": ["metal", "stone", "wood", )");
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.english().find("the correct response \"brick\" is not among"),
            std::string::npos);
}

TEST(PlantedFaults, ASessionWithoutEndIsRefused) {
  std::string text = test::example_selection();
  const std::string run = R"({"run": "main", "break_every_trials": 3, "pause": {"minimum_s": 60}})";
  std::string runs = run;
  for (int i = 0; i < 900; ++i) runs += ", " + run;
  text.replace(text.find(run), run.size(), runs);  // 901 × 6 trials
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.english().find("more than 5000 trials"), std::string::npos);
}

TEST(PlantedFaults, AnOrderThatCannotBeMetIsRefused) {
  std::string text = test::example_selection();
  const std::string from = R"("crossed": ["texture"],)";
  text.replace(text.find(from), from.size(),
               R"("listed": [{"texture": "metal"}, {"texture": "metal"}, {"texture": "metal"},
                             {"texture": "stone"}],)");
  const std::string limit = R"({"texture": 2})";
  text.replace(text.find(limit), limit.size(), R"({"texture": 1})");
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].pointer, "/blocks/main/maximum_in_a_row");
  EXPECT_NE(problems[0].message.english().find("no order of the block's 12 trials"),
            std::string::npos);
}

TEST(PlantedFaults, AMessageBeginsWithFileLineAndColumn) {
  const auto problems = problems_of("{\n  \"format\": 3x\n}");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(text_of(problems[0]).starts_with("p.json:2:14: error: 'x' is not JSON"))
      << text_of(problems[0]);
}

TEST(PlantedFaults, WhatIsNoJsonTextAtAllGetsASentence) {
  const std::string deep(100000, '[');
  const std::pair<std::string, const char*> cases[] = {
      {"", "the file is empty"},
      {"   \n", "the file is empty"},
      {"hello", "'hello' is not JSON"},
      {"[1, 2]", "is not a protocol"},
      {"\"text\"", "is not a protocol"},
      {"\xEF\xBB\xBF{}", "byte order mark"},
      {std::string("\xFF\xFE{\0}\0", 6), "not UTF-8"},
      {std::string("{\0\"\0", 4), "not UTF-8"},
      {"{\"a\": \"\xC3\x28\"}", "not UTF-8"},
      {deep, "nested deeper than 64"},
      {"{\"a\":" + deep, "nested deeper than 64"},
      {"{\"a\": [" + std::string(20000, '1') + "]}", "too large"},
      {"{\"a\": \"" + std::string(9000, 'x') + "\"}", "longer than 8192"},
      {std::string(5U << 20U, ' '), "larger than 4 MiB"},
      {"{\"a\": [0" +
           [] {
             std::string many{};
             for (int i = 0; i < 5000; ++i) many += ",0";
             return many;
           }() +
           "]}",
       "more than 4096 entries"},
      {"{\"a\": 1", "ends before"},
      {"{} {}", "unexpected"},
  };
  for (const auto& [text, words] : cases) {
    const auto problems = problems_of(text);
    ASSERT_EQ(problems.size(), 1U) << text.substr(0, 40);
    EXPECT_NE(problems[0].message.english().find(words), std::string::npos)
        << text.substr(0, 40) << " → " << problems[0].message.english();
  }
}

TEST(PlantedFaults, ASyntaxErrorStatesItsCorrection) {
  struct Case {
    std::string text{};
    std::string place{};  ///< line and column
    std::string correction{};
  };
  const Case cases[] = {
      {"{\n  \"a\": 1\n  \"b\": 2\n}", "3:3", "add a comma after the entry before it"},
      {"{\"a\": [1 2]}", "1:10", "add a comma after the entry before it"},
      {"{\"a\": {} \"b\": 2}", "1:10", "add a comma after the entry before it"},
      {"{\n  \"a\": 1,\n}", "3:1", "delete the comma before it"},
      {"{\"a\": [1, 2,]}", "1:13", "delete the comma before it"},
      {"{\"a\": 1,, \"b\": 2}", "1:9", "delete this comma"},
      {"{\"a\": 0,2}", "1:9", "write a decimal point in place of the comma before it"},
      {"{\n\u00a0 \"a\": 1}", "2:1",
       "there is a no-break space (U+00A0) here; write a space instead"},
      {"{\u201ca\u201d: 1}", "1:2",
       "a typographic quotation mark (U+201C) here; write straight quotation marks"},
      {"{\"a\": \u22121}", "1:7", "a minus sign (U+2212) here; write a hyphen (-) instead"},
      {"{\"a\": 1\u200b}", "1:8", "a zero-width space (U+200B) here; delete it"},
      {"{\n  \"a\": \"one,\n  \"b\": 2\n}", "2:13", "add the closing quotation mark on this line"},
      {"{\"a\": \"one", "1:11", "add the closing quotation mark"},
      {"{\n  \"a: \"one\"\n}", "2:8", "close every quotation mark"},
      {"{\"a\" 1}", "1:6", "write a colon between a key and its value"},
      {"{\"a\":: 1}", "1:6", "delete this colon"},
      {"{\"a\": }", "1:7", "write a value after the colon"},
      {"{\"a\": [1, 2}", "1:12", "close the list with ']'"},
      {"{\"a\": 1}}", "1:9", "closing bracket too many"},
      {"{a: 1}", "1:2", "write the key in \"quotation marks\""},
      {"{'a': 1}", "1:2", "double quotation marks"},
      {"{\"a\": 1 // one\n}", "1:9", "\"$comment\""},
      {"{\"a\": \"C:\\data\"}", "1:11", "write \\\\ for a backslash"},
      {"{\"a\": \"one\ttwo\"}", "1:11", "the control character U+0009; write \\t for it"},
      {"{\"a\": \"\x1b\"}", "1:8", "the control character U+001B; write \\u001B for it"},
      {"{\"a\": \"\\u12\"}", "1:12", "four hexadecimal digits"},
      {"{\"a\": \"\\ud83d\"}", "1:14", "half of a pair"},
      {"{@: 1}", "1:2", "unexpected '@'"},
      {"{\"a\": [1, @]}", "1:11", "unexpected '@'"}};
  for (const Case& one : cases) {
    const auto problems = problems_of(one.text);
    ASSERT_EQ(problems.size(), 1U) << one.text;
    EXPECT_THAT(text_of(problems[0]), testing::StartsWith("p.json:" + one.place + ": "))
        << one.text;
    EXPECT_THAT(problems[0].message.english(), testing::HasSubstr(one.correction)) << one.text;
    EXPECT_EQ(test::untranslated(problems[0].message), "") << one.text;
  }
}

class PlantedInMagnitude : public testing::TestWithParam<Fault> {};
TEST_P(PlantedInMagnitude, IsRefusedAtItsPlace) {
  expect_complaint(planted(test::library_text("roughness_diameter"), GetParam()), GetParam());
}
INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedInMagnitude,
    testing::Values(
        Fault{"NoEstimation", R"("estimation": {"spacing": "texture", "condition": "tip"},)", "",
              R"("magnitude")", "/kind", "add the key \"estimation\""},
        Fault{"AnUnknownSpacing", R"("spacing": "texture",)", R"("spacing": "textur",)",
              R"("textur",)", "/estimation/spacing", "did you mean \"texture\"?"},
        Fault{"SpacingAndConditionInOne", R"("condition": "tip")", R"("condition": "texture")",
              R"("texture"})", "/estimation/condition", "the same factor"},
        Fault{"ATextureWithoutSpacing", R"("spacing_m": 0.0005,)", "",
              R"({
      "height_field": "stimuli/cones_05.png")",
              "/textures/spacing_05", "give it a \"spacing_m\""},
        Fault{"SpacingsThatAreNoTextures", R"("spacing": "texture",)", R"("spacing": "tip",)",
              R"("sphere_1mm", "sphere_2mm")", "/factors/tip/levels/0",
              "neither a number nor a texture"},
        Fault{"AMixedCondition", R"("crossed": ["texture"])", R"("crossed": ["texture", "tip"])",
              R"({
      "phase": "main")",
              "/blocks/main", "run this block \"for_each\" level of \"tip\""},
        Fault{"AConditionThatNothingSets", R"("for_each": "tip",)", "", R"({
      "phase": "main")",
              "/blocks/main", "this main block does not set the condition \"tip\""},
        Fault{"AnAnchorOfAnotherFactor", R"("anchor": {"texture": "spacing_14"})",
              R"("anchor": {"texture": "spacing_14", "tip": "sphere_1mm"})",
              R"("tip": "sphere_1mm"})", "/blocks/main/anchor/tip", "remove it from the anchor"},
        Fault{"AnAnchorOfNoLevel", R"("anchor": {"texture": "spacing_14"})",
              R"("anchor": {"texture": "spacing_15"})", R"("spacing_15"})",
              "/blocks/main/anchor/texture", "is not a level of the factor"},
        Fault{"ACannotTell", R"("allow_revisit": false)",
              R"("allow_revisit": false, "allow_cannot_tell": true)", R"("allow_cannot_tell")",
              "/blocks/practice/question/allow_cannot_tell", "discrimination has this key"},
        Fault{"Feedback", R"("exploration": "stroking")",
              R"("exploration": "stroking", "feedback": "correctness")", R"("correctness")",
              "/blocks/practice/feedback",
              "no response of a magnitude estimation is correct or incorrect"},
        Fault{"LevelsThatAreNoExplorations", R"("exploration": "stroking")",
              R"("exploration": {"factor": "texture"})", R"("spacing_05", "spacing_07")",
              "/factors/texture/levels/0", "there is no exploration \"spacing_05\""},
        Fault{"AnExpectation", R"("magnitude_of": "lateral_force",)", R"("expectation": "prior",)",
              R"("prior")", "/observer/expectation", "set this to \"none\""}),
    [](const auto& given) { return given.param.name; });

/// Every layer finds something: a form that is wrong hides no meaning, and neither the other.
TEST(Problems, OfAllLayersAreReportedAtOnceInTheOrderOfLines) {
  std::string text = test::example_selection();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace(R"("kind": "selection")", R"("name": "example_selection", "kind": "staircase")");
  replace(R"("height_field": ")", R"("height_field": "../)");
  replace(R"("exploration": "stroking")", R"("exploration": "strokin")");
  replace(R"({"check": "device"})", R"({"check": "devise"})");
  const std::vector<Diagnostic> problems = problems_of(text);
  std::vector<std::string> messages{};
  for (const Diagnostic& problem : problems) messages.push_back(problem.message.english());
  EXPECT_THAT(messages,
              testing::ElementsAre(testing::HasSubstr("\"staircase\" is not permitted here"),
                                   testing::HasSubstr("the key 'name' occurs twice"),
                                   testing::HasSubstr("points outside the study"),
                                   testing::HasSubstr("there is no exploration \"strokin\""),
                                   testing::HasSubstr("\"devise\" is not permitted here")));
  EXPECT_TRUE(
      std::is_sorted(problems.begin(), problems.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; }));
}

/// What depends on a wrong value is no second problem.
TEST(Problems, OfOneWrongValueAreOne) {
  struct {
    const char* protocol;
    const char* from;
    const char* to;
    const char* pointer;
    const char* words;
  } const kCases[] = {
      // A name that the blocks need.
      {"chapter_selection", R"("model": {"factor": "model"})", R"("model": {"factor": "mode"})",
       "/stimuli/rendered/model/factor", "did you mean \"model\"?"},
      {"chapter_selection", R"("model": {"factor": "model"})", R"("model": {"factor": 3})",
       "/stimuli/rendered/model/factor", "write text in quotation marks"},
      // A level that a block lists.
      {"chapter_selection", R"("levels": ["metal")", R"("levels": ["meta")",
       "/factors/texture/levels/0", "did you mean \"metal\"?"},
      {"chapter_selection", R"("levels": ["metal")", R"("levels": [3)", "/factors/texture/levels/0",
       "use names as its levels"},
      // A surface that the analysis is about.
      {"chapter_selection", R"("stimulus": "rendered")", R"("stimulus": "rendere")",
       "/blocks/main/presented/0/stimulus", "did you mean \"rendered\"?"},
      // A block without which there is no practice.
      {"amplitude_jnd", R"("run": "practice")", R"("run": "practic")", "/flow/6/run",
       "did you mean \"practice\"?"},
      // A number in quotation marks, to which the levels refer.
      {"amplitude_jnd", R"("amplitude_m": 5e-05)", R"("amplitude_m": "5e-05")",
       "/stimuli/grating/parameters/amplitude_m", "without quotation marks"},
      {"amplitude_jnd", R"("relative_to": "standard")", R"("relative_to": "standar")",
       "/blocks/practice/vary/relative_to", "has the role \"standar\""},
  };
  for (const auto& each : kCases) {
    const std::string text = replaced(test::library_text(each.protocol), each.from, each.to);
    const std::vector<Diagnostic> problems = problems_of(text);
    std::string all{};
    for (const Diagnostic& problem : problems) all += text_of(problem) + '\n';
    ASSERT_EQ(problems.size(), 1U) << each.to << '\n' << all;
    EXPECT_EQ(problems[0].pointer, each.pointer) << all;
    EXPECT_THAT(problems[0].message.english(), testing::HasSubstr(each.words));
  }
}

TEST(Problems, OfTwoWrongValuesAreTwo) {
  std::string text = replaced(test::library_text("chapter_selection"),
                              R"("model": {"factor": "model"})", R"("model": {"factor": "mode"})");
  text = replaced(text, R"("levels": ["metal")", R"("levels": ["meta")");
  std::vector<std::string> places{};
  for (const Diagnostic& problem : problems_of(text)) places.push_back(problem.pointer);
  EXPECT_THAT(places,
              testing::ElementsAre("/factors/texture/levels/0", "/stimuli/rendered/model/factor"));
}

TEST(Problems, HideNoLevelOfTheSameFactor) {
  for (const auto& [from, to] :
       {std::pair(R"("levels": ["metal", "stone"])", R"("levels": ["metal", "granite"], "x": 1)"),
        std::pair(R"("levels": ["metal", "stone"])", R"("levels": [true, "granite"])")}) {
    std::string text = test::example_selection();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(from).size(), to);
    std::vector<std::string> messages{};
    for (const Diagnostic& problem : problems_of(text))
      messages.push_back(problem.message.english());
    EXPECT_EQ(messages.size(), 2U);
    EXPECT_THAT(messages, testing::Contains(testing::HasSubstr("there is no texture \"granite\"")))
        << to;
  }
}

TEST(Problems, OfABinaryFileSayThatItIsNoText) {
  for (const std::string& bytes : {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
                                   std::string("\xff\xd8\xff\xe0", 4), std::string("{  \0}", 5)}) {
    const std::vector<Diagnostic> problems = problems_of(bytes);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems[0].message.english(), testing::StartsWith("this is not a JSON text file"));
  }
}

TEST(Problems, OfAZeroByteHaveItsPlace) {
  std::string text = test::example_selection();
  const std::string end = R"("version": "1.0.0",)";
  text.insert(text.find(end),
              std::string(600, ' ') + '\n');  // further than the beginning of the file
  const std::size_t at = text.find(end) + end.size();
  text.insert(at, 1, '\0');
  const std::vector<Diagnostic> problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message.english(),
              testing::StartsWith("the file contains a zero byte (U+0000); delete"));
  const auto [line, column] = place_in(text, end);
  EXPECT_EQ(problems[0].line, line);
  EXPECT_EQ(problems[0].column, column + static_cast<int>(end.size()));
}

TEST(Problems, NameTypesInPlainEnglish) {
  std::string text = test::example_selection();
  const std::string title = R"("title": ")";
  const std::size_t at = text.find(title);
  text.replace(at, text.find('"', at + title.size()) + 1 - at, R"("title": 3)");
  const std::vector<Diagnostic> problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message.english(),
              testing::StartsWith("3 is not permitted here: write text in quotation marks"));
}

TEST(Problems, OfAValueInAnotherUnitAreOneAndStateTheValueThatWasMeant) {
  struct {
    const char* protocol;
    const char* from;
    const char* to;
    const char* pointer;
    const char* words;
  } const kCases[] = {
      // Ranges of the schema, of a table of keys, of a model, and those that depend on other values.
      {"roughness_diameter", R"("spacing_m": 0.0005)", R"("spacing_m": 500)",
       "/textures/spacing_05/spacing_m",
       "500 is too large: it must be at most 1; lengths are in metres: 500 mm is 0.5, and 500 µm "
       "is 0.0005. Expected here: "},
      {"roughness_force", R"("force_limit_N": 5)", R"("force_limit_N": 5000)",
       "/device/force_limit_N", "at most 20; forces are in newtons: 5000 mN is 5"},
      {"amplitude_jnd", R"("wavelength_m": 0.0025)", R"("wavelength_m": 2.5)",
       "/stimuli/grating/parameters/wavelength_m", "lengths are in metres: 2.5 mm is 0.0025"},
      {"roughness_force", R"({"minimum": 0.03, "target": 0.05)",
       R"({"minimum": 30, "target": 0.05)", "/explorations/light/stroke_length_m/minimum",
       "enlarge the patch; lengths are in metres: 30 mm is 0.03"},
      {"roughness_force", R"("target": 2, "maximum": 2.6)", R"("target": 2000, "maximum": 2.6)",
       "/explorations/firm/normal_force_N/target",
       "raise the limit; forces are in newtons: 2000 mN is 2"},
  };
  for (const auto& each : kCases) {
    const std::string text = replaced(test::library_text(each.protocol), each.from, each.to);
    const std::vector<Diagnostic> problems = problems_of(text);
    ASSERT_EQ(problems.size(), 1U) << each.to;
    EXPECT_EQ(problems[0].pointer, each.pointer);
    EXPECT_THAT(problems[0].message.english(), testing::HasSubstr(each.words));
  }
}

/// What is doubted of the library's protocol of three forces with one text in place of another.
std::vector<Diagnostic> warnings_with(const std::string& from, const std::string& to) {
  const std::string text = replaced(test::library_text("roughness_force"), from, to);
  std::vector<Diagnostic> warnings =
      warnings_about(read_protocol(text, "p.json", test::example_models()), "p.json");
  test::expect_translatable(warnings);
  return warnings;
}

TEST(Warnings, AreAboutWhatIsValidAndMayNotBeMeant) {
  struct {
    const char* from;
    const char* to;
    const char* pointer;
    const char* words;
  } const kCases[] = {
      {R"("required_fraction_in_band": 0.6,)", "", "/explorations/light/on_failure",
       "while \"required_fraction_in_band\" is 0"},
      {R"("maximum_contact_s": 8)", R"("maximum_contact_s": 2)",
       "/explorations/light/strokes/target", "do not fit into the 2 s"},
      {R"("strokes": {"minimum": 2, "target": 3})", R"("strokes": {"minimum": 30, "target": 40})",
       "/explorations/light/strokes/minimum", "30 strokes of 0.03 m at 0.09 m/s"},
      {R"({"minimum": 0.04, "target": 0.06, "maximum": 0.09})",
       R"({"minimum": 40, "target": 60, "maximum": 90})",
       "/explorations/light/speed_m_per_s/minimum", "metres per second: 40 mm/s is 0.04"},
      {R"("target": 2, "maximum": 2.6)", R"("target": 4.5, "maximum": 4.8)",
       "/explorations/firm/normal_force_N/target", "set 4 N or less"},
      {R"(back and forth, from left to right. Two bars)", R"(back and forth. Two low tones)",
       "/flow/4/screen", "mentions \"tones\""},
  };
  for (const auto& each : kCases) {
    const std::vector<Diagnostic> warnings = warnings_with(each.from, each.to);
    ASSERT_EQ(warnings.size(), 1U) << each.to;
    EXPECT_EQ(warnings[0].pointer, each.pointer);
    EXPECT_NE(warnings[0].message.english().find(each.words), std::string::npos)
        << warnings[0].message.english();
    EXPECT_GT(warnings[0].line, 1);
  }
}

TEST(Warnings, AreAboutAnExplorationThatNoBlockAsksFor) {
  const auto warnings = warnings_with(R"("explorations": {)", R"("explorations": {"spare": {},)");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].pointer, "/explorations/spare");
}

TEST(Warnings, AreAboutASelectionAmongLevelsOfOneParameter) {
  std::string text = test::example_selection();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(
      warnings_about(read_protocol(text, "p.json", test::example_models()), "p.json").empty());
  replace(R"("levels": ["height_map", "sinusoid", "stochastic"])", R"("levels": [0.1, 0.2, 0.3])");
  replace(R"("model": {"factor": "model"},)",
          R"("model": "height_map", "parameters": {"height_scale": {"factor": "model"}},)");
  replace(R"("texture": {"factor": "texture"},
      "equal_force": {"to_model": "height_map"})",
          R"("texture": {"factor": "texture"})");
  replace(R"({"model": "height_map"}})", R"({"model": 0.1}, "item": "weak"})");
  replace(R"({"model": "sinusoid"}})", R"({"model": 0.2}, "item": "middle"})");
  replace(R"({"model": "stochastic"}})", R"({"model": 0.3}, "item": "strong"})");
  const auto warnings =
      warnings_about(read_protocol(text, "p.json", test::example_models()), "p.json");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].pointer, "/blocks/main/presented");
  EXPECT_NE(warnings[0].message.english().find("differ in \"height_scale\" alone"),
            std::string::npos)
      << warnings[0].message.english();
  EXPECT_NE(warnings[0].message.english().find("not whether levels can be discriminated"),
            std::string::npos);
}

TEST(PlantedFaults, ColumnsCountCharactersNotBytes) {
  const auto problems = problems_of("{\"ä\": 1, \"ö\": x}");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].column, 15);  // {"ä": 1, "ö": is 14 characters long
}

TEST(PlantedFaults, CommentsAndExtensionsAreNone) {
  std::string text = test::example_selection();
  const std::string from = R"("textures": {)";
  text.replace(text.find(from), from.size(),
               R"("x-lab": [1], "$comment": "why", "textures": {"$comment": "two", "x-y": 3,)");
  EXPECT_TRUE(problems_of(text).empty());
}

// The schema is what an editor shows: everything in it says what it is.
void expect_described(const nlohmann::json& root, const nlohmann::json& schema,
                      const std::string& where) {
  const nlohmann::json& node =
      schema.contains("$ref")
          ? root.at(nlohmann::json::json_pointer(schema.at("$ref").get<std::string>().substr(1)))
          : schema;
  EXPECT_FALSE(node.value("description", "").empty()) << where;
  if (schema.contains("$ref")) return;
  const auto properties = node.find("properties");
  if (properties == node.end()) return;
  for (const auto& [key, member] : properties->items()) {
    expect_described(root, member, where + "/" + key);
  }
}

TEST(Schema, DescribesEveryKeyForTheEditor) {
  const nlohmann::json& root = protocol_schema();
  expect_described(root, root, "");
}

}  // namespace
}  // namespace asperity
