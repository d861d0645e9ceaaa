// Bands of ages that are wide enough to be published.

#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

/// Bands of whole multiples of five years, such as "20 to 29", each with at least `kFewest` of the given participants.
///
/// Neighbouring bands of five years are merged, from the youngest participants to the oldest, until each has enough;
/// what remains at the end is part of the last band, which is then "30 and older". With fewer than `kFewest` ages there is no band. Human and virtual
/// participants have separate bands, because the virtual ones do not make a person harder to identify.
class AgeBands final {
 public:
  static constexpr std::size_t kFewest = 5;

  /// Participants without an age are ignored.
  explicit AgeBands(const std::vector<ParticipantRow>& participants);

  /// Nothing for an age in no band and for a participant without an age.
  std::optional<std::string> of(const ParticipantRow& participant) const;
  /// Of all bands, from the youngest.
  std::vector<std::string> names() const;

 private:
  struct Band {
    int from_years = 0;
    std::optional<int> to_years{};  ///< including the last year of life; empty: and older
    std::string name() const;
    auto operator<=>(const Band&) const = default;
  };
  static std::vector<Band> bands_of(const std::vector<double>& ages_years);

  std::array<std::vector<Band>, 2> bands_{};  ///< of human participants, of virtual ones
};

}  // namespace asperity
