// Compares one stimulus with the profile of a device.

#pragma once

#include <string>
#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/explored_stimuli.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "app/session/stimulus_builder.h"
#include "device/virtual_hand.h"
#include "protocols/design/protocol.h"
#include "renderers/offline/bodies_as_relief.h"
#include "renderers/offline/texture_waves.h"

namespace asperity {

/// Makes the warnings for single stimuli; rehearsal.h lists the comparisons. The computations are those of
/// renderers/offline/.
///
/// The arguments of the constructor outlive the object.
class StimulusRehearsal final {
 public:
  StimulusRehearsal(const Protocol& protocol, const DeviceProfile& profile,
                    StimulusBuilder& builder)
      : protocol_(protocol), profile_(profile), builder_(builder) {}

  /// The warnings for a stimulus that is explored as requested. A stimulus that cannot be rendered is a warning as well.
  /// Errors: std::bad_alloc.
  std::vector<RehearsalWarning> compare(const PlannedPresentation& planned,
                                        const Exploration& exploration);
  /// Of the stimulus that was compared last, of all its quantities the nearest.
  Nearness nearness() const noexcept { return nearness_; }

 private:
  void warn(RehearsalWarning warning);
  void note_if_near(bool is_near) {
    if (is_near) nearness_ = Nearness::near;
  }
  double period_s() const { return 1.0 / protocol_.rate_Hz; }
  std::optional<double> holds_N_per_m() const;

  void compare_point(const PlannedPresentation& planned, const Exploration& exploration);
  void compare_bodies(const PlannedPresentation& planned, const Exploration& exploration);
  double texture_force_N(const PlannedPresentation& planned, const PreparedStimulus& stimulus,
                         const TextureForcePath& path);

  void check_force(double texture_force_N);
  bool force_is_compared() const;
  void check_waves(const TextureWaves& waves, double speed_m_per_s);
  void check_coupling(const VirtualCoupling& coupling);
  void check_stiffness(const std::optional<FeltStiffness>& felt, double holds_N_per_m,
                       double damper_N_s_per_m);
  void check_contact(const PreparedStimulus& stimulus, const HandHabits& habits);
  void check_workspace(const SurfacePatch& patch);

  const Protocol& protocol_;
  const DeviceProfile& profile_;
  StimulusBuilder& builder_;
  std::string name_{};     ///< of the stimulus that is compared
  std::string pointer_{};  ///< to it
  std::vector<RehearsalWarning> warnings_{};
  Nearness nearness_ = Nearness::far;
};

}  // namespace asperity
