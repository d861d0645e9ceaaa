// Identifies the program, as stored with every session.

#pragma once

#include <filesystem>
#include <string>

namespace asperity {

struct ProgramIdentity {
  std::string version{};
  std::string commit{};
  std::string build{};
  std::string sha256{};           ///< of the executable
  std::string instruction_set{};  ///< for which the numerical code was compiled
  /// Kernel, processor, C library (on whose mathematical functions the forces depend).
  std::string os{};
};

/// The identity of the running program. The first call reads the executable.
const ProgramIdentity& this_program();

/// The executable; empty where it was replaced or removed since the program was started.
std::filesystem::path program_file();

/// "0.2.0"
std::string program_version();
/// "Release": the build type, empty for none.
std::string program_build();
/// "asperity 0.2.0 (commit 1a2b3c4, Release)"
std::string version_line();
/// The same with what else determines the bytes of results (docs/decisions/004-floating-point.md): the instruction set for which
/// the numerical code was compiled, and the C library. "asperity 0.2.0 (commit 1a2b3c4, Release), sse2, glibc 2.36"
std::string numerical_identity();

}  // namespace asperity
