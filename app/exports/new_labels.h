// Random labels for the participants of an export.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// Returns 64 random bits with each call.
using RandomBits = std::function<std::uint64_t()>;

/// The random numbers of the operating system, which no other program can reproduce. With a seed of 64 bits or less the
/// assignment could be found by trying seeds.
RandomBits random_bits_of_this_machine();

/// Draws `count` different labels of five consonants, such as "kzmqt", that spell neither a word nor a number.
/// None of them is one of `taken`, whether in capitals or not, so that no new label can be mistaken for an old one.
/// Errors: std::invalid_argument for more labels than one in four of those that there are.
std::vector<std::string> drawn_labels(std::size_t count, const std::vector<std::string>& taken,
                                      const RandomBits& bits);

}  // namespace asperity
