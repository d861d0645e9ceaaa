// Whether a sweep goes beside a protocol's estimates: by what varies, by numbers, and what else differs.

#include "app/sweep/sweep_beside.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Change = std::function<void(nlohmann::ordered_json&)>;

const ModelRegistry& all_models() {
  static const ModelRegistry kAll = built_in_models();
  return kAll;
}

Protocol roughness_by(std::string_view what, const Change& change = {}) {
  const std::string name = "roughness_" + std::string(what);
  std::ifstream file(std::string(ASPERITY_SOURCE_DIR) + "/protocols/library/" + name + ".json");
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(file);
  if (change) change(json);
  return read_protocol(json.dump(), name, declarations_of(all_models()));
}

/// As the three protocols of roughness have it.
SweepOrder like_the_library(VariedQuantity varied, std::vector<double> values) {
  SweepOrder order{.varied = varied, .values = std::move(values)};
  order.stroke.model = all_models().find("pd_gradient");
  order.stroke.material = {.stiffness_N_per_m = 3000.0, .friction = 0.2};
  order.stroke.speed_m_per_s = 0.06;
  order.spacings_m = {0.0005, 0.002, 0.0035};
  order.texture = {.kind = "sinusoid", .values = {{"amplitude_m", 1e-4}}};
  return order;
}

/// A study with waves 0.2 mm high in place of the cones of the protocols: they are read sooner.
class SweepBesideTest : public testing::Test {
 protected:
  SweepBesideTest() {
    std::filesystem::create_directory(folder_.path() / "stimuli");
    for (const auto& [name, spacing_m] :
         {std::pair{"cones_05", 0.0005}, std::pair{"cones_07", 0.0007},
          std::pair{"cones_10", 0.001}, std::pair{"cones_14", 0.0014}, std::pair{"cones_20", 0.002},
          std::pair{"cones_28", 0.0028}, std::pair{"cones_35", 0.0035}}) {
      const HeightField field =
          make_surface("sinusoid", {{"spacing_m", spacing_m}, {"amplitude_m", 1e-4}},
                       {.width_m = 4.0 * spacing_m, .pixels = 32});
      save_height_field(folder_.path() / "stimuli" / (std::string(name) + ".png"), field, {},
                        Overwrite::refuse);
    }
  }

  SweepBeside beside(const SweepOrder& order, const Protocol& protocol) const {
    return sweep_beside(order, protocol, folder_.path());
  }
  std::string refusal(const SweepOrder& order, const Protocol& protocol) const {
    return refusal_of<std::runtime_error>([&] { (void)beside(order, protocol); });
  }

  TemporaryFolder folder_{};
};

TEST_F(SweepBesideTest, PutsEachLevelToTheConditionOfItsNumber) {
  const Protocol force = roughness_by("force");
  SweepOrder order = like_the_library(VariedQuantity::applied_force, {2.0, 0.5, 1.0});
  const SweepBeside found = beside(order, force);
  EXPECT_THAT(found.conditions, ElementsAre("firm", "light", "medium"));
  EXPECT_THAT(found.remarks, IsEmpty());
  EXPECT_THAT(beside(like_the_library(VariedQuantity::exploratory_speed, {0.1, 0.05}),
                     roughness_by("speed"))
                  .conditions,
              ElementsAre("fast", "slow"));
  // In whatever order the protocol lists them.
  const Protocol turned = roughness_by("diameter", [](nlohmann::ordered_json& json) {
    json["factors"]["tip"]["levels"] = {"sphere_3mm", "sphere_1mm", "sphere_2mm"};
  });
  EXPECT_THAT(
      beside(like_the_library(VariedQuantity::probe_diameter, {0.001, 0.002, 0.003}), turned)
          .conditions,
      ElementsAre("sphere_1mm", "sphere_2mm", "sphere_3mm"));
}

TEST_F(SweepBesideTest, GoesByTheOrderOfThePlanWhereConditionsCarryNoNumber) {
  const Protocol protocol = roughness_by("force", [](nlohmann::ordered_json& json) {
    for (const char* how : {"light", "medium", "firm"}) {
      json["explorations"][how]["normal_force_N"].erase("target");
    }
  });
  EXPECT_THAT(
      beside(like_the_library(VariedQuantity::applied_force, {2.0, 0.5, 1.0}), protocol).conditions,
      ElementsAre("light", "medium", "firm"));
}

TEST_F(SweepBesideTest, RefusesWhatTheConditionsDoNotVary) {
  const std::string said =
      refusal(like_the_library(VariedQuantity::probe_diameter, {0.001, 0.002, 0.003}),
              roughness_by("force"));
  EXPECT_THAT(said, HasSubstr("light, medium and firm"));
  EXPECT_THAT(said, HasSubstr("--vary applied_force --values 0.5,1,2"));
}

TEST_F(SweepBesideTest, RefusesOtherLevelsThanTheConditions) {
  const Protocol force = roughness_by("force");
  EXPECT_THAT(
      refusal(like_the_library(VariedQuantity::applied_force, {0.5, 1.0}), force),
      HasSubstr("3 conditions, light, medium and firm (0.5 N, 1 N and 2 N), and the sweep has 2 "
                "levels, 0.5 N and 1 N"));
  EXPECT_THAT(refusal(like_the_library(VariedQuantity::applied_force, {0.25, 0.5, 1.0}), force),
              HasSubstr("the level of 0.25 N is not one of them; use --values 0.5,1,2"));
}

TEST_F(SweepBesideTest, RefusesSpacingsThatNobodyFelt) {
  SweepOrder order = like_the_library(VariedQuantity::applied_force, {0.5, 1.0, 2.0});
  order.spacings_m = {0.005, 0.008};
  EXPECT_THAT(refusal(order, roughness_by("force")),
              HasSubstr("spacings of 0.5 to 3.5 mm, and the sweep has 5 to 8 mm"));
}

TEST_F(SweepBesideTest, SaysInWhichThingsItIsAnotherExperiment) {
  const Protocol force = roughness_by("force");
  const SweepOrder same = like_the_library(VariedQuantity::applied_force, {0.5, 1.0, 2.0});
  const auto remark = [&](const std::function<void(SweepOrder&)>& change) {
    SweepOrder order = same;
    change(order);
    const std::vector<std::string> remarks = beside(order, force).remarks;
    return remarks.size() == 1 ? remarks.front() : std::to_string(remarks.size()) + " remarks";
  };
  EXPECT_THAT(remark([](SweepOrder& order) {
                order.texture.values = {{"amplitude_m", 2e-4}};
              }),
              HasSubstr("from trough to crest is 0.4 mm in the sweep and 0.2 mm in "
                        "roughness_force; for the same height, change --texture"));
  EXPECT_THAT(remark([](SweepOrder& order) { order.stroke.material.stiffness_N_per_m = 1000.0; }),
              HasSubstr("1000 N/m in the sweep and 3000 N/m in roughness_force; for the same "
                        "stiffness, use --stiffness-n-per-m 3000"));
  EXPECT_THAT(remark([](SweepOrder& order) { order.stroke.material.friction = 0.0; }),
              HasSubstr("is 0 in the sweep and 0.2 in roughness_force; for the same friction, use "
                        "--friction 0.2"));
  EXPECT_THAT(remark([](SweepOrder& order) {
                order.spacings_m = {0.0005, 0.008};
              }),
              HasSubstr("0.5 to 3.5 mm, and the sweep has 0.5 to 8 mm (--spacings)"));
  EXPECT_THAT(remark([](SweepOrder& order) { order.stroke.tip.diameter_m = 0.001; }),
              HasSubstr("the sweep has 1 mm, and roughness_force has 2 mm; for the same value, "
                        "change --probe-diameter-m"));
  EXPECT_THAT(remark([](SweepOrder& order) { order.stroke.speed_m_per_s = 0.1; }),
              HasSubstr("100 mm/s, and roughness_force has 60 mm/s; for the same value, change "
                        "--exploratory-speed-m-per-s"));
  EXPECT_THAT(
      remark([](SweepOrder& order) { order.stroke.model = all_models().find("height_map"); }),
      HasSubstr("the force model height_map, and roughness_force uses pd_gradient; for the same "
                "model, change --model"));
  std::filesystem::remove(folder_.path() / "stimuli" / "cones_20.png");
  EXPECT_THAT(remark([](SweepOrder&) {}), HasSubstr("cones_20.png"));
}

TEST_F(SweepBesideTest, SaysThatItIsOutsideABandWithoutATarget) {
  const auto remarks_at = [this](double speed_m_per_s, const nlohmann::ordered_json& band) {
    SweepOrder order = like_the_library(VariedQuantity::applied_force, {0.5, 1.0, 2.0});
    order.stroke.speed_m_per_s = speed_m_per_s;
    return beside(order, roughness_by("force",
                                      [&band](nlohmann::ordered_json& json) {
                                        for (auto& exploration : json["explorations"]) {
                                          exploration["speed_m_per_s"] = band;
                                        }
                                      }))
        .remarks;
  };
  const nlohmann::ordered_json band{{"minimum", 0.04}, {"maximum", 0.08}};
  EXPECT_THAT(remarks_at(0.04, band), IsEmpty());
  EXPECT_THAT(remarks_at(0.08, band), IsEmpty());
  EXPECT_THAT(remarks_at(0.1, band),
              ElementsAre("the sweep has 100 mm/s, and roughness_force requests 40 mm/s to 80 "
                          "mm/s; for the same value, change --exploratory-speed-m-per-s"));
  EXPECT_THAT(remarks_at(0.1, {{"minimum", 0.12}}), ElementsAre(HasSubstr("120 mm/s or more")));
  EXPECT_THAT(remarks_at(0.1, {{"maximum", 0.08}}), ElementsAre(HasSubstr("80 mm/s or less")));
}

}  // namespace
}  // namespace asperity
