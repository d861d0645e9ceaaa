// A stand-in for Force Dimension's SDK: the same functions and the same answers, without a device.

#include "tests/device/vendors/test_dhd.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>

using asperity::test_dhd::Bench;
using asperity::test_dhd::Unit;

namespace {

// For a program that a test starts: one unit with this serial number, which knows its zero or was switched off.
Bench bench_of_this_process() {
  Bench bench;
  if (const char* serial = std::getenv("ASPERITY_TEST_DHD_ATTACHED")) {
    bench.units.push_back({.serial = static_cast<unsigned short>(std::atoi(serial))});
  }
  if (const char* serial = std::getenv("ASPERITY_TEST_DHD_SWITCHED_OFF")) {
    bench.units.push_back({.serial = static_cast<unsigned short>(std::atoi(serial)),
                           .knows_its_zero = false,
                           .searches_on = std::getenv("ASPERITY_TEST_DHD_SEARCHES_ON") != nullptr});
  }
  if (const char* function = std::getenv("ASPERITY_TEST_DHD_BLOCKS")) bench.blocks = function;
  return bench;
}

Bench the_bench = bench_of_this_process();
std::recursive_mutex
    the_lock;  // of everything here: a driver looks for a lost device in a thread of its own

std::condition_variable_any stopped;  // under `the_lock`

int failed(const char* reason) {
  the_bench.last_error = reason;
  return -1;
}

// Which one is opened is said by its place in the list; from then on by an ID, which is another number.
char id_at(std::size_t index) { return static_cast<char>(3 + 2 * index); }

Unit* unit_at(std::size_t index) {
  if (!the_bench.is_there) {
    failed("device disconnected");
    return nullptr;
  }
  if (index >= the_bench.units.size()) {
    failed("no such device");
    return nullptr;
  }
  return &the_bench.units[index];
}

Unit* unit_of(char id) {
  for (std::size_t index = 0; index < the_bench.units.size(); ++index) {
    if (id_at(index) != id) continue;
    Unit* unit = unit_at(index);
    if (unit == nullptr || unit->is_open) return unit;
    break;
  }
  failed("no open device has this ID");
  return nullptr;
}

int opened_at(char index) {
  Unit* unit = index < 0 ? nullptr : unit_at(static_cast<std::size_t>(index));
  if (unit == nullptr) return -1;
  if (!unit->is_open) {
    unit->is_open = true;
    unit->is_stopped = false;
  }
  return id_at(static_cast<std::size_t>(index));
}

void note(const char* function, char id) {
  the_bench.calls.push_back(std::string(function) + " " + std::to_string(static_cast<int>(id)));
  if (const char* file = std::getenv("ASPERITY_TEST_DHD_CALLS")) {
    std::ofstream(file, std::ios::app) << the_bench.calls.back() << '\n';
  }
}

#ifndef ASPERITY_TEST_DHD_IS_OLD
// What a unit receives, as another process sees it: a line for each change between zero and a force.
void note_at_wire(const double (&sent)[7]) {
  static std::string last;
  const char* file = std::getenv("ASPERITY_TEST_DHD_WIRE");
  if (file == nullptr) return;
  const bool is_zero = std::all_of(sent, sent + 7, [](double each) { return each == 0.0; });
  const std::string now = is_zero ? "zero" : "force";
  if (now == last) return;
  last = now;
  std::ofstream(file, std::ios::app) << now << '\n';
}
#endif

// A library waits for its threads when a program ends in order.
struct EndOfProcess {
  int blocked_calls = 0;  // under `the_lock`
  ~EndOfProcess() {
    std::unique_lock held(the_lock);
    while (blocked_calls > 0) stopped.wait_for(held, std::chrono::milliseconds(1));
  }
} end_of_process;

void wait_while_blocked(std::unique_lock<std::recursive_mutex>& held, const char* function) {
  ++end_of_process.blocked_calls;
  while (the_bench.blocks == function) stopped.wait_for(held, std::chrono::milliseconds(1));
  --end_of_process.blocked_calls;
}

#ifndef ASPERITY_TEST_DHD_WITHOUT_DRD
// Moves until neither its force nor its regulation is on, axis by axis; then it takes the arm a while to come to rest.
int searched_on(char id) {
  std::unique_lock held(the_lock);
  for (;;) {
    Unit* unit = unit_of(id);
    if (unit == nullptr) return -1;
    unit->force_is_on = true;
    unit->regulation_is_on = true;
    stopped.wait(held, [id] {
      const Unit* it = unit_of(id);
      return it == nullptr || (!it->force_is_on && !it->regulation_is_on);
    });
    ++the_bench.stops_heard;
    if (the_bench.axes_to_search-- <= 0) break;
  }
  held.unlock();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  held.lock();
  note("at rest", id);
  return failed("it was stopped");
}
#endif

}  // namespace

extern "C" {

Bench* test_dhd_bench() { return &the_bench; }
std::recursive_mutex* test_dhd_lock() { return &the_lock; }

int dhdGetDeviceCount() {
  const std::lock_guard held(the_lock);
  return the_bench.is_there ? static_cast<int>(the_bench.units.size()) : 0;
}
int dhdGetAvailableCount() {
  const std::lock_guard held(the_lock);
  // What this program itself has open counts as available.
  return dhdGetDeviceCount() - the_bench.in_use_elsewhere;
}
int dhdOpenID(char index) {
  const std::lock_guard held(the_lock);
  note("dhdOpenID", index);
  return opened_at(index);
}
int dhdOpenSerial(int serial) {
  const std::lock_guard held(the_lock);
  for (std::size_t index = 0; index < the_bench.units.size(); ++index) {
    if (the_bench.units[index].serial != serial || !the_bench.opens_by_serial) continue;
    note("dhdOpenSerial", static_cast<char>(index));
    return opened_at(static_cast<char>(index));
  }
  return failed("no device has this serial number");
}
int dhdClose(char id) {
  std::unique_lock held(the_lock);
  note("dhdClose", id);
  wait_while_blocked(held, "dhdClose");
  Unit* unit = unit_of(id);
  // What is closed after its cable was pulled is closed.
  for (std::size_t index = 0; index < the_bench.units.size(); ++index) {
    if (id_at(index) == id) the_bench.units[index].is_open = false;
  }
  return unit == nullptr ? -1 : 0;
}
int dhdStop(char id) {
  std::unique_lock held(the_lock);
  note("dhdStop", id);
  wait_while_blocked(held, "dhdStop");
  Unit* unit = unit_of(id);
  if (unit == nullptr) return -1;
  unit->is_stopped = true;
  unit->force_is_on = false;
  stopped.notify_all();
  return 0;
}
int dhdEnableForce(unsigned char, char id) {
  const std::lock_guard held(the_lock);
  Unit* unit = unit_of(id);
  if (unit == nullptr) return -1;
  if (the_bench.enable_answer < 0) return failed("it has no power");
  for (const double one : unit->sent) {
    unit->was_enabled_with_force = unit->was_enabled_with_force || one != 0.0;
  }
  unit->force_is_on = true;
  return 0;
}
int dhdGetSystemType(char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  return unit == nullptr ? -1 : unit->type;
}
int dhdGetSerialNumber(unsigned short* serial, char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  if (unit == nullptr) return -1;
  *serial = unit->serial;
  return 0;
}
void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = 3;
  *minor = 17;
  *release = 5;
  *revision = 0;
}
int dhdGetStatus(int* status, char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  if (unit == nullptr) return -1;
  for (int i = 0; i < 17; ++i) status[i] = 0;
  status[0] = 1;
  status[3] = unit->knows_its_zero ? 1 : 0;
  status[5] = unit->force_is_on ? 1 : 0;
  status[14] = unit->force_off_cause;
  return 0;
}
int dhdGetPosition(double* x, double* y, double* z, char id) {
  std::unique_lock held(the_lock);
  wait_while_blocked(held, "dhdGetPosition");
  const Unit* unit = unit_of(id);
  if (unit == nullptr || the_bench.read_answer < 0) return -1;
  *x = unit->position_m[0];
  *y = unit->position_m[1];
  *z = unit->position_m[2];
  return the_bench.read_answer;
}
int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double frame[3][3],
                                      char id) {
  const std::lock_guard held(the_lock);
  const int answer = dhdGetPosition(x, y, z, id);
  if (answer < 0) return answer;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) frame[i][j] = unit_of(id)->frame[i][j];
  }
  return answer;
}
unsigned int dhdGetButtonMask(char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  return unit == nullptr ? 0 : unit->buttons;
}
#ifndef ASPERITY_TEST_DHD_WITHOUT_DRD
int dhdGetGripperAngleRad(double* angle_rad, char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  if (unit == nullptr) return -1;
  *angle_rad = unit->gripper_rad;
  return 0;
}
#endif
#ifndef ASPERITY_TEST_DHD_IS_OLD
int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty,
                                        double tz, double gripper, char id) {
  const std::lock_guard held(the_lock);
  Unit* unit = unit_of(id);
  if (unit == nullptr || the_bench.send_answer < 0) return -1;
  const double sent[7] = {fx, fy, fz, tx, ty, tz, gripper};
  for (int i = 0; i < 7; ++i) unit->sent[i] = sent[i];
  note_at_wire(sent);
  return the_bench.send_answer;
}
#endif
const char* dhdErrorGetLastStr() {
  const std::lock_guard held(the_lock);
  return the_bench.last_error;
}

#ifndef ASPERITY_TEST_DHD_WITHOUT_DRD
int drdOpenID(char index) {
  const std::lock_guard held(the_lock);
  note("drdOpenID", index);
  return opened_at(index);
}
int drdAutoInit(char id) {
  {
    const std::lock_guard held(the_lock);
    note("drdAutoInit", id);
    Unit* unit = unit_of(id);
    if (unit == nullptr) return -1;
    if (!unit->finds_its_zero) return failed("the handle was held");
    unit->knows_its_zero = !unit->searches_on;
    if (unit->knows_its_zero) return 0;
  }
  return searched_on(id);
}
int drdStop(bool leaves_force_on, char id) {
  std::unique_lock held(the_lock);
  note(leaves_force_on ? "drdStop with force" : "drdStop", id);
  wait_while_blocked(held, "drdStop");
  if (!leaves_force_on) {
    if (Unit* unit = unit_of(id)) unit->regulation_is_on = false;
    stopped.notify_all();
  }
  return the_bench.stop_answer < 0 ? failed("the regulation goes on") : 0;
}
bool drdIsRunning(char id) {
  const std::lock_guard held(the_lock);
  const Unit* unit = unit_of(id);
  return the_bench.goes_on || (unit != nullptr && unit->regulation_is_on);
}
int drdClose(char id) {
  const std::lock_guard held(the_lock);
  note("drdClose", id);
  return dhdClose(id);
}
#endif
}
