// Declares the search for the largest stiffness at which a simulated stroke shows no perceived instability.

#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "device/simulated_device.h"
#include "renderers/offline/perceived_instability.h"

namespace asperity {

/// The simulated device of an arm in a light hand: without the damping of a hand that grips it firmly, with the position step,
/// the latency and the velocity of a Falcon.
inline constexpr const char* kArmInLightHand =
    "simulated:falcon,mass_kg=0.1,damping_N_s_per_m=1,normal_damping_N_s_per_m=1";

/// Strokes of a simulated hand on a simulated device, in a closed loop.
struct LoopStrokes {
  SimulatedDeviceSettings device{};
  HandHabits habits{};
  double rate_Hz = 1000.0;
  double duration_s = 4.0;
  int strokes = 3;         ///< independent hands, each with its own seed
  std::uint64_t seed = 1;  ///< of the first one
};

/// The records of the stroke `number` (from 0), with presentation 1. The renderer is called once in a period, the force is held
/// in between and limited to the peak force of the device; the slew limit is that of ForceLimits.
///
/// Errors: std::invalid_argument in the cases of the model, the hand and the device, and for a rate that is not positive.
std::vector<TickRecord> loop_stroke(const ForceModel& model, const RendererInputs& inputs,
                                    const LoopStrokes& loop, int number);

struct CleanStiffnessSearch {
  double least_N_per_m = 100.0;
  double most_N_per_m = 409600.0;
  double tolerance = 0.02;  ///< of the stiffness, relative
  double buzz_limit = 0.4;  ///< on Buzz::ratio (docs/instability.md)
  /// On Buzz::force_N. A ratio alone would accept on a strong texture a vibration that is felt without it. The vibration that
  /// position steps Δ alone cause on a surface K has K·Δ/√12, because a rounding error is uniform over a step; it reaches the
  /// limit at K = √12·20 mN/Δ, 1.82 kN/m for the 38 µm of a Falcon. This is twice the greatest stiffness that participants
  /// found clean, 0.33 to 0.90 kN/m from 250 Hz to 40 kHz [Choi 2004b]: where they found the border, the ratio decides.
  double buzz_force_limit_N = kFeltForce_N;
};

enum class CleanStatus {
  ok,
  clean_everywhere,  ///< also at the largest stiffness of the search
  clean_nowhere,     ///< not even at the smallest one
  not_judged         ///< at the smallest one no stroke has contact of 0.3 s
};
const char* text_of(CleanStatus status) noexcept;

/// The result: a stiffness at which all strokes are clean, and a larger one, within the tolerance, at which one is not.
struct CleanStiffness {
  CleanStatus status = CleanStatus::ok;
  std::optional<double> clean_N_per_m{};
  std::optional<double> unclean_N_per_m{};
  /// The greatest ratio and the greatest force of the strokes.
  std::optional<Buzz> buzz_of_clean{};
  std::optional<Buzz> buzz_of_unclean{};  ///< none if a stroke was not judged
};

/// Searches the largest clean stiffness of the surface (Material::stiffness_N_per_m), after the experiments of [Choi 2004], with
/// the detector of buzz (perceived_instability.h) in place of the participant.
///
/// A stiffness is clean if, in every one of the strokes, the detector has a ratio of at most `buzz_limit` and a force of at
/// most `buzz_force_limit_N`. A stroke without contact of 0.3 s is not clean: the probe is thrown off the surface. The search
/// doubles the stiffness from the smallest one until one is not clean, and then bisects its logarithm between this one and the
/// one before, until their ratio is at most 1 + tolerance. A larger stiffness that is clean again is not searched for.
///
/// The same inputs give the same result. nullopt if stopped by `stop`.
///
/// Cost: strokes × (some 10 to 15) × 4 s of closed loop at the rate, each judged as in a session.
///
/// Errors: std::invalid_argument, naming the field, for limits that are not positive or not in order, a tolerance or a number of
/// strokes that is not positive, and a rate at which the detector has no band (300 Hz or less); in the cases of `loop_stroke`.
///
/// [Choi 2004] Choi, Tan: Perceived instability of virtual haptic texture. I. Experimental studies.
/// [Choi 2004b] Choi, Tan: Effect of update rate on perceived instability of virtual haptic texture.
std::optional<CleanStiffness> clean_stiffness(const ForceModel& model, const RendererInputs& inputs,
                                              const LoopStrokes& loop,
                                              const CleanStiffnessSearch& search,
                                              const std::stop_token& stop = {});

}  // namespace asperity
