// The workspace follows the session: its surfaces, its probe, its hand.

#include "app/gui/participant/live_workspace.h"

#include <cmath>

#include <QtCore/QTemporaryDir>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/study_files/height_field_files.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// A session whose trial 1 has two surfaces: one with a relief of waves, one with another.
class LiveWorkspaceTest : public testing::Test {
 protected:
  LiveWorkspaceTest() {
    for (int i = 1; i <= 2; ++i) {
      const HeightField::Grid grid{.rows = 100, .columns = 100, .pitch_m = 0.001};
      std::vector<float> heights_m(grid.rows * grid.columns);
      for (std::size_t k = 0; k < heights_m.size(); ++k) {
        heights_m[k] =
            static_cast<float>(1e-4 * std::sin(0.3 * i * static_cast<double>(k % grid.columns)));
      }
      save_height_field(folder() / (std::to_string(i) + ".png"), HeightField(grid, heights_m), {},
                        Overwrite::refuse);
      PlannedPresentation surface{};
      surface.position = i;
      surface.stimulus.height_field = std::to_string(i) + ".png";
      trial_.presentations.push_back(surface);
    }
    trial_.ordinal = 1;
  }

  std::filesystem::path folder() const { return folder_.path().toStdString(); }

  void begin(bool mirrored = false) {
    SessionFacts facts{};
    facts.plan = std::make_shared<const Plan>(Plan{.trials = {trial_}, .steps = {}});
    facts.mirrored = mirrored;
    monitor_.set_facts(facts);
  }
  void feel(int surface) {
    monitor_.update([surface](SessionSnapshot& now) {
      now.trial = 1;
      now.surface = surface;
    });
  }
  void move(float x_m) {
    LiveBin bin{};
    bin.x_m = x_m;
    bin.touching = true;
    monitor_.add_bin(bin);
  }
  /// What is seen once nothing more comes.
  static QImage settled(LiveWorkspace& workspace) {
    EXPECT_TRUE(eventually([&] { return workspace.is_settled(); }));
    return workspace.grab().toImage();
  }

  QTemporaryDir folder_{};
  Trial trial_{};
  SessionMonitor monitor_{};
};

TEST_F(LiveWorkspaceTest, ShowsTheReliefOfTheSurfaceThatIsFelt) {
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::relief);
  workspace.resize(480, 270);
  workspace.show();
  begin();
  feel(1);
  const QImage first = settled(workspace);
  feel(2);
  const QImage second = settled(workspace);
  EXPECT_NE(first, second);
  feel(1);
  EXPECT_EQ(settled(workspace), first);
}

TEST_F(LiveWorkspaceTest, ShowsAllSurfacesAlikeWhereTheyAreNotToBeTold) {
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::pattern);
  workspace.resize(480, 270);
  workspace.show();
  begin();
  feel(1);
  const QImage first = settled(workspace);
  feel(2);
  EXPECT_EQ(settled(workspace), first);
}

TEST_F(LiveWorkspaceTest, TheProbeFollowsTheHandAndIsGoneBetweenSurfaces) {
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::plain);
  workspace.resize(480, 270);
  workspace.show();
  begin();
  feel(1);
  const QImage empty = settled(workspace);
  move(-0.03F);
  const QImage left = settled(workspace);
  EXPECT_NE(left, empty);
  move(0.03F);
  EXPECT_NE(settled(workspace), left);
  feel(0);
  EXPECT_EQ(settled(workspace), empty);
}

TEST_F(LiveWorkspaceTest, ShowsTheBodiesOfAModelThatHasThem) {
  BodyDescription plate{.name = "plate", .shape = PlateShape{{0.06, 0.04, 0.01}}};
  trial_.presentations[0].stimulus.surface = plate;
  trial_.presentations[0].stimulus.tool = {.name = "ball",
                                           .shape = SphereShape{.diameter_m = 0.01}};
  trial_.presentations[1].stimulus.surface = plate;
  trial_.presentations[1].stimulus.tool = {
      .name = "rod", .shape = CylinderShape{.diameter_m = 0.006, .length_m = 0.03}};
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::plain);
  workspace.resize(480, 270);
  workspace.show();
  begin();
  feel(1);
  move(0.0F);
  const QImage ball = settled(workspace);
  feel(2);
  move(0.0F);
  const QImage rod = settled(workspace);
  EXPECT_NE(rod, ball);
  LiveBin turned{};
  turned.orientation = glm::angleAxis(1.0F, glm::vec3{0.0F, 1.0F, 0.0F});
  turned.touching = true;
  monitor_.add_bin(turned);
  EXPECT_NE(settled(workspace), rod);
}

TEST_F(LiveWorkspaceTest, AMirroredSessionLiesOnTheOtherSide) {
  trial_.presentations[0].stimulus.patch.centre_m.x = 0.05;
  trial_.presentations[0].patch = trial_.presentations[0].stimulus.patch;
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::plain);
  workspace.resize(480, 270);
  workspace.show();
  begin(true);
  feel(1);
  const QImage empty = settled(workspace);
  move(-0.05F);  // the centre of the mirrored patch, and so of the picture
  const QImage now = settled(workspace);
  int changed = 0;
  for (int row = 0; row < now.height(); ++row) {
    for (int column = 200; column < 280; ++column) {
      changed += now.pixel(column, row) != empty.pixel(column, row) ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 100);
}

TEST_F(LiveWorkspaceTest, AReliefThatCannotBeReadIsReported) {
  trial_.presentations[0].stimulus.height_field = "none.png";
  LiveWorkspace workspace(monitor_, folder(), SurfaceLook::relief);
  QSignalSpy unreadable(&workspace, &LiveWorkspace::unreadable);
  workspace.resize(480, 270);
  workspace.show();
  begin();
  feel(1);
  ASSERT_TRUE(eventually([&] { return unreadable.count() == 1; }));
  EXPECT_TRUE(unreadable.front().front().toString().contains("none.png"));
}

}  // namespace
}  // namespace asperity
