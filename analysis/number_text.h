// A number as text, the same in every locale.

#pragma once

#include <string>

namespace asperity {

/// The shortest decimal text that reads back as the same number, always with a point.
std::string number_text(double number);

/// With so many decimals, always with a point; what is rounded to nothing has no sign.
std::string fixed(double number, int decimals);

}  // namespace asperity
