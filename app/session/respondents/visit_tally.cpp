// Searches the positions in turn after the last one, for a missing or a permitted visit.

#include "app/session/respondents/visit_tally.h"

namespace asperity {

namespace {

/// The first position after `last`, in turn, for which `holds`.
template <class Condition>
std::optional<int> first_in_turn(const Trial& trial, int last, const Condition& holds) {
  const int surfaces = static_cast<int>(trial.presentations.size());
  for (int step = 0; step < surfaces; ++step) {
    const int position = (last + step) % surfaces + 1;
    if (holds(position)) return position;
  }
  return {};
}

}  // namespace

std::optional<int> VisitTally::owed(const Trial& trial, int last) const {
  if (trial.arrangement.surfaces != Arrangement::Surfaces::on_request) return {};
  return first_in_turn(
      trial, last, [&](int position) { return of(position) < trial.arrangement.minimum_visits; });
}

std::optional<int> VisitTally::next(const Trial& trial, int last) const {
  return first_in_turn(trial, last, [&](int position) { return may_visit(trial, position); });
}

}  // namespace asperity
