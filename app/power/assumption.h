// One number from which studies are simulated, and the file that states such numbers.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/kinds/response_table.h"

namespace asperity {

/// A number that simulated responses depend on, of one question of one block.
struct Assumption {
  using Part = ResponseParameter::Part;

  std::string name{};  ///< "BLOCK.QUESTION.PARAMETER", "comparisons.rougher.order"
  Part part = Part::other;
  std::optional<double> value{};  ///< none: it has to be stated
  std::string unit = "1";         ///< "1" of a pure number
  std::string source{};           ///< "assumed", or where the value is from
  Phrase meaning{};               ///< a clause
  double null_value = 0.0;        ///< of an effect
  std::string
      tests{};  ///< of an effect: the names of the tests that it concerns, "pairs, preference"
  ParameterRange range = ParameterRange::any;
};

/// The source of a value that nobody has stated.
inline constexpr const char* kAssumed = "assumed";
/// That of an effect with its null value.
inline constexpr const char* kNoEffect = "no effect";

/// Whether the name is `name`, or ends with it after a point: "order" is the order effect of every question that has one.
bool is_named(const Assumption& assumption, std::string_view name);

/// Sets the value and the source of those that are named `name`. Errors: std::runtime_error where there are none, listing the
/// names; an empty source.
void set_assumption(std::span<Assumption> assumptions, std::string_view name, double value,
                    const std::string& source);

/// The assumptions with what a JSON file states in their place: an array of objects with "name" (as in `set_assumption`), "value" and "source". Further keys that
/// `json_of` writes are compared ("unit") or not read ("meaning", "part", "tests", "null_value"); an entry whose value is null is
/// not read. Errors: std::runtime_error naming the file and the entry.
std::vector<Assumption> with_assumptions_of_file(std::vector<Assumption> assumptions,
                                                 const std::string& path);
/// The text of such a file with all assumptions; a missing value is null.
std::string json_of(std::span<const Assumption> assumptions);

}  // namespace asperity
