// Defines the comparison of sixteen pairs of triangles in terms of Lanes; included once by each instruction set.

#pragma once

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
/// smallest overlap along these axes.
///
/// The axis of nearly parallel edges is uncertain, and left out. Its facet is a strip with a width of |product| / |longer edge|. A
/// cross-section of P − Q through the nearest point of the boundary reaches a facet of a certain axis after at most the widths of
/// the strips between them, two for each such product; the overlap along that axis exceeds the depth by at most this way.
struct Slack {
  // Of the angle between edges: 0.05. The rounding of a product of edges turns its axis by about 1e-7 divided by this sine, which
  // changes an overlap of bodies of the size R by 4e-6·R: as much as the tolerance, twice which is subtracted.
  static constexpr float kLeastSine2 = 2.5e-3F;
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

}  // namespace
}  // namespace asperity
