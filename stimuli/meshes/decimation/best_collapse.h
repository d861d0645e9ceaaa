// Declares the choice of the collapse that removes a vertex at the least cost.

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/meshes/decimation/closed_surface.h"
#include "stimuli/meshes/decimation/collapse_fan.h"
#include "stimuli/meshes/decimation/vertex_past.h"

namespace asperity::decimation {

enum class Strictness { turn_and_shape, look, flip_only };

/// The collapses that are permitted.
struct Permission {
  Strictness strictness = Strictness::turn_and_shape;
  double furthest = 0.0;  ///< the greatest permitted distance of a sample from the surface
};

/// The collapse of a vertex into one of its neighbours, and its cost.
struct Collapse {
  double cost = std::numeric_limits<double>::infinity();
  std::uint32_t half = kNoHalfEdge;  ///< from the removed vertex; none if no collapse is permitted
};

/// Finds the cheapest permitted collapse of a vertex; see mesh_decimation.h for the cost and the restrictions.
///
/// The surface and the pasts are kept by reference. An object is for one thread; several can read one surface.
class CollapseChoice final {
 public:
  CollapseChoice(const ClosedSurface& surface, const std::vector<VertexPast>& pasts)
      : surface_(surface), pasts_(pasts) {}

  Collapse best_of(std::uint32_t vertex, const Permission& permission);

 private:
  /// A neighbour of the vertex that is to be removed.
  struct Neighbour {
    std::uint32_t half = kNoHalfEdge;
    glm::dvec3 point{};
    // Of the face between this neighbour and the next:
    glm::dvec3 front{};  ///< twice its area, along its normal
    double front_length = 0.0;
    double squared_sides = 0.0;  ///< the sum of the squares of its sides
  };
  /// A collapse and the part of its cost that does not depend on samples.
  struct Candidate {
    double least_cost = 0.0;
    std::size_t neighbour = 0;
  };

  void gather(std::uint32_t vertex);
  std::size_t after(std::size_t neighbour) const {
    return neighbour + 1 < ring_.size() ? neighbour + 1 : 0;
  }
  bool raise_fan(std::size_t kept, const Permission& permission);
  bool is_permitted(std::size_t kept, std::size_t face, Strictness strictness) const;

  const ClosedSurface& surface_;
  const std::vector<VertexPast>& pasts_;
  std::vector<Neighbour> ring_{};
  std::vector<std::uint32_t> neighbours_{};  ///< the vertices of the ring
  std::vector<Candidate> candidates_{};
  CollapseFan fan_{};
};

}  // namespace asperity::decimation
