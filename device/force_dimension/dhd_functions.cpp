// The functions of Force Dimension's SDK that we use.

#include "device/force_dimension/dhd_functions.h"

#include <vector>

namespace asperity {
namespace {

std::vector<std::filesystem::path> dhd_library_names(const std::filesystem::path& library) {
  if (!library.empty()) return {library};
  return {"libdrd.so", "libdrd.so.3", "libdhd.so", "libdhd.so.3"};
}

}  // namespace

DhdFunctions::DhdFunctions(const std::filesystem::path& library)
    : named_(library), library_("Force Dimension's SDK", dhd_library_names(library)) {
  library_.find("dhdGetDeviceCount", dhdGetDeviceCount);
  library_.find_if_there("dhdGetAvailableCount", dhdGetAvailableCount);
  library_.find("dhdOpenID", dhdOpenID);
  library_.find_if_there("dhdOpenSerial", dhdOpenSerial);
  library_.find("dhdClose", dhdClose);
  library_.find("dhdStop", dhdStop);
  library_.find("dhdEnableForce", dhdEnableForce);
  library_.find("dhdGetSystemType", dhdGetSystemType);
  library_.find("dhdGetSerialNumber", dhdGetSerialNumber);
  library_.find("dhdGetSDKVersion", dhdGetSDKVersion);
  library_.find("dhdGetStatus", dhdGetStatus);
  library_.find("dhdGetPosition", dhdGetPosition);
  library_.find("dhdGetPositionAndOrientationFrame", dhdGetPositionAndOrientationFrame);
  library_.find("dhdGetButtonMask", dhdGetButtonMask);
  library_.find_if_there("dhdGetGripperAngleRad", dhdGetGripperAngleRad);
  library_.find("dhdSetForceAndTorqueAndGripperForce", dhdSetForceAndTorqueAndGripperForce);
  library_.find("dhdErrorGetLastStr", dhdErrorGetLastStr);

  library_.find_if_there("drdAutoInit", drdAutoInit);
  if (has_robotics()) {
    library_.find("drdOpenID", drdOpenID);
    library_.find("drdStop", drdStop);
    library_.find("drdClose", drdClose);
    library_.find_if_there("drdIsRunning", drdIsRunning);
  }
}

std::string DhdFunctions::library_option() const {
  return named_.empty() ? "" : " --library " + named_.string();
}

std::string DhdFunctions::description() const {
  int major = 0;
  int minor = 0;
  int release = 0;
  int revision = 0;
  dhdGetSDKVersion(&major, &minor, &release, &revision);
  return std::string(has_robotics() ? "libdrd " : "libdhd ") + std::to_string(major) + "." +
         std::to_string(minor) + "." + std::to_string(release) + " in " + library_.file().string();
}

}  // namespace asperity
