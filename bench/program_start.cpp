// Measures the processor time of `asperity --version`: what it costs to start the program.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"

namespace asperity {
namespace {

constexpr int kStarts = 20;

double milliseconds_of(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

/// User and system time of one process, from its start to its end; none where it fails.
std::optional<double> start_ms(const std::filesystem::path& program) {
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(127);
    execl(program.c_str(), program.c_str(), "--version", nullptr);
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) != child || status != 0) {
    return std::nullopt;
  }
  return milliseconds_of(used.ru_utime) + milliseconds_of(used.ru_stime);
}

int run(bool json) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "asperity";
  std::vector<double> times_ms{};
  start_ms(program);  // reads its files into memory
  for (int i = 0; i < kStarts; ++i) {
    const std::optional<double> time_ms = start_ms(program);
    if (!time_ms) {
      std::fprintf(stderr, "%s --version fails; build the target asperity first.\n",
                   program.c_str());
      return 1;
    }
    times_ms.push_back(*time_ms);
  }
  std::sort(times_ms.begin(), times_ms.end());
  const double median_ms = 0.5 * (times_ms[kStarts / 2 - 1] + times_ms[kStarts / 2]);
  if (json) {
    const nlohmann::json result{
        {"machine", machine()},
        {"commit", ASPERITY_COMMIT},
        {"cases",
         {{{"name", "version/cpu"}, {"unit", "ms"}, {"p50", median_ms}, {"count", kStarts}}}}};
    std::printf("%s\n", result.dump(2).c_str());
  } else {
    std::printf("asperity --version: %.1f ms of processor time (median of %d, %.1f to %.1f)\n",
                median_ms, kStarts, times_ms.front(), times_ms.back());
  }
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
  if (argc > 1 && !json) {
    std::fprintf(stderr, "Usage: bench_program_start [--json]\n");
    return 2;
  }
  return asperity::run(json);
}
