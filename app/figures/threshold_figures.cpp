// Psychometric functions of the participants of a discrimination, and their thresholds by condition.

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "app/figures/figure_kinds.h"
#include "app/figures/single_participants.h"
#include "app/findings/reading_table.h"
#include "app/findings/study/answer_columns.h"
#include "app/findings/study/cell_words.h"
#include "app/findings/study/discrimination_results.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// The unit in which a quantity is drawn, with its value in the stored unit.
struct DrawnUnit {
  std::string text{};
  double size = 1.0;
};

DrawnUnit drawn_unit(const std::string& unit, double greatest) {
  if (unit != "m") return {unit, 1.0};
  if (greatest < 1e-3) return {"µm", 1e-6};
  return greatest < 1.0 ? DrawnUnit{"mm", 1e-3} : DrawnUnit{unit, 1.0};
}

const NamedTable* table_named(const AnalysisOutcome& outcome, const char* name) {
  const auto found = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                                  [name](const NamedTable& each) { return each.name == name; });
  return found == outcome.tables.end() ? nullptr : &*found;
}

/// The cells of a row by the name of their column.
class RowOfTable final {
 public:
  RowOfTable(const Table& table, const std::vector<Cell>& row) : table_(table), row_(row) {}
  Cell cell(const std::string& column) const {
    const auto at = column_of(table_, column);
    return at ? row_[*at] : Cell{};
  }
  std::string text(const std::string& column) const {
    const Cell content = cell(column);
    const auto* const words = std::get_if<std::string>(&content);
    return words == nullptr ? std::string() : *words;
  }
  std::optional<double> number(const std::string& column) const { return number_of(cell(column)); }

 private:
  const Table& table_;
  const std::vector<Cell>& row_;
};

std::string file_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

/// The responses of one participant, with the conditions of one judgement.
struct DrawnFunctions {
  std::string participant{};
  std::string parameter{};
  std::string unit{};
  bool is_performance = false;
  LabelRows conditions{};
  std::set<std::string> names{};
  NumberColumn levels{};
  NumberColumn trials{};
  NumberColumn hits{};
  double greatest = 0.0;  ///< absolute level
};

/// By participant, parameter and judgement, in the order of the table.
std::vector<DrawnFunctions> drawn_functions(const Table& table) {
  std::vector<DrawnFunctions> all{};
  for (const std::vector<Cell>& cells : table.rows) {
    const RowOfTable row(table, cells);
    const std::optional<double> difference = row.number("difference");
    const std::string participant = row.text("participant");
    const std::string parameter = row.text("parameter");
    auto known = std::find_if(all.begin(), all.end(), [&](const DrawnFunctions& each) {
      return each.participant == participant && each.parameter == parameter &&
             each.is_performance == difference.has_value();
    });
    if (known == all.end()) {
      all.push_back({.participant = participant,
                     .parameter = parameter,
                     .unit = row.text("unit"),
                     .is_performance = difference.has_value()});
      known = all.end() - 1;
    }
    const double level = difference ? std::abs(*difference) : row.number("level").value_or(0.0);
    known->conditions.add(row.text("condition"));
    known->names.insert(row.text("condition"));
    known->levels.push_back(level);
    known->trials.push_back(row.number("responses"));
    known->hits.push_back(row.number("hits"));
    known->greatest = std::max(known->greatest, std::abs(level));
  }
  return all;
}

/// The findings of the function of one condition in the unit that is drawn, with the names of the family `psyfit`.
void add_function(const FoundNumbers& functions, const FoundNumbers& thresholds,
                  const DrawnFunctions& drawn, const std::string& condition, const DrawnUnit& unit,
                  std::vector<Finding>& made) {
  const std::string key = drawn.participant + '|' + condition;
  for (const char* const quantity : {"fit.alpha", "fit.beta", "fit.gamma", "fit.lambda"}) {
    const Finding* const found = functions.find(quantity, key);
    if (found == nullptr || !found->value) continue;
    Finding scaled = *found;
    scaled.key = condition;
    if (scaled.quantity == "fit.alpha") *scaled.value /= unit.size;
    if (scaled.quantity == "fit.beta" && !drawn.is_performance) *scaled.value *= unit.size;
    made.push_back(std::move(scaled));
  }
  const Finding* const threshold = thresholds.find(drawn.is_performance ? "jnd" : "pse", key);
  if (threshold == nullptr || !threshold->value) return;
  Finding scaled = *threshold;
  scaled.quantity = "threshold";
  scaled.key = condition;
  for (std::optional<double>* const number : {&scaled.value, &scaled.low, &scaled.high}) {
    if (*number) **number /= unit.size;
  }
  made.push_back(std::move(scaled));
}

TidyInput input_of_functions(DrawnFunctions& drawn, const DrawnUnit& unit) {
  for (std::optional<double>& level : drawn.levels) *level /= unit.size;
  TidyInput input{};
  input.tables.emplace_back(
      std::vector<TidyTable::Column>{{"condition", std::move(drawn.conditions).take()},
                                     {"x", std::move(drawn.levels)},
                                     {"n", std::move(drawn.trials)},
                                     {"k", std::move(drawn.hits)}},
      "the responses");
  input.options.set("shape", std::string(drawn.is_performance ? "weibull" : "normal"));
  input.options.set("gamma", drawn.is_performance ? 0.5 : kSymmetricLapseRate);
  input.options.set("pt", drawn.is_performance ? kProportionAtThreshold : 0.5);
  return input;
}

Figure figure_of_functions(DrawnFunctions drawn, const FoundNumbers& functions,
                           const FoundNumbers& thresholds) {
  const DrawnUnit unit = drawn_unit(drawn.unit, drawn.greatest);
  std::vector<Finding> findings{};
  for (const std::string& condition : drawn.names) {
    add_function(functions, thresholds, drawn, condition, unit, findings);
  }
  const TidyInput input = input_of_functions(drawn, unit);
  Figure figure = psychometric_figure(input, FoundNumbers(findings), unit.text);
  const bool is_repeated =
      std::any_of(drawn.names.begin(), drawn.names.end(), [&](const std::string& condition) {
        return thresholds.find("without", drawn.participant + '|' + condition) != nullptr;
      });
  const std::string parameter = words_of_parameter(drawn.parameter);
  figure.name =
      file_name("psychometric_" + drawn.participant + (drawn.is_performance ? "" : "_comparison"));
  figure.table = kPsychometric;
  figure.title =
      phrase("Figures", "Psychometric functions of participant %1").with(drawn.participant);
  if (drawn.is_performance) {
    figure.x.name = phrase("Figures", "difference of the %1 from the standard").with(parameter);
    if (is_repeated) {
      figure.note =
          phrase(
              "Figures",
              "Filled symbols: proportions correct, larger for more trials. Curves: "
              "maximum-likelihood psychometric functions. Open symbols: thresholds, the level of "
              "%1 % correct, with 95 % CIs by running the procedure again.")
              .with(number_text(100.0 * kProportionAtThreshold));
    }
    return figure;
  }
  figure.note = phrase("Figures",
                       "Filled symbols: proportions of choices, larger for more trials. Curves: "
                       "maximum-likelihood psychometric functions. Open symbols: points of "
                       "subjective equality, with 95 % CIs by the delta method.");
  if (is_repeated) {
    figure.note = phrase("Figures",
                         "Filled symbols: proportions of choices, larger for more trials. Curves: "
                         "maximum-likelihood psychometric functions. Open symbols: points of "
                         "subjective equality, with 95 % CIs by running the procedure again.");
  }
  figure.x.name = phrase("Figures", "%1 of the comparison").with(parameter);
  figure.y.name = phrase("Figures", "proportion of choices");
  figure.references.clear();
  const Finding* const standard =
      thresholds.find("standard", drawn.participant + '|' + *drawn.names.begin());
  if (standard != nullptr && standard->value) {
    figure.references.push_back({.at = FigureReference::At::x,
                                 .value = *standard->value / unit.size,
                                 .label = phrase("Figures", "standard")});
  }
  return figure;
}

/// The numbers of one threshold in the tables.
struct DrawnThreshold {
  const char* column = "";
  const char* figure = "";
  Phrase title{};
  Phrase axis{};
  std::string mean = "mean";  ///< column of the table of means
};

/// Means with their intervals, a row per condition, and the participants behind them; nothing without a mean.
std::optional<Figure> figure_of_thresholds(const DrawnThreshold& drawn, const Table& means,
                                           const Table& thresholds) {
  double greatest = 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  std::string unit{};
  const auto reach = [&](const std::optional<double>& number) {
    if (!number) return;
    greatest = std::max(greatest, *number);
    lowest = std::min(lowest, *number);
  };
  std::vector<RowOfTable> rows{};
  for (const std::vector<Cell>& cells : means.rows) {
    const RowOfTable row(means, cells);
    if (row.text("measure") != drawn.column) continue;
    rows.push_back(row);
    unit = row.text("unit");
    for (const char* const end : {"", "_low", "_high"}) reach(row.number(drawn.mean + end));
  }
  if (rows.empty()) return std::nullopt;
  std::map<std::string, std::vector<double>> singles{};
  for (const std::vector<Cell>& cells : thresholds.rows) {
    const RowOfTable row(thresholds, cells);
    const std::optional<double> value = row.number(drawn.column);
    if (!value) continue;
    singles[row.text("condition")].push_back(*value);
    reach(value);
  }
  const DrawnUnit shown = drawn_unit(unit, std::abs(greatest));
  Figure figure{.name = drawn.figure,
                .table = kMeanThresholds,
                .title = drawn.title,
                .note = drawn.mean == "mean"
                            ? phrase("Figures",
                                     "Points are means over the participants whose threshold could "
                                     "be estimated, bars their t-based 95 % CIs.")
                            : phrase("Figures",
                                     "Points are geometric means over the participants whose "
                                     "threshold could be estimated, bars their t-based 95 % CIs on "
                                     "the logarithmic scale."),
                .shape = FigureShape::rows};
  const bool is_pse = std::string(drawn.column) == "pse";
  const double room = 0.06 * (greatest - (is_pse ? lowest : std::min(0.0, lowest)));
  figure.x = {.name = drawn.axis,
              .unit = shown.text,
              .low = (is_pse ? lowest - room : std::min(0.0, lowest)) / shown.size,
              .high = (greatest + (room > 0.0 ? room : 1e-9)) / shown.size};
  FigureSeries points{};
  std::vector<SingleValues> behind{};
  for (const RowOfTable& row : rows) {
    const auto scaled = [&](const char* end) {
      const std::optional<double> number = row.number(drawn.mean + end);
      return number ? std::optional(*number / shown.size) : std::nullopt;
    };
    const auto place = static_cast<double>(figure.y.places.size());
    FigurePoint point{.x = *scaled(""), .y = place};
    if (const auto low = scaled("_low"), high = scaled("_high"); low && high) {
      point.x_interval = FigureSpan{*low, *high};
    }
    points.points.push_back(point);
    const std::string condition = row.text("condition");
    std::vector<double> own = singles[condition];
    for (double& value : own) value /= shown.size;
    behind.push_back({.place = place, .values = std::move(own)});
    figure.y.places.push_back(words_of_cell("factor", condition));
  }
  figure.series.push_back(singles_in_rows(behind, figure.x, 0));
  figure.series.push_back(std::move(points));
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

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
std::vector<DrawnTracks> drawn_tracks(const Table& table) {
  std::vector<DrawnTracks> all{};
  for (const std::vector<Cell>& cells : table.rows) {
    const RowOfTable row(table, cells);
    const std::string participant = row.text("participant");
    auto of = std::find_if(all.begin(), all.end(), [&participant](const DrawnTracks& each) {
      return each.participant == participant;
    });
    if (of == all.end()) {
      all.push_back({.participant = participant, .unit = row.text("unit")});
      of = all.end() - 1;
    }
    const auto whole = [&row](const char* column) {
      return static_cast<int>(row.number(column).value_or(0.0));
    };
    DrawnTrack track{.condition = row.text("condition"),
                     .session = whole("session"),
                     .block_ordinal = whole("block_ordinal"),
                     .track = whole("track")};
    auto known = std::find(of->tracks.begin(), of->tracks.end(), track);
    if (known == of->tracks.end()) known = of->tracks.insert(known, std::move(track));
    const double level = row.number("level").value_or(0.0);
    of->greatest = std::max(of->greatest, std::abs(level));
    known->trials.push_back({.step = row.number("step").value_or(0.0),
                             .level = level,
                             .is_correct = row.number("hit") == 1.0});
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

/// The tracks of each participant, named by condition and number: "wood, 1", or "wood, 2.1" in the second of several runs.
std::vector<Figure> figures_of_tracks(const Table& table) {
  std::vector<Figure> figures{};
  for (DrawnTracks& drawn : drawn_tracks(table)) {
    const DrawnUnit unit = drawn_unit(drawn.unit, drawn.greatest);
    const auto runs = numbered_runs(drawn.tracks);
    bool has_several_runs = false;
    std::vector<TrackTrial> trials{};
    for (DrawnTrack& track : drawn.tracks) {
      const auto& own_runs = runs.at(track.condition);
      std::string name = track.condition == "all" ? std::string() : track.condition + ", ";
      if (own_runs.size() > 1) {
        has_several_runs = true;
        name += std::to_string(own_runs.at({track.session, track.block_ordinal})) + '.';
      }
      name += std::to_string(track.track);
      for (TrackTrial& trial : track.trials) {
        trial.track = name;
        trial.level /= unit.size;
      }
      std::stable_sort(track.trials.begin(), track.trials.end(),
                       [](const TrackTrial& a, const TrackTrial& b) { return a.step < b.step; });
      mark_reversals(track.trials);
      trials.insert(trials.end(), track.trials.begin(), track.trials.end());
    }
    Figure figure = tracks_figure(trials, unit.text);
    figure.name = file_name("tracks_" + drawn.participant);
    figure.table = kTracks;
    figure.title = phrase("Figures", "Tracks of participant %1").with(drawn.participant);
    figure.note = phrase("Figures",
                         "Filled symbols: hits (correct responses, or choices of the comparison); "
                         "open symbols: other responses. Rings: reversals, after which the level "
                         "changes its direction.");
    if (has_several_runs) {
      figure.note = phrase("Figures", "%1 Names: the run of the block, and the track within it.")
                        .with(figure.note);
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace

std::vector<Figure> threshold_figures(const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const NamedTable* const means = table_named(outcome, kMeanThresholds);
  const NamedTable* const thresholds = table_named(outcome, kThresholds);
  if (means != nullptr && thresholds != nullptr) {
    const std::array kDrawn{
        DrawnThreshold{"pse", "points_of_subjective_equality",
                       phrase("Figures", "Points of subjective equality"),
                       phrase("Figures", "point of subjective equality, mean with its 95 % CI")},
        DrawnThreshold{"jnd", "thresholds", phrase("Figures", "Thresholds"),
                       phrase("Figures", "threshold, geometric mean with its 95 % CI"),
                       "geometric_mean"}};
    for (const DrawnThreshold& drawn : kDrawn) {
      auto figure = figure_of_thresholds(drawn, means->table, thresholds->table);
      if (figure) figures.push_back(std::move(*figure));
    }
  }
  if (const NamedTable* const tracks = table_named(outcome, kTracks)) {
    for (Figure& figure : figures_of_tracks(tracks->table)) figures.push_back(std::move(figure));
  }
  const NamedTable* const responses = table_named(outcome, kPsychometric);
  if (responses == nullptr) return figures;
  std::vector<Finding> of_functions{};
  std::vector<Finding> of_thresholds{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis == kPsychometric) of_functions.push_back(finding);
    if (finding.analysis == kThresholds) of_thresholds.push_back(finding);
  }
  const FoundNumbers found_functions(of_functions);
  const FoundNumbers found_thresholds(of_thresholds);
  for (DrawnFunctions& drawn : drawn_functions(responses->table)) {
    figures.push_back(figure_of_functions(std::move(drawn), found_functions, found_thresholds));
  }
  return figures;
}

}  // namespace asperity
