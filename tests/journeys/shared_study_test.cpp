// A study that somebody else uses, that cannot be written, or whose disk is full.

#include <array>
#include <csignal>
#include <sys/mount.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

std::vector<std::string> virtual_run_arguments(const fs::path& protocol, const fs::path& study) {
  return {"run",      protocol,    "--study", study, "--participant",
          "standin1", "--virtual", "--seed",  "9"};
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::string& more) {
  arguments.push_back(more);
  return arguments;
}

/// A file system of its own at a folder, for as long as it lives; needs the right to mount.
class Mount final {
 public:
  Mount(const fs::path& source, const fs::path& target, const char* type, unsigned long flags,
        const char* options)
      : target_(target),
        mounted_(::mount(source.c_str(), target.c_str(), type, flags, options) == 0) {}
  ~Mount() {
    if (mounted_) ::umount2(target_.c_str(), MNT_DETACH);
  }
  Mount(const Mount&) = delete;
  Mount& operator=(const Mount&) = delete;

  bool mounted() const noexcept { return mounted_; }
  bool again(unsigned long flags, const char* options) const {
    return ::mount("none", target_.c_str(), nullptr, MS_REMOUNT | flags, options) == 0;
  }

 private:
  fs::path target_{};
  bool mounted_ = false;
};

fs::perms permissions_of(const fs::path& path) { return fs::status(path).permissions(); }

TEST(NewStudy, IsItsOwnersUnlessItIsSharedAndACheckWarnsOfOthers) {
  const SmallStudy small(1);
  const fs::path own = small.place() / "own";
  ASSERT_EQ(asperity({"new", own}).status, 0);
  EXPECT_EQ(permissions_of(own), fs::perms::owner_all);
  const fs::path shared = small.place() / "shared";
  const Outcome made = asperity({"new", shared, "--shared"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("shared with the group "), std::string::npos) << made.out;
  EXPECT_EQ(permissions_of(shared),
            fs::perms::owner_all | fs::perms::group_all | fs::perms::set_gid);
  const Outcome nobody = asperity({"new", small.place() / "n", "--shared", "--group", "no such"});
  EXPECT_EQ(nobody.status, 1);
  EXPECT_NE(nobody.err.find("there is no group no such"), std::string::npos) << nobody.err;
  EXPECT_FALSE(fs::exists(small.place() / "n"));
  EXPECT_EQ(asperity({"new", small.place() / "n", "--group", "x"}).status, 2) << "without --shared";

  const auto warning = [&] {
    return asperity({"check", small.selection(), "--study", small.study()}).err;
  };
  const std::string sentence = "every user of this computer can read the study";
  EXPECT_EQ(warning().find(sentence), std::string::npos);
  constexpr auto kOpen = fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec;
  fs::permissions(small.place(), kOpen);
  fs::permissions(small.study(), kOpen);
  EXPECT_NE(warning().find(sentence), std::string::npos);
}

TEST(ReadOnlyStudy, IsRefusedForWritingAndStillRead) {
  const SmallStudy small(1);
  ASSERT_EQ(asperity(simulate_arguments(small, small.study(), 1, 3)).status, 0);
  const auto expected = exported(small.study(), small.place() / "expected");
  const std::string analysis = asperity({"analyze", small.study()}).out;
  const Mount bind(small.study(), small.study(), nullptr, MS_BIND, nullptr);
  if (!bind.mounted() || !bind.again(MS_BIND | MS_RDONLY, nullptr)) {
    GTEST_SKIP() << "mounting is not permitted here";
  }
  for (const auto& arguments : {simulate_arguments(small, small.study(), 1, 3),
                                virtual_run_arguments(small.selection(), small.study())}) {
    const Outcome refused = asperity(arguments);
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find(small.study().string()), std::string::npos) << refused.err;
    EXPECT_TRUE(refused.err.find("read-only") != std::string::npos ||
                refused.err.find("written") != std::string::npos)
        << refused.err;
  }
  EXPECT_TRUE(exported(small.study(), small.place() / "tables") == expected);
  EXPECT_EQ(asperity({"analyze", small.study()}).out, analysis);
  EXPECT_EQ(asperity({"verify", small.study(), "--replay"}).status, 0);
  EXPECT_EQ(asperity({"copy", small.study(), small.place() / "copy"}).status, 0);
}

TEST(RunningSession, IsRefusedASecondTimeNamingHostAndProcess) {
  const SmallStudy small(50);
  Invocation invocation{};
  invocation.arguments =
      with(virtual_run_arguments(small.selection(), small.study()), "--realtime");
  Program first(invocation);
  ASSERT_TRUE(first.read_until([](const std::string&, const std::string& err) {
    return !done_lines(err).empty();
  })) << first.err();
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  for (const auto& arguments :
       {virtual_run_arguments(small.selection(), small.study()),
        with(virtual_run_arguments(small.selection(), small.study()), "--resume")}) {
    const Outcome second = asperity(arguments);
    EXPECT_EQ(second.status, 1);
    EXPECT_NE(second.err.find(std::to_string(first.process())), std::string::npos) << second.err;
    EXPECT_NE(second.err.find(host.data()), std::string::npos) << second.err;
  }
  // Another participant is not in the way.
  std::vector<std::string> other = virtual_run_arguments(small.recognition(), small.study());
  other[5] = "standin2";
  EXPECT_EQ(asperity(other).status, 0);

  // What is copied meanwhile is a sound study, with every trial that was done when it was taken.
  const std::size_t done = done_lines(first.err()).size();
  ASSERT_EQ(asperity({"copy", small.study(), small.place() / "copy"}).status, 0);
  const auto tables = exported(small.place() / "copy", small.place() / "tables");
  EXPECT_GE(tsv(tables.at("attempts.tsv")).rows.size(), done);
  const Outcome verified = asperity({"verify", small.place() / "copy"});
  EXPECT_EQ(verified.status, 0) << verified.err;
}

TEST(RunningSession, DoesNotKeepAnOutputFromBeingListed) {
  const SmallStudy small(50);
  Invocation invocation{};
  invocation.arguments =
      with(virtual_run_arguments(small.selection(), small.study()), "--realtime");
  Program session(invocation);
  ASSERT_TRUE(session.read_until([](const std::string&, const std::string& err) {
    return !done_lines(err).empty();
  })) << session.err();
  const fs::path tables = small.place() / "tables";
  const fs::path report = small.place() / "report.html";
  const fs::path copy = small.place() / "copy";
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"export", small.study(), "--out", tables},
                                             {"report", small.study(), "--out", report},
                                             {"copy", small.study(), copy}}) {
    const Outcome made = asperity(arguments);
    EXPECT_EQ(made.status, 0);
    EXPECT_EQ(made.err.find("list"), std::string::npos) << made.err;
  }
  session.send(SIGINT);
  session.finish();
  const Outcome withdrawn = asperity({"withdraw", small.study(), "standin1", "--by", "a test"});
  EXPECT_EQ(withdrawn.status, 0) << withdrawn.err;
  for (const fs::path& output : {tables, report, copy}) {
    EXPECT_NE(withdrawn.out.find(output.string() + '\n'), std::string::npos) << withdrawn.out;
  }
}

TEST(Copy, OfAStudyThatIsBeingSimulatedIsConsistent) {
  const SmallStudy small(40);
  Invocation invocation{};
  invocation.arguments = simulate_arguments(small, small.study(), 4, 3);
  Program simulation(invocation);
  for (int i = 0; i < 3; ++i) {
    const std::size_t more = done_lines(simulation.err()).size() + 5;
    ASSERT_TRUE(simulation.read_until([more](const std::string&, const std::string& err) {
      return done_lines(err).size() >= more;
    }));
    const std::size_t done = done_lines(simulation.err()).size();
    const fs::path copy = small.place() / ("copy_" + std::to_string(i));
    const Outcome copied = asperity({"copy", small.study(), copy});
    ASSERT_EQ(copied.status, 0) << copied.err;
    const Outcome verified = asperity({"verify", copy});
    EXPECT_EQ(verified.status, 0) << verified.err;
    const auto tables = exported(copy, small.place() / ("tables_" + std::to_string(i)));
    EXPECT_GE(tsv(tables.at("attempts.tsv")).rows.size(), done);
  }
}

TEST(FullDisk, KeepsEveryFinishedTrialAndTheSessionContinues) {
  const SmallStudy small(30);  // 60 trials
  const fs::path never_full = small.place() / "never_full";
  copy_stimuli(small, never_full);
  ASSERT_EQ(asperity(virtual_run_arguments(small.selection(), never_full)).status, 0);
  const auto expected = exported(never_full, small.place() / "expected");

  const fs::path disk = small.place() / "disk";
  fs::create_directory(disk);
  const Mount mount("tmpfs", disk, "tmpfs", 0, "size=1200k");
  if (!mount.mounted()) GTEST_SKIP() << "mounting is not permitted here";
  const fs::path study = disk / "study";
  copy_stimuli(small, study);
  const Outcome full = asperity(virtual_run_arguments(small.selection(), study));
  ASSERT_EQ(full.status, 1) << full.err;
  EXPECT_NE(full.err.find("the disk is full"), std::string::npos) << full.err;
  const std::vector<std::string> done = done_lines(full.err);
  EXPECT_GE(done.size(), 1U);
  EXPECT_LT(done.size(), 60U);

  // On the full disk, which has no room for anything, the study can still be read.
  const auto meanwhile = exported(study, small.place() / "meanwhile");
  EXPECT_GE(tsv(meanwhile.at("attempts.tsv")).rows.size(), done.size());

  ASSERT_TRUE(mount.again(0, "size=64m"));
  const Outcome resumed =
      asperity(with(virtual_run_arguments(small.selection(), study), "--resume"));
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  const auto tables = exported(study, small.place() / "tables");
  EXPECT_EQ(tsv(tables.at("responses.tsv")).column("answer"),
            tsv(expected.at("responses.tsv")).column("answer"));
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"completed"});
}

}  // namespace
}  // namespace asperity::test
