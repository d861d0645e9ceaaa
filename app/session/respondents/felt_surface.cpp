// Strokes the surface on a stepped rig until the contact is long enough, and extracts its force features.

#include "app/session/respondents/felt_surface.h"

#include "app/session/rig/recorder.h"
#include "app/session/rig/rig.h"
#include "renderers/offline/recorded_force.h"

namespace asperity {

namespace {

constexpr double kContact_s = 4.0;
constexpr std::uint64_t kPresentation = 1;

}  // namespace

ForceFeatures felt_surface(const ForceModel& model, const RendererInputs& inputs,
                           const Protocol& protocol, const HandHabits& habits,
                           const Random& random) {
  RigSettings settings{};
  settings.servo.rate_Hz = protocol.rate_Hz;
  settings.limits.force_N = protocol.force_limit_N;
  SteppedRig rig(settings, 0);
  Recorder recorder;
  rig.prepare_attempt(habits, random.split("hand"));
  recorder.begin(nullptr, protocol.rate_Hz, rig.records());
  rig.pass(0.1, recorder);
  RendererInputs seeded = inputs;
  seeded.seed = random.split("renderer").bits();
  rig.loop().present({kPresentation, model.make(seeded)});
  recorder.watch(kPresentation);
  rig.hand().stroke();
  const double limit_s = 4.0 * kContact_s;
  for (double passed_s = 0.0; recorder.live().contact_s < kContact_s && passed_s < limit_s;
       passed_s += 0.1) {
    rig.pass(0.1, recorder);
  }
  const Recorder::Attempt attempt = recorder.finish(rig.records());
  return recorded_force_features({attempt.records, kPresentation, protocol.rate_Hz});
}

}  // namespace asperity
