// Represents the choices of one of three surfaces by place: the counterpart of the order effect of two alternatives.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"

namespace asperity {

inline constexpr std::size_t kPlacesOfChoice = 3;
/// The codes of the places, as participants know them. In a sequence A is presented first.
inline constexpr std::array<const char*, kPlacesOfChoice> kCodesOfPlaces{"A", "B", "C"};

/// The choices of one participant.
struct PlacesOfPerson {
  std::uint32_t person = 0;
  /// By the place of the correct surface and that of the chosen one.
  std::array<std::array<std::uint64_t, kPlacesOfChoice>, kPlacesOfChoice> choices{};

  std::uint64_t responses() const;
  /// Whether the correct surface was presented at every place.
  bool has_all() const;
  /// The proportion of choices of a place, averaged over the places of the correct surface, which then need not be equally
  /// frequent. ⅓ without a preference for a place; the three proportions add to 1. Only where `has_all`.
  double proportion_of(std::size_t place) const;
};

/// Of the participants with trials.
std::vector<PlacesOfPerson> places_of(const DiscriminationStudy& study);

/// The means of `PlacesOfPerson::proportion_of` over the participants: analysis `order`, quantity place.proportion, by
/// `key_of_place`.
std::vector<Finding> place_findings(std::span<const PlacesOfPerson> places,
                                    const std::string& task);
/// "B", "TASK|B"
FindingKey key_of_place(const std::string& task, std::size_t place);

}  // namespace asperity
