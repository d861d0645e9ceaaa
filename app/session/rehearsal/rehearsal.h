// Can this device do what a protocol asks for? Its limits, and every stimulus that a plan can reach, against a
// measured profile.

#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/stimulus_builder.h"
#include "app/words/phrase.h"
#include "device/device_trait.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// One thing that a device cannot do as a stimulus asks for it.
struct RehearsalWarning {
  /// "friction", "force_resolution", "position_resolution", "wavelength", "bandwidth", "stiffness", "coupling",
  /// "contact", "friction_damping", "workspace"; "not_rehearsed" for a stimulus of which nothing, or nothing of
  /// its stiffness, can be stated;
  /// "limit_" and "unmeasured_" with the name of an item that does not keep the protocol's limit, or of which
  /// nothing is known.
  std::string id{};
  std::string stimulus{};  ///< as the session calls it; empty for what concerns all
  std::string pointer{};   ///< of what asks for it: "/stimuli/rough", "/device/limits/friction_N"
  double asked = 0.0;      ///< both in SI units: N, m, Hz, N/m, N s/m; of an item its limit
  double device = 0.0;
  Phrase text{};  ///< a sentence with both numbers
};

/// As warnings write numbers: "0.300", "8000", as many decimals as three digits take.
std::string in_three_digits(double value);

struct RehearsalCourse {
  std::stop_token stop{};
  std::function<void(double)> progress{};  ///< 0 to 1; may be empty
};

/// Compares the protocol's limits for a device, and every stimulus that the plan can reach, with what the device
/// was measured to do. Of a simulated one timing keeps every limit. Of stimuli:
///
///   friction             RMS of the texture force ≥ friction_N
///   force_resolution     likewise ≥ force_resolution_N, where friction is not the reason
///   position_resolution  amplitude ≥ position_resolution_m
///   wavelength           λ ≥ 2 · position_resolution_m
///   bandwidth            v/λ ≤ half the protocol's rate, and the resonance where one was found
///   stiffness            K the largest eigenvalue of the symmetric part of −∂F/∂x at the force limit (felt_stiffness.h),
///                        B the contact damping: K·T/2 + |B| ≤ b (sampled_loop.h), and K + 2|B|/T ≤ the stiffest spring
///                        that it was seen to hold; T of the protocol, for a loop slower than the one that held it by the
///                        share of the rates
///   coupling             of two bodies behind a virtual coupling instead: likewise of its spring and damper, whatever the
///                        tool touches
///   contact              out of contact for no more than 5 % of a stroke (contact_loss.h), at the force and the speed that
///                        the hand aims at, of a mass of moving_mass_kg with damping_N_s_per_m across the surface. Not of
///                        two bodies
///   friction_damping     see friction_rehearsal.h; of two bodies only without a coupling
///   workspace            the patch inside what was reached by hand, or else what the driver reports
///
/// The texture force is that of `texture_force_rms_N` at the force and the speed that a hand aims at which
/// explores as asked; of a stimulus whose force is made equal to another's it is the other's. A
/// texture's amplitude (√2 times the RMS of its heights) and λ are those of the sinusoid that it suggests, on the
/// device: λ over the motion scale; noise in time and a texture at amplitude 0 have none. F is the force of the
/// stimulus's own model and parameters; one that is made as strong as another counts with the amplitude that its
/// sample suggests. A stimulus without texture force is compared with neither friction nor force resolution. Where
/// something was not measured, it is not compared.
///
/// Two bodies are compared as the relief that both make under the tool's tip along the stroke, H (composed_relief.h),
/// with δ = H − z: so a wave of the tool against one of the surface counts as they meet, and a texture that the tool
/// does not reach does not. The stiffness is that of F = −kδ∇δ, pd_gradient's law: of k(∇δ∇δᵀ + δ∇∇δ) with kδ the force
/// limit, by differences over one sample of H. The amplitude is √2 times the RMS of H, λ the finest wave of either texture
/// (finest_wave.h). Behind a virtual coupling of stiffness k_t the texture force is that of a surface of K·k_t/(K + k_t).
/// Limits: those of composed_relief; the smooth maximum counts as the hard one.
///
/// Errors: none of a stimulus: what cannot be rendered is a warning. std::bad_alloc.
///
/// [Colgate 1997] Colgate, Schenkel: Passivity of a class of sampled-data systems.
/// `course` is for a caller that waits: it may take seconds. What was not compared when the stop came is left out.
std::vector<RehearsalWarning> rehearse_on_device(const Protocol& protocol,
                                                 const DeviceProfile& profile,
                                                 StimulusBuilder& builder,
                                                 const RehearsalCourse& course = {});

/// With which of what is `not_known` of a device (DeviceCapability::not_known) stimuli would be compared, and are not.
/// The workspace is none of it: what the driver reports is compared, as a session takes the force away beyond that
/// whatever the device could reach. Nor is the peak force, which a session's opening compares with the protocol's.
std::vector<DeviceTrait> not_compared(const std::vector<DeviceTrait>& not_known);

/// What was found of a protocol and its files before a session, for a caller that asks again while nothing of them has
/// changed: the checklist first, then the session.
///
/// Threads: any; one that asks while another looks waits for it.
class RehearsalMemory final {
 public:
  /// `compare` is called for another `key` than the last one's, and what it returns is kept unless `stop`
  /// was asked for meanwhile.
  std::vector<RehearsalWarning> recall(
      const std::string& key, const std::stop_token& stop,
      const std::function<std::vector<RehearsalWarning>()>& compare);

  /// `rehearse` is called for another `key` than that of the last one that had no problems. Returns its problems.
  std::vector<Diagnostic> problems_once(const std::string& key,
                                        const std::function<std::vector<Diagnostic>()>& rehearse);

 private:
  std::mutex mutex_{};
  std::optional<std::string> sound_key_{};
  std::optional<std::string> key_{};
  std::vector<RehearsalWarning> warnings_{};
};

/// Names a protocol and the files of the study that it names, by their content. Errors: as `hash_files`.
std::string content_key(const Protocol& protocol, const std::filesystem::path& study);

/// `rehearse_on_device`, unless `memory` (null: none) holds what came of the same protocol, profile and files of the
/// study.
std::vector<RehearsalWarning> rehearse_once(RehearsalMemory* memory, const Protocol& protocol,
                                            const DeviceProfile& profile,
                                            const std::filesystem::path& study,
                                            StimulusBuilder& builder,
                                            const RehearsalCourse& course = {});

}  // namespace asperity
