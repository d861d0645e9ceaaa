// Reads processor, load and compiler, and warns if other programs use the computer.

#include "app/timing/timing_machine.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "analysis/numbers/number_text.h"
#include "app/study_files/program.h"
#include "device/machine.h"
#include "renderers/pd_gradient/loops/instruction_set.h"

namespace asperity {

namespace {

constexpr double kMostLoad = 0.5;

#if defined(__clang__)
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "gcc " __VERSION__;
#endif

}  // namespace

TimingMachine this_machine() {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  double load = 0.0;
  if (getloadavg(&load, 1) != 1) load = 0.0;
  return {.processor = machine(),
          .cores = cores,
          .load_per_core = load / cores,
          .program = version_line(),
          .build = program_build(),
          .compiler = kCompiler,
          .instruction_set = name_of(instruction_sets_here().back())};
}

std::vector<std::string> timing_warnings(const TimingMachine& machine) {
  std::vector<std::string> warnings;
  if (machine.build != "Release") {
    const std::string kind =
        machine.build.empty() ? "a build without a type" : "the build type " + machine.build;
    warnings.push_back(
        "this program has " + kind +
        ", whose ticks take longer; measure with a release build (cmake --preset release)");
  }
  if (machine.load_per_core > kMostLoad) {
    warnings.push_back("other programs use this computer (load average " +
                       fixed(machine.load_per_core, 1) +
                       " per core); end them, and measure again when it is below 0.5");
  }
  return warnings;
}

}  // namespace asperity
