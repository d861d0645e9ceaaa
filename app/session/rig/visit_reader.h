// Measures the visits of the hand to the surfaces of an attempt, record by record.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/session/rig/contact_reader.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/rows.h"

namespace asperity {

/// Reads the records of an attempt in order. A visit (VisitRow) begins with a contact and lasts until another surface is
/// presented or touched, or until the same one is presented again; lifting does not end it, and neither does the flat
/// surface between patches.
///
/// Times are those of ticks; contact time is a number of ticks divided by the rate. The speed is tangential, of every
/// tick of contact; the force is the pressing force of ContactReader.
class VisitReader final {
 public:
  VisitReader(std::size_t surfaces, double rate_Hz, JudgedForce force);

  void take(const TickRecord& record);

  /// Of the surface with this position, from 1.
  const std::vector<VisitRow>& visits(int position) const {
    return visits_.at(static_cast<std::size_t>(position) - 1);
  }
  /// Contact time of all visits.
  double contact_s(int position) const;

 private:
  /// Running mean and sum of squared deviations.
  struct Spread {
    std::int64_t samples = 0;
    double mean = 0.0;
    double squares = 0.0;
    void add(double sample) noexcept;
    double sd() const noexcept;
  };

  double rate_Hz_ = 1000.0;
  ContactReader reader_;
  std::vector<std::vector<VisitRow>> visits_{};
  std::uint64_t current_ = 0;  ///< position of the visited surface; 0: none
  bool touches_ = false;       ///< the last record was a contact of the current visit
  glm::dvec3 last_m_{0.0};
  std::int64_t contact_ticks_ = 0;
  Spread force_N_{};
  Spread speed_m_per_s_{};
};

}  // namespace asperity
