// Compares a protocol and every stimulus of its plan with the measured profile of a device.

#pragma once

#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/explored_stimuli.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "app/session/stimulus_builder.h"
#include "device/device_trait.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Compares the protocol's limits for a device (limit_rehearsal.h), the steps of its levels (level_rehearsal.h), the
/// friction of the stimuli (friction_rehearsal.h)
/// and every stimulus that the plan can reach (stimulus_rehearsal.h) with the measured properties of the device:
///
///   friction             RMS of the texture force ≥ friction_N
///   force_resolution     RMS of the texture force ≥ force_resolution_N, where friction is not the reason
///   position_resolution  amplitude ≥ position_resolution_m
///   wavelength           λ ≥ 2 · position_resolution_m
///   bandwidth            v/λ ≤ half the protocol's rate, and the resonance if the device has one
///   stiffness            K the largest eigenvalue of the symmetric part of −∂F/∂x at the force limit (felt_stiffness.h),
///                        B the contact damping: K + 2|B|/T ≤ the stiffest spring that the device holds in a loop of the
///                        protocol's rate (sampled_loop.h)
///   coupling             for two bodies behind a virtual coupling, instead of stiffness: its spring and damper, whatever
///                        the tool touches
///   contact              out of contact for no more than 5 % of a stroke (contact_loss.h), at the force and the speed of
///                        the instructed exploration, for a mass of moving_mass_kg with damping_N_s_per_m across the
///                        surface. Not for two bodies
///   friction_damping, friction_stiffness   see friction_rehearsal.h; for two bodies only without a coupling
///   position_step        one position step changes the force by at most 20 mN (position_step_rehearsal.h)
///   workspace            the patch is inside the range reached by hand, or else inside the range that the driver reports
///
/// The texture force is `texture_force_rms_N` at the force and the speed of the instructed exploration; for a stimulus
/// whose force is made equal to another's it is that of the other. Amplitude and λ are those of texture_waves.h. F is
/// the force of the stimulus's own model and parameters; a stimulus that is made as strong as another counts with the
/// amplitude that its sample suggests. A stimulus without texture force is compared with neither friction nor force
/// resolution. Items that were not measured are not compared.
///
/// A warning that several levels of a parameter or several stimuli have in common is one warning (warned_levels.h).
///
/// Two bodies are compared as one relief (bodies_as_relief.h).
///
/// Of the levels of a varied parameter, unless it is the amplitude of the texture, those near a limit are compared
/// (for_each_stimulus_near_limit).
///
/// Errors: std::bad_alloc; a stimulus that cannot be rendered is a warning.
std::vector<RehearsalWarning> rehearse_on_device(const Protocol& protocol,
                                                 const DeviceProfile& profile,
                                                 StimulusBuilder& builder,
                                                 const StimuliCourse& course = {});

/// The traits among the unknown ones of a device (DeviceCapability::not_known) with which stimuli would be compared. The
/// workspace is not among them: the range that the driver reports is compared, because a session removes the force
/// beyond it in any case. Nor is the peak force, which the opening of a session compares with the protocol's.
std::vector<DeviceTrait> not_compared(const std::vector<DeviceTrait>& not_known);

}  // namespace asperity
