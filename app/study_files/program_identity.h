// Version, commit and build type of the program, which the build writes (cmake/program_identity.cmake).

#pragma once

namespace asperity {

extern const char kProgramVersion[];
extern const char kProgramCommit[];  ///< "unknown" without git
extern const char kProgramBuild[];   ///< the build type of CMake, empty for none

}  // namespace asperity
