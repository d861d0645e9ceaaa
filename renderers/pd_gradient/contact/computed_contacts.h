// Declares the contacts of a tick on a compute device: collected, submitted at once, and looked up.

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderers/compute/compute_device.h"
#include "renderers/pd_gradient/contact/textured_body.h"
#include "renderers/pd_gradient/contact/textured_contact.h"
#include "renderers/pd_gradient/gpu/gpu_penetration.h"
#include "renderers/pd_gradient/sampling/cached_penetration.h"

namespace asperity {

/// Evaluates the contacts of a tick on a device, in one submission.
///
/// Errors: those of GpuPenetration.
///
/// Real-time: as GpuPenetration::evaluate; a tick waits for at most the deadline of the Compute.
class ComputedContacts final {
 public:
  ComputedContacts(const Compute& compute, const TexturedMesh& a, double gain_a,
                   const TexturedMesh& b, double gain_b, const GpuRoom& room);

  /// Discards the contacts of the previous tick.
  void begin() noexcept;

  /// Adds a contact in the window of the given sampler, with the triangles of both bodies in it; returns how many of these had no
  /// room. Contacts beyond the room have no answer.
  std::size_t add(const TexturedContact& contact, const CachedPenetration& window,
                  const MaximumLaw& law, const TexturedBody& a, const Pose& pose_a,
                  const TexturedBody& b, const Pose& pose_b) noexcept;

  void submit() noexcept;

  /// The outcome of the last `submit`.
  GpuOutcome outcome() const noexcept { return outcome_; }

  /// The answer to a contact of this tick; null if it was not submitted or there was no answer.
  const std::optional<Penetration>* find(const TexturedContact& contact) const noexcept;

 private:
  // Which contact of a tick: that of a region, or one of the previous tick in the present poses.
  struct Key {
    std::uint64_t id = 0;
    bool is_continued = false;

    bool operator==(const Key&) const = default;
  };

  static Key key_of(const TexturedContact& contact) noexcept;
  std::span<const std::uint32_t> triangles_in(const TexturedBody& body, const ContactFrame& own,
                                              double outwards, const WindowBox& box,
                                              std::size_t& left_out) noexcept;

  GpuPenetration gpu_;
  std::chrono::nanoseconds deadline_{};
  std::size_t most_contacts_ = 0;
  std::vector<Key> keys_{};
  std::vector<GpuContact> contacts_{};
  std::vector<std::optional<Penetration>> answers_{};
  std::vector<std::uint32_t> triangles_{};
  std::size_t taken_ = 0;
  GpuOutcome outcome_ = GpuOutcome::answered;
};

}  // namespace asperity
