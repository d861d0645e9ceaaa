// The one random generator of the project, and its distributions.

#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace asperity {

/// Random numbers that are the same on every platform, for ever.
///
/// A counter-based generator, Philox4x32-10: the n-th number of a stream is a function of the seed,
/// the stream and n, with no state to warm up. Streams are split by name or number:
/// `seeded.split("plan")` never overlaps `seeded.split("hand")`, and drawing from one does not move
/// the other. The distributions are our own, built on IEEE arithmetic that is exactly rounded (no
/// libm), because those of the standard library differ between implementations.
///
/// Real-time: nothing here allocates, locks or throws.
///
/// [Salmon 2011] Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3.
class Random final {
 public:
  /// What a session stores, so that its numbers can be drawn again.
  static constexpr std::string_view kName = "philox4x32-10/1";

  explicit Random(std::uint64_t seed) noexcept;

  /// An independent stream.
  Random split(std::string_view name) const noexcept;
  Random split(std::uint64_t number) const noexcept;

  std::uint64_t bits() noexcept;  ///< 64 random bits
  double uniform() noexcept;      ///< in [0, 1), a multiple of 2⁻⁵³
  double normal() noexcept;       ///< mean 0, standard deviation 1
  /// In [0, n), without bias. `n` must be positive.
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
