// Declares what times of ticks depend on: the computer, its load and the build of the program.

#pragma once

#include <string>
#include <vector>

namespace asperity {

struct TimingMachine {
  std::string processor{};
  unsigned cores = 1;
  double load_per_core = 0.0;  ///< the mean of the last minute
  std::string program{};       ///< "asperity 0.2.0 (commit 1a2b3c4, Release)"
  std::string build{};         ///< "Release"
  std::string compiler{};
  std::string instruction_set{};  ///< of the search for contacts
};

TimingMachine this_machine();

/// Reasons for which times on this machine are not those of the program: another build than a release build, a load of more than 0.5
/// per core.
std::vector<std::string> timing_warnings(const TimingMachine& machine);

}  // namespace asperity
