// The files from which a stimulus is made.

#include "stimuli/stimulus_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(StimulusAssets, AreTheFilesOfHeightFieldBodiesAndDeclaredRoles) {
  StimulusDescription stimulus{};
  EXPECT_THAT(assets_of(stimulus), IsEmpty());
  stimulus.height_field = "stimuli/metal.png";
  stimulus.tool = BodyDescription{.name = "rasp", .mesh = "stimuli/rasp.mesh"};
  stimulus.declared_assets = {{"vibrations", "stimuli/metal.vib"}, {"heat", "stimuli/metal.heat"}};
  EXPECT_THAT(assets_of(stimulus), ElementsAre(StimulusAsset{"height_field", "stimuli/metal.png"},
                                               StimulusAsset{"tool", "stimuli/rasp.mesh"},
                                               StimulusAsset{"heat", "stimuli/metal.heat"},
                                               StimulusAsset{"vibrations", "stimuli/metal.vib"}));
}

TEST(StimulusAssets, OfAShapeAreTheReliefOnIt) {
  StimulusDescription stimulus{};
  stimulus.surface = BodyDescription{.name = "plate", .height_field = "stimuli/grain.png"};
  stimulus.surface->shape = PlateShape{{0.02, 0.02, 0.01}};
  stimulus.tool = BodyDescription{.name = "ball"};
  stimulus.tool->shape = SphereShape{.diameter_m = 0.006};
  EXPECT_THAT(assets_of(stimulus), ElementsAre(StimulusAsset{"surface", "stimuli/grain.png"}));
}

}  // namespace
}  // namespace asperity
