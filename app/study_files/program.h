// Which program this is: what every session stores of it.

#pragma once

#include <string>

namespace asperity {

struct ProgramIdentity {
  std::string version{};
  std::string commit{};
  std::string build{};
  std::string sha256{};           ///< of the executable
  std::string instruction_set{};  ///< what the numerical code was compiled for
  std::string os{};  ///< kernel, processor, C library (whose mathematics the forces rest on)
};

/// Of the running program. Reads the executable once per call.
ProgramIdentity this_program();

/// "0.1.0"
std::string program_version();
/// "asperity 0.1.0 (commit 1a2b3c4, Release)"
std::string version_line();

}  // namespace asperity
