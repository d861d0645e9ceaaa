// Defines the intersection of triangle pairs in terms of DoubleLanes; included once by each instruction set.

#pragma once

#include <cstddef>

#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {
namespace {

using Doubles = DoubleLanes::Doubles;

struct Vectors {
  Doubles x;
  Doubles y;
  Doubles z;
};

inline Vectors operator+(const Vectors& p, const Vectors& q) {
  return {DoubleLanes::add(p.x, q.x), DoubleLanes::add(p.y, q.y), DoubleLanes::add(p.z, q.z)};
}
inline Vectors operator-(const Vectors& p, const Vectors& q) {
  return {DoubleLanes::sub(p.x, q.x), DoubleLanes::sub(p.y, q.y), DoubleLanes::sub(p.z, q.z)};
}
inline Vectors operator*(Doubles a, const Vectors& p) {
  return {DoubleLanes::mul(a, p.x), DoubleLanes::mul(a, p.y), DoubleLanes::mul(a, p.z)};
}
inline Doubles dot(const Vectors& p, const Vectors& q) {
  return DoubleLanes::add(DoubleLanes::add(DoubleLanes::mul(p.x, q.x), DoubleLanes::mul(p.y, q.y)),
                          DoubleLanes::mul(p.z, q.z));
}
inline Doubles difference_of_products(Doubles a, Doubles b, Doubles c, Doubles d) {
  return DoubleLanes::sub(DoubleLanes::mul(a, b), DoubleLanes::mul(c, d));
}
inline Vectors cross(const Vectors& p, const Vectors& q) {
  return {difference_of_products(p.y, q.z, p.z, q.y), difference_of_products(p.z, q.x, p.x, q.z),
          difference_of_products(p.x, q.y, p.y, q.x)};
}
inline Doubles choose(DoubleLanes::Mask where, Doubles yes, Doubles no) {
  return DoubleLanes::choose(where, yes, no);
}
inline Vectors choose(DoubleLanes::Mask where, const Vectors& yes, const Vectors& no) {
  return {DoubleLanes::choose(where, yes.x, no.x), DoubleLanes::choose(where, yes.y, no.y),
          DoubleLanes::choose(where, yes.z, no.z)};
}

inline Vectors vectors_at(const double (&from)[3][kSegmentLanes], int lane) {
  return {DoubleLanes::load(from[0] + lane), DoubleLanes::load(from[1] + lane),
          DoubleLanes::load(from[2] + lane)};
}
inline void put(double (&to)[3][kSegmentLanes], int lane, const Vectors& p) {
  DoubleLanes::store(to[0] + lane, p.x);
  DoubleLanes::store(to[1] + lane, p.y);
  DoubleLanes::store(to[2] + lane, p.z);
}

inline Vectors turned(const PlacedBody& body, const Vectors& p) {
  const auto row = [&](int axis) {
    const double* turn = body.turn + 3 * axis;
    return DoubleLanes::add(DoubleLanes::add(DoubleLanes::mul(DoubleLanes::all(turn[0]), p.x),
                                             DoubleLanes::mul(DoubleLanes::all(turn[1]), p.y)),
                            DoubleLanes::mul(DoubleLanes::all(turn[2]), p.z));
  };
  return {row(0), row(1), row(2)};
}

inline Vectors placed(const PlacedBody& body, const Vectors& p) {
  return turned(body, p) + Vectors{DoubleLanes::all(body.shift_m[0]),
                                   DoubleLanes::all(body.shift_m[1]),
                                   DoubleLanes::all(body.shift_m[2])};
}

struct PlacedTriangles {
  Vectors corners[3];
  Vectors normal;
};

inline PlacedTriangles placed(const PlacedBody& body, const SegmentTriangles& triangles, int lane) {
  return {{placed(body, vectors_at(triangles.corners[0], lane)),
           placed(body, vectors_at(triangles.corners[1], lane)),
           placed(body, vectors_at(triangles.corners[2], lane))},
          turned(body, vectors_at(triangles.normal, lane))};
}

/// Points on a line and their positions along it.
struct PointsOnLine {
  Doubles along;
  Vectors place;
};

inline PointsOnLine choose(DoubleLanes::Mask where, const PointsOnLine& yes,
                           const PointsOnLine& no) {
  return {DoubleLanes::choose(where, yes.along, no.along), choose(where, yes.place, no.place)};
}

/// The intersection of triangles with the line in which another one's plane cuts their own.
struct Intervals {
  PointsOnLine low;
  PointsOnLine high;
  DoubleLanes::Mask are_cut;
};

inline Intervals cut(const PlacedTriangles& triangles, const PlacedTriangles& by,
                     const Vectors& along) {
  const Vectors(&corners)[3] = triangles.corners;
  const Doubles zero = DoubleLanes::all(0.0);
  Doubles heights[3];
  DoubleLanes::Mask below[3];
  for (int i = 0; i < 3; ++i) {
    heights[i] = dot(by.normal, corners[i] - by.corners[0]);
    below[i] = DoubleLanes::less(heights[i], zero);
  }
  // The plane separates one corner from the others and cuts the edges next to it. Edge i goes from corner i to the next.
  const DoubleLanes::Mask cuts_0 = DoubleLanes::differ(below[0], below[1]);
  const DoubleLanes::Mask cuts_1 = DoubleLanes::differ(below[1], below[2]);
  const auto crossing = [&](DoubleLanes::Mask where, int edge, int other_edge) -> PointsOnLine {
    const auto begin = [&](const auto& values) {
      return choose(where, values[edge], values[other_edge]);
    };
    const auto end = [&](const auto& values) {
      return choose(where, values[(edge + 1) % 3], values[(other_edge + 1) % 3]);
    };
    const Doubles height = begin(heights);
    const Doubles share = DoubleLanes::div(height, DoubleLanes::sub(height, end(heights)));
    const Vectors from = begin(corners);
    const Vectors place = from + share * (end(corners) - from);
    return {dot(place, along), place};
  };
  const PointsOnLine first = crossing(cuts_0, 0, 1);
  const PointsOnLine second = crossing(DoubleLanes::both(cuts_0, cuts_1), 1, 2);
  return {choose(DoubleLanes::less(second.along, first.along), second, first),
          choose(DoubleLanes::less(first.along, second.along), second, first),
          DoubleLanes::either(cuts_0, cuts_1)};
}

void cut_pairs_by_lanes(const SegmentTriangles* a, const SegmentTriangles* b, std::size_t count,
                        const PlacedBody& body_a, const PlacedBody& body_b,
                        Segments* segments) noexcept {
  const Doubles zero = DoubleLanes::all(0.0);
  const Vectors nowhere{zero, zero, zero};
  for (std::size_t first = 0; first < count; first += kSegmentLanes, ++a, ++b, ++segments) {
    for (int lane = 0; lane < kSegmentLanes; lane += DoubleLanes::kWidth) {
      const PlacedTriangles p = placed(body_a, *a, lane);
      const PlacedTriangles q = placed(body_b, *b, lane);
      const Vectors along = cross(p.normal, q.normal);
      const Intervals of_p = cut(p, q, along);
      const Intervals of_q = cut(q, p, along);
      const PointsOnLine low =
          choose(DoubleLanes::less(of_q.low.along, of_p.low.along), of_p.low, of_q.low);
      const PointsOnLine high =
          choose(DoubleLanes::less(of_p.high.along, of_q.high.along), of_p.high, of_q.high);
      const DoubleLanes::Mask overlap = DoubleLanes::both(
          DoubleLanes::both(of_p.are_cut, of_q.are_cut), DoubleLanes::less(low.along, high.along));
      const Vectors begin = choose(overlap, low.place, nowhere);
      const Vectors end = choose(overlap, high.place, nowhere);
      const Vectors way = end - begin;
      const Doubles length = DoubleLanes::sqrt(dot(way, way));
      put(segments->ends_m[0], lane, begin);
      put(segments->ends_m[1], lane, end);
      DoubleLanes::store(segments->length_m + lane, length);
      put(segments->middles_m2, lane,
          DoubleLanes::mul(length, DoubleLanes::all(0.5)) * (begin + end));
      put(segments->normals_a_m, lane, length * p.normal);
      put(segments->normals_b_m, lane, length * q.normal);
    }
  }
}

}  // namespace
}  // namespace asperity
