// Up-down rules: when a track of levels moves, and the proportion of correct responses that it approaches.

#pragma once

#include <cstddef>

namespace asperity {

/// The level moves down after `down` correct responses in succession and up after `up` incorrect ones. Both counts
/// begin again after a move, and each is ended by a response of the other kind [Levitt 1971].
///
/// [Levitt 1971] Levitt: Transformed up-down methods in psychoacoustics.
struct UpDownRule {
  std::size_t up = 1;
  std::size_t down = 1;

  bool operator==(const UpDownRule&) const = default;
};

enum class UpDownMove { none, down, up };

/// Follows a rule through the responses of a track.
///
/// A reversal is a response whose move has the direction opposite to that of the move before. A move counts as such
/// even if a bound prevents it. The step of a move is that of the number of reversals so far, including its own: the
/// first step of a list is used up to the first reversal.
class UpDownRun final {
 public:
  /// Errors: std::invalid_argument for a count of 0.
  explicit UpDownRun(const UpDownRule& rule);

  struct Outcome {
    UpDownMove move = UpDownMove::none;
    bool is_reversal = false;
  };
  Outcome respond(bool is_correct) noexcept;

  std::size_t reversals() const noexcept { return reversals_; }

 private:
  UpDownRule rule_{};
  std::size_t correct_ = 0;
  std::size_t incorrect_ = 0;
  std::size_t reversals_ = 0;
  UpDownMove direction_ = UpDownMove::none;
};

/// The proportion of correct responses p at which a rule moves up and down in balance.
///
/// While p is constant, the next move is downwards with the probability
///
///   D(p) = p^{n−1}·(1 − q^m) / (p^{n−1} + q^{m−1} − p^{n−1}·q^{m−1}),   q = 1 − p, n = down, m = up,
///
/// that n correct responses in succession come before m incorrect ones. The level has no drift where
/// D(p)·Δ⁻ = (1 − D(p))·Δ⁺ with the lengths of the steps. For m = 1, D = pⁿ and
///
///   p = (r/(1 + r))^{1/n},   r = Δ⁺/Δ⁻:
///
/// 0.707 and 0.794 for 2 and 3 down with equal steps [Levitt 1971], r/(1 + r) for 1 down [Kaernbach 1991], and the values
/// of [García-Pérez 1998] for his ratios. On a track p changes with every move, so that the mean level is near this
/// balance and not at it; the distance shrinks with the steps.
///
/// Errors: std::invalid_argument for a count of 0, or a ratio that is not finite and above 0.
///
/// [Kaernbach 1991] Kaernbach: Simple adaptive testing with the weighted up-down method.
/// [García-Pérez 1998] García-Pérez: Forced-choice staircases with fixed step sizes.
double balanced_performance(const UpDownRule& rule, double up_over_down = 1.0);

}  // namespace asperity
