// The functions of OpenHaptics' libHD that we use.

#include "device/openhaptics/hd_functions.h"

#include <vector>

namespace asperity {
namespace {

std::vector<std::filesystem::path> hd_library_names(const std::filesystem::path& library) {
  if (!library.empty()) return {library};
  return {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"};
}

// More than any one call leaves behind; an endless stack must not hold up a tick.
constexpr int kMostErrors = 16;

}  // namespace

HdFunctions::HdFunctions(const std::filesystem::path& library)
    : library_("3D Systems' OpenHaptics", hd_library_names(library)) {
  library_.find("hdInitDevice", hdInitDevice);
  library_.find("hdDisableDevice", hdDisableDevice);
  library_.find("hdMakeCurrentDevice", hdMakeCurrentDevice);
  library_.find("hdGetError", hdGetError);
  library_.find("hdGetErrorString", hdGetErrorString);
  library_.find("hdBeginFrame", hdBeginFrame);
  library_.find("hdEndFrame", hdEndFrame);
  library_.find("hdGetDoublev", hdGetDoublev);
  library_.find("hdGetIntegerv", hdGetIntegerv);
  library_.find("hdGetString", hdGetString);
  library_.find("hdSetDoublev", hdSetDoublev);
  library_.find("hdEnable", hdEnable);
  library_.find("hdDisable", hdDisable);
  library_.find("hdCheckCalibration", hdCheckCalibration);
  library_.find("hdUpdateCalibration", hdUpdateCalibration);
  library_.find("hdSetSchedulerRate", hdSetSchedulerRate);
  library_.find("hdStartScheduler", hdStartScheduler);
  library_.find("hdStopScheduler", hdStopScheduler);
  library_.find("hdScheduleAsynchronous", hdScheduleAsynchronous);
  library_.find("hdUnschedule", hdUnschedule);
}

HdFunctions::Error HdFunctions::take_errors() const noexcept {
  const auto gravity = [](const Error& error) {
    if (error.code == 0) return 0;
    if (is_of_device(error.code)) return 3;
    return is_about_force(error.code) ? 2 : 1;
  };
  Error gravest = hdGetError();
  Error next = gravest;
  for (int i = 0; i < kMostErrors && next.code != 0; ++i) {
    next = hdGetError();
    if (gravity(next) > gravity(gravest)) gravest = next;
  }
  return gravest;
}

std::string HdFunctions::name_of(const Error& error) const {
  switch (error.code) {
    case 0x0200:
      return "HD_WARM_MOTORS (its motors are warm: let them cool)";
    case 0x0201:
      return "HD_EXCEEDED_MAX_FORCE (more force was requested than it can exert: lower "
             "force_limit_N of the protocol)";
    case 0x0202:
      return "HD_EXCEEDED_MAX_FORCE_IMPULSE (the force changed too fast for it: lower the "
             "stiffness or the amplitude of the texture)";
    case 0x0203:
      return "HD_EXCEEDED_MAX_VELOCITY (it was moved too fast: move it more slowly)";
    case 0x0204:
      return "HD_FORCE_ERROR (its force failed: check its power and its cable)";
    case 0x0300:
      return "HD_DEVICE_FAULT (the device reports a fault: switch it off and on)";
    case 0x0301:
      return "HD_DEVICE_ALREADY_INITIATED (another session or program uses it: end that one first)";
    case 0x0302:
      return "HD_COMM_ERROR (it does not respond: check its power and its cable)";
    case 0x0304:
      return "HD_TIMER_ERROR (its clock failed: open the device again)";
    default: {
      const char* words = hdGetErrorString(error.code);
      return words == nullptr ? "error " + std::to_string(error.code) : words;
    }
  }
}

}  // namespace asperity
