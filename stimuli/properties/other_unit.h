// The number that was probably meant where one outside its limits is written in another unit than that of its name.

#pragma once

#include <functional>
#include <string_view>

#include "analysis/words/phrase.h"

namespace asperity {

/// The context of numbers in the unit of the file, of the value that a sentence is about: a form shows them in its own unit.
inline constexpr const char* kNumbersOfFile = "NumbersOfFile";
Phrase number_of_file(std::string_view number);
/// The context of the unit after such a number, with a space before it: a form has written its own with the number.
inline constexpr const char* kUnitOfNumber = "UnitOfNumber";

/// The context of the phrases about other units.
inline constexpr const char* kUnitsOfFile = "UnitsOfFile";

/// "; lengths are in metres: 2.3 mm is 0.0023", for the end of a sentence about `number`, which is in `unit` ("m") and not
/// permitted. Empty if there is no usual other unit of the quantity in which the number would be permitted.
Phrase meant_in_other_unit(double number, std::string_view unit,
                           const std::function<bool(double)>& is_permitted);

}  // namespace asperity
