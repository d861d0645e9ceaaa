// Declares the input and output of the triangle loops, and the table of the compiled ones.

#pragma once

#include <cstddef>
#include <cstdint>

namespace asperity {

// C arrays: the loops must not use the standard library (see README.md).

inline constexpr int kClusterSize = 16;

/// Sixteen triangles, in metres from the mesh's centre: [corner][axis][lane].
struct alignas(64) TriangleCluster {
  float corners[3][3][kClusterSize];
  float low[3][kClusterSize];
  float high[3][kClusterSize];  ///< below `low` in a lane without a triangle
  std::uint32_t triangles[kClusterSize];
  std::uint32_t used;  ///< bit i: lane i contains a triangle
  // All of them lie between two planes: low ≤ normal · place ≤ high, with unit length except for rounding.
  float slab_normal[3];
  float slab_low_m;
  float slab_high_m;
};

/// The boxes of sixteen clusters; `high` is below `low` for missing ones.
struct alignas(64) ClusterBoxes {
  float low[3][kClusterSize];
  float high[3][kClusterSize];
};

struct TriangleClusters {
  const TriangleCluster* clusters = nullptr;
  std::size_t count = 0;
  const ClusterBoxes* boxes = nullptr;
};

/// A part of a search of all pairs. Positions count the sixteen places of a cluster of A with a cluster of B, in the order of the
/// search: all of B for the first cluster of A, then all of B for the second.
struct SearchPart {
  std::size_t first = 0;
  /// In units of about ten nanoseconds; the triangle of A with which it is reached is compared to the end.
  std::size_t most_work = static_cast<std::size_t>(-1);
  // What the search returns:
  std::size_t next = 0;  ///< the first position that has not been searched
  std::size_t work = 0;
};

/// Sixteen pairs of triangles, in metres from the centres of their meshes: [corner][axis][lane].
struct alignas(64) PairBatch {
  float a[3][3][kClusterSize];
  float b[3][3][kClusterSize];
};

/// The verdicts on sixteen pairs at one pose. Bit i is for pair i.
struct alignas(64) PairVerdicts {
  std::uint32_t together = 0;  ///< not found to be separate
  std::uint32_t unsure = 0;    ///< of these, the ones too close to touching for a decision
  /// The verdict remains true until a point of A has moved this far relative to B; if it is not above 0, the distance is unknown.
  float slack_m[kClusterSize] = {};
};

/// The region between two planes perpendicular to a unit vector.
struct Slab {
  float normal[3];
  float low_m = 0.0F;
  float high_m = 0.0F;
};

/// A box as the intersection of three slabs, and a direction: triangles face it if their outer sides are less than 90° from it.
struct SlabBox {
  Slab slabs[3];
  float facing[3];
};

/// The transformation from A's frame to B's, both with their origins in the meshes' centres.
struct ClusterPose {
  float turn[9] = {};  ///< row by row
  float shift_m[3] = {};
  float tolerance_m = 0.0F;  ///< within this distance of touching, single precision does not decide
};

using TakePair = void (*)(void* to, std::uint32_t a, std::uint32_t b) noexcept;

inline constexpr int kSegmentLanes = 8;

/// Eight triangles in a body's frame: [corner][axis][lane], and their unit normals.
struct alignas(64) SegmentTriangles {
  double corners[3][3][kSegmentLanes];
  double normal[3][kSegmentLanes];
};

/// The pose of a body in the world.
struct PlacedBody {
  double turn[9] = {};  ///< row by row
  double shift_m[3] = {};
};

/// The segments in which eight pairs of triangles intersect, in the world; zero for a pair that does not intersect in a segment.
struct alignas(64) Segments {
  double ends_m[2][3][kSegmentLanes];
  double length_m[kSegmentLanes];
  double middles_m2[3][kSegmentLanes];   ///< the middle times the length
  double normals_a_m[3][kSegmentLanes];  ///< the normal of A's triangle times the length
  double normals_b_m[3][kSegmentLanes];
};

/// The loops for one instruction set. Real-time: no allocation, no lock, no exception.
struct TriangleLoops {
  /// The pairs that are not separated by more than the tolerance along the axes of B's frame or a normal of either triangle: all that
  /// are within the tolerance of each other, and others.
  void (*find_candidates)(const TriangleClusters& a, const TriangleClusters& b,
                          const ClusterPose& pose, SearchPart& part, TakePair take,
                          void* to) noexcept = nullptr;
  /// Tests sixteen pairs with separating axes.
  void (*judge_pairs)(const PairBatch& batch, const ClusterPose& pose,
                      PairVerdicts& verdicts) noexcept = nullptr;
  /// Subtracts a distance from sixteen slacks; returns the ones that are not above 0 then, as bits.
  unsigned (*use_slack)(float* slack_m, float way_m) noexcept = nullptr;
  /// The triangles of a cluster, as bits, that face a direction and reach into a box or are within twice the tolerance of it.
  unsigned (*find_in_box)(const TriangleCluster& cluster, const SlabBox& box,
                          float tolerance_m) noexcept = nullptr;
  /// The segments of `count` pairs of a triangle of A and the one of B in the same lane.
  void (*cut_pairs)(const SegmentTriangles* a, const SegmentTriangles* b, std::size_t count,
                    const PlacedBody& body_a, const PlacedBody& body_b,
                    Segments* segments) noexcept = nullptr;
};

extern const TriangleLoops kSse2TriangleLoops;
extern const TriangleLoops kAvx2TriangleLoops;
extern const TriangleLoops kAvx512TriangleLoops;

}  // namespace asperity
