// A program that drives a Falcon until it is killed, in the test bed that it was started in.

#include <chrono>
#include <thread>

#include "device/falcon/falcon_device.h"
#include "tests/device/victim.h"

int main() {
  asperity::die_at_once();
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
