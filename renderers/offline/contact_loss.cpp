// Implements the strokes of a held mass on a rendered surface, tick by tick.

#include "renderers/offline/contact_loss.h"

#include <cmath>
#include <cstdint>
#include <memory>

#include "analysis/numbers/random.h"
#include "device/refusal.h"
#include "renderers/servo/contact.h"
#include "renderers/servo/servo_time.h"

namespace asperity {
namespace {

constexpr double kLift_m = 0.001;  // above a texture; the hand comes down from there
// After the touch-down the hand presses within 0.15 s, and the mass comes to rest.
constexpr double kSettling_s = 0.5;
// A hand that meets nothing by then is out of contact.
constexpr double kComesDown_s = 2.0;
// The variation between them averages over speeds and forces on both sides of the onset of the loss.
constexpr double kStrokes = 8.0;

}  // namespace

double share_out_of_contact(const ForceModel& model, const RendererInputs& inputs,
                            const HeldStrokes& strokes) {
  require_positive("HeldStrokes::rate_Hz", strokes.rate_Hz);
  const double period_s = 1.0 / strokes.rate_Hz;
  HandHabits habits = strokes.habits;
  habits.lift_height_m = kLift_m;
  VirtualHand hand(habits, Random(0));
  SimulatedDevice device(hand, {.hand = strokes.hand});
  RendererInputs endless = inputs;
  endless.patch.edge = PatchEdge::wall;  // never reached
  // A stroke may be longer than the patch: a texture that is not repeated continues mirrored, without a seam.
  if (endless.patch.tiling == Tiling::bounded) endless.patch.tiling = Tiling::mirror;
  endless.patch.extent_m += 2.0 * (habits.stroke_length_m + 5.0 * habits.drift_m);
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(model, endless);

  const double stroke_s =
      habits.stroke_length_m / (habits.speed_m_per_s * (1.0 - habits.gathering));
  const std::int64_t counted = std::llround(kStrokes * stroke_s * strokes.rate_Hz);
  const std::int64_t settling = std::llround(kSettling_s * strokes.rate_Hz);
  std::int64_t first = std::llround(kComesDown_s * strokes.rate_Hz) + settling;
  bool has_touched = false;
  std::int64_t lost = 0;
  hand.stroke();
  for (std::int64_t tick = 1; tick <= first + counted; ++tick) {
    const auto probe = device.read(tick * period_ns_of(strokes.rate_Hz));
    if (!probe) break;  // its readings are finite and without faults
    if (tick == 1) renderer->reset(*probe);
    const RenderedTick felt = renderer->tick(*probe, period_s);
    (void)device.push(felt.wrench, period_s);
    const bool touches = is_in_contact(felt);
    if (touches && !has_touched) {
      has_touched = true;
      first = tick + settling;
    }
    if (tick > first && !touches) ++lost;
  }
  return static_cast<double>(lost) / static_cast<double>(counted);
}

}  // namespace asperity
