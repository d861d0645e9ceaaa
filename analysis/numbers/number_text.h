// Numbers and counts as text, the same in every locale.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// The shortest decimal text that reads back as the same number, always with a point.
std::string number_text(double number);

/// With so many decimals, always with a point; what is rounded to nothing has no sign.
std::string fixed(double number, int decimals);

/// A count with its noun: "1 vertex", "2 vertices", "0 vertices".
std::string counted(std::size_t number, std::string_view one, std::string_view several);

}  // namespace asperity
