// Declares the memory layout of a textured mesh for the sample loops.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// Stores a copy of a mesh, made once: the data of a triangle's corners are contiguous, and texels are paired. It needs
/// twice the bytes of the atlas.
///
/// Throws std::invalid_argument in the cases of require_sound, and for an atlas of more than 32000 rows or columns.
class PackedSurface final {
 public:
  struct Corner {
    glm::dvec3 point_m{0.0};
    glm::dvec3 normal{0.0};
    float place_x = 0.0F;
    float place_y = 0.0F;
  };
  using Triangle = std::array<Corner, 3>;

  explicit PackedSurface(const TexturedMesh& mesh) : PackedSurface(mesh, 1.0) {}
  /// Multiplies the displacements by `gain`.
  PackedSurface(const TexturedMesh& mesh, double gain);

  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  PairedTexels texels() const noexcept;
  double step_m() const noexcept { return step_m_; }
  std::size_t bytes() const noexcept;

 private:
  std::vector<Triangle> triangles_{};
  std::vector<std::uint32_t> pairs_{};
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t pitch_ = 0;
  double step_m_ = 0.0;
};

}  // namespace asperity
