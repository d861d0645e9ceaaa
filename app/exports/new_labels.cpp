// Draws five letters with equal probabilities from random bits, and omits labels that are taken.

#include "app/exports/new_labels.h"

#include <cctype>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace asperity {
namespace {

constexpr std::string_view kLetters = "bcdfghjkmnpqrstvwxz";  // l looks like 1
constexpr std::size_t kLength = 5;

std::size_t number_of_labels() {
  std::size_t number = 1;
  for (std::size_t i = 0; i < kLength; ++i) number *= kLetters.size();
  return number;
}

char drawn_letter(const RandomBits& bits) {
  // The bits that would make the first letters more probable are drawn again.
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  constexpr std::uint64_t kEnd = kMost - kMost % kLetters.size();
  std::uint64_t value = bits();
  while (value >= kEnd) value = bits();
  return kLetters[static_cast<std::size_t>(value % kLetters.size())];
}

std::string in_small_letters(std::string label) {
  for (char& letter : label) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return label;
}

}  // namespace

RandomBits random_bits_of_this_machine() {
  return [] {
    std::random_device source;
    return (std::uint64_t{source()} << 32U) | source();
  };
}

std::vector<std::string> drawn_labels(std::size_t count, const std::vector<std::string>& taken,
                                      const RandomBits& bits) {
  if (count > number_of_labels() / 4) {
    throw std::invalid_argument("new labels cannot be drawn for " + std::to_string(count) +
                                " participants; there are " + std::to_string(number_of_labels()) +
                                " labels");
  }
  std::set<std::string> used{};
  for (const std::string& label : taken) used.insert(in_small_letters(label));
  std::vector<std::string> labels{};
  while (labels.size() < count) {
    std::string label{};
    for (std::size_t i = 0; i < kLength; ++i) label += drawn_letter(bits);
    if (used.insert(label).second) labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace asperity
