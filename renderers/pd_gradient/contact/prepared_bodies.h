// Declares the bodies that renderers of the same meshes share.

#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/contact/textured_body.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// Prepares a body once for all renderers that use it. The renderers of an attempt have the same bodies: that of the session
/// and those with which it is evaluated; so have most attempts of a session, and simulated sessions. The preparation of a plate
/// of 80 × 28 mm takes as long as thousands of ticks.
///
/// A body belongs to a mesh object, not to equal content, and to a gain. It is kept while the mesh exists, until the bodies
/// that were requested after it need `most_bytes`: a study has a few meshes with one or two gains each, but a search for an
/// amplitude has a new gain in every step. A renderer has its bodies whether or not they are kept here.
///
/// A body does not depend on when and for which request it was prepared, so that results depend neither on other renderers
/// nor on the number of threads.
///
/// Errors: those of TexturedBody, in every request.
///
/// Threads: any. Different bodies are prepared simultaneously; a request waits for a body that is being prepared.
/// Not real-time: allocates and locks.
class PreparedBodies final {
 public:
  /// Eleven plates of 80 × 28 mm with a texel every 16 µm, as those of a height field with a sample every 62.5 µm.
  static constexpr std::size_t kMostBytes = std::size_t{512} << 20;

  explicit PreparedBodies(std::size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

  /// The mesh must not be null.
  TexturedBody body(const std::shared_ptr<const TexturedMesh>& mesh, double gain);

 private:
  /// The mutex is locked while the body is prepared.
  struct Slot {
    std::mutex mutex{};
    std::optional<TexturedBody> body{};
  };
  struct Kept {
    std::weak_ptr<const TexturedMesh> mesh{};
    double gain = 0.0;
    std::shared_ptr<Slot> slot{};
    std::size_t bytes = 0;  ///< 0 until it is prepared
  };

  std::shared_ptr<Slot> slot_of(const std::shared_ptr<const TexturedMesh>& mesh, double gain);
  void keep(const std::shared_ptr<Slot>& slot, std::size_t bytes);
  void discard(const std::shared_ptr<Slot>& slot);

  std::size_t most_bytes_ = 0;
  std::mutex mutex_{};
  std::vector<Kept> kept_{};  ///< guarded by the mutex; the last requested one at the end
};

}  // namespace asperity
