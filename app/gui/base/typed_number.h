// Converts numbers between what is typed and shown in windows and the notation of files.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QtCore/QString>

#include "protocols/shapes/shape.h"

namespace asperity {

/// A number as it is typed, with a decimal comma or point and a hyphen or minus sign, in the notation of files.
std::string decimal_of(QString typed);
/// A number of a file with the decimal point of the windows' language and a minus sign.
QString shown_decimal(std::string_view in_file);

/// The number in the unit of the file, of one that is typed in the unit for display; nullopt for what is not a number.
std::optional<std::string> number_typed(const NumberShape& shape, const QString& typed);
/// The unit for display; empty: none.
QString shown_unit(const NumberShape& shape);
/// The reverse. What is not a number is shown unconverted.
QString shown_in_unit(const NumberShape& shape, std::string_view in_file);

}  // namespace asperity
