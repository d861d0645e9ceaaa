// What the loops over triangles read and write, and the table of those that are compiled.

#pragma once

#include <cstddef>
#include <cstdint>

namespace asperity {

// C arrays: the loops may use nothing of the standard library (see README.md).

inline constexpr int kClusterSize = 16;

/// Sixteen triangles, in metres from the mesh's centre: [corner][axis][lane].
struct alignas(64) TriangleCluster {
  float corners[3][3][kClusterSize];
  float low[3][kClusterSize];
  float high[3][kClusterSize];  ///< below `low` in a lane that holds no triangle
  std::uint32_t triangles[kClusterSize];
  std::uint32_t used;  ///< bit i: lane i holds a triangle
  // All of them lie between two planes: low ≤ normal · place ≤ high, unit length but for rounding.
  float slab_normal[3];
  float slab_low_m;
  float slab_high_m;
};

/// The boxes of sixteen clusters; those that there are not are empty likewise.
struct alignas(64) ClusterBoxes {
  float low[3][kClusterSize];
  float high[3][kClusterSize];
};

struct TriangleClusters {
  const TriangleCluster* clusters = nullptr;
  std::size_t count = 0;
  const ClusterBoxes* boxes = nullptr;
};

/// From A's frame to B's, both with their origins in the meshes' centres.
struct ClusterPose {
  float turn[9] = {};  ///< row after row
  float shift_m[3] = {};
  float tolerance_m = 0.0F;  ///< nearer to touching than this, single precision cannot say
};

/// Receives a pair; not sure: it may be apart by less than the tolerance.
using TakePair = void (*)(void* to, std::uint32_t a, std::uint32_t b, bool is_sure) noexcept;

/// The loop for one instruction set. Real-time: no allocation, no lock, no exception.
struct TriangleLoops {
  void (*find_pairs)(const TriangleClusters& a, const TriangleClusters& b, const ClusterPose& pose,
                     TakePair take, void* to) noexcept = nullptr;
};

extern const TriangleLoops kSse2TriangleLoops;
extern const TriangleLoops kAvx2TriangleLoops;
extern const TriangleLoops kAvx512TriangleLoops;

}  // namespace asperity
