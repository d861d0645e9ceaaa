// What a protocol file may say, and what the reader answers when it says something else.

#include "protocols/file/protocol_reader.h"

#include <algorithm>
#include <set>

#include "protocols/plan/plan.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

TEST(ProtocolReader, ReadsAMinimalSelection) {
  try {
    const Protocol protocol =
        read_protocol(test::example_selection(), "example.json", test::example_models());
    EXPECT_EQ(protocol.name, "example_selection");
    EXPECT_EQ(protocol.textures.at("stone").height_field, "stimuli/stone.png");
    EXPECT_EQ(protocol.blocks.at("main").presented.size(), 3U);
    const Plan plan = make_plan(protocol, {.seed = 1, .counterbalance_row = 0});
    EXPECT_EQ(plan.trials.size(), 6U);
  } catch (const ProtocolError& error) {
    FAIL() << error.what();
  }
}

TEST(ProtocolReader, ReadsTheConsequenceOfAVibration) {
  const auto rule_in = [](const std::string& instability) {
    std::string text = test::example_selection();
    text.insert(text.find("\"device\""), instability);
    return read_protocol(text, "example.json", test::example_models()).instability;
  };
  EXPECT_FALSE(rule_in(""));
  const auto flags = rule_in(R"("instability": {"buzz_max": 0.5}, )");
  EXPECT_EQ(flags.value().buzz_max, 0.5);
  EXPECT_EQ(flags->on, InstabilityRule::OnExcess::flag);
  const auto repeats = rule_in(R"("instability": {"buzz_max": 0.4, "on": "repeat_now"}, )");
  EXPECT_EQ(repeats.value().on, InstabilityRule::OnExcess::repeat_now);
}

Protocol with_environment(const std::string& environment) {
  std::string text = test::example_selection();
  text.insert(text.find("\"device\""), "\"environment\": " + environment + ", ");
  try {
    return read_protocol(text, "example.json", test::example_models());
  } catch (const ProtocolError& error) {
    ADD_FAILURE() << error.what();
    return {};
  }
}

TEST(ProtocolReader, ReadsWhatParticipantsSeeAndHear) {
  const Protocol protocol = with_environment(
      R"({"vision": "hand_occluded", "scene": {"visual_texture": "neutral"},
          "masking_noise": {"kind": "white", "level_dBA": 62.5},
          "speech": {"surface_1": "speech/a.wav", "question": "speech/which.wav"}})");
  EXPECT_EQ(protocol.vision, Vision::hand_occluded);
  EXPECT_EQ(protocol.scene, VisualTexture::neutral);
  EXPECT_EQ(protocol.masking_noise.kind, Protocol::Noise::Kind::white);
  EXPECT_EQ(protocol.masking_noise.level_dBA, 62.5);
  EXPECT_EQ(protocol.speech.at("question"), "speech/which.wav");
}

TEST(ProtocolReader, ShowsNoSceneAndPlaysNoNoiseUnlessAsked) {
  const Protocol protocol =
      read_protocol(test::example_selection(), "example.json", test::example_models());
  EXPECT_EQ(protocol.vision, Vision::free);
  EXPECT_FALSE(protocol.scene);
  EXPECT_EQ(protocol.masking_noise.kind, Protocol::Noise::Kind::none);
  EXPECT_FALSE(protocol.masking_noise.level_dBA);
  EXPECT_TRUE(protocol.speech.empty());
}

TEST(ProtocolReader, CountsRecordedSpeechAmongTheFilesOfAProtocol) {
  const Protocol protocol = with_environment(R"({"speech": {"surface_1": "speech/a.wav"}})");
  const std::vector<NamedFile> files = files_of(protocol, "example.json");
  ASSERT_EQ(files.size(), 5U);
  EXPECT_EQ(files.back().path, "speech/a.wav");
  EXPECT_EQ(files.back().kind, NamedFile::Kind::speech);
  EXPECT_EQ(files.back().place.pointer, "/environment/speech/surface_1");
}

TEST(ProtocolReader, ReadsBodiesAsMeshesAndShapes) {
  const Protocol protocol =
      read_protocol(test::example_bodies(), "bodies.json", test::example_models());
  ASSERT_EQ(protocol.bodies.size(), 4U);
  EXPECT_EQ(protocol.bodies.at("rasp").mesh, "stimuli/rasp.mesh");
  EXPECT_FALSE(protocol.bodies.at("rasp").shape);
  const auto* const plate = std::get_if<PlateShape>(&*protocol.bodies.at("plate").shape);
  ASSERT_NE(plate, nullptr);
  EXPECT_EQ(plate->size_m, glm::dvec3(0.08, 0.06, 0.01));
  const BodyDescription& roll = protocol.bodies.at("roll");
  const auto* const cylinder = std::get_if<CylinderShape>(&*roll.shape);
  ASSERT_NE(cylinder, nullptr);
  EXPECT_EQ(cylinder->diameter_m, 0.008);
  EXPECT_EQ(cylinder->length_m, 0.01);
  EXPECT_EQ(roll.axis, BodyAxis::x);
  EXPECT_EQ(roll.texture, "stone");
  EXPECT_EQ(protocol.bodies.at("ball").axis, BodyAxis::z);
  EXPECT_EQ(protocol.stimuli.at("felt").tool.factor, "held");
}

TEST(ProtocolReader, CountsTexturedMeshesAmongTheFilesOfAProtocol) {
  const Protocol protocol =
      read_protocol(test::example_bodies(), "bodies.json", test::example_models());
  const std::vector<NamedFile> files = files_of(protocol, "bodies.json");
  const auto mesh = std::find_if(files.begin(), files.end(), [](const NamedFile& file) {
    return file.kind == NamedFile::Kind::textured_mesh;
  });
  ASSERT_NE(mesh, files.end());
  EXPECT_EQ(mesh->path, "stimuli/rasp.mesh");
  EXPECT_EQ(mesh->place.pointer, "/bodies/rasp/mesh");
}

std::vector<ModelDeclaration> models_with_an_asset() {
  std::vector<ModelDeclaration> models = test::example_models();
  models[0].assets = {{"vibrations", "recorded accelerations"}};
  return models;
}

std::string with_assets(const std::string& of_metal, const std::string& of_stone) {
  std::string text = test::example_selection();
  for (const auto& [path, assets] :
       {std::pair("stimuli/metal.png", of_metal), std::pair("stimuli/stone.png", of_stone)}) {
    const std::string field = std::string("\"height_field\": \"") + path + '"';
    text.insert(text.find(field), assets);
  }
  return text;
}

TEST(ProtocolReader, ReadsTheAssetsThatModelsDeclare) {
  const Protocol protocol = read_protocol(
      with_assets(R"("assets": {"vibrations": "stimuli/metal.vib", "$comment": "of steel"}, )",
                  R"("assets": {"vibrations": "stimuli/stone.vib"}, )"),
      "example.json", models_with_an_asset());
  const std::vector<NamedFile> files = files_of(protocol, "example.json");
  ASSERT_EQ(files.size(), 6U);
  EXPECT_EQ(files[2].path, "stimuli/metal.vib");
  EXPECT_EQ(files[2].kind, NamedFile::Kind::asset);
  EXPECT_EQ(files[2].place.pointer, "/textures/metal/assets/vibrations");
  EXPECT_GT(files[2].place.line, 1);
  for (const Trial& trial : make_plan(protocol, {.seed = 1}).trials) {
    for (const PlannedPresentation& planned : trial.presentations) {
      const auto& path = planned.stimulus.declared_assets.at("vibrations");
      EXPECT_EQ(path, "stimuli/" + planned.stimulus.texture + ".vib");
      EXPECT_NE(json_of(trial).find(R"("assets":{"vibrations":")" + path + "\"}"),
                std::string::npos);
    }
  }
}

/// The problems of a protocol whose textures have these assets, each as its place and its message.
std::string problems_of_assets(const std::string& of_metal, const std::string& of_stone) {
  std::string said{};
  try {
    read_protocol(with_assets(of_metal, of_stone), "example.json", models_with_an_asset());
  } catch (const ProtocolError& error) {
    for (const Diagnostic& each : error.diagnostics()) {
      said += each.pointer + ": " + each.message.english() + '\n';
    }
  }
  return said;
}

TEST(ProtocolReader, RefusesAnAssetThatIsMissingUnknownOrOutsideTheStudy) {
  const std::string vibrations = R"("assets": {"vibrations": "stimuli/a.vib"}, )";
  EXPECT_EQ(problems_of_assets(vibrations, vibrations), "");
  EXPECT_EQ(problems_of_assets(vibrations, ""),
            "/factors/texture/levels/1: the model \"height_map\" needs the asset \"vibrations\" "
            "(recorded accelerations), which the texture \"stone\" does not have: add its file "
            "under \"assets\"\n");
  const std::string misspelt =
      R"("assets": {"vibrations": "stimuli/a.vib", "vibration": "b.vib"}, )";
  EXPECT_TRUE(problems_of_assets(vibrations, misspelt)
                  .starts_with("/textures/stone/assets/vibration: there is no role of an asset "
                               "\"vibration\"; did you mean \"vibrations\"?"))
      << problems_of_assets(vibrations, misspelt);
  EXPECT_NE(problems_of_assets(vibrations, R"("assets": {"vibrations": "../a.vib"}, )")
                .find("/textures/stone/assets/vibrations: "),
            std::string::npos);
}

// A force that comes late in every tick is another force.
TEST(ProtocolReader, RefusesAModelAboveTheRateAtWhichItKeepsItsPeriod) {
  std::vector<ModelDeclaration> models = test::example_models();
  const auto sinusoid = std::find_if(models.begin(), models.end(),
                                     [](const auto& each) { return each.id == "sinusoid"; });
  ASSERT_NE(sinusoid, models.end());
  sinusoid->maximum_rate_Hz = 1000.0;
  nlohmann::json file = nlohmann::json::parse(test::example_selection());
  file["device"]["rate_Hz"] = 1000;
  (void)test::valid(file, models);
  file["device"]["rate_Hz"] = 1001;
  EXPECT_EQ(test::problems_at(file, "/factors/model/levels/1", models),
            "a tick of the force model sinusoid takes longer than a period at the 1001 Hz of "
            "/device/rate_Hz: set it to at most 1000, or choose another model");
}

TEST(NamedFile, OfAHeightFieldIsTwoFiles) {
  const Protocol protocol =
      read_protocol(test::example_selection(), "example.json", test::example_models());
  const std::vector<NamedFile> files = files_of(protocol);
  ASSERT_EQ(files.size(), 4U);
  EXPECT_EQ(paths_of(files[0]),
            (std::vector<std::string>{"stimuli/metal.png", "stimuli/metal.png.json"}));
  EXPECT_EQ(paths_of(files[1]), std::vector<std::string>{"stimuli/metal_photo.png"});
}

TEST(SpeechCues, AreTextsThatTellThemApart) {
  const std::vector<std::string> cues = speech_cues();
  EXPECT_EQ(std::set<std::string>(cues.begin(), cues.end()).size(), cues.size());
  EXPECT_NE(std::find(cues.begin(), cues.end(), "option_26"), cues.end());
}

}  // namespace
}  // namespace asperity
