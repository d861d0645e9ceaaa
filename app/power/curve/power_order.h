// Declares the simulated studies of a power analysis, and the order in which they are numbered.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What is simulated. Two orders that differ in `runs` alone have the same studies, as far as both have them.
struct PowerOrder {
  std::vector<std::string> effects{};  ///< as stated: "comparisons.rougher.slope=0.8"; at least one
  std::vector<int> participants{};     ///< ascending, from 1 on
  std::uint64_t seed = 1;
  std::int64_t runs = 1000;       ///< studies of each effect and number of participants
  std::string protocol_sha256{};  ///< of its text
  std::string
      assumptions_sha256{};  ///< of all assumptions, without the effects that `effects` states
  /// Of what responses on the full physics depend on in addition; none of studies from response tables.
  std::optional<std::string> physics_sha256{};
  std::string program{};  ///< version and commit
};

/// Errors: std::invalid_argument for empty lists, an effect that occurs twice, numbers of participants that do not ascend, and
/// fewer than one run.
void require_order(const PowerOrder& order);

/// One study.
struct StudyPlace {
  std::int64_t run = 0;
  std::size_t effect = 0;  ///< of PowerOrder::effects
  std::size_t size = 0;    ///< of PowerOrder::participants
  bool operator==(const StudyPlace&) const = default;
};

/// The number of studies of one run: of every effect with every number of participants.
std::int64_t studies_per_run(const PowerOrder& order);
/// The place of study number `index`, from 0: runs one after the other, in each the effects, of each the numbers of
/// participants. More runs follow those that are there.
StudyPlace place_of(const PowerOrder& order, std::int64_t index);

/// JSON, `asperity.power_studies/1`: all of the order except `runs`.
std::string declaration_of(const PowerOrder& order);
/// The names of what differs between two declarations, for a sentence: "the protocol and the seed"; empty where nothing does,
/// "the format" where `other` is not a declaration.
std::string differences(const std::string& declaration, const std::string& other);

}  // namespace asperity
