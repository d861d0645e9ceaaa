// Point models on bodies in a study: checked, felt, stored, replayed.

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/stimulus_builder.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/verify/verify_study.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "app/tasks/warnings/stimulus_examination.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/app/protocol_in_study.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// One trial: a texture on a plane, on a sphere and on a mesh.
constexpr const char* kProtocolOfShapes = R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "shapes",
  "version": "1.0.0",
  "title": "On which shape is the texture the roughest?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "surface": {"extent_m": [0.04, 0.03]},
  "textures": {"grain": {"height_field": "stimuli/grain.png"}},
  "factors": {"shape": {"levels": ["globe", "stone"]}},
  "bodies": {
    "globe": {"shape": "sphere", "diameter_m": 0.08},
    "stone": {"mesh": "stimuli/stone.mesh"}
  },
  "stimuli": {
    "flat": {"model": "height_map", "texture": "grain"},
    "curved": {"model": "height_map", "texture": "grain", "surface": {"factor": "shape"}}
  },
  "explorations": {
    "short": {"stroke_length_m": {"target": 0.02}, "speed_m_per_s": {"target": 0.04},
              "minimum_contact_s": 0.3, "maximum_contact_s": 2}
  },
  "blocks": {
    "main": {
      "presented": [
        {"stimulus": "flat", "item": "flat"},
        {"stimulus": "curved", "with": {"shape": "globe"}, "item": "globe"},
        {"stimulus": "curved", "with": {"shape": "stone"}, "item": "stone"}
      ],
      "question": {"name": "roughest", "prompt": "Which surface felt the roughest?"},
      "exploration": "short"
    }
  },
  "flow": [{"run": "main"}]
})";

void save_stone(const std::filesystem::path& study, double size_m) {
  StoredTexturedMesh stored{};
  stored.mesh =
      placed(body_mesh(BoxShape{{size_m, size_m, 0.4 * size_m}}, nullptr), BodyRole::surface);
  save_textured_mesh(study / "stimuli" / "stone.mesh", stored, Overwrite::allow);
}

class PointsOnBodies : public ProtocolInStudy {
 protected:
  PointsOnBodies() : ProtocolInStudy("shapes.json") {
    make_small_study(study_);
    save_stone(study_, 0.05);
    write_file(protocol_, kProtocolOfShapes, Overwrite::refuse);
  }
};

TEST_F(PointsOnBodies, AreCheckedWithTheirFiles) {
  EXPECT_THAT(problems(), IsEmpty());
  std::filesystem::remove(study_ / "stimuli" / "stone.mesh");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/bodies/stone/mesh");
}

TEST_F(PointsOnBodies, AreNotShownWithATextureThatIsNotTheirs) {
  replace_in_protocol(
      R"("surface": {"extent_m")",
      R"("environment": {"scene": {"visual_texture": "on"}}, "surface": {"extent_m")");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/environment/scene");
  replace_in_protocol(R"("visual_texture": "on")", R"("visual_texture": "off")");
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(PointsOnBodies, WhoseBodyLiesNowhereUnderTheHandAreRefusedBeforeASession) {
  save_stone(study_, 0.004);
  StimulusBuilder builder(models_, study_);
  const std::vector<Diagnostic> found =
      rehearse({load_protocol(protocol_, models_, study_), protocol_.string()}, builder);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].pointer, "/bodies/stone");
  EXPECT_THAT(found[0].message.english(),
              HasSubstr("no part of the surface \"stone\" (stimuli/stone.mesh) lies under the path "
                        "of the hand"));
  EXPECT_THAT(found[0].message.english(), HasSubstr("the strokes extend beyond the surface"));
}

// The plane cannot exert 2 N; this is not examined where a session would fail anyway.
TEST_F(PointsOnBodies, AreExaminedNoFurtherWhereTheHandWouldMissThem) {
  replace_in_protocol(R"("speed_m_per_s": {"target": 0.04})",
                      R"("speed_m_per_s": {"target": 0.04}, "normal_force_N": {"target": 2})");
  const auto examined = [this] {
    StimulusBuilder builder(models_, study_);
    return examine_stimuli({load_protocol(protocol_, models_, study_), protocol_.string()}, study_,
                           builder);
  };
  const auto says =
      Contains(Field(&Diagnostic::message,
                     testing::Property(&Phrase::english, HasSubstr("exerts at most 1.50 N"))));
  StimulusExamination found = examined();
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.warnings, says);
  save_stone(study_, 0.004);
  found = examined();
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].pointer, "/bodies/stone");
  EXPECT_THAT(found.warnings, Not(says));
}

TEST_F(PointsOnBodies, HaveTheMeshOfTheirBodyAndTheirOwnTexture) {
  StimulusBuilder builder(models_, study_);
  const Protocol protocol = load_protocol(protocol_, models_, study_);
  const std::vector<Trial> trials = possible_trials(protocol);
  const auto& planned = trials.at(0).presentations;
  const PreparedStimulus flat = builder.unmatched(planned.at(0).stimulus);
  const PreparedStimulus globe = builder.unmatched(planned.at(1).stimulus);
  EXPECT_EQ(flat.inputs.body, nullptr);
  ASSERT_NE(globe.inputs.body, nullptr);
  EXPECT_EQ(globe.inputs.height_field, flat.inputs.height_field);
  // The relief is the model's: the sphere under it is smooth.
  EXPECT_FALSE(planned.at(1).stimulus.surface->height_field.has_value());
  // Prepared once for all presentations.
  EXPECT_EQ(builder.unmatched(planned.at(1).stimulus).inputs.body, globe.inputs.body);
}

TEST_F(PointsOnBodies, AreFeltStoredAndReplayed) {
  SimulationInputs inputs{};
  inputs.protocols = {protocol_};
  inputs.study = study_;
  inputs.recordings = Recordings::all;
  EXPECT_EQ(simulate(inputs, models_, {}, {}, {}).sessions, 1);
  Study opened = Study::open(study_, Access::read_only);
  const SessionRow session = opened.sessions().at(0);
  EXPECT_EQ(session.state, SessionState::completed);
  const std::vector<AttemptRow> attempts = opened.attempts(session.id);
  ASSERT_EQ(attempts.size(), 1U);
  ASSERT_EQ(attempts[0].presentations.size(), 3U);
  for (const PresentationRow& felt : attempts[0].presentations) {
    EXPECT_GE(felt.contact_s, 0.3) << felt.item;
    std::vector<std::string> roles{};
    for (const AssetRow& asset : felt.assets) roles.push_back(asset.role);
    if (felt.item == "flat") {
      EXPECT_THAT(roles, ElementsAre("height_field"));
    } else {
      EXPECT_THAT(roles, ElementsAre("height_field", "surface"));
    }
    if (felt.item == "stone") {
      EXPECT_EQ(felt.assets.at(1).sha256, sha256_of(read_file(study_ / "stimuli" / "stone.mesh")));
    }
  }
  EXPECT_THAT(verify_study(opened, models_, true, {}, [](double) {}).problems, IsEmpty());
}

}  // namespace
}  // namespace asperity
