#include "renderers/pd_gradient/contact/textured_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

constexpr double kAgreement = 0.5;  // cosine between the directions of what is felt as one
constexpr double kSteepestSlope = 1.7320508075688772;  // of a surface as far from n: tan 60°
// In cells: each of two grids has a sample within 0.71 of a peak.
constexpr double kSamePlace = 1.5;
constexpr double kNone = 1e-9;  // what rounding leaves of a share
constexpr double kAlike = 0.1;  // of a force: what a share changes by in a millisecond

/// A rotation, and a place at which single precision still tells millimetres apart. Further out, or turned by
/// what is no rotation, products overflow and nothing can be compared any more.
bool is_in_reach(const Pose& pose) noexcept {
  constexpr double kFurthest_m = 1e4;
  constexpr double kUnit = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3& column = pose.rotation[axis];
    if (!(std::abs(glm::dot(column, column) - 1.0) <= kUnit)) return false;  // false for NaN
    if (!(std::abs(pose.position_m[axis]) <= kFurthest_m)) return false;
  }
  return true;
}

glm::dvec3 in_body(const Pose& pose, const glm::dvec3& place_m) noexcept {
  return glm::transpose(pose.rotation) * (place_m - pose.position_m);
}

/// A's pose as B sees it.
Pose relative(const Pose& a, const Pose& b) noexcept {
  const glm::dmat3 back = glm::transpose(b.rotation);
  return {.rotation = back * a.rotation, .position_m = back * (a.position_m - b.position_m)};
}

ContactFrame in_body(const Pose& pose, const ContactFrame& frame) noexcept {
  const glm::dmat3 back = glm::transpose(pose.rotation);
  return {.origin_m = in_body(pose, frame.origin_m),
          .u = back * frame.u,
          .v = back * frame.v,
          .n = back * frame.n};
}

/// Whether the contact at `frame` is felt in another one's window already.
bool is_part_of(const ContactFrame& frame, const TexturedContact& other) noexcept {
  if (glm::dot(frame.n, other.frame.n) < kAgreement) return false;
  const glm::dvec3 way_m = other.frame.to_frame(frame.origin_m - other.frame.origin_m);
  const double half_m = 0.5 * other.grid.width_m;
  return std::abs(way_m.x) <= half_m && std::abs(way_m.y) <= half_m &&
         std::abs(way_m.z) <= other.half_height_m;
}

glm::dvec3 deepest_m(const TexturedContact& contact) noexcept {
  return contact.frame.origin_m + contact.frame.to_world(contact.penetration.deepest_m);
}

/// Whether both are felt along about the same direction.
bool are_felt_alike(const TexturedContact& one, const TexturedContact& other) noexcept {
  return is_felt(one) && is_felt(other) && glm::dot(one.frame.n, other.frame.n) >= kAgreement;
}

/// Whether both found the same deepest place.
bool are_at_one_place(const TexturedContact& one, const TexturedContact& other) noexcept {
  const double cell_m = std::max(one.grid.spacing_m(), other.grid.spacing_m());
  return are_felt_alike(one, other) &&
         glm::distance(deepest_m(one), deepest_m(other)) <= kSamePlace * cell_m;
}

/// Whether it is felt less deep than it is.
bool is_cut_short(const TexturedContact& contact) noexcept {
  return contact.penetration.depth_m < contact.sampled_depth_m;
}

/// The larger of both ways across n.
double aside_m(const glm::dvec3& way_m) noexcept {
  return std::max(std::abs(way_m.x), std::abs(way_m.y));
}

/// Whether the deepest place of a contact lies outside its own curve.
bool is_beside_curve(const TexturedContact& contact) noexcept {
  return aside_m(contact.penetration.deepest_m) >
         contact.half_extent_m + kSamePlace * contact.grid.spacing_m();
}

/// Whether the deepest place of the first lies outside its own curve and in that of the other one.
bool shows_place_of(const TexturedContact& one, const TexturedContact& other) noexcept {
  if (!is_beside_curve(one) || !are_felt_alike(one, other)) return false;
  const glm::dvec3 way_m = other.frame.to_frame(deepest_m(one) - other.frame.origin_m);
  return aside_m(way_m) <= other.half_extent_m && std::abs(way_m.z) <= other.half_height_m;
}

/// A region whose whole window lies in that of another contact.
bool lies_in(const ContactRegion& region, const TexturedContact& other) noexcept {
  const glm::dvec3 way_m = other.frame.to_frame(region.frame.origin_m - other.frame.origin_m);
  const double room_m = 0.5 * (other.grid.width_m - region.width_m);
  return is_part_of(region.frame, other) && std::abs(way_m.x) <= room_m &&
         std::abs(way_m.y) <= room_m;
}

// A curve lies on both bodies, so the smaller one bounds it; its middle may be at its end.
double widest_window_m(const TexturedBody& a, const TexturedBody& b) {
  constexpr double kStepOfWidths = 1.5;  // regions widen in steps, and are widened with hysteresis
  return kStepOfWidths * 4.0 *
         std::min(a.hull_clusters()->radius_m(), b.hull_clusters()->radius_m());
}

}  // namespace

TexturedContacts::TexturedContacts(TexturedBody a, TexturedBody b, const WindowSampling& sampling,
                                   InstructionSet instructions)
    : a_(std::move(a)),
      b_(std::move(b)),
      query_(a_.hull_clusters(), b_.hull_clusters(), kMostPairs, instructions),
      regions_(a_.hull(), b_.hull(), kMostPairs, kMostContacts),
      samplers_(sampling, widest_window_m(a_, b_),
                std::min(kMostTriangles, std::max(a_.triangles(), b_.triangles())), instructions),
      triangles_a_(std::min(kMostTriangles, a_.triangles())),
      triangles_b_(std::min(kMostTriangles, b_.triangles())),
      thinner_m_(std::min(a_.thickness_m(), b_.thickness_m())) {
  contacts_.reserve(kMostContacts);
  before_.reserve(kMostContacts);
}

void TexturedContacts::reset() noexcept {
  regions_.reset();
  contacts_.clear();
  before_.clear();
  samplers_.reset();
  left_out_ = {};
  is_first_ = true;
  is_inside_ = false;
}

std::span<const TexturedContact> TexturedContacts::find(const Pose& a, const Pose& b,
                                                        double dt_s) noexcept {
  dt_s_ = dt_s;
  rise_ = std::min(1.0, dt_s / kBlend_s);
  left_out_ = {};
  std::swap(before_, contacts_);
  contacts_.clear();
  is_inside_ = is_inside_ && is_in_reach(a) && is_in_reach(b);
  if (!is_in_reach(a) || !is_in_reach(b)) return {};
  const std::span<const TrianglePair> pairs = query_.find(relative(a, b));
  left_out_.pairs = query_.count() - pairs.size();
  const std::span<const ContactRegion> regions = regions_.update(pairs, a, b);
  left_out_.regions = regions_.regions_left_out();
  std::array<const ContactRegion*, kMostContacts> ordered{};
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::size_t place = i;
    for (; place > 0 && goes_before(regions[i], *ordered[place - 1]); --place) {
      ordered[place] = ordered[place - 1];
    }
    ordered[place] = &regions[i];
  }
  for (const ContactRegion* each : std::span(ordered).first(regions.size())) {
    const ContactRegion& region = *each;
    const bool is_part = std::any_of(
        contacts_.begin(), contacts_.end(),
        [&](const TexturedContact& other) { return !other.is_doubtful && lies_in(region, other); });
    if (is_part) continue;
    add({.id = region.id,
         .frame = region.frame,
         .width_m = region.width_m,
         .half_extent_m = region.half_extent_m,
         .half_height_m = half_height_m(region.width_m, depth_before_m(region)),
         .leaning_a = std::clamp(region.upright_a, 0.0, kAgreement),
         .leaning_b = std::clamp(region.upright_b, 0.0, kAgreement)},
        a, b);
  }
  const bool were_in_contact =
      std::any_of(before_.begin(), before_.end(), [](const auto& last) { return is_felt(last); });
  // Shortly before its curve vanishes, a region has no direction any more.
  if (regions.empty() && were_in_contact && (!pairs.empty() || hold_each_other(a, b))) {
    keep_buried(a, b);
  }
  const bool are_apart =
      pairs.empty() && contacts_.empty() && (!were_in_contact || !hold_each_other(a, b));
  blend(a, b, are_apart);
  look_inside(a, b);
  a_before_ = a;
  b_before_ = b;
  return felt_once();
}

// Those without a share go last: they are known in the next tick, and nobody sees them.
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

// Faces and their solid angles are many: not in every tick in which a tool is in the air.
void TexturedContacts::look_inside(const Pose& a, const Pose& b) noexcept {
  const glm::dvec3 a_in_b_m = relative(a, b).position_m;
  const bool may_be =
      is_first_ || is_inside_ || glm::distance(a_in_b_m, a_in_b_before_m_) > thinner_m_;
  is_inside_ = may_be && contacts_.empty() && query_.count() == 0 && hold_each_other(a, b);
  a_in_b_before_m_ = a_in_b_m;
  is_first_ = false;
}

bool TexturedContacts::touch(const Pose& a, const Pose& b) noexcept {
  if (!is_in_reach(a) || !is_in_reach(b)) return false;
  return !query_.find(relative(a, b)).empty() || hold_each_other(a, b);
}

// Where nothing is cut, one point of a body is as good as any other.
bool TexturedContacts::hold_each_other(const Pose& a, const Pose& b) noexcept {
  const auto seen_from = [](const Pose& one, const Pose& other, const TexturedBody& body) {
    const Pose pose = relative(one, other);
    return pose.rotation * body.hull().vertices_m.front() + pose.position_m;
  };
  return a_in_b_.is_in(b_, seen_from(a, b, a_)) || b_in_a_.is_in(a_, seen_from(b, a, b_));
}

double TexturedContacts::half_height_m(double width_m, double last_depth_m) const noexcept {
  return 0.5 * width_m + a_.furthest_displacement_m() + b_.furthest_displacement_m() +
         2.0 * std::max(0.0, last_depth_m);
}

// Regions come longest first. Two may be as long as each other, as where a block goes through two sheets,
// and which is longer then changes with every tick: the one that was felt stays the one.
bool TexturedContacts::goes_before(const ContactRegion& one,
                                   const ContactRegion& longer) const noexcept {
  const auto was_felt = [this](const ContactRegion& region) {
    return std::any_of(before_.begin(), before_.end(), [&](const TexturedContact& last) {
      return last.id == region.id && is_felt(last) && !last.is_fading && last.share > 0.0;
    });
  };
  return one.width_m >= longer.width_m && was_felt(one) && !was_felt(longer);
}

// A region that is new may be where a kept contact was.
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

// Where a contact of the tick before is now, if n stays with B and the place with A.
TexturedContact TexturedContacts::gone_on(const TexturedContact& last, const Pose& a,
                                          const Pose& b) const noexcept {
  const glm::dmat3 turned = b.rotation * glm::transpose(b_before_.rotation);
  return {.id = last.id,
          .frame = {.origin_m = a.rotation * last.origin_in_a_m + a.position_m,
                    .u = turned * last.frame.u,
                    .v = turned * last.frame.v,
                    .n = turned * last.frame.n},
          .width_m = last.width_m,
          .half_extent_m = last.half_extent_m,
          .half_height_m = half_height_m(last.width_m, last.sampled_depth_m),
          .leaning_a = last.leaning_a,
          .leaning_b = last.leaning_b};
}

double TexturedContacts::most_depth_m(const TexturedContact& contact, const Pose& a,
                                      const Pose& b) const noexcept {
  constexpr double kBeyond = 1.01;  // the surface itself is met, whatever rounding does
  const glm::dvec3& n = contact.frame.n;
  const double depth_m = contact.penetration.depth_m;
  const glm::dvec3 on_a_m = deepest_m(contact);
  const glm::dvec3 on_b_m = on_a_m + depth_m * n;
  const auto way_out = [depth_m](const TexturedBody& body, const Pose& pose,
                                 const glm::dvec3& from_m, const glm::dvec3& along) {
    const double texture_m = body.furthest_displacement_m();
    WayOut way = body.way_out(in_body(pose, from_m), glm::transpose(pose.rotation) * along,
                              kBeyond * depth_m + texture_m);
    way.way_m = std::min(depth_m, way.way_m + texture_m);  // one that is thicker agrees to it all
    return way;
  };
  // A line along a body's rim meets nothing of it.
  const auto thickness_m = [&](const TexturedBody& body, const Pose& pose, const glm::dvec3& from_m,
                               const glm::dvec3& along) {
    const double way_m = way_out(body, pose, from_m, along).way_m;
    if (way_m < depth_m) return way_m;
    const double all_m = 2.0 * body.hull_clusters()->radius_m() + depth_m;
    const WayOut way =
        body.way_out(in_body(pose, from_m), glm::transpose(pose.rotation) * along, all_m);
    return way.way_m < all_m ? depth_m : 0.0;
  };
  const double half_window_m =
      contact.is_kept ? depth_m
                      : std::min(depth_m, contact.half_extent_m + a_.furthest_displacement_m() +
                                              b_.furthest_displacement_m());
  // What most contacts are is found out with one short line.
  if (half_window_m == depth_m && way_out(b_, b, on_b_m, -n).way_m == depth_m) return depth_m;
  const double of_b_m = thickness_m(b_, b, on_b_m, -n);
  const double of_a_m = thickness_m(a_, a, on_a_m, n);
  const double median_m =
      std::max(std::min(of_a_m, of_b_m), std::min(std::max(of_a_m, of_b_m), half_window_m));
  if (median_m == depth_m) return depth_m;
  const WayOut out_of_b = way_out(b_, b, on_a_m, n);
  const WayOut out_of_a = way_out(a_, a, on_b_m, -n);
  if (out_of_a.is_inside == out_of_b.is_inside) return median_m;
  return std::min(median_m, out_of_b.is_inside ? out_of_b.way_m : out_of_a.way_m);
}

// Where the deepest place is at a rim, the way from there to where a body ends is another one with every
// sample that it goes on: a bound falls at once, and rises as what is doubtful is believed.
double TexturedContacts::most_after_m(const TexturedContact& contact) const noexcept {
  if (contact.is_fading) return std::numeric_limits<double>::infinity();
  for (const TexturedContact& last : before_) {
    if (last.id != contact.id || !is_felt(last) || !last.is_bounded || last.is_fading) continue;
    return last.penetration.depth_m + kReachGrowth_m_per_s * dt_s_;
  }
  return std::numeric_limits<double>::infinity();
}

void TexturedContacts::keep_buried(const Pose& a, const Pose& b) noexcept {
  for (const TexturedContact& last : before_) {
    if (!is_felt(last) || last.is_fading || last.share == 0.0) continue;
    TexturedContact kept = gone_on(last, a, b);
    kept.is_kept = true;
    add(kept, a, b);
  }
}

// By its name; or else, of those in whose window it was, the one whose deepest place is nearest. As many
// as there are contacts where none is.
std::size_t TexturedContacts::successor_of(const TexturedContact& last) const noexcept {
  std::size_t nearest = contacts_.size();
  const auto away_m = [&](std::size_t i) {
    return glm::distance(deepest_m(contacts_[i]), deepest_m(last));
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].id == last.id) return i;
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!is_part_of(last.frame, contacts_[i])) continue;
    if (nearest == contacts_.size() || away_m(i) < away_m(nearest)) nearest = i;
  }
  return nearest;
}

// The contact of the tick before that goes on as this one, of those of which it is the successor. Where
// others joined it, that is the one whose deepest place is nearest to its own; none has its share where
// that place was in no window before, or where it would be felt otherwise under another name.
std::size_t TexturedContacts::heir_of(std::size_t contact, const Successors& successors,
                                      const Pose& a, const Pose& b) const noexcept {
  const TexturedContact& now = contacts_[contact];
  std::size_t heir = kMostContacts;
  std::size_t nearest = kMostContacts;
  bool others_joined = false;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    if (successors[i] != contact) continue;
    const bool is_same = before_[i].id == now.id;
    others_joined = others_joined || (!is_same && !before_[i].is_fading);
    if (is_same && !before_[i].is_fading) heir = i;
    const auto away_m = [&](std::size_t last) {
      return glm::distance(deepest_m(before_[last]), deepest_m(now));
    };
    if (nearest == kMostContacts || away_m(i) < away_m(nearest)) nearest = i;
  }
  if (heir == kMostContacts || others_joined) heir = nearest;
  if (heir == kMostContacts) return heir;
  const TexturedContact& last = before_[heir];
  const glm::dvec3 way_m = last.frame.to_frame(deepest_m(now) - last.frame.origin_m);
  const bool was_seen = std::max(std::abs(way_m.x), std::abs(way_m.y)) <= 0.5 * last.grid.width_m;
  if (!was_seen || (last.id != now.id && !is_felt_on(last, now, a, b))) return kMostContacts;
  return is_cut_off(last, now, a, b) ? kMostContacts : heir;
}

// Whether a contact pushes as the one before would, if that one's deepest place, which goes with A, went
// along its gradient.
bool TexturedContacts::is_felt_on(const TexturedContact& last, const TexturedContact& now,
                                  const Pose& a, const Pose& b) const noexcept {
  const ContactFrame frame = gone_on(last, a, b).frame;
  const glm::dvec3 place_m = a.rotation * in_body(a_before_, deepest_m(last)) + a.position_m;
  const glm::dvec3 stayed_m = b.rotation * in_body(b_before_, deepest_m(last)) + b.position_m;
  const glm::dvec3 gradient = frame.to_world({last.penetration.slope, -1.0});
  const double depth_m = last.penetration.depth_m + glm::dot(gradient, place_m - stayed_m);
  const glm::dvec3 gradient_now = now.frame.to_world({now.penetration.slope, -1.0});
  return glm::distance(now.penetration.depth_m * gradient_now, depth_m * gradient) <=
         kAlike * now.penetration.depth_m + kReachGrowth_m_per_s * dt_s_;
}

// Whether the bound of a depth is another one, so that it falls at once.
bool TexturedContacts::is_cut_off(const TexturedContact& last, const TexturedContact& now,
                                  const Pose& a, const Pose& b) const noexcept {
  return (is_cut_short(last) || is_cut_short(now)) && !is_felt_on(last, now, a, b);
}

// Of what was one contact, what is nearest to its deepest place, and pushes as it did, has its share.
void TexturedContacts::part(const TexturedContact& last, std::size_t heir, const Pose& a,
                            const Pose& b, Begun& begun) noexcept {
  std::size_t nearest = heir;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const TexturedContact& contact = contacts_[i];
    if (!begun[i] || i == heir || !is_felt(contact)) continue;
    if (!is_part_of(contact.frame, last) || !is_felt_on(last, contact, a, b)) continue;
    if (glm::distance(deepest_m(contact), deepest_m(last)) <
        glm::distance(deepest_m(contacts_[nearest]), deepest_m(last))) {
      nearest = i;
    }
  }
  std::swap(contacts_[nearest].share, contacts_[heir].share);
  std::swap(begun[nearest], begun[heir]);
}

// Whether it would have been felt in the tick before, to first order; not where it moved so far since that
// it would not be known again.
bool TexturedContacts::was_deep(const TexturedContact& contact, const Pose& a,
                                const Pose& b) const noexcept {
  if (is_first_ || !is_felt(contact)) return false;
  const glm::dvec3 now_m = deepest_m(contact);
  const glm::dvec3 before_m = a_before_.rotation * in_body(a, now_m) + a_before_.position_m;
  const glm::dvec3 on_b_m = b.rotation * in_body(b_before_, before_m) + b.position_m;
  const glm::dvec3 way_m = contact.frame.to_frame(now_m - on_b_m);
  if (glm::length(way_m) > 0.5 * contact.grid.width_m) return false;
  const glm::dvec3 gradient{contact.penetration.slope, -1.0};
  return contact.penetration.depth_m - glm::dot(gradient, way_m) > 0.0;
}

double TexturedContacts::share_before(const TexturedContact& contact) const noexcept {
  for (const TexturedContact& last : before_) {
    if (last.id == contact.id && is_felt(last) && !last.is_fading) return last.share;
  }
  return 0.0;
}

// Of each contact, which one feels its place: of those at one place the one that did, or else the deepest.
TexturedContacts::Successors TexturedContacts::owners() const noexcept {
  const auto goes_before = [this](std::size_t one, std::size_t other) {
    const auto rank = [this](std::size_t i) {
      return std::pair{share_before(contacts_[i]), contacts_[i].penetration.depth_m};
    };
    return rank(one) != rank(other) ? rank(one) > rank(other) : one < other;
  };
  Successors owners{};
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    owners[i] = i;
    for (std::size_t j = 0; j < contacts_.size(); ++j) {
      if (j == i || !are_at_one_place(contacts_[i], contacts_[j])) continue;
      if (goes_before(j, owners[i])) owners[i] = j;
    }
  }
  const auto first_of = [&owners](std::size_t i) {
    while (owners[i] != i) i = owners[i];
    return i;
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!is_beside_curve(contacts_[i])) continue;
    for (std::size_t j = 0; owners[i] == i && j < contacts_.size(); ++j) {
      if (shows_place_of(contacts_[i], contacts_[j])) owners[i] = first_of(j);
    }
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) owners[i] = first_of(i);
  return owners;
}

void TexturedContacts::blend(const Pose& a, const Pose& b, bool are_apart) noexcept {
  const std::size_t now = contacts_.size();
  const Successors owner = owners();
  Successors successors{};
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const bool counts = is_felt(before_[i]) && before_[i].share > 0.0;
    const std::size_t successor = counts ? successor_of(before_[i]) : now;
    successors[i] = successor < now ? owner[successor] : now;
  }
  std::array<std::size_t, kMostContacts> heirs{};
  Begun begun{};
  bool parts = false;
  for (std::size_t i = 0; i < now; ++i) {
    TexturedContact& contact = contacts_[i];
    heirs[i] = contact.is_doubtful ? kMostContacts : heir_of(i, successors, a, b);
    bool had_any = contact.is_doubtful;
    for (std::size_t j = 0; j < before_.size(); ++j) {
      const TexturedContact& last = before_[j];
      const bool is_same = last.id == contact.id && (is_felt(last) || last.is_doubtful);
      had_any = had_any || successors[j] == i || is_same ||
                (is_felt(last) && is_part_of(contact.frame, last));
    }
    if (owner[i] != i) {
      contact.share = 0.0;
    } else if (heirs[i] < kMostContacts) {
      contact.share = std::min(1.0, before_[heirs[i]].share + rise_);
    } else if (had_any || was_deep(contact, a, b)) {
      contact.share = rise_;
      begun[i] = true;
      parts = true;
    }
  }
  for (std::size_t i = 0; parts && i < now; ++i) {
    if (heirs[i] < kMostContacts) part(before_[heirs[i]], i, a, b, begun);
  }
  for (std::size_t i = 0; !are_apart && i < before_.size(); ++i) {
    const TexturedContact& last = before_[i];
    const bool goes_on = successors[i] < now && heirs[successors[i]] == i;
    if (!goes_on && is_felt(last) && last.share > rise_ + kNone) fade(last, a, b);
  }
}

// Where its window shows what another contact feels already, or its bound is another one, it stays at its own
// place.
void TexturedContacts::fade(const TexturedContact& last, const Pose& a, const Pose& b) noexcept {
  const std::size_t others = contacts_.size();
  TexturedContact fading = gone_on(last, a, b);
  fading.share = last.share - rise_;
  fading.is_fading = true;
  add(fading, a, b);
  if (contacts_.size() == others) return;
  const std::span<const TexturedContact> before_it = std::span(contacts_).first(others);
  TexturedContact& added = contacts_.back();
  const auto is_at_its_place = [&](const TexturedContact& other) {
    return other.share > 0.0 && (are_at_one_place(added, other) || shows_place_of(added, other));
  };
  if (added.is_doubtful || std::any_of(before_it.begin(), before_it.end(), is_at_its_place)) {
    added.is_doubtful = !lead_on(added, last, a, b);
  } else if (is_cut_off(last, added, a, b)) {
    lead_on(added, last, a, b);
  }
  if (!is_felt(added) || added.share <= kNone) contacts_.pop_back();
}

// As if its deepest place, which goes with A, went along the gradient; not further than that holds.
bool TexturedContacts::lead_on(TexturedContact& contact, const TexturedContact& last, const Pose& a,
                               const Pose& b) const noexcept {
  const glm::dvec3 place_m = a.rotation * in_body(a_before_, deepest_m(last)) + a.position_m;
  const glm::dvec3 stayed_m = b.rotation * in_body(b_before_, deepest_m(last)) + b.position_m;
  const glm::dvec3 way_m = contact.frame.to_frame(place_m - stayed_m);
  if (glm::length(way_m) > kSamePlace * last.grid.spacing_m()) return false;
  contact.penetration = last.penetration;
  contact.sampled_depth_m = last.sampled_depth_m;
  contact.is_bounded = last.is_bounded;
  contact.penetration.depth_m += glm::dot(glm::dvec3{last.penetration.slope, -1.0}, way_m);
  contact.penetration.deepest_m = contact.frame.to_frame(place_m - contact.frame.origin_m);
  return true;
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

void TexturedContacts::add(TexturedContact contact, const Pose& a, const Pose& b) noexcept {
  if (contacts_.size() == kMostContacts) {
    ++left_out_.regions;
    return;
  }
  contact.reach_m = contact.half_height_m;
  for (const TexturedContact& last : before_) {
    if (last.id != contact.id || !last.is_doubtful) continue;
    contact.reach_m = std::max(contact.reach_m, last.reach_m + kReachGrowth_m_per_s * dt_s_);
    if (last.penetration.covered == 0) contact.half_height_m = contact.reach_m;
  }
  WindowSamplers::Window& window = samplers_.window_for(contact.width_m);
  const SamplingGrid& grid = window.sampler.grid();
  PackedPatch patch_a{.surface = a_.surface(),
                      .pose = a,
                      .half_height_m = contact.half_height_m,
                      .leaning_cosine = contact.leaning_a};
  PackedPatch patch_b{.surface = b_.surface(),
                      .pose = b,
                      .half_height_m = contact.half_height_m,
                      .leaning_cosine = contact.leaning_b};
  if (window.sampler.needs_triangles(patch_a, patch_b, contact.frame)) {
    const WindowBox box{.half_width_m = 0.5 * window.sampler.patch_width_m(),
                        .half_height_m = contact.half_height_m};
    patch_a.triangles = triangles_in(a_, a, contact.frame, -1.0, box, triangles_a_);
    patch_b.triangles = triangles_in(b_, b, contact.frame, 1.0, box, triangles_b_);
  }
  const std::optional<Penetration> found = window.sampler.evaluate(patch_a, patch_b, contact.frame);
  if (!found && (contact.is_kept || contact.is_fading)) return;
  contact.penetration = found.value_or(Penetration{});
  contact.is_doubtful = !found || found->depth_m > contact.reach_m;
  left_out_.depths += found && contact.is_doubtful ? 1 : 0;
  contact.sampled_depth_m = contact.penetration.depth_m;
  if (is_felt(contact)) {
    const double most_m = std::min(most_depth_m(contact, a, b), most_after_m(contact));
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
  contact.grid = grid;
  contact.is_coarse = window.is_coarse;
  contact.origin_in_a_m = in_body(a, contact.frame.origin_m);
  contacts_.push_back(contact);
}

}  // namespace asperity
