// Implements the detection of the instruction sets of the processor and the system.

#include "renderers/pd_gradient/loops/instruction_set.h"

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {

const char* name_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::sse2:
      return "sse2";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "";
}

std::vector<InstructionSet> instruction_sets_here() {
  std::vector<InstructionSet> sets{InstructionSet::sse2};
  if (!__builtin_cpu_supports("avx2")) return sets;
  sets.push_back(InstructionSet::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")) {
    sets.push_back(InstructionSet::avx512);
  }
  return sets;
}

const SampleLoops& loops_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::sse2:
      return kSse2Loops;
    case InstructionSet::avx2:
      return kAvx2Loops;
    case InstructionSet::avx512:
      return kAvx512Loops;
  }
  return kSse2Loops;
}

const TriangleLoops& triangle_loops_of(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::sse2:
      return kSse2TriangleLoops;
    case InstructionSet::avx2:
      return kAvx2TriangleLoops;
    case InstructionSet::avx512:
      return kAvx512TriangleLoops;
  }
  return kSse2TriangleLoops;
}

}  // namespace asperity
