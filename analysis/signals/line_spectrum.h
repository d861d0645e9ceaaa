// Declares the line spectral frequencies of an autoregressive model.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// The greatest order of a model whose coefficients are computed from its line spectral frequencies.
inline constexpr std::size_t kMostSpectralLines = 32;

/// The line spectral frequencies w_1 < … < w_p in (0, π) of a stationary model m_i = Σ a_j·m_{i−j} + σ·e_i [Itakura 1975].
///
///   A(z) = 1 − Σ_{j=1..p} a_j·z^{−j}
///   P(z) = A(z) + z^{−(p+1)}·A(1/z)                       zeros on the unit circle, at w_1, w_3, …
///   Q(z) = A(z) − z^{−(p+1)}·A(1/z)                       at w_2, w_4, …
///
/// The model is stationary exactly if its frequencies are in increasing order within (0, π), so that every mean of the
/// frequencies of stationary models with weights that are not negative is stationary as well. Means of coefficients are not.
///
/// w_i is where the phase of z^{−(p+1)}·A(1/z)/A(z) is −i·π. It decreases from 0 at 0 to −(p + 1)·π at π and is a sum of
/// arcs of tangents, one for each reflection coefficient κ_k (the last coefficient of order k):
///
///   φ_0 = −ω,   φ_k = φ_{k−1} − ω + 2·atan(κ_k·sin φ_{k−1}/(1 − κ_k·cos φ_{k−1}))
///
/// The arcs are within ±π/2 because |κ_k| < 1, so no phase needs unwrapping and bisection finds every frequency, however
/// close two of them are.
///
/// Errors: std::invalid_argument for no coefficients and for a process that is not stationary.
///
/// [Itakura 1975] Itakura: Line spectrum representation of linear predictor coefficients of speech signals.
std::vector<double> line_spectral_frequencies(std::span<const double> coefficients);

/// The coefficients a_1 … a_p of line spectral frequencies, by multiplication of the zeros of P and Q:
///
///   p even:  P = (1 + z⁻¹)·Π_{i odd} (1 − 2·cos w_i·z⁻¹ + z⁻²),   Q = (1 − z⁻¹)·Π_{i even} (…)
///   p odd:   P = Π_{i odd} (…),                                   Q = (1 − z⁻²)·Π_{i even} (…)
///   A = (P + Q)/2
///
/// Takes up to kMostSpectralLines frequencies from 0 to π, and as many coefficients. The cosines are those of a series
/// (an error of at most 3·10⁻¹⁶), so that a model has the same bits everywhere.
///
/// Real-time: does not allocate, lock or throw.
void coefficients_of_lines(std::span<const double> frequencies_rad,
                           std::span<double> coefficients) noexcept;

}  // namespace asperity
