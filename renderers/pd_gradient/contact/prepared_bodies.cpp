// Implements the preparation of shared bodies, and the choice of those that are kept.

#include "renderers/pd_gradient/contact/prepared_bodies.h"

#include <algorithm>
#include <iterator>

#include "renderers/pd_gradient/sampling/newest_within.h"

namespace asperity {

TexturedBody PreparedBodies::body(const std::shared_ptr<const TexturedMesh>& mesh, double gain) {
  const std::shared_ptr<Slot> slot = slot_of(mesh, gain);
  const std::lock_guard lock(slot->mutex);
  if (!slot->body) {
    try {
      slot->body.emplace(*mesh, gain);
    } catch (...) {
      discard(slot);
      throw;
    }
    keep(slot, slot->body->bytes());
  }
  return *slot->body;
}

std::shared_ptr<PreparedBodies::Slot> PreparedBodies::slot_of(
    const std::shared_ptr<const TexturedMesh>& mesh, double gain) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [](const Kept& each) { return each.mesh.expired(); });
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) {
    return each.mesh.lock() == mesh && each.gain == gain;
  });
  if (found != kept_.end()) {
    std::rotate(found, std::next(found), kept_.end());
  } else {
    kept_.push_back({.mesh = mesh, .gain = gain, .slot = std::make_shared<Slot>()});
  }
  return kept_.back().slot;
}

// Releases the bodies that were not requested for the longest time; it may be among them.
void PreparedBodies::keep(const std::shared_ptr<Slot>& slot, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  for (Kept& each : kept_) {
    if (each.slot == slot) each.bytes = bytes;
  }
  kept_.erase(kept_.begin(),
              newest_within(kept_, most_bytes_, [](const Kept& each) { return each.bytes; }));
}

void PreparedBodies::discard(const std::shared_ptr<Slot>& slot) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&slot](const Kept& each) { return each.slot == slot; });
}

}  // namespace asperity
