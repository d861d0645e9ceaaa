// Composes each protocol from the common keys and the blocks of one task.

#include "tests/journeys/small_tasks.h"

#include "tests/journeys/small_study.h"

namespace asperity::test {

nlohmann::ordered_json three_tasks() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["kind"] = "rating";
  protocol["name"] = "three_tasks";
  protocol["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
  protocol["groups"] = {{"factor", "training"}, {"assigned", "balanced"}};
  protocol["stimuli"]["plain"] =
      nlohmann::ordered_json::parse(R"({"model": "height_map", "texture": {"factor": "texture"}})");
  nlohmann::ordered_json selection = protocol["blocks"]["main"];
  selection["kind"] = "selection";
  const nlohmann::ordered_json asked = selection["question"];
  selection.erase("question");
  selection["questions"] = {
      asked,
      {{"name", "sure"}, {"prompt", "How sure?"}, {"scale", nlohmann::ordered_json::object()}}};
  nlohmann::ordered_json recognition = small_recognition(2)["blocks"]["main"];
  recognition["kind"] = "recognition";
  recognition["presented"] = {{{"stimulus", "plain"}}};
  nlohmann::ordered_json ratings = recognition;
  ratings.erase("kind");
  ratings.erase("question");
  ratings["repetitions"] = 1;
  ratings["question_layout"] = "one_page";
  ratings["question_order"] = "shuffle";
  for (const char* const name : {"rough", "hard", "slippery", "coarse", "pleasant"}) {
    ratings["questions"].push_back({{"name", name},
                                    {"prompt", std::string("How ") + name + "?"},
                                    {"scale", {{"minimum", 1}, {"maximum", 7}, {"points", 7}}}});
  }
  protocol["blocks"] = {
      {"ratings", ratings}, {"recognition", recognition}, {"selection", selection}};
  protocol["flow"] = nlohmann::ordered_json::parse(
      R"([{"run": "ratings"}, {"run": "recognition"}, {"run": "selection"}])");
  return protocol;
}

nlohmann::ordered_json pairs_of_models() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["kind"] = "paired_comparison";
  protocol["name"] = "pairs_of_models";
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("positions");
  block["all_pairs"] = {{"factor", "model"}, {"in_both_orders", true}};
  block["presented"] = {{{"stimulus", "rendered"}}};
  block["question"]["tie"] = {{"text", "Neither"}};
  return protocol;
}

nlohmann::ordered_json rated_pairs_of_models(int parts) {
  nlohmann::ordered_json protocol = small_selection(1);
  protocol["kind"] = "similarity";
  protocol["name"] = "rated_pairs";
  protocol.erase("realism_standard");
  protocol["factors"] = nlohmann::ordered_json::parse(
      R"({"model": {"levels": ["height_map", "bump_map", "normal_map", "lateral_gradient", "sinusoid"]}})");
  protocol["stimuli"] = nlohmann::ordered_json::parse(
      R"({"rendered": {"model": {"factor": "model"}, "texture": "walnut"}})");
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("crossed");
  block["positions"] = "shuffle";
  block["all_pairs"] = {{"factor", "model"}, {"with_identical", true}, {"parts", parts}};
  block["presented"] = {{{"stimulus", "rendered"}}};
  block["question"] = nlohmann::ordered_json::parse(
      R"({"name": "different", "prompt": "How different were they?",
          "scale": {"minimum": 0, "maximum": 100, "labels": ["identical", "completely different"]}})");
  return protocol;
}

nlohmann::ordered_json staircases() {
  nlohmann::ordered_json protocol = small_selection(2);
  protocol["kind"] = "discrimination";
  protocol["name"] = "staircases";
  for (const char* const key : {"textures", "factors", "realism_standard", "analysis"})
    protocol.erase(key);
  protocol["stimuli"] = nlohmann::ordered_json::parse(
      R"({"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}})");
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  for (const char* const key :
       {"crossed", "listed", "drawn", "repetitions", "order", "maximum_in_a_row"}) {
    block.erase(key);
  }
  block["vary"] = nlohmann::ordered_json::parse(
      R"({"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
          "levels_percent": {"lowest": 5, "highest": 100, "step": 5}})");
  block["procedure"] = nlohmann::ordered_json::parse(
      R"({"method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10], "stop": {"trials": 4},
          "tracks": [{"start": 50}, {"start": 25}]})");
  block["presented"] = nlohmann::ordered_json::parse(
      R"([{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}])");
  block["positions"] = "balanced";
  block["question"] = {
      {"name", "rougher"}, {"prompt", "Which is rougher?"}, {"judgement", "performance"}};
  return protocol;
}

nlohmann::ordered_json same_different() {
  nlohmann::ordered_json protocol = staircases();
  protocol["name"] = "same_different";
  protocol["observer"]["different_above"] = 0.2;
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("procedure");
  block["design"] = "same_different";
  block["vary"].erase("levels_percent");
  block["vary"]["levels_percent"] = {20, 60};
  block["question"] = nlohmann::ordered_json::parse(
      R"({"name": "different", "prompt": "Same or different?", "judgement": "performance",
          "options": [{"value": "same", "text": "The same"}, {"value": "different", "text": "Different"}]})");
  return protocol;
}

nlohmann::ordered_json choice_of_three(const std::string& design) {
  nlohmann::ordered_json protocol = staircases();
  protocol["name"] = "choice_of_three";
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("procedure");
  block["design"] = design;
  block["vary"].erase("levels_percent");
  block["vary"]["levels_percent"] = {20, 60, 90};
  return protocol;
}

nlohmann::ordered_json tracks_of_oddity() {
  nlohmann::ordered_json protocol = staircases();
  protocol["blocks"]["main"]["design"] = "oddity";
  return protocol;
}

nlohmann::ordered_json psi_track() {
  nlohmann::ordered_json protocol = staircases();
  protocol["name"] = "psi_track";
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block["vary"]["levels_percent"] = {{"lowest", 2}, {"highest", 100}, {"step", 2}};
  block["procedure"] = nlohmann::ordered_json::parse(
      R"({"method": "psi", "target": 0.75,
          "prior": {"threshold": {"lowest": 2, "highest": 100, "count": 41},
                    "slope": {"lowest": 1, "highest": 8, "count": 8},
                    "lapse": {"lowest": 0, "highest": 0.06, "count": 4}},
          "marginalise": ["slope", "lapse"], "stop": {"trials": 6},
          "catch_trials": {"level": 150, "every": 3}})");
  return protocol;
}

nlohmann::ordered_json magnitude_estimates() {
  nlohmann::ordered_json protocol = small_selection(3);
  protocol["kind"] = "magnitude";
  protocol["name"] = "magnitude_estimates";
  protocol.erase("realism_standard");
  protocol["factors"].erase("model");
  protocol["stimuli"]["rendered"]["model"] = "height_map";
  protocol["estimation"] = nlohmann::ordered_json::parse(
      R"({"factor": "texture", "modulus": {"standard": "walnut", "value": 10}})");
  nlohmann::ordered_json& block = protocol["blocks"]["main"];
  block.erase("positions");
  block["presented"] = nlohmann::ordered_json::parse(
      R"([{"role": "standard", "stimulus": "rendered", "with": {"texture": "walnut"}},
          {"role": "target", "stimulus": "rendered"}])");
  block["question"] = {{"name", "roughness"}, {"prompt", "How rough did it feel?"}};
  protocol["observer"]["expectation"] = "none";
  return protocol;
}

}  // namespace asperity::test
