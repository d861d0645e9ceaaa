// What a share of right answers alone says about transmitted information.

#pragma once

#include <cstddef>

namespace asperity {

/// The information in bits that answers among m labels, equally often presented, transmit when a
/// share p of them is right and all m(m − 1) errors are equally frequent,
///
///   log₂m + p·log₂p + (1 − p)·log₂((1 − p)/(m − 1)):
///
/// Fano's bound, since any other errors transmit more. Throws std::invalid_argument for fewer than
/// two labels and for a share outside 0 to 1.
double equal_error_bits(double share, std::size_t labels);

}  // namespace asperity
