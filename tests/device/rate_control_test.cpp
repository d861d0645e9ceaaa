// A probe driven by a deflected cap, against closed forms.

#include "device/spacemouse/rate_control.h"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity::spacemouse {
namespace {

constexpr RateControlSettings kSettings{.full_speed_m_per_s = 0.1,
                                        .full_turn_rad_per_s = 1.0,
                                        .dead_zone = 0.05,
                                        .workspace_minimum_m = {-0.1, -0.1, -0.01},
                                        .workspace_maximum_m = {0.1, 0.1, 0.05},
                                        .home_m = {0.0, 0.0, 0.02}};

class ARate : public testing::Test {
 protected:
  // The cap as it is told from now on, every 8 ms.
  void deflect(const glm::dvec3& push, const glm::dvec3& turn = glm::dvec3(0.0),
               std::uint32_t buttons = 0) {
    cap_ = {.push = push, .turn = turn, .buttons = buttons};
    rate_.take({.cap = cap_, .moved_ns = now_ns_});
  }
  void run_ms(int duration_ms) {
    for (int i = 0; i < duration_ms; ++i) {
      now_ns_ += kMillisecond_ns;
      rate_.advance(now_ns_);
      if (++ticks_ % 8 == 0) rate_.take({.cap = cap_, .moved_ns = now_ns_});
    }
  }
  void SetUp() override { rate_.advance(now_ns_); }

  RateControl rate_{kSettings};
  Cap cap_{};
  std::int64_t now_ns_ = 5'000'000'000;
  int ticks_ = 0;
};

// 0.1 m/s for 0.7 s.
TEST_F(ARate, IsFullSpeedAtFullDeflectionAlongEachAxis) {
  deflect({1.0, 0.0, 0.0});
  run_ms(700);
  EXPECT_NEAR(rate_.position_m().x, 0.07, 1e-12);
  EXPECT_EQ(rate_.position_m().y, 0.0);
  EXPECT_EQ(rate_.position_m().z, 0.02);
  EXPECT_EQ(rate_.velocity_m_per_s(), glm::dvec3(0.1, 0.0, 0.0));
  deflect({0.0, -1.0, 0.0});
  run_ms(500);
  EXPECT_NEAR(rate_.position_m().y, -0.05, 1e-12);
  EXPECT_NEAR(rate_.position_m().x, 0.07, 1e-12);
}

// Halfway between the dead zone of 0.05 and full, s = 1/2 and the rate a quarter: at d = 0.525.
TEST_F(ARate, GrowsWithTheSquareBeyondTheDeadZone) {
  deflect({0.525, -0.525, 0.0}, {0.0, 0.0, -0.525});
  EXPECT_NEAR(rate_.velocity_m_per_s().x, 0.025, 1e-15);
  EXPECT_NEAR(rate_.velocity_m_per_s().y, -0.025, 1e-15);
  EXPECT_NEAR(rate_.angular_velocity_rad_per_s().z, -0.25, 1e-15);
  // A third of the way: a ninth of it.
  deflect({0.05 + 0.95 / 3.0, 0.0, 0.0});
  EXPECT_NEAR(rate_.velocity_m_per_s().x, 0.1 / 9.0, 1e-15);
}

TEST_F(ARate, IsNothingWithinTheDeadZoneOfEachAxisByItself) {
  deflect({0.05, -0.049, 1.0}, {0.05, 0.05, -0.05});
  run_ms(100);
  EXPECT_EQ(rate_.position_m().x, 0.0);
  EXPECT_EQ(rate_.position_m().y, 0.0);
  EXPECT_NEAR(rate_.position_m().z, 0.03, 1e-12);
  EXPECT_EQ(rate_.orientation(), glm::dquat(1.0, 0.0, 0.0, 0.0));
}

// 0.8 s of one radian per second about the axis (1, 1, 0)/√2, in steps: cos and sin of half the angle.
TEST_F(ARate, TurnsAboutTheAxisOfTheTurn) {
  const double side = 1.0 / std::sqrt(2.0);
  // r = s² of each axis is to be side: s = side^(1/2).
  const double deflection = 0.05 + 0.95 * std::sqrt(side);
  deflect(glm::dvec3(0.0), {deflection, deflection, 0.0});
  EXPECT_NEAR(glm::length(rate_.angular_velocity_rad_per_s()), 1.0, 1e-15);
  run_ms(800);
  const glm::dquat& turned = rate_.orientation();
  EXPECT_NEAR(turned.w, std::cos(0.4), 1e-12);
  EXPECT_NEAR(turned.x, side * std::sin(0.4), 1e-12);
  EXPECT_NEAR(turned.y, side * std::sin(0.4), 1e-12);
  EXPECT_NEAR(turned.z, 0.0, 1e-12);
}

// A quarter turn about x, then one about z of the room: x̂ → ŷ, ŷ → ẑ, ẑ → x̂, wherever the probe was turned to before.
TEST_F(ARate, TurnsAboutTheAxesOfTheRoom) {
  const double quarter_s = 1.5707963267948966;
  const auto turn = [&](const glm::dvec3& about) {
    deflect(glm::dvec3(0.0), about);
    run_ms(1570);
    now_ns_ += std::llround(1e9 * (quarter_s - 1.570));
    rate_.advance(now_ns_);
  };
  turn({1.0, 0.0, 0.0});
  turn({0.0, 0.0, 1.0});
  EXPECT_LT(glm::distance(rate_.orientation() * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)), 1e-8);
  EXPECT_LT(glm::distance(rate_.orientation() * glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)), 1e-8);
  EXPECT_LT(glm::distance(rate_.orientation() * glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)), 1e-8);
}

TEST_F(ARate, EndsAtTheFacesAndLeavesThemAtOnce) {
  deflect({1.0, 0.0, -1.0});
  run_ms(5000);
  EXPECT_EQ(rate_.position_m(), glm::dvec3(0.1, 0.0, -0.01));
  EXPECT_EQ(rate_.velocity_m_per_s(), glm::dvec3(0.0));  // it goes nowhere, and says so
  deflect({-1.0, 0.0, 1.0});
  EXPECT_EQ(rate_.velocity_m_per_s(), glm::dvec3(-0.1, 0.0, 0.1));
  run_ms(10);
  EXPECT_NEAR(rate_.position_m().x, 0.099, 1e-12);
  EXPECT_NEAR(rate_.position_m().z, -0.009, 1e-12);
}

// What is told is what is gone: the sum of velocities is the way, whatever the cap does.
TEST_F(ARate, HasTheVelocityOfItsPath) {
  glm::dvec3 way_m{0.0};
  for (int i = 0; i < 400; ++i) {
    deflect({std::sin(0.05 * i), std::cos(0.03 * i), std::sin(0.11 * i)});
    way_m += 1e-3 * rate_.velocity_m_per_s();
    run_ms(1);
  }
  EXPECT_GT(glm::length(way_m), 1e-3);
  EXPECT_LT(glm::distance(rate_.position_m() - kSettings.home_m, way_m), 1e-12);
}

TEST_F(ARate, DoesNotDependOnWhenItIsRead) {
  deflect({0.7, 0.3, 0.0}, {0.0, 0.2, 0.9});
  RateControl other(kSettings);
  other.advance(now_ns_);
  other.take({.cap = cap_, .moved_ns = now_ns_});
  for (const int step_ms : {1, 7, 2, 20, 10}) other.advance(now_ns_ += step_ms * kMillisecond_ns);
  rate_.advance(now_ns_);
  EXPECT_LT(glm::distance(rate_.position_m(), other.position_m()), 1e-15);
  EXPECT_NEAR(std::abs(glm::dot(rate_.orientation(), other.orientation())), 1.0, 1e-15);
}

// 50 ms at 0.1 m/s are 5 mm; whoever reads 2 s later finds no more.
TEST_F(ARate, GoesNoFartherThanAReportHolds) {
  deflect({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  EXPECT_FALSE(rate_.is_overdue(now_ns_ + 50 * kMillisecond_ns));
  EXPECT_TRUE(rate_.is_overdue(now_ns_ + 50 * kMillisecond_ns + 1));
  now_ns_ += 2000 * kMillisecond_ns;
  rate_.advance(now_ns_);
  EXPECT_NEAR(rate_.position_m().x, 0.005, 1e-12);
  EXPECT_NEAR(rate_.orientation().y, std::sin(0.025), 1e-12);
  rate_.advance(now_ns_ + kMillisecond_ns);
  EXPECT_NEAR(rate_.position_m().x, 0.005, 1e-12);
}

TEST_F(ARate, IsNotOverdueAtRest) {
  deflect({0.04, 0.0, 0.0}, {0.0, 0.0, -0.05});
  EXPECT_FALSE(rate_.is_overdue(now_ns_ + 3'600'000'000'000));
  deflect({0.06, 0.0, 0.0});
  EXPECT_TRUE(rate_.is_overdue(now_ns_ + 51 * kMillisecond_ns));
}

TEST_F(ARate, IsNothingFromAStopToTheNextReport) {
  deflect({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
  run_ms(7);
  rate_.stop();
  EXPECT_EQ(rate_.velocity_m_per_s(), glm::dvec3(0.0));
  EXPECT_EQ(rate_.angular_velocity_rad_per_s(), glm::dvec3(0.0));
  const glm::dvec3 stopped_m = rate_.position_m();
  rate_.advance(now_ns_ + 30 * kMillisecond_ns);
  EXPECT_EQ(rate_.position_m(), stopped_m);
}

TEST_F(ARate, StandsStillWhileTimeGoesBack) {
  deflect({1.0, 0.0, 0.0});
  run_ms(10);
  const glm::dvec3 before_m = rate_.position_m();
  rate_.advance(now_ns_ - 5 * kMillisecond_ns);
  EXPECT_EQ(rate_.position_m(), before_m);
  rate_.advance(now_ns_ + 1 * kMillisecond_ns);
  EXPECT_NEAR(rate_.position_m().x, before_m.x + 0.0001, 1e-12);
}

// From (30, −40, 20) mm it is 50 mm home, half a second; the turn of 0.2 rad takes 0.2 s.
TEST_F(ARate, GoesHomeStraightAtFullSpeedWhenTheSecondButtonGoesDown) {
  deflect({0.05 + 0.95 * std::sqrt(0.75), -1.0, 0.0}, {0.0, 0.0, 0.05 + 0.95 * std::sqrt(0.5)});
  run_ms(400);
  ASSERT_LT(glm::distance(rate_.position_m(), glm::dvec3(0.03, -0.04, 0.02)), 1e-12);
  const glm::dvec3 from_m = rate_.position_m();
  deflect(glm::dvec3(0.0), glm::dvec3(0.0), RateControl::kHomeButton);
  EXPECT_EQ(rate_.buttons(), 0U);  // it is nobody's answer
  EXPECT_LT(glm::distance(rate_.velocity_m_per_s(), glm::dvec3(-0.06, 0.08, 0.0)), 1e-12);
  EXPECT_LT(glm::distance(rate_.angular_velocity_rad_per_s(), glm::dvec3(0.0, 0.0, -1.0)), 1e-12);
  run_ms(100);
  EXPECT_NEAR(glm::distance(rate_.position_m(), from_m), 0.01, 1e-12);
  EXPECT_NEAR(rate_.orientation().z, std::sin(0.05), 1e-12);
  run_ms(401);
  EXPECT_EQ(rate_.position_m(), kSettings.home_m);
  EXPECT_EQ(rate_.orientation(), glm::dquat(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(rate_.velocity_m_per_s(), glm::dvec3(0.0));
  // Held down it is pressed once.
  deflect({1.0, 0.0, 0.0}, glm::dvec3(0.0), RateControl::kHomeButton);
  run_ms(100);
  EXPECT_NEAR(rate_.position_m().x, 0.01, 1e-12);
}

TEST_F(ARate, GoesHomeWhateverTheCapDoesAndNotAfterAStop) {
  deflect({1.0, 0.0, 0.0});
  run_ms(500);
  deflect({1.0, 0.0, 0.0}, glm::dvec3(0.0), RateControl::kHomeButton);
  run_ms(100);
  EXPECT_NEAR(rate_.position_m().x, 0.04, 1e-12);
  rate_.stop();
  const glm::dvec3 stopped_m = rate_.position_m();
  rate_.advance(now_ns_ + 20 * kMillisecond_ns);
  EXPECT_EQ(rate_.position_m(), stopped_m);
}

TEST_F(ARate, LeavesTheFirstButtonAloneToTheParticipant) {
  deflect(glm::dvec3(0.0), glm::dvec3(0.0), 0xffffffffU);
  EXPECT_EQ(rate_.buttons(), 1U);
  deflect(glm::dvec3(0.0), glm::dvec3(0.0), 0xfffffffeU);
  EXPECT_EQ(rate_.buttons(), 0U);
}

TEST_F(ARate, TouchesNoHeap) {
  const AllocationGuard guard;
  deflect({1.0, 0.5, 0.2}, {0.3, 0.2, 1.0});
  run_ms(100);
  deflect(glm::dvec3(0.0), glm::dvec3(0.0), RateControl::kHomeButton);
  run_ms(100);
  rate_.stop();
  EXPECT_EQ(guard.count(), 0);
}

std::string setting_refusal(const std::function<void(RateControlSettings&)>& change) {
  RateControlSettings settings = kSettings;
  change(settings);
  return refusal_of<std::invalid_argument>([&] { const RateControl rate(settings); });
}

TEST(RateControl, RefusesSettingsOutOfTheirDomainByName) {
  using testing::HasSubstr;
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(setting_refusal([](auto& s) { s.full_speed_m_per_s = 0.0; }),
              HasSubstr("full_speed"));
  EXPECT_THAT(setting_refusal([](auto& s) { s.full_turn_rad_per_s = -1.0; }),
              HasSubstr("full_turn"));
  EXPECT_THAT(setting_refusal([](auto& s) { s.dead_zone = 1.0; }), HasSubstr("dead_zone"));
  EXPECT_THAT(setting_refusal([&](auto& s) { s.dead_zone = nothing; }), HasSubstr("dead_zone"));
  EXPECT_THAT(setting_refusal([](auto& s) { s.workspace_minimum_m.y = 0.2; }),
              HasSubstr("workspace_minimum_m"));
  EXPECT_THAT(setting_refusal([&](auto& s) { s.workspace_maximum_m.z = nothing; }),
              HasSubstr("workspace"));
  EXPECT_THAT(setting_refusal([](auto& s) { s.home_m.z = 0.06; }), HasSubstr("home_m"));
  EXPECT_EQ(setting_refusal([](auto&) {}), "");
}

}  // namespace
}  // namespace asperity::spacemouse
