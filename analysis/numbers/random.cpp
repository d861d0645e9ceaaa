// Philox4x32-10, its streams, and distributions made of exactly rounded operations.

#include "analysis/numbers/random.h"

#include <bit>
#include <cassert>
#include <cmath>

namespace asperity {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint32_t low_word(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
constexpr std::uint32_t high_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value >> 32);
}
constexpr std::uint64_t joined(std::uint32_t low, std::uint32_t high) {
  return (std::uint64_t{high} << 32) | low;
}

// What a stream is called: FNV-1a over the parent's stream, a mark for the kind of name, and the
// name, then the finaliser of SplitMix64, because FNV mixes its last byte poorly.
class StreamHash final {
 public:
  constexpr StreamHash(std::uint64_t parent, std::uint8_t kind) {
    add(parent);
    add(kind);
  }
  constexpr void add(std::uint8_t byte) {
    hash_ = (hash_ ^ byte) * 0x100000001b3U;  // FNV's 64-bit prime
  }
  constexpr void add(std::uint64_t number) {
    for (int byte = 0; byte < 8; ++byte) {
      add(static_cast<std::uint8_t>(number >> (8 * byte)));
    }
  }
  constexpr std::uint64_t value() const {
    std::uint64_t z = hash_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;  // FNV's 64-bit offset basis
};

// Natural logarithm of a normal positive number, to about one unit in the last place.
// x = m·2ᵉ with √½ ≤ m < √2; ln m = 2·artanh(s), s = (m−1)/(m+1), |s| < 0.172; the series in s² is
// cut where a term is below 2⁻⁵⁴.
double portable_log(double x) {
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  const auto x_bits = std::bit_cast<std::uint64_t>(x);
  int exponent = static_cast<int>(x_bits >> 52) - 1023;
  double m = std::bit_cast<double>((x_bits & kFraction) | (std::uint64_t{1023} << 52));
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int odd = 21; odd >= 3; odd -= 2) {
    series = (series + 1.0 / odd) * s2;
  }
  constexpr double kLn2 = 0.69314718055994530942;
  return exponent * kLn2 + (2.0 * s + 2.0 * s * series);
}

struct Rational {
  std::array<double, 8> numerator{};
  std::array<double, 8> denominator{};
};

double value_at(const Rational& of, double x) {
  double above = of.numerator[7];
  double below = of.denominator[7];
  for (std::size_t i = 7; i > 0; --i) {
    above = above * x + of.numerator[i - 1];
    below = below * x + of.denominator[i - 1];
  }
  return above / below;
}

// The three rational approximations of PPND16 in [Wichura 1988]; each is good to 1 in 10¹⁶.
constexpr Rational kCentre{
    {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
     1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
     3.3430575583588128105e4, 2.5090809287301226727e3},
    {1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3,
     2.1213794301586595867e4, 3.9307895800092710610e4, 2.8729085735721942674e4,
     5.2264952788528545610e3}};
constexpr Rational kShoulder{
    {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0,
     3.64784832476320460504e0, 1.27045825245236838258e0, 2.41780725177450611770e-1,
     2.27238449892691845833e-2, 7.74545014278341407640e-4},
    {1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
     1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4,
     1.05075007164441684324e-9}};
constexpr Rational kTail{
    {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0,
     2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
     2.71155556874348757815e-5, 2.01033439929228813265e-7},
    {1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
     7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7,
     2.04426310338993978564e-15}};

}  // namespace

std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter,
                                           std::array<std::uint32_t, 2> key) noexcept {
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53U;
  constexpr std::uint64_t kMultiplier1 = 0xCD9E8D57U;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9U;  // the golden ratio
  constexpr std::uint32_t kWeyl1 = 0xBB67AE85U;  // √3 − 1
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = kMultiplier0 * counter[0];
    const std::uint64_t product1 = kMultiplier1 * counter[2];
    counter = {high_word(product1) ^ counter[1] ^ key[0], low_word(product1),
               high_word(product0) ^ counter[3] ^ key[1], low_word(product0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

double upper_normal_quantile(double tail) noexcept {
  const double q = 0.5 - tail;
  if (q <= 0.425) {
    return q * value_at(kCentre, 0.180625 - q * q);
  }
  const double r = std::sqrt(-portable_log(tail));
  return r <= 5.0 ? value_at(kShoulder, r - 1.6) : value_at(kTail, r - 5.0);
}

Random::Random(std::uint64_t seed) noexcept : key_(seed) {}

Random Random::split(std::string_view name) const noexcept {
  StreamHash hash(stream_, 'n');
  for (const char c : name) {
    hash.add(static_cast<std::uint8_t>(c));
  }
  Random child(key_);
  child.stream_ = hash.value();
  return child;
}

Random Random::split(std::uint64_t number) const noexcept {
  StreamHash hash(stream_, '#');
  hash.add(number);
  Random child(key_);
  child.stream_ = hash.value();
  return child;
}

std::uint64_t Random::bits() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const auto block = philox4x32_10(
      {low_word(counter_), high_word(counter_), low_word(stream_), high_word(stream_)},
      {low_word(key_), high_word(key_)});
  ++counter_;
  spare_ = joined(block[2], block[3]);
  has_spare_ = true;
  return joined(block[0], block[1]);
}

double Random::uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Random::normal() noexcept {
  // One bit is the sign; 52 bits are the middle of one of 2⁵² equal cells of (0, ½). Everything up
  // to the quantile is exact, and both signs are equally likely to the bit.
  const std::uint64_t drawn = bits();
  const double tail = (static_cast<double>(drawn >> 12) + 0.5) * 0x1p-53;
  const double size = upper_normal_quantile(tail);
  return (drawn & 1U) != 0 ? -size : size;
}

std::uint64_t Random::below(std::uint64_t n) noexcept {
  assert(n > 0);
  Wide product = Wide{bits()} * n;
  auto rest = static_cast<std::uint64_t>(product);
  if (rest < n) {
    const std::uint64_t unfair = (0 - n) % n;  // 2⁶⁴ mod n: so many remainders come once too often
    while (rest < unfair) {
      product = Wide{bits()} * n;
      rest = static_cast<std::uint64_t>(product);
    }
  }
  return static_cast<std::uint64_t>(product >> 64);
}

}  // namespace asperity
