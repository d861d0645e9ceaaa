// asperity device-test: what a device does, measured and held to limits.

#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <poll.h>
#include <termios.h>

#include "analysis/numbers/number_text.h"
#include "app/cli/call_limit.h"
#include "app/cli/command.h"
#include "app/cli/options/driver_options.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/device_bench/device_bench.h"
#include "app/device_bench/device_choice.h"
#include "app/device_bench/measure_device.h"
#include "app/plugins/plugin_files.h"
#include "app/profiles/device_kind.h"
#include "app/profiles/profile_verdict.h"
#include "app/tasks/protocol_files.h"
#include "device/drivers.h"
#include "device/virtual_hand.h"
#include "protocols/file/device_limit.h"

namespace asperity {

namespace {

/// "friction_N=0.2" → friction_N, 0.2
std::pair<std::string, double> item_limit(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos) {
    if (const auto limit = number_in(std::string_view(text).substr(equals + 1))) {
      return {text.substr(0, equals), *limit};
    }
  }
  throw WrongUsage("--limit takes NAME=NUMBER, such as friction_N=0.2, not \"" + text + '"');
}

/// Those of the options, none of which a protocol would refuse.
std::map<std::string, double> given_limits(const std::vector<std::string>& texts, double rate_Hz) {
  std::map<std::string, double> limits{};
  for (const std::string& text : texts) {
    const auto [item, limit] = item_limit(text);
    if (const auto complaint = complaint_about({.item = item, .limit = limit}, rate_Hz)) {
      throw WrongUsage("--limit " + text +
                       " is not a limit that a protocol can set: " + complaint->english());
    }
    if (!limits.emplace(item, limit).second) {
      throw WrongUsage("--limit " + item + " is given twice; give it once");
    }
  }
  return limits;
}

/// Four digits are more than any of these is good for.
std::string in_four_digits(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return {text.data(), end.ptr};
}

/// A line that somebody types; nothing where a stop or the end of the input comes first.
std::optional<std::string> typed_line(const std::stop_token& stop) {
  constexpr int kBetweenLooks_ms = 50;
  while (!stop.stop_requested()) {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, kBetweenLooks_ms) <= 0) continue;
    std::string line{};
    return std::getline(std::cin, line) ? std::optional(line) : std::nullopt;
  }
  return {};
}

/// Says what will happen and whether somebody agrees to it; `is_agreed` where they said so beforehand.
bool agrees(const std::string& what, bool is_agreed, const std::stop_token& stop) {
  say("asperity: " + what);
  if (is_agreed) return true;
  if (isatty(STDIN_FILENO) == 0) {
    throw WrongUsage(
        "device-test requests confirmation on a terminal before it moves a device, and there is no "
        "terminal; use --yes if a person is next to the device");
  }
  // Not what was typed before anybody could read what it would agree to.
  tcflush(STDIN_FILENO, TCIFLUSH);
  say("Type yes and press Return to begin:");
  return typed_line(stop) == "yes";
}

/// What a person has to know, and a yes, before a real device is measured.
void ask_before_it_moves(const HapticDevice& device, const DeviceTestOptions& options,
                         bool is_agreed, const std::stop_token& stop) {
  const DeviceCapability& capability = device.capability();
  if (capability.actuated_degrees_of_freedom == 0) {
    say("asperity: " + capability.model + " has no motors: nothing moves by itself");
    return;
  }
  const std::string what =
      what_measuring_does(capability.model + ' ' + capability.serial, options.force_N).english();
  if (agrees(what + "\n  Ctrl-C sets the force to zero at once.", is_agreed, stop)) return;
  throw std::runtime_error(stop.stop_requested()
                               ? "nothing was measured: the test was stopped on request; to "
                                 "measure the device, repeat the command"
                               : "nothing was measured: the answer was not \"yes\"; to measure the "
                                 "device, repeat the command and type yes");
}

Table table_of(const DeviceProfile& profile) {
  Table table{{"item", "result", "value", "limit", "remark"}, {}};
  for (const DeviceItem& item : profile.items) {
    std::string limit = "n/a";
    if (item.limit) {
      limit =
          (item.bound == DeviceItem::Bound::at_most ? "<= " : ">= ") + in_four_digits(*item.limit);
    }
    table.rows.push_back({item.name, outcome_of(item),
                          item.value ? in_four_digits(*item.value) : "n/a", limit,
                          item.text.english()});
  }
  return table;
}

void print_for_people(const DeviceProfile& profile) {
  if (const Phrase known = what_is_known(profile); !known.empty()) {
    std::cout << known.english() << '\n';
  }
  std::cout << aligned(table_of(profile)) << verdict_on(profile).english() << '\n';
}

// Longer than the drivers need: opening may load firmware and find the zero of an arm, closing waits for a thread.
constexpr std::chrono::seconds kLongestOpening{120};
constexpr std::chrono::seconds kLongestClosing{10};

/// A device that is closed within a limit, or left to a call into its driver that does not return.
class TestedDeviceHandle final {
 public:
  TestedDeviceHandle(std::unique_ptr<HapticDevice> device, CallLimit& call)
      : device_(std::move(device)), call_(call) {}
  ~TestedDeviceHandle() {
    if (device_ == nullptr) return;
    call_.begin("closing the device", kLongestClosing);
    device_.reset();
    call_.end();
  }
  TestedDeviceHandle(const TestedDeviceHandle&) = delete;
  TestedDeviceHandle& operator=(const TestedDeviceHandle&) = delete;

  HapticDevice& operator*() noexcept { return *device_; }
  MeasuredDevice measure(const MeasureOrder& order, const std::stop_token& stop) {
    try {
      return measure_device(*device_, order, stop);
    } catch (const DriverHangs&) {
      [[maybe_unused]] HapticDevice* const left = device_.release();
      throw;
    }
  }

 private:
  std::unique_ptr<HapticDevice> device_;
  CallLimit& call_;
};

/// Opens it within a limit, which counts anew after each request to the user.
std::unique_ptr<HapticDevice> open_within_limit(const std::string& device, DriverOptions options,
                                                CallLimit& call) {
  const auto begin = [&call] { call.begin("opening the device", kLongestOpening); };
  options.tell = [begin](const std::string& sentence) {
    say(sentence);
    begin();
  };
  options.may_move = [begin, &call, asked = options.may_move](const std::string& what) {
    call.end();
    const bool is_agreed = asked(what);
    begin();
    return is_agreed;
  };
  begin();
  auto opened = built_in_drivers().open(device, options);
  call.end();
  return opened;
}

}  // namespace

void add_device_test(CLI::App& program, Job& job) {
  struct Options {
    std::string device{};
    MeasureOrder order{};
    DriverOptions drivers{};
    std::vector<std::string> limits{};
    std::optional<std::string> protocol{};
    bool json = false;
    bool agreed = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "device-test", "Measure a device: timing, mechanics, safety. The device moves by itself.");
  command
      ->add_option(
          "NAME", options->device,
          "Device: simulated, simulated:MODEL[,PROPERTY=VALUE…], falcon, …; NAME:SERIAL if several "
          "are attached")
      ->required();
  command->add_option("--study", options->order.study,
                      "Store the profile in this study, for its sessions");
  command->add_option("--protocol", options->protocol,
                      "Protocol whose limits and rate apply to the device");
  const CLI::Option* rate =
      command->add_option("--rate-hz", options->order.test.rate_Hz, "Rate of the servo loop")
          ->check(number_within(100.0, 10000.0))
          ->capture_default_str();
  command->add_option("--force-n", options->order.test.force_N, "Upper limit of every force")
      ->check(number_within(0.1, 20.0))
      ->capture_default_str();
  command->add_option("--limit", options->limits, "Limit for an item, NAME=NUMBER");
  add_driver_options(*command, options->drivers);
  command->add_flag("--yes", options->agreed,
                    "Do not request confirmation before the device moves");
  command->add_flag("--json", options->json, "Print the profile as JSON");
  add_plugin_option(*command, options->plugins);
  command->callback([options, rate, &job] {
    const bool has_rate = rate->count() > 0;
    job = [options, has_rate]() -> int {
      require_device("NAME", options->device);
      MeasureOrder& order = options->order;
      // Before a minute of measuring is lost for a folder that is no study.
      std::optional<MeasuringLock> measuring{};
      if (order.study) measuring.emplace(*order.study);
      if (options->protocol) {
        const Protocol protocol =
            load_protocol(*options->protocol, models_with(options->plugins), order.study);
        order.protocol_limits = protocol.device_limits;
        if (!has_rate) order.test.rate_Hz = protocol.rate_Hz;
      }
      order.test.limits = given_limits(options->limits, order.test.rate_Hz);
      VirtualHand hand = hand_to_measure();
      // Both before the device: one that is homed, moves to find its zero or is pushed is not left by a process that
      // just dies.
      InterruptWatch interrupt(
          "asperity: stopping the device. If the handle keeps moving by itself, switch the device "
          "off");
      const InterruptWatch::Hold until_it_is_closed;
      options->drivers.stop = interrupt.token();
      options->drivers.may_move = [&](const std::string& what) {
        return agrees(what, options->agreed, interrupt.token());
      };
      options->drivers.hand = &hand;
      CallLimit call(options->device);
      TestedDeviceHandle device(open_within_limit(options->device, options->drivers, call), call);
      interrupt.will_say("asperity: stopping; the force is set to zero");
      if (kind_of_device(options->device) != DeviceKind::simulated) {
        ask_before_it_moves(*device, order.test, options->agreed, interrupt.token());
        if (isatty(STDIN_FILENO) != 0) order.borders_s = kBorders_s;
      }
      order.test.tell = [](const DeviceTestNews& news) {
        say(fixed(100.0 * news.done, 0) + " %: " + news.what);
      };
      const auto [profile, file] = device.measure(order, interrupt.token());
      if (file) say("the profile is stored as " + file->string());
      if (options->json) {
        std::cout << json_text_of(profile);
      } else {
        print_for_people(profile);
      }
      std::cout.flush();  // closing the device may end the program
      return profile.has_failed() ? 1 : 0;
    };
  });
}

}  // namespace asperity
