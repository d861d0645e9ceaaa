// Implements the search for narrow handles and their cuts.

#include "stimuli/meshes/mesh_handles.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "stimuli/meshes/mesh_edges.h"

namespace asperity {

namespace {

std::uint32_t half_edge_before(std::uint32_t half) { return next_half_edge(next_half_edge(half)); }

std::size_t parts_of(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> leader(mesh.vertices_m.size());
  std::iota(leader.begin(), leader.end(), std::uint32_t{0});
  const auto find = [&leader](std::uint32_t vertex) {
    while (leader[vertex] != vertex) vertex = leader[vertex] = leader[leader[vertex]];
    return vertex;
  };
  std::size_t parts = mesh.vertices_m.size();
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const std::uint32_t other : {b, c}) {
      const std::uint32_t one = find(a);
      const std::uint32_t two = find(other);
      if (one == two) continue;
      leader[one] = two;
      --parts;
    }
  }
  return parts;
}

/// One round of cuts that share no vertex.
class Cutting final {
 public:
  Cutting(TriangleMesh& mesh, HandleCuts& cuts)
      : mesh_(mesh),
        cuts_(cuts),
        opposite_(opposite_half_edges(mesh.triangles)),
        touched_(mesh.vertices_m.size(), false),
        leaving_(mesh.vertices_m.size()) {
    for (std::uint32_t half = 0; half < opposite_.size(); ++half) {
      leaving_[from(half)].push_back(half);
    }
  }

  /// Cuts up to `most` handles and returns their number.
  std::size_t cut(double widest_m, std::size_t most) {
    std::size_t done = 0;
    for (const Way& way : ways_shorter_than(widest_m)) {
      if (done == most) break;
      const auto& [a, b, c] = way.corners;
      if (touched_[a] || touched_[b] || touched_[c]) continue;
      const std::array<std::uint32_t, 3> halves{half_edge(a, b), half_edge(b, c), half_edge(c, a)};
      if (falls_apart(halves)) continue;
      divide(halves);
      touched_[a] = touched_[b] = touched_[c] = true;
      ++cuts_.handles;
      cuts_.widest_m = std::max(cuts_.widest_m, way.length_m);
      ++done;
    }
    return done;
  }

 private:
  /// A closed path around a handle, along three edges.
  struct Way {
    double length_m = 0.0;
    std::array<std::uint32_t, 3> corners{};
  };

  std::uint32_t from(std::uint32_t half) const { return mesh_.triangles[half / 3][half % 3]; }
  std::uint32_t to(std::uint32_t half) const { return from(next_half_edge(half)); }
  double length_m(std::uint32_t one, std::uint32_t other) const {
    return glm::distance(mesh_.vertices_m[one], mesh_.vertices_m[other]);
  }
  std::uint32_t half_edge(std::uint32_t start, std::uint32_t end) const {
    return *std::find_if(leaving_[start].begin(), leaving_[start].end(),
                         [&](std::uint32_t half) { return to(half) == end; });
  }

  std::vector<Way> ways_shorter_than(double widest_m) const {
    std::vector<Way> ways{};
    std::vector<std::uint32_t> near(mesh_.vertices_m.size(), kNoHalfEdge);
    for (std::uint32_t a = 0; a < leaving_.size(); ++a) {
      for (const std::uint32_t half : leaving_[a]) near[to(half)] = a;
      for (const std::uint32_t half : leaving_[a]) {
        const std::uint32_t b = to(half);
        if (b < a) continue;
        const std::uint32_t left = from(half_edge_before(half));
        const std::uint32_t right = from(half_edge_before(opposite_[half]));
        for (const std::uint32_t onwards : leaving_[b]) {
          const std::uint32_t c = to(onwards);
          if (c < b || near[c] != a || c == left || c == right) continue;
          const double way_m = length_m(a, b) + length_m(b, c) + length_m(c, a);
          if (way_m < widest_m) ways.push_back({way_m, {a, b, c}});
        }
      }
    }
    std::sort(ways.begin(), ways.end(), [](const Way& one, const Way& other) {
      return std::pair(one.length_m, one.corners) < std::pair(other.length_m, other.corners);
    });
    return ways;
  }

  /// Whether these edges separate the part: no path over faces leads from one side to the other without crossing them.
  bool falls_apart(const std::array<std::uint32_t, 3>& halves) const {
    const auto is_cut = [&](std::uint32_t half) {
      return std::any_of(halves.begin(), halves.end(), [&](std::uint32_t each) {
        return half == each || half == opposite_[each];
      });
    };
    const std::uint32_t wanted = opposite_[halves[0]] / 3;
    std::vector<bool> seen(mesh_.triangles.size(), false);
    std::vector<std::uint32_t> open{halves[0] / 3};
    seen[open.front()] = true;
    while (!open.empty()) {
      const std::uint32_t face = open.back();
      open.pop_back();
      if (face == wanted) return false;
      for (std::uint32_t half = 3 * face; half < 3 * face + 3; ++half) {
        const std::uint32_t beyond = opposite_[half] / 3;
        if (is_cut(half) || seen[beyond]) continue;
        seen[beyond] = true;
        open.push_back(beyond);
      }
    }
    return true;
  }

  /// Gives the faces on the left of a → b → c → a separate corners.
  void divide(const std::array<std::uint32_t, 3>& halves) {
    const std::array<std::uint32_t, 3> corners{from(halves[0]), from(halves[1]), from(halves[2])};
    std::array<std::uint32_t, 3> copies{};
    std::array<std::uint32_t, 3> right{};
    for (std::size_t i = 0; i < 3; ++i) {
      right[i] = opposite_[halves[i]];
      copies[i] = static_cast<std::uint32_t>(mesh_.vertices_m.size());
      const glm::dvec3 point_m = mesh_.vertices_m[corners[i]];
      mesh_.vertices_m.push_back(point_m);
      cuts_.copies.push_back(corners[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t last = halves[(i + 2) % 3];
      std::uint32_t half = halves[i];
      while (true) {
        mesh_.triangles[half / 3][half % 3] = copies[i];
        const std::uint32_t before = half_edge_before(half);
        if (before == last) break;
        half = opposite_[before];
      }
    }
    // Along c ← b ← a on the left, and along a → b → c on the right.
    add_face({copies[0], copies[2], copies[1]}, {halves[2], halves[1], halves[0]});
    add_face(corners, right);
  }

  /// `across` contains the opposite half-edge of each of its own.
  void add_face(const std::array<std::uint32_t, 3>& corners,
                const std::array<std::uint32_t, 3>& across) {
    const auto first = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    mesh_.triangles.push_back(corners);
    for (std::uint32_t i = 0; i < 3; ++i) {
      opposite_.push_back(across[i]);
      opposite_[across[i]] = first + i;
    }
  }

  TriangleMesh& mesh_;
  HandleCuts& cuts_;
  std::vector<std::uint32_t> opposite_;
  std::vector<bool> touched_;
  std::vector<std::vector<std::uint32_t>> leaving_;
};

}  // namespace

// Vertices − edges + faces = 2·(parts − handles), with three edges for every two faces.
std::size_t handles_of(const TriangleMesh& mesh) {
  return (2 * parts_of(mesh) + mesh.triangles.size() / 2 - mesh.vertices_m.size()) / 2;
}

HandleCuts cut_narrow_handles(TriangleMesh& mesh, double widest_m) {
  HandleCuts cuts{};
  std::size_t left = handles_of(mesh);
  while (left > 0) {
    const std::size_t done = Cutting(mesh, cuts).cut(widest_m, left);
    if (done == 0) break;
    left -= done;
  }
  return cuts;
}

}  // namespace asperity
