// Counts runs of equal responses; the balanced performance is closed-form for 1 up, and otherwise found by bisection.

#include "analysis/psychometric/up_down.h"

#include <cmath>
#include <stdexcept>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

void refuse_empty(const UpDownRule& rule) {
  if (rule.up == 0) throw std::invalid_argument("up is 0; it must be at least 1");
  if (rule.down == 0) throw std::invalid_argument("down is 0; it must be at least 1");
}

double chance_of_down(const UpDownRule& rule, double p) {
  const double q = 1.0 - p;
  const double to_down = std::pow(p, static_cast<double>(rule.down - 1));
  const double to_up = std::pow(q, static_cast<double>(rule.up - 1));
  return to_down * (1.0 - to_up * q) / (to_down + to_up - to_down * to_up);
}

}  // namespace

UpDownRun::UpDownRun(const UpDownRule& rule) : rule_(rule) { refuse_empty(rule); }

UpDownRun::Outcome UpDownRun::respond(bool is_correct) noexcept {
  correct_ = is_correct ? correct_ + 1 : 0;
  incorrect_ = is_correct ? 0 : incorrect_ + 1;
  const bool is_down = correct_ == rule_.down;
  if (!is_down && incorrect_ != rule_.up) return {};
  correct_ = 0;
  incorrect_ = 0;
  Outcome outcome{.move = is_down ? UpDownMove::down : UpDownMove::up};
  outcome.is_reversal = direction_ != UpDownMove::none && direction_ != outcome.move;
  if (outcome.is_reversal) ++reversals_;
  direction_ = outcome.move;
  return outcome;
}

double balanced_performance(const UpDownRule& rule, double up_over_down) {
  refuse_empty(rule);
  if (!(up_over_down > 0.0) || !std::isfinite(up_over_down)) {
    throw std::invalid_argument("up_over_down is " + number_text(up_over_down) +
                                "; it must be finite and above 0");
  }
  const double sought = up_over_down / (1.0 + up_over_down);
  if (rule.up == 1) return std::pow(sought, 1.0 / static_cast<double>(rule.down));
  // D increases from 0 to 1, and bisection ends where no double lies between.
  double low = 0.0;
  double high = 1.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (chance_of_down(rule, middle) < sought ? low : high) = middle;
  }
}

}  // namespace asperity
