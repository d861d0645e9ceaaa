// A tick that does not return, on a device at whose wire a test looks.

#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "device/haptic_device.h"
#include "renderers/servo/servo_thread.h"
#include "tests/support/eventually.h"
#include "tests/support/hanging_push.h"
#include "tests/support/patient_servo.h"

namespace asperity {

/// Expects that a force that the wire carries (`is_pushed`) is gone within a second after a tick began that does not return,
/// that the fault `standstill` came first, and that the device can be pushed again once the tick has returned and the
/// fault is cleared.
template <typename IsPushed>
void expect_zero_force_while_a_tick_hangs(HapticDevice& device, const IsPushed& is_pushed) {
  // A busy machine may stop the threads at any time: only the watch over the ticks is not patient.
  ServoSettings settings = patient_servo();
  settings.standstill_to_fault_s = ServoSettings{}.standstill_to_fault_s;
  settings.silence_to_fault_s = 1e6;
  const auto hang = std::make_shared<Hang>();
  RecordRing ring(1 << 16);
  ServoLoop loop(device, ring, settings);
  loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
  const ServoThread thread(loop, device, Scheduling::normal);
  const HangEnds at_the_end(hang);  // before the thread is waited for
  const auto is_pushed_again = [&] {
    if (const Fault fault = loop.status().fault; fault != Fault::none) loop.clear_fault(fault);
    return is_pushed();
  };
  ASSERT_TRUE(eventually(is_pushed_again));

  hang->is_wanted = true;
  ASSERT_TRUE(eventually([&] { return hang->is_under_way.load(); }));
  const auto began = std::chrono::steady_clock::now();
  const TickProgress hanging = loop.progress();
  EXPECT_TRUE(hanging.rendering);
  ASSERT_TRUE(eventually([&] { return !is_pushed(); }));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(1));
  EXPECT_EQ(loop.status().fault, Fault::standstill);
  EXPECT_TRUE(loop.progress().hangs_since(hanging));

  hang->is_wanted = false;
  EXPECT_TRUE(eventually(is_pushed_again));
}

}  // namespace asperity
