// Declares the detectors of perceived instability: a vibration, a force and a shape that a model does not contain.

#pragma once

#include <cstdint>
#include <optional>

#include "renderers/force/force_model.h"
#include "renderers/offline/recorded_force.h"

namespace asperity {

/// Why a detector has no value.
enum class NotJudged {
  too_short,  ///< contact (buzz), resting contact (aliveness) or slow contact (ridge) is too short
  no_force,   ///< no force was delivered: the device has no motors
  low_rate,   ///< the servo rate is too low for the band
  no_crests,  ///< the model declares no crests (ForceModel::crest_phase), or not where they lie on a body
};
/// "too_short", as it is stored.
const char* name_of(NotJudged reason) noexcept;

/// A vibration that the model does not explain.
struct Buzz {
  double ratio =
      0.0;  ///< force_N relative to the texture force; at least relative to kLeastTexture_N
  double force_N = 0.0;      ///< RMS in the window with the most (unexplained_vibration.h)
  std::int64_t time_ns = 0;  ///< of the middle of that window
};

/// The force on a hand that rests on the surface, in 2 to 20 Hz.
struct Aliveness {
  double resting_s = 0.0;  ///< how long the hand rested in stretches that are long enough
  double force_N = 0.0;    ///< RMS of the delivered force
  double plate_N =
      0.0;  ///< RMS of the force of the same surface without texture for the same motion
  double position_m = 0.0;  ///< RMS of the motion
  /// Work of the delivered force on the hand less that of the surface without texture, over closed parts of the path;
  /// nullopt if no part of the path is closed.
  std::optional<double> net_work_J{};
};

/// The proportion of slow contact near crests.
struct Ridge {
  double crest_share = 0.0;  ///< 0.3 where the hand is at all phases for equally long
  double slow_s = 0.0;       ///< time over which it was taken
};

/// The three kinds of perceived instability of [Choi 2004] in the record of one presentation. Each has a value or the reason
/// why it has none.
struct PerceivedInstability {
  std::optional<Buzz> buzz{};
  std::optional<NotJudged> no_buzz{};
  std::optional<Aliveness> aliveness{};
  std::optional<NotJudged> no_aliveness{};
  std::optional<Ridge> ridge{};
  std::optional<NotJudged> no_ridge{};
};

/// The threshold for the presence of a force on a pen: 20.8 mN (mean of eleven participants) [Lee 2003].
///
/// [Lee 2003] Lee, Hannaford: Preliminary two dimensional haptic thresholds and task performance enhancements.
inline constexpr double kFeltForce_N = 0.020;
/// The least texture force to which a vibration is related, so that a weak or missing texture does not make an imperceptible
/// vibration a great one.
inline constexpr double kLeastTexture_N = kFeltForce_N;
/// The hand rests below this speed along the surface, for half a second or more.
inline constexpr double kResting_m_per_s = 0.005;
/// A stroke is slow below this speed along the surface.
inline constexpr double kSlow_m_per_s = 0.030;

/// Judges one presentation from its records, those of the plate without its texture, and a fresh renderer of the same model
/// and inputs.
///
/// A stretch is contact with a completely faded-in surface, in which the probe leaves the surface for at most kLift_s and no
/// record is missing.
///
/// **Buzz.** The greatest unexplained vibration of a stretch (unexplained_vibration.h): the force that was sent, compared with the
/// same model along the same path without its components above 30 Hz (slow_hand.h). The reference is the RMS of the texture
/// force in 5 to 500 Hz (recorded_texture_force_rms_N): it is that of the presentation, not of the window, because there is no
/// texture where a stroke reverses; and it contains neither friction nor the hand's pressing, whose changes below 30 Hz are a
/// multiple of a weak texture.
///
/// **Aliveness.** Stretches in which the speed of the slow hand along the surface is below kResting_m_per_s for 0.5 s or more, one
/// period of 2 Hz. A resting hand trembles at 8 to 12 Hz and presses unevenly; a stiff plate turns this into a force. Therefore
/// the plate's force for the same motion is reported as well: a force above it is the texture's. Work: the force of
/// tick i acts until tick i + 1,
///
///   W = Σ (F_i − P_i − C)·(x_{i+1} − x_i)
///
/// F sent, P that of the plate, C the mean of F − P over the part: a constant force does no work on a closed path, and the
/// probe does not return exactly. A part is closed if the probe returns within 50 µm of its beginning; each part is the longest
/// from its beginning, at least 50 ms. A conservative force does no work on it, except for the delay of half a tick; a
/// positive sum is energy that the surface gave to the hand.
///
/// **Ridge.** The proportion of the time of contact below kSlow_m_per_s in which the probe is within ±15 % of a wavelength of a
/// crest (ForceModel::crest_phase). A force along the plane's normal pushes the hand into the valleys: the proportion
/// is then below 0.3.
///
/// Cost: one replay of the records in addition to that of `texture`, and six transforms for each step of the window: 9 ms
/// for 4 s of a point model. Not for the servo thread.
///
/// Errors: std::invalid_argument for inputs that the model rejects. A rate of at most 300 Hz is a reason not to judge.
///
/// [Choi 2004] Choi, Tan: Perceived instability of virtual haptic texture. I. Experimental studies.
/// `texture_force_N`: recorded_texture_force_rms_N(texture, {}), by a caller that has it.
PerceivedInstability perceived_instability(const ForceModel& model, const RendererInputs& inputs,
                                           const RecordedTexture& texture,
                                           std::optional<double> texture_force_N = {});

}  // namespace asperity
