// A demonstration study on disk whose protocols a test changes, simulates and counts.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

/// Which observer a gate judges.
enum class GateObserver { deaf, noiseless };

/// A library protocol, and how often it is done.
struct GateDesign {
  std::string_view protocol{};
  GateObserver observer = GateObserver::deaf;
  int repetitions = 1;  ///< of the main block's rows
  int participants = 1;
  std::vector<std::uint64_t> seeds{};
  std::optional<int> strokes{};  ///< over each surface; otherwise as many as the protocol asks for
};

/// A library protocol as it comes, but for what `change` does to its JSON.
Protocol library_protocol(std::string_view name,
                          const std::function<void(nlohmann::ordered_json&)>& change = {});

/// What a gate counts of one kind, pooled over participants and seeds.
struct GateCounts {
  std::size_t trials = 0;
  std::size_t items = 0;
  std::size_t right = 0;          ///< items
  std::size_t whole = 0;          ///< trials with every item right
  std::size_t guess_sources = 0;  ///< trials whose every answer is stored as virtual_guess
  std::map<std::string, std::size_t> chosen{};  ///< answers, by what was chosen
  std::map<std::string, std::size_t> orders{};  ///< of the surfaces by their items
  /// Of the surfaces in one trial and in the next one of the session.
  std::map<std::pair<std::string, std::string>, std::size_t> order_pairs{};
};

/// Textures and protocols of the demonstration, in a folder that is gone after the test.
class SimulatedStudy final {
 public:
  SimulatedStudy();

  /// Simulates `participants` for each seed, with the protocol reduced to its main block, without
  /// breaks and pauses.
  GateCounts run(const GateDesign& design);

 private:
  TemporaryFolder folder_{};
};

}  // namespace asperity
