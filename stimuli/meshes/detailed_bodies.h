// Declares bodies of fine detail by formula, for measurements of time: closed, with several hundred thousand triangles.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// The height of a relief in metres at a place on a body, along its normal.
using Relief = std::function<double(const glm::dvec3& place_m)>;

/// A relief in space: waves of one to four times the shortest length in all directions. The same seed gives the same relief.
class RandomWaves final {
 public:
  struct Settings {
    double shortest_m = 1e-3;
    double rms_m = 5e-5;
    std::uint64_t seed = 0;
  };
  explicit RandomWaves(const Settings& settings);

  double operator()(const glm::dvec3& place_m) const;

 private:
  struct Wave {
    glm::dvec3 per_m{0.0};
    double height_m = 0.0;
    double phase_rad = 0.0;
  };
  std::vector<Wave> waves_{};
};

/// A body that a benchmark can name.
struct DetailedBody {
  std::string_view name{};
  std::size_t triangles = 0;   ///< of the original, unless another number is asked for
  std::size_t simplified = 0;  ///< of the mesh that is rendered
};

/// block, ball, ten_balls, wide_block, hammer, file, part, comb and ribs. The hammer, the file and the CAD part have the numbers of
/// triangles of [Otaduy 2004]: 433 000 simplified to 518, 285 000 to 632, and 658 000 to 720.
std::span<const DetailedBody> detailed_bodies() noexcept;

/// Makes one of them. `triangles` is not exceeded by more than 5 %, and missed by 3 % at 300 000 and by 10 % at 20 000
/// at most.
///
/// Their textures are waves of 1 mm and more with an RMS of 0.05 mm; a file also has teeth in rows, a part the traces of a
/// cutter, and ribs are waves of 5 mm. The upper side of a block, of ribs as well, lies about the plane z = 0; the other
/// bodies are about the origin, hammer, file and part along the z axis.
///
/// Errors: std::invalid_argument for an unknown name or fewer than 1000 triangles.
TriangleMesh make_detailed_body(std::string_view name, std::size_t triangles);

/// A torus about the z axis with a radius of 30 mm whose tube of 12 mm has bumps of ±1.8 mm: nothing about it is symmetric or aligned
/// with an axis. 2·around·along triangles.
TriangleMesh bumpy_torus(std::uint32_t around, std::uint32_t along);

}  // namespace asperity
