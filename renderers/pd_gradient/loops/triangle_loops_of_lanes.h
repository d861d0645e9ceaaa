// Defines the triangle loop in terms of Lanes; included once by each instruction set.

#pragma once

#include <cstddef>

#include "renderers/pd_gradient/loops/triangle_comparison_of_lanes.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

/// A cluster of A in B's frame.
struct MovedCluster {
  alignas(64) float corners[3][3][kClusterSize];
  alignas(64) float low[3][kClusterSize];
  alignas(64) float high[3][kClusterSize];
};

/// Corners of A in B's frame.
inline Sixteen moved_to(const Sixteen3& from, const ClusterPose& pose, int axis) {
  const float* turn = pose.turn;
  return turn[3 * axis] * from.x + turn[3 * axis + 1] * from.y + turn[3 * axis + 2] * from.z +
         all_sixteen(pose.shift_m[axis]);
}

inline void move(const TriangleCluster& cluster, const ClusterPose& pose, MovedCluster& moved) {
  for (int axis = 0; axis < 3; ++axis) {
    Sixteen low = all_sixteen(0.0F);
    Sixteen high = low;
    for (int corner = 0; corner < 3; ++corner) {
      const Sixteen place = moved_to(corner_of(cluster.corners, corner), pose, axis);
      put(moved.corners[corner][axis], place);
      low = corner == 0 ? place : lesser(low, place);
      high = corner == 0 ? place : greater(high, place);
    }
    // Enlarged by the tolerance: touching triangles must not be lost to rounding.
    put(moved.low[axis], low - all_sixteen(pose.tolerance_m));
    put(moved.high[axis], high + all_sixteen(pose.tolerance_m));
  }
}

/// The slab of a cluster, in its own frame.
inline Slab slab_of(const TriangleCluster& cluster) {
  return {{cluster.slab_normal[0], cluster.slab_normal[1], cluster.slab_normal[2]},
          cluster.slab_low_m,
          cluster.slab_high_m};
}

/// The slab of a cluster of A, in B's frame.
inline Slab moved_slab(const TriangleCluster& cluster, const ClusterPose& pose) {
  Slab moved{};
  float along = 0.0F;
  for (int axis = 0; axis < 3; ++axis) {
    moved.normal[axis] = 0.0F;
    for (int from = 0; from < 3; ++from) {
      moved.normal[axis] += pose.turn[3 * axis + from] * cluster.slab_normal[from];
    }
    along += moved.normal[axis] * pose.shift_m[axis];
  }
  moved.low_m = cluster.slab_low_m + along;
  moved.high_m = cluster.slab_high_m + along;
  return moved;
}

/// The triangles, of sixteen, that reach into a slab. Triangles that do not are separated by more than the tolerance,
/// so that the axes would separate them too.
inline unsigned reaching(const float (&corners)[3][3][kClusterSize], const Slab& slab,
                         float tolerance_m) {
  Sixteen low = all_sixteen(0.0F);
  Sixteen high = low;
  for (int corner = 0; corner < 3; ++corner) {
    const Sixteen along = slab.normal[0] * sixteen_at(corners[corner][0]) +
                          slab.normal[1] * sixteen_at(corners[corner][1]) +
                          slab.normal[2] * sixteen_at(corners[corner][2]);
    low = corner == 0 ? along : lesser(low, along);
    high = corner == 0 ? along : greater(high, along);
  }
  const float play_m = 2.0F * tolerance_m;
  const unsigned beside = is_less(all_sixteen(slab.high_m + play_m), low) |
                          is_less(high, all_sixteen(slab.low_m - play_m));
  return ~beside & 0xFFFFU;
}

/// The boxes, of sixteen, that overlap the given box.
inline unsigned meeting(const float (&low)[3][kClusterSize], const float (&high)[3][kClusterSize],
                        const float* one_low, const float* one_high) {
  unsigned apart = 0;
  for (int axis = 0; axis < 3; ++axis) {
    apart |= is_less(all_sixteen(one_high[axis]), sixteen_at(low[axis]));
    apart |= is_less(sixteen_at(high[axis]), all_sixteen(one_low[axis]));
  }
  return ~apart & 0xFFFFU;
}

/// A mask of the first `count` of sixteen lanes, or of all.
inline unsigned first_lanes(std::size_t count) {
  return count < kClusterSize ? (1U << count) - 1U : 0xFFFFU;
}

inline TrianglesOfA triangle_of(const MovedCluster& cluster, int lane) {
  TrianglesOfA one;
  for (int corner = 0; corner < 3; ++corner) {
    one.corners[corner] = {all_sixteen(cluster.corners[corner][0][lane]),
                           all_sixteen(cluster.corners[corner][1][lane]),
                           all_sixteen(cluster.corners[corner][2][lane])};
  }
  return one;
}

/// The box of a moved cluster of A, computed from its box, which is faster than from its corners.
inline void moved_box(const ClusterBoxes& boxes, int lane, const ClusterPose& pose, float* low,
                      float* high) {
  for (int axis = 0; axis < 3; ++axis) {
    float middle = pose.shift_m[axis];
    float half = pose.tolerance_m;
    for (int from = 0; from < 3; ++from) {
      const float turn = pose.turn[3 * axis + from];
      middle += turn * (0.5F * (boxes.low[from][lane] + boxes.high[from][lane]));
      half +=
          (turn < 0.0F ? -turn : turn) * (0.5F * (boxes.high[from][lane] - boxes.low[from][lane]));
    }
    low[axis] = middle - half;
    high[axis] = middle + half;
  }
}

// What parts of a search take, in units of about ten nanoseconds.
constexpr std::size_t kWorkOfCluster = 2;
constexpr std::size_t kWorkOfTriangle = 8;
constexpr std::size_t kWorkOfCandidate = 5;

void find_candidates_by_lanes(const TriangleClusters& a, const TriangleClusters& b,
                              const ClusterPose& pose, SearchPart& part, TakePair take,
                              void* to) noexcept {
  const std::size_t groups = (b.count + kClusterSize - 1) / kClusterSize;
  MovedCluster moved;
  part.work = 0;
  // Where the search of the first cluster of A begins.
  std::size_t begin_b = part.first / kClusterSize % b.count;
  std::size_t begin_lane = part.first % kClusterSize;
  const std::size_t first_a = part.first / kClusterSize / b.count;
  for (std::size_t ca = first_a; ca < a.count; ++ca) {
    if (ca > first_a && part.work >= part.most_work) {
      part.next = ca * b.count * kClusterSize;
      return;
    }
    part.work += kWorkOfCluster;
    const TriangleCluster& from = a.clusters[ca];
    float box_low[3];
    float box_high[3];
    moved_box(a.boxes[ca / kClusterSize], static_cast<int>(ca % kClusterSize), pose, box_low,
              box_high);
    bool has_moved = false;
    Slab slab{};
    for (std::size_t group = begin_b / kClusterSize; group < groups; ++group) {
      // Comparisons with NaN keep every lane, including empty ones.
      unsigned near = meeting(b.boxes[group].low, b.boxes[group].high, box_low, box_high) &
                      first_lanes(b.count - group * kClusterSize);
      if (group * kClusterSize < begin_b) near &= ~first_lanes(begin_b % kClusterSize);
      for (; near != 0; near &= near - 1) {
        const int box = __builtin_ctz(near);
        const std::size_t cb = group * kClusterSize + static_cast<std::size_t>(box);
        const std::size_t done = cb == begin_b ? begin_lane : 0;  // lanes of this pair of clusters
        begin_lane = 0;
        if (!has_moved) {
          move(from, pose, moved);
          slab = moved_slab(from, pose);
          has_moved = true;
        }
        const TriangleCluster& other = b.clusters[cb];
        float other_low[3];
        float other_high[3];
        for (int axis = 0; axis < 3; ++axis) {
          other_low[axis] = b.boxes[group].low[axis][box];
          other_high[axis] = b.boxes[group].high[axis][box];
        }
        unsigned ones = meeting(moved.low, moved.high, other_low, other_high);
        // Its unused lanes repeat its last triangle.
        ones &= from.used & ~first_lanes(done);
        if (ones != 0) ones &= reaching(moved.corners, slab_of(other), pose.tolerance_m);
        if (ones == 0) continue;
        const unsigned others = reaching(other.corners, slab, pose.tolerance_m);
        if (others == 0) continue;
        for (; ones != 0; ones &= ones - 1) {
          const int lane = __builtin_ctz(ones);
          float one_low[3];
          float one_high[3];
          for (int axis = 0; axis < 3; ++axis) {
            one_low[axis] = moved.low[axis][lane];
            one_high[axis] = moved.high[axis][lane];
          }
          unsigned lanes = meeting(other.low, other.high, one_low, one_high) & others & other.used;
          if (lanes == 0) continue;
          part.work += kWorkOfTriangle;
          lanes = meeting_along_normals(triangle_of(moved, lane), other.corners, lanes,
                                        pose.tolerance_m);
          for (; lanes != 0; lanes &= lanes - 1) {
            part.work += kWorkOfCandidate;
            take(to, from.triangles[lane], other.triangles[__builtin_ctz(lanes)]);
          }
          // After the comparison: every part makes progress.
          if (part.work >= part.most_work) {
            part.next = (ca * b.count + cb) * kClusterSize + static_cast<std::size_t>(lane) + 1;
            return;
          }
        }
      }
    }
    begin_b = 0;
    begin_lane = 0;
  }
  part.next = a.count * b.count * kClusterSize;
}

void judge_pairs_by_lanes(const PairBatch& batch, const ClusterPose& pose,
                          PairVerdicts& verdicts) noexcept {
  TrianglesOfA moved;
  for (int corner = 0; corner < 3; ++corner) {
    const Sixteen3 from = corner_of(batch.a, corner);
    moved.corners[corner] = {moved_to(from, pose, 0), moved_to(from, pose, 1),
                             moved_to(from, pose, 2)};
  }
  Slack slack;
  const Verdict verdict = compare(moved, batch.b, pose.tolerance_m, slack);
  verdicts.together = verdict.together;
  verdicts.unsure = verdict.unsure;
  put(verdicts.slack_m, slack.slack_m(verdict, pose.tolerance_m));
}

unsigned use_slack_by_lanes(float* slack_m, float way_m) noexcept {
  const Sixteen left_m = sixteen_at(slack_m) - all_sixteen(way_m);
  put(slack_m, left_m);
  return ~is_less(all_sixteen(0.0F), left_m) & 0xFFFFU;
}

unsigned find_in_box_by_lanes(const TriangleCluster& cluster, const SlabBox& box,
                              float tolerance_m) noexcept {
  unsigned found = cluster.used;
  for (const Slab& slab : box.slabs) {
    if (found != 0) found &= reaching(cluster.corners, slab, tolerance_m);
  }
  if (found == 0) return 0;
  const Sixteen3 first = corner_of(cluster.corners, 0);
  const Sixteen3 normal =
      cross(corner_of(cluster.corners, 1) - first, corner_of(cluster.corners, 2) - first);
  const Sixteen along =
      box.facing[0] * normal.x + box.facing[1] * normal.y + box.facing[2] * normal.z;
  return found & is_less(all_sixteen(0.0F), along);
}

}  // namespace
}  // namespace asperity
