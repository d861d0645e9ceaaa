// Continues the contacts of the last tick, adds new regions, and blends those that share a place.

#include "renderers/pd_gradient/contact/textured_contacts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

// Crests of equal depth are at least about one wave apart. If their depths differ, the spread is less, and 0 from the
// difference on at which a tilt no longer makes the other one the deepest. On one crest it is a small part of a wave.
constexpr double kSpreadOfWaves = 0.25;
constexpr double kSteepestSlope =
    1.7320508075688772;  // tan 60°: of a surface that leans 60° from n

// A curve lies on both bodies, so that the smaller one limits it; the middle of the window may be at an end of it.
double widest_window_m(const TexturedBody& a, const TexturedBody& b) {
  constexpr double kStepOfWidths = 1.5;  // regions widen in steps, with hysteresis
  return kStepOfWidths * 4.0 *
         std::min(a.hull_clusters()->radius_m(), b.hull_clusters()->radius_m());
}

std::shared_ptr<WindowSamplers> samplers_of(const WindowSampling& sampling, double widest_m,
                                            std::size_t most_triangles, InstructionSet instructions,
                                            SpareSamplers* spare) {
  if (spare != nullptr) return spare->take(sampling, widest_m, most_triangles, instructions);
  return std::make_shared<WindowSamplers>(sampling, widest_m, most_triangles, instructions);
}

}  // namespace

TexturedContacts::TexturedContacts(TexturedBody a, TexturedBody b, const WindowSampling& sampling,
                                   InstructionSet instructions,
                                   std::unique_ptr<ComputedContacts> computed, SpareSamplers* spare)
    : a_(std::move(a)),
      b_(std::move(b)),
      query_(a_.hull_clusters(), b_.hull_clusters(), kMostPairs, instructions),
      regions_(a_.hull(), b_.hull(), kMostPairs, kMostContacts, instructions),
      samplers_(samplers_of(refinable(sampling, a_, b_), widest_window_m(a_, b_),
                            std::min(kMostTriangles, std::max(a_.triangles(), b_.triangles())),
                            instructions, spare)),
      triangles_a_(std::min(kMostTriangles, a_.triangles())),
      triangles_b_(std::min(kMostTriangles, b_.triangles())),
      computed_(std::move(computed)),
      most_samples_(long{sampling.most_samples} * sampling.most_samples),
      crests_m_(kSpreadOfWaves * std::min(a_.finest_wave_m(), b_.finest_wave_m())),
      thinner_m_(std::min(a_.thickness_m(), b_.thickness_m())) {
  contacts_.reserve(kMostContacts);
  before_.reserve(kMostContacts);
}

void TexturedContacts::reset() noexcept {
  regions_.reset();
  contacts_.clear();
  before_.clear();
  samplers_->reset();
  left_out_ = {};
  shares_.reset();
  is_first_ = true;
  is_inside_ = false;
}

std::span<const TexturedContact> TexturedContacts::find(const Pose& X_WA, const Pose& X_WB,
                                                        double dt_s) noexcept {
  dt_s_ = dt_s;
  left_out_ = {};
  std::swap(before_, contacts_);
  contacts_.clear();
  is_inside_ = is_inside_ && is_in_reach(X_WA) && is_in_reach(X_WB);
  if (!is_in_reach(X_WA) || !is_in_reach(X_WB)) return {};
  motion_.X_WA = X_WA;
  motion_.X_WB = X_WB;
  const std::span<const TrianglePair> pairs = query_.find(relative(X_WA, X_WB));
  left_out_.pairs = query_.count() - pairs.size();
  const std::span<const ContactRegion> regions = regions_.update(pairs, X_WA, X_WB);
  left_out_.regions = regions_.regions_left_out();
  std::array<const ContactRegion*, kMostContacts> ordered{};
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::size_t place = i;
    for (; place > 0 && goes_before(regions[i], *ordered[place - 1]); --place) {
      ordered[place] = ordered[place - 1];
    }
    ordered[place] = &regions[i];
  }
  const std::span<const ContactRegion* const> longest_first =
      std::span(ordered).first(regions.size());
  plan_refinement(longest_first);
  if (computed_) compute(longest_first, X_WA, X_WB);
  for (const ContactRegion* each : longest_first) {
    const ContactRegion& region = *each;
    const bool is_part = std::any_of(
        contacts_.begin(), contacts_.end(),
        [&](const TexturedContact& other) { return !other.is_doubtful && lies_in(region, other); });
    if (is_part) continue;
    add(contact_of(region), X_WA, X_WB);
  }
  const bool were_in_contact =
      std::any_of(before_.begin(), before_.end(), [](const auto& last) { return is_felt(last); });
  // Shortly before its curve vanishes, a region has no direction.
  if (regions.empty() && were_in_contact && (!pairs.empty() || hold_each_other(X_WA, X_WB))) {
    keep_buried(X_WA, X_WB);
  }
  const bool are_apart =
      pairs.empty() && contacts_.empty() && (!were_in_contact || !hold_each_other(X_WA, X_WB));
  left_out_.regions += shares_.update(
      contacts_, before_,
      {.motion = motion_, .dt_s = dt_s, .is_first = is_first_, .are_apart = are_apart});
  look_inside(X_WA, X_WB);
  motion_.X_WA_before = X_WA;
  motion_.X_WB_before = X_WB;
  return felt_once();
}

// Contacts without a share are moved to the end: the next tick needs them, the caller does not.
std::span<const TexturedContact> TexturedContacts::felt_once() noexcept {
  std::size_t end = contacts_.size();
  for (std::size_t i = 0; i < end;) {
    if (contacts_[i].share > 0.0) {
      ++i;
    } else {
      std::swap(contacts_[i], contacts_[--end]);
    }
  }
  return std::span(contacts_).first(end);
}

// The solid angles of all faces take too long for every tick in which a tool is in the air.
void TexturedContacts::look_inside(const Pose& X_WA, const Pose& X_WB) noexcept {
  const glm::dvec3 a_in_b_m = relative(X_WA, X_WB).position_m;
  const bool may_be =
      is_first_ || is_inside_ || glm::distance(a_in_b_m, a_in_b_before_m_) > thinner_m_;
  is_inside_ = may_be && contacts_.empty() && query_.count() == 0 && hold_each_other(X_WA, X_WB);
  a_in_b_before_m_ = a_in_b_m;
  is_first_ = false;
}

bool TexturedContacts::touch(const Pose& X_WA, const Pose& X_WB) noexcept {
  if (!is_in_reach(X_WA) || !is_in_reach(X_WB)) return false;
  return !query_.find(relative(X_WA, X_WB)).empty() || hold_each_other(X_WA, X_WB);
}

// If the surfaces do not intersect, any point of a body decides.
bool TexturedContacts::hold_each_other(const Pose& X_WA, const Pose& X_WB) noexcept {
  const auto point_in = [](const Pose& X_WD, const Pose& X_WC, const TexturedBody& c) {
    return relative(X_WC, X_WD) * c.hull().vertices_m.front();
  };
  return a_in_b_.is_in(b_, point_in(X_WB, X_WA, a_)) || b_in_a_.is_in(a_, point_in(X_WA, X_WB, b_));
}

double TexturedContacts::half_height_m(double width_m, double last_depth_m) const noexcept {
  return 0.5 * width_m + a_.furthest_displacement_m() + b_.furthest_displacement_m() +
         2.0 * std::max(0.0, last_depth_m);
}

// Regions are ordered by length. Two may be equally long, as where a block penetrates two sheets, so that their order
// changes with every tick: the one that was rendered stays the first.
bool TexturedContacts::goes_before(const ContactRegion& one,
                                   const ContactRegion& longer) const noexcept {
  const auto was_felt = [this](const ContactRegion& region) {
    return std::any_of(before_.begin(), before_.end(), [&](const TexturedContact& last) {
      return last.id == region.id && is_felt(last) && !last.is_fading && last.share > 0.0;
    });
  };
  return one.width_m >= longer.width_m && was_felt(one) && !was_felt(longer);
}

// A new region may be at the place of a kept contact.
double TexturedContacts::depth_before_m(const ContactRegion& region) const noexcept {
  double depth_m = 0.0;
  for (const TexturedContact& last : before_) {
    if (!is_felt(last)) continue;
    if (last.id == region.id || is_part_of(region.frame, last)) {
      depth_m = std::max(depth_m, last.sampled_depth_m);
    }
  }
  return depth_m;
}

TexturedContact TexturedContacts::contact_of(const ContactRegion& region) const noexcept {
  const std::optional<std::size_t> last = index_of(region.id, before_);
  return {.id = region.id,
          .frame = region.frame,
          .width_m = region.width_m,
          .half_extent_m = region.half_extent_m,
          .half_height_m = half_height_m(region.width_m, depth_before_m(region)),
          .halvings = last ? before_[*last].halvings : 0,
          .leaning_a = std::clamp(region.upright_a, 0.0, kAgreement),
          .leaning_b = std::clamp(region.upright_b, 0.0, kAgreement)};
}

// A contact of the previous tick in the present poses.
TexturedContact TexturedContacts::continued(const TexturedContact& last) const noexcept {
  return {.id = last.id,
          .frame = motion_.continued(last),
          .width_m = last.width_m,
          .half_extent_m = last.half_extent_m,
          .half_height_m = half_height_m(last.width_m, last.sampled_depth_m),
          .halvings = last.halvings,
          .leaning_a = last.leaning_a,
          .leaning_b = last.leaning_b};
}

void TexturedContacts::keep_buried(const Pose& X_WA, const Pose& X_WB) noexcept {
  for (const TexturedContact& last : before_) {
    if (!is_felt(last) || last.is_fading || last.share == 0.0) continue;
    TexturedContact kept = continued(last);
    kept.is_kept = true;
    add(kept, X_WA, X_WB);
  }
}

std::span<const std::uint32_t> TexturedContacts::triangles_in(
    const TexturedBody& body, const Pose& pose, const ContactFrame& frame, double outwards,
    const WindowBox& box, std::vector<std::uint32_t>& room) noexcept {
  const ContactFrame own = in_body(pose, frame);
  const std::size_t found = body.find_triangles(own, outwards * own.n, box, room);
  const std::size_t taken = std::min(found, room.size());
  left_out_.triangles += found - taken;
  return std::span(room).first(taken);
}

// The greatest credible depth, and the box that grows towards it while it is empty.
void TexturedContacts::set_reach(TexturedContact& contact) const noexcept {
  contact.reach_m = contact.half_height_m;
  for (const TexturedContact& last : before_) {
    if (last.id != contact.id || !last.is_doubtful) continue;
    contact.reach_m = std::max(contact.reach_m, last.reach_m + kReachGrowth_m_per_s * dt_s_);
    if (last.penetration.covered == 0) contact.half_height_m = contact.reach_m;
  }
}

// Submits everything that this tick may need: all regions, or else the contacts of the previous tick, which may be kept.
void TexturedContacts::compute(std::span<const ContactRegion* const> regions, const Pose& X_WA,
                               const Pose& X_WB) noexcept {
  computed_->begin();
  const auto request = [&](TexturedContact contact) {
    set_reach(contact);
    WindowSamplers::Window& window = samplers_->window_for(contact.width_m);
    left_out_.triangles +=
        computed_->add(contact, window.with(contact.halvings), window.law, a_, X_WA, b_, X_WB);
  };
  for (const ContactRegion* region : regions) request(contact_of(*region));
  for (const TexturedContact& last : before_) {
    if (!regions.empty() || !is_felt(last) || last.is_fading || last.share == 0.0) continue;
    TexturedContact contact = continued(last);
    contact.is_kept = true;
    request(contact);
  }
  computed_->submit();
  left_out_.is_computed_here = computed_->outcome() != GpuOutcome::answered;
}

std::optional<Penetration> TexturedContacts::evaluated(TexturedContact& contact,
                                                       WindowSamplers::Window& window,
                                                       const Pose& X_WA,
                                                       const Pose& X_WB) noexcept {
  CachedPenetration& planned = window.with(contact.halvings);
  contact.grid = planned.grid();
  if (computed_) {
    const std::optional<Penetration>* answer = computed_->find(contact);
    if (answer != nullptr) return *answer;
  }
  PackedPatch patch_a{.surface = a_.surface(),
                      .pose = X_WA,
                      .half_height_m = contact.half_height_m,
                      .leaning_cosine = contact.leaning_a};
  PackedPatch patch_b{.surface = b_.surface(),
                      .pose = X_WB,
                      .half_height_m = contact.half_height_m,
                      .leaning_cosine = contact.leaning_b};
  const auto find_triangles = [&](const CachedPenetration& sampler) {
    const WindowBox box{.half_width_m = 0.5 * sampler.patch_width_m(),
                        .half_height_m = contact.half_height_m};
    patch_a.triangles = triangles_in(a_, X_WA, contact.frame, -1.0, box, triangles_a_);
    patch_b.triangles = triangles_in(b_, X_WB, contact.frame, 1.0, box, triangles_b_);
  };
  if (contact.halvings > 0) {
    const CachedPenetration::Choice choice = planned.choose(patch_a, patch_b, contact.frame);
    if (choice.begins) find_triangles(planned);
    const auto found = planned.evaluate_kept(choice, patch_a, patch_b, contact.frame);
    if (choice.place) return found;
    contact.grid = window.sampler.grid();
  }
  const CachedPenetration::Choice choice = window.sampler.choose(patch_a, patch_b, contact.frame);
  if (choice.needs_triangles()) find_triangles(window.sampler);
  return window.sampler.evaluate(choice, patch_a, patch_b, contact.frame);
}

void TexturedContacts::add(TexturedContact contact, const Pose& X_WA, const Pose& X_WB) noexcept {
  if (contacts_.size() == kMostContacts) {
    ++left_out_.regions;
    return;
  }
  set_reach(contact);
  WindowSamplers::Window& window = samplers_->window_for(contact.width_m);
  const std::optional<Penetration> found = evaluated(contact, window, X_WA, X_WB);
  if (!found && contact.is_kept) return;
  contact.penetration = found.value_or(Penetration{});
  contact.is_doubtful = !found || found->depth_m > contact.reach_m;
  left_out_.depths += found && contact.is_doubtful ? 1 : 0;
  contact.sampled_depth_m = contact.penetration.depth_m;
  if (is_felt(contact)) {
    const double most_m = std::min(most_depth_m(contact, X_WA, X_WB), most_after_m(contact));
    if (most_m < contact.sampled_depth_m) {
      contact.penetration = pressed_to(most_m, contact.penetration);
      contact.is_bounded = true;
    }
    const double slope = glm::length(contact.penetration.slope);
    if (slope > kSteepestSlope) {
      contact.penetration = flattened(kSteepestSlope / slope, contact.penetration);
      contact.is_bounded = true;
    }
  }
  keep_refined(contact);
  contact.is_coarse = window.is_coarse;
  const auto* differences = std::get_if<HardMaximum>(&window.law);
  contact.filter_m =
      differences != nullptr ? differences->step_m : std::get<SmoothMaximum>(window.law).tau_m;
  contact.origin_in_a_m = in_body(X_WA, contact.frame.origin_m);
  contacts_.push_back(contact);
}

}  // namespace asperity
