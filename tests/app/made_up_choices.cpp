#include "tests/app/made_up_choices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric_function.h"
#include "app/exports/export_study.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/study/discrimination_tracks.h"
#include "app/words/text_parts.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/atomic_file.h"
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

AnalysisOutcome outcome_of_observers(const PsychometricFunction& function, int people,
                                     const std::vector<double>& values_m, bool is_performance,
                                     int per_level, double bias_to_first) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol(
      "jnd", "discrimination",
      discrimination_protocol(is_performance ? "performance" : "comparison").dump());
  for (int person = 0; person < people; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    MadeUpObserver observer(function, static_cast<unsigned>(100 + person));
    observer.bias_to_first = bias_to_first;
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(observer.choices(values_m, per_level, is_performance)));
  }
  return outcome_of_discrimination(made);
}

std::vector<Finding> part_of(const AnalysisOutcome& outcome, const std::string& analysis) {
  std::vector<Finding> part{};
  std::copy_if(outcome.findings.begin(), outcome.findings.end(), std::back_inserter(part),
               [&](const Finding& each) { return each.analysis == analysis; });
  return part;
}

const NamedTable& discrimination_table(const AnalysisOutcome& outcome, const std::string& name) {
  const auto found = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                                  [&name](const NamedTable& each) { return each.name == name; });
  if (found == outcome.tables.end()) throw std::runtime_error("there is no table " + name);
  return *found;
}

std::string answer_to(const AnalysisOutcome& outcome, const std::string& name) {
  const auto found =
      std::find_if(outcome.questions.begin(), outcome.questions.end(),
                   [&name](const AnsweredQuestion& each) { return each.name == name; });
  return found == outcome.questions.end() ? std::string() : found->answer.english();
}

std::string sentence_about(const AnalysisOutcome& outcome, const std::string& test,
                           const std::string& about) {
  for (const TestSentence& each : outcome.test_sentences) {
    if (each.test == test && (about.empty() || each.about == about)) return each.text;
  }
  return {};
}

std::map<std::string, std::string> wide_row(MadeUpStudy& made, std::size_t row) {
  ExportOptions options{};
  options.formats = {ExportFormat::wide};
  export_study(made.study(), built_in_models(), made.beside("wide"), options);
  std::istringstream file(read_file(made.beside("wide") / "wide.csv"));
  std::string header{};
  std::string line{};
  std::getline(file, header);
  for (std::size_t i = 0; i <= row; ++i) std::getline(file, line);
  for (std::string* const each : {&header, &line}) {
    if (each->ends_with('\r')) each->pop_back();
  }
  const std::vector<std::string> names = parts_of(header, ',');
  const std::vector<std::string> cells = parts_of(line, ',');
  std::map<std::string, std::string> found{};
  for (std::size_t i = 0; i < names.size(); ++i) found[names[i]] = cells.at(i);
  return found;
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
  const StoredProtocol::Block block = stored_protocol(protocol.dump()).blocks.at("only");
  std::vector<MadeUpTrial> trials{};
  for (std::size_t i = 0; i < block.tracks.size(); ++i) {
    const auto chance = [&](double level) {
      return observer.value(block.vary->value_of(level) - kStandard_m);
    };
    const Random of_track = Random(seed).split(static_cast<std::uint64_t>(i));
    int step = 0;
    for (const LevelAnswer& answer : simulated_track(block.tracks[i], chance, of_track)) {
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
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  for (int person = 0; person < people; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials =
        staircase_trials(kPerformer, protocol, 200 + static_cast<std::uint64_t>(person));
    trials.resize(std::min(kept, trials.size()));
    made.add_session(label, id, trials);
  }
  return outcome_of_discrimination(made);
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
