// Edits the flow of the protocol as JSON, and copies the files that it names.

#include "app/tasks/mouse_trial.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/session/levels/external_program.h"
#include "app/session/session_setup.h"
#include "protocols/plan/groups.h"
#include "protocols/shapes/key.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr int kNoLimit = 100'000;

using Json = nlohmann::ordered_json;

/// The introduction, what is read and asked before the first block, the first main block, and the rest, which is not reached.
Json flow_of(const Protocol& protocol, const Json& flow, const std::string& introduction) {
  const auto runs = [](const Json& step) { return step.contains("run"); };
  const auto first = std::find_if(flow.begin(), flow.end(), runs);
  const auto main = std::find_if(first, flow.end(), [&](const Json& step) {
    return runs(step) && protocol.blocks.at(step.at("run").get<std::string>()).phase == Phase::main;
  });
  const auto tried = main == flow.end() ? first : main;
  Json edited = Json::array();
  edited.push_back(Json::object({{"screen", introduction}}));
  for (auto step = flow.begin(); step != first; ++step) {
    if (step->contains("screen") || step->contains("ask")) edited.push_back(*step);
  }
  Json run = *tried;
  for (const char* key : {"break_every_trials", "break_every_contact_minutes", "pause"}) {
    run.erase(key);
  }
  edited.push_back(std::move(run));
  for (auto step = first; step != flow.end(); ++step) {
    if (step != tried) edited.push_back(*step);
  }
  return edited;
}

}  // namespace

std::string mouse_trial_text(const Protocol& protocol, const std::string& introduction) {
  Json json = Json::parse(protocol.source);
  json["flow"] = flow_of(protocol, json.at("flow"), introduction);
  const Json declared = json.value("device", Json::object());
  Json device{{"input_only", true},
              {"maximum_missed_deadlines", kNoLimit},
              {"maximum_gaps_in_contact", kNoLimit},
              {"maximum_lost_records", kNoLimit}};
  for (const char* key : {"rate_Hz", "force_limit_N"}) {
    if (declared.contains(key)) device[key] = declared.at(key);
  }
  json["device"] = std::move(device);
  if (json.contains("environment")) json["environment"].erase("masking_noise");
  // The group is chosen here, also where another rule assigns those of participants.
  if (json.contains("groups")) {
    json["groups"] = {{"factor", json["groups"].at("factor")}, {"assigned", "by_experimenter"}};
  }
  // A trial with the mouse need not comply with the instructions: none is repeated.
  json.erase("instability");
  for (auto& [name, exploration] : json.at("explorations").items()) {
    if (is_comment(name)) continue;
    exploration["on_failure"] = "flag";
    exploration.erase("maximum_repeats");
  }
  return json.dump(2);
}

MouseTrial::MouseTrial(const Protocol& protocol, const std::filesystem::path& study,
                       const std::string& introduction, std::uint64_t seed,
                       const std::string& group) {
  if (!blocks_of_external_program(protocol).empty()) {
    throw PhrasedError(phrase("MouseTrial",
                              "the protocol takes its levels from an external program; run a pilot "
                              "session with the mouse to try it"));
  }
  inputs_.study = work_.path() / "study";
  inputs_.protocol = inputs_.study / "protocols" / (protocol.name + ".json");
  Study::create(inputs_.study, protocol.name);
  copy_files(protocol, study, inputs_.study);
  write_file(inputs_.protocol, mouse_trial_text(protocol, introduction), Overwrite::refuse);
  inputs_.participant = "try";
  inputs_.new_person = ParticipantRow{.label = inputs_.participant};
  inputs_.consent.emplace();  // nobody is asked
  inputs_.seed = seed;
  inputs_.mode = SessionMode::pilot;
  inputs_.device = "mouse";
  inputs_.on_gpu = false;
  if (protocol.groups) inputs_.group = group.empty() ? groups_of(protocol).front() : group;
}

}  // namespace asperity
