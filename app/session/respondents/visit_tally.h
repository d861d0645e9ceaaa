// Counts the visits to the surfaces of a trial, for the participant's side of an attempt.

#pragma once

#include <map>
#include <optional>

#include "protocols/design/trial.h"

namespace asperity {

/// The visits of one attempt so far, against the limits of the trial's arrangement.
class VisitTally final {
 public:
  void clear() { visits_.clear(); }
  void add(int position) { ++visits_[position]; }
  /// One visit of those added did not take place.
  void take_back(int position) { --visits_[position]; }
  int of(int position) const {
    const auto found = visits_.find(position);
    return found == visits_.end() ? 0 : found->second;
  }
  bool may_visit(const Trial& trial, int position) const {
    return trial.arrangement.may_visit(of(position));
  }
  /// A surface that the participant has to request before a response is possible: the first one after `last` in turn.
  /// Nothing if there is none, and where surfaces are not felt on request.
  std::optional<int> owed(const Trial& trial, int last = 0) const;
  /// The next surface after `last` in turn that may be visited; nothing if there is none.
  std::optional<int> next(const Trial& trial, int last) const;

 private:
  std::map<int, int> visits_{};
};

}  // namespace asperity
