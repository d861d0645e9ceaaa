// Implements the closed loop and the search for the largest clean stiffness.

#include "renderers/offline/clean_stiffness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "device/refusal.h"
#include "renderers/offline/unexplained_vibration.h"
#include "renderers/servo/servo_time.h"

namespace asperity {
namespace {

constexpr std::uint64_t kPresentation = 1;

/// The strokes at one stiffness.
struct Judged {
  bool is_clean = true;
  bool is_any_judged = false;
  /// The greatest ratio and the greatest force; none if a stroke was not judged.
  std::optional<Buzz> buzz{};
};

class Search final {
 public:
  Search(const ForceModel& model, const RendererInputs& inputs, const LoopStrokes& loop,
         const CleanStiffnessSearch& search, const std::stop_token& stop)
      : model_(model), inputs_(inputs), loop_(loop), search_(search), stop_(stop) {}

  std::optional<Judged> judged_at(double stiffness_N_per_m) const {
    RendererInputs inputs = inputs_;
    inputs.material.stiffness_N_per_m = stiffness_N_per_m;
    Judged judged{};
    Buzz greatest{};
    for (int number = 0; number < loop_.strokes; ++number) {
      if (stop_.stop_requested()) return {};
      const std::vector<TickRecord> records = loop_stroke(model_, inputs, loop_, number);
      const RecordedTexture texture =
          recorded_texture(model_, inputs, {records, kPresentation, loop_.rate_Hz});
      const std::optional<Buzz> buzz = perceived_instability(model_, inputs, texture).buzz;
      if (!buzz || buzz->ratio > search_.buzz_limit || buzz->force_N > search_.buzz_force_limit_N) {
        judged.is_clean = false;
      }
      if (!buzz) return judged;
      judged.is_any_judged = true;
      greatest.ratio = std::max(greatest.ratio, buzz->ratio);
      greatest.force_N = std::max(greatest.force_N, buzz->force_N);
    }
    judged.buzz = greatest;
    return judged;
  }

 private:
  const ForceModel& model_;
  const RendererInputs& inputs_;
  const LoopStrokes& loop_;
  const CleanStiffnessSearch& search_;
  const std::stop_token& stop_;
};

void require_search(const LoopStrokes& loop, const CleanStiffnessSearch& search) {
  require_positive("CleanStiffnessSearch::least_N_per_m", search.least_N_per_m);
  require_positive("CleanStiffnessSearch::tolerance", search.tolerance);
  require_positive("CleanStiffnessSearch::buzz_limit", search.buzz_limit);
  require_positive("CleanStiffnessSearch::buzz_force_limit_N", search.buzz_force_limit_N);
  require_positive("LoopStrokes::strokes", loop.strokes);
  if (!(search.most_N_per_m > search.least_N_per_m)) {
    throw std::invalid_argument(
        "CleanStiffnessSearch::most_N_per_m is " + number_text(search.most_N_per_m) +
        "; it must be above least_N_per_m, " + number_text(search.least_N_per_m));
  }
  if (!(loop.rate_Hz > 2.0 * kBuzzFrom_Hz)) {
    throw std::invalid_argument("LoopStrokes::rate_Hz is " + number_text(loop.rate_Hz) +
                                "; it must be above " + number_text(2.0 * kBuzzFrom_Hz) +
                                " Hz, because buzz is a vibration from 150 Hz on");
  }
}

}  // namespace

const char* text_of(CleanStatus status) noexcept {
  switch (status) {
    case CleanStatus::ok:
      return "ok";
    case CleanStatus::clean_everywhere:
      return "clean_everywhere";
    case CleanStatus::clean_nowhere:
      return "clean_nowhere";
    case CleanStatus::not_judged:
      return "not_judged";
  }
  return "";
}

std::vector<TickRecord> loop_stroke(const ForceModel& model, const RendererInputs& inputs,
                                    const LoopStrokes& loop, int number) {
  require_positive("LoopStrokes::rate_Hz", loop.rate_Hz);
  const auto renderer = make_renderer(model, inputs);
  VirtualHand hand(loop.habits, Random(loop.seed).split(static_cast<std::uint64_t>(number)));
  SimulatedDevice device(hand, loop.device);
  ForceLimits limits{};
  limits.force_N = device.capability().peak_force_N;
  device.set_limits(limits);
  hand.stroke();
  const auto ticks = std::llround(loop.duration_s * loop.rate_Hz);
  std::vector<TickRecord> records{};
  records.reserve(static_cast<std::size_t>(std::max(ticks, 0LL)));
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    const auto probe = device.read(tick * period_ns_of(loop.rate_Hz));
    if (!probe) break;
    TickRecord record{};
    record.probe = rounded_for_recording(*probe);
    record.presentation = kPresentation;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.gain = 1.0;
    if (tick == 1) {
      record.flags |= static_cast<std::uint32_t>(TickFlag::first_of_presentation);
      renderer->reset(record.probe);
    }
    const RenderedTick rendered = renderer->tick(record.probe, 1.0 / loop.rate_Hz);
    record.rendered = rendered.wrench;
    record.penetration_m = rendered.penetration_m;
    const auto pushed = device.push(rendered.wrench, 1.0 / loop.rate_Hz);
    if (!pushed) break;
    record.sent = pushed->wrench;
    records.push_back(record);
  }
  return records;
}

std::optional<CleanStiffness> clean_stiffness(const ForceModel& model, const RendererInputs& inputs,
                                              const LoopStrokes& loop,
                                              const CleanStiffnessSearch& search,
                                              const std::stop_token& stop) {
  require_search(loop, search);
  const Search strokes(model, inputs, loop, search, stop);
  CleanStiffness found{};
  double stiffness_N_per_m = search.least_N_per_m;
  while (true) {
    const std::optional<Judged> judged = strokes.judged_at(stiffness_N_per_m);
    if (!judged) return {};
    if (!judged->is_clean) {
      if (!found.clean_N_per_m && !judged->is_any_judged) found.status = CleanStatus::not_judged;
      found.unclean_N_per_m = stiffness_N_per_m;
      found.buzz_of_unclean = judged->buzz;
      break;
    }
    found.clean_N_per_m = stiffness_N_per_m;
    found.buzz_of_clean = judged->buzz;
    if (stiffness_N_per_m >= search.most_N_per_m) {
      found.status = CleanStatus::clean_everywhere;
      return found;
    }
    stiffness_N_per_m = std::min(2.0 * stiffness_N_per_m, search.most_N_per_m);
  }
  if (!found.clean_N_per_m) {
    if (found.status == CleanStatus::ok) found.status = CleanStatus::clean_nowhere;
    return found;
  }
  while (*found.unclean_N_per_m > (1.0 + search.tolerance) * *found.clean_N_per_m) {
    const double between_N_per_m = std::sqrt(*found.clean_N_per_m * *found.unclean_N_per_m);
    const std::optional<Judged> judged = strokes.judged_at(between_N_per_m);
    if (!judged) return {};
    (judged->is_clean ? found.clean_N_per_m : found.unclean_N_per_m) = between_N_per_m;
    (judged->is_clean ? found.buzz_of_clean : found.buzz_of_unclean) = judged->buzz;
  }
  return found;
}

}  // namespace asperity
