// Declares the window samplers that renderers leave to later ones.

#pragma once

#include <cstddef>
#include <memory>

#include "renderers/pd_gradient/sampling/window_samplers.h"

namespace asperity {

/// Keeps the window samplers of ended renderers for new ones: their heights are tens of megabytes, which take longer to allocate
/// and to fill than a second of ticks takes to compute.
///
/// Samplers that are returned are cleared (WindowSamplers::reset) and given to the next request with the same windows and
/// cells. Of those that nobody has, the last ones with up to `most_bytes` are kept.
///
/// A cleared sampler gives the same results as a new one, so that results do not depend on other renderers.
///
/// Errors: those of WindowSamplers.
///
/// Threads: any; a sampler belongs to one renderer at a time. Not real-time: `take`, and the end of what it returned, allocate and
/// lock.
class SpareSamplers final {
 public:
  /// The three renderers of an attempt, for a ball of 2 mm with cells of 45 µm that are halved twice.
  static constexpr std::size_t kMostBytes = std::size_t{128} << 20;

  explicit SpareSamplers(std::size_t most_bytes = kMostBytes);

  /// Arguments as those of WindowSamplers. The result may outlive this object.
  std::shared_ptr<WindowSamplers> take(const WindowSampling& sampling, double widest_m,
                                       std::size_t most_triangles, InstructionSet instructions);

 private:
  class Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace asperity
