// Which vector instructions the loops over samples use.

#pragma once

#include <vector>

namespace asperity {

struct SampleLoops;

/// Same source, same operations in the same order, no fused multiplications: every set gives the
/// same bits, wider ones sooner. x86-64 only.
enum class InstructionSet { sse2, avx2, avx512 };

/// "sse2", "avx2", "avx512".
const char* name_of(InstructionSet set) noexcept;

/// Those that this processor and system can run, the widest last; never empty.
std::vector<InstructionSet> instruction_sets_here();

/// The loops over samples that are compiled for a set.
const SampleLoops& loops_of(InstructionSet set) noexcept;

}  // namespace asperity
