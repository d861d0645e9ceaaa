// A study is its owner's, unless it is shared; then another member of the group can work in it.

#include "results_schema/study_sharing.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

unsigned mode_of(const std::filesystem::path& path) {
  struct stat status {};
  EXPECT_EQ(::lstat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777U;
}

class Umask {
 public:
  explicit Umask(mode_t mask) : was_(::umask(mask)) {}
  ~Umask() { ::umask(was_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t was_;
};

/// Runs a session of one attempt, as `asperity run` would.
void run_session(const std::filesystem::path& folder, const std::string& label) {
  Study study = Study::open(folder, Access::read_write);
  study.add_participant(some_participant(label));
  const StudyLock lock(folder, Study::session_lock_name(label));
  const std::int64_t session =
      study.add_session(some_session(study.add_protocol(some_protocol()), label), some_plan(1));
  study.begin_segment(session, 0);
  AttemptRow attempt = some_attempt(1);
  RecordingWriter writer(folder, "recordings/all/" + label + ".asprec",
                         {.rate_Hz = 10.0, .columns = {{.name = "x_m"}}});
  const float x_m = 0.1F;
  writer.append(0, &x_m);
  attempt.recording = writer.finish();
  study.add_attempt(session, attempt);
}

TEST(StudyPermissions, AreForTheOwnerOnlyInANewStudyAndACopy) {
  const Umask usual(022);
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  EXPECT_EQ(mode_of(folder / "s"), 0700U);
  Study::open(folder / "s", Access::read_only).copy_to(folder / "copy");
  EXPECT_EQ(mode_of(folder / "copy"), 0700U);
}

TEST(StudyPermissions, OfAFolderThatWasThereStay) {
  const Umask usual(022);
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "s");
  { Study::create(folder / "s", "x"); }
  EXPECT_EQ(mode_of(folder / "s"), 0755U);
  std::filesystem::create_directory(folder / "t");
  ASSERT_EQ(::chmod((folder / "t").c_str(), 02770), 0);
  { Study::create(folder / "t", "x"); }
  EXPECT_EQ(mode_of(folder / "t/study.sqlite"), 0660U);
  EXPECT_EQ(mode_of(folder / "t/locks"), 02770U);
}

// The strictest umask there is: what a member makes is to be the group's all the same.
TEST(SharedStudy, GivesTheGroupAllThatIsInItAndAllThatComes) {
  const Umask strict(077);
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  write_file(folder / "s/stimuli/a.png", "x", Overwrite::refuse);
  std::ofstream(folder / "precious") << "x";
  ASSERT_EQ(::chmod((folder / "precious").c_str(), 0600), 0);
  std::filesystem::create_symlink(folder / "precious", folder / "s/stimuli/link");
  EXPECT_FALSE(is_shared_with_group(folder / "s"));
  EXPECT_EQ(share_study(folder / "s"), group_of(folder / "s"));
  EXPECT_TRUE(is_shared_with_group(folder / "s"));
  run_session(folder / "s", "P01");
  write_file(folder / "s/protocols/new.json", "{}", Overwrite::refuse);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "s")) {
    if (entry.is_symlink()) continue;
    EXPECT_EQ(mode_of(entry.path()), entry.is_directory() ? 02770U : 0660U) << entry.path();
  }
  EXPECT_EQ(mode_of(folder / "s"), 02770U);
  EXPECT_EQ(mode_of(folder / "precious"), 0600U);
}

TEST(SharedStudy, HasAGroupThatIsThere) {
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  EXPECT_THAT(refusal_of<ResultsError>([&] { share_study(folder / "s", "no such group"); }),
              HasSubstr("there is no group no such group; name one that you are a member of"));
  EXPECT_EQ(mode_of(folder / "s"), 0700U);
}

/// Runs `action` as another user of this group; 0 where it was not refused.
template <typename Action>
int as_member(gid_t group, uid_t user, Action action) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::umask(077);
    if (::setgroups(1, &group) != 0 || ::setgid(group) != 0 || ::setuid(user) != 0) ::_exit(3);
    const std::string refusal = refusal_of<ResultsError>(action);
    if (!refusal.empty()) std::fprintf(stderr, "%s\n", refusal.c_str());
    ::_exit(refusal.empty() ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SharedStudy, IsOutOfReachInAFolderThatIsClosedToItsGroup) {
  const TemporaryFolder folder;
  { Study::create(folder / "s", "x"); }
  share_study(folder / "s");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0700), 0);
  EXPECT_EQ(folder_closed_to_group(folder / "s"), std::filesystem::canonical(folder.path()));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0711), 0);
  EXPECT_EQ(folder_closed_to_group(folder / "s"), std::nullopt);
}

TEST(SharedStudy, IsWorkedInByTwoMembersOfItsGroup) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the superuser can be two others";
  constexpr gid_t kGroup = 54321;
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  ASSERT_EQ(as_member(kGroup, 54321,
                      [&] {
                        Study::create(folder / "s", "x");
                        run_session(folder / "s", "P01");
                      }),
            0);
  const auto run_next = [&] { run_session(folder / "s", "P02"); };
  EXPECT_EQ(as_member(kGroup, 54322, run_next), 1) << "it is not shared yet";
  ASSERT_EQ(as_member(kGroup, 54321, [&] { share_study(folder / "s"); }), 0);
  EXPECT_EQ(as_member(kGroup, 54322, run_next), 0);
  EXPECT_EQ(as_member(kGroup, 54321, [&] { run_session(folder / "s", "P03"); }), 0);
  EXPECT_EQ(as_member(kGroup + 1, 54323, [&] { Study::open(folder / "s", Access::read_only); }), 1);
  const Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_EQ(study.participants().size(), 3U);
  EXPECT_THAT(study.verify({}), testing::IsEmpty());
}

TEST(StudyPermissions, SayWhetherOthersCanRead) {
  const Umask usual(022);
  const TemporaryFolder folder;
  const std::filesystem::path study = folder / "around/s";
  { Study::create(study, "x"); }
  const auto with_modes = [&](mode_t around, mode_t own) {
    EXPECT_EQ(::chmod(study.parent_path().c_str(), around), 0);
    EXPECT_EQ(::chmod(study.c_str(), own), 0);
    return is_readable_by_others(study);
  };
  EXPECT_FALSE(with_modes(0755, 0755)) << "the folder of the test is its owner's";
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_TRUE(with_modes(0755, 0755));
  EXPECT_TRUE(with_modes(0711, 0711)) << "the name of the database is known";
  EXPECT_FALSE(with_modes(0700, 0755));
  EXPECT_FALSE(with_modes(0755, 0700));
  EXPECT_FALSE(with_modes(0755, 02770));
  EXPECT_FALSE(with_modes(0755, 0750));
}

}  // namespace
}  // namespace asperity
