// Declares the search for intersecting triangles of two meshes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderers/pd_gradient/geometry/clustered_mesh.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/near_pairs.h"
#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/loops/triangle_loops.h"

namespace asperity {

/// Finds all pairs of triangles, one of each mesh, that share a point.
///
/// Two triangles are separate if and only if there is a separating plane whose normal is one of seventeen: the two of
/// the triangles, the nine products of their edges, and the six in their planes perpendicular to an edge. The test runs
/// in single precision on sixteen triangles at once; results within the rounding error of touching are decided in
/// double precision. Touching triangles are a pair.
///
/// While A moves slowly, only pairs that were within a margin of each other at an earlier pose are considered: no other pair
/// can intersect before a point of A has moved by the margin. When half of the margin has been used, the next list (NearPairs) is
/// begun; it is made in parts that correspond to the motion. Of a list, only pairs whose verdict may have changed are tested.
/// Without a valid list all pairs are searched. The pairs and their order are the same with and without a list.
///
/// The pairs and their order do not depend on the processor: the code is compiled for SSE2, AVX2 and AVX-512 without
/// contraction, and the widest set of the processor is used.
///
/// Real-time: `find` does not allocate, lock or throw.
///
/// Sources: separating axes [Gottschalk 1996].
class MeshQuery final {
 public:
  /// Pairs beyond `maximum_pairs` are counted, not listed.
  MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
            std::size_t maximum_pairs);
  /// Uses the code for one instruction set, which must be one of `instruction_sets_here()`.
  MeshQuery(std::shared_ptr<const ClusteredMesh> a, std::shared_ptr<const ClusteredMesh> b,
            std::size_t maximum_pairs, InstructionSet set);

  /// Ordered by cluster; valid until the next call.
  std::span<const TrianglePair> find(const Pose& X_BA) noexcept;
  /// The number of all intersecting pairs in the last `find`.
  std::size_t count() const noexcept { return count_; }
  /// The number of calls of `find` that used a list.
  std::uint64_t listed_calls() const noexcept { return listed_calls_; }

  const ClusteredMesh& a() const noexcept { return *a_; }
  const ClusteredMesh& b() const noexcept { return *b_; }

 private:
  /// The pairs within the margin of each other at one pose, in the order of the search.
  struct List {
    std::size_t searched = 0;  ///< as in SearchPart
    std::size_t work = 0;      ///< as in SearchPart
    double due_work = 0.0;     ///< so much should be done by now
    NearPairs pairs;           ///< those of the searched part
  };

  MeshPair meshes() const noexcept { return {.a = *a_, .b = *b_, .loops = *loops_}; }
  double way_m(const Pose& from, const Pose& to) const noexcept;
  bool is_whole(const List& list) const noexcept;
  static void begin(List& list, const Pose& X_BA, double margin_m) noexcept;
  void search(List& list, std::size_t most_work) noexcept;
  bool has_list_for(const Pose& X_BA, double moved_m) noexcept;
  void search_all(const Pose& X_BA, bool is_slow) noexcept;

  // Shared, because every stimulus with the same tool or surface has a separate query.
  std::shared_ptr<const ClusteredMesh> a_{};
  std::shared_ptr<const ClusteredMesh> b_{};
  const TriangleLoops* loops_ = nullptr;
  std::vector<TrianglePair> pairs_{};
  std::size_t count_ = 0;
  double margin_m_ = 0.0;
  std::optional<Pose> last_pose_{};
  std::optional<Pose> crowded_pose_{};  // at which a list had no room for the near pairs
  bool is_listing_ = false;
  List listed_;
  List next_;                  // being made while is_listing_
  bool is_from_list_ = false;  // pairs_ are those of listed_ in the previous call
  std::uint64_t listed_calls_ = 0;
};

}  // namespace asperity
