// Implements the pairing of texels and the collection of corners.

#include "renderers/pd_gradient/sampling/packed_surface.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "renderers/pd_gradient/geometry/contact_geometry.h"

namespace asperity {
namespace {

// Row and pitch are multiplied as signed 16-bit numbers.
constexpr std::size_t kMostTexels = 32000;
constexpr std::size_t kPadding = 20;
// Texels at a distance of a power of two of bytes map to the same cache set.
constexpr std::size_t kCrowded = 64;

std::size_t pitch_of(std::size_t columns) {
  const std::size_t pitch = columns + kPadding;
  return pitch % kCrowded == 0 ? pitch + kPadding : pitch;
}

}  // namespace

PackedSurface::PackedSurface(const TexturedMesh& mesh, double gain) {
  require_sound(mesh);
  const DisplacementAtlas& atlas = mesh.atlas;
  if (std::max(atlas.rows, atlas.columns) > kMostTexels) {
    throw std::invalid_argument("TexturedMesh: the atlas has " + std::to_string(atlas.rows) +
                                " × " + std::to_string(atlas.columns) +
                                " texels; it must have at most " + std::to_string(kMostTexels) +
                                " per side. Use a smaller shape or a coarser height field.");
  }
  step_m_ = gain * atlas.step_m;
  rows_ = atlas.rows;
  columns_ = atlas.columns;
  pitch_ = pitch_of(columns_);
  pairs_.assign(rows_ * pitch_ + kPadding, 0);
  for (std::size_t row = 0; row < rows_; ++row) {
    const std::size_t below = std::min(row + 1, rows_ - 1);
    for (std::size_t column = 0; column < pitch_; ++column) {
      const std::size_t held = std::min(column, columns_ - 1);  // the last texel is repeated
      const auto bits = [&](std::size_t of_row) {
        return std::uint32_t{static_cast<std::uint16_t>(atlas.values[of_row * columns_ + held])};
      };
      pairs_[row * pitch_ + column] = bits(row) | bits(below) << 16;
    }
  }
  triangles_.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = mesh.triangles[i][corner];
      triangles_[i][corner] = {.point_m = mesh.vertices_m[vertex],
                               .normal = mesh.normals[vertex],
                               .place_x = static_cast<float>(mesh.places[i][corner].x),
                               .place_y = static_cast<float>(mesh.places[i][corner].y)};
    }
  }
}

std::size_t PackedSurface::bytes() const noexcept {
  return std::as_bytes(std::span(triangles_)).size() + std::as_bytes(std::span(pairs_)).size();
}

PairedTexels PackedSurface::texels() const noexcept {
  return {.pairs = pairs_.data(),
          .pitch = static_cast<std::int32_t>(pitch_),
          .last_column = static_cast<float>(columns_ - 1),
          .last_row = static_cast<float>(rows_ - 1)};
}

}  // namespace asperity
