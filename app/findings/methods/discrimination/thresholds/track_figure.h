// Makes figures of the tracks of procedures.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// A trial of a track, whose level was chosen from the responses to the trials before it.
struct TrackTrial {
  std::string track{};
  double step = 0.0;  ///< its number in the track
  double level = 0.0;
  bool is_correct = false;
  bool is_unsure = false;    ///< the response "cannot tell"
  bool is_reversal = false;  ///< the level changes its direction after this trial
};
/// The note, which explains the symbol of the responses "cannot tell" if there are any.
Phrase with_note_on_unsure(const Phrase& note, std::span<const TrackTrial> trials);
/// Sets `is_reversal` from the levels; the trials are in order.
void mark_reversals(std::span<TrackTrial> of_one_track);
/// The trials with a response of the tables and the findings of the family `staircase`.
std::vector<TrackTrial> track_trials(const TidyInput& input, const FoundNumbers& found);
/// Levels over the trials of each track, in the order of the trials. `unit`: of the levels.
Figure tracks_figure(std::span<const TrackTrial> trials, const std::string& unit);

}  // namespace asperity
