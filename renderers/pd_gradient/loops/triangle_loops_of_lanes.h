// Defines the triangle loop in terms of Lanes; included once by each instruction set.

#pragma once

#include <cstddef>

#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

/// One number for each of sixteen triangles.
struct Sixteen {
  Lanes::Floats part[kClusterSize / Lanes::kWidth];
};

inline Sixteen all_sixteen(float x) {
  Sixteen sixteen;
  for (Lanes::Floats& part : sixteen.part) part = Lanes::all(x);
  return sixteen;
}

inline Sixteen sixteen_at(const float* from) {
  Sixteen sixteen;
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    sixteen.part[i] = Lanes::load(from + i * Lanes::kWidth);
  }
  return sixteen;
}

inline void put(float* to, const Sixteen& x) {
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    Lanes::store(to + i * Lanes::kWidth, x.part[i]);
  }
}

template <Lanes::Floats (*operation)(Lanes::Floats, Lanes::Floats)>
inline Sixteen each(const Sixteen& x, const Sixteen& y) {
  Sixteen sixteen;
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    sixteen.part[i] = operation(x.part[i], y.part[i]);
  }
  return sixteen;
}

inline Sixteen operator+(const Sixteen& x, const Sixteen& y) { return each<Lanes::add>(x, y); }
inline Sixteen operator-(const Sixteen& x, const Sixteen& y) { return each<Lanes::sub>(x, y); }
inline Sixteen operator*(const Sixteen& x, const Sixteen& y) { return each<Lanes::mul>(x, y); }
inline Sixteen operator*(float x, const Sixteen& y) { return all_sixteen(x) * y; }
inline Sixteen lesser(const Sixteen& x, const Sixteen& y) { return each<Lanes::min>(x, y); }
inline Sixteen greater(const Sixteen& x, const Sixteen& y) { return each<Lanes::max>(x, y); }
inline Sixteen magnitude(const Sixteen& x) { return greater(x, all_sixteen(0.0F) - x); }

/// Bit i is the result for triangle i.
inline unsigned is_less(const Sixteen& x, const Sixteen& y) {
  unsigned bits = 0;
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    bits |= Lanes::bits(Lanes::less(x.part[i], y.part[i])) << (i * Lanes::kWidth);
  }
  return bits;
}

struct Sixteen3 {
  Sixteen x;
  Sixteen y;
  Sixteen z;
};

inline Sixteen3 operator-(const Sixteen3& p, const Sixteen3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Sixteen dot(const Sixteen3& p, const Sixteen3& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
inline Sixteen3 cross(const Sixteen3& p, const Sixteen3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
/// At least the length, and at most √3 times the length.
inline Sixteen sum_of_magnitudes(const Sixteen3& p) {
  return magnitude(p.x) + magnitude(p.y) + magnitude(p.z);
}

/// The triangles of A, in B's frame: the same one in every lane, or one for each lane.
struct TrianglesOfA {
  Sixteen3 corners[3];
};

struct Verdict {
  unsigned together = 0;  ///< not found to be separate
  unsigned unsure = 0;    ///< of these, the ones too close to touching for a decision
};

inline Sixteen3 corner_of(const float (&corners)[3][3][kClusterSize], int corner) {
  return {sixteen_at(corners[corner][0]), sixteen_at(corners[corner][1]),
          sixteen_at(corners[corner][2])};
}

/// Removes the triangles whose projections on an axis leave a gap between [p_low, p_high] and [q_low, q_high].
inline void look_along(const Sixteen3& axis, const Sixteen& p_low, const Sixteen& p_high,
                       const Sixteen& q_low, const Sixteen& q_high, float tolerance_m,
                       Verdict& verdict) {
  const Sixteen gap = greater(q_low - p_high, p_low - q_high);
  const Sixteen tolerance = tolerance_m * sum_of_magnitudes(axis);
  verdict.together &= ~is_less(tolerance, gap);
  verdict.unsure |= is_less(all_sixteen(0.0F) - tolerance, gap);
}

inline Verdict compare(const TrianglesOfA& a, const float (&b)[3][3][kClusterSize], unsigned lanes,
                       float tolerance_m) {
  Verdict verdict{.together = lanes, .unsure = 0};
  // Relative to a corner of A, where the numbers are small.
  const Sixteen3 p[3] = {a.corners[0] - a.corners[0], a.corners[1] - a.corners[0],
                         a.corners[2] - a.corners[0]};
  const Sixteen3 q[3] = {corner_of(b, 0) - a.corners[0], corner_of(b, 1) - a.corners[0],
                         corner_of(b, 2) - a.corners[0]};
  {
    const Sixteen3 normal = cross(p[1], p[2]);
    const Sixteen first = dot(normal, q[0]);
    const Sixteen second = dot(normal, q[1]);
    const Sixteen third = dot(normal, q[2]);
    look_along(normal, all_sixteen(0.0F), all_sixteen(0.0F), lesser(first, lesser(second, third)),
               greater(first, greater(second, third)), tolerance_m, verdict);
    if (verdict.together == 0) return verdict;
  }
  {
    const Sixteen3 normal = cross(q[1] - q[0], q[2] - q[0]);
    const Sixteen level = dot(normal, q[0]);
    const Sixteen second = dot(normal, p[1]);
    const Sixteen third = dot(normal, p[2]);
    look_along(normal, lesser(all_sixteen(0.0F), lesser(second, third)),
               greater(all_sixteen(0.0F), greater(second, third)), level, level, tolerance_m,
               verdict);
    if (verdict.together == 0) return verdict;
  }
  for (int i = 0; i < 3; ++i) {
    const Sixteen3 edge = p[(i + 1) % 3] - p[i];
    for (int j = 0; j < 3; ++j) {
      // Both ends of an edge have the same projection.
      const Sixteen3 axis = cross(edge, q[(j + 1) % 3] - q[j]);
      const Sixteen on = dot(axis, p[i]);
      const Sixteen off = dot(axis, p[(i + 2) % 3]);
      const Sixteen other_on = dot(axis, q[j]);
      const Sixteen other_off = dot(axis, q[(j + 2) % 3]);
      look_along(axis, lesser(on, off), greater(on, off), lesser(other_on, other_off),
                 greater(other_on, other_off), tolerance_m, verdict);
    }
    if (verdict.together == 0) return verdict;
  }
  return verdict;
}

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

void find_pairs_by_lanes(const TriangleClusters& a, const TriangleClusters& b,
                         const ClusterPose& pose, SearchPart& part, TakePair take,
                         void* to) noexcept {
  const std::size_t groups = (b.count + kClusterSize - 1) / kClusterSize;
  MovedCluster moved;
  part.work = 0;
  std::size_t begin_b = part.first % b.count;  // of the first cluster of A only
  for (std::size_t ca = part.first / b.count; ca < a.count; ++ca) {
    ++part.work;
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
        if (part.work >= part.most_work) {
          part.next = ca * b.count + group * kClusterSize + static_cast<std::size_t>(box);
          return;
        }
        if (!has_moved) {
          move(from, pose, moved);
          slab = moved_slab(from, pose);
          has_moved = true;
        }
        const TriangleCluster& other =
            b.clusters[group * kClusterSize + static_cast<std::size_t>(box)];
        float other_low[3];
        float other_high[3];
        for (int axis = 0; axis < 3; ++axis) {
          other_low[axis] = b.boxes[group].low[axis][box];
          other_high[axis] = b.boxes[group].high[axis][box];
        }
        unsigned ones = meeting(moved.low, moved.high, other_low, other_high);
        // Its unused lanes repeat its last triangle.
        ones &= from.used;
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
          const unsigned lanes =
              meeting(other.low, other.high, one_low, one_high) & others & other.used;
          if (lanes == 0) continue;
          ++part.work;
          const Verdict verdict =
              compare(triangle_of(moved, lane), other.corners, lanes, pose.tolerance_m);
          for (unsigned left = verdict.together; left != 0; left &= left - 1) {
            const int found = __builtin_ctz(left);
            take(to, from.triangles[lane], other.triangles[found],
                 (verdict.unsure >> found & 1U) == 0);
          }
        }
      }
    }
    begin_b = 0;
  }
  part.next = a.count * b.count;
}

void test_pairs_by_lanes(const PairBatch* batches, std::size_t count, const ClusterPose& pose,
                         TakePair take, void* to) noexcept {
  for (std::size_t first = 0; first < count; first += kClusterSize, ++batches) {
    const PairBatch& batch = *batches;
    TrianglesOfA moved;
    for (int corner = 0; corner < 3; ++corner) {
      const Sixteen3 from = corner_of(batch.a, corner);
      moved.corners[corner] = {moved_to(from, pose, 0), moved_to(from, pose, 1),
                               moved_to(from, pose, 2)};
    }
    const Verdict verdict = compare(moved, batch.b, first_lanes(count - first), pose.tolerance_m);
    for (unsigned left = verdict.together; left != 0; left &= left - 1) {
      const int found = __builtin_ctz(left);
      take(to, batch.triangles_a[found], batch.triangles_b[found],
           (verdict.unsure >> found & 1U) == 0);
    }
  }
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
