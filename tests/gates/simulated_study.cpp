// Makes the demonstration study, simulates a changed protocol in it, and counts its attempts.

#include "tests/gates/simulated_study.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "app/tasks/new_study.h"
#include "app/tasks/simulation/simulation.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

using json = nlohmann::ordered_json;

json library_json(std::string_view name) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (protocol.name == name) return json::parse(protocol.text);
  }
  throw std::invalid_argument("no library protocol " + std::string(name));
}

void keep_the_main_block(json& protocol, int repetitions) {
  json main = protocol["blocks"]["main"];
  main["repetitions"] = repetitions;
  protocol["blocks"] = json{{"main", main}};
  protocol["flow"] = json::array({json{{"run", "main"}}});
  // Rests are waited for tick by tick.
  for (const char* pause : {"pause_before_trial_s", "pause_between_surfaces_s"}) {
    protocol["blocks"]["main"].erase(pause);
  }
}

void judge_with(json& protocol, GateObserver observer) {
  json& declared = protocol["observer"];
  declared["deaf"] = observer == GateObserver::deaf;
  declared["feature_noise"] = 0.0;
  declared["position_bias"] = 0.0;
  declared["lapse"] = 0.0;
}

std::string order_of(const AttemptRow& attempt) {
  std::string order{};
  for (const PresentationRow& surface : attempt.presentations) order += surface.item + ' ';
  return order;
}

void count(const AttemptRow& attempt, GateCounts& counts) {
  ++counts.trials;
  bool whole = true;
  bool guessed = true;
  for (const ResponseRow& response : attempt.responses) {
    ++counts.items;
    ++counts.chosen[response.answer];
    const bool right = response.correct.value_or(false);
    if (right) ++counts.right;
    whole = whole && right;
    guessed = guessed && response.source == "virtual_guess";
  }
  if (whole) ++counts.whole;
  if (guessed) ++counts.guess_sources;
  ++counts.orders[order_of(attempt)];
}

}  // namespace

Protocol library_protocol(std::string_view name, const std::function<void(json&)>& change) {
  json protocol = library_json(name);
  if (change) change(protocol);
  return read_protocol(protocol.dump(1), std::string(name), declarations_of(built_in_models()));
}

SimulatedStudy::SimulatedStudy() {
  new_demo_study(folder_ / "study", [](double) {});
}

GateCounts SimulatedStudy::run(const GateDesign& design) {
  json protocol = library_json(design.protocol);
  keep_the_main_block(protocol, design.repetitions);
  judge_with(protocol, design.observer);
  if (design.strokes) protocol["explorations"]["stroking"]["strokes"]["target"] = *design.strokes;
  const std::filesystem::path file = folder_ / (std::string(design.protocol) + ".json");
  std::ofstream(file, std::ios::binary) << protocol.dump(1);
  SimulationInputs inputs{};
  inputs.protocols = {file};
  inputs.study = folder_ / "study";
  inputs.participants = design.participants;
  inputs.recordings = Recordings::none;
  const ModelRegistry models = built_in_models();
  for (const std::uint64_t seed : design.seeds) {
    inputs.seed = seed;
    (void)simulate(inputs, models, {}, {}, {});
  }

  GateCounts counts{};
  const Study study = Study::open(folder_ / "study", Access::read_only);
  for (const SessionRow& session : study.sessions()) {
    if (study.protocol(session.protocol_id).source != protocol.dump(1)) continue;
    std::string before{};
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      if (!attempt.valid || attempt.responses.empty()) continue;
      count(attempt, counts);
      if (!before.empty()) ++counts.order_pairs[{before, order_of(attempt)}];
      before = order_of(attempt);
    }
  }
  return counts;
}

}  // namespace asperity
