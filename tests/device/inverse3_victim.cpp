// A program that drives an Inverse3 until it is killed. Usage: asperity_inverse3_victim HOST:PORT

#include <chrono>
#include <thread>

#include "device/inverse3/inverse3_device.h"
#include "tests/device/victim.h"

int main(int count, char** arguments) {
  asperity::die_at_once();
  if (count != 2) return 2;
  asperity::Inverse3Device device(asperity::InverseServicePlace::of(arguments[1]), "049D");
  device.start_calls({.function =
                          [](void* pushed) noexcept {
                            auto& it = *static_cast<asperity::HapticDevice*>(pushed);
                            if (!it.read(0)) return;
                            it.push({.force_N = {0.0, 0.0, 1.0}}, 1e-3);
                          },
                      .argument = &device,
                      .rate_Hz = 1000.0});
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}
