// The plans of the library's protocols: they are those that tests/protocols/library_plans.tsv states.
//
// To store the present plans after a protocol was meant to change, run
//   ASPERITY_STORE_PLANS=1 build/release/bin/asperity_protocols_tests --gtest_filter='LibraryPlans.*'
// and review the lines that changed.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/course.h"
#include "results_schema/hashes/sha256.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

constexpr int kParticipants = 4;

/// "amplitude_jnd", the number of trials of all participants, and the digest of these trials in their order without their
/// wording, separated by tabs.
std::string line_of_plans(const LibraryProtocol& of) {
  const Protocol protocol =
      read_protocol(of.text, std::string(of.name) + ".json", test::models_of_library());
  std::string planned{};
  std::size_t trials = 0;
  for (int row = 0; row < kParticipants; ++row) {
    const Plan plan = example_plan(protocol, {.seed = 1, .counterbalance_row = row});
    for (const Trial& trial : plan.trials) {
      planned += test::without_wording(nlohmann::json::parse(json_of(trial))).dump() + '\n';
    }
    trials += plan.trials.size();
  }
  return std::string(of.name) + '\t' + std::to_string(trials) + '\t' + sha256_of(planned) + '\n';
}

TEST(LibraryPlans, AreThoseThatAreStored) {
  const std::filesystem::path file =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/protocols/library_plans.tsv";
  std::string present = "protocol\ttrials\tsha256\n";
  for (const LibraryProtocol& each : library_protocols()) present += line_of_plans(each);
  if (std::getenv("ASPERITY_STORE_PLANS") != nullptr) {
    std::ofstream(file, std::ios::binary) << present;
    return;
  }
  std::ifstream stored(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stored), {}), present)
      << "plans of library protocols for participants 1 to " << kParticipants << " with seed 1";
}

}  // namespace
}  // namespace asperity
