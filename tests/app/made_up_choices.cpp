// Draws choices from psychometric functions with fixed seeds, and keeps their analyses.

#include "tests/app/made_up_choices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "app/exports/export_study.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/words/text_parts.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"

namespace asperity {

using nlohmann::json;

json discrimination_protocol(const std::string& judgement, double standard_m) {
  json protocol = json::parse(R"({"kind": "discrimination",
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {}}},
    "blocks": {"only": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "which", "prompt": "Which is rougher?"}}},
    "analysis": {"family": ["order", "conditions", "point_of_subjective_equality"]}})");
  protocol["stimuli"]["grating"]["parameters"]["amplitude_m"] = standard_m;
  protocol["blocks"]["only"]["question"]["judgement"] = judgement;
  return protocol;
}

MadeUpTrial discriminated(const MadeUpChoice& choice) {
  MadeUpTrial trial{};
  json factors{{"amplitude_m", choice.value_m}};
  if (!choice.texture.empty()) factors["texture"] = choice.texture;
  trial.factors_json = factors.dump();
  trial.surfaces = {surface_of("standard", "sinusoid", ""),
                    surface_of("comparison", "sinusoid", "")};
  if (choice.comparison_first) std::swap(trial.surfaces[0], trial.surfaces[1]);
  trial.answers = {choice.chose_comparison ? "comparison" : "standard"};
  trial.options = {"standard", "comparison"};
  trial.block = choice.block;
  if (choice.is_performance) trial.right = {"comparison"};
  return trial;
}

std::vector<MadeUpTrial> trials_of(const std::vector<MadeUpChoice>& choices) {
  std::vector<MadeUpTrial> trials{};
  for (const MadeUpChoice& choice : choices) trials.push_back(discriminated(choice));
  return trials;
}

AnalysisOutcome outcome_of_discrimination(MadeUpStudy& made) {
  std::vector<AnalysisOutcome> outcomes = analyze_study(made.study(), std::nullopt, {});
  EXPECT_EQ(outcomes.size(), 1U);
  return std::move(outcomes.front());
}

AnalysisOutcome outcome_of_choices(const json& protocol, const MadeUpParticipants& people,
                                   const TrialsOfParticipant& trials_of) {
  return analysed("discrimination", protocol.dump(), people, trials_of);
}

const AnalysisOutcome& outcome_of_observers(const MadeUpObservers& observers) {
  const PsychometricFunction& f = observers.function;
  const std::string key = outcome_key("observers", static_cast<int>(f.shape), f.alpha, f.beta,
                                      f.gamma, f.lambda, observers.people, observers.is_performance,
                                      observers.per_level, observers.bias_to_first);
  return outcome_once(key, [&] {
    const bool is_performance = observers.is_performance;
    const json protocol = discrimination_protocol(is_performance ? "performance" : "comparison");
    return outcome_of_choices(protocol, {.number = observers.people}, [&](int person) {
      MadeUpObserver observer(f, static_cast<unsigned>(100 + person));
      observer.bias_to_first = observers.bias_to_first;
      return trials_of(observer.choices(is_performance ? kAbove_m : kAround_m, observers.per_level,
                                        is_performance));
    });
  });
}

const AnalysisOutcome& outcome_of_performers() {
  return outcome_of_observers({.function = kPerformer, .people = 12});
}

const AnalysisOutcome& outcome_of_comparers() {
  return outcome_of_observers({.function = kComparer, .people = 12, .is_performance = false});
}

std::vector<std::map<std::string, std::string>> wide_rows(MadeUpStudy& made) {
  ExportOptions options{};
  options.formats = {ExportFormat::wide};
  export_study(made.study(), built_in_models(), made.beside("wide"), options);
  std::istringstream file(read_file(made.beside("wide") / "wide.csv"));
  std::vector<std::string> names{};
  std::vector<std::map<std::string, std::string>> rows{};
  for (std::string line{}; std::getline(file, line);) {
    if (line.ends_with('\r')) line.pop_back();
    const std::vector<std::string> cells = parts_of(line, ',');
    if (names.empty()) {
      names = cells;
      continue;
    }
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
  }
  return rows;
}

json staircase_protocol(int trials) {
  json protocol = discrimination_protocol("performance");
  json& block = protocol["blocks"]["only"];
  block["vary"].erase("levels");
  block["vary"]["levels_percent"] = {{"lowest", 2}, {"highest", 100}, {"step", 2}};
  block["procedure"] = {{"method", "transformed_up_down"},
                        {"down", 3},
                        {"up", 1},
                        {"steps", {16, 8, 4}},
                        {"stop", {{"trials", trials}}},
                        {"tracks", {{{"start", 50}}, {{"start", 34}}}}};
  return protocol;
}

std::vector<MadeUpTrial> staircase_trials(const PsychometricFunction& observer,
                                          const json& protocol, std::uint64_t seed) {
  const Protocol::Block block = stored_protocol(protocol.dump()).protocol.blocks.at("only");
  std::vector<MadeUpTrial> trials{};
  for (std::size_t i = 0; i < block.procedure->tracks.size(); ++i) {
    const auto chance = [&](double level) {
      return observer.value(block.vary->value_of(level) - kStandard_m);
    };
    const Random of_track = Random(seed).split(static_cast<std::uint64_t>(i));
    int step = 0;
    for (const LevelAnswer& answer :
         simulated_track(block.procedure->tracks[i], chance, of_track)) {
      MadeUpTrial trial =
          discriminated({.value_m = block.vary->value_of(answer.level),
                         .chose_comparison = answer.outcome == LevelOutcome::correct,
                         .comparison_first = step % 2 == 0});
      trial.track = static_cast<int>(i) + 1;
      trial.step = ++step;
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

AnalysisOutcome outcome_of_staircases(const json& protocol, int people, std::size_t kept) {
  return outcome_of_choices(protocol, {.number = people}, [&](int person) {
    std::vector<MadeUpTrial> trials =
        staircase_trials(kPerformer, protocol, 200 + static_cast<std::uint64_t>(person));
    trials.resize(std::min(kept, trials.size()));
    return trials;
  });
}

const AnalysisOutcome& outcome_of_twelve_staircases() {
  return outcome_once("staircases",
                      [] { return outcome_of_staircases(staircase_protocol(40), 12, 80); });
}

json psi_protocol(int trials) {
  json protocol = staircase_protocol(trials);
  protocol["blocks"]["only"]["procedure"] = {
      {"method", "psi"},
      {"stop", {{"trials", trials}}},
      {"tracks", json::array({json::object(), json::object()})}};
  return protocol;
}

}  // namespace asperity
