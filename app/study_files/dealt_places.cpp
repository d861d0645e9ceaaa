// Stores ranges of places in a JSON file of the study, and reads a session's place from its event.

#include "app/study_files/dealt_places.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include <nlohmann/json.hpp>

#include "results_schema/files/atomic_file.h"
#include "results_schema/part_files.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr const char* kFormat = "asperity.deal/1";

std::optional<int> place_in(std::string_view text) {
  int place = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, place);
  if (error != std::errc{} || read != end || place < 1 || place > kMostPlaces) return std::nullopt;
  return place;
}

bool overlap(const PlaceRange& one, const PlaceRange& other) {
  return one.first <= other.last && other.first <= one.last;
}

}  // namespace

std::string text_of(const PlaceRange& range) {
  const std::string first = std::to_string(range.first);
  return range.first == range.last ? first : first + '-' + std::to_string(range.last);
}

std::optional<PlaceRange> place_range_in(std::string_view text) {
  const std::size_t dash = text.find('-');
  const std::optional<int> first = place_in(text.substr(0, dash));
  const std::optional<int> last =
      dash == std::string_view::npos ? first : place_in(text.substr(dash + 1));
  if (!first || !last || *first > *last) return std::nullopt;
  return PlaceRange{*first, *last};
}

std::vector<PlaceRange> dealt_places(const std::filesystem::path& study) {
  const std::filesystem::path file = study / kDealFile;
  if (!std::filesystem::exists(file)) return {};
  std::vector<PlaceRange> ranges{};
  try {
    const auto json = nlohmann::json::parse(read_file(file, kOptionsFile));
    if (json.at("format") != kFormat) throw std::runtime_error("another format");
    for (const auto& range : json.at("places")) {
      const auto read = place_range_in(range.get<std::string>());
      if (!read) throw std::runtime_error("no range");
      ranges.push_back(*read);
    }
  } catch (const ResultsError&) {
    throw;
  } catch (const std::exception&) {
    throw std::runtime_error(file.string() + " does not state places in the format " + kFormat +
                             "; restore it from a copy of the study");
  }
  return ranges;
}

std::optional<int> dealt_place(const std::vector<EventRow>& events) {
  for (const EventRow& event : events) {
    if (event.kind == kDealtEvent) return place_in(event.text);
  }
  return std::nullopt;
}

void deal_places(const Study& study, const PlaceRange& range) {
  std::vector<PlaceRange> ranges = dealt_places(study.folder());
  for (const PlaceRange& before : ranges) {
    if (!overlap(before, range)) continue;
    throw std::runtime_error("the places " + text_of(before) + " are dealt to the study " +
                             study.folder().string() +
                             " already; deal it places that neither this "
                             "study nor another station has");
  }
  const std::vector<SessionRow> sessions = study.sessions();
  if (ranges.empty() && std::any_of(sessions.begin(), sessions.end(), [](const SessionRow& row) {
        return row.mode == SessionMode::run;
      })) {
    throw std::runtime_error(
        "the study " + study.folder().string() +
        " has sessions already, whose participants have no places; deal places "
        "before the first session, in a new study");
  }
  ranges.push_back(range);
  nlohmann::ordered_json json{{"format", kFormat}, {"places", nlohmann::ordered_json::array()}};
  for (const PlaceRange& each : ranges) json["places"].push_back(text_of(each));
  write_file(study.folder() / kDealFile, json.dump(2) + '\n', Overwrite::allow);
}

}  // namespace asperity
