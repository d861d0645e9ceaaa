// Describes values that were averaged while the responses were gathered; shown tables have one row per condition.

#include "app/findings/shared/exploration.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/findings/gathering/explored_rows.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/reading_number.h"
#include "app/findings/outcome/reading_table.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/exploration_model.h"
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
    finding.key =
        finding.key.empty() ? std::string(quantity) : std::string(quantity) + '|' + finding.key;
  }
}

class ExplorationTable final {
 public:
  ExplorationTable(const char* name, Phrase title)
      : table_{name,
               std::move(title),
               {{"measure", "factor", "level", "persons", "measurements", "median",
                 "lower_quartile", "upper_quartile", "mean", "sd"},
                {}},
               {}} {}

  void add(const ExploredRows& rows, const ExploredQuantity& quantity, const FoundNumbers& found) {
    add_row(quantity, "all", "", quantity.name, found);
    if (found.find("mean", quantity.name) == nullptr) {
      const Phrase name = words_of_cell("measure", quantity.name);
      missing_ = missing_.empty() ? name : phrase("Analysis", "%1, %2").with(missing_, name);
    }
    for (const ExploredFactor& one : rows.factors()) {
      for (const std::string& level : one.levels) {
        add_row(quantity, one.name, level,
                std::string(quantity.name) + '|' + one.name + '=' + level, found);
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
               const std::string& level, const std::string& key, const FoundNumbers& found) {
    const Finding* measured = found.find("measurements", key);
    if (measured == nullptr || (measured->n == 0 && factor != "all")) return;
    const auto where = [&](bool is_shown, const char* of) {
      return is_shown ? found.cell(of, key) : Cell{};
    };
    table_.table.rows.push_back(
        {std::string(quantity.name), factor, level.empty() ? Cell{} : Cell{level},
         static_cast<std::int64_t>(measured->n), static_cast<std::int64_t>(*measured->value),
         where(quantity.is_time(), "median"), where(quantity.is_time(), "quartile.lower"),
         where(quantity.is_time(), "quartile.upper"), where(!quantity.is_time(), "mean"),
         where(!quantity.is_time(), "sd")});
  }

  NamedTable table_{};
  Phrase missing_{};  ///< quantities without a measurement
};

/// "5.17 [4.90, 5.61]", "0.951 (0.021)", "0.951" of one participant.
Cell read_quantity(const Table& table, const std::vector<Cell>& row,
                   const ExploredQuantity& quantity) {
  const auto text = [&](const char* column) -> std::optional<std::string> {
    const std::optional<double> number = number_of(row[*column_of(table, column)]);
    if (!number) return std::nullopt;
    return reading_signed(*number, quantity.decimals);
  };
  if (quantity.is_time()) {
    const auto median = text("median");
    if (!median) return {};
    return *median + " [" + text("lower_quartile").value_or("") + ", " +
           text("upper_quartile").value_or("") + ']';
  }
  const auto mean = text("mean");
  if (!mean) return {};
  const auto sd = text("sd");
  return sd ? *mean + " (" + *sd + ')' : *mean;
}

/// One row for all measures of a condition.
Table conditions_in_rows(const Table& table) {
  Table made{{"factor", "level", "persons", "measurements"}, {}};
  constexpr std::size_t kMeasure = 0;
  constexpr std::size_t kBefore = 4;  // columns before the measures
  std::map<std::pair<Cell, Cell>, std::size_t> places{};
  for (const std::vector<Cell>& row : table.rows) {
    const auto* const measure = std::get_if<std::string>(&row[kMeasure]);
    const ExploredQuantity* const quantity =
        measure == nullptr ? nullptr : explored_quantity(*measure);
    if (quantity == nullptr) continue;
    auto at = column_of(made, quantity->name);
    if (!at) {
      at = made.columns.size();
      made.columns.emplace_back(quantity->name);
      for (std::vector<Cell>& known : made.rows) known.emplace_back();
    }
    const auto [place, is_new] = places.try_emplace({row[1], row[2]}, made.rows.size());
    if (is_new) {
      made.rows.emplace_back(row.begin() + 1, row.begin() + 1 + kBefore);
      made.rows.back().resize(made.columns.size());
    }
    made.rows[place->second][*at] = read_quantity(table, row, *quantity);
  }
  return made;
}

/// With "F(2, 35.37) = 2.45" in place of three columns.
Table models_as_read(const Table& table) {
  const auto F = column_of(table, "F");
  const auto df1 = column_of(table, "df1");
  const auto df2 = column_of(table, "df2");
  if (!F || !df1 || !df2) return table;  // no model has a fit
  Table made = table;
  made.columns[*F] = "statistic";
  for (std::vector<Cell>& row : made.rows) {
    const std::optional<double> value = number_of(row[*F]);
    const std::optional<double> above = number_of(row[*df1]);
    const std::optional<double> below = number_of(row[*df2]);
    row[*F] = value && above && below
                  ? Cell{statistic_text("F", std::array{*above, *below}, *value)}
                  : Cell{};
  }
  for (const std::size_t gone : {std::max(*df1, *df2), std::min(*df1, *df2)}) {
    const auto at = static_cast<std::ptrdiff_t>(gone);
    made.columns.erase(made.columns.begin() + at);
    for (std::vector<Cell>& row : made.rows) row.erase(row.begin() + at);
  }
  return made;
}

bool is_exploration(const NamedTable& table) {
  return table.name == kExploration || table.name == kExplorationForces;
}

}  // namespace

Table with_exploration_as_read(const NamedTable& table) {
  if (is_exploration(table)) return conditions_in_rows(table.table);
  return table.name == kExplorationModel ? models_as_read(table.table) : table.table;
}

bool is_explored_quantity(const NamedTable& table, const std::string& column) {
  return is_exploration(table) && explored_quantity(column) != nullptr;
}

void add_exploration(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  if (gathered.only_accompanies || gathered.exploration.empty()) return;
  const ExploredRows surfaces(gathered, ExploredUnit::surface);
  const ExploredRows trials(gathered, ExploredUnit::trial);
  ExplorationTable times(kExploration,
                         phrase("Analysis", "Exploration by condition: times and strokes"));
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
