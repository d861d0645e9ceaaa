// A force model with a file of its own: declared once, and then checked, hashed, stored, replayed and exported.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/exports/export_study.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/verify/verify_study.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/tables/table.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kFile = "stimuli/grain.wave";
constexpr const char* kContent = "2e-4\n";

/// The loader: all that the model adds to its law and its declaration.
double amplitude_in(const std::string& content) {
  const std::optional<double> amplitude_m =
      content.empty() ? std::nullopt : number_in(content.substr(0, content.size() - 1));
  if (!amplitude_m) throw std::invalid_argument("a wave is one number, its amplitude in metres");
  return *amplitude_m;
}

/// The built-in models and "measured", a sinusoid whose amplitude is in a file. Its parameter switches the wave off.
ModelRegistry models_with_one_of_a_file() {
  ModelRegistry models = built_in_models();
  ForceModel measured = *models.find("sinusoid");
  measured.declaration.id = "measured";
  measured.declaration.assets = {{"wave", "a measured amplitude"}};
  measured.suggested_by = {};
  measured.make = [sinusoid = measured.make](const RendererInputs& inputs) {
    RendererInputs own = inputs;
    const double amplitude_m = amplitude_in(*inputs.assets.at("wave"));
    if (number_of(inputs.parameters, "amplitude_m") > 0.0)
      own.parameters["amplitude_m"] = amplitude_m;
    return sinusoid(own);
  };
  models.add(std::move(measured));
  return models;
}

class AssetOfAModel : public testing::Test {
 protected:
  AssetOfAModel() {
    make_small_study(study_);
    write_file(study_ / kFile, kContent, Overwrite::refuse);
    std::string text = small_protocol();
    const auto replace_all = [&text](const std::string& from, const std::string& to) {
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
      }
    };
    replace_all("stochastic", "measured");
    replace_all(R"("height_field":)",
                R"("assets": {"wave": "stimuli/grain.wave"}, "height_field":)");
    write_file(protocol_, text, Overwrite::refuse);
  }

  std::vector<Diagnostic> problems() const {
    return check_protocol(protocol_, models_, study_, {}).diagnostics;
  }
  void simulate_one() const {
    SimulationInputs inputs{};
    inputs.protocols = {protocol_};
    inputs.study = study_;
    inputs.recordings = Recordings::all;
    EXPECT_EQ(simulate(inputs, models_, {}, {}, {}).sessions, 1);
  }
  std::vector<std::string> found_by_verify() const {
    Study opened = Study::open(study_, Access::read_only);
    return verify_study(opened, models_, true, {}, [](double) {}).problems;
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_.path() / "study";
  std::filesystem::path protocol_ = study_ / "protocols" / "small.json";
  ModelRegistry models_ = models_with_one_of_a_file();
};

TEST_F(AssetOfAModel, IsCheckedWithItsContent) {
  EXPECT_THAT(problems(), IsEmpty());
  write_file(study_ / kFile, "a list of groceries\n", Overwrite::allow);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/stimuli/rendered");
  EXPECT_GT(problems()[0].line, 1);
  EXPECT_THAT(problems()[0].message.english(),
              HasSubstr("a wave is one number, its amplitude in metres"));
  std::filesystem::remove(study_ / kFile);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_EQ(problems()[0].pointer, "/textures/grain/assets/wave");
  EXPECT_THAT(problems()[0].message.english(),
              HasSubstr("the file stimuli/grain.wave is not in the study"));
}

TEST_F(AssetOfAModel, IsRefusedByWhatIsThereInstead) {
  std::filesystem::remove(study_ / kFile);
  ASSERT_EQ(::mkfifo((study_ / kFile).c_str(), 0600), 0);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_THAT(problems()[0].message.english(),
              AllOf(HasSubstr("grain.wave"), HasSubstr("it is a pipe")));
  std::filesystem::remove(study_ / kFile);
  std::filesystem::create_directory(study_ / kFile);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_THAT(problems()[0].message.english(),
              AllOf(HasSubstr("grain.wave"), HasSubstr("not a folder")));
  std::filesystem::remove(study_ / kFile);
  std::filesystem::create_symlink("grain.wave", study_ / kFile);
  ASSERT_EQ(problems().size(), 1U);
  EXPECT_THAT(problems()[0].message.english(),
              AllOf(HasSubstr("grain.wave"), HasSubstr("replace the link")));
}

TEST_F(AssetOfAModel, IsHashedStoredAndVerified) {
  simulate_one();
  {
    const Study opened = Study::open(study_, Access::read_only);
    const SessionRow session = opened.sessions().at(0);
    const auto file = std::find_if(session.files.begin(), session.files.end(),
                                   [](const auto& each) { return each.path == kFile; });
    ASSERT_NE(file, session.files.end());
    EXPECT_EQ(file->sha256, sha256_of(kContent));
    const std::vector<AttemptRow> attempts = opened.attempts(session.id);
    ASSERT_FALSE(attempts.empty());
    for (const PresentationRow& felt : attempts[0].presentations) {
      EXPECT_TRUE(asset_sha256(felt.assets, "height_field"));
      EXPECT_EQ(asset_sha256(felt.assets, "wave"),
                felt.model == "measured" ? std::optional(sha256_of(kContent)) : std::nullopt);
    }
  }
  EXPECT_THAT(found_by_verify(), IsEmpty());
  write_file(study_ / kFile, "3e-4\n", Overwrite::allow);
  EXPECT_THAT(found_by_verify(),
              Contains(HasSubstr("the wave, file stimuli/grain.wave, differs from the one that was "
                                 "presented (its SHA-256 differs)")));
}

TEST_F(AssetOfAModel, IsAColumnOfAnExport) {
  simulate_one();
  ExportOptions tables{};
  tables.formats = {};
  export_study(Study::open(study_, Access::read_only), models_, folder_.path() / "out", tables);
  const Table table =
      read_tsv(read_file(folder_.path() / "out" / "presentations.tsv"), "presentations");
  const auto place_of = [&table](const std::string& column) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    EXPECT_NE(found, table.columns.end()) << column;
    return static_cast<std::size_t>(found - table.columns.begin());
  };
  const std::size_t wave = place_of("wave_sha256");
  EXPECT_EQ(wave, place_of("tool_sha256") + 1);
  const std::size_t model = place_of("model");
  ASSERT_LT(std::max(wave, model), table.columns.size());
  ASSERT_FALSE(table.rows.empty());
  for (const auto& row : table.rows) {
    EXPECT_EQ(row[wave], row[model] == Cell{"measured"} ? Cell{sha256_of(kContent)} : Cell{});
  }
}

TEST_F(AssetOfAModel, IsListedAmongTheStimuliWithItsProtocol) {
  write_file(study_ / "stimuli" / "notes.txt", "of nobody\n", Overwrite::refuse);
  const auto stimuli = stimulus_overviews(study_, models_, 32, {});
  const auto wave = std::find_if(stimuli.begin(), stimuli.end(),
                                 [](const auto& each) { return each.path == kFile; });
  ASSERT_NE(wave, stimuli.end());
  EXPECT_EQ(wave->kind, StimulusOverview::Kind::asset);
  EXPECT_EQ(wave->problem, "");
  EXPECT_THAT(wave->used_by, ElementsAre("small"));
  EXPECT_EQ(stimuli.size(), 3U) << "the relief, its photograph and the wave";
}

// The force that other stimuli are made equal to may rest on a file that only it needs.
TEST_F(AssetOfAModel, IsReadForTheReferenceOfEqualForceToo) {
  std::string text = read_file(protocol_);
  const std::string stimulus = R"("texture": "grain"})";
  text.replace(text.find(stimulus), stimulus.size(),
               R"("texture": "grain", "equal_force": {"to_model": "measured"}})");
  write_file(protocol_, text, Overwrite::allow);
  EXPECT_THAT(problems(), IsEmpty());
  Study opened = Study::open(study_, Access::read_write);
  const auto amplitude = [&] {
    StimulusBuilder builder(models_, study_);
    const Protocol protocol = load_protocol(protocol_, models_, study_);
    PlannedPresentation planned = make_plan(protocol, {.seed = 1}).trials.at(0).presentations.at(0);
    planned.stimulus.model = "sinusoid";
    return number_of(builder.prepare(planned, &opened).inputs.parameters, "amplitude_m");
  };
  const double of_the_file_m = amplitude();
  EXPECT_GT(of_the_file_m, 0.0);
  EXPECT_EQ(amplitude(), of_the_file_m);
  write_file(study_ / kFile, "1e-4\n", Overwrite::allow);
  EXPECT_LT(amplitude(), of_the_file_m) << "another file is another problem";
}

}  // namespace
}  // namespace asperity
