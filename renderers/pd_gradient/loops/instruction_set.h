// Declares the vector instruction sets of the sample loops.

#pragma once

#include <vector>

namespace asperity {

struct SampleLoops;
struct TriangleLoops;

/// The instruction sets. All sets use the same source with the same operations in the same order and without fused
/// multiplications: the results are identical to the bit, and wider sets are faster. x86-64 only.
enum class InstructionSet { sse2, avx2, avx512 };

/// The name of the set: "sse2", "avx2", "avx512".
const char* name_of(InstructionSet set) noexcept;

/// The sets that this processor and system support, the widest last; never empty.
std::vector<InstructionSet> instruction_sets_here();

/// The loops that are compiled for a set.
const SampleLoops& loops_of(InstructionSet set) noexcept;
const TriangleLoops& triangle_loops_of(InstructionSet set) noexcept;

}  // namespace asperity
