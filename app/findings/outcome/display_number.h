// Formats numbers for display, with their significant digits.

#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// Four digits, integers without decimals, very small and very large numbers in powers of ten:
/// "0.6041", "−12", "2.5e-23".
std::string display_number(double value);

/// "p = .011", and "p < .001" below that; without the zero before the point.
std::string display_p(double p);

/// The same under a column heading that names p: ".011", "< .001".
std::string display_p_cell(double p);

/// "78 %"; one decimal where a whole per cent would be 0 or 100 for a proportion that is neither 0
/// nor 1, and "< 0.1 %" or "> 99.9 %" where a decimal would be as well: a limit on the logit scale
/// is never 0 or 1.
std::string display_percent(double share);

/// This many decimals, with a minus that is as wide as a plus; a number that rounds to zero has no
/// sign.
std::string display_signed(double value, int decimals);

/// The decimals of a number whose interval has this width, or of a standard error or other number of this size: as many as show two
/// significant digits of it, but at least two and at most five. "0.93 [0.87, 0.99]", "1.0012 [0.9993, 1.0031]".
int decimals_of(double size);

/// The decimals of heights in µm of this size: below 10 µm as many as show three significant digits, at most nine; from there
/// `coarse`. A relief of nanometres would be "0.0 µm" otherwise.
int decimals_of_height(double size_um, int coarse);

/// This many decimals of a number that cannot exceed 1, such as a correlation: without the zero
/// before the point, in APA style: ".71", "−.10", "1.00".
std::string display_bounded(double value, int decimals = 2);

/// A difference of proportions in percentage points, one decimal: "−16.7".
std::string display_points(double difference);

/// A stated number with all of its digits and a suitable SI prefix of its unit: "102.5 µm".
std::string stated_quantity(double value, const std::string& unit);

/// Three digits and the unit with a suitable SI prefix: "31 µs", "50 mm/s", "0.8 N". A value of
/// unit "1" or without a unit has none.
std::string display_quantity(double value, const std::string& unit);

/// "1 234 567", with narrow no-break spaces.
std::string display_count(std::uint64_t count);

/// "−3": a whole number with a minus sign.
std::string display_whole(std::int64_t value);

/// The same text with no-break spaces within its numbers, for pages and labels that are broken into
/// lines: "[0.16, 0.49]", "F(2, 38) = 5.17", "p = .031", "N = 20", "62 %", "4 N".
std::string with_numbers_unbroken(const std::string& text);

/// "no", "one" … "nine", then digits: counts in running text.
std::string count_in_words(std::uint64_t count);

}  // namespace asperity
