// Squares for every size that a study may use.

#include "protocols/plan/squares.h"

#include <map>
#include <set>

namespace asperity {
namespace {

std::map<std::pair<std::size_t, std::size_t>, int> places_in(const Square& square) {
  std::map<std::pair<std::size_t, std::size_t>, int> counts{};
  for (const auto& row : square) {
    for (std::size_t i = 0; i < row.size(); ++i) ++counts[{row[i], i}];
  }
  return counts;
}

class Squares : public testing::TestWithParam<std::size_t> {};

TEST_P(Squares, LatinHasEveryItemOnceInEveryPosition) {
  const std::size_t n = GetParam();
  const Square square = latin_square(n);
  ASSERT_EQ(square.size(), n);
  const auto counts = places_in(square);
  EXPECT_EQ(counts.size(), n * n);
  for (const auto& [place, count] : counts) EXPECT_EQ(count, 1);
}

TEST_P(Squares, WilliamsHasEveryItemEquallyOftenInEveryPosition) {
  const std::size_t n = GetParam();
  const Square square = williams_square(n);
  ASSERT_EQ(square.size(), n % 2 == 0 ? n : 2 * n);
  const auto counts = places_in(square);
  EXPECT_EQ(counts.size(), n * n);
  for (const auto& [place, count] : counts) EXPECT_EQ(count, n % 2 == 0 ? 1 : 2);
}

TEST_P(Squares, WilliamsHasEveryItemAfterEveryOtherEquallyOften) {
  const std::size_t n = GetParam();
  std::map<std::pair<std::size_t, std::size_t>, int> neighbours{};
  for (const auto& row : williams_square(n)) {
    for (std::size_t i = 1; i < row.size(); ++i) ++neighbours[{row[i - 1], row[i]}];
  }
  EXPECT_EQ(neighbours.size(), n * (n - 1));
  for (const auto& [pair, count] : neighbours) EXPECT_EQ(count, n % 2 == 0 ? 1 : 2);
}

TEST_P(Squares, EachHalfOfAnOddWilliamsSquareIsALatinSquare) {
  const std::size_t n = GetParam();
  const Square square = williams_square(n);
  for (std::size_t from = 0; from < square.size(); from += n) {
    const Square half(square.begin() + static_cast<std::ptrdiff_t>(from),
                      square.begin() + static_cast<std::ptrdiff_t>(from + n));
    EXPECT_EQ(places_in(half).size(), n * n);
  }
}

INSTANTIATE_TEST_SUITE_P(TwoToEight, Squares, testing::Range<std::size_t>(2, 9));

TEST(Squares, OfOneItemIsOneRow) {
  EXPECT_EQ(latin_square(1), Square{{0}});
  EXPECT_EQ(williams_square(1), Square{{0}});
}

}  // namespace
}  // namespace asperity
