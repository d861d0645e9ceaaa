// Declares what is sent to the kernels for a contact, and what they answer.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/gpu/gpu_penetration.h"

namespace asperity {

// These structs, sizes and numbers are repeated in faces.cl and penetration.cl.

inline constexpr std::size_t kDeviceSurfaces = 12;  ///< B; A here; A in its ten moved poses
inline constexpr std::size_t kDeviceRates = 5;

struct DeviceTask {
  std::array<double, 12> frame{};  ///< origin, u, v, n
  std::array<std::array<double, 12>, kDeviceSurfaces> poses{};
  double spacing_m = 0.0;
  double width_m = 0.0;
  std::array<double, 2> leaning{};  ///< of B and A
  double tau_m = 0.0;               ///< 0: hard maximum
  std::int32_t samples = 0;
  std::int32_t used_surfaces = 0;
  std::array<std::int32_t, 2> first{};  ///< triangle of B and A in the lists of the submission
  std::array<std::int32_t, 2> count{};
  std::int32_t first_face = 0;
  std::int32_t padding = 0;
};

struct DeviceAnswer {
  std::array<double, kDeviceSurfaces> depth_m{};  ///< the first is unused; NaN: no overlap
  double height_m = 0.0;
  std::array<double, 2 * (1 + kDeviceRates)> sums{};
  std::int32_t sample = 0;
  std::int32_t covered = 0;
  std::int32_t folded = 0;
  std::int32_t at_border = 0;
};

struct DeviceCorner {
  std::array<double, 3> point_m{};
  std::array<double, 3> normal{};
  std::array<double, 2> place{};
  std::int32_t vertex = 0;
  std::int32_t padding = 0;
};

/// Of structs that only the kernels read and write.
inline constexpr std::size_t kFaceBytes = 8 * (3 * 5 + 3 * 8 + 1 + 3) + 4 * 4;
inline constexpr std::size_t kFoundBytes = 8 + 4 * 4;

/// Without the lists of triangles and the place of the faces.
DeviceTask device_task_of(const GpuContact& contact);

std::optional<Penetration> penetration_of(const DeviceAnswer& answer, const GpuContact& contact);

/// Three for each triangle.
std::vector<DeviceCorner> corners_of(const TexturedMesh& mesh);

}  // namespace asperity
