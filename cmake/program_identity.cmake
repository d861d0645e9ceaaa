# Writes program_identity.h; run at every build, so that the commit is the one that was built.
# Input: SOURCE_DIR OUTPUT VERSION BUILD
set(commit "unknown")
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty=+changes --abbrev=12 --exclude=*
  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed EQUAL 0)
  set(commit "${described}")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [[
// Generated: which program this is.
#pragma once

namespace asperity {
inline constexpr char kProgramVersion[] = "@VERSION@";
inline constexpr char kProgramCommit[] = "@commit@";
inline constexpr char kProgramBuild[] = "@BUILD@";
}  // namespace asperity
]] @ONLY)
