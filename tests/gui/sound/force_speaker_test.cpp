// Forces become sound at their own pitch, in an even stream.

#include "app/gui/sound/force_speaker.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

std::vector<double> sine(double frequency_Hz, double offset_N, double duration_s) {
  std::vector<double> force_N(static_cast<std::size_t>(duration_s * 1000.0));
  for (std::size_t i = 0; i < force_N.size(); ++i) {
    force_N[i] = offset_N +
                 std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / 1000.0);
  }
  return force_N;
}

std::vector<double> listen(ForceSound& sound, double duration_s) {
  std::vector<float> stereo(2 * static_cast<std::size_t>(duration_s * 48000.0));
  sound.fill(stereo);
  std::vector<double> left{};
  for (std::size_t i = 0; i < stereo.size(); i += 2) left.push_back(static_cast<double>(stereo[i]));
  return left;
}

double peak_of(const std::vector<double>& samples) {
  double peak = 0.0;
  for (const double sample : samples) peak = std::max(peak, std::abs(sample));
  return peak;
}

TEST(ForceSound, KeepsThePitchOfTheForce) {
  ForceSound sound(48000.0);
  sound.put(sine(100.0, 0.0, 0.2), 1000.0);
  const auto heard = listen(sound, 0.15);
  int crossings = 0;
  for (std::size_t i = 1; i < heard.size(); ++i) crossings += heard[i - 1] < 0.0 && heard[i] >= 0.0;
  EXPECT_NEAR(crossings, 15, 1);
  EXPECT_NEAR(peak_of(heard), std::tanh(0.5),
              0.06);  // 1 N at a full scale of 1 N, less the slow part
}

TEST(ForceSound, ASteadyPressureIsSilent) {
  ForceSound sound(48000.0);
  for (int i = 0; i < 5; ++i) {
    sound.put(std::vector<double>(200, 5.0), 1000.0);
    listen(sound, 0.15);
  }
  EXPECT_LT(peak_of(listen(sound, 0.02)), 0.001);
}

TEST(ForceSound, BurstsOfAWindowBecomeAnEvenStream) {
  ForceSound sound(48000.0);
  const auto force_N = sine(125.0, 0.0, 1.0);
  std::vector<double> heard{};
  for (std::size_t burst = 0; burst < 60; ++burst) {  // 16 or 17 samples 60 times a second
    const std::size_t first = burst * 1000 / 60;
    const std::size_t next = (burst + 1) * 1000 / 60;
    sound.put(std::span(force_N).subspan(first, next - first), 1000.0);
    for (const double sample : listen(sound, 1.0 / 60.0)) heard.push_back(sample);
  }
  // From its beginning on it is never silent for as long as half a period.
  const auto begin =
      std::find_if(heard.begin(), heard.end(), [](double x) { return std::abs(x) > 0.3; });
  ASSERT_NE(begin, heard.end());
  EXPECT_LT(begin - heard.begin(), 48 * 100);
  int silence = 0;
  int longest = 0;
  for (auto sample = begin; sample != heard.end(); ++sample) {
    silence = std::abs(*sample) < 0.1 ? silence + 1 : 0;
    longest = std::max(longest, silence);
  }
  EXPECT_LT(longest, 48 * 4);
}

TEST(ForceSound, FallsSilentWhenForcesStopAndLeavesOutWhatIsLate) {
  ForceSound sound(48000.0);
  sound.put(sine(100.0, 0.0, 1.0),
            1000.0);  // a second at once: all but its last 50 ms are too late
  EXPECT_GT(peak_of(listen(sound, 0.04)), 0.2);
  listen(sound, 0.1);
  EXPECT_LT(peak_of(listen(sound, 0.1)), 0.001);
}

TEST(ForceSound, FillingDoesNotTouchTheHeap) {
  ForceSound sound(48000.0);
  sound.put(sine(100.0, 0.0, 0.2), 1000.0);
  std::vector<float> stereo(960);
  AllocationGuard guard;
  for (int i = 0; i < 20; ++i) sound.fill(stereo);
  EXPECT_EQ(guard.count(), 0);
}

TEST(ForceSpeaker, TakesForcesWithoutASoundCard) {
  ForceSpeaker speaker(null_output());
  EXPECT_TRUE(speaker.is_null());
  speaker.play_force(sine(100.0, 0.0, 0.1), 1000.0);
}

}  // namespace
}  // namespace asperity
