// Finds a result by the places of its contact, in storage reserved beforehand.

#include "renderers/pd_gradient/contact/computed_contacts.h"

#include <algorithm>

namespace asperity {

ComputedContacts::ComputedContacts(const Compute& compute, const TexturedMesh& a, double gain_a,
                                   const TexturedMesh& b, double gain_b, const GpuRoom& room)
    : gpu_(compute.device, a, gain_a, b, gain_b, room),
      deadline_(compute.deadline),
      most_contacts_(room.contacts),
      answers_(room.contacts),
      triangles_(room.triangles) {
  keys_.reserve(room.contacts);
  contacts_.reserve(room.contacts);
}

void ComputedContacts::begin() noexcept {
  keys_.clear();
  contacts_.clear();
  taken_ = 0;
  outcome_ = GpuOutcome::answered;
}

ComputedContacts::Key ComputedContacts::key_of(const TexturedContact& contact) noexcept {
  return {.id = contact.id, .is_continued = contact.is_fading || contact.is_kept};
}

std::span<const std::uint32_t> ComputedContacts::triangles_in(const TexturedBody& body,
                                                              const ContactFrame& own,
                                                              double outwards, const WindowBox& box,
                                                              std::size_t& left_out) noexcept {
  const std::span<std::uint32_t> room = std::span(triangles_).subspan(taken_);
  const std::size_t found = body.find_triangles(own, outwards * own.n, box, room);
  const std::size_t taken = std::min(found, room.size());
  left_out += found - taken;
  taken_ += taken;
  return room.first(taken);
}

std::size_t ComputedContacts::add(const TexturedContact& contact, const CachedPenetration& window,
                                  const MaximumLaw& law, const TexturedBody& a, const Pose& pose_a,
                                  const TexturedBody& b, const Pose& pose_b) noexcept {
  if (contacts_.size() == most_contacts_) return 0;
  std::size_t left_out = 0;
  const SamplingGrid& grid = window.grid();
  // A configuration of A is moved by up to the step, or turned by as much at the border of the window.
  const WindowBox box{.half_width_m = 0.5 * window.patch_width_m(),
                      .half_height_m = contact.half_height_m};
  contacts_.push_back(
      {.frame = contact.frame,
       .grid = grid,
       .law = law,
       .pose_a = pose_a,
       .pose_b = pose_b,
       .triangles_a = triangles_in(a, in_body(pose_a, contact.frame), -1.0, box, left_out),
       .triangles_b = triangles_in(b, in_body(pose_b, contact.frame), 1.0, box, left_out),
       .leaning_a = contact.leaning_a,
       .leaning_b = contact.leaning_b});
  keys_.push_back(key_of(contact));
  return left_out;
}

void ComputedContacts::submit() noexcept {
  outcome_ = gpu_.evaluate(contacts_, std::span(answers_).first(contacts_.size()), deadline_);
}

const std::optional<Penetration>* ComputedContacts::find(
    const TexturedContact& contact) const noexcept {
  if (outcome_ != GpuOutcome::answered) return nullptr;
  const auto found = std::find(keys_.begin(), keys_.end(), key_of(contact));
  return found == keys_.end() ? nullptr
                              : &answers_[static_cast<std::size_t>(found - keys_.begin())];
}

}  // namespace asperity
