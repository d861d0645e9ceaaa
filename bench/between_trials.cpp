// The wall-clock time from the commit of an attempt to the presentation of the next trial's first surface: in a block whose
// levels are fixed, and in one whose levels a staircase chooses from the responses, with the same stimuli. The participant
// responds after a time in which the stimuli of the possible next trials are made; for comparison, also without making
// them ahead.

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/session/conductor.h"
#include "app/study_files/program.h"
#include "app/tasks/new_study.h"
#include "app/tasks/protocol_files.h"
#include "device/machine.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {
namespace {

using Clock = std::chrono::steady_clock;

/// Less than a person takes to explore two surfaces and to respond.
constexpr std::chrono::milliseconds kTrial{1500};

/// Answers after a fixed time: the other seconds between its questions are those of the program.
class PromptRespondent final : public Respondent {
 public:
  explicit PromptRespondent(std::chrono::milliseconds delay) : delay_(delay) {}
  void committed() { committed_ = Clock::now(); }
  std::map<std::string, std::vector<double>> between_s{};  ///< by block

  void read(const std::string&, double, const Wait&) override {}
  void announce(const Trial& trial, const PlannedPresentation& surface) override {
    if (surface.position != 1 || !committed_) return;
    if (trial.block == block_) {
      between_s[trial.block].push_back(
          std::chrono::duration<double>(Clock::now() - *committed_).count());
    }
    block_ = trial.block;
    committed_.reset();
  }
  Reply ask(const Trial& trial, std::span<const Question>, std::span<const ForceFeatures>,
            std::optional<double>, const Wait&) override {
    std::this_thread::sleep_for(delay_);
    Random random = Random(1).split(static_cast<std::uint64_t>(trial.ordinal));
    return {only_answer(ChosenOption{static_cast<std::size_t>(random.below(2))})};
  }
  void tell(const std::string&, const Wait&) override {}
  std::optional<Answer> answer(const Question&, const Wait&) override { return {}; }
  std::string source() const override { return "virtual_guess"; }
  void begin_attempt(int, int) override {}

 private:
  std::chrono::milliseconds delay_{};
  std::optional<Clock::time_point> committed_{};
  std::string block_{};
};

/// Two blocks of 24 trials with the same stimuli: `stimulus` with `parameter` varied by per cent of the standard.
std::string protocol_text(const std::string& stimulus, const std::string& parameter) {
  const std::string surfaces =
      R"("presented": [{"role": "standard", "stimulus": "surface"}, {"role": "comparison", "stimulus": "surface"}],
      "positions": "balanced", "exploration": "short", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"})";
  const std::string vary =
      R"("vary": {"parameter": ")" + parameter +
      R"(", "of": "comparison", "relative_to": "standard", "levels_percent": )";
  return R"({"format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "between",
    "version": "1.0.0", "title": "Between trials", "consent": {"version": "1.0", "statement": "Nobody takes part."},
    "textures": {"stone": {"height_field": "stimuli/stone.png"},
      "file": {"height_field": "stimuli/file_fine.png"}, "studs": {"height_field": "stimuli/file_plate.png"}},
    "bodies": {"plate": {"shape": "plate", "size_m": [0.1, 0.06, 0.01], "texture": "studs"},
      "file": {"shape": "cylinder", "diameter_m": 0.00764, "length_m": 0.008, "axis": "y", "texture": "file"}},
    "stimuli": {"surface": )" +
         stimulus + R"(},
    "explorations": {"short": {"minimum_contact_s": 0.05, "maximum_contact_s": 1}},
    "blocks": {
      "fixed": {)" +
         vary + R"([5, 10, 15, 20, 25, 30, 35, 40]}, "repetitions": 3, )" + surfaces + R"(},
      "staircase": {)" +
         vary + R"({"lowest": 5, "highest": 40, "step": 5}},
        "procedure": {"method": "transformed_up_down", "down": 3, "up": 1, "steps": [10, 5], "stop": {"trials": 12},
                      "tracks": [{"start": 20}, {"start": 40}]}, )" +
         surfaces + R"(}},
    "flow": [{"run": "fixed"}, {"run": "staircase"}]})";
}

/// Letters and digits only.
std::string label_of(std::string model) {
  std::erase_if(model, [](unsigned char c) { return std::isalnum(c) == 0; });
  return model;
}

double percentile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

std::map<std::string, std::vector<double>> between_trials(const std::filesystem::path& folder,
                                                          const std::string& text,
                                                          const std::string& participant,
                                                          bool makes_ahead) {
  const ModelRegistry models = built_in_models();
  const std::filesystem::path file = folder / "protocols" / (participant + ".json");
  write_file(file, text, Overwrite::allow);
  const Protocol protocol = load_protocol(file, models, folder);
  Study study = Study::open(folder, Access::read_write);
  study.add_participant({.label = participant, .created_utc = "2026-01-01T00:00:00.000Z"});
  StimulusBuilder builder(models, folder);
  SteppedRig rig(rig_settings_for(protocol, {}), 0);
  PromptRespondent respondent(makes_ahead ? kTrial : std::chrono::milliseconds(0));
  SessionConditions conditions{};
  conditions.seed = 1;
  conditions.pacing = rig.pacing();
  conditions.started_utc = rig.clock().utc();
  conditions.device = rig.capability();
  Conductor conductor(study, protocol, builder, rig, respondent,
                      {.record = true,
                       .makes_ahead = makes_ahead,
                       .done = [&respondent](const AttemptDone&) { respondent.committed(); }});
  conductor.run(begin_session(study, protocol, participant, conditions, this_program()));
  return respondent.between_s;
}

int run(bool json) {
  std::string pattern = (std::filesystem::temp_directory_path() / "asperity-bench-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) return 1;
  const std::filesystem::path folder = std::filesystem::path(pattern) / "study";
  new_demo_study(folder, [](double) {});
  const ProgramIdentity program = this_program();
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", program.commit},
                                  {"isa", program.instruction_set},
                                  {"cases", nlohmann::ordered_json::array()}};
  const std::map<std::string, std::string> texts{
      {"sinusoid",
       protocol_text(
           R"({"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}})",
           "amplitude_m")},
      {"height_map",
       protocol_text(
           R"({"model": "height_map", "texture": "stone", "parameters": {"height_scale": 1}})",
           "height_scale")},
      // The amplitude is solved again for every level.
      {"height_map, equal force",
       protocol_text(
           R"({"model": "height_map", "texture": "stone", "parameters": {"lateral_gradient_gain": 0.5},
             "equal_force": {"rms_N": 0.05}})",
           "lateral_gradient_gain")},
      {"pd_gradient",
       protocol_text(
           R"({"model": "pd_gradient", "texture": "file", "surface": "plate", "tool": "file",
             "parameters": {"cell_m": 0.00007, "step_m": 0.00007, "texture_gain": 1}})",
           "texture_gain")}};
  std::vector<std::pair<std::string, bool>> measured_models{};
  for (const auto& [model, text] : texts) {
    for (const bool makes_ahead : {true, false}) measured_models.emplace_back(model, makes_ahead);
  }
  for (const auto& [model, makes_ahead] : measured_models) {
    const std::string name = model + (makes_ahead ? "" : ", not made ahead");
    for (const auto& [block, times_s] :
         between_trials(folder, texts.at(model), label_of(name), makes_ahead)) {
      document["cases"].push_back({{"name", name + '/' + block},
                                   {"unit", "s"},
                                   {"p50", percentile(times_s, 0.5)},
                                   {"p95", percentile(times_s, 0.95)},
                                   {"p99", percentile(times_s, 0.99)},
                                   {"count", times_s.size()},
                                   {"preempted", nullptr}});
    }
  }
  std::filesystem::remove_all(pattern);
  if (json) {
    std::puts(document.dump(2).c_str());
    return 0;
  }
  for (const auto& measured : document["cases"]) {
    std::printf("%-52s median %7.2f ms, p95 %7.2f ms, %d intervals\n",
                measured["name"].get<std::string>().c_str(), 1e3 * measured["p50"].get<double>(),
                1e3 * measured["p95"].get<double>(), measured["count"].get<int>());
  }
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  return asperity::run(argc > 1 && std::strcmp(argv[1], "--json") == 0);
}
