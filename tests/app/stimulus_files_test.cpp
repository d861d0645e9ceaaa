// Stimuli are renamed with all references, deleted if nothing refers to them, and copied without replacing a file.

#include "app/tasks/stimulus_files.h"

#include <csignal>
#include <cstddef>
#include <stop_token>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/session_setup.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/program.h"
#include "app/study_files/rendering_files.h"
#include "app/tasks/check_protocol.h"
#include "app/words/phrase_of_error.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StimulusFiles : public testing::Test {
 protected:
  StimulusFiles() {
    make_small_study(folder());
    write_file(protocol_, small_protocol(), Overwrite::refuse);
    save_rendering(folder(), "strong",
                   {.model = "height_map",
                    .version = "1",
                    .texture = {"stimuli/grain.png", std::string(64, 'a')}});
  }
  std::filesystem::path folder() const { return temporary_.path() / "study"; }
  std::filesystem::path stimulus(const std::string& name) const {
    return folder() / "stimuli" / name;
  }
  Study study() const { return Study::open(folder(), Access::read_only); }
  void run_it() {
    Study own = Study::open(folder(), Access::read_write);
    own.add_participant({.label = "p1", .created_utc = "2026-01-01T00:00:00.000Z"});
    SessionConditions conditions{};
    conditions.seed = 7;
    conditions.pacing = "stepped";
    conditions.started_utc = "2026-01-01T00:00:00.000Z";
    begin_session(own, read_small_protocol(built_in_models(), read_file(protocol_)), "p1",
                  conditions, this_program());
  }
  TemporaryFolder temporary_{};
  std::filesystem::path protocol_ = folder() / "protocols" / "small.json";
};

TEST_F(StimulusFiles, KnowWhatRefersToThem) {
  const StimulusUses uses = uses_of_stimulus(study(), "stimuli/grain.png");
  EXPECT_THAT(uses.protocols, ElementsAre(protocol_));
  EXPECT_THAT(uses.renderings, ElementsAre(rendering_file(folder(), "strong")));
  EXPECT_FALSE(uses.is_stored());
  EXPECT_TRUE(uses_of_stimulus(study(), "stimuli/strong.rendering.json").is_unused());
}

TEST_F(StimulusFiles, AreRenamedWithSidecarPhotographAndReferences) {
  const std::string sha256 = load_height_field(stimulus("grain.png")).sha256;
  const RenamePlan plan = plan_of_renaming(study(), "stimuli/grain.png");
  EXPECT_THAT(plan.files,
              testing::UnorderedElementsAre("stimuli/grain_photo.png", "stimuli/grain.png.json",
                                            "stimuli/grain.png"));
  EXPECT_THAT(plan.changed, ElementsAre(protocol_, rendering_file(folder(), "strong")));
  EXPECT_TRUE(plan.reliefs.empty()) << "its photograph is renamed with it";
  EXPECT_EQ(rename_stimulus(study(), "stimuli/grain.png", "sand-2"), "stimuli/sand-2.png");
  EXPECT_EQ(load_height_field(stimulus("sand-2.png")).sha256, sha256);
  EXPECT_TRUE(std::filesystem::exists(stimulus("sand-2_photo.png")));
  for (const char* const old : {"grain.png", "grain.png.json", "grain_photo.png"}) {
    EXPECT_FALSE(std::filesystem::exists(stimulus(old))) << old;
  }
  const std::string text = read_file(protocol_);
  EXPECT_THAT(text, HasSubstr(R"("grain": {"height_field": "stimuli/sand-2.png", "picture": )"
                              R"("stimuli/sand-2_photo.png"})"));
  EXPECT_TRUE(check_protocol(protocol_, built_in_models(), folder(), std::nullopt).is_valid());
  EXPECT_EQ(load_rendering(rendering_file(folder(), "strong")).texture.height_field,
            "stimuli/sand-2.png");
}

TEST_F(StimulusFiles, AreRenamedWithTheProtocolsOfTheirPhotographAndTheNotesOfTheirName) {
  const std::string only_photo =
      replaced(small_protocol(), "\"height_field\": \"stimuli/grain.png\", ", "");
  const std::filesystem::path other = folder() / "protocols" / "photo.json";
  write_file(other, only_photo, Overwrite::refuse);
  EXPECT_THAT(plan_of_renaming(study(), "stimuli/grain.png").changed,
              ElementsAre(other, protocol_, rendering_file(folder(), "strong")));
  EXPECT_THAT(plan_of_renaming(study(), "stimuli/grain_photo.png").reliefs,
              ElementsAre("stimuli/grain.png"));

  const std::string noting =
      replaced(small_protocol(), "\"rendered\": {", "\"rendered\": {\"x-rendering\": \"strong\", ");
  write_file(other, noting, Overwrite::allow);
  EXPECT_THAT(plan_of_renaming(study(), "stimuli/strong.rendering.json").changed,
              ElementsAre(other));
  EXPECT_EQ(rename_stimulus(study(), "stimuli/strong.rendering.json", "weak"),
            "stimuli/weak.rendering.json");
  EXPECT_EQ(read_file(other), replaced(noting, "\"strong\"", "\"weak\""));
  run_it();
  write_file(protocol_, read_file(other), Overwrite::allow);
  const RenamePlan plan = plan_of_renaming(study(), "stimuli/weak.rendering.json");
  EXPECT_THAT(plan.unchanged, ElementsAre(other, protocol_)) << "their protocol has sessions";
  EXPECT_FALSE(plan.complaint.has_value());
}

TEST_F(StimulusFiles, OfProtocolsThatWereRunAreRemovedThereFirst) {
  run_it();
  for (const char* const end : {".png", ".png.json"}) {
    std::filesystem::copy_file(stimulus(std::string("grain") + end),
                               stimulus(std::string("sand") + end));
  }
  write_file(protocol_, replaced(small_protocol(), "stimuli/grain.png", "stimuli/sand.png"),
             Overwrite::allow);
  EXPECT_THAT(refusal_of<PhrasedError>([&] { delete_stimulus(study(), "stimuli/sand.png"); }),
              HasSubstr("is used by protocols with stored sessions: small.json"));
}

TEST_F(StimulusFiles, KeepTheirNameWhereAnotherHasTheNewOne) {
  write_file(stimulus("sand_photo.png"), "another", Overwrite::refuse);
  EXPECT_THAT(
      refusal_of<PhrasedError>([this] { rename_stimulus(study(), "stimuli/grain.png", "sand"); }),
      HasSubstr("already has a file sand_photo.png"));
  for (const char* const name : {"", "../sand", "sand/1", "Körner"}) {
    EXPECT_THAT(
        refusal_of<PhrasedError>([&] { rename_stimulus(study(), "stimuli/grain.png", name); }),
        HasSubstr("cannot be the name"))
        << name;
  }
  write_file(folder() / "protocols" / "broken.json", R"({"file": "stimuli/grain.png")",
             Overwrite::refuse);
  EXPECT_THAT(
      refusal_of<PhrasedError>([this] { rename_stimulus(study(), "stimuli/grain.png", "corn"); }),
      HasSubstr("broken.json names stimuli/grain.png"));
  EXPECT_TRUE(std::filesystem::exists(stimulus("grain.png")));
  EXPECT_FALSE(std::filesystem::exists(stimulus("corn.png")));
  EXPECT_EQ(read_file(protocol_), small_protocol());
}

TEST_F(StimulusFiles, KeepTheirSidecarWhereTheEndingIsInCapitals) {
  for (const char* const end : {"", ".json"}) {
    std::filesystem::rename(stimulus(std::string("grain.png") + end),
                            stimulus(std::string("GRAIN.PNG") + end));
  }
  EXPECT_THAT(files_of_stimulus(folder(), "stimuli/GRAIN.PNG"),
              ElementsAre("stimuli/GRAIN.PNG.json", "stimuli/GRAIN.PNG"));
  EXPECT_EQ(rename_stimulus(study(), "stimuli/GRAIN.PNG", "sand"), "stimuli/sand.PNG");
  EXPECT_TRUE(std::filesystem::exists(stimulus("sand.PNG.json")));
  EXPECT_FALSE(std::filesystem::exists(stimulus("GRAIN.PNG.json")));
}

// A limit on the size of files fails the second of two protocols, as a full disk does.
TEST_F(StimulusFiles, KeepTheirNameWhereAReferenceCannotBeWritten) {
  constexpr std::size_t kPadding = 1 << 20;
  const std::string large = small_protocol() + std::string(kPadding, '\n');
  write_file(folder() / "protocols" / "small_2.json", large, Overwrite::refuse);
  const Study own = study();
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = kPadding;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      refusal_of([&] { rename_stimulus(own, "stimuli/grain.png", "sand"); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, HasSubstr("small_2.json"));
  EXPECT_EQ(read_file(protocol_), small_protocol());
  EXPECT_EQ(read_file(folder() / "protocols" / "small_2.json"), large);
  for (const char* const name : {"sand.png", "sand.png.json", "sand_photo.png"}) {
    EXPECT_FALSE(std::filesystem::exists(stimulus(name))) << name;
  }
  EXPECT_TRUE(std::filesystem::exists(stimulus("grain.png")));
  EXPECT_EQ(rename_stimulus(study(), "stimuli/grain.png", "sand"), "stimuli/sand.png")
      << "it can be repeated";
}

TEST_F(StimulusFiles, OfSessionsAreNeitherRenamedNorDeleted) {
  run_it();
  std::filesystem::remove(protocol_);  // the store still has its text
  for (const char* const path : {"stimuli/grain.png", "stimuli/grain_photo.png"}) {
    EXPECT_THAT(refusal_of<PhrasedError>([&] { rename_stimulus(study(), path, "sand"); }),
                HasSubstr("belongs to stored sessions"))
        << path;
    EXPECT_THAT(refusal_of<PhrasedError>([&] { delete_stimulus(study(), path); }),
                HasSubstr("belongs to stored sessions"))
        << path;
    EXPECT_TRUE(std::filesystem::exists(folder() / path));
  }
}

TEST_F(StimulusFiles, AreDeletedOnlyIfNothingRefersToThem) {
  EXPECT_THAT(refusal_of<PhrasedError>([this] { delete_stimulus(study(), "stimuli/grain.png"); }),
              HasSubstr("is used by small.json, strong.rendering.json"));
  std::filesystem::remove(protocol_);
  delete_stimulus(study(), "stimuli/strong.rendering.json");
  delete_stimulus(study(), "stimuli/grain.png");
  EXPECT_FALSE(std::filesystem::exists(stimulus("grain.png")));
  EXPECT_FALSE(std::filesystem::exists(stimulus("grain.png.json")));
  EXPECT_TRUE(std::filesystem::exists(stimulus("grain_photo.png"))) << "is a separate stimulus";
}

TEST_F(StimulusFiles, AreCopiedFromAnotherStudyAndReplaceNothing) {
  const std::filesystem::path other = temporary_.path() / "other";
  make_small_study(other);
  const auto state_of = [&](const std::string& path) {
    for (const ForeignStimulus& each : foreign_stimuli(folder(), other)) {
      if (each.path == path) return each.state;
    }
    throw std::runtime_error("not listed: " + path);
  };
  using State = ForeignStimulus::State;
  EXPECT_EQ(state_of("stimuli/grain.png"), State::is_there);
  std::filesystem::rename(other / "stimuli" / "grain.png", other / "stimuli" / "corn.png");
  std::filesystem::rename(other / "stimuli" / "grain.png.json",
                          other / "stimuli" / "corn.png.json");
  EXPECT_EQ(state_of("stimuli/corn.png"), State::can_be_copied);
  write_file(stimulus("corn.png"), "another", Overwrite::refuse);
  EXPECT_EQ(state_of("stimuli/corn.png"), State::name_is_taken);
  EXPECT_ANY_THROW(copy_stimuli(folder(), other, {"stimuli/corn.png"}));
  EXPECT_EQ(read_file(stimulus("corn.png")), "another");
  EXPECT_FALSE(std::filesystem::exists(stimulus("corn.png.json")));
  std::filesystem::remove(stimulus("corn.png"));
  copy_stimuli(folder(), other, {"stimuli/corn.png"});
  EXPECT_EQ(load_height_field(stimulus("corn.png")).sha256,
            load_height_field(stimulus("grain.png")).sha256);
  write_file(other / "stimuli" / "notes.txt", "", Overwrite::refuse);
  EXPECT_THROW(state_of("stimuli/notes.txt"), std::runtime_error);
  std::filesystem::copy_file(other / "stimuli" / "grain_photo.png",
                             other / "stimuli" / "rice_photo.png");
  for (const char* const end : {".png", ".png.json"}) {
    std::filesystem::rename(other / "stimuli" / (std::string("corn") + end),
                            other / "stimuli" / (std::string("rice") + end));
  }
  save_rendering(other, "weak",
                 {.model = "height_map",
                  .version = "1",
                  .texture = {"stimuli/rice.png", std::string(64, 'a')}});
  std::stop_source stopped{};
  stopped.request_stop();
  EXPECT_EQ(copy_stimuli(folder(), other, {"stimuli/rice.png"}, stopped.get_token()), 0);
  EXPECT_FALSE(std::filesystem::exists(stimulus("rice.png")));
  EXPECT_EQ(copy_stimuli(folder(), other, {"stimuli/weak.rendering.json", "stimuli/rice.png"}), 2);
  for (const char* const name :
       {"weak.rendering.json", "rice.png", "rice.png.json", "rice_photo.png"}) {
    EXPECT_TRUE(std::filesystem::exists(stimulus(name))) << name;
  }
  EXPECT_EQ(state_of("stimuli/weak.rendering.json"), State::is_there);
  EXPECT_THAT(refusal_of<PhrasedError>([&] { foreign_stimuli(folder(), temporary_.path()); }),
              HasSubstr("is not a study"));
}

}  // namespace
}  // namespace asperity
