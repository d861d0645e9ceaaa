// Tracks of procedures that choose levels from the responses.

#include "app/findings/methods/discrimination/thresholds/track_figure.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "app/findings/outcome/finding_parts.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr double kRoomAroundTrack = 0.06;    // as a fraction of the range of the levels
constexpr double kRingAroundReversal = 2.2;  // relative to the mark of a trial
constexpr double kDotOfUnsure = 0.4;         // the same

/// By track, in the order of their first trials.
std::vector<std::pair<std::string, std::vector<TrackTrial>>> by_track(
    std::span<const TrackTrial> trials) {
  std::vector<std::pair<std::string, std::vector<TrackTrial>>> tracks{};
  for (const TrackTrial& trial : trials) {
    auto known = std::find_if(tracks.begin(), tracks.end(),
                              [&trial](const auto& each) { return each.first == trial.track; });
    if (known == tracks.end()) {
      tracks.push_back({trial.track, {}});
      known = tracks.end() - 1;
    }
    known->second.push_back(trial);
  }
  for (auto& [name, own] : tracks) {
    std::stable_sort(own.begin(), own.end(), [](const TrackTrial& one, const TrackTrial& other) {
      return one.step < other.step;
    });
  }
  return tracks;
}

/// A part of a hit: the mean of a guess.
bool is_unsure_response(double response) { return response > 0.0 && response < 1.0; }

}  // namespace

void mark_reversals(std::span<TrackTrial> of_one_track) {
  double last_move = 0.0;
  for (std::size_t i = 0; i + 1 < of_one_track.size(); ++i) {
    const double move = of_one_track[i + 1].level - of_one_track[i].level;
    if (move == 0.0) continue;
    of_one_track[i].is_reversal = last_move * move < 0.0;
    last_move = move;
  }
}

Phrase with_note_on_unsure(const Phrase& note, std::span<const TrackTrial> trials) {
  const bool has_unsure = std::any_of(trials.begin(), trials.end(),
                                      [](const TrackTrial& trial) { return trial.is_unsure; });
  if (!has_unsure) return note;
  return phrase("Figures", "%1 Open symbols with a dot: responses “cannot tell”.").with(note);
}

Figure tracks_figure(std::span<const TrackTrial> trials, const std::string& unit) {
  Figure figure{
      .name = "tracks",
      .title = phrase("Figures", "Levels over the trials of each track"),
      .note = with_note_on_unsure(
          phrase("Figures",
                 "Filled symbols: correct responses; open symbols: incorrect ones. Rings: "
                 "reversals, after which the level changes its direction."),
          trials)};
  if (trials.empty()) {
    figure.instead = phrase("Figures", "No track has a trial; collect responses first.");
    return figure;
  }
  double low = trials.front().level;
  double high = low;
  double last_step = 1.0;
  for (const TrackTrial& trial : trials) {
    low = std::min(low, trial.level);
    high = std::max(high, trial.level);
    last_step = std::max(last_step, trial.step);
  }
  const auto tracks = by_track(trials);
  std::vector<FigureSeries> rings{};
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const int style = static_cast<int>(i);
    FigureSeries correct{.name = tracks.size() > 1 ? Phrase(tracks[i].first) : Phrase(),
                         .style = style};
    FigureSeries incorrect{.style = style, .hollow = true};
    FigureSeries dots{.style = style};  // of the responses "cannot tell"
    FigureSeries reversals{.style = style, .hollow = true};
    std::vector<FigurePlace>& line = correct.lines.emplace_back();
    for (const TrackTrial& trial : tracks[i].second) {
      line.push_back({.x = trial.step, .y = trial.level});
      (trial.is_correct ? correct : incorrect)
          .points.push_back({.x = trial.step, .y = trial.level});
      if (trial.is_unsure) {
        dots.points.push_back({.x = trial.step, .y = trial.level, .size = kDotOfUnsure});
      }
      if (!trial.is_reversal) continue;
      reversals.points.push_back({.x = trial.step, .y = trial.level, .size = kRingAroundReversal});
    }
    if (!reversals.points.empty()) rings.push_back(std::move(reversals));
    for (FigureSeries* const series : {&correct, &incorrect, &dots}) {
      if (!series->points.empty() || !series->lines.empty()) {
        figure.series.push_back(std::move(*series));
      }
    }
  }
  // Open symbols are filled with the ground: drawn first, the rings cover no response.
  figure.series.insert(figure.series.begin(), std::make_move_iterator(rings.begin()),
                       std::make_move_iterator(rings.end()));
  const double room = high > low ? kRoomAroundTrack * (high - low) : 0.5 * std::max(high, 1e-9);
  figure.x = {.name = phrase("Figures", "trial of the track"), .low = 0.0, .high = last_step + 1.0};
  figure.y = {.name = unit.empty() ? phrase("Figures", "level, in the unit of the table")
                                   : phrase("Figures", "level"),
              .unit = unit,
              .low = low >= 0.0 ? std::max(0.0, low - room) : low - room,
              .high = high + room};
  return figure;
}

std::vector<TrackTrial> track_trials(const TidyInput& input, const FoundNumbers& found) {
  const TidyTable& table = input.table();
  const LabelColumn tracks = table.all_labels("track");
  const std::vector<std::uint64_t> numbers = table.counts("trial");
  const NumberColumn responses = table.numbers("response");
  std::map<FindingKey, std::set<std::string>> reversals{};
  for (const Finding* const each : found.all("reversal.trials")) {
    const std::vector<std::string> parts = parts_of(each->word, ';');
    reversals[each->key].insert(parts.begin(), parts.end());
  }
  std::vector<TrackTrial> trials{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& track = tracks.names[tracks.codes[row]];
    const std::string trial = std::to_string(numbers[row]);
    const auto level = found.value("level", {track, trial});
    if (!level || !responses[row]) continue;
    trials.push_back({.track = track,
                      .step = static_cast<double>(numbers[row]),
                      .level = *level,
                      .is_correct = *responses[row] == 1.0,
                      .is_unsure = is_unsure_response(*responses[row]),
                      .is_reversal = reversals[track].contains(trial)});
  }
  return trials;
}

}  // namespace asperity
