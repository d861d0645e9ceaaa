// Implements Latin squares by rotation of a first row.

#include "protocols/plan/squares.h"

#include <algorithm>

namespace asperity {

namespace {

Square rotations_of(const std::vector<std::size_t>& first) {
  Square square{};
  const std::size_t n = first.size();
  for (std::size_t r = 0; r < n; ++r) {
    std::vector<std::size_t> row(n);
    for (std::size_t i = 0; i < n; ++i) row[i] = (first[i] + r) % n;
    square.push_back(row);
  }
  return square;
}

}  // namespace

Square latin_square(std::size_t n) {
  std::vector<std::size_t> first(n);
  for (std::size_t i = 0; i < n; ++i) first[i] = i;
  return rotations_of(first);
}

Square williams_square(std::size_t n) {
  // 0, 1, n−1, 2, n−2, …: for even n the differences between neighbours are all different (mod n); for odd n each
  // occurs twice with one sign, and with the other sign in the reversed rows.
  std::vector<std::size_t> first{};
  for (std::size_t i = 0; i < n; ++i) first.push_back(i % 2 == 1 ? (i + 1) / 2 : (n - i / 2) % n);
  Square square = rotations_of(first);
  if (n % 2 == 1 && n > 1) {
    for (std::size_t r = 0; r < n; ++r) {
      std::vector<std::size_t> row = square[r];
      std::reverse(row.begin(), row.end());
      square.push_back(row);
    }
  }
  return square;
}

}  // namespace asperity
