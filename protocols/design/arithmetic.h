// Formulas that compute a level from other levels.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// Why a text is not a formula: a sentence without its end, "a number, a factor or ( is missing after character 5".
struct ArithmeticProblem {
  Phrase text{};
};

/// A formula of numbers, names, +, −, *, / and parentheses, with the usual precedence, evaluated in double precision:
/// "speed / spacing", "2 * (1 - share)". Names have the form of names in a protocol.
class Arithmetic {
 public:
  static std::variant<Arithmetic, ArithmeticProblem> parse(std::string_view text);

  /// In the order of their first use.
  const std::vector<std::string>& names() const noexcept { return names_; }
  /// Infinite or NaN where a divisor is 0.
  double value(const std::function<double(const std::string& name)>& of_name) const;

 private:
  friend class ArithmeticParser;
  /// In reverse Polish notation: numbers, indices of names, and operators; 'n' negates.
  using Token = std::variant<double, std::size_t, char>;
  std::vector<Token> tokens_{};
  std::vector<std::string> names_{};
};

}  // namespace asperity
