// Tests the warning about a stimulus that cannot reach the force that its protocol requests.

#include "app/tasks/warnings/force_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

// At the default stiffness of 500 N/m the depth of height_map ends at 3 mm: 1.5 N.
TEST(ForceWarnings, NameAStimulusThatCannotReachTheRequestedForce) {
  const TemporaryFolder folder{};
  make_small_study(folder / "study");
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, folder / "study");
  const auto warnings = [&](const std::string& band) {
    const Protocol protocol =
        read_small_protocol(models, small_protocol("", R"(, "normal_force_N": {)" + band + "}"));
    return warnings_about_forces({protocol, "p.json"}, builder);
  };
  EXPECT_TRUE(warnings(R"("minimum": 0.5, "target": 1.2, "maximum": 2.5)").empty());
  EXPECT_TRUE(warnings(R"("maximum": 2.5)").empty());
  for (const char* band :
       {R"("minimum": 1.5, "target": 2.0, "maximum": 2.5)", R"("minimum": 2.0, "maximum": 2.5)"}) {
    const std::vector<Diagnostic> found = warnings(band);
    ASSERT_EQ(found.size(), 1U) << band;
    EXPECT_EQ(found.front().pointer, "/stimuli/rendered");
    EXPECT_THAT(found.front().message.english(), HasSubstr("exerts at most 1.50 N"));
    EXPECT_THAT(found.front().message.english(),
                HasSubstr("the exploration \"short\" requests 2 N"));
  }
}

}  // namespace
}  // namespace asperity
