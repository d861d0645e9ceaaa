// Two builds of a plug-in with one version, in one study: what warns of them, and how each attempt is rendered again by its build.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"
#include "results_schema/hashes/short_hash.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const fs::path kFormer = ASPERITY_FAULTY_PLUGINS "/faulty_none.so";
const fs::path kRebuilt = ASPERITY_FAULTY_PLUGINS "/faulty_rebuilt.so";

class PluginBuilds : public testing::Test {
 protected:
  PluginBuilds() { write_text(protocol(), faulty_discrimination().dump()); }

  fs::path protocol() const { return folder_ / "faulty.json"; }
  fs::path study() const { return folder_ / "study"; }

  Outcome simulate(const fs::path& plugin, const std::string& seed) const {
    Outcome done = asperity({"simulate", protocol(), "--study", study(), "--participants", "1",
                             "--seed", seed, "--recordings", "all", "--plugin", plugin});
    EXPECT_EQ(done.status, 0) << done.err;
    return done;
  }
  void simulate_both() const {
    simulate(kFormer, "1");
    simulate(kRebuilt, "2");
  }

  Outcome verify(const std::vector<fs::path>& plugins) const {
    std::vector<std::string> arguments{"verify", study(), "--replay"};
    for (const fs::path& plugin : plugins) {
      arguments.insert(arguments.end(), {"--plugin", plugin.string()});
    }
    return asperity(arguments);
  }

  TemporaryFolder folder_{};
};

TEST_F(PluginBuilds, AreWarnedOfBeforeTheyAreJoined) {
  simulate(kFormer, "1");
  const auto warning =
      AllOf(HasSubstr("/stimuli/ridges"), HasSubstr(sha256_of_file(kFormer)),
            HasSubstr("the loaded plug-in has the SHA-256 " + sha256_of_file(kRebuilt)),
            HasSubstr("raise the version of the plug-in"));
  const Outcome checked = asperity({"check", protocol(), "--study", study(), "--plugin", kRebuilt});
  EXPECT_EQ(checked.status, 0);
  EXPECT_THAT(checked.err, warning);
  EXPECT_THAT(asperity({"check", protocol(), "--study", study(), "--plugin", kFormer}).err,
              Not(HasSubstr("another build")));
  EXPECT_THAT(simulate(kRebuilt, "2").err, warning);
  const Outcome session =
      asperity({"run", protocol(), "--study", study(), "--participant", "virtual0009", "--mode",
                "pilot", "--virtual", "--seed", "5", "--plugin", kRebuilt});
  EXPECT_EQ(session.status, 0) << session.err;
  EXPECT_THAT(session.err, warning);
}

TEST_F(PluginBuilds, ArePooledWithARemarkInTheAnalysisAndTheReport) {
  simulate_both();
  const auto remark = AllOf(
      HasSubstr("Different builds of the plug-in of the force model faulty have the version 1"),
      HasSubstr(short_hash(sha256_of_file(kFormer)) + "…"),
      HasSubstr(short_hash(sha256_of_file(kRebuilt)) + "…"));
  const Outcome analysis = asperity({"analyze", study(), "--json"});
  EXPECT_THAT(analysis.out, remark) << analysis.err;
#ifdef ASPERITY_WITH_REPORT
  const Outcome report = asperity({"report", study(), "--out", folder_ / "report.html"});
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_THAT(text_of(folder_ / "report.html"),
              AllOf(remark, HasSubstr("faulty 1, file faulty_rebuilt.so, SHA-256 " +
                                      sha256_of_file(kRebuilt))));
#endif
}

TEST_F(PluginBuilds, EachRenderTheirAttemptsAgain) {
  simulate_both();
  const Outcome with_both = verify({kRebuilt, kFormer});
  EXPECT_EQ(with_both.status, 0) << with_both.out << with_both.err;
  EXPECT_THAT(with_both.out, Not(HasSubstr("not replayed")));
  // One problem for all attempts with a missing build.
  const Outcome with_one = verify({kFormer});
  EXPECT_EQ(with_one.status, 1);
  EXPECT_THAT(with_one.err,
              ContainsRegex("the plug-in model faulty, version 1 \\(SHA-256 [0-9a-f]*\\), rendered "
                            "[0-9]* attempts, and the loaded plug-in faulty_none.so differs"));
  EXPECT_THAT(with_one.err, Not(HasSubstr("attempt virtual")));
  EXPECT_THAT(with_one.out,
              AllOf(HasSubstr("1 problem found"), Not(HasSubstr("Restore")),
                    ContainsRegex("not replayed because their plug-in is not loaded: [1-9]")));
}

TEST_F(PluginBuilds, AreChosenByTheAttemptThatIsReplayed) {
  simulate_both();
  const auto replay = [&](const std::string& attempt, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"replay",  study(), "--attempt",           attempt,
                                       "--force", "--out", folder_ / "forces.tsv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return asperity(arguments);
  };
  for (const std::string attempt : {"virtual0001/1/1/1", "virtual0002/1/1/1"}) {
    const Outcome replayed = replay(attempt, {"--plugin", kFormer, "--plugin", kRebuilt});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
  }
  const Outcome missing = replay("virtual0002/1/1/1", {"--plugin", kFormer});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err,
              AllOf(HasSubstr("faulty_rebuilt.so"), HasSubstr(sha256_of_file(kRebuilt)),
                    HasSubstr("not loaded; load it with --plugin FILE")));
}

TEST_F(PluginBuilds, AreComparedWithTheLoadedOne) {
  simulate(kFormer, "1");
  std::vector<std::string> arguments{"replay", study(), "--compare", "--out",
                                     folder_ / "compared.tsv"};
  const Outcome without = asperity(arguments);
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.err,
              HasSubstr("its force model faulty is in a plug-in that is not loaded; load it with "
                        "--plugin FILE"));
  arguments.insert(arguments.end(), {"--plugin", kRebuilt});
  const Outcome compared = asperity(arguments);
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_THAT(compared.out, HasSubstr("largest difference "));
}

TEST_F(PluginBuilds, AreNotNeededToReplayWithAnotherModel) {
  simulate(kFormer, "1");
  const Outcome replayed = asperity({"replay", study(), "--attempt", "virtual0001/1/1/1", "--model",
                                     "sinusoid", "--out", folder_ / "forces.tsv"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
}

}  // namespace
}  // namespace asperity::test
