// How much faster than real time a virtual session runs: the demo study, session by
// session, through the same conductor, servo loop and store as any other, on one core.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/study_files/program.h"
#include "app/tasks/new_study.h"
#include "app/tasks/simulation/simulation.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

constexpr int kParticipants = 10;

struct Case {
  std::string name{};
  std::vector<double> speed{};  // seconds of session per second
};

double quantile_of(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const auto index = static_cast<std::size_t>(p * static_cast<double>(values.size() - 1));
  return values[index];
}

Case measure(const std::string& protocol, Recordings recordings,
             const std::filesystem::path& study) {
  const ModelRegistry models = built_in_models();
  Case measured{protocol + (recordings == Recordings::all ? "/recorded" : ""), {}};
  for (int i = 0; i < kParticipants; ++i) {
    SimulationInputs inputs{};
    inputs.protocols = {study / "protocols" / (protocol + ".json")};
    inputs.study = study;
    inputs.seed = 1;
    inputs.recordings = recordings;
    const SimulationResult result = simulate(
        inputs, models, {}, [](double) {}, [](const AttemptDone&) {});
    measured.speed.push_back(result.simulated_s / result.wall_s);
  }
  return measured;
}

int run(bool json) {
  std::string pattern = (std::filesystem::temp_directory_path() / "asperity-bench-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) return 1;
  const std::filesystem::path study = std::filesystem::path(pattern) / "study";
  new_demo_study(study, [](double) {});
  std::vector<Case> cases{};
  for (const char* protocol : {"chapter_selection", "chapter_matching", "chapter_recognition"}) {
    cases.push_back(measure(protocol, Recordings::none, study));
  }
  cases.push_back(measure("chapter_matching", Recordings::all, study));
  std::filesystem::remove_all(pattern);

  const ProgramIdentity program = this_program();
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", program.os},
                                  {"commit", program.commit},
                                  {"isa", program.instruction_set},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Case& measured : cases) {
    // The slow tail is the low one: p99 is what 99 % of the sessions exceed.
    document["cases"].push_back({{"name", measured.name},
                                 {"unit", "s of session per s"},
                                 {"p50", quantile_of(measured.speed, 0.5)},
                                 {"p99", quantile_of(measured.speed, 0.01)},
                                 {"p99_9", quantile_of(measured.speed, 0.001)},
                                 {"count", measured.speed.size()},
                                 {"preempted", nullptr}});
  }
  if (json) {
    std::puts(document.dump(2).c_str());
  } else {
    for (const auto& measured : document["cases"]) {
      std::printf("%-32s median %6.0f, slowest %6.0f times real time\n",
                  measured["name"].get<std::string>().c_str(), measured["p50"].get<double>(),
                  measured["p99"].get<double>());
    }
  }
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  return asperity::run(argc > 1 && std::strcmp(argv[1], "--json") == 0);
}
