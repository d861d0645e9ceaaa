// The tracks of the participants of a study.

#include "app/findings/methods/discrimination/thresholds/study_track_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/methods/discrimination/thresholds/track_figure.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/drawn_table.h"

namespace asperity {

namespace {

/// A track of a participant, with its trials.
struct DrawnTrack {
  std::string condition{};
  int session = 0;
  int block_ordinal = 0;
  int track = 0;
  std::vector<TrackTrial> trials{};

  bool operator==(const DrawnTrack& other) const {
    return condition == other.condition && session == other.session &&
           block_ordinal == other.block_ordinal && track == other.track;
  }
};

/// The tracks of one participant.
struct DrawnTracks {
  std::string participant{};
  std::string unit{};
  double greatest = 0.0;  ///< absolute level
  std::vector<DrawnTrack> tracks{};
};

/// By participant, in the order of the table.
std::vector<DrawnTracks> drawn_tracks(const ResultTable& table) {
  std::vector<DrawnTracks> all{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const std::string participant = row.text(columns::kParticipant);
    auto of = std::find_if(all.begin(), all.end(), [&participant](const DrawnTracks& each) {
      return each.participant == participant;
    });
    if (of == all.end()) {
      all.push_back({.participant = participant, .unit = row.text(kUnitOfLevels)});
      of = all.end() - 1;
    }
    const auto whole = [&row](const ResultColumn& column) {
      return static_cast<int>(row.number(column).value_or(0.0));
    };
    DrawnTrack track{.condition = row.text(columns::kCondition),
                     .session = whole(columns::kSession),
                     .block_ordinal = whole(columns::kBlockOrdinal),
                     .track = whole(kTrackColumn)};
    auto known = std::find(of->tracks.begin(), of->tracks.end(), track);
    if (known == of->tracks.end()) known = of->tracks.insert(known, std::move(track));
    const double level = row.number(kLevelColumn).value_or(0.0);
    of->greatest = std::max(of->greatest, std::abs(level));
    const double hit = row.number(kHitColumn).value_or(0.0);
    known->trials.push_back({.step = row.number(kStepColumn).value_or(0.0),
                             .level = level,
                             .is_correct = hit == 1.0,
                             .is_unsure = hit > 0.0 && hit < 1.0});
  }
  return all;
}

/// By session and block ordinal: the number of the run of a condition, from 1.
std::map<std::string, std::map<std::pair<int, int>, int>> numbered_runs(
    const std::vector<DrawnTrack>& tracks) {
  std::map<std::string, std::map<std::pair<int, int>, int>> runs{};
  for (const DrawnTrack& track : tracks) {
    runs[track.condition][{track.session, track.block_ordinal}] = 0;
  }
  for (auto& [condition, own] : runs) {
    int number = 0;
    for (auto& run : own) run.second = ++number;
  }
  return runs;
}

/// Gives figures with the same unit axes that show all of them: participants are compared by eye.
void share_axes(std::vector<Figure>& figures) {
  struct SharedAxes {
    double last_step = 0.0;
    FigureSpan levels{};
  };
  std::map<std::string, SharedAxes> ranges{};
  for (const Figure& figure : figures) {
    SharedAxes& known =
        ranges.try_emplace(figure.y.unit, SharedAxes{.levels = {figure.y.low, figure.y.high}})
            .first->second;
    known.last_step = std::max(known.last_step, figure.x.high);
    known.levels.low = std::min(known.levels.low, figure.y.low);
    known.levels.high = std::max(known.levels.high, figure.y.high);
  }
  for (Figure& figure : figures) {
    const SharedAxes& range = ranges.at(figure.y.unit);
    figure.x.high = range.last_step;
    figure.y.low = range.levels.low;
    figure.y.high = range.levels.high;
  }
}

/// "wood, track 1", or "wood, run 2, track 1" where the condition has several runs.
Phrase name_of_track(const DrawnTrack& track, const std::map<std::pair<int, int>, int>& runs) {
  const std::string condition =
      track.condition == "all" ? std::string() : words_of_condition(track.condition);
  const std::string number = std::to_string(track.track);
  if (runs.size() < 2) {
    return condition.empty() ? phrase("Figures", "track %1").with(number)
                             : phrase("Figures", "%1, track %2").with(condition, number);
  }
  const std::string run = std::to_string(runs.at({track.session, track.block_ordinal}));
  return condition.empty() ? phrase("Figures", "run %1, track %2").with(run, number)
                           : phrase("Figures", "%1, run %2, track %3").with(condition, run, number);
}

}  // namespace

std::vector<Figure> track_figures(const ResultTable& table, const AnalysisOutcome&) {
  std::vector<Figure> figures{};
  std::vector<DrawnTracks> all = drawn_tracks(table);
  std::map<std::string, double> greatest{};  // by unit
  for (const DrawnTracks& drawn : all) {
    greatest[drawn.unit] = std::max(greatest[drawn.unit], drawn.greatest);
  }
  for (DrawnTracks& drawn : all) {
    const DrawnUnit unit = drawn_unit(drawn.unit, greatest.at(drawn.unit));
    const auto runs = numbered_runs(drawn.tracks);
    std::map<std::string, Phrase> names{};
    std::vector<TrackTrial> trials{};
    for (DrawnTrack& track : drawn.tracks) {
      const Phrase name = name_of_track(track, runs.at(track.condition));
      names.emplace(name.english(), name);
      for (TrackTrial& trial : track.trials) {
        trial.track = name.english();
        trial.level /= unit.size;
      }
      std::stable_sort(track.trials.begin(), track.trials.end(),
                       [](const TrackTrial& a, const TrackTrial& b) { return a.step < b.step; });
      mark_reversals(track.trials);
      trials.insert(trials.end(), track.trials.begin(), track.trials.end());
    }
    Figure figure = tracks_figure(trials, unit.text);
    for (FigureSeries& series : figure.series) {
      const auto name = names.find(series.name.english());
      if (name != names.end()) series.name = name->second;
    }
    figure.name = figure_file_name("tracks_" + drawn.participant);
    figure.title = phrase("Figures", "Tracks of participant %1").with(drawn.participant);
    figure.note = with_note_on_unsure(
        phrase("Figures",
               "Filled symbols: hits (correct responses, or choices of the comparison); "
               "open symbols: other responses. Rings: reversals, after which the level "
               "changes its direction."),
        trials);
    figures.push_back(std::move(figure));
  }
  share_axes(figures);
  return figures;
}

}  // namespace asperity
