// Declares the process that opens and closes a device when the program that drove it was killed.

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "device/watchdog_process.h"

namespace asperity {

/// Lets a second process wait for the end of this one, as long as this object lives. After an end without its destructor
/// (SIGKILL, a crash) it starts `program` as
///
///     PROGRAM close-device DEVICE --claim CLAIM [--library FILE]
///
/// which opens the device and closes it, as soon as that is possible within 60 s: every driver sets the motors to zero in both.
/// A device whose DeviceClaim another program has for all of this time is left to that program, which has set its motors to zero.
/// For a device that is reached through a library of its manufacturer, which the second process itself cannot call: it is a
/// fork of a program with threads (watchdog_process.h). While this process is stopped the device is in use, and nothing
/// happens.
///
/// Errors: the constructor throws those of WatchdogProcess, and std::length_error for names that are too long.
class ClosingProcess final {
 public:
  /// `claim` is the name of the device's DeviceClaim.
  ClosingProcess(const std::filesystem::path& program, const std::string& device,
                 const std::string& claim, const std::filesystem::path& library);
  ClosingProcess(const ClosingProcess&) = delete;
  ClosingProcess& operator=(const ClosingProcess&) = delete;

 private:
  static constexpr std::size_t kLongest_bytes = 4096;
  static constexpr std::size_t kMostWords = 7;
  /// For a process that may not allocate.
  struct Command {
    std::array<std::array<char, kLongest_bytes>, kMostWords> words{};
    std::array<char*, kMostWords + 1> pointers{};  ///< as execv takes them
    std::size_t count = 0;
  };
  void add(const std::string& word);
  static void start(WatchdogProcess::Cause cause, const void* about) noexcept;

  Command command_{};
  std::optional<WatchdogProcess> watchdog_{};
};

}  // namespace asperity
