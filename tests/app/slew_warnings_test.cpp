// Which stimuli the limiter would change.

#include "app/tasks/slew_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

TEST(SlewWarnings, NameAStimulusThatWouldBeLimited) {
  const TemporaryFolder folder{};
  make_small_study(folder / "study");
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, folder / "study");
  const auto warnings = [&](double stiffness_N_per_m, double speed_m_per_s) {
    Protocol protocol =
        read_small_protocol(models, small_protocol("", R"(, "normal_force_N": {"target": 1.0})"));
    protocol.material.stiffness_N_per_m = stiffness_N_per_m;
    for (auto& each : protocol.explorations) each.second.speed_m_per_s.maximum = speed_m_per_s;
    return warnings_about_slew(protocol, "p.json", builder);
  };
  EXPECT_TRUE(warnings(500.0, 0.06).empty());
  const std::vector<Diagnostic> found = warnings(100'000.0, 0.3);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().pointer, "/stimuli/rendered");
  EXPECT_THAT(found.front().message, HasSubstr("(model height_map) would be limited in "));
  EXPECT_THAT(found.front().message,
              HasSubstr(" ticks of strokes at 300 mm/s and 1 N in the exploration \"short\""));
  EXPECT_THAT(found.front().message, HasSubstr("by more than 1 N"));
}

}  // namespace
}  // namespace asperity
