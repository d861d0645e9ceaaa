// Strokes over a body in the workbench: the path of the hand, the forces, and the choice of the body.

#include "app/gui/workbench/stroked_body.h"

#include <cmath>
#include <stdexcept>

#include <QtCore/QTemporaryDir>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/force_stroke.h"
#include "app/study_files/textured_mesh_files.h"
#include "renderers/built_in_models.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

constexpr double kPressed_m = 0.001;
constexpr double kDomeRadius_m = 0.03;

std::shared_ptr<const HeightField> flat_relief() {
  return std::make_shared<const HeightField>(
      HeightField({64, 64, 0.05 / 64}, std::vector<float>(64 * 64, 0.0F)));
}

TEST(StrokedBody, LiesWithItsHighestPointInThePlaneOfTheRelief) {
  EXPECT_EQ(StrokedBody({.shape = "plane"}).surface(), nullptr);
  EXPECT_THROW((void)StrokedBody({.shape = "mesh"}).surface(), std::invalid_argument);
  for (const char* const shape : {"sphere", "cylinder"}) {
    StrokedBody body({.shape = shape, .diameter_m = 2.0 * kDomeRadius_m});
    const auto surface = body.surface();
    ASSERT_NE(surface, nullptr);
    EXPECT_EQ(body.surface(), surface) << "made once";
    const auto nearest = surface->search().nearest({0.0, 0.0, 0.0});
    EXPECT_NEAR(nearest.distance_m, 0.0, 1e-6) << shape;
  }
}

// The height of a sphere at x is √(R² − x²) − R; the probe is pressed along z.
TEST(MouseHand, FollowsABody) {
  StrokedBody body({.shape = "sphere", .diameter_m = 2.0 * kDomeRadius_m});
  MouseHand hand(kPressed_m, body.surface());
  hand.begin({-0.02, 0.0});
  hand.aim({0.015, 0.005});
  double former_z_m = 0.0;
  for (const ProbeState& probe : hand.advance(300'000'000)) {
    const glm::dvec3& at_m = probe.position_m;
    const double level_m =
        std::sqrt(kDomeRadius_m * kDomeRadius_m - at_m.x * at_m.x - at_m.y * at_m.y) -
        kDomeRadius_m;
    ASSERT_NEAR(at_m.z, level_m - kPressed_m, 2e-6);
    if (probe.time_ns > 0) {
      ASSERT_NEAR(probe.velocity_m_per_s.z, (at_m.z - former_z_m) / 0.001, 1e-12);
    }
    former_z_m = at_m.z;
  }
  hand.begin({0.05, 0.0});
  EXPECT_EQ(hand.advance(0).front().position_m.z, -kPressed_m) << "beside the body";
}

// Along z by d at the slope θ the probe is d·cos θ inside a sphere, to the first order of d/R.
TEST(ForceStroke, PressesWithTheDepthInABody) {
  StrokedBody body({.shape = "sphere", .diameter_m = 2.0 * kDomeRadius_m});
  const ModelRegistry registry = built_in_models();
  StrokedModel stroked{.id = "height_map",
                       .inputs = stroke_inputs(flat_relief(), {.stiffness_N_per_m = 800.0}, {})};
  stroked.inputs.body = body.surface();
  stroked.renderer = make_renderer(*registry.find("height_map"), stroked.inputs);
  ForceStroke stroke{};
  std::vector<StrokedModel> models{};
  models.push_back(std::move(stroked));
  stroke.set_models(std::move(models), MouseHand(kPressed_m, body.surface()));
  for (const double x_m : {0.0, 0.01, 0.02}) {
    stroke.begin({x_m, 0.0});
    stroke.advance(1'000'000);
    const double centre_m = std::hypot(x_m, stroke.path().back().position_m.z + kDomeRadius_m);
    const double depth_m = kDomeRadius_m - centre_m;
    EXPECT_GT(depth_m, 0.7 * kPressed_m);
    EXPECT_NEAR(glm::length(stroke.forces_N()[0].back()), 800.0 * depth_m, 2e-3) << x_m;
  }
}

class SurfaceCardTest : public testing::Test {
 protected:
  SurfaceCardTest() { comparison_.set_field(flat_relief()); }

  void choose_body(const char* shape) {
    auto& list = child<QComboBox>(comparison_, "body");
    const int index = list.findText(shape, Qt::MatchFixedString);
    ASSERT_GE(index, 0) << shape;
    list.setCurrentIndex(index);
    emit list.activated(index);
    ASSERT_TRUE(eventually([this] { return comparison_.is_settled(); }));
  }

  ModelRegistry models_ = built_in_models();
  ForceComparison comparison_{models_};
};

TEST_F(SurfaceCardTest, PutsTheReliefOnTheChosenBody) {
  comparison_.show();
  EXPECT_FALSE(child<QPushButton>(comparison_, "choose_mesh").isVisible());
  choose_body("sphere");
  ASSERT_FALSE(comparison_.stroke().models().empty());
  for (const StrokedModel& stroked : comparison_.stroke().models()) {
    EXPECT_NE(stroked.inputs.body, nullptr) << stroked.id;
  }
  choose_body("plane");
  for (const StrokedModel& stroked : comparison_.stroke().models()) {
    EXPECT_EQ(stroked.inputs.body, nullptr) << stroked.id;
  }
}

TEST_F(SurfaceCardTest, ReadsAMeshAndKeepsTheChoice) {
  comparison_.show();
  QTemporaryDir folder{};
  const std::filesystem::path file = folder.filePath("block.mesh").toStdString();
  StoredTexturedMesh block{};
  block.mesh = placed(body_mesh(BoxShape{{0.05, 0.05, 0.02}}, nullptr), BodyRole::tool);
  save_textured_mesh(file, block, Overwrite::refuse);
  choose_body("mesh");
  EXPECT_TRUE(child<QPushButton>(comparison_, "choose_mesh").isVisible());
  EXPECT_TRUE(comparison_.stroke().models().empty()) << "no file is chosen";
  ForceComparison::Choices choices = comparison_.choices();
  choices.surface.mesh = file;
  comparison_.choose(choices);
  ASSERT_TRUE(eventually([this] { return comparison_.is_settled(); }));
  ASSERT_FALSE(comparison_.stroke().models().empty());
  const auto body = comparison_.stroke().models().front().inputs.body;
  ASSERT_NE(body, nullptr);
  EXPECT_NEAR(body->search().nearest({0.0, 0.0, 0.0}).distance_m, 0.0, 1e-6);
  EXPECT_EQ(comparison_.choices().surface.mesh, file);
}

}  // namespace
}  // namespace asperity
