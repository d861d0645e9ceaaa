# Writes program_identity.cpp; run at every build, so that the commit is the one that was built.
# Input: SOURCE_DIR OUTPUT VERSION BUILD
set(commit "unknown")
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty=+changes --abbrev=12 --exclude=*
  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed EQUAL 0)
  set(commit "${described}")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [[
// Generated: which program this is.

#include "app/study_files/program_identity.h"

namespace asperity {
const char kProgramVersion[] = "@VERSION@";
const char kProgramCommit[] = "@commit@";
const char kProgramBuild[] = "@BUILD@";
}  // namespace asperity
]] @ONLY)
