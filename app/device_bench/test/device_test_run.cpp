// Announces each part, and compares every measured item with its limit or states why it has no value.

#include "app/device_bench/test/device_test_run.h"

#include <algorithm>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/words/coded_phrases.h"
#include "app/words/device_remarks.h"
#include "app/words/reason.h"

namespace asperity {

Phrase blocker_of(const StageRecord& record, const DeviceStage& stage) {
  if (record.fault != Fault::none) {
    return phrase_of(DeviceRemark::took_force_away).with(phrase_of(record.fault));
  }
  if (record.ran_away) {
    return phrase_of(DeviceRemark::ran_away).with(fixed(1e3 * stage.reach_m, 0));
  }
  return {};
}

DeviceTestRun::DeviceTestRun(HapticDevice& device, const DeviceTestOptions& options,
                             const std::stop_token& stop)
    : device_(device),
      options_(options),
      usual_{.rate_Hz = options.rate_Hz, .is_simulated = options.is_simulated},
      bench_(device, options.rate_Hz, stop, options.watch) {
  const DeviceCapability& capability = device.capability();
  has_motors_ = capability.actuated_degrees_of_freedom > 0;
  profile_.model = capability.model;
  profile_.not_known = capability.not_known;
  force_N_ = options.force_N;
  if (has_motors_) {
    force_N_ = std::min(force_N_, capability.peak_force_N);
    if (capability.continuous_force_N > 0.0) {
      force_N_ = std::min(force_N_, capability.continuous_force_N);
    }
    device.set_limits({.force_N = force_N_});
  }
}

void DeviceTestRun::announce(DeviceTestPart part, std::string what, double done) const {
  if (options_.tell) options_.tell({.part = part, .what = std::move(what), .done = done});
}

void DeviceTestRun::announce(DeviceTestPart part, const std::string& what, int axis,
                             double done) const {
  if (!options_.tell) return;
  options_.tell({.part = part,
                 .axis = axis,
                 .what = what + kTestedAxisNames[static_cast<std::size_t>(axis)],
                 .done = done});
}

void DeviceTestRun::judge(const std::string& name, std::optional<double> value, const Phrase& text,
                          std::vector<double> by_axis) {
  DeviceItem item{.name = name, .value = value, .by_axis = std::move(by_axis), .text = text};
  item.bound = device_quantity(name)->bound;
  const auto given = options_.limits.find(name);
  item.limit = given != options_.limits.end() ? given->second : usual_.of(name);
  if (value) {
    const bool is_kept = !item.limit || keeps(*value, item.bound, *item.limit);
    item.status = is_kept ? DeviceItem::Status::pass : DeviceItem::Status::fail;
  }
  profile_.items.push_back(std::move(item));
}

void DeviceTestRun::judge(const std::string& name, const ByAxis& found) {
  const bool at_least = device_quantity(name)->bound == DeviceItem::Bound::at_least;
  std::optional<double> worst{};
  std::vector<double> by_axis{};
  Phrase missing{};
  for (std::size_t axis = 0; axis < kTestedAxes; ++axis) {
    if (const std::optional<double>& value = found.values[axis]) {
      by_axis.push_back(*value);
      const bool is_worse = !worst || (at_least ? *value < *worst : *value > *worst);
      if (is_worse) worst = value;
    } else if (!found.reasons[axis].empty()) {
      const Phrase reason =
          phrase_of(DeviceRemark::along).with(kTestedAxisNames[axis], found.reasons[axis]);
      missing = with_semicolon(missing, reason);
    }
  }
  if (by_axis.size() != kTestedAxes) by_axis.clear();
  judge(name, worst,
        missing.empty() ? found.text : phrase_of(DeviceRemark::not_measured).with(missing),
        std::move(by_axis));
}

void DeviceTestRun::judge_met(const std::string& name, bool is_met, const Phrase& text) {
  profile_.items.push_back({.name = name,
                            .status = is_met ? DeviceItem::Status::pass : DeviceItem::Status::fail,
                            .text = text});
}

void DeviceTestRun::leave_out(const std::vector<std::string>& names, const Phrase& why) {
  for (const std::string& name : names) judge(name, {}, why);
}

bool DeviceTestRun::is_left_out(const std::string& name) {
  if (has_motors_ && !profile_.is_unknown(name)) return false;
  leave_out({name}, phrase_of(DeviceRemark::no_motors));  // replaced by leave_out_unknown
  return true;
}

}  // namespace asperity
