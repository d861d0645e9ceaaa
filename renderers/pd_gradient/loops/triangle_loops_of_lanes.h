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

template <Lanes::Floats (*operation)(Lanes::Floats)>
inline Sixteen each(const Sixteen& x) {
  Sixteen sixteen;
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    sixteen.part[i] = operation(x.part[i]);
  }
  return sixteen;
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
inline Sixteen operator/(const Sixteen& x, const Sixteen& y) { return each<Lanes::div>(x, y); }
inline Sixteen root_of(const Sixteen& x) { return each<Lanes::sqrt>(x); }
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

/// The first number where its bit is set, otherwise the second.
inline Sixteen choose(unsigned bits, const Sixteen& yes, const Sixteen& no) {
  Sixteen sixteen;
  for (int i = 0; i < kClusterSize / Lanes::kWidth; ++i) {
    sixteen.part[i] =
        Lanes::choose(Lanes::mask(bits >> (i * Lanes::kWidth)), yes.part[i], no.part[i]);
  }
  return sixteen;
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

/// Triangles of A, in B's frame.
struct TrianglesOfA {
  Sixteen3 corners[3];
};

struct Verdict {
  unsigned together = 0;  ///< not found to be separate
  unsigned unsure = 0;    ///< of these, the ones too close to touching for a decision
};

/// Computes how far the triangles are from the opposite verdict.
///
/// Separate triangles have at least the distance of the widest gap. Intersecting triangles continue to intersect until a point has
/// moved by their penetration depth: the distance from the origin to the boundary of P − Q, the differences of their points. The
/// facets of P − Q are perpendicular to the normals of the triangles and to the products of their edges, so that the depth is the
/// smallest overlap along these axes. The direction of a product of nearly parallel edges is uncertain. Its facet is a strip
/// with a width of |product| / |longer edge|, and another facet adjoins each of its long sides. If the nearest point of the boundary is
/// in a strip, the overlap along the axis of the next facet exceeds the depth by at most the width of the strip. There are two
/// strips for each such product.
struct Slack {
  static constexpr float kLeastSine2 = 4e-4F;  // of the angle between edges
  static constexpr float kNone_m2 = -1e30F;
  Sixteen widest_gap_m2 = all_sixteen(kNone_m2);  // the square, with the sign of the gap
  Sixteen strips_m = all_sixteen(0.0F);

  /// The axis is the product of two edges.
  void look(const Sixteen3& axis, const Sixteen& gap, const Sixteen3& edge, const Sixteen3& other) {
    const Sixteen length2 = dot(axis, axis);
    const Sixteen edge2 = dot(edge, edge);
    const Sixteen other2 = dot(other, other);
    const unsigned is_clear = is_less(kLeastSine2 * (edge2 * other2), length2);
    const Sixteen gap_m2 = gap * magnitude(gap) / length2;
    widest_gap_m2 = choose(is_clear, greater(widest_gap_m2, gap_m2), widest_gap_m2);
    if (is_clear == 0xFFFFU) return;
    strips_m = choose(is_clear, strips_m, strips_m + root_of(length2 / greater(edge2, other2)));
  }

  Sixteen slack_m(const Verdict& verdict, float tolerance_m) const {
    const Sixteen size_m = root_of(magnitude(widest_gap_m2));
    const unsigned is_gap = is_less(all_sixteen(0.0F), widest_gap_m2);
    const Sixteen gap_m = choose(is_gap, size_m, all_sixteen(0.0F) - size_m);
    const Sixteen play_m = all_sixteen(2.0F * tolerance_m);
    const Sixteen inside_m = all_sixteen(0.0F) - gap_m - 2.0F * strips_m;
    const Sixteen known_m = choose(verdict.together, inside_m, gap_m) - play_m;
    const unsigned is_known =
        is_less(all_sixteen(0.5F * kNone_m2), widest_gap_m2) & ~(verdict.together & verdict.unsure);
    return choose(is_known, known_m, all_sixteen(-1.0F));
  }
};

inline Sixteen3 corner_of(const float (&corners)[3][3][kClusterSize], int corner) {
  return {sixteen_at(corners[corner][0]), sixteen_at(corners[corner][1]),
          sixteen_at(corners[corner][2])};
}

/// The gap between [p_low, p_high] and [q_low, q_high]; negative if they overlap.
inline Sixteen gap_between(const Sixteen& p_low, const Sixteen& p_high, const Sixteen& q_low,
                           const Sixteen& q_high) {
  return greater(q_low - p_high, p_low - q_high);
}

/// Removes the triangles whose projections on an axis leave a gap. The axis is the product of two edges, and its rounding error is
/// relative to the product of their lengths.
inline void look_along(const Sixteen3& axis, const Sixteen& gap, const Sixteen3& edge,
                       const Sixteen3& other, float tolerance_m, Verdict& verdict) {
  // Times the tolerance, this is more than the rounding error of a product of three lengths.
  constexpr float kPartOfEdges = 0.25F;
  const Sixteen tolerance =
      tolerance_m * (sum_of_magnitudes(axis) +
                     kPartOfEdges * (sum_of_magnitudes(edge) * sum_of_magnitudes(other)));
  verdict.together &= ~is_less(tolerance, gap);
  verdict.unsure |= is_less(all_sixteen(0.0F) - tolerance, gap);
}

/// Corners relative to a corner of A, where the numbers are small.
struct Relative {
  Sixteen3 p[3];
  Sixteen3 q[3];
};

inline Relative relative(const TrianglesOfA& a, const float (&b)[3][3][kClusterSize]) {
  const Sixteen3& origin = a.corners[0];
  return {{origin - origin, a.corners[1] - origin, a.corners[2] - origin},
          {corner_of(b, 0) - origin, corner_of(b, 1) - origin, corner_of(b, 2) - origin}};
}

/// For a comparison that needs no slack.
struct WithoutSlack {
  void look(const Sixteen3&, const Sixteen&, const Sixteen3&, const Sixteen3&) {}
};

template <class OfSlack>
inline void look_along_normal_of_p(const Relative& corners, float tolerance_m, Verdict& verdict,
                                   OfSlack& slack) {
  const auto& [p, q] = corners;
  const Sixteen zero = all_sixteen(0.0F);
  const Sixteen3 normal = cross(p[1], p[2]);
  const Sixteen first = dot(normal, q[0]);
  const Sixteen second = dot(normal, q[1]);
  const Sixteen third = dot(normal, q[2]);
  const Sixteen gap = gap_between(zero, zero, lesser(first, lesser(second, third)),
                                  greater(first, greater(second, third)));
  look_along(normal, gap, p[1], p[2], tolerance_m, verdict);
  slack.look(normal, gap, p[1], p[2]);
}

template <class OfSlack>
inline void look_along_normal_of_q(const Relative& corners, float tolerance_m, Verdict& verdict,
                                   OfSlack& slack) {
  const auto& [p, q] = corners;
  const Sixteen zero = all_sixteen(0.0F);
  const Sixteen3 edge = q[1] - q[0];
  const Sixteen3 other = q[2] - q[0];
  const Sixteen3 normal = cross(edge, other);
  const Sixteen level = dot(normal, q[0]);
  const Sixteen second = dot(normal, p[1]);
  const Sixteen third = dot(normal, p[2]);
  const Sixteen gap = gap_between(lesser(zero, lesser(second, third)),
                                  greater(zero, greater(second, third)), level, level);
  look_along(normal, gap, edge, other, tolerance_m, verdict);
  slack.look(normal, gap, edge, other);
}

inline Verdict compare(const TrianglesOfA& a, const float (&b)[3][3][kClusterSize],
                       float tolerance_m, Slack& slack) {
  Verdict verdict{.together = 0xFFFFU, .unsure = 0};
  const Relative corners = relative(a, b);
  look_along_normal_of_p(corners, tolerance_m, verdict, slack);
  look_along_normal_of_q(corners, tolerance_m, verdict, slack);
  const auto& [p, q] = corners;
  for (int i = 0; i < 3; ++i) {
    const Sixteen3 edge = p[(i + 1) % 3] - p[i];
    for (int j = 0; j < 3; ++j) {
      // Both ends of an edge have the same projection.
      const Sixteen3 other = q[(j + 1) % 3] - q[j];
      const Sixteen3 axis = cross(edge, other);
      const Sixteen on = dot(axis, p[i]);
      const Sixteen off = dot(axis, p[(i + 2) % 3]);
      const Sixteen other_on = dot(axis, q[j]);
      const Sixteen other_off = dot(axis, q[(j + 2) % 3]);
      const Sixteen gap = gap_between(lesser(on, off), greater(on, off),
                                      lesser(other_on, other_off), greater(other_on, other_off));
      look_along(axis, gap, edge, other, tolerance_m, verdict);
      slack.look(axis, gap, edge, other);
    }
  }
  return verdict;
}

/// The triangles that are not separate along the normals: most that are, are separate along one of them.
inline unsigned meeting_along_normals(const TrianglesOfA& a, const float (&b)[3][3][kClusterSize],
                                      unsigned lanes, float tolerance_m) {
  Verdict verdict{.together = lanes, .unsure = 0};
  WithoutSlack slack;
  const Relative corners = relative(a, b);
  look_along_normal_of_p(corners, tolerance_m, verdict, slack);
  if (verdict.together != 0) look_along_normal_of_q(corners, tolerance_m, verdict, slack);
  return verdict.together;
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
  for (std::size_t ca = part.first / kClusterSize / b.count; ca < a.count; ++ca) {
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
          if (part.work >= part.most_work) {
            part.next = (ca * b.count + cb) * kClusterSize + static_cast<std::size_t>(lane);
            return;
          }
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
