// How finely contacts on many crests are sampled.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "renderers/pd_gradient/contact/textured_contacts.h"

namespace asperity {

namespace {

/// The longest cell that is at most `enough_m`, of those to which a cell can be halved or doubled; of halved ones at least that
/// after `most_halvings`. Textures that are sampled alike have the same one.
double fine_enough_m(double cell_m, double enough_m, int most_halvings) {
  const int doublings = std::ilogb(enough_m / cell_m);
  const bool is_rounded = std::ldexp(cell_m, doublings) > enough_m;
  return std::ldexp(cell_m, std::max(is_rounded ? doublings - 1 : doublings, -most_halvings));
}

}  // namespace

// The bound of the error of a slope is κ·c²/(8·step).
WindowSampling TexturedContacts::refinable(WindowSampling sampling, const TexturedBody& a,
                                           const TexturedBody& b) noexcept {
  constexpr double kMostSlopeError = 0.002;  // a fifth of the error on one crest
  const double crest_per_m = a.crest_per_m() + b.crest_per_m();
  const auto* hard = std::get_if<HardMaximum>(&sampling.law);
  sampling.fine_enough_m =
      hard != nullptr && crest_per_m > 0.0
          ? fine_enough_m(sampling.cell_m,
                          std::sqrt(8.0 * kMostSlopeError * hard->step_m / crest_per_m),
                          sampling.most_halvings)
          : std::numeric_limits<double>::infinity();
  return sampling;
}

// Decides how often the cells of the contacts of the previous tick may be halved if they continue in this one: of the
// longer ones first, as often as the samples of all contacts permit.
void TexturedContacts::plan_refinement(std::span<const ContactRegion* const> regions) noexcept {
  struct Planned {
    TexturedContact* last = nullptr;
    WindowSamplers::Window* window = nullptr;
  };
  std::array<Planned, kMostContacts> planned{};
  std::size_t count = 0;
  for (TexturedContact& last : before_) {
    last.halvings = 0;
    const bool may_be_kept = is_felt(last) && !last.is_fading && last.share > 0.0;
    if (regions.empty() && may_be_kept) {
      planned[count++] = {.last = &last, .window = &samplers_->window_for(last.width_m)};
    }
  }
  for (const ContactRegion* region : regions) {
    const std::optional<std::size_t> last = index_of(region->id, before_);
    planned[count++] = {.last = last ? &before_[*last] : nullptr,
                        .window = &samplers_->window_for(region->width_m)};
  }
  const auto samples = [](const Planned& contact, int halvings) {
    const long across = contact.window->with(halvings).grid().samples;
    return across * across;
  };
  long left = most_samples_;
  for (const Planned& contact : std::span(planned).first(count)) left -= samples(contact, 0);
  for (const Planned& contact : std::span(planned).first(count)) {
    if (contact.last == nullptr || !(contact.last->refine_s > 0.0)) continue;
    const auto added = [&](int halvings) {
      return samples(contact, halvings) - samples(contact, 0);
    };
    int halvings = static_cast<int>(contact.window->finer.size());
    while (halvings > 0 && added(halvings) > left) --halvings;
    contact.last->halvings = halvings;
    left -= added(halvings);
  }
}

// After its evaluation: whether it is on many crests, or was not long ago.
void TexturedContacts::keep_refined(TexturedContact& contact) const noexcept {
  if (is_felt(contact) && contact.penetration.spread_m > crests_m_) {
    contact.refine_s = kRefined_s;
    return;
  }
  if (const std::optional<std::size_t> last = index_of(contact.id, before_)) {
    contact.refine_s = std::max(0.0, before_[*last].refine_s - dt_s_);
  }
}

}  // namespace asperity
