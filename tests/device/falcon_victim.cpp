// A program that drives a Falcon until it is killed, in the test bed that it was started in.

#include <chrono>
#include <csignal>
#include <sys/resource.h>
#include <thread>

#include "device/falcon/falcon_device.h"

int main() {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // A sanitizer's handler takes so long to tell of the signal that the driver has time for its zero.
  for (const int signal : {SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);
  asperity::FalconSettings settings{};
  settings.line.place = "usb 1-2";
  settings.line.wants_fifo = false;
  const auto device = asperity::FalconDevice::open(settings);
  for (;;) {
    device->read(0);
    device->push({.force_N = {0.0, 0.0, 1.0}}, 1e-3);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}
