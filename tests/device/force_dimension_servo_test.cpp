// A device of Force Dimension under the servo loop: a force that the device took away comes back as a new surface does.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "device/force_dimension/force_dimension_device.h"
#include "device/vendor_library.h"
#include "renderers/servo/servo_loop.h"
#include "tests/device/hanging_tick.h"
#include "tests/device/vendors/test_dhd.h"

namespace asperity {
namespace {

constexpr double kForce_N = 1.0;
constexpr double kRamp_s = 0.050;

// Outside of a surface for one tick, then in it for good.
class OneNewton final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override { ticks_ = 0; }
  RenderedTick tick(const ProbeState&, double) noexcept override {
    if (ticks_++ == 0) return {};
    return {.wrench = {.force_N = {0.0, 0.0, kForce_N}}, .penetration_m = 0.001};
  }

 private:
  int ticks_ = 0;
};

TEST(ForceDimensionUnderTheServo, RampsAForceThatWasOffForOneTick) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DRD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  test_dhd::Bench& bench = *bench_of();
  bench = test_dhd::Bench{};
  bench.units.push_back({.type = 33, .serial = 101});
  ForceDimensionDevice device(std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 0);
  RecordRing records(4096);
  ServoLoop loop(device, records, {.rate_Hz = 1000.0, .ramp_s = kRamp_s});
  loop.present({.id = 1, .renderer = std::make_unique<OneNewton>()});
  std::int64_t now_ns = 0;
  const auto sent_N = [&](int ticks) {  // the strongest, and the last
    double strongest_N = 0.0;
    for (int i = 0; i < ticks; ++i) {
      loop.heartbeat();
      loop.tick(now_ns += 1'000'000);
      strongest_N = std::max(strongest_N, std::abs(bench.units[0].sent[2]));
    }
    return strongest_N;
  };
  EXPECT_NEAR(sent_N(100), kForce_N, 1e-12);

  bench.units[0].force_is_on = false;
  bench.units[0].force_off_cause = 6;  // the hand was off the handle
  EXPECT_EQ(sent_N(1), 0.0);
  bench.units[0].force_is_on = true;
  EXPECT_EQ(sent_N(20), 0.0);  // until a person clears the fault
  EXPECT_EQ(loop.status().fault, Fault::device_lost);
  loop.clear_fault(loop.status().fault);
  const double each_tick_N = kForce_N * 1e-3 / kRamp_s;
  EXPECT_LE(sent_N(2), each_tick_N + 1e-12);
  EXPECT_LE(sent_N(25), 26.0 * each_tick_N + 1e-12);
  EXPECT_NEAR(sent_N(60), kForce_N, 1e-12);
}

TEST(ForceDimensionUnderTheServo, HasZeroForceWhileATickHangs) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DRD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  TestDhdLock lock_of = nullptr;
  library.find("test_dhd_lock", lock_of);
  const test_dhd::SharedBench bench(bench_of(), lock_of());
  *bench_of() = test_dhd::Bench{};
  bench->units.push_back({.type = 33, .serial = 101});
  ForceDimensionDevice device(std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 0);
  expect_zero_force_while_a_tick_hangs(device, [&bench] { return bench->units[0].sent[2] != 0.0; });
}

// The servo thread is in a call that does not return, and so is the thread that would send zero: only the watchdog of the
// manufacturer can switch the force off. The fault comes all the same, and zero once the SDK returns.
TEST(ForceDimensionUnderTheServo, KeepsItsForceWhereTheSdkHangsUntilItReturns) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DRD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  TestDhdLock lock_of = nullptr;
  library.find("test_dhd_lock", lock_of);
  const test_dhd::SharedBench bench(bench_of(), lock_of());
  *bench_of() = test_dhd::Bench{};
  bench->units.push_back({.type = 33, .serial = 101});
  ForceDimensionDevice device(std::make_shared<const DhdFunctions>(ASPERITY_TEST_DRD), 0);
  ServoSettings settings = patient_servo();
  settings.standstill_to_fault_s = ServoSettings{}.standstill_to_fault_s;
  RecordRing records(1 << 16);
  ServoLoop loop(device, records, settings);
  loop.present({.id = 1, .renderer = std::make_unique<OneNewton>()});
  const ServoThread thread(loop, device, Scheduling::normal);
  ASSERT_TRUE(eventually([&] {
    if (const Fault fault = loop.status().fault; fault != Fault::none) loop.clear_fault(fault);
    return bench->units[0].sent[2] != 0.0;
  }));
  {
    // Every function of the stand-in waits for it, as for a lock of the SDK.
    const test_dhd::SharedBench::Held hangs = bench.operator->();
    EXPECT_TRUE(eventually([&] { return loop.status().fault == Fault::standstill; }));
    EXPECT_FALSE(loop.progress().rendering);
    EXPECT_NE(hangs.bench->units[0].sent[2], 0.0);
  }
  EXPECT_TRUE(eventually([&] { return bench->units[0].sent[2] == 0.0; }));
}

}  // namespace
}  // namespace asperity
