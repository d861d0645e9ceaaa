// What asperity power is asked for: its options, and the analysis that they describe.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/output/power_output.h"
#include "app/power/assumption.h"
#include "app/shards/shard.h"
#include "app/tasks/check_protocol.h"
#include "app/virtual_studies/physics_studies.h"
#include "protocols/design/protocol.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

inline constexpr const char* kStatedSource =
    "stated by the researcher as the smallest effect of interest";
inline constexpr const char* kAssumedSource = "stated by the researcher";

/// As given on the command line.
struct PowerOptions {
  std::string protocol{};
  std::string participants{};
  std::vector<std::string> effects{};
  std::string effect_source = kStatedSource;
  std::string calibrated_by{};
  std::string assumptions{};
  std::vector<std::string> assumed{};
  std::string assumed_source = kAssumedSource;
  bool list_assumptions = false;
  bool physics = false;
  std::string study{};
  std::int64_t runs = 1000;
  std::optional<std::uint64_t> seed{};
  int jobs = 0;
  Attrition attrition{};
  std::string out{};
  std::optional<Shard> shard{};
  std::string plot{};
  bool force = false;
  bool json = false;
  std::vector<std::filesystem::path> plugins{};

  Overwrite overwrite() const noexcept { return force ? Overwrite::allow : Overwrite::refuse; }
};

/// Refuses options of response tables with --physics, with the reason, and --study without it. Errors: WrongUsage.
void require_one_source(const PowerOptions& options);

/// The numbers of `--participants`. Errors: WrongUsage with the correct form.
std::vector<int> participants_of(const PowerOptions& options);

/// The protocol's assumptions with what a study, a file and --assume state in their place, in this order. What is taken from the study is
/// printed. Errors: WrongUsage; those of `assumptions_of`, `calibrated_by_study` and `with_assumptions_of_file`.
std::vector<Assumption> stated_assumptions(const PowerOptions& options, const Protocol& protocol);

/// The analysis without its studies: with the effects that were stated, from response tables. Errors: WrongUsage.
PowerReport report_of_tables(const PowerOptions& options, const ProtocolCheck& check,
                             const std::vector<Assumption>& assumptions);

/// The same with one effect, that of the observers.
PowerReport report_of_physics(const PowerOptions& options, const ProtocolCheck& check,
                              const PhysicsStudies& studies);

/// Prints what may be read wrongly: before hours of work.
void say_warnings(const PowerReport& report);

}  // namespace asperity
