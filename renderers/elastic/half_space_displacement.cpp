// Implements the convolution with the kernel of the half-space.

#include "renderers/elastic/half_space_displacement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderers/elastic/love_kernel.h"

namespace asperity {
namespace {

/// One turn p of a step: four rows of `run` numbers, `apart` from each other, are combined into four rows that follow each other.
/// The factors are exp(−2πi·kp/length) for k = 1, 2, 3, as cosine and sine.
struct Butterflies {
  double c1 = 1.0;
  double s1 = 0.0;
  double c2 = 1.0;
  double s2 = 0.0;
  double c3 = 1.0;
  double s3 = 0.0;
  std::size_t run = 0;
  std::size_t apart = 0;
  const double* from_re = nullptr;
  const double* from_im = nullptr;
  double* to_re = nullptr;
  double* to_im = nullptr;
};

// Without contraction every instruction set gives the same bits. The rows do not overlap, which the compiler would not examine: it
// would have to compare twelve pairs of them.
[[gnu::always_inline]] inline void combine(const Butterflies& butterflies) noexcept {
  const auto [c1, s1, c2, s2, c3, s3, run, apart, a_re, a_im, to_re, to_im] = butterflies;
#pragma GCC ivdep
  for (std::size_t i = 0; i < run; ++i) {
    const double even_re = a_re[i] + a_re[i + 2 * apart];
    const double even_im = a_im[i] + a_im[i + 2 * apart];
    const double odd_re = a_re[i] - a_re[i + 2 * apart];
    const double odd_im = a_im[i] - a_im[i + 2 * apart];
    const double sum_re = a_re[i + apart] + a_re[i + 3 * apart];
    const double sum_im = a_im[i + apart] + a_im[i + 3 * apart];
    const double turned_re = a_im[i + 3 * apart] - a_im[i + apart];  // i·(b − d)
    const double turned_im = a_re[i + apart] - a_re[i + 3 * apart];
    const double one_re = odd_re - turned_re;
    const double one_im = odd_im - turned_im;
    const double two_re = even_re - sum_re;
    const double two_im = even_im - sum_im;
    const double three_re = odd_re + turned_re;
    const double three_im = odd_im + turned_im;
    to_re[i] = even_re + sum_re;
    to_im[i] = even_im + sum_im;
    to_re[i + run] = c1 * one_re + s1 * one_im;
    to_im[i + run] = c1 * one_im - s1 * one_re;
    to_re[i + 2 * run] = c2 * two_re + s2 * two_im;
    to_im[i + 2 * run] = c2 * two_im - s2 * two_re;
    to_re[i + 3 * run] = c3 * three_re + s3 * three_im;
    to_im[i + 3 * run] = c3 * three_im - s3 * three_re;
  }
}

void combine_by_two(const Butterflies& butterflies) noexcept { combine(butterflies); }
[[gnu::target("avx2")]] void combine_by_four(const Butterflies& butterflies) noexcept {
  combine(butterflies);
}

using Combine = void(const Butterflies& butterflies) noexcept;
Combine* const kCombineHere = __builtin_cpu_supports("avx2") ? combine_by_four : combine_by_two;

}  // namespace

// Three steps of radix 4, from one buffer to the other and without bit reversal (Stockham): the innermost loop runs over
// contiguous numbers. `batch` transforms lie next to each other.
void HalfSpaceDisplacement::transform(std::size_t batch, double*& re, double*& im,
                                      double*& other_re, double*& other_im) const noexcept {
  std::size_t stride = 1;
  for (std::size_t length = kPadded; length > 1; length /= 4, stride *= 4) {
    const std::size_t quarter = length / 4;
    const std::size_t run = stride * batch;
    for (std::size_t p = 0; p < quarter; ++p) {
      const std::size_t turn = p * stride;
      kCombineHere({.c1 = cosine_[turn],
                    .s1 = sine_[turn],
                    .c2 = cosine_[2 * turn],
                    .s2 = sine_[2 * turn],
                    .c3 = cosine_[3 * turn],
                    .s3 = sine_[3 * turn],
                    .run = run,
                    .apart = quarter * run,
                    .from_re = re + p * run,
                    .from_im = im + p * run,
                    .to_re = other_re + 4 * p * run,
                    .to_im = other_im + 4 * p * run});
    }
    std::swap(re, other_re);
    std::swap(im, other_im);
  }
}

void HalfSpaceDisplacement::unpack_columns(const double* re, const double* im, double* lines_re,
                                           double* lines_im) const noexcept {
  for (std::size_t line = 0; line <= kCellsAcross; ++line) {
    const double* const a_re = re + line * kPairs;
    const double* const a_im = im + line * kPairs;
    const std::size_t mirrored = (kPadded - line) % kPadded;
    const double* const b_re = re + mirrored * kPairs;
    const double* const b_im = im + mirrored * kPairs;
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
      lines_re[pair * kLines + line] = 0.5 * (a_re[pair] + b_re[pair]);
      lines_im[pair * kLines + line] = 0.5 * (a_im[pair] - b_im[pair]);
      lines_re[(pair + kPairs) * kLines + line] = 0.5 * (a_im[pair] + b_im[pair]);
      lines_im[(pair + kPairs) * kLines + line] = 0.5 * (b_re[pair] - a_re[pair]);
    }
  }
}

void HalfSpaceDisplacement::pack_columns(const double* lines_re, const double* lines_im, double* re,
                                         double* im) const noexcept {
  for (std::size_t line = 0; line <= kCellsAcross; ++line) {
    const std::size_t mirrored = (kPadded - line) % kPadded;
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
      const double first_re = lines_re[pair * kLines + line];
      const double first_im = lines_im[pair * kLines + line];
      const double second_re = lines_re[(pair + kPairs) * kLines + line];
      const double second_im = lines_im[(pair + kPairs) * kLines + line];
      // The mirrored line first: of the lines 0 and 32, which are their own mirror images, this one is overwritten.
      re[mirrored * kPairs + pair] = first_re + second_im;
      im[mirrored * kPairs + pair] = second_re - first_im;
      re[line * kPairs + pair] = first_re - second_im;
      im[line * kPairs + pair] = first_im + second_re;
    }
  }
}

HalfSpaceDisplacement::HalfSpaceDisplacement() {
  for (std::size_t i = 0; i < kPadded; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / kPadded;
    cosine_[i] = std::cos(angle_rad);
    sine_[i] = std::sin(angle_rad);
  }
  // K is real and even: its transform is a sum of cosines, first along y and then along x.
  constexpr auto distance = [](std::size_t i) { return i <= kCellsAcross ? i : kPadded - i; };
  std::array<std::array<double, kCellsAcross + 1>, kCellsAcross + 1> along_y{};
  constexpr double kScale = 1.0 / (kPadded * kPadded);  // of the inverse transforms
  for (std::size_t x = 0; x <= kCellsAcross; ++x) {
    for (std::size_t line = 0; line <= kCellsAcross; ++line) {
      for (std::size_t y = 0; y < kPadded; ++y) {
        along_y[x][line] +=
            cosine_[y * line % kPadded] *
            love_displacement(static_cast<double>(x), static_cast<double>(distance(y)));
      }
    }
  }
  for (std::size_t across = 0; across < kPadded; ++across) {
    for (std::size_t line = 0; line <= kCellsAcross; ++line) {
      double sum = 0.0;
      for (std::size_t x = 0; x < kPadded; ++x) {
        sum += cosine_[x * across % kPadded] * along_y[distance(x)][line];
      }
      spectrum_[across * kLines + line] = kScale * sum;
    }
  }
}

void HalfSpaceDisplacement::of(const CellField& load_m, CellField& displacement_m) noexcept {
  double* re = one_.re.data();
  double* im = one_.im.data();
  double* other_re = two_.re.data();
  double* other_im = two_.im.data();
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    std::copy_n(&load_m[row * kCellsAcross], kPairs, re + row * kPairs);
    std::copy_n(&load_m[row * kCellsAcross + kPairs], kPairs, im + row * kPairs);
  }
  std::fill_n(re + kCellsAcross * kPairs, kCellsAcross * kPairs, 0.0);
  std::fill_n(im + kCellsAcross * kPairs, kCellsAcross * kPairs, 0.0);
  transform(kPairs, re, im, other_re, other_im);
  unpack_columns(re, im, other_re, other_im);
  std::swap(re, other_re);
  std::swap(im, other_im);
  std::fill_n(re + kCellsAcross * kLines, kCellsAcross * kLines, 0.0);
  std::fill_n(im + kCellsAcross * kLines, kCellsAcross * kLines, 0.0);
  transform(kLines, re, im, other_re, other_im);
  for (std::size_t i = 0; i < spectrum_.size(); ++i) {
    re[i] *= spectrum_[i];
    im[i] *= spectrum_[i];
  }
  // With real and imaginary parts exchanged, the transform is the inverse one.
  transform(kLines, im, re, other_im, other_re);
  pack_columns(re, im, other_re, other_im);
  std::swap(re, other_re);
  std::swap(im, other_im);
  transform(kPairs, im, re, other_im, other_re);
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    std::copy_n(re + row * kPairs, kPairs, &displacement_m[row * kCellsAcross]);
    std::copy_n(im + row * kPairs, kPairs, &displacement_m[row * kCellsAcross + kPairs]);
  }
}

}  // namespace asperity
