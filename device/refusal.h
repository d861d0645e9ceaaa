// How a number is refused.

#pragma once

#include <string_view>

namespace asperity {

/// Throws std::invalid_argument with the field's name and value unless it is positive and finite.
void require_positive(std::string_view field, double value);

/// The same, but zero is allowed.
void require_not_negative(std::string_view field, double value);

/// Throws std::invalid_argument: "`field` is `value`; it must be `right`."
[[noreturn]] void refuse(std::string_view field, double value, std::string_view right);

}  // namespace asperity
