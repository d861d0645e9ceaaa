// Combines version, build, instruction set and C library with the checksum of the executable.

#include "app/study_files/program.h"

#include <sys/utsname.h>
#include <system_error>

#include <gnu/libc-version.h>

#include "app/study_files/program_identity.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

namespace {

const char* compiled_instruction_set() {
#if defined(__AVX512F__)
  return "avx512";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__SSE2__)
  return "sse2";
#else
  return "generic";
#endif
}

std::string c_library() { return std::string("glibc ") + gnu_get_libc_version(); }

ProgramIdentity identified() {
  ProgramIdentity identity{};
  identity.version = kProgramVersion;
  identity.commit = kProgramCommit;
  identity.build = kProgramBuild;
  identity.sha256 = sha256_of_file("/proc/self/exe");
  identity.instruction_set = compiled_instruction_set();
  utsname system{};
  if (uname(&system) == 0) {
    identity.os = std::string(system.sysname) + ' ' + system.release + ' ' + system.machine + ", " +
                  c_library();
  }
  return identity;
}

}  // namespace

const ProgramIdentity& this_program() {
  static const ProgramIdentity identity = identified();
  return identity;
}

std::filesystem::path program_file() {
  std::error_code unseen{};
  std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe", unseen);
  return std::filesystem::exists(file, unseen) ? file : std::filesystem::path{};
}

std::string program_version() { return kProgramVersion; }

std::string program_build() { return kProgramBuild; }

std::string version_line() {
  return std::string("asperity ") + kProgramVersion + " (commit " + kProgramCommit + ", " +
         kProgramBuild + ")";
}

std::string numerical_identity() {
  return version_line() + ", " + compiled_instruction_set() + ", " + c_library();
}

}  // namespace asperity
