// The assumptions from which studies of a protocol are simulated without rendering.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// A number that simulated responses depend on, of one question of one block.
struct Assumption {
  /// The part that it has in a response table.
  enum class Part {
    effect,  ///< what a test of the protocol is to find; `null_value` where there is nothing to find
    effect_sd,  ///< how far participants (or textures) differ in an effect: it has to be stated
    other,  ///< anything else: criterion, noise, lapses, order effects, their standard deviations
  };
  std::string name{};  ///< "BLOCK.QUESTION.PARAMETER", "comparisons.rougher.order"
  Part part = Part::other;
  std::optional<double> value{};  ///< none: it has to be stated
  std::string unit{};             ///< "1" for a pure number
  std::string source{};           ///< "assumed", or where the value is from
  std::string meaning{};          ///< a clause
  double null_value = 0.0;        ///< of an effect
  std::string tests{};  ///< of an effect: the names of the tests that it concerns, "order"
};

/// All assumptions of a protocol, with the values that are usually assumed: effects and their standard deviations have none.
///
/// Errors: std::runtime_error for a kind of trial without a response table, and for a procedure whose levels an external
/// program states; the message names block, kind and remedy.
std::vector<Assumption> assumptions_of(const Protocol& protocol);

/// The assumptions with those that a JSON file states in their place: an array of objects with "name", "value" and "source",
/// and optionally "unit", which must be equal. Errors: std::runtime_error naming the file, the entry and the remedy.
std::vector<Assumption> with_assumptions_of_file(std::vector<Assumption> assumptions,
                                                 const std::string& path);
/// The text of such a file, with all assumptions; a missing value is null.
std::string json_of(const std::vector<Assumption>& assumptions);

/// A protocol with all its assumptions, checked. Shared by all simulated runs, and never changed.
class PowerModel final {
 public:
  /// Errors: std::runtime_error listing the assumptions without a value (with the remedy), those that the protocol does not
  /// have, and values out of range.
  PowerModel(Protocol protocol, std::vector<Assumption> assumptions);

  const Protocol& protocol() const noexcept { return protocol_; }
  const std::vector<Assumption>& assumptions() const noexcept { return assumptions_; }
  /// Number of participants in one round of counterbalancing rows and groups.
  int multiple() const noexcept { return multiple_; }
  /// The same model with all effects at their null value, and the standard deviations of the effects kept.
  PowerModel at_null() const;

 private:
  Protocol protocol_;
  std::vector<Assumption> assumptions_{};
  int multiple_ = 1;
};

}  // namespace asperity
