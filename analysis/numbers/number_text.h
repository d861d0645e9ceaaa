// Numbers and counts as text, the same in every locale.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// The shortest decimal text that reads back as the same number, always with a point.
std::string number_text(double number);

/// With so many decimals, always with a point; what is rounded to nothing has no sign.
std::string fixed(double number, int decimals);

/// `number` · 10^`places`, exact to the last digit: only the decimal point moves, as between units of one quantity.
/// ("2.3", −3) is "0.0023", ("5e-05", 6) is "50"; with 0 places the text is unchanged. Otherwise there are no
/// superfluous zeros, and an exponent only below 10⁻⁶ and from 10²¹ on.
///
/// nullopt if the text is not a number of JSON, or has an exponent of more than 4 digits.
std::optional<std::string> shifted_decimal(std::string_view number, int places);

/// A count with its noun: "1 vertex", "2 vertices", "0 vertices".
std::string counted(std::size_t number, std::string_view one, std::string_view several);

}  // namespace asperity
