// The demo study: its tools are felt and recognised, and it asks no more than the simulated device can do.

#include "app/tasks/check_protocol.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "tests/app/demo_study.h"

#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/session/rehearsal/rehearsal.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/warnings/texture_warnings.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// The library protocol on the demonstration's files, with one short trial of its main block.
TEST_F(DemoStudy, HasToolsThatAreCheckedPlannedFeltAndAnswered) {
  const std::filesystem::path file = study / "protocols" / "tools_matching.json";
  const ModelRegistry models = built_in_models();
  const ProtocolCheck check = check_protocol(file, models, study, "simulated");
  EXPECT_THAT(check.diagnostics, IsEmpty());
  EXPECT_EQ(check.cost.contacts, 3 * check.cost.trials);
  const auto warnings_of = [&](const Protocol& rehearsed) {
    StimulusBuilder builder(models, study);
    const RehearsedStimuli found = rehearse_with_warnings({rehearsed, file.string()}, builder);
    EXPECT_THAT(found.problems, IsEmpty());
    return found.warnings;
  };
  EXPECT_THAT(warnings_of(*check.protocol), IsEmpty());

  auto protocol = nlohmann::ordered_json::parse(read_file(file));
  // Samples 100 µm apart are too few for its finest waves, eight times 74.75 µm.
  auto coarse = protocol;
  coarse["stimuli"]["tool_on_plate"].erase("parameters");
  write_file(file, coarse.dump(1), Overwrite::allow);
  const std::vector<Diagnostic> warnings = warnings_of(load_protocol(file, models, study));
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings[0].message.english(),
              HasSubstr("its shortest wavelength is 598 µm, and samples"));
  EXPECT_THAT(warnings[0].message.english(), HasSubstr("or a cell_m of 74 µm or less"));

  auto main = protocol["blocks"]["main"];
  main["repetitions"] = 1;
  main["positions"] = "shuffle";
  protocol["blocks"] = {{"main", main}};
  protocol["flow"] = nlohmann::ordered_json::array({{{"run", "main"}}});
  auto& stroking = protocol["explorations"]["stroking"];
  stroking["strokes"] = {{"target", 1}};
  stroking["minimum_contact_s"] = 0.3;
  write_file(file, protocol.dump(1), Overwrite::allow);
  SimulationInputs inputs{};
  inputs.protocols = {file};
  inputs.study = study;
  inputs.recordings = Recordings::none;
  EXPECT_EQ(simulate(inputs, models, {}, {}, {}).attempts, 1);
  const Study opened = Study::open(study, Access::read_only);
  const AttemptRow attempt = opened.attempts(opened.sessions().at(0).id).at(0);
  EXPECT_TRUE(attempt.valid) << attempt.invalid_reason.value_or("").text;
  std::set<std::string> tools{};
  for (const PresentationRow& felt : attempt.presentations) {
    tools.insert(asset_sha256(felt.assets, "tool").value_or(""));
    EXPECT_EQ(asset_sha256(felt.assets, "surface"),
              asset_sha256(attempt.presentations[0].assets, "surface"));
    EXPECT_GT(felt.achieved_texture_force_N.value_or(0.0), 0.01) << felt.item;
  }
  EXPECT_EQ(tools.size(), 3U);
  ASSERT_EQ(attempt.responses.size(), 3U);
  EXPECT_EQ(attempt.responses[0].source, "virtual");  // it was expected as it feels
}

// What device-test finds of the simulated device: friction and steps of nothing, the damping of the virtual hand.
TEST_F(DemoStudy, AsksNoMoreThanTheSimulatedDeviceCanDo) {
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, study);
  const auto item = [](const std::string& name, double value) {
    return DeviceItem{.name = name, .status = DeviceItem::Status::pass, .value = value};
  };
  DeviceProfile device{.name = "simulated",
                       .rate_Hz = 1000.0,
                       .workspace_minimum_m = glm::dvec3(-1.0),
                       .workspace_maximum_m = glm::dvec3(1.0),
                       .items = {item("friction_N", 0.0), item("force_resolution_N", 0.0),
                                 item("position_resolution_m", 1e-9), item("moving_mass_kg", 0.05),
                                 item("damping_N_s_per_m", 5.17)}};
  device.items.back().by_axis = {5.17, 5.17, 10.0};
  device.is_simulated = true;
  int compared = 0;
  for (const LibraryProtocol& library : library_protocols()) {
    const std::string name(library.name);
    if (!name.starts_with("chapter_") && name != "improved_selection_blindfold") continue;
    ++compared;
    const Protocol protocol = read_small_protocol(models, std::string(library.text));
    for (const RehearsalWarning& warning : rehearse_on_device(protocol, device, builder)) {
      ADD_FAILURE() << name << ": " << warning.text.english();
    }
  }
  EXPECT_EQ(compared, 4);
}

}  // namespace
}  // namespace asperity
