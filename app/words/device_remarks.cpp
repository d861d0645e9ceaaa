// Holds the table of codes and phrases, and lists traits in one phrase.

#include "app/words/device_remarks.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace asperity {

namespace {

struct RemarkWords {
  DeviceRemark remark{};
  const char* code = nullptr;
  Phrase words{};
};

const std::vector<RemarkWords>& all_remarks() {
  static const std::vector<RemarkWords> kRemarks{
      {DeviceRemark::took_force_away, "device_test_force_removed",
       phrase("DeviceTest", "the servo loop set the force to zero (%1)")},
      {DeviceRemark::ran_away, "device_test_handle_ran_away",
       phrase("DeviceTest",
              "the handle moved away by more than %1 mm, and the force was switched off")},
      {DeviceRemark::along, "device_test_along_axis", phrase("DeviceTest", "along %1 %2")},
      {DeviceRemark::not_measured, "device_test_not_measured",
       phrase("DeviceTest",
              "Not measured: %1. If this value is needed, fix the cause and measure the device "
              "again.")},
      {DeviceRemark::of_this_computer, "device_test_simulated",
       phrase("DeviceTest",
              "Measured on a simulated device: the value characterises this computer.")},
      {DeviceRemark::nothing_felt, "device_test_no_surface",
       phrase("DeviceTest", "No surface was presented.")},
      {DeviceRemark::did_not_run, "device_test_loop_did_not_run",
       phrase("DeviceTest",
              "The servo loop did not run: %1. Fix the cause, then measure the device again.")},
      {DeviceRemark::force_of_nothing, "device_test_force_without_surface",
       phrase("DeviceTest", "Largest force sent without a surface.")},
      {DeviceRemark::noise, "device_test_position_noise",
       phrase("DeviceTest", "Standard deviation of the positions of the handle at rest.")},
      {DeviceRemark::too_few_readings, "device_test_too_few_readings",
       phrase("DeviceTest", "there were too few readings")},
      {DeviceRemark::no_motors, "device_test_no_motors", phrase("DeviceTest", "It has no motors.")},
      {DeviceRemark::limited, "device_test_force_limit",
       phrase("DeviceTest", "When %1 N was requested at a limit of %2 N, at most %3 N was sent.")},
      {DeviceRemark::stopped, "device_test_zero_after_stop",
       phrase("DeviceTest",
              "After a stop under force, exactly 0 N was sent from the next tick on.")},
      {DeviceRemark::no_number, "device_test_zero_after_not_finite",
       phrase("DeviceTest",
              "When a force that is not finite was requested, exactly 0 N was sent in the same "
              "tick.")},
      {DeviceRemark::silent, "device_test_zero_without_heartbeat",
       phrase("DeviceTest",
              "Without a heartbeat from the program, the force faded to 0 N (timeout in a session: "
              "%1 s).")},
      {DeviceRemark::did_not_act, "device_test_did_not_act",
       phrase("DeviceTest", "This is required, and it did not happen: %1")},
      {DeviceRemark::did_not_follow, "device_test_did_not_follow",
       phrase("DeviceTest", "the handle did not follow a force of %1 N")},
      {DeviceRemark::did_not_move, "device_test_did_not_move",
       phrase("DeviceTest", "the handle did not move")},
      {DeviceRemark::swings_in_sweeps, "device_test_swings_in_sweeps",
       phrase("DeviceTest", "the handle kept swinging by %1 mm during the sweeps")},
      {DeviceRemark::sweeps_say_nothing, "device_test_sweeps_inconclusive",
       phrase("DeviceTest", "the sweeps were inconclusive")},
      {DeviceRemark::push_did_not_move, "device_test_push_did_not_move",
       phrase("DeviceTest", "a push of %1 N did not move the handle")},
      {DeviceRemark::swings_before_pushes, "device_test_swings_before_pushes",
       phrase("DeviceTest", "the handle did not come to rest within %1 s before a push")},
      {DeviceRemark::latency, "device_test_latency",
       phrase("DeviceTest", "Time from a force step to the measured motion.")},
      {DeviceRemark::mass, "device_test_moving_mass",
       phrase("DeviceTest",
              "Mass of the handle and the parts that move with it, from the acceleration after a "
              "force step.")},
      {DeviceRemark::friction, "device_test_friction",
       phrase("DeviceTest", "Coulomb friction, from slow back-and-forth sweeps at two speeds.")},
      {DeviceRemark::damping, "device_test_damping",
       phrase("DeviceTest", "Increase of the resistance to motion with speed.")},
      {DeviceRemark::position_step, "device_test_position_resolution",
       phrase("DeviceTest",
              "The position resolution that corresponds to the errors measured in a slow sweep.")},
      {DeviceRemark::resonance, "device_test_resonance",
       phrase("DeviceTest",
              "The lowest frequency at which the handle responds twice as strongly as its mass "
              "alone.")},
      {DeviceRemark::no_resonance, "device_test_no_resonance",
       phrase("DeviceTest", "there is no resonance between %1 and %2 Hz")},
      {DeviceRemark::stiffest, "device_test_stiffness",
       phrase("DeviceTest",
              "The stiffest spring, up to 8000 N/m, on which the handle came to rest after an "
              "impulse.")},
      {DeviceRemark::swings_at_once, "device_test_unstable_at_softest",
       phrase("DeviceTest", "even a spring of 250 N/m made the handle oscillate")},
      {DeviceRemark::weakest, "device_test_force_resolution",
       phrase("DeviceTest",
              "The weakest push, in steps of a factor of √2, that moved the handle from rest.")},
      {DeviceRemark::nothing_moves_it, "device_test_no_push_moved",
       phrase("DeviceTest", "no push up to %1 N moved the handle")},
      {DeviceRemark::nobody_moved_it, "device_test_workspace_not_explored",
       phrase("DeviceTest",
              "The handle was not moved along the borders of its workspace; measure the device "
              "again, and move the handle along them.")},
      {DeviceRemark::no_readings, "device_test_no_readings",
       phrase("DeviceTest",
              "There were no readings of the position; check the cable, and measure the device "
              "again.")},
      {DeviceRemark::share_reached, "device_test_workspace_reached",
       phrase("DeviceTest",
              "The smallest fraction of the declared workspace that the handle reached along an "
              "axis.")},
      {DeviceRemark::not_known, "device_test_unknown_trait",
       phrase("DeviceTest",
              "Unknown for %1, which the simulated device models; measure the real device.")},
  };
  return kRemarks;
}

}  // namespace

Phrase phrase_of(DeviceRemark remark) {
  const std::vector<RemarkWords>& all = all_remarks();
  const auto found = std::find_if(all.begin(), all.end(), [remark](const RemarkWords& words) {
    return words.remark == remark;
  });
  assert(found != all.end());
  return found->words.coded(found->code);
}

std::vector<Phrase> coded_remarks() {
  std::vector<Phrase> all{};
  for (const RemarkWords& words : all_remarks()) all.push_back(words.words.coded(words.code));
  return all;
}

Phrase phrase_of(DeviceTrait trait) {
  switch (trait) {
    case DeviceTrait::workspace:
      return phrase("DeviceTest", "workspace");
    case DeviceTrait::peak_force:
      return phrase("DeviceTest", "peak force");
    case DeviceTrait::continuous_force:
      return phrase("DeviceTest", "continuous force");
    case DeviceTrait::rate:
      return phrase("DeviceTest", "rate");
    case DeviceTrait::latency:
      return phrase("DeviceTest", "latency");
    case DeviceTrait::position_step:
      return phrase("DeviceTest", "position resolution");
    case DeviceTrait::position_noise:
      return phrase("DeviceTest", "position noise");
    case DeviceTrait::friction:
      return phrase("DeviceTest", "friction");
    case DeviceTrait::damping:
      return phrase("DeviceTest", "damping");
    case DeviceTrait::moving_mass:
      return phrase("DeviceTest", "moving mass");
    case DeviceTrait::resonance:
      return phrase("DeviceTest", "resonance");
    case DeviceTrait::stiffness:
      return phrase("DeviceTest", "stiffest spring");
    case DeviceTrait::force_resolution:
      return phrase("DeviceTest", "force resolution");
  }
  return {};
}

Phrase listed_traits(const std::vector<DeviceTrait>& traits) {
  Phrase all{};
  for (const DeviceTrait trait : traits) {
    all = all.empty() ? phrase_of(trait) : Phrase("%1, %2").with(all, phrase_of(trait));
  }
  return all;
}

}  // namespace asperity
