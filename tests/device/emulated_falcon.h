// Falcons without hardware: the wire's other end, for the driver as it is.

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "device/falcon/falcon_frame.h"
#include "tests/device/emulated_usb.h"

namespace asperity {

struct EmulatedFalconSettings {
  int port = 2;  ///< its place is "usb 1-PORT"
  std::string serial{};
  bool runs_firmware = true;
  bool is_homed = true;
  /// What its boot loader takes; anything else is loaded and does not run.
  std::vector<std::uint8_t> firmware{};
  double rate_Hz = 1000.0;  ///< of its answers at most
};

/// Boot loader, firmware and mechanics of one Falcon behind its serial chip: two bytes of modem lines
/// before all that it says, those two alone every few milliseconds while it has nothing to say.
///
/// Threads: any.
class EmulatedFalcon final {
 public:
  EmulatedFalcon(EmulatedBus& bus, EmulatedFalconSettings settings);
  ~EmulatedFalcon();
  EmulatedFalcon(const EmulatedFalcon&) = delete;
  EmulatedFalcon& operator=(const EmulatedFalcon&) = delete;

  /// In the machine's own frame, where encoder counts put it.
  void put_grip(const glm::dvec3& position_m);
  /// Goes to and fro by itself: a circle in x and y of this radius, once a second; 0 stands still.
  void circle(double radius_m);
  void press(std::uint8_t buttons);
  void home();

  /// A file that was open of it answers nothing any more but that the device is gone, also when it is back.
  void unplug();
  void plug_in();
  /// Nobody may open it any more; a thread has to be without root's rights to find out.
  void forbid();
  /// Without power it forgets firmware and homing.
  void lose_power();

  /// The next transfers of frames fail on the bus.
  void fail_transfers(int count);
  /// Frames wait on the bus until whoever sent them takes them back. What another process sends over a file of
  /// its own is taken.
  void take_no_frames(bool takes_none);
  /// It takes everything and says nothing any more.
  void fall_silent(bool silent);
  /// Bits flip in what the boot loader sends back, in the next loads.
  void spoil_loads(int count);
  /// The next answer is this late, and those to frames that come meanwhile follow it, one packet each.
  void answer_late(std::chrono::milliseconds delay);
  /// The process that had claimed it has ended: what the kernel does then.
  void let_go();
  /// These bits of each encoder's counts flip on the wire in every answer; 0: none.
  void flip(const std::array<std::int16_t, 3>& bits);
  /// Every answer is preceded by these bytes.
  void babble(std::vector<std::uint8_t> noise);

  bool runs_firmware() const;
  bool is_held() const;  ///< somebody has claimed it
  int refused_claims() const;
  std::int64_t frames() const;
  int loads() const;
  falcon::Frame last_frame() const;
  /// The words of the last frame, and the strongest since this was last asked.
  std::array<std::int16_t, 3> motor_words() const;
  int take_strongest_word();
  /// The most answers that nobody had read yet when another frame came, since this was last asked.
  int take_most_unread();
  /// Requests and values of the serial chip's settings, in order.
  std::vector<std::pair<int, int>> settings_sent() const;

 private:
  /// What it says to a frame, from `due` on.
  struct Spoken {
    std::chrono::steady_clock::time_point due{};
    std::vector<std::uint8_t> bytes{};
  };
  void answer_ioctl(const UMockdevIoctlBase* plug, UMockdevIoctlClient* client);
  int serve(UMockdevIoctlClient* client);
  int serve_former(UMockdevIoctlClient* client);
  int submit(UMockdevIoctlData* argument);
  int reap(UMockdevIoctlData* argument);
  int send_at_once(UMockdevIoctlData* argument);
  int control(std::uint8_t* setup_and_data, int length);
  void take_byte(std::uint8_t byte);
  void take_frame(const falcon::Frame& frame);
  /// How many bytes of `urb` it fills by now.
  std::optional<int> fill(const Urb& urb);
  std::array<std::int16_t, 3> counts_now() const;

  EmulatedBus& bus_;
  EmulatedFalconSettings settings_{};
  std::vector<UMockdevIoctlBase*> plugs_{};  // one for each time that it was plugged in
  std::string node_{};
  std::string system_path_{};
  int number_ = 1;

  mutable std::mutex mutex_{};
  bool plugged_ = false;
  bool silent_ = false;
  bool takes_none_ = false;
  bool held_ = false;
  int refused_claims_ = 0;
  const UMockdevIoctlClient* holder_ = nullptr;  // whoever has claimed it
  int failing_transfers_ = 0;
  int spoilt_loads_ = 0;
  std::vector<std::uint8_t> noise_{};
  int divisor_ = 0;
  bool line_ready_ = false;
  bool runs_ = false;
  bool homed_ = false;
  bool loading_ = false;
  int loads_ = 0;
  std::uint8_t buttons_ = 0;
  std::array<std::int16_t, 3> counts_{};
  std::array<std::int16_t, 3> flipped_{};
  double circle_m_ = 0.0;
  glm::dvec3 centre_m_{0.0, 0.0, 0.115};
  std::vector<std::uint8_t> received_{};
  std::vector<std::uint8_t> taken_{};  // into the boot loader
  std::deque<std::uint8_t> to_say_{};
  std::deque<Spoken> answers_{};
  std::chrono::steady_clock::time_point last_due_{};
  std::chrono::milliseconds delay_{0};
  int most_unread_ = 0;
  falcon::Frame last_frame_{};
  std::int64_t frames_ = 0;
  int strongest_ = 0;
  std::vector<std::pair<int, int>> settings_sent_{};
  UrbQueue urbs_{};
  UrbQueue former_urbs_{};  // of files from before it was plugged in
  IoctlAnswers ioctls_{[this](const auto* plug, auto* client) { answer_ioctl(plug, client); }};
};

}  // namespace asperity
