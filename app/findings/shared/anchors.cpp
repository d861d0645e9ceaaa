// Means of participants over runs with a response at the first and the last place; estimates as logarithms.

#include "app/findings/shared/anchors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/summary.h"
#include "analysis/tests/t_test.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/shared/anchor_figures.h"
#include "app/findings/shared/learning.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr std::array kPlaces{AnchorPlace::start, AnchorPlace::middle, AnchorPlace::end};

using ByPlace = std::map<AnchorPlace, double>;

/// The responses to one question of the anchors of one block.
struct AnchorSeries {
  std::string block{};
  std::string question{};
  const char* measure = nullptr;
  /// The places of which the change is stated: the first and the last with a response.
  AnchorPlace first = AnchorPlace::end;
  AnchorPlace last = AnchorPlace::start;
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

/// Means and change are of the same participants and runs: of those with a response at both places.
void keep_complete_runs(AnchorSeries& series) {
  for (auto& [participant, runs] : series.runs) {
    std::erase_if(runs, [&series](const auto& run) {
      return series.first == series.last || !run.second.contains(series.first) ||
             !run.second.contains(series.last);
    });
  }
  std::erase_if(series.runs, [](const auto& own) { return own.second.empty(); });
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
      series.first = std::min(series.first, each->place);
      series.last = std::max(series.last, each->place);
    }
    keep_complete_runs(series);
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
    if (const auto of_runs = summary_of(own)) of_participants.push_back(of_runs->mean);
  }
  const std::optional<Summary> summary = summary_of(of_participants);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

std::vector<double> changes_of_participants(const AnchorSeries& series) {
  std::vector<double> changes{};
  for (const auto& [participant, runs] : series.runs) {
    std::vector<double> own{};
    for (const auto& [run, by_place] : runs) {
      own.push_back(by_place.at(series.last) - by_place.at(series.first));
    }
    changes.push_back(summary_of(own)->mean);
  }
  return changes;
}

void add_trend_row(const AnchorSeries& series, ResultTable& table) {
  const std::vector<double> changes = changes_of_participants(series);
  if (changes.empty()) return;
  const bool is_log = series.measure == std::string_view(kAnchorEstimate);
  const auto shown = [is_log](double value) { return is_log ? std::pow(10.0, value) : value; };
  ResultRow row{series.block, series.question, series.measure, count_cell(changes.size())};
  for (const AnchorPlace place : kPlaces) {
    const std::optional<double> mean = mean_at(place, series);
    row.push_back(mean ? ResultCell{shown(*mean)} : ResultCell{});
  }
  const OneSampleT mean = one_sample_t(changes);
  row.emplace_back(shown(mean.mean));
  if (mean.test && series.measure != std::string_view(kAnchorCorrect)) {
    row.push_back(interval_cell(shown(mean.test->interval.low), shown(mean.test->interval.high)));
  }
  table.add(std::move(row));
}

ResultTable responses_table(const GatheredAnswers& gathered) {
  using namespace columns;
  ResultTable table{
      kAnchors,
      phrase("Analysis", "Responses to anchors"),
      {kParticipant, kSession, kBlockOrdinal, kBlock, kAnchorPlace, kQuestion, kAnchorResponse,
       kCorrect},
      phrase(
          "Analysis",
          "Anchors are reference trials at fixed places of every run of a block. Only the tables "
          "of anchors contain their responses; no finding and no test does."),
      true};
  for (const AnchorResponse& each : gathered.anchors) {
    table.add({each.participant, std::int64_t{each.session}, std::int64_t{each.block_ordinal},
               each.block, text_of(each.place), each.question,
               each.number ? ResultCell{*each.number} : ResultCell{each.answer},
               cell_of(each.correct)});
  }
  table.drop_empty_columns(7);
  return table;
}

Phrase note_on_trend(const ResultTable& table, bool are_in_groups) {
  Phrase note = phrase(
      "Analysis",
      "Means over the participants at the start, in the middle and at the end of a run of the "
      "block, and the change from the first to the last of these places. Runs without a response "
      "at both are left out; the mean in the middle is of those with a response there. Estimates: "
      "geometric means, and the ratio of the last to the first. The change is described and not "
      "tested.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (table.has_values(interval_of(kChange))) {
    add(phrase("Analysis",
               "95 % CI: t-based over participants, for estimates on the logarithmic scale; in "
               "simulations with 2 to 20 participants, its coverage was 94 to 100 %, and 92 to "
               "100 % for ratings near an end of their scale."));
  }
  const bool has_proportions =
      std::any_of(table.rows.begin(), table.rows.end(), [&table](const ResultRow& row) {
        return RowReader(table, row).text(columns::kMeasure) == kAnchorCorrect;
      });
  if (has_proportions) {
    add(phrase("Analysis",
               "Changes of proportions correct have no CI, because each participant has only one "
               "trial at a place: in simulations with 2 to 20 participants, the coverage of a "
               "t-based CI was 92 to 100 %."));
  }
  if (are_in_groups) {
    add(phrase("Analysis", "The participants of all groups are analysed together."));
  }
  return note;
}

}  // namespace

void add_anchors(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const bool shows_drift =
      std::any_of(gathered.anchors.begin(), gathered.anchors.end(),
                  [](const AnchorResponse& each) { return each.place != AnchorPlace::start; });
  if (!shows_drift) return;
  using namespace columns;
  outcome.tables.push_back(responses_table(gathered));
  ResultTable trend{kAnchorTrend,
                    phrase("Analysis", "Change of the responses to anchors"),
                    {kBlock, kQuestion, kMeasure, kPersons, kAnchorStart, kAnchorMiddle, kAnchorEnd,
                     kChange, interval_of(kChange)},
                    {}};
  for (const AnchorSeries& series : series_of(gathered)) add_trend_row(series, trend);
  if (trend.rows.empty()) return;
  trend.drop_empty_columns(4);
  trend.note = note_on_trend(trend, gathered.groups.size() > 1);
  trend.figures = anchor_figures;
  outcome.tables.push_back(std::move(trend));
}

}  // namespace asperity
