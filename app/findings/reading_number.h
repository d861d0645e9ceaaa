// Numbers as people read them: the digits that mean something, and no more.

#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// Four digits, whole numbers whole, very small and very large ones in powers of ten: "0.6041",
/// "2.5e-23".
std::string reading_number(double value);

/// "p = .011", and "p < .001" below that: a p never reaches 1 in front of its point.
std::string reading_p(double p);

/// The same under a heading that says p: ".011", "< .001".
std::string reading_p_cell(double p);

/// "78 %"; one decimal where a whole per cent would read 0 or 100 of what is neither, and "< 0.1 %" or "> 99.9 %" where a
/// decimal would as well: a limit on the logit scale is never 0 or 1.
std::string reading_percent(double share);

/// So many decimals, with a minus that is as broad as a plus; what rounds to nothing has no sign.
std::string reading_signed(double value, int decimals);

/// So many decimals of what cannot exceed 1, such as a correlation: without the zero before the point, as the APA prints it:
/// ".71", "−.10", "1.00".
std::string reading_bounded(double value, int decimals = 2);

/// A difference of proportions in percentage points, one decimal: "−16.7".
std::string reading_points(double difference);

/// Three digits and the unit with the SI prefix that suits them: "31 µs", "50 mm/s", "0.8 N". A
/// value of unit "1" or without one has none.
std::string reading_quantity(double value, const std::string& unit);

/// "1 234 567", with thin spaces that do not break.
std::string reading_count(std::uint64_t count);

/// "no", "one" … "nine", then digits: as counts stand in a sentence.
std::string count_in_words(std::uint64_t count);

}  // namespace asperity
