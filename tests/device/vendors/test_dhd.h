// What tests arrange and see of the stand-in for Force Dimension's SDK.

#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace asperity::test_dhd {

struct Unit {
  int type = 33;
  unsigned short serial = 0;
  bool knows_its_zero = true;
  bool finds_its_zero = true;
  bool searches_on = false;  ///< drdAutoInit moves it until it is stopped
  bool is_open = false;
  bool is_stopped = false;
  double position_m[3] = {0.0, 0.0, 0.0};
  double frame[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  unsigned int buttons = 0;
  double gripper_rad = 0.5;                              ///< open
  double sent[7] = {9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0};  ///< force, torque, gripper
  bool force_is_on = false;
  bool regulation_is_on = false;
  int force_off_cause = 0;
  bool was_enabled_with_force = false;  ///< with anything but zero to give
};

struct Bench {
  std::vector<Unit> units{};
  int in_use_elsewhere = 0;     ///< by other programs
  bool opens_by_serial = true;  ///< recent models do
  bool is_there = true;  ///< false: every call for a device fails, as after its cable was pulled
  int read_answer = 0;
  int send_answer = 0;
  int stop_answer = 0;   ///< of drdStop
  bool goes_on = false;  ///< drdIsRunning says so, whatever was stopped
  /// Does not return while this names it: dhdGetPosition, dhdStop, dhdClose or drdStop. Nor does the end of the
  /// process meanwhile.
  std::string blocks{};
  /// So many more times drdAutoInit goes on with its next axis, force on, after it was stopped.
  int axes_to_search = 0;
  int stops_heard = 0;    ///< by a drdAutoInit under way, of both functions
  int enable_answer = 0;  ///< of dhdEnableForce
  const char* last_error = "no error";
  std::vector<std::string> calls{};  ///< those that open, move, close
};

/// The bench while a driver's own thread may be at it: held from `->` to the end of the expression.
class SharedBench final {
 public:
  struct Held {
    std::unique_lock<std::recursive_mutex> lock;
    Bench* bench = nullptr;
    Bench* operator->() const noexcept { return bench; }
  };

  SharedBench() = default;
  SharedBench(Bench* bench, std::recursive_mutex* lock) : bench_(bench), lock_(lock) {}
  Held operator->() const { return {std::unique_lock(*lock_), bench_}; }

 private:
  Bench* bench_ = nullptr;
  std::recursive_mutex* lock_ = nullptr;
};

}  // namespace asperity::test_dhd

// Exported by the stand-in.
using TestDhdBench = asperity::test_dhd::Bench* (*)();
using TestDhdLock = std::recursive_mutex* (*)();
