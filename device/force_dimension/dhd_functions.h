// The functions of Force Dimension's SDK that we use, as its documentation gives them.

#pragma once

#include <filesystem>
#include <string>

#include "device/vendor_library.h"

namespace asperity {

/// Force Dimension's SDK, loaded: libdrd where it is there (it brings libdhd with it and can find a
/// device's zero), otherwise libdhd alone.
///
/// The fields are named as the functions are, so that they can be held against the SDK's own pages. Both
/// functions that open one take its index in the list of those attached and return its ID, another number, which is
/// the last argument of all others. These return 0, or kTimeGuard, or kMotorSaturated, or −1 with
/// the reason in dhdErrorGetLastStr. Frame: x towards the participant, y to their right, z up; metres,
/// newtons, newton metres.
///
/// Errors: the constructor's are VendorLibrary's.
class DhdFunctions final {
 public:
  /// Without a path, where the system looks for libraries.
  explicit DhdFunctions(const std::filesystem::path& library = {});

  static constexpr int kTimeGuard = 1;       ///< asked too soon: what was read before, again
  static constexpr int kMotorSaturated = 2;  ///< done, but with less force than was asked for

  // What dhdGetStatus fills: 16 numbers, 17 in later versions. Room for more, should there be more.
  static constexpr int kStatusSize = 32;
  static constexpr int kStatusReset = 3;  ///< the device knows its zero
  static constexpr int kStatusForce = 5;
  static constexpr int kStatusForceOffCause = 14;

  /// "libdrd 3.17.5 in /usr/lib/libdrd.so".
  std::string description() const;
  /// " --library FILE" for a command that shall take the same one; empty where none was named.
  std::string library_option() const;
  /// Whether the library can move a device to find its zero.
  bool has_robotics() const noexcept { return drdAutoInit != nullptr; }

  int (*dhdGetDeviceCount)() = nullptr;
  int (*dhdGetAvailableCount)() = nullptr;     ///< null in old versions
  int (*dhdOpenID)(char index) = nullptr;      ///< of one that is open already: its ID again
  int (*dhdOpenSerial)(int serial) = nullptr;  ///< null in old versions; fails for old models
  int (*dhdClose)(char) = nullptr;
  int (*dhdStop)(char) = nullptr;
  int (*dhdEnableForce)(unsigned char, char) = nullptr;
  int (*dhdGetSystemType)(char) = nullptr;
  int (*dhdGetSerialNumber)(unsigned short*, char) = nullptr;
  void (*dhdGetSDKVersion)(int*, int*, int*, int*) = nullptr;
  int (*dhdGetStatus)(int*, char) = nullptr;
  int (*dhdGetPosition)(double*, double*, double*, char) = nullptr;
  int (*dhdGetPositionAndOrientationFrame)(double*, double*, double*, double (*)[3],
                                           char) = nullptr;
  unsigned int (*dhdGetButtonMask)(char) = nullptr;
  int (*dhdGetGripperAngleRad)(double*, char) = nullptr;  ///< null in old versions
  int (*dhdSetForceAndTorqueAndGripperForce)(double, double, double, double, double, double, double,
                                             char) = nullptr;
  const char* (*dhdErrorGetLastStr)() = nullptr;

  // Null without libdrd.
  int (*drdOpenID)(char index) = nullptr;
  int (*drdAutoInit)(char) = nullptr;
  int (*drdStop)(bool, char) = nullptr;
  int (*drdClose)(char) = nullptr;
  bool (*drdIsRunning)(char) = nullptr;  ///< its regulation; null in a version without it

 private:
  std::filesystem::path named_;
  VendorLibrary library_;
};

}  // namespace asperity
