// Declares a list of triangle pairs that are near each other, and which of them intersect.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderers/pd_gradient/geometry/clustered_mesh.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {

/// A triangle of A and a triangle of B, by their indices.
struct TrianglePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  friend bool operator==(const TrianglePair&, const TrianglePair&) = default;
};

/// Whether two triangles share a point, in double precision.
bool triangles_intersect(const std::array<glm::dvec3, 3>& a,
                         const std::array<glm::dvec3, 3>& b) noexcept;

/// The meshes of a list of pairs, and the code for them.
struct MeshPair {
  const ClusteredMesh& a;
  const ClusteredMesh& b;
  const TriangleLoops& loops;
};

/// A list of the pairs that are within a margin of each other at one pose, with the verdict whether each of them intersects.
///
/// A verdict holds for a while: separate triangles cannot meet before a point of A has moved by their distance, and intersecting ones
/// cannot separate before one has moved by their penetration depth. Each verdict is stored with a lower bound of this
/// distance, its slack, and a pair is tested again only when the sum of A's motions since its last test has reached the slack. Pairs
/// within the rounding error of touching are tested in every call, in double precision.
///
/// Real-time: no function except the constructor allocates, locks or throws.
class NearPairs final {
 public:
  explicit NearPairs(std::size_t most);

  /// Clears the list, for the pairs within the margin at this pose; with a margin of 0 for those that intersect.
  void begin(const Pose& X_BA, double margin_m) noexcept;
  const Pose& pose() const noexcept { return X_BA_; }
  double margin_m() const noexcept { return margin_m_; }
  /// Adds a pair if it is within the margin. `add_last` has to be called after a sequence of pairs.
  void add(const MeshPair& meshes, const TrianglePair& pair) noexcept;
  void add_last(const MeshPair& meshes) noexcept;
  /// Pairs beyond the maximum are only counted.
  std::size_t count() const noexcept { return count_; }
  bool is_overfull() const noexcept { return count_ > pairs_.size(); }

  /// Records a motion of A relative to B, by at most this at any point.
  void move(double way_m) noexcept;
  /// Tests the pairs whose slack has been used at this pose. Whether a verdict has changed.
  bool renew(const MeshPair& meshes, const Pose& X_BA) noexcept;
  /// Writes the intersecting pairs, in the order of `add`; returns their number.
  std::size_t intersecting(std::span<TrianglePair> to) const noexcept;

 private:
  // The verdicts on sixteen pairs.
  struct Verdicts {
    alignas(64) float slack_m[kClusterSize] = {};
    std::uint32_t together = 0;
  };

  void put(const MeshPair& meshes, const TrianglePair& pair, std::size_t place) noexcept;
  void judge(const MeshPair& meshes, const Pose& X_BA, PairVerdicts& verdicts) noexcept;
  bool set(std::size_t place, const PairVerdicts& verdicts, std::size_t lane) noexcept;

  Pose X_BA_{};
  double margin_m_ = 0.0;
  double way_since_begin_m_ = 0.0;
  double way_m_ = 0.0;  // since the last `renew`
  std::size_t count_ = 0;
  std::vector<TrianglePair> pairs_{};
  std::vector<Verdicts> verdicts_{};
  // Those that are tested together; the lanes after the last one have earlier pairs.
  PairBatch tested_{};
  std::array<TrianglePair, kClusterSize> tested_pairs_{};
  std::array<std::size_t, kClusterSize> tested_places_{};  // in pairs_
  std::size_t tested_count_ = 0;
};

}  // namespace asperity
