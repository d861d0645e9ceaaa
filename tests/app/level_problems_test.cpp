// Levels that give the same surface, and levels that are finer than the steps of a height file.

#include "app/tasks/check_protocol.h"
#include "app/tasks/warnings/level_problems.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study_files/height_field_files.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A discrimination of two reliefs of a file that differ in `height_scale`.
std::string scaled_reliefs(const std::string& file, const std::string& levels) {
  return R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "scaled",
  "version": "1.0.0", "title": "Scaled", "consent": {"version": "1.0", "statement": "I take part."},
  "textures": {"relief": {"height_field": "stimuli/)" +
         file + R"(.png"}},
  "stimuli": {"plate": {"model": "height_map", "texture": "relief", "parameters": {"height_scale": 1}}},
  "explorations": {"stroking": {"minimum_contact_s": 1, "maximum_contact_s": 6}},
  "blocks": {"pairs": {
    "vary": {"parameter": "height_scale", "of": "comparison", "relative_to": "standard",
             )" +
         levels + R"(},
    "presented": [{"role": "standard", "stimulus": "plate"}, {"role": "comparison", "stimulus": "plate"}],
    "repetitions": 2, "positions": "balanced", "exploration": "stroking",
    "question": {"name": "higher", "prompt": "Which is higher?", "judgement": "performance"}}},
  "flow": [{"run": "pairs"}]
})";
}

/// Heights of 0 and of this height in turn, at a pitch of 1 mm; between them they are interpolated.
HeightField two_heights(float height_m) {
  const HeightField::Grid grid{.rows = 8, .columns = 8, .pitch_m = 1e-3};
  std::vector<float> heights_m(64);
  for (std::size_t i = 0; i < heights_m.size(); i += 2) heights_m[i] = height_m;
  return {grid, heights_m};
}

class LevelProblems : public testing::Test {
 protected:
  LevelProblems() {
    make_small_study(study_);
    save_height_field(study_ / "stimuli" / "rough.png", two_heights(1e-4F), {.kind = "test"},
                      Overwrite::refuse);
    save_height_field(study_ / "stimuli" / "flat.png", two_heights(0.0F), {.kind = "test"},
                      Overwrite::refuse);
  }
  std::vector<Diagnostic> problems_of(const std::string& protocol) const {
    return check_protocol_text(protocol, "p.json", models_, study_, {}).diagnostics;
  }

  const TemporaryFolder folder_{};
  const std::filesystem::path study_ = folder_ / "study";
  const ModelRegistry models_ = built_in_models();
};

constexpr const char* kFineGrid =
    R"("levels_percent": {"lowest": 1e-6, "highest": 3e-6, "step": 1e-6})";

TEST_F(LevelProblems, NameAFileInWhichAllHeightsAreTheSame) {
  const std::vector<Diagnostic> found =
      problems_of(scaled_reliefs("flat", R"("levels_percent": [5, 10])"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/blocks/pairs/vary/parameter");
  EXPECT_EQ(found[0].line, 8);
  EXPECT_THAT(found[0].message.english(),
              HasSubstr("all heights of stimuli/flat.png are the same"));
  EXPECT_THAT(found[0].message.english(), HasSubstr("use a height field with a texture"));
}

TEST_F(LevelProblems, NameLevelsThatAreTheSameValue) {
  const std::vector<Diagnostic> grid = problems_of(scaled_reliefs(
      "rough", R"("levels_percent": {"lowest": 5, "highest": 5.00000000002, "step": 1e-11})"));
  ASSERT_THAT(grid, SizeIs(1));
  EXPECT_EQ(grid[0].pointer, "/blocks/pairs/vary/levels_percent/step");
  EXPECT_THAT(grid[0].message.english(), HasSubstr("are the same value of \"height_scale\", 1.05"));
  EXPECT_THAT(grid[0].message.english(), HasSubstr("use a larger step"));
  const std::vector<Diagnostic> list =
      problems_of(scaled_reliefs("rough", R"("levels_percent": [5, 5.00000000001])"));
  ASSERT_THAT(list, SizeIs(1));
  EXPECT_EQ(list[0].pointer, "/blocks/pairs/vary/levels_percent");
  EXPECT_THAT(list[0].message.english(), HasSubstr("leave one of them out"));
}

// The file has heights of 0 and 0.1 mm in steps of 1.5 nm. A step of 1e-6 per cent is 1 pm at the greatest height.
TEST_F(LevelProblems, AreNoneForStepsBelowThoseOfTheFile) {
  EXPECT_THAT(problems_of(scaled_reliefs("rough", kFineGrid)), IsEmpty());
}

// The heights that the file stores are multiplied in floating point.
TEST_F(LevelProblems, AreNoneBecauseEveryLevelIsRendered) {
  const Protocol protocol = read_small_protocol(models_, scaled_reliefs("rough", kFineGrid));
  const std::vector<double> values = protocol.blocks.at("pairs").vary->values();
  ASSERT_THAT(values, SizeIs(3));
  StimulusBuilder builder(models_, study_);
  std::vector<double> normal_N{};
  for (const double value : values) {
    StimulusDescription described{.model = "height_map", .parameters = {{"height_scale", value}}};
    described.height_field = "stimuli/rough.png";
    described.material.stiffness_N_per_m = 500.0;
    described.patch.extent_m = {0.1, 0.1};
    const PreparedStimulus prepared = builder.unmatched(described);
    const auto renderer = make_renderer(*prepared.model, prepared.inputs);
    const ProbeState at_sample{.position_m = {-3.5e-3, 3.5e-3, 0.0}};
    renderer->reset(at_sample);
    normal_N.push_back(renderer->tick(at_sample, 1e-3).wrench.force_N.z);
  }
  const double expected_N = 500.0 * 1e-4 * 1e-8;  // a step of the grid, at the greatest height
  EXPECT_NEAR(normal_N[1] - normal_N[0], expected_N, 1e-3 * expected_N);
  EXPECT_NEAR(normal_N[2] - normal_N[1], expected_N, 1e-3 * expected_N);
}

}  // namespace
}  // namespace asperity
