#include "app/device_remarks.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "app/conductor/reason.h"

namespace asperity {

namespace {

using RemarkWords = std::pair<DeviceRemark, Phrase>;

const std::vector<RemarkWords>& all_remarks() {
  static const std::vector<RemarkWords> kRemarks{
      {DeviceRemark::took_force_away,
       phrase("DeviceTest", "the servo loop took the force away (%1)")},
      {DeviceRemark::ran_away,
       phrase("DeviceTest", "the handle ran farther than %1 mm away, and the force was let go of")},
      {DeviceRemark::along, phrase("DeviceTest", "along %1 %2")},
      {DeviceRemark::not_measured, phrase("DeviceTest", "Not measured: %1.")},
      {DeviceRemark::of_this_computer,
       phrase("DeviceTest", "Of a simulated device: it says something about this computer.")},
      {DeviceRemark::nothing_felt, phrase("DeviceTest", "Nothing was felt.")},
      {DeviceRemark::did_not_run, phrase("DeviceTest", "The loop did not run: %1")},
      {DeviceRemark::force_of_nothing,
       phrase("DeviceTest", "The strongest force with nothing to feel.")},
      {DeviceRemark::noise,
       phrase("DeviceTest", "Standard deviation of the positions of the handle at rest.")},
      {DeviceRemark::too_few_readings, phrase("DeviceTest", "there were too few readings")},
      {DeviceRemark::no_motors, phrase("DeviceTest", "It has no motors.")},
      {DeviceRemark::limited,
       phrase("DeviceTest", "Asked for %1 N at a limit of %2 N, at most %3 N was sent.")},
      {DeviceRemark::stopped,
       phrase("DeviceTest",
              "Stopped under a force, the device got exactly 0 N from the next tick on.")},
      {DeviceRemark::no_number,
       phrase("DeviceTest",
              "Asked for a force that is no number, the device got exactly 0 N in the same tick.")},
      {DeviceRemark::silent, phrase("DeviceTest",
                                    "Without a sign of life from the program the force faded to 0 "
                                    "N (a session waits for %1 s).")},
      {DeviceRemark::did_not_follow, phrase("DeviceTest", "the handle did not follow with %1 N")},
      {DeviceRemark::did_not_move, phrase("DeviceTest", "the handle did not move")},
      {DeviceRemark::sweeps_say_nothing, phrase("DeviceTest", "the sweeps say nothing")},
      {DeviceRemark::push_did_not_move,
       phrase("DeviceTest", "a push of %1 N did not move the handle")},
      {DeviceRemark::latency,
       phrase("DeviceTest", "From a sudden force to the motion that is read.")},
      {DeviceRemark::mass,
       phrase("DeviceTest",
              "Of the handle and what moves with it, from how a sudden force speeds it up.")},
      {DeviceRemark::friction,
       phrase("DeviceTest", "Coulomb friction, from slow sweeps to and fro at two speeds.")},
      {DeviceRemark::damping, phrase("DeviceTest", "Growth of that resistance with speed.")},
      {DeviceRemark::position_step,
       phrase("DeviceTest",
              "The step of positions that would make the errors found in a slow sweep.")},
      {DeviceRemark::resonance,
       phrase("DeviceTest",
              "The lowest frequency at which the handle answers twice as much as its mass.")},
      {DeviceRemark::no_resonance, phrase("DeviceTest", "there is none from %1 to %2 Hz")},
      {DeviceRemark::stiffest,
       phrase(
           "DeviceTest",
           "The stiffest spring, up to 8000 N/m, on which the handle came to rest after a kick.")},
      {DeviceRemark::swings_at_once,
       phrase("DeviceTest", "already a spring of 250 N/m made the handle swing")},
      {DeviceRemark::weakest,
       phrase("DeviceTest",
              "The weakest push, by steps of a factor √2, that moved the handle from rest.")},
      {DeviceRemark::nothing_moves_it, phrase("DeviceTest", "no push up to %1 N moved the handle")},
      {DeviceRemark::nobody_moved_it,
       phrase("DeviceTest", "Nobody moved the handle along the borders of its workspace.")},
      {DeviceRemark::no_readings, phrase("DeviceTest", "There were no readings.")},
      {DeviceRemark::share_reached,
       phrase("DeviceTest", "The least share of the declared workspace that the handle reached.")},
      {DeviceRemark::not_known,
       phrase("DeviceTest", "Not known of %1, which the simulated device stands for.")},
  };
  return kRemarks;
}

/// The reasons of up to three axes, one after the other.
Phrase read_reasons(const std::string& stored) {
  const std::size_t end = stored.rfind("; along ");
  if (end == std::string::npos) return read_remark(stored);
  return Phrase("%1; %2").with(read_reasons(stored.substr(0, end)),
                               read_remark(stored.substr(end + 2)));
}

}  // namespace

Phrase phrase_of(DeviceRemark remark) {
  const std::vector<RemarkWords>& all = all_remarks();
  const auto found = std::find_if(
      all.begin(), all.end(), [remark](const RemarkWords& words) { return words.first == remark; });
  assert(found != all.end());
  return found->second;
}

Phrase read_remark(const std::string& stored) {
  for (const auto& [remark, words] : all_remarks()) {
    const auto places = words.places_in(stored);
    if (!places) continue;
    std::vector<Phrase> arguments{};
    for (const std::string& place : *places) {
      const bool is_of_axes = remark == DeviceRemark::not_measured;
      arguments.push_back(is_of_axes ? read_reasons(place) : read_remark(place));
    }
    return words.filled(std::move(arguments));
  }
  for (const Fault fault : kFaults) {
    if (phrase_of(fault).english() == stored) return phrase_of(fault);
  }
  return stored;
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
      return phrase("DeviceTest", "steps of positions");
    case DeviceTrait::position_noise:
      return phrase("DeviceTest", "noise of positions");
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
      return phrase("DeviceTest", "weakest force");
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

Phrase what_is_known(const DeviceProfile& profile) {
  if (profile.stands_for().empty()) return {};
  return phrase("DeviceTest", "Simulated in place of %1; known of it: %2; not known: %3.")
      .with(profile.stands_for(), listed_traits(profile.known()), listed_traits(profile.not_known));
}

Phrase verdict_on(const DeviceProfile& profile, const ItemNames& called) {
  const auto names = [&](const auto& is_meant) {
    std::string all{};
    for (const DeviceItem& item : profile.items) {
      if (!is_meant(item)) continue;
      all += (all.empty() ? "" : ", ") + (called ? called(item.name) : item.name);
    }
    return all;
  };
  const std::string failed =
      names([](const DeviceItem& item) { return item.status == DeviceItem::Status::fail; });
  const std::string open = names([](const DeviceItem& item) { return item.is_open(); });
  const bool kept_some =
      std::any_of(profile.items.begin(), profile.items.end(), [](const DeviceItem& item) {
        return item.status == DeviceItem::Status::pass && !item.is_only_told();
      });
  Phrase kept{};
  if (!failed.empty()) {
    kept = phrase("DeviceTest", "The device did not keep every limit: %1.").with(failed);
  } else if (kept_some) {
    kept = open.empty() ? phrase("DeviceTest", "The device kept every limit.")
                        : phrase("DeviceTest", "The device kept every limit of what was measured.");
  } else if (open.empty()) {
    kept = phrase("DeviceTest", "The device was held to no limit.");
  }
  if (open.empty()) return kept;
  const Phrase unseen = phrase("DeviceTest", "Not measured, though limited: %1.").with(open);
  return kept.empty() ? unseen : Phrase("%1 %2").with(kept, unseen);
}

}  // namespace asperity
