// Which stimuli the limiter would change.

#include "app/tasks/warnings/slew_warnings.h"

#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(SlewWarnings, NameAStimulusThatWouldBeLimited) {
  const TemporaryFolder folder{};
  make_small_study(folder / "study");
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, folder / "study");
  StimuliCourse course{};
  const auto warnings = [&](double stiffness_N_per_m, double speed_m_per_s) {
    Protocol protocol =
        read_small_protocol(models, small_protocol("", R"(, "normal_force_N": {"target": 1.0})"));
    protocol.material.stiffness_N_per_m = stiffness_N_per_m;
    for (auto& each : protocol.explorations) each.second.speed_m_per_s.maximum = speed_m_per_s;
    return warnings_about_slew({protocol, "p.json"}, builder, course);
  };
  EXPECT_TRUE(warnings(500.0, 0.06).empty());
  const std::vector<Diagnostic> found = warnings(100'000.0, 0.3);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().pointer, "/stimuli/rendered");
  EXPECT_THAT(found.front().message.english(),
              HasSubstr("(model height_map) would be limited in "));
  EXPECT_THAT(found.front().message.english(),
              HasSubstr(" ticks of strokes at 300 mm/s and 1 N and in "));
  EXPECT_THAT(found.front().message.english(),
              HasSubstr(" of 8 touch-downs at 50 mm/s in the exploration \"short\""))
      << "100 kN/m · 50 µm are 5 N in a millisecond";
  EXPECT_THAT(found.front().message.english(), HasSubstr("by more than 1 N"));
  std::vector<double> progress{};
  std::stop_source stop{};
  course = {.stop = stop.get_token(), .progress = [&](double done) { progress.push_back(done); }};
  EXPECT_FALSE(warnings(100'000.0, 0.3).empty());
  ASSERT_GE(progress.size(), 2U);
  EXPECT_EQ(progress.front(), 0.0);
  EXPECT_LT(progress.back(), 1.0);
  stop.request_stop();
  EXPECT_TRUE(warnings(100'000.0, 0.3).empty());
}

/// Of lateral_gradient at 5 mm/s; `stimulus`: further keys of its stimulus.
std::vector<Diagnostic> warnings_of_lateral_force(double gain_N, const std::string& stimulus) {
  const TemporaryFolder folder{};
  make_small_study(folder / "study");
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, folder / "study");
  std::string text = small_protocol(
      "", R"(, "normal_force_N": {"target": 1.0}, "speed_m_per_s": {"target": 0.005})");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  };
  replace("height_map", "lateral_gradient");
  replace(R"("texture": "grain"})", R"("texture": "grain")" + stimulus + "}");
  Protocol protocol = read_small_protocol(models, text);
  protocol.stimuli.at("rendered").parameters["gain_N"].value = gain_N;
  return warnings_about_slew({protocol, "p.json"}, builder);
}

// A lateral force fades in over 0.1 mm, which 50 mm/s pass in two ticks: up to three quarters of it in one. At constant depth and
// 5 mm/s it turns slowly.
TEST(SlewWarnings, NameWhatWouldBeLimitedWhereTheHandTouchesDown) {
  EXPECT_TRUE(warnings_of_lateral_force(1.0, "").empty());
  const std::vector<Diagnostic> found = warnings_of_lateral_force(10.0, "");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.front().message.english(),
              HasSubstr("(model lateral_gradient) would be limited in "));
  EXPECT_THAT(found.front().message.english(),
              HasSubstr(" of 8 touch-downs at 50 mm/s in the exploration"));
  EXPECT_THAT(found.front().message.english(), Not(HasSubstr("ticks of strokes")));
}

TEST(SlewWarnings, TakeTheAmplitudeOfEqualForce) {
  EXPECT_TRUE(warnings_of_lateral_force(10.0, R"(, "equal_force": {"rms_N": 0.05})").empty());
}

TEST(SlewWarnings, LeaveOutWhatCannotBeRendered) {
  const TemporaryFolder folder{};
  const ModelRegistry models = built_in_models();
  StimulusBuilder without_the_texture(models, folder / "elsewhere");
  const Protocol protocol = read_small_protocol(models, small_protocol("", ""));
  EXPECT_TRUE(warnings_about_slew({protocol, "p.json"}, without_the_texture).empty());
}

}  // namespace
}  // namespace asperity
