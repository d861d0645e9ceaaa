// The arrangement of a block's trials: how a file states it, the places of the surfaces, and designs that are refused.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/arranged_patches.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ArrangedJson = nlohmann::json;
using ::testing::HasSubstr;

/// A main block "pairs" that presents two gratings.
ArrangedJson two_gratings(const ArrangedJson& arrangement) {
  ArrangedJson protocol = ArrangedJson::parse(R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "two",
    "version": "1.0.0", "title": "Two gratings",
    "consent": {"version": "1.0", "statement": "I take part of my own free will."},
    "surface": {"centre_m": [0, 0, 0], "extent_m": [0.1, 0.08], "tiling": "repeat", "edge": "fade",
                "edge_width_m": 0.005, "motion_scale": 1},
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
    "explorations": {"stroking": {"minimum_contact_s": 1, "maximum_contact_s": 6}},
    "blocks": {"pairs": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels_ratio": [1.5, 2]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "exploration": "stroking",
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
    "flow": [{"run": "pairs"}]})");
  if (!arrangement.is_null()) protocol["blocks"]["pairs"]["arrangement"] = arrangement;
  return protocol;
}

Protocol arranged_protocol(const ArrangedJson& arrangement) {
  return test::valid(two_gratings(arrangement));
}

const Arrangement& arrangement_in(const Protocol& protocol) {
  return protocol.blocks.at("pairs").arrangement;
}

TEST(ArrangementOfATrial, IsASequenceThatCanBeFeltAgainUnlessStated) {
  const Protocol plain = arranged_protocol(nullptr);
  EXPECT_EQ(arrangement_in(plain).surfaces, Arrangement::Surfaces::sequential);
  EXPECT_EQ(arrangement_in(plain).minimum_visits, 1);
  EXPECT_TRUE(arrangement_in(plain).allows_revisits());
  EXPECT_FALSE(arrangement_in(plain).interval);
  ArrangedJson once = two_gratings(nullptr);
  once["blocks"]["pairs"]["question"]["allow_revisit"] = false;
  EXPECT_FALSE(arrangement_in(test::valid(once)).allows_revisits());
}

TEST(ArrangementOfATrial, IsReadAsStated) {
  const Protocol protocol =
      arranged_protocol({{"surfaces", "sequential"},
                         {"visits", {{"minimum", 2}, {"maximum", 3}}},
                         {"interval_s", {{"shortest", 0.5}, {"longest", 1.5}}},
                         {"exposure", {{"strokes", 4}}},
                         {"phase", "drawn"}});
  const Arrangement& arrangement = arrangement_in(protocol);
  EXPECT_EQ(arrangement.minimum_visits, 2);
  EXPECT_EQ(arrangement.maximum_visits, 3);
  EXPECT_EQ(arrangement.interval->shortest_s, 0.5);
  EXPECT_EQ(arrangement.interval->longest_s, 1.5);
  EXPECT_EQ(arrangement.strokes, 4);
  EXPECT_TRUE(arrangement.draws_phase);
  EXPECT_TRUE(arrangement.may_visit(2));
  EXPECT_FALSE(arrangement.may_visit(3));
  EXPECT_EQ(arrangement_in(arranged_protocol({{"interval_s", 0.8}})).interval->longest_s, 0.8);
}

TEST(ArrangementOfATrial, DividesTheWorkspaceAmongPatches) {
  const Protocol protocol = arranged_protocol({{"surfaces", "side_by_side"}, {"gap_m", 0.01}});
  const Plan plan = make_plan(protocol, {1, 0});
  for (const Trial& trial : plan.trials) {
    const SurfacePatch& left = trial.presentations.at(0).patch;
    const SurfacePatch& right = trial.presentations.at(1).patch;
    EXPECT_NEAR(left.centre_m.x, -0.0275, 1e-15);
    EXPECT_NEAR(right.centre_m.x, 0.0275, 1e-15);
    EXPECT_NEAR(left.extent_m.x, 0.045, 1e-15);
    EXPECT_EQ(left.extent_m.y, 0.08);
    EXPECT_THAT(json_of(trial), HasSubstr("\"patch\""));
  }
  EXPECT_NE(plan.trials.at(0).presentations.at(0).role, plan.trials.at(1).presentations.at(0).role)
      << "sides are balanced";
  const SurfacePatch workspace{.extent_m = {0.1, 0.1}};
  const std::vector<SurfacePatch> three = arranged_patches(
      workspace, {.surfaces = Arrangement::Surfaces::side_by_side, .axis = Arrangement::Axis::y},
      3);
  EXPECT_NEAR(three[1].centre_m.y, 0.0, 1e-15);
  EXPECT_NEAR(three[2].centre_m.y - three[1].centre_m.y, three[1].extent_m.y + 0.006, 1e-15);
  EXPECT_EQ(three[2].extent_m.x, 0.1);
}

/// Plans of earlier versions are compared byte for byte.
TEST(ArrangementOfATrial, AddsNothingToThePlanOfASequence) {
  const Plan plan = make_plan(arranged_protocol({{"interval_s", 0.8}}), {1, 0});
  EXPECT_THAT(json_of(plan.trials.at(0)), testing::Not(HasSubstr("patch")));
}

struct RefusedArrangement {
  const char* pointer = "";  ///< below the block
  const char* message = "";
  std::function<void(ArrangedJson& protocol, ArrangedJson& block)> change{};
};

TEST(ArrangementOfATrial, RefusesWhatCannotBePresented) {
  using J = ArrangedJson;
  const std::vector<RefusedArrangement> faults{
      {"/arrangement/interval_s/shortest", "exchange the two numbers",
       [](J&, J& b) {
         b["arrangement"]["interval_s"] = {{"shortest", 2}, {"longest", 1}};
       }},
      {"/arrangement/visits/maximum", "the maximum is below the minimum",
       [](J&, J& b) {
         b["arrangement"]["visits"] = {{"minimum", 3}, {"maximum", 2}};
       }},
      {"/question/allow_revisit", "the arrangement determines how often",
       [](J&, J& b) { b["question"]["allow_revisit"] = false; }},
      {"/pause_between_surfaces_s", "replaces this pause",
       [](J&, J& b) {
         b["pause_between_surfaces_s"] = 1;
         b["arrangement"]["interval_s"] = 1;
       }},
      {"/arrangement/exposure", "state what ends a visit",
       [](J&, J& b) { b["arrangement"]["exposure"] = J::object(); }},
      {"/arrangement/exposure/contact_s", "keep one of the two",
       [](J&, J& b) {
         b["arrangement"]["exposure"] = {{"strokes", 2}, {"contact_s", 2}};
       }},
      {"/arrangement/exposure/contact_s", "state a longer \"contact_s\"",
       [](J&, J& b) {
         b["arrangement"]["exposure"] = {{"contact_s", 0.5}};
       }},
      {"/arrangement/exposure/contact_s", "raise \"maximum_contact_s\"",
       [](J&, J& b) {
         b["arrangement"]["exposure"] = {{"contact_s", 5.9}};
       }},
      {"/arrangement/exposure/strokes", "state more strokes",
       [](J& p, J& b) {
         p["explorations"]["stroking"]["strokes"] = {{"minimum", 3}};
         b["arrangement"]["exposure"] = {{"strokes", 2}};
       }},
      {"/arrangement/exposure/strokes", "state fewer strokes",
       [](J& p, J& b) {
         p["explorations"]["stroking"]["strokes"] = {{"maximum", 4}};
         b["arrangement"]["exposure"] = {{"strokes", 4}};
       }},
      {"/question/asks_for", "where \"judgement\" is \"comparison\"",
       [](J&, J& b) { b["question"]["asks_for"] = "less"; }},
      {"/pause_between_surfaces_s", "applies only to surfaces in sequence",
       [](J&, J& b) {
         b["pause_between_surfaces_s"] = 1;
         b["arrangement"] = {{"surfaces", "on_request"}};
       }},
      {"/arrangement/gap_m", "where \"surfaces\" is \"side_by_side\"",
       [](J&, J& b) { b["arrangement"]["gap_m"] = 0.01; }},
      {"/arrangement/visits/maximum", "visits have no maximum",
       [](J&, J& b) {
         b["arrangement"] = {{"surfaces", "side_by_side"}, {"visits", {{"maximum", 2}}}};
       }},
      {"/arrangement/interval_s", "without an interval",
       [](J&, J& b) {
         b["arrangement"] = {{"surfaces", "side_by_side"}, {"interval_s", 1}};
       }},
      {"/arrangement/exposure", "divides the time",
       [](J&, J& b) {
         b["arrangement"] = {{"surfaces", "side_by_side"}, {"exposure", {{"strokes", 1}}}};
       }},
      {"/arrangement/gap_m", "the patches would be 5.0 mm wide",
       [](J&, J& b) {
         b["arrangement"] = {{"surfaces", "side_by_side"}, {"gap_m", 0.09}};
       }},
      {"/arrangement/phase", "felt at one place only",
       [](J& p, J& b) {
         p["surface"]["tiling"] = "bounded";
         b["arrangement"] = {{"phase", "drawn"}};
       }},
  };
  for (const RefusedArrangement& fault : faults) {
    SCOPED_TRACE(fault.message);
    ArrangedJson protocol = two_gratings({{"surfaces", "sequential"}});
    fault.change(protocol, protocol["blocks"]["pairs"]);
    EXPECT_THAT(test::problems_at(protocol, std::string("/blocks/pairs") + fault.pointer),
                HasSubstr(fault.message));
  }
}

TEST(ArrangementOfATrial, SideBySideHasNoScene) {
  ArrangedJson protocol = two_gratings({{"surfaces", "side_by_side"}});
  protocol["environment"] = {{"scene", {{"visual_texture", "off"}}}};
  EXPECT_THAT(test::problems_at(protocol, "/environment/scene"),
              HasSubstr("the scene shows one surface"));
}

TEST(RovingOfABlock, DrawsALevelForEveryPresentation) {
  ArrangedJson stated = two_gratings(nullptr);
  stated["blocks"]["pairs"]["repetitions"] = 30;
  stated["blocks"]["pairs"]["rove"] = {{"stiffness_N_per_m", {400, 500, 600}}};
  stated["stimuli"]["grating"]["material"] = {{"friction", 0.05}};
  const Protocol protocol = test::valid(stated);
  std::map<double, int> counts{};
  int different = 0;
  const Plan plan = make_plan(protocol, {1, 0});
  for (const Trial& trial : plan.trials) {
    for (const PlannedPresentation& planned : trial.presentations) {
      ++counts[planned.stimulus.material.stiffness_N_per_m];
      EXPECT_EQ(planned.stimulus.material.friction, 0.05) << "of the stimulus";
    }
    different += trial.presentations[0].stimulus.material.stiffness_N_per_m !=
                 trial.presentations[1].stimulus.material.stiffness_N_per_m;
    EXPECT_THAT(json_of(trial), HasSubstr("\"material\":{\"stiffness_N_per_m\":"));
  }
  ASSERT_EQ(counts.size(), 3U);
  for (const auto& [level, count] : counts) EXPECT_NEAR(count, 40, 17) << level;  // ±3.3 SD
  EXPECT_GT(different, 20) << "independent draws of the surfaces of a trial";
  for (const Trial& trial : possible_trials(protocol)) {
    EXPECT_EQ(trial.presentations[0].stimulus.material.stiffness_N_per_m, 600.0)
        << "devices are compared with the greatest";
  }
  stated["blocks"]["pairs"]["rove"] = {{"raised_m", {0, 0.001}}};
  stated["blocks"]["pairs"]["arrangement"] = {{"surfaces", "side_by_side"}};
  EXPECT_THAT(test::problems_at(stated, "/blocks/pairs/rove/raised_m"),
              HasSubstr("lie in one plane"));
}

}  // namespace
}  // namespace asperity
