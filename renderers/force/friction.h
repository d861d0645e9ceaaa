// Declares the friction of the point models: its laws, their parameters and their state.

#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// The constants of a friction law: the Material's coefficient, and the parameters that all point models share.
struct FrictionSettings {
  double coefficient = 0.0;          ///< μ of sliding
  double speed_m_per_s = 0.010;      ///< v₀
  double mass_kg = 0.05;             ///< m̂
  double delay_s = 0.0045;           ///< τ
  double stiffness_N_per_m = 120.0;  ///< σ
  double smoothing_s = 0.0025;       ///< τ_s
  double static_ratio = 1.0;         ///< μ_s/μ
  double damping_N_s_per_m = 0.0;    ///< b_s
};

/// One sample of the hand along the surface, in contact.
struct FrictionSample {
  glm::dvec2 position_m{0.0};
  glm::dvec2 velocity_m_per_s{0.0};
  double normal_N = 0.0;  ///< N, not negative
  double dt_s = 0.0;      ///< T, since the previous sample, positive
};

/// The state of a law in a contact. The initial state is that of no contact.
struct FrictionState {
  bool in_contact = false;
  bool slides = false;        ///< `proxy`: at the level of sliding
  glm::dvec2 halfway_m{0.0};  ///< after the first of two low-passes
  glm::dvec2 smooth_m{0.0};   ///< s, the smoothed position
  glm::dvec2 strain_m{0.0};   ///< z, of the contact
  double normal_N = 0.0;      ///< N̂ of `elastoplastic`, the smoothed normal force
  glm::dvec2 share{0.0};      ///< c of `elastoplastic`: of the drag of sliding
  double work_m2 = 0.0;       ///< 2W/σ of `elastoplastic`: the work of the hand
};

/// A law near rest as a linear element of the loop: its drag is at most that of D = B·v + σ·s + b_s·ṡ.
struct FrictionNearRest {
  double damper_N_s_per_m = 0.0;          ///< B, on the velocity that the device gives
  double stiffness_N_per_m = 0.0;         ///< σ, on the smoothed position s
  double contact_damper_N_s_per_m = 0.0;  ///< b_s, on the differences of s
  double lag_s = 0.0;  ///< of s: what the low-passes add to the latency of the device
};

/// The change of axes between two surfaces: the same point, and the rotation of a vector.
struct FrictionTurn {
  glm::dvec2 from_m{0.0};  ///< of the point, in the axes of the first surface
  glm::dvec2 to_m{0.0};    ///< of the same point, in those of the second
  glm::dmat2 turn{1.0};
};

/// One law of friction by name.
struct FrictionLaw {
  std::string_view name{};
  Phrase (*meaning)() = nullptr;
  std::span<const std::string_view> parameters{};  ///< those that the law uses
  bool remembers = false;                          ///< whether the drag depends on earlier samples
  /// The drag [N]: the force on the hand is −drag. Real-time: no allocation, no exceptions.
  glm::dvec2 (*drag_N)(const FrictionSettings&, const FrictionSample&,
                       FrictionState&) noexcept = nullptr;
  /// The law near rest, under the normal force N [N], in a loop of period T [s]. From it follows what the law requires of a
  /// device (offline/friction_near_rest.h).
  FrictionNearRest (*near_rest)(const FrictionSettings&, double normal_N,
                                double period_s) noexcept = nullptr;
};

/// The laws of friction, in the order in which they are listed to users.
///
/// Symbols: v velocity along the surface, N normal force, μ = FrictionSettings::coefficient, T the period.
///
/// **rounded**: D = μ·N·v/√(v² + v₀²). Coulomb friction that decreases to zero below v₀: a damper of B = μN/v₀ near rest,
/// evaluated with a velocity that is as old as the device makes it.
///
/// **bounded**: the same curve, with a slope that a loop of period T carries, at the end of an implicit step.
///
///   D = μ·N·v'/√(v'² + v_b²),    v' = v − (T/m̂)·D,    v_b = max(v₀, μN/B),    B = m̂/(2T)·sin(π/(2(2τ/T + 1)))
///
/// B is a quarter of the damper on which a mass m̂ begins to oscillate if its velocity is τ old (steepest_damper_N_s_per_m
/// in offline/sampled_loop.h), m̂/(2T) without a delay. v' is the velocity at the end of a period in which friction alone
/// slows m̂, so that dD/dv ≤ B/(1 + BT/m̂). The curve is monotonic in v', and a Newton iteration from below converges to it
/// (bounded_speed in friction.cpp). Price: friction is as weak below v_b as that of `rounded` below v₀.
///
/// **proxy**: adhesion with a breaking strain [Hayward 2000]. The contact sticks to a point of the surface, the anchor a,
/// and pulls the hand to it; the anchor follows the hand at the distance at which the force is that of sliding.
///
///   z = s − a,   D = σ·z;    |z| > z_max:  a ← s − z_max·z/|z|,    z_max = μ·N/σ
///
/// There is no drift: under a force below μ_s·N the anchor does not move, however often the force changes. With μ_s > μ
/// there are two levels, and the hand sticks and slips: it slides off at |z| = μ_s·N/σ, drags at μ·N/σ while it slides and
/// sticks again below 1 mm/s or where it turns round, with a damper D += b_s·ṡ while it sticks (|D| ≤ μ_s·N). A mass m on a spring k_h pulled
/// slowly at v slips with the period (μ_s − μ)·N·(2/k_h + 1/σ)/v + π·√(m/k_h).
///
/// **elastoplastic**: adhesion that is elastic for a small strain and then yields smoothly [Dupont 2002]. Its state is the share
/// c of the drag of sliding, which moves with the path only, so that the drag follows the normal force:
///
///   D = μ·N̂·c,   dc/du = e − α(|c|)·max(0, ĉ·e)·c,   du = σ·dℓ/(μN̂),   α(r)·r = ((r − b)/(1 − b))² for r > b, otherwise 0
///
/// with b = 0.1. Along a line it is a spring σ up to b and wherever it is unloaded; loaded from zero it is
/// |c| = b + (1 − b)·tanh((u − b)/(1 − b)), in steps of any length. A vibration below b·μN̂ does not creep. Sliding, it drags at
/// μ·N̂(t) whatever N does: the mean drag is that of Coulomb friction. Without a normal force c is the direction of motion e, so
/// that a hand that turns round there meets a drag against its new direction.
///
/// N̂ is N after a low-pass of the mean age τ_n = τ_s/5, the same at every period: N̂⁺ = N̂ + T/(T + τ_n)·(N − N̂), from N at the
/// beginning of a contact. It weakens the modulation by a texture of the frequency f by 1/(1 + (2πfτ_n)²), by 0.6 % at 24 Hz, and the steps
/// that a device's position steps cause in N. τ_s = 0: N̂ = N.
///
/// An increase of N̂ under a strained contact increases its energy ½D²/σ, which nothing supplies if the hand rests. The drag is
/// therefore not greater than the one that the work W of the hand can hold:
///
///   |D| ≤ √(2σW),   dW = D·ds,   W ≤ 4·½(μN̂)²/σ where it increases
///
/// With N̂ constant the bound is never reached, because dW − d(½D²/σ) = μN̂·α·|c|²·max(0, ĉ·e)·dℓ ≥ 0. What sliding dissipates,
/// and what a decrease of N̂ takes off the contact, remains in W for the next increase. A drag at the bound increases by σ along
/// the path. For any path and any N(t) the work on s is thus never negative, to the second order in the steps of a path
/// that turns.
///
/// **dahl**: a contact that creeps while it is strained [Dahl 1968], in the vector form in which z relaxes towards the
/// direction of motion e over the path length ℓ:
///
///   dz/dℓ = e − z/z_ss,   z_ss = μ·N/σ,   D = σ·z
///
/// which along a line is dF/dt = σ·v·(1 − F·sgn(v)/(μN)). Over a straight step of length d it is integrated exactly:
///
///   z⁺ = z_ss·e + (z − z_ss·e)·exp(−d/z_ss)
///
/// so the result does not depend on the period, and the drag never exceeds μN (z is shortened to z_ss first where N has
/// decreased). Its slope is bounded by 2σ, without the kink that `proxy` has where sliding begins.
///
/// **lugre**: `dahl` with a level of sliding that depends on the speed v of the smoothed position, and with a damping σ₁
/// (FrictionSettings::damping_N_s_per_m) of the adhesion [de Wit 1995]:
///
///   ż = v − σ·|v|·z/g(v),   g(v) = μN·(1 + (μ_s/μ − 1)·exp(−(v/v₀)²)),   D = σ·z + σ₁'·ż,   σ₁' = min(σ₁, 4·g(v)/|v|)
///
/// z is integrated over a step as that of `dahl`, exactly for a constant v, so that no stiffness is unstable in itself.
/// Sliding at v it drags at g(v), near rest it is a spring σ with a damper σ₁, and at rest without a displacement there is no
/// force. With μ_s = μ and σ₁ = 0 it is `dahl`. The spring is passive on the path s, because σzv − d(½σz²)/dt = σ²z²|v|/g ≥ 0
/// whatever g is. The damper adds σ₁'v²(1 − q) with q = σz·sgn(v)/g, which is negative where the speed has increased; the
/// sum g|v|q² + σ₁'v²(1 − q) is not negative for any q if σ₁'|v| ≤ 4g [Barabanov 2000].
///
/// Position instead of velocity: `proxy`, `elastoplastic`, `dahl` and `lugre` depend on the way and not on an estimated velocity,
/// so that they do not amplify its delay and its steps. The steps of a device's sensor are steps of the force of up to 2σ·Δ; s is
/// the position after two low-passes of the time constant τ_s each (gain 1 − exp(−T/τ_s) per tick). τ_s = 0: s is the
/// position. All of them store at most ½σz² and return no more to the path s, on which their work on a closed path is never
/// positive.
///
/// What they require of a device: the damping b of device and hand with which the loop is passive near rest,
///
///   b > σ·(T/2 + latency + ℓ) + b_s,      ℓ = 2T/(exp(T/τ_s) − 1) < 2τ_s
///
/// where ℓ is the mean age that the low-passes give to the position. In time: the force belongs to a path that is τ old,
/// and T/2 more in the mean while it is held. It differs from that of the present path by at most L·∫|v| over this time,
/// with L the slope of D along the path, so that a device gains no more than L·(T/2 + τ)·∫v² dt and b ≥ L·(T/2 + τ)
/// dissipates it. (In frequency: delayed_damping_N_s_per_m in offline/sampled_loop.h.) For `proxy` L = σ in every motion, and
/// for `elastoplastic` under a constant N: the condition is sufficient. For `dahl` L = σ about z = 0 and up to 2σ where a
/// contact is released that was strained up to z_ss. A vibration over the way p about a strained z relaxes it by the fraction 2p/z_ss in each cycle, until z is 0:
/// vibration is not sustained with the condition, though a release from z_ss may ring for some cycles without twice this
/// damping. `lugre` as `dahl`, with b_s = σ₁. Below the condition a hand at rest vibrates; the amplitude is limited by μN with `proxy` and less with `dahl`.
///
/// `rounded` and `bounded` are dampers on a delayed velocity, which no device renders passively; a mass m does not vibrate
/// on them while B < 2m/T·sin(π/(2(2τ/T + 1))) (steepest_damper_N_s_per_m).
///
/// At rest `rounded` and `bounded` exert no force; `proxy`, `elastoplastic` and `dahl` hold a hand on a slope up to μ·N, as
/// friction does.
///
/// [Hayward 2000] Hayward, Armstrong: A new computational model of friction applied to haptic rendering.
/// [Dupont 2002] Dupont, Hayward, Armstrong, Altpeter: Single state elastoplastic friction models.
/// [Dahl 1968] Dahl: A solid friction model, Aerospace Corporation TOR-0158(3107-18)-1.
/// [de Wit 1995] Canudas de Wit, Olsson, Åström, Lischinsky: A new model for control of systems with friction.
/// [Barabanov 2000] Barabanov, Ortega: Necessary and sufficient conditions for passivity of the LuGre friction model.
/// [Colgate 1997] Colgate, Schenkel: Passivity of a class of sampled-data systems.
std::span<const FrictionLaw> friction_laws() noexcept;

/// The law of this name. Errors: std::invalid_argument, with the names of all laws.
const FrictionLaw& friction_law(std::string_view name);

/// The law of these parameters: `friction_law`, and `rounded` for a model that does not declare this parameter.
const FrictionLaw& friction_law_of(const ParameterValues& parameters);

/// The constants of the shared parameters in a model's complete values; those that a model does not declare keep their
/// defaults. Errors: std::invalid_argument without `friction_speed_m_per_s`.
FrictionSettings friction_settings(double coefficient, const ParameterValues& parameters);

/// The greatest slope [N s/m] of the law `bounded`: a quarter of the damper on which the loop begins to oscillate.
double greatest_friction_slope_N_s_per_m(const FrictionSettings& settings,
                                         double period_s) noexcept;

/// The declaration of v₀, which every model has.
Parameter friction_speed_parameter();

/// Adds the parameters of friction to those of a point model: v₀, the law and the laws' further parameters.
void add_friction_parameters(std::vector<Parameter>& parameters);

/// Only the parameters of friction among a model's values.
ParameterValues friction_values_of(const ParameterValues& parameters);

/// A model's values without those parameters of friction that have no effect: those that its law does not use, except v₀,
/// below which the textures of some models fade too.
ParameterValues without_unused_friction(const ParameterValues& parameters);

/// The friction of one contact: a law with its constants and its state.
///
/// Real-time: `drag_N` and `reset` do not allocate, lock or throw.
class Friction final {
 public:
  /// Errors: as friction_law and friction_settings.
  Friction(double coefficient, const ParameterValues& parameters);

  /// Forgets the contact: where it is lost, and at the start of a presentation.
  void reset() noexcept { state_ = {}; }
  /// Takes over the contact of another friction of the same law, where the hand slides from its surface to this one. A
  /// friction of another law starts over.
  ///
  /// The energy of the contact does not increase. The work W stays the same. A strain z on the stiffness σ continues as z' on
  /// σ': on a stiffer contact with the same drag, σ'z' = σz, and on a softer one with the same energy, ½σ'z'² = ½σz², because
  /// the same drag would need more: z' = z·min(r, √r), r = σ/σ'.
  void continue_contact_of(const Friction& other) noexcept {
    state_ = law_ == other.law_ ? other.state_ : FrictionState{};
    const double ratio = other.settings_.stiffness_N_per_m / settings_.stiffness_N_per_m;
    state_.strain_m *= std::min(ratio, std::sqrt(ratio));
    state_.work_m2 *= ratio;
  }
  /// The same where the axes of the two surfaces differ.
  void continue_contact_of(const Friction& other, const FrictionTurn& turn) noexcept {
    continue_contact_of(other);
    state_.halfway_m = turn.to_m + turn.turn * (state_.halfway_m - turn.from_m);
    state_.smooth_m = turn.to_m + turn.turn * (state_.smooth_m - turn.from_m);
    state_.strain_m = turn.turn * state_.strain_m;
    state_.share = turn.turn * state_.share;
  }
  /// The drag of one sample in contact; the force on the hand is −drag.
  glm::dvec2 drag_N(const FrictionSample& sample) noexcept {
    return law_->drag_N(settings_, sample, state_);
  }

 private:
  const FrictionLaw* law_ = nullptr;
  FrictionSettings settings_{};
  FrictionState state_{};
};

}  // namespace asperity
