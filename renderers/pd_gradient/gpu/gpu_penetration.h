// Declares the evaluation of all contacts of a tick on a compute device, in one submission.

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "renderers/compute/compute_device.h"
#include "renderers/pd_gradient/sampling/penetration.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// Samples of a window are evaluated in squares of this width.
inline constexpr int kSamplesOfTile = 16;

/// The room for the contacts of a tick.
struct GpuRoom {
  std::size_t contacts = 16;
  int samples = 256;              ///< of a window, in each direction; a multiple of kSamplesOfTile
  std::size_t triangles = 16384;  ///< of all contacts and both bodies together
  bool is_smooth = false;         ///< whether there may be a smooth maximum
};

/// One contact of A on B, as PackedPatch describes it for the processor.
struct GpuContact {
  ContactFrame frame{};
  SamplingGrid grid{};  ///< a multiple of kSamplesOfTile samples in each direction
  MaximumLaw law{};
  Pose pose_a{};
  Pose pose_b{};
  std::span<const std::uint32_t> triangles_a{};
  std::span<const std::uint32_t> triangles_b{};
  double leaning_a = 0.0;  ///< the cosine from which faces sink (sunk_m); 0: none
  double leaning_b = 0.0;
};

enum class GpuOutcome {
  answered,
  late,      ///< no answer within the deadline
  busy,      ///< the device still computes a submission that was late
  too_much,  ///< more contacts, samples or triangles than there is room for, or a smooth maximum
  lost       ///< the device reported an error; every later call has this outcome
};

/// Computes δ and ∇δ of several contacts as reference_penetration does: both surfaces are sampled again for every
/// configuration of the differences, in double precision and with the same operations. No height is kept from an
/// earlier call, and none is interpolated between samples.
///
/// Errors relative to the reference: hard maximum, none on a driver whose square root, division and floor are those of
/// IEEE 754, as OpenCL requires of double precision; smooth maximum, the order of the sums and the driver's exponential
/// function, 1e-12 of the RMS. The result depends only on the arguments of the call and is the same in every bit from
/// call to call on one device.
///
/// Errors: the constructor throws std::invalid_argument in the cases of require_sound and for room that is not
/// positive; std::runtime_error, with the device's name and the driver's message, where the device has not enough
/// memory or its driver refuses the program.
///
/// Real-time: `evaluate` does not throw and returns at the deadline. It calls the driver, which may allocate and lock.
/// One object serves one thread.
class GpuPenetration final {
 public:
  /// Displacements are multiplied by the gains.
  GpuPenetration(const ComputeDevice& device, const TexturedMesh& a, double gain_a,
                 const TexturedMesh& b, double gain_b, const GpuRoom& room);
  ~GpuPenetration();
  GpuPenetration(GpuPenetration&&) noexcept;
  GpuPenetration& operator=(GpuPenetration&&) noexcept;

  /// Fills one answer for each contact; nullopt if no sample is covered by both surfaces. Without the outcome
  /// `answered` the answers are unchanged.
  GpuOutcome evaluate(std::span<const GpuContact> contacts,
                      std::span<std::optional<Penetration>> answers,
                      std::chrono::nanoseconds deadline) noexcept;

 private:
  class Program;
  std::unique_ptr<Program> program_{};
};

}  // namespace asperity
