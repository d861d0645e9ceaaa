// Describes values that were averaged while the responses were gathered; shown tables have one row per condition.

#include "app/findings/shared/exploration.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/gathering/explored_rows.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/exploration_model.h"
#include "app/findings/shared/figures/response_time_figures.h"
#include "app/findings/tidy/described_conditions.h"

namespace asperity {

namespace {

/// A quantity of each surface, or the response time of each trial.
struct ExploredQuantity {
  const char* table = "";
  const char* name = "";  ///< fixed, for programs, with its unit; display text: cell_words.h
  int decimals = 2;       ///< that are displayed
  Explored quantity = Explored::contact_s;

  /// Medians and quartiles.
  bool is_time() const noexcept { return own_average_of(quantity) == OwnAverage::median; }
};

// Of times; in the displayed table they follow the median.
const ResultColumn kLowerQuartile{.id = "lower_quartile"};
const ResultColumn kUpperQuartile{.id = "upper_quartile"};

/// In the order of the tables.
constexpr std::array kExploredQuantities{
    ExploredQuantity{kExploration, "contact_s", 2, Explored::contact_s},
    ExploredQuantity{kExploration, "visits", 2, Explored::visits},
    ExploredQuantity{kExploration, "path_m", 3, Explored::path_m},
    ExploredQuantity{kExploration, "strokes", 2, Explored::strokes},
    ExploredQuantity{kExploration, "stroke_length_m", 4, Explored::stroke_length_m},
    ExploredQuantity{kExploration, "response_s", 2, Explored::response_s},
    ExploredQuantity{kExplorationForces, "force_N", 3, Explored::force_N},
    ExploredQuantity{kExplorationForces, "force_sd_N", 3, Explored::force_sd_N},
    ExploredQuantity{kExplorationForces, "speed_m_per_s", 4, Explored::speed_m_per_s},
    ExploredQuantity{kExplorationForces, "speed_sd_m_per_s", 4, Explored::speed_sd_m_per_s}};

const ExploredQuantity* explored_quantity(const std::string& name) {
  const auto* const found =
      std::find_if(kExploredQuantities.begin(), kExploredQuantities.end(),
                   [&name](const ExploredQuantity& one) { return one.name == name; });
  return found == kExploredQuantities.end() ? nullptr : found;
}

/// As the family `description` for a table of the rows.
std::vector<Finding> described(const GatheredAnswers& gathered, const ExploredRows& rows,
                               Explored quantity) {
  Description description{.average = own_average_of(quantity), .described = rows.participants()};
  for (const AnsweringPerson& person : gathered.people) {
    description.participants.push_back(person.label);
  }
  const auto own = [&](const ExploredCondition& condition) {
    return gathered.exploration.own_values(condition, quantity);
  };
  description.missing = rows.size();
  for (const OwnValue& one : own({})) description.missing -= one.measurements;
  description.conditions.push_back({.own = own({})});
  for (const ExploredFactor& factor : rows.factors()) {
    for (std::size_t level = 0; level < factor.levels.size(); ++level) {
      description.conditions.push_back(
          {.key = factor.name + '=' + factor.levels[level], .own = own(factor.condition(level))});
    }
  }
  return findings_of(description);
}

/// "force_N|texture=wood" for "texture=wood"; of a participant "force_N|p1|texture=wood".
void name_quantity(const char* quantity, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    finding.key = {quantity, finding.key};
  }
}

/// "5.17 [4.90, 5.61]", "0.951 (0.021)", "0.951" of one participant.
ResultCell read_quantity(const RowReader& row, const ExploredQuantity& quantity) {
  using namespace columns;
  const auto text = [&](const ResultColumn& column) -> std::optional<std::string> {
    const std::optional<double> number = row.number(column);
    if (!number) return std::nullopt;
    return display_signed(*number, quantity.decimals);
  };
  if (quantity.is_time()) {
    const auto median = text(kMedian);
    if (!median) return {};
    return JoinedCell{{*row.number(kMedian)},
                      *median + " [" + text(kLowerQuartile).value_or("") + ", " +
                          text(kUpperQuartile).value_or("") + ']'};
  }
  const auto mean = text(kMean);
  if (!mean) return {};
  const auto sd = text(kSd);
  return JoinedCell{{*row.number(kMean)}, sd ? *mean + " (" + *sd + ')' : *mean};
}

/// One row for all measures of a condition.
ResultTable conditions_in_rows(const ResultTable& table) {
  using namespace columns;
  const std::vector<ResultColumn> of_condition{kFactor, kFactorLevel, kPersons, kMeasurements};
  ResultTable made{table.name, table.title, of_condition, table.note};
  std::map<std::pair<std::string, std::string>, std::size_t> places{};
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const std::string measure = row.text(kMeasure);
    const ExploredQuantity* const quantity = explored_quantity(measure);
    if (quantity == nullptr) continue;
    const ResultColumn column{.id = measure, .heading = words_of_measure(measure)};
    if (!made.has(column)) {
      made.columns.push_back(column);
      for (ResultRow& known : made.rows) known.emplace_back();
    }
    const auto [place, is_new] =
        places.try_emplace({row.text(kFactor), row.text(kFactorLevel)}, made.rows.size());
    if (is_new) {
      ResultRow condition{};
      for (const ResultColumn& each : of_condition) condition.push_back(row.cell(each));
      made.add(std::move(condition));
    }
    made.rows[place->second][*made.find(column)] = read_quantity(row, *quantity);
  }
  return made;
}

class ExplorationTable final {
 public:
  ExplorationTable(const char* name, Phrase title, FiguresOfTable figures = nullptr)
      : table_{.name = name,
               .title = std::move(title),
               .columns = {columns::kMeasure, columns::kFactor, columns::kFactorLevel,
                           columns::kPersons, columns::kMeasurements, columns::kMedian,
                           kLowerQuartile, kUpperQuartile, columns::kMean, columns::kSd},
               .for_readers = conditions_in_rows,
               .figures = figures} {}

  void add(const ExploredRows& rows, const ExploredQuantity& quantity, const FoundNumbers& found) {
    add_row(quantity, "all", "", quantity.name, found);
    if (found.find("mean", quantity.name) == nullptr) {
      const Phrase name = words_of_measure(quantity.name);
      missing_ = missing_.empty() ? name : phrase("Analysis", "%1, %2").with(missing_, name);
    }
    for (const ExploredFactor& one : rows.factors()) {
      for (const std::string& level : one.levels) {
        add_row(quantity, one.name, level, {quantity.name, one.name + '=' + level}, found);
      }
    }
  }
  void take_into(AnalysisOutcome& outcome) {
    table_.note = note_on_exploration();
    outcome.tables.push_back(std::move(table_));
  }

 private:
  Phrase note_on_exploration() const {
    const Phrase note =
        table_.name == kExplorationForces
            ? phrase("Analysis",
                     "The mean and the SD of each surface are computed over the time in contact. "
                     "The table shows the mean (SD) over the participants of each participant’s "
                     "mean over the surfaces.")
            : phrase(
                  "Analysis",
                  "For each participant, the median of times and the mean of other quantities are "
                  "computed over surfaces (for response times: over trials). The table shows the "
                  "median [quartiles] or the mean (SD) of these values over the participants.");
    if (missing_.empty()) return note;
    return phrase("Analysis", "%1 Not stored by these sessions: %2.").with(note, missing_);
  }

  void add_row(const ExploredQuantity& quantity, const std::string& factor,
               const std::string& level, const FindingKey& key, const FoundNumbers& found) {
    const Finding* measured = found.find("measurements", key);
    if (measured == nullptr || (measured->n == 0 && factor != "all")) return;
    const auto where = [&](bool is_shown, QuantityName of) {
      return is_shown ? found.cell(of, key) : ResultCell{};
    };
    table_.add({quantity.name, factor, word_cell(level), count_cell(measured->n),
                count_cell(static_cast<std::size_t>(*measured->value)),
                where(quantity.is_time(), "median"), where(quantity.is_time(), "quartile.lower"),
                where(quantity.is_time(), "quartile.upper"), where(!quantity.is_time(), "mean"),
                where(!quantity.is_time(), "sd")});
  }

  ResultTable table_{};
  Phrase missing_{};  ///< quantities without a measurement
};

}  // namespace

void add_exploration(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  if (gathered.only_accompanies || gathered.exploration.empty()) return;
  const ExploredRows surfaces(gathered, ExploredUnit::surface);
  const ExploredRows trials(gathered, ExploredUnit::trial);
  ExplorationTable times(
      kExploration, phrase("Analysis", "Exploration by condition: times and strokes"),
      [](const ResultTable&, const AnalysisOutcome& drawn) {
        return std::vector{contact_times_figure(FoundNumbers(drawn.findings, kExploration))};
      });
  ExplorationTable forces(kExplorationForces,
                          phrase("Analysis", "Exploration by condition: force and speed"));
  for (const ExploredQuantity& quantity : kExploredQuantities) {
    const ExploredRows& rows = quantity.quantity == Explored::response_s ? trials : surfaces;
    std::vector<Finding> findings =
        analysis_of(kExploration, [&] { return described(gathered, rows, quantity.quantity); });
    name_quantity(quantity.name, findings);
    const FoundNumbers found(findings);
    (quantity.table == std::string_view(kExploration) ? times : forces).add(rows, quantity, found);
    keep_findings(findings, outcome);
  }
  times.take_into(outcome);
  forces.take_into(outcome);
  add_exploration_models(gathered, surfaces, trials, outcome);
}

}  // namespace asperity
