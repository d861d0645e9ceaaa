// A stand-in for OpenHaptics' libHD: the same functions, answers and thread, without a device.

#include "tests/device/vendors/test_hd.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>

using asperity::test_hd::Bench;

namespace {

std::unique_ptr<Bench> the_bench = std::make_unique<Bench>();
std::thread scheduler;
std::atomic<bool> scheduler_ends{false};
bool is_in_frame = false;

struct Scheduled {
  unsigned int (*callback)(void*) = nullptr;
  void* argument = nullptr;
};
Scheduled scheduled;

constexpr unsigned int kHandle = 0;

void note(const std::string& call) {
  const std::lock_guard lock(the_bench->mutex);
  the_bench->calls.push_back(call);
  // For a program that a test starts.
  if (const char* file = std::getenv("ASPERITY_TEST_HD_CALLS")) {
    std::ofstream(file, std::ios::app) << call << '\n';
  }
}

// What the device receives, as another process sees it: a line for each change between zero and a force.
void note_at_wire(const double* force_N) {
  static std::string last;
  const char* file = std::getenv("ASPERITY_TEST_HD_CALLS");
  if (file == nullptr) return;
  const std::string now =
      force_N[0] == 0.0 && force_N[1] == 0.0 && force_N[2] == 0.0 ? "zero" : "force";
  if (std::exchange(last, now) != now) std::ofstream(file, std::ios::app) << now << '\n';
}

void run_scheduler() {
  while (!scheduler_ends) {
    the_bench->is_hanging = the_bench->hangs.load();
    Scheduled now;
    {
      const std::lock_guard lock(the_bench->mutex);
      now = scheduled;
    }
    if (!the_bench->hangs && now.callback != nullptr) {
      const unsigned int answer = now.callback(now.argument);
      const std::lock_guard lock(the_bench->mutex);
      if (answer == 0) scheduled = {};
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

void end_scheduler() {
  scheduler_ends = true;
  if (scheduler.joinable()) scheduler.join();
  scheduler_ends = false;
}

}  // namespace

extern "C" {

Bench* test_hd_bench() { return the_bench.get(); }
void test_hd_reset() {
  end_scheduler();
  scheduled = {};
  is_in_frame = false;
  the_bench = std::make_unique<Bench>();
}

struct TestHdError {
  unsigned int code;
  int internal_code;
  unsigned int device;
};

unsigned int hdInitDevice(const char* name) {
  note(std::string("hdInitDevice ") + (name == nullptr ? "default" : name));
  const std::lock_guard lock(the_bench->mutex);
  if (!the_bench->is_attached || (name != nullptr && std::strcmp(name, "Left Device") != 0)) {
    the_bench->errors.push_back(0x0302);
    return 0xFFFFFFFF;
  }
  return kHandle;
}
void hdDisableDevice(unsigned int) { note("hdDisableDevice"); }
void hdMakeCurrentDevice(unsigned int) { ++the_bench->made_current; }
TestHdError hdGetError() {
  const std::lock_guard lock(the_bench->mutex);
  if (the_bench->errors.empty()) return {0, 0, kHandle};
  const unsigned int code = the_bench->errors.back();
  the_bench->errors.pop_back();
  return {code, 0, kHandle};
}
const char* hdGetErrorString(unsigned int) { return "an error without a name"; }
void hdBeginFrame(unsigned int) {
  const std::lock_guard lock(the_bench->mutex);
  if (is_in_frame) ++the_bench->disorders;
  is_in_frame = true;
  if (!the_bench->is_attached) the_bench->errors.push_back(0x0302);
  if (the_bench->error_of_each_begin != 0) {
    the_bench->errors.push_back(the_bench->error_of_each_begin);
  }
}
void hdEndFrame(unsigned int) {
  const std::lock_guard lock(the_bench->mutex);
  if (!is_in_frame) ++the_bench->disorders;
  is_in_frame = false;
  if (the_bench->error_of_each_end != 0) the_bench->errors.push_back(the_bench->error_of_each_end);
  ++the_bench->frames;
}
void hdGetDoublev(unsigned int what, double* values) {
  const std::lock_guard lock(the_bench->mutex);
  switch (what) {
    case 0x2052:
      std::copy_n(the_bench->transform, 16, values);
      break;
    case 0x2551:
      std::copy_n(the_bench->workspace_mm, 6, values);
      break;
    case 0x2603:
      *values = the_bench->peak_force_N;
      break;
    case 0x2604:
      *values = 0.88;
      break;
    default:
      the_bench->errors.push_back(0x0100);
  }
}
void hdGetIntegerv(unsigned int what, int* values) {
  const std::lock_guard lock(the_bench->mutex);
  switch (what) {
    case 0x2000:
      *values = the_bench->buttons;
      break;
    case 0x2553:
      *values = 6;
      break;
    case 0x2554:
      *values = the_bench->actuated_degrees;
      break;
    case 0x2555:
      *values = 4;
      break;
    default:
      the_bench->errors.push_back(0x0100);
  }
}
const char* hdGetString(unsigned int what) { return what == 0x2504 ? "T-17" : "Touch"; }
void hdSetDoublev(unsigned int what, const double* values) {
  const std::lock_guard lock(the_bench->mutex);
  if (!is_in_frame) ++the_bench->disorders;
  if (what == 0x2700) {
    std::copy_n(values, 3, the_bench->force_N);
    note_at_wire(values);
    the_bench->strongest_N =
        std::max(the_bench->strongest_N, std::hypot(values[0], values[1], values[2]));
  } else if (what == 0x2701) {
    std::copy_n(values, 3, the_bench->torque);
  } else {
    the_bench->errors.push_back(0x0100);
  }
}
void hdEnable(unsigned int what) {
  note("hdEnable " + std::to_string(what));
  const std::lock_guard lock(the_bench->mutex);
  if (what == 0x4000) the_bench->gives_force = true;
}
void hdDisable(unsigned int what) {
  while (the_bench->hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  note("hdDisable " + std::to_string(what));
  const std::lock_guard lock(the_bench->mutex);
  if (what == 0x4000) the_bench->gives_force = false;
}
unsigned int hdCheckCalibration() {
  const std::lock_guard lock(the_bench->mutex);
  return the_bench->calibration;
}
void hdUpdateCalibration(unsigned int style) {
  note("hdUpdateCalibration " + std::to_string(style));
  const std::lock_guard lock(the_bench->mutex);
  if (the_bench->calibrates) the_bench->calibration = 0x5000;
}
void hdSetSchedulerRate(unsigned long rate_Hz) {
  const std::lock_guard lock(the_bench->mutex);
  if (rate_Hz > 1600) {
    the_bench->errors.push_back(0x0101);
  } else {
    the_bench->rate_Hz = rate_Hz;
  }
}
void hdStartScheduler() {
  note("hdStartScheduler");
  {
    const std::lock_guard lock(the_bench->mutex);
    if (the_bench->refuses_to_start) the_bench->errors.push_back(0x0304);
    if (the_bench->refuses_to_start || the_bench->never_calls) return;
  }
  if (!scheduler.joinable()) scheduler = std::thread(run_scheduler);
}
void hdStopScheduler() {
  note("hdStopScheduler");
  end_scheduler();
}
unsigned long hdScheduleAsynchronous(unsigned int (*callback)(void*), void* argument,
                                     unsigned short) {
  const std::lock_guard lock(the_bench->mutex);
  scheduled = {callback, argument};
  return 1;
}
#ifndef ASPERITY_TEST_HD_IS_OLD
void hdUnschedule(unsigned long) {
  note("hdUnschedule");
  const std::lock_guard lock(the_bench->mutex);
  scheduled = {};
}
#endif
}
