// The places of the participants of a whole study that are dealt to the study of one station.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

class Study;

/// Places of participants in the whole study, from 1, both ends included.
struct PlaceRange {
  int first = 1;
  int last = 1;

  bool operator==(const PlaceRange&) const = default;
};

/// The largest number of a place.
inline constexpr int kMostPlaces = 9999;

/// "13-24"; "13" for a single place.
std::string text_of(const PlaceRange& range);
/// Reads `text_of`; nothing for another text, and where not 1 ≤ first ≤ last ≤ kMostPlaces.
std::optional<PlaceRange> place_range_in(std::string_view text);

/// The ranges in the order in which they were dealt; empty for a study that is not divided among stations. They are in the file
/// `deal.json` of the study's folder.
///
/// Errors: std::runtime_error naming the file, for one that is damaged.
std::vector<PlaceRange> dealt_places(const std::filesystem::path& study);

/// The place that the events of a session state, at most kMostPlaces; nothing in a study that is not divided.
std::optional<int> dealt_place(const std::vector<EventRow>& events);

/// Deals a further range of places to the study, or the first one.
///
/// Errors: std::runtime_error for places that are dealt to it already, and for the first range of a study with sessions of
/// human participants, who have no places; ResultsError.
void deal_places(const Study& study, const PlaceRange& range);

}  // namespace asperity
