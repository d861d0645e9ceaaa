// Power on the full physics: each study is that of a simulation with its seed, and leaves nothing behind.

#include "app/virtual_studies/physics_studies.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/gathering/gathered_answers.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 3;
constexpr std::int64_t kRun = 5;

/// Two staircases of a few trials; gratings need no files.
std::string short_text() {
  nlohmann::json file = test::without_practice(test::library_file("amplitude_jnd"));
  nlohmann::json& procedure = file["blocks"]["comparisons"]["procedure"];
  procedure["stop"] = {{"trials", 8}};
  procedure.erase("catch_trials");
  return file.dump(1);
}

class PhysicsStudiesTest : public testing::Test {
 protected:
  PhysicsStudiesTest() {
    if (const char* const place = std::getenv("TMPDIR")) before_ = place;
    fs::create_directory(temporary());
    ::setenv("TMPDIR", temporary().c_str(), 1);
  }
  ~PhysicsStudiesTest() override {
    if (before_) {
      ::setenv("TMPDIR", before_->c_str(), 1);
    } else {
      ::unsetenv("TMPDIR");
    }
  }

  fs::path temporary() const { return folder_ / "temporary"; }

  /// The outcomes of a simulation that is kept, with all that power leaves out.
  std::vector<SimulatedOutcome> outcomes_of_simulation(int participants) const {
    const fs::path file = folder_ / "short.json";
    write_file(file, short_text(), Overwrite::allow);
    const fs::path study = folder_ / ("study" + std::to_string(participants));
    simulate({.protocols = {file},
              .study = study,
              .participants = participants,
              .seed = simulation_seed(kSeed, kRun)},
             models_, {}, {}, {});
    return outcomes_of(gather_answers(Study::open(study, Access::read_only), std::nullopt, {}));
  }

  TemporaryFolder folder_{};
  std::optional<std::string> before_{};
  ModelRegistry models_ = built_in_models();
  Protocol protocol_ = read_protocol(short_text(), "short.json", declarations_of(models_));
};

void expect_equal(const std::vector<SimulatedOutcome>& one,
                  const std::vector<SimulatedOutcome>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].family, other[i].family);
    EXPECT_EQ(one[i].test, other[i].test);
    EXPECT_EQ(one[i].p, other[i].p);
    EXPECT_EQ(one[i].corrected_p, other[i].corrected_p);
    EXPECT_EQ(one[i].estimate, other[i].estimate);
    EXPECT_EQ(one[i].lower, other[i].lower);
    EXPECT_EQ(one[i].upper, other[i].upper);
    EXPECT_EQ(one[i].status, other[i].status);
  }
}

// A smaller study has the first participants of the larger one, which are those that it would have alone.
TEST_F(PhysicsStudiesTest, AreThoseOfASimulationWithTheSeedOfTheRun) {
  PhysicsStudies studies(protocol_, {.participants = {2, 3}, .jobs = 2}, models_);
  const std::vector<SimulatedOutcome> two = studies.outcomes(2, kSeed, kRun, {});
  const std::vector<SimulatedOutcome> three = studies.outcomes(3, kSeed, kRun, {});
  ASSERT_FALSE(two.empty());
  EXPECT_TRUE(two.front().estimate.has_value() || two.front().p.has_value());
  expect_equal(two, outcomes_of_simulation(2));
  expect_equal(three, outcomes_of_simulation(3));
  EXPECT_NE(two.front().estimate, three.front().estimate);
  // Another run has other participants; the first is made again as it was.
  EXPECT_NE(simulation_seed(kSeed, kRun + 1), simulation_seed(kSeed, kRun));
  EXPECT_FALSE(studies.outcomes(2, kSeed, kRun + 1, {}).empty());
  expect_equal(studies.outcomes(2, kSeed, kRun, {}), two);
}

TEST_F(PhysicsStudiesTest, LeaveNoFilesBehind) {
  {
    PhysicsStudies studies(protocol_, {.participants = {1}}, models_);
    studies.outcomes(1, kSeed, 0, {});
    const auto folders =
        std::distance(fs::directory_iterator(temporary()), fs::directory_iterator{});
    EXPECT_EQ(folders, 1);  // what the next run begins with
  }
  EXPECT_TRUE(fs::is_empty(temporary()));
}

TEST_F(PhysicsStudiesTest, EndWithoutOutcomesWhenAStopIsRequested) {
  PhysicsStudies studies(protocol_, {.participants = {1}}, models_);
  std::stop_source stop{};
  stop.request_stop();
  EXPECT_TRUE(studies.outcomes(1, kSeed, kRun, stop.get_token()).empty());
  EXPECT_FALSE(studies.outcomes(1, kSeed, kRun, {}).empty());
}

TEST_F(PhysicsStudiesTest, DeclareTheProtocolAndTheLargestNumber) {
  const PhysicsStudies studies(protocol_, {.participants = {1, 2}}, models_);
  EXPECT_EQ(PhysicsStudies(protocol_, {.participants = {1, 2}, .jobs = 2}, models_).declaration(),
            studies.declaration());
  EXPECT_NE(PhysicsStudies(protocol_, {.participants = {1, 3}}, models_).declaration(),
            studies.declaration());
}

// Protocols whose studies cannot be made are refused before hours of simulation.
TEST_F(PhysicsStudiesTest, RefuseFilesWithoutAStudy) {
  const Protocol with_files =
      read_protocol(test::library_text("roughness_in_pairs"), "file", declarations_of(models_));
  const std::string refusal =
      refusal_of([&] { const PhysicsStudies studies(with_files, {.participants = {1}}, models_); });
  EXPECT_THAT(refusal, testing::AllOf(testing::HasSubstr("stimuli/"),
                                      testing::HasSubstr("state the study that has them with "
                                                         "--study")));
  EXPECT_TRUE(fs::is_empty(temporary()));
}

}  // namespace
}  // namespace asperity
