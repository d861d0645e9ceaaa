// Models with two bodies in a study: checked, felt, stored, replayed, exported.

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/exports/export_study.h"
#include "app/records/session_conditions.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/verify/verify_study.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "app/tasks/warnings/texture_warnings.h"
#include "renderers/built_in_models.h"
#include "renderers/compute/compute_device.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/app/protocol_in_study.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// One trial: a ball, a rough roll and a mesh, each on the same rough plate.
constexpr const char* kProtocol = R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "tools",
  "version": "1.0.0",
  "title": "Which tool is the roughest?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "surface": {"extent_m": [0.04, 0.02]},
  "textures": {"grain": {"height_field": "stimuli/grain.png"}},
  "factors": {"held": {"levels": ["ball", "roll", "rasp"]}},
  "bodies": {
    "plate": {"shape": "plate", "size_m": [0.04, 0.02, 0.01]},
    "ball": {"shape": "sphere", "diameter_m": 0.006},
    "roll": {"shape": "cylinder", "diameter_m": 0.006, "length_m": 0.004, "axis": "y", "texture": "grain"},
    "rasp": {"mesh": "stimuli/rasp.mesh"}
  },
  "stimuli": {
    "felt": {"model": "pd_gradient", "texture": "grain", "surface": "plate", "tool": {"factor": "held"}}
  },
  "explorations": {
    "short": {"stroke_length_m": {"target": 0.02}, "speed_m_per_s": {"target": 0.04},
              "minimum_contact_s": 0.3, "maximum_contact_s": 2}
  },
  "blocks": {
    "main": {
      "presented": [
        {"stimulus": "felt", "with": {"held": "ball"}, "item": "ball"},
        {"stimulus": "felt", "with": {"held": "roll"}, "item": "roll"},
        {"stimulus": "felt", "with": {"held": "rasp"}, "item": "rasp"}
      ],
      "question": {"name": "roughest", "prompt": "Which tool felt the roughest?"},
      "exploration": "short"
    }
  },
  "flow": [{"run": "main"}]
})";

constexpr double kRasp_m = 0.004;

/// A box that was baked elsewhere: its lowest side is the tip.
void save_rasp(const std::filesystem::path& study, double size_m) {
  StoredTexturedMesh stored{};
  stored.mesh = placed(body_mesh(BoxShape{{size_m, size_m, size_m}}, nullptr), BodyRole::tool);
  save_textured_mesh(study / "stimuli" / "rasp.mesh", stored, Overwrite::allow);
}

void make_study(const std::filesystem::path& study) {
  make_small_study(study);
  save_rasp(study, kRasp_m);
  write_file(study / "protocols" / "tools.json", kProtocol, Overwrite::refuse);
}

class Bodies : public ProtocolInStudy {
 protected:
  Bodies() : ProtocolInStudy("tools.json") { make_study(study_); }

  /// The ball and the roll.
  void leave_out_the_rasp() {
    replace_in_protocol(R"(,
        {"stimulus": "felt", "with": {"held": "rasp"}, "item": "rasp"})",
                        "");
    replace_in_protocol(R"("ball", "roll", "rasp"])", R"("ball", "roll"])");
  }
};

TEST_F(Bodies, AreCheckedWithTheirFiles) {
  EXPECT_THAT(problems(), IsEmpty());
  std::filesystem::remove(study_ / "stimuli" / "rasp.mesh");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/bodies/rasp/mesh");
  EXPECT_THAT(problems()[0].message.english(), HasSubstr("stimuli/rasp.mesh is not in the study"));
}

TEST_F(Bodies, ADamagedMeshIsRefused) {
  const std::filesystem::path file = study_ / "stimuli" / "rasp.mesh";
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_file(file, bytes, Overwrite::allow);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/bodies/rasp/mesh");
  EXPECT_THAT(problems()[0].message.english(), HasSubstr("rasp.mesh"));
  write_file(file, "a list of groceries\n", Overwrite::allow);
  EXPECT_EQ(problems().size(), 1U);
}

TEST_F(Bodies, AReliefThatIsTooFineForItsShapeIsRefused) {
  // Texels of 20 mm/128/4 = 39 µm on 1 m²: 6.6·10⁸.
  replace_in_protocol("[0.04, 0.02, 0.01]", "[1, 1, 0.01]");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/bodies/plate");
  EXPECT_THAT(problems()[0].message.english(), HasSubstr("use a smaller shape"));
}

TEST_F(Bodies, WithAStepOfThreeCellsAreRefusedWithWhatWouldBeRight) {
  replace_in_protocol(R"("model": "pd_gradient",)",
                      R"("model": "pd_gradient", "parameters": {"step_m": 0.0003},)");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/stimuli/felt/parameters/step_m");
  EXPECT_EQ(problems()[0].message.english(),
            "step_m is 3e-04 and cell_m 1e-04; step_m must be 1, 2, 4 or 8 times cell_m, "
            "here 1e-04, 2e-04, 4e-04 or 8e-04.");
  replace_in_protocol(R"("step_m": 0.0003)", R"("step_m": 0.0003, "maximum": "smooth")");
  EXPECT_THAT(problems(), IsEmpty());
  replace_in_protocol(R"("step_m": 0.0003, "maximum": "smooth")",
                      R"("step_m": 0.0008, "most_samples": 128)");
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/stimuli/felt/parameters/most_samples");
  EXPECT_THAT(problems()[0].message.english(), HasSubstr("at least 256"));
}

// A texture of more columns than a renderer can address: nothing but building one tells.
TEST_F(Bodies, ThatNoRendererTakesAreRefusedBeforeASession) {
  StoredTexturedMesh stored{};
  stored.mesh = placed(body_mesh(BoxShape{{kRasp_m, kRasp_m, kRasp_m}}, nullptr), BodyRole::tool);
  DisplacementAtlas& atlas = stored.mesh.atlas;
  atlas = {.rows = atlas.rows,
           .columns = 32001,
           .step_m = atlas.step_m,
           .values = std::vector<std::int16_t>(atlas.rows * 32001)};
  save_textured_mesh(study_ / "stimuli" / "rasp.mesh", stored, Overwrite::allow);
  StimulusBuilder builder(models_, study_);
  try {
    load_protocol_to_run(protocol_, study_, builder);
    FAIL() << "it was not refused";
  } catch (const ProtocolError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].pointer, "/stimuli/felt");
    EXPECT_GT(error.diagnostics()[0].line, 1);
    EXPECT_THAT(error.diagnostics()[0].message.english(),
                HasSubstr("\"felt_grain_pd_gradient_rasp\""));
    EXPECT_THAT(error.diagnostics()[0].message.english(),
                HasSubstr("at most 32000 per side. Use a smaller shape"));
  }
}

// Strokes are 20 mm long: the hand comes down 10 mm beside the middle of the surface.
TEST_F(Bodies, WhoseSurfaceLiesNowhereUnderTheToolAreRefusedBeforeASession) {
  replace_in_protocol(R"({"shape": "plate", "size_m": [0.04, 0.02, 0.01]})",
                      R"({"mesh": "stimuli/cube.mesh"})");
  const auto cube = [](double size_m) {
    return body_mesh(BoxShape{{size_m, size_m, size_m}}, nullptr);
  };
  const auto refusals = [this](const TexturedMesh& mesh) {
    StoredTexturedMesh stored{};
    stored.mesh = mesh;
    save_textured_mesh(study_ / "stimuli" / "cube.mesh", stored, Overwrite::allow);
    EXPECT_THAT(problems(), IsEmpty());  // the files are as they should be
    StimulusBuilder builder(models_, study_);
    return rehearse({load_protocol(protocol_, models_, study_), protocol_.string()}, builder);
  };
  const std::vector<Diagnostic> of_a_tool = refusals(placed(cube(0.004), BodyRole::tool));
  ASSERT_EQ(of_a_tool.size(), 1U);
  EXPECT_EQ(of_a_tool[0].pointer, "/bodies/plate");
  EXPECT_GT(of_a_tool[0].line, 1);
  for (const char* said :
       {"no part of the surface \"plate\" (stimuli/cube.mesh) lies", "the tool \"ball\"",
        "10.0 mm from the middle", "x -2.0 to 2.0 mm", "z 0.0 to 4.0 mm",
        "again with `--for surface`", "the strokes extend beyond the surface"}) {
    EXPECT_THAT(of_a_tool[0].message.english(), HasSubstr(said));
  }
  SimulationInputs inputs{};
  inputs.protocols = {protocol_};
  inputs.study = study_;
  EXPECT_THROW(simulate(inputs, models_, {}, {}, {}), ProtocolError);  // before anybody sits there

  const std::vector<Diagnostic> of_a_short_one = refusals(placed(cube(0.004), BodyRole::surface));
  ASSERT_EQ(of_a_short_one.size(), 1U);
  EXPECT_THAT(of_a_short_one[0].message.english(),
              HasSubstr("the strokes extend beyond the surface"));
  EXPECT_THAT(of_a_short_one[0].message.english(), testing::Not(HasSubstr("--for surface")));
  EXPECT_THAT(refusals(placed(cube(0.04), BodyRole::surface)), IsEmpty());
  // About its middle: from 30 mm above the plane to where no hand goes.
  const std::vector<Diagnostic> of_its_own_frame = refusals(cube(0.06));
  ASSERT_EQ(of_its_own_frame.size(), 1U);
  EXPECT_THAT(of_its_own_frame[0].message.english(),
              HasSubstr("the tool \"ball\" begins inside the surface \"plate\""));
  EXPECT_THAT(of_its_own_frame[0].message.english(),
              HasSubstr("the highest point of a surface must lie in that plane"));
}

/// A wave of 1.6 mm, 0.2 mm high, on a tile of that width, in the place of the grain.
void save_wave(const std::filesystem::path& study, double width_m) {
  const ParameterValues values{{"spacing_m", 0.0016}, {"amplitude_m", 1e-4}};
  const SurfaceCanvas canvas{.width_m = width_m, .pixels = 160};
  save_height_field(study / "stimuli" / "grain.png", make_surface("sinusoid", values, canvas),
                    {.kind = "sinusoid", .parameters = values}, Overwrite::allow);
}

// The checklist rehearses every stimulus; the session after it does not, unless something has changed.
TEST_F(Bodies, AreRehearsedOnceForChecklistAndSession) {
  leave_out_the_rasp();
  ModelRegistry counting{};
  int made = 0;
  for (const ForceModel& model : models_.models()) {
    ForceModel counted = model;
    counted.make = [&made, make = model.make](const RendererInputs& inputs) {
      ++made;
      return make(inputs);
    };
    counting.add(counted);
  }
  RehearsalMemory memory{};
  const auto load = [&](RehearsalMemory* with) {
    StimulusBuilder builder(counting, study_);
    made = 0;
    load_protocol_to_run(protocol_, study_, builder, with);
    return made;
  };
  EXPECT_GT(load(&memory), 0);
  EXPECT_EQ(load(&memory), 0);
  EXPECT_GT(load(nullptr), 0);
  replace_in_protocol(R"("stimuli": {)", R"("stimuli": {"$comment": "another text",)");
  EXPECT_GT(load(&memory), 0);
  EXPECT_EQ(load(&memory), 0);
  save_wave(study_, 0.016);
  EXPECT_GT(load(&memory), 0) << "a file is another one";
}

// Ten whole waves are rendered as they are; of 12.5 the step at the seam counts as the texture's finest
// waves, which no sample of a contact holds, wherever the hand is.
TEST_F(Bodies, WithATileThatDoesNotCloseGiveAWarningWithBothNumbersAndTheRemedy) {
  replace_in_protocol(R"(, "texture": "grain")", "");  // of the roll
  const auto warnings = [this] {
    StimulusBuilder builder(models_, study_);
    const Protocol protocol = load_protocol(protocol_, models_, study_);
    const CheckedProtocol checked(protocol, protocol_.string());
    RehearsedStimuli found = rehearse_with_warnings(checked, builder);
    EXPECT_THAT(found.problems, IsEmpty());
    for (Diagnostic& warning : warnings_about_textures(checked, study_)) {
      found.warnings.push_back(std::move(warning));
    }
    return found.warnings;
  };
  save_wave(study_, 0.016);
  EXPECT_THAT(warnings(), IsEmpty());

  save_wave(study_, 0.02);
  const std::vector<Diagnostic> found = warnings();
  ASSERT_EQ(found.size(), 4U);  // each tool, and the texture
  EXPECT_EQ(found[0].pointer, "/stimuli/felt");
  for (const char* said :
       {"the stimulus \"felt_grain_pd_gradient_ball\" with the texture \"grain\" "
        "(stimuli/grain.png)",
        "under the tool \"ball\"", "the assumption fine_detail of pd_gradient (ticks of contact: ",
        "samples of 100 µm (cell_m) represent wavelengths of 800 µm and longer", "a cell_m of"}) {
    EXPECT_THAT(found[0].message.english(), HasSubstr(said));
  }
  EXPECT_EQ(found[3].pointer, "/textures/grain");
  EXPECT_THAT(
      found[3].message.english(),
      HasSubstr(
          "used in \"felt_grain_pd_gradient_ball\", \"felt_grain_pd_gradient_rasp\", "
          "\"felt_grain_pd_gradient_roll\": 0.02 m along x contain 12.5 spacings of 0.0016 m"));
  EXPECT_THAT(found[3].message.english(), HasSubstr("0.0192 m or 0.0208 m"));

  // On a plate that shows less than one tile there is no seam to feel.
  replace_in_protocol("[0.04, 0.02, 0.01]", "[0.0198, 0.0198, 0.01]");
  replace_in_protocol(R"("target": 0.02})", R"("target": 0.01})");
  EXPECT_THAT(warnings(), IsEmpty());
}

TEST_F(Bodies, WhoseTextureHasAnotherSpacingThanItsFileGiveAWarning) {
  save_wave(study_, 0.016);
  const auto said = [this] {
    std::string all{};
    for (const Diagnostic& warning : warnings_about_textures(
             {load_protocol(protocol_, models_, study_), protocol_.string()}, study_)) {
      all += warning.pointer + ' ' + warning.message.english() + '\n';
    }
    return all;
  };
  replace_in_protocol(R"("stimuli/grain.png"})", R"("stimuli/grain.png", "spacing_m": 0.0016})");
  EXPECT_EQ(said(), "");
  replace_in_protocol(R"("spacing_m": 0.0016)", R"("spacing_m": 0.003)");
  EXPECT_THAT(said(), HasSubstr("/textures/grain/spacing_m the texture \"grain\""));
  EXPECT_THAT(said(),
              HasSubstr("a spacing of 0.003 m, but according to its sidecar the file was "
                        "made with 0.0016 m; use a \"spacing_m\" of 0.0016 or another file"));
}

TEST_F(Bodies, OfTheSameMakingAreOneMeshAndOthersAreNot) {
  StimulusBuilder builder(models_, study_);
  BodyDescription ball{.name = "one", .shape = SphereShape{.diameter_m = 0.006}};
  const LoadedBody first = builder.body(ball, BodyRole::tool);
  ball.name = "another";
  EXPECT_EQ(builder.body(ball, BodyRole::tool).mesh, first.mesh);
  EXPECT_NE(builder.body(ball, BodyRole::surface).sha256, first.sha256);
  ball.axis = BodyAxis::x;
  EXPECT_NE(builder.body(ball, BodyRole::tool).sha256, first.sha256);
  ball.axis = BodyAxis::z;
  ball.height_field = "stimuli/grain.png";
  EXPECT_NE(builder.body(ball, BodyRole::tool).sha256, first.sha256);
  // As docs/formats/study.md has it.
  EXPECT_EQ(first.sha256,
            sha256_of(R"({"format":"asperity.shaped_body/1","role":"tool","shape":"sphere",)"
                      R"("diameter_m":0.006,"axis":"z","height_field_sha256":null})"));
  const LoadedBody rasp = builder.body({.mesh = "stimuli/rasp.mesh"}, BodyRole::tool);
  EXPECT_EQ(rasp.sha256, sha256_of(read_file(study_ / "stimuli" / "rasp.mesh")));
}

TEST_F(Bodies, AreListedAmongTheStimuli) {
  write_file(study_ / "stimuli" / "torn.mesh", "a list of groceries\n", Overwrite::refuse);
  std::map<std::size_t, std::shared_ptr<const TexturedMesh>> bodies{};
  const auto stimuli =
      stimulus_overviews(study_, models_, 32, {},
                         [&bodies](std::size_t place, const auto& body) { bodies[place] = body; });
  const auto surfaces = std::count_if(stimuli.begin(), stimuli.end(), [](const auto& each) {
    return each.kind != StimulusOverview::Kind::picture;
  });
  EXPECT_EQ(count_stimuli(study_, models_), surfaces);
  const auto named = [&stimuli](const std::string& path) {
    const auto found = std::find_if(stimuli.begin(), stimuli.end(),
                                    [&path](const auto& each) { return each.path == path; });
    return found == stimuli.end() ? StimulusOverview{} : *found;
  };
  const StimulusOverview rasp = named("stimuli/rasp.mesh");
  EXPECT_EQ(rasp.kind, StimulusOverview::Kind::textured_mesh);
  EXPECT_GT(rasp.triangles, 11U);
  EXPECT_NEAR(rasp.size_m.y, kRasp_m, 1e-12);
  EXPECT_THAT(rasp.used_by, ElementsAre("tools"));
  const StimulusOverview roll = named("tools/roll");
  EXPECT_EQ(roll.kind, StimulusOverview::Kind::shape);
  EXPECT_TRUE(std::holds_alternative<CylinderShape>(roll.shape.value()));
  EXPECT_NEAR(roll.size_m.y, 0.004, 1e-12);  // along its axis
  EXPECT_THAT(roll.used_by, ElementsAre("tools"));
  EXPECT_THAT(named("stimuli/torn.mesh").problem.english(), HasSubstr("torn.mesh"));
  EXPECT_GT(named("tools/ball").triangles, 100U);
  // Each was seen once, at its place.
  EXPECT_EQ(bodies.size(), 4U);
  for (const auto& [place, body] : bodies) {
    EXPECT_EQ(stimuli.at(place).triangles, body->triangles.size());
    EXPECT_EQ(stimuli.at(place).columns, body->atlas.columns);
  }
}

/// The study after one virtual participant, the same for all tests that only look at it.
class FeltBodies : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    make_study(study());
    SimulationInputs inputs{};
    inputs.protocols = {study() / "protocols" / "tools.json"};
    inputs.study = study();
    inputs.recordings = Recordings::all;
    EXPECT_EQ(simulate(inputs, built_in_models(), {}, {}, {}).sessions, 1);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::filesystem::path study() { return folder_->path() / "study"; }
  static std::vector<std::string> found_by_replay() {
    Study opened = Study::open(study(), Access::read_only);
    return verify_study(opened, built_in_models(), true, {}, [](double) {}).problems;
  }

 private:
  static inline std::unique_ptr<TemporaryFolder> folder_{};
};

TEST_F(FeltBodies, AreStoredWithWhatTheModelCounted) {
  const Study opened = Study::open(study(), Access::read_only);
  const SessionRow session = opened.sessions().at(0);
  EXPECT_EQ(session.state, SessionState::completed);
  EXPECT_TRUE(std::any_of(session.files.begin(), session.files.end(),
                          [](const auto& file) { return file.path == "stimuli/rasp.mesh"; }));
  const std::vector<AttemptRow> attempts = opened.attempts(session.id);
  ASSERT_EQ(attempts.size(), 1U);
  ASSERT_EQ(attempts[0].presentations.size(), 3U);
  std::set<std::string> tools{};
  for (const PresentationRow& felt : attempts[0].presentations) {
    EXPECT_GE(felt.contact_s, 0.3) << felt.item;
    std::vector<std::string> roles{};
    for (const AssetRow& asset : felt.assets) roles.push_back(asset.role);
    ASSERT_THAT(roles, ElementsAre("height_field", "surface", "tool"));
    EXPECT_EQ(felt.assets[1], attempts[0].presentations[0].assets.at(1));
    tools.insert(felt.assets[2].sha256);
    std::vector<std::string> kinds{};
    for (const ModelLimitRow& limit : felt.limits) kinds.push_back(limit.kind);
    ASSERT_THAT(kinds,
                ElementsAre("coarse_window", "contact", "fast", "fine_detail", "folded", "kept",
                            "left_out", "too_deep", "wholly_inside", "window_border"));
    // It was touched for at least 0.3 s at 1 kHz.
    EXPECT_GE(felt.limits[1].ticks, 300);
  }
  EXPECT_EQ(tools.size(), 3U);
}

TEST_F(FeltBodies, GiveTheRecordedHandTheRecordedForceUnlessOneWasExchanged) {
  EXPECT_THAT(found_by_replay(), IsEmpty());
  save_rasp(study(), 0.005);
  EXPECT_THAT(found_by_replay(),
              testing::Contains(HasSubstr("the tool, file stimuli/rasp.mesh, differs from the one "
                                          "that was presented (its SHA-256 differs)")));
  save_rasp(study(), kRasp_m);
}

TEST_F(FeltBodies, DifferWithARemarkAndNoProblemInAnotherVersionOfTheModel) {
  const ModelRegistry built_in = built_in_models();
  ForceModel model = *built_in.find("pd_gradient");
  const std::string recorded = model.declaration.version;
  model.make = [make = model.make](RendererInputs inputs) {
    inputs.parameters["texture_gain"] = 1.2;
    return make(inputs);
  };
  const auto verified = [&model] {
    ModelRegistry models = built_in_models();
    models.replace(model);
    Study opened = Study::open(study(), Access::read_only);
    return verify_study(opened, models, true, {}, [](double) {});
  };
  EXPECT_THAT(verified().problems, testing::Contains(HasSubstr("does not reproduce")));
  model.declaration.version = "1000";
  const VerifyResult result = verified();
  EXPECT_THAT(result.problems, IsEmpty());
  EXPECT_THAT(result.remarks,
              testing::Contains(testing::MatchesRegex(
                  "forces of pd_gradient that were recorded with its version " + recorded +
                  " and replayed with version 1000 differ by up to .* N")));
}

TEST_F(FeltBodies, AreColumnsOfAnExport) {
  const Study opened = Study::open(study(), Access::read_only);
  const TemporaryFolder folder{};
  ExportOptions tables{};
  tables.formats = {};
  export_study(opened, built_in_models(), folder.path() / "out", tables);
  const auto columns =
      read_tsv(read_file(folder.path() / "out" / "presentations.tsv"), "presentations").columns;
  for (const char* name : {"surface_sha256", "tool_sha256", "limit_contact_ticks",
                           "limit_fast_ticks", "parameter_coupling"}) {
    EXPECT_NE(std::find(columns.begin(), columns.end(), name), columns.end()) << name;
  }
}

// On the driver that the tests install, which computes on the processor.
TEST_F(Bodies, AreComputedOnTheDeviceThatTheProtocolAsksFor) {
  replace_in_protocol(R"("consent")", R"("device": {"compute": "gpu"}, "consent")");
  // The smooth maximum has no differences, which take most of the time of this driver.
  replace_in_protocol(R"("model": "pd_gradient",)",
                      R"("model": "pd_gradient", "parameters": {"maximum": "smooth"},)");
  replace_in_protocol(R"("minimum_contact_s": 0.3, "maximum_contact_s": 2)",
                      R"("minimum_contact_s": 0.05, "maximum_contact_s": 0.1)");
  replace_in_protocol(R"({"target": 0.02})", R"({"target": 0.005})");
  leave_out_the_rasp();
  EXPECT_THAT(problems(), IsEmpty());
  SimulationInputs inputs{.protocols = {"tools.json"}, .study = study_};
  EXPECT_EQ(simulate(inputs, models_, {}, {}, {}).attempts, 1);
  Study opened = Study::open(study_, Access::read_only);
  const std::string device = described(ComputeDevice::all().front().name());
  const SessionRow session = opened.sessions().at(0);
  EXPECT_EQ(recorded_stretches(session, opened.events(session.id), opened.attempts(session.id))
                .at(0)
                .program.compute,
            device);
  const VerifyResult verified = verify_study(opened, models_, true, {}, [](double) {});
  EXPECT_THAT(verified.problems, IsEmpty());
  EXPECT_THAT(verified.remarks, IsEmpty());
  EXPECT_THAT(verified.rules, ElementsAre("same program and system: compared bit for bit"));
}

}  // namespace
}  // namespace asperity
