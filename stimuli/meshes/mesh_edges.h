// Declares internals of the mesh code: edges by their ends, and the adjacency of half-edges.

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

/// A key that is the same for both directions of an edge.
inline std::uint64_t edge_key(std::uint32_t one, std::uint32_t other) {
  return static_cast<std::uint64_t>(std::min(one, other)) << 32 | std::max(one, other);
}

/// The next half-edge of a triangle. A half-edge is 3·triangle + corner, from that corner to the next.
inline std::uint32_t next_half_edge(std::uint32_t half) {
  return half % 3 == 2 ? half - 2 : half + 1;
}

inline constexpr std::uint32_t kNoHalfEdge = std::numeric_limits<std::uint32_t>::max();

/// For each half-edge the one in the other triangle of its edge; kNoHalfEdge if the edge does not have exactly two
/// triangles.
inline std::vector<std::uint32_t> opposite_half_edges(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto corner = [&](std::uint32_t half) { return triangles[half / 3][half % 3]; };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges(3 * triangles.size());
  for (std::uint32_t half = 0; half < edges.size(); ++half) {
    edges[half] = {edge_key(corner(half), corner(next_half_edge(half))), half};
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> opposite(edges.size(), kNoHalfEdge);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
    if (end - begin != 2) continue;
    opposite[edges[begin].second] = edges[begin + 1].second;
    opposite[edges[begin + 1].second] = edges[begin].second;
  }
  return opposite;
}

}  // namespace asperity
