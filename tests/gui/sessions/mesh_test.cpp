// A study of a mesh in the windows: three point models and one of a plug-in on the same body.

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/exports/export_study.h"
#include "app/gui/base/settings.h"
#include "app/plugins/plugin_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/verify/verify_study.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::IsEmpty;

const std::set<std::string> kModelsOnTheMesh{"height_map", "sinusoid", "stochastic", "faulty"};

class MeshInWindows : public SessionRoom {
 protected:
  MeshInWindows() { remember_plugin_files({plugin_}); }

  /// A block of stone of 50 mm as a mesh, under four models.
  void make_mesh_study() {
    make_study();
    StoredTexturedMesh stone{};
    stone.mesh = placed(body_mesh(BoxShape{{0.05, 0.05, 0.02}}, nullptr), BodyRole::surface);
    save_textured_mesh(folder() / "stimuli" / "stone.mesh", stone, Overwrite::refuse);
    add_protocol({.trials = 1});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    json protocol = json::parse(std::ifstream(file));
    protocol["surface"] = {{"extent_m", {0.04, 0.03}}};
    protocol["bodies"] = {{"stone", {{"mesh", "stimuli/stone.mesh"}}}};
    protocol["factors"]["model"]["levels"] = kModelsOnTheMesh;
    protocol["stimuli"]["rendered"]["surface"] = "stone";
    protocol["explorations"]["short"]["stroke_length_m"] = {{"target", 0.02}};
    json presented = json::array();
    for (const std::string& model : kModelsOnTheMesh) {
      presented.push_back(
          {{"stimulus", "rendered"}, {"with", {{"texture", "slate"}, {"model", model}}}});
    }
    protocol["blocks"]["main"]["presented"] = presented;
    write_file(file, protocol.dump(1), Overwrite::allow);
  }

  /// The models of the presentations of a session that were touched.
  std::set<std::string> felt_models(const Study& study, std::int64_t session) const {
    std::set<std::string> felt{};
    for (const AttemptRow& attempt : study.attempts(session)) {
      for (const PresentationRow& surface : attempt.presentations) {
        if (surface.contact_s > 0.0) felt.insert(surface.model);
      }
    }
    return felt;
  }

  std::filesystem::path plugin_ = std::filesystem::path(ASPERITY_TEST_PLUGINS) / "faulty_none.so";
};

TEST_F(MeshInWindows, IsFeltWithEveryModelSimulatedVerifiedAndExported) {
  make_mesh_study();
  open();
  start("small");
  take_part(chooses_a());
  close_windows();
  const ModelRegistry models = models_with({plugin_});
  SimulationInputs inputs{};
  inputs.protocols = {folder() / "protocols" / "small.json"};
  inputs.study = folder();
  inputs.recordings = Recordings::all;
  EXPECT_EQ(simulate(inputs, models, {}, {}, {}).sessions, 1);

  Study study = Study::open(folder(), Access::read_only);
  const std::vector<SessionRow> sessions = study.sessions();
  ASSERT_EQ(sessions.size(), 2U);
  for (const SessionRow& session : sessions) {
    EXPECT_EQ(session.state, SessionState::completed);
    EXPECT_EQ(felt_models(study, session.id), kModelsOnTheMesh);
  }
  EXPECT_THAT(verify_study(study, models, true, {}, [](double) {}).problems, IsEmpty());
  EXPECT_FALSE(verify_study(study, built_in_models(), true, {}, [](double) {}).problems.empty())
      << "without the plug-in";

  const std::filesystem::path tables = home() / "tables";
  export_study(study, models, tables, {});
  std::set<std::string> plugins{};
  for (const auto& row : read_exported(tables / "presentations.tsv")) {
    if (row.at("model") == "faulty") plugins.insert(row.at("plugin_sha256"));
    EXPECT_EQ(row.at("model") == "faulty", row.at("plugin_sha256").size() == 64) << row.at("model");
  }
  EXPECT_EQ(plugins.size(), 1U);
}

}  // namespace
}  // namespace asperity
