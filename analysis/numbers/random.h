// The one random generator of the project, and its distributions.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace asperity {

/// One block of Philox4x32-10: ten rounds that turn a counter into four random words [Salmon 2011].
/// Word 0 is the least significant one. Random is built on this; tests hold it to published
/// answers.
std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter,
                                           std::array<std::uint32_t, 2> key) noexcept;

/// What a standard normal number exceeds with probability `tail`, 0 < tail ≤ ½, by the three
/// rational functions of [Wichura 1988] and a logarithm of our own: good to about 1 in 10¹⁵, and
/// the same bits everywhere.
double upper_normal_quantile(double tail) noexcept;

/// Random numbers that are the same on every platform, for ever.
///
/// A counter-based generator, Philox4x32-10: the n-th number of a stream is a function of the seed,
/// the stream and n, with no state to warm up. The seed is Philox's key; the block number stands in
/// the lower two words of its counter and the stream in the upper two; a block gives two numbers.
/// So streams of one seed never overlap unless they are the same stream, and each is 2⁶⁵ numbers
/// long.
///
/// Streams are split by name or number: `seeded.split("plan")` and `seeded.split("hand")` are
/// different streams, and drawing from one does not move the other. A child depends on its parent's
/// stream and on the name, not on how much the parent has drawn. Its stream is a 64-bit hash of
/// both, so two of n streams coincide with a probability near n²/2⁶⁵: 3·10⁻⁸ for a million.
///
/// The distributions are our own, built on integer and exactly rounded IEEE arithmetic (+, −, ×, ÷,
/// √; no libm), because those of the standard library differ between implementations. `normal` is
/// the inverse of the normal distribution [Wichura 1988] at a 53-bit uniform number, so one draw
/// costs one number and |z| ≤ 8.30.
///
/// Real-time: nothing here allocates, locks or throws. `normal` takes some 20 to 30 ns, never a
/// varying number of draws.
///
/// [Salmon 2011] Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3.
/// [Wichura 1988] Wichura: Algorithm AS 241: the percentage points of the normal distribution.
/// [Lemire 2019] Lemire: Fast random integer generation in an interval.
class Random final {
 public:
  /// What a session stores, so that its numbers can be drawn again. A change of any number that is
  /// drawn, by whatever function, is a change of this name.
  static constexpr std::string_view kName = "philox4x32-10/1";

  explicit Random(std::uint64_t seed) noexcept;

  /// Another stream of the same seed, at its beginning. A name and a number never mean the same.
  Random split(std::string_view name) const noexcept;
  Random split(std::uint64_t number) const noexcept;

  std::uint64_t bits() noexcept;  ///< 64 random bits
  double uniform() noexcept;      ///< in [0, 1), a multiple of 2⁻⁵³
  double normal() noexcept;       ///< mean 0, standard deviation 1
  /// In [0, n), without bias [Lemire 2019]. `n` must be positive.
  std::uint64_t below(std::uint64_t n) noexcept;

  /// Fisher–Yates: every order is equally likely.
  template <class T>
  void shuffle(std::span<T> items) noexcept {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(below(i))]);
    }
  }

 private:
  std::uint64_t key_ = 0;
  std::uint64_t stream_ = 0;
  std::uint64_t counter_ = 0;
  std::uint64_t spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace asperity
