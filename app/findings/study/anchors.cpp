#include "app/findings/study/anchors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/t_test.h"
#include "app/findings/reading_table.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr std::array kPlaces{AnchorPlace::start, AnchorPlace::middle, AnchorPlace::end};

double place_in_run(AnchorPlace place) {
  switch (place) {
    case AnchorPlace::start:
      return 0.0;
    case AnchorPlace::middle:
      return 0.5;
    case AnchorPlace::end:
      break;
  }
  return 1.0;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

using ByPlace = std::map<AnchorPlace, double>;

/// From the start to the end of a run; nothing for a single place.
std::optional<double> change_in(const ByPlace& run) {
  if (run.size() < 2) return {};
  std::vector<double> places{};
  std::vector<double> values{};
  for (const auto& [place, value] : run) {
    places.push_back(place_in_run(place));
    values.push_back(value);
  }
  const double mean_place = mean_of(places);
  const double mean_value = mean_of(values);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    products += (places[i] - mean_place) * (values[i] - mean_value);
    squares += (places[i] - mean_place) * (places[i] - mean_place);
  }
  return products / squares;
}

/// The responses to one question of the anchors of one block.
struct AnchorSeries {
  std::string block{};
  std::string question{};
  const char* measure = nullptr;
  /// As analysed, of each participant and run (session, block_ordinal).
  std::map<std::string, std::map<std::pair<int, int>, ByPlace>> runs{};
};

/// Null where responses are neither numbers nor correct or incorrect.
const char* measure_of(const std::vector<const AnchorResponse*>& responses, bool are_estimates) {
  const auto all_have = [&responses](auto member) {
    return std::all_of(responses.begin(), responses.end(), [member](const AnchorResponse* each) {
      return (each->*member).has_value();
    });
  };
  if (all_have(&AnchorResponse::number)) return are_estimates ? kAnchorEstimate : kAnchorRating;
  return all_have(&AnchorResponse::correct) ? kAnchorCorrect : nullptr;
}

/// Nothing for an estimate that has no logarithm.
std::optional<double> analysed_value(const AnchorResponse& response, std::string_view measure) {
  if (measure == kAnchorCorrect) return response.correct;
  if (measure == kAnchorRating) return response.number;
  return *response.number > 0.0 ? std::optional(std::log10(*response.number)) : std::nullopt;
}

std::vector<AnchorSeries> series_of(const GatheredAnswers& gathered) {
  std::map<std::pair<std::string, std::string>, std::vector<const AnchorResponse*>> responses{};
  for (const AnchorResponse& each : gathered.anchors) {
    responses[{each.block, each.question}].push_back(&each);
  }
  const ExperimentKind* const kind = find_kind(gathered.kind);
  const bool are_estimates = kind != nullptr && std::holds_alternative<NumberForm>(kind->form);
  std::vector<AnchorSeries> all{};
  for (const auto& [key, own] : responses) {
    const char* const measure = measure_of(own, are_estimates);
    if (measure == nullptr) continue;
    AnchorSeries& series = all.emplace_back();
    series.block = key.first;
    series.question = key.second;
    series.measure = measure;
    for (const AnchorResponse* const each : own) {
      const std::optional<double> value = analysed_value(*each, measure);
      if (!value) continue;
      series.runs[each->participant][{each->session, each->block_ordinal}][each->place] = *value;
    }
  }
  return all;
}

/// The mean over the participants of each participant's mean at this place.
std::optional<double> mean_at(AnchorPlace place, const AnchorSeries& series) {
  std::vector<double> of_participants{};
  for (const auto& [participant, runs] : series.runs) {
    std::vector<double> own{};
    for (const auto& [run, by_place] : runs) {
      if (const auto found = by_place.find(place); found != by_place.end()) {
        own.push_back(found->second);
      }
    }
    if (!own.empty()) of_participants.push_back(mean_of(own));
  }
  if (of_participants.empty()) return {};
  return mean_of(of_participants);
}

std::vector<double> changes_of_participants(const AnchorSeries& series) {
  std::vector<double> changes{};
  for (const auto& [participant, runs] : series.runs) {
    std::vector<double> own{};
    for (const auto& [run, by_place] : runs) {
      if (const auto change = change_in(by_place)) own.push_back(*change);
    }
    if (!own.empty()) changes.push_back(mean_of(own));
  }
  return changes;
}

void add_trend_row(const AnchorSeries& series, Table& table) {
  const std::vector<double> changes = changes_of_participants(series);
  if (changes.empty()) return;
  const bool is_log = series.measure == std::string_view(kAnchorEstimate);
  const auto shown = [is_log](double value) { return is_log ? std::pow(10.0, value) : value; };
  std::vector<Cell> row{series.block, series.question, series.measure,
                        static_cast<std::int64_t>(changes.size())};
  for (const AnchorPlace place : kPlaces) {
    const std::optional<double> mean = mean_at(place, series);
    row.push_back(mean ? Cell{shown(*mean)} : Cell{});
  }
  const OneSampleT mean = one_sample_t(changes);
  row.push_back(shown(mean.mean));
  const bool has_interval = mean.test && series.measure != std::string_view(kAnchorCorrect);
  row.push_back(has_interval ? Cell{shown(mean.test->interval.low)} : Cell{});
  row.push_back(has_interval ? Cell{shown(mean.test->interval.high)} : Cell{});
  table.rows.push_back(std::move(row));
}

Table responses_table(const GatheredAnswers& gathered) {
  Table table{{"participant", "session", "block_ordinal", "block", "place", "question", "response",
               "correct"},
              {}};
  for (const AnchorResponse& each : gathered.anchors) {
    table.rows.push_back({each.participant, static_cast<std::int64_t>(each.session),
                          static_cast<std::int64_t>(each.block_ordinal), each.block,
                          std::string(text_of(each.place)), each.question,
                          each.number ? Cell{*each.number} : Cell{each.answer},
                          each.correct ? Cell{*each.correct} : Cell{}});
  }
  drop_empty_columns(table, 7);
  return table;
}

Phrase note_on_trend(const Table& table) {
  Phrase note = phrase(
      "Analysis",
      "Means over the participants at the start, in the middle and at the end of a run of the "
      "block, and the change from its start to its end: the slope of a straight line through each "
      "participant’s responses. Estimates: geometric means, and the ratio of end to start. The "
      "change is described and not tested.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (has_cells(table, "change_low")) {
    add(phrase("Analysis",
               "95 % CI: t-based over participants, for estimates on the logarithmic scale."));
  }
  const bool has_proportions =
      std::any_of(table.rows.begin(), table.rows.end(),
                  [](const std::vector<Cell>& row) { return row[2] == Cell{kAnchorCorrect}; });
  if (has_proportions) {
    add(phrase("Analysis",
               "Changes of proportions correct have no CI, because each participant has only one "
               "trial at a place."));
  }
  return note;
}

}  // namespace

void add_anchors(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const bool shows_drift =
      std::any_of(gathered.anchors.begin(), gathered.anchors.end(),
                  [](const AnchorResponse& each) { return each.place != AnchorPlace::start; });
  if (!shows_drift) return;
  outcome.tables.push_back(
      {kAnchors, phrase("Analysis", "Responses to anchors"), responses_table(gathered),
       phrase("Analysis",
              "Anchors are reference trials at fixed places of every run of a block. No other "
              "table, finding or test contains their responses.")});
  NamedTable trend{kAnchorTrend,
                   phrase("Analysis", "Change of the responses to anchors"),
                   {{"block", "question", "measure", "persons", "start", "middle", "end", "change",
                     "change_low", "change_high"},
                    {}},
                   {}};
  for (const AnchorSeries& series : series_of(gathered)) add_trend_row(series, trend.table);
  if (trend.table.rows.empty()) return;
  drop_empty_columns(trend.table, 4);
  trend.note = note_on_trend(trend.table);
  outcome.tables.push_back(std::move(trend));
}

}  // namespace asperity
