// The functions of OpenHaptics' libHD that we use, as its documentation gives them.

#pragma once

#include <filesystem>
#include <string>

#include "device/vendor_library.h"

namespace asperity {

/// libHD of 3D Systems' OpenHaptics, loaded. The fields are named as the functions are, so that they can be held
/// against its own pages. It works on the device that is current (hdMakeCurrentDevice) and keeps errors on a
/// stack, from which hdGetError takes the latest. Frame: x to the right, y up, z towards the participant;
/// millimetres, newtons, newton millimetres.
///
/// Errors: the constructor's are VendorLibrary's.
class HdFunctions final {
 public:
  /// Without a path, where the system looks for libraries.
  explicit HdFunctions(const std::filesystem::path& library = {});

  struct Error {
    unsigned int code = 0;  ///< 0: none
    int internal_code = 0;
    unsigned int device = 0;
  };
  using Callback = unsigned int (*)(void*);

  static constexpr unsigned int kNoDevice = 0xFFFFFFFF;
  static constexpr unsigned int kDone = 0;      // what a callback returns
  static constexpr unsigned int kContinue = 1;  // likewise
  static constexpr unsigned short kUsualPriority = 0x7FFF;

  // What is asked for and set.
  static constexpr unsigned int kButtons = 0x2000;
  static constexpr unsigned int kTransform = 0x2052;  ///< 16 numbers, column after column
  static constexpr unsigned int kModel = 0x2501;
  static constexpr unsigned int kDriverVersion = 0x2502;
  static constexpr unsigned int kSerial = 0x2504;
  static constexpr unsigned int kUsableWorkspace = 0x2551;  ///< minimum, maximum: 6 numbers
  static constexpr unsigned int kSensedDegrees = 0x2553;
  static constexpr unsigned int kActuatedDegrees = 0x2554;
  static constexpr unsigned int kCalibrationStyle = 0x2555;
  static constexpr unsigned int kPeakForce = 0x2603;
  static constexpr unsigned int kContinuousForce = 0x2604;
  static constexpr unsigned int kForce = 0x2700;
  static constexpr unsigned int kTorque = 0x2701;
  static constexpr unsigned int kForceOutput = 0x4000;
  static constexpr unsigned int kForceClamping = 0x4001;
  // Answers of hdCheckCalibration, and bits of kCalibrationStyle.
  static constexpr unsigned int kCalibrated = 0x5000;
  static constexpr unsigned int kNeedsUpdate = 0x5001;
  static constexpr unsigned int kNeedsHand = 0x5002;
  static constexpr unsigned int kByItself = 2;
  static constexpr unsigned int kInInkwell = 4;

  /// Nothing, one about the force (warm motors, too strong), or one of the device itself (fault, no answer).
  static constexpr bool is_about_force(unsigned int code) { return (code & 0xFF00U) == 0x0200U; }
  static constexpr bool is_of_device(unsigned int code) { return (code & 0xFF00U) == 0x0300U; }

  /// The gravest error since the last call, with which the stack is emptied: one of the device before one about
  /// the force before any other; the latest of equals.
  Error take_errors() const noexcept;
  /// "HD_WARM_MOTORS (its motors are warm: let them cool)", or what the library calls it.
  std::string name_of(const Error& error) const;
  const std::filesystem::path& file() const noexcept { return library_.file(); }

  unsigned int (*hdInitDevice)(const char*) = nullptr;  ///< null: the one configured as default
  void (*hdDisableDevice)(unsigned int) = nullptr;
  void (*hdMakeCurrentDevice)(unsigned int) = nullptr;
  Error (*hdGetError)() = nullptr;
  const char* (*hdGetErrorString)(unsigned int) = nullptr;
  void (*hdBeginFrame)(unsigned int) = nullptr;
  void (*hdEndFrame)(unsigned int) = nullptr;
  void (*hdGetDoublev)(unsigned int, double*) = nullptr;
  void (*hdGetIntegerv)(unsigned int, int*) = nullptr;
  const char* (*hdGetString)(unsigned int) = nullptr;
  void (*hdSetDoublev)(unsigned int, const double*) = nullptr;
  void (*hdEnable)(unsigned int) = nullptr;
  void (*hdDisable)(unsigned int) = nullptr;
  unsigned int (*hdCheckCalibration)() = nullptr;
  void (*hdUpdateCalibration)(unsigned int) = nullptr;
  void (*hdSetSchedulerRate)(unsigned long) = nullptr;
  void (*hdStartScheduler)() = nullptr;
  void (*hdStopScheduler)() = nullptr;
  unsigned long (*hdScheduleAsynchronous)(Callback, void*, unsigned short) = nullptr;
  void (*hdUnschedule)(unsigned long) = nullptr;

 private:
  VendorLibrary library_;
};

}  // namespace asperity
