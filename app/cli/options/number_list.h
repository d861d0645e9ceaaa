// Lists of numbers on the command line.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The numbers of a list. `option`: its name; `expected`: the correct form, for the error.
///
/// Errors: WrongUsage naming the part that is not a number.
inline std::vector<double> numbers_of(const std::string& option, const std::string& text,
                                      char separator, const std::string& expected) {
  std::vector<double> numbers{};
  for (const std::string& piece : parts_of(text, separator)) {
    const std::optional<double> number = number_in(piece);
    if (!number) {
      throw WrongUsage(option + " " + text + ": \"" + piece + "\" is not a number; " + expected);
    }
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace asperity
