// Proportions with their intervals, in rows.

#include "app/findings/shared/figures/forest_figures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/findings/outcome/single_participants.h"
#include "app/findings/outcome/tally.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// The quantity of the findings for single participants.
constexpr QuantityName kOwnShare = "subject.share";

/// `kind`: rows of one kind have one style, and one name in the legend.
struct ForestRow {
  Phrase label{};
  std::optional<double> share{};
  std::optional<FigureSpan> interval{};
  std::optional<double> chance{};
  int kind = 0;
  std::vector<double> singles{};  ///< of the participants that it averages
};

struct ForestKind {
  Phrase name{};
  bool is_part = false;  ///< contained in the data of other rows: outlined
};

Phrase count_phrase(const Phrase& label, std::size_t hits, std::size_t of) {
  return phrase("Figures", "%1 (%2 of %3)").with(label, std::to_string(hits), std::to_string(of));
}

Phrase mean_of(std::size_t people) {
  return people == 1 ? phrase("Figures", "one participant")
                     : phrase("Figures", "mean of %1 participants").with(std::to_string(people));
}

Phrase share_axis(const std::string& percent) {
  return phrase("Figures", "proportion, with its %1 % CI").with(percent);
}

/// Fills the axes and marks of `figure`.
void add_rows(const std::vector<ForestRow>& rows, const std::vector<ForestKind>& kinds,
              const Phrase& axis, Figure& figure) {
  figure.shape = FigureShape::rows;
  figure.x = {.name = axis, .low = 0.0, .high = 1.0};
  std::set<double> chances{};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    figure.series.push_back(
        {.name = kinds[kind].name, .style = static_cast<int>(kind), .hollow = kinds[kind].is_part});
  }
  std::vector<std::vector<SingleValues>> singles(kinds.size());
  FigureSeries by_chance{.name = phrase("Figures", "chance level"), .style = 5};
  for (const ForestRow& row : rows) {
    const auto place = static_cast<double>(figure.y.places.size());
    figure.y.places.push_back(row.label);
    if (row.chance) {
      chances.insert(*row.chance);
      by_chance.points.push_back({.x = *row.chance, .y = place});
    }
    if (!row.share) continue;
    figure.series[static_cast<std::size_t>(row.kind)].points.push_back(
        {.x = *row.share, .y = place, .x_interval = row.interval});
    singles[static_cast<std::size_t>(row.kind)].push_back({place, row.singles});
  }
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    figure.series.push_back(singles_in_rows(singles[kind], figure.x, static_cast<int>(kind)));
  }
  const bool has_points =
      std::any_of(figure.series.begin(), figure.series.end(),
                  [](const FigureSeries& series) { return !series.points.empty(); });
  if (!has_points) {
    figure.instead = phrase(
        "Figures",
        "There are no responses from which to compute a proportion; collect responses first.");
    return;
  }
  std::erase_if(figure.series, [](const FigureSeries& series) { return series.points.empty(); });
  if (chances.size() == 1) {
    figure.references.push_back(
        {.value = *chances.begin(), .label = phrase("Figures", "chance level")});
  } else if (chances.size() > 1) {
    if (figure.series.front().name.empty())
      figure.series.front().name = phrase("Figures", "proportion");
    figure.series.push_back(std::move(by_chance));
  }
}

/// Translates the program's words among the names of a table.
Phrase word_of_cell(const ResultCell& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return display_whole(*number);
  const auto* text = std::get_if<std::string>(&cell);
  if (text == nullptr) return "–";
  if (*text == "all") return phrase("Figures", "all");
  if (*text == "Total") return phrase("Figures", "all participants");
  if (*text == "Female") return phrase("Figures", "women");
  if (*text == "Male") return phrase("Figures", "men");
  if (*text == "Other or not told") return phrase("Figures", "other or not reported");
  return *text;
}

/// The combined names of a row: "column 1 · height_map over sinusoid".
Phrase label_of_row(const ResultTable& table, const ResultRow& cells, std::size_t keys) {
  Phrase label{};
  for (std::size_t i = 0; i < keys; ++i) {
    const ResultColumn& column = table.columns[i];
    Phrase word = word_of_cell(cells[i]);
    const bool is_level =
        column.is_same(columns::kRepetition) && cells[i] != ResultCell{kAllColumns};
    if (is_level) word = phrase("Figures", "repetition %1").with(word);
    if (column.is_same(columns::kPosition)) word = phrase("Figures", "position %1").with(word);
    if (label.empty()) {
      label = std::move(word);
    } else if (column.is_same(kAgainst)) {
      label = phrase("Figures", "%1 over %2").with(label, word);
    } else {
      label = phrase("Figures", "%1 · %2").with(label, word);
    }
  }
  return label;
}

/// Whether the data of a row are contained in other rows of the table.
bool is_part(const ResultTable& table, const ResultRow& row, std::size_t keys) {
  for (std::size_t i = 0; i < keys; ++i) {
    const ResultColumn& column = table.columns[i];
    if (!column.is_same(columns::kRepetition) && !column.is_same(columns::kSex)) continue;
    const auto* word = std::get_if<std::string>(&row[i]);
    if (word == nullptr || (*word != "all" && *word != "Total")) return true;
  }
  return false;
}

const std::vector<ForestKind>& pooled_and_people() {
  static const std::vector<ForestKind> kKinds{
      {.name = phrase("Figures", "proportion of responses (Wilson 95 % CI)")},
      {.name = phrase("Figures", "mean over participants")}};
  return kKinds;
}

/// The limits that belong to a column; nothing where one is missing.
std::optional<FigureSpan> span_of(const RowReader& row, const ResultColumn& column) {
  const Interval interval = row.interval(column);
  if (!interval.low || !interval.high) return {};
  return FigureSpan{.low = *interval.low, .high = *interval.high};
}

/// A row for each mean of the participants' proportions, with their own ones. `with_name`: adds the quantity that is averaged.
std::vector<ForestRow> rows_of_persons(const ResultTable& table, const AnalysisOutcome& outcome,
                                       const char* analysis, bool with_name) {
  using namespace columns;
  const SinglesByCondition singles =
      singles_by_condition(FoundNumbers(outcome.findings, analysis).all(kOwnShare));
  std::vector<ForestRow> rows{};
  for (const ResultRow& cells : table.rows) {
    const RowReader reader(table, cells);
    const Phrase of = mean_of(static_cast<std::size_t>(reader.number(kPersons).value_or(0.0)));
    ForestRow row{
        .label =
            with_name ? phrase("Figures", "%1 · %2").with(label_of_row(table, cells, 1), of) : of,
        .share = reader.number(kMean),
        .interval = span_of(reader, kMean)};
    const auto* name = std::get_if<std::string>(&cells.front());
    const bool is_whole = name == nullptr || *name == "all";
    const auto own = singles.find(is_whole ? std::string() : *name);
    if (own != singles.end()) row.singles = own->second;
    rows.push_back(std::move(row));
  }
  return rows;
}

bool has_intervals(const std::vector<ForestRow>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const ForestRow& row) { return row.interval.has_value(); });
}

/// `means`: drawn below the proportions.
Figure forest_of(const ResultTable& table, const std::vector<ForestRow>& means) {
  using namespace columns;
  const std::size_t hits = table.find(kOf).value() - 1;  // the names of the row precede it
  std::vector<ForestRow> rows{};
  for (const ResultRow& cells : table.rows) {
    const RowReader reader(table, cells);
    ForestRow row{};
    row.label = count_phrase(label_of_row(table, cells, hits),
                             static_cast<std::size_t>(number_of(cells[hits]).value_or(0.0)),
                             static_cast<std::size_t>(reader.number(kOf).value_or(0.0)));
    row.share = reader.number(kShare);
    row.interval = span_of(reader, kWilson);
    row.chance = reader.number(kChance);
    row.kind = is_part(table, cells, hits) ? 1 : 0;
    rows.push_back(std::move(row));
  }
  const bool has_both =
      std::any_of(rows.begin(), rows.end(), [](const ForestRow& row) { return row.kind == 0; }) &&
      std::any_of(rows.begin(), rows.end(), [](const ForestRow& row) { return row.kind == 1; });
  const Phrase note =
      has_both
          ? phrase("Figures",
                   "Points are proportions of all responses of a row; error bars show their Wilson "
                   "95 % CIs. Open symbols are subsets, filled symbols totals.")
          : phrase("Figures",
                   "Points are proportions of all responses of a row; error bars show their Wilson "
                   "95 % CIs.");
  const std::optional<double> by_chance = rows.empty() ? std::nullopt : rows.front().chance;
  for (ForestRow row : means) {
    row.chance = by_chance;
    row.kind = 2;
    rows.push_back(std::move(row));
  }
  Figure figure{
      .name = table.name + "_forest",
      .title = table.title,
      .note = means.empty()
                  ? note
                  : (has_intervals(means)
                         ? phrase("Figures",
                                  "%1 Squares are means of the participants' own proportions with "
                                  "t-based 95 % CIs on the logit scale: the participant is the "
                                  "unit of analysis.")
                         : phrase("Figures",
                                  "%1 Squares are means of the participants' own proportions: the "
                                  "participant is the unit of analysis."))
                        .with(note)};
  const std::vector<ForestKind>& names = pooled_and_people();
  add_rows(rows,
           {{.name = means.empty() ? Phrase() : names[0].name},
            {.name = means.empty() ? Phrase() : names[0].name, .is_part = true},
            {.name = names[1].name}},
           share_axis("95"), figure);
  for (FigureSeries& series : figure.series) {
    // One colour: parts are outlined in the same colour.
    if (series.style == 1) series.style = 0;
    if (series.style == 2) series.style = 1;
  }
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

/// The chance level, where it is the same in all rows of a table of proportions.
std::optional<double> one_chance(const ResultTable& table) {
  std::set<double> chances{};
  for (const ResultRow& cells : table.rows) {
    if (const auto chance = RowReader(table, cells).number(columns::kChance))
      chances.insert(*chance);
  }
  return chances.size() == 1 ? std::optional(*chances.begin()) : std::nullopt;
}

/// Rows of the findings of `quantity`, labelled with the parts of their keys.
std::vector<ForestRow> rows_of(const FoundNumbers& found, QuantityName quantity) {
  std::vector<ForestRow> rows{};
  for (const Finding* finding : found.all(quantity)) {
    ForestRow row{.share = finding->value, .interval = interval_of(*finding)};
    for (const std::string& part : finding->key.names()) {
      const Phrase word = part == "POOLED" ? phrase("Figures", "all together") : Phrase(part);
      row.label = row.label.empty() ? word : phrase("Figures", "%1 · %2").with(row.label, word);
    }
    if (finding->value) {
      const double hits = *finding->value * static_cast<double>(finding->n);
      row.label = count_phrase(row.label, static_cast<std::size_t>(std::llround(hits)), finding->n);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The mean of the participants' proportions, whose interval takes participants as the unit.
void add_mean_of_people(const FoundNumbers& found, std::optional<double> chance,
                        std::vector<ForestRow>& rows) {
  const SinglesByCondition singles = singles_by_condition(found.all(kOwnShare));
  for (const Finding* mean : found.all("subj.mean")) {
    if (!mean->value) continue;
    const Phrase of = mean_of(mean->n);
    const auto own = singles.find(mean->key);
    rows.push_back({.label = mean->key.empty()
                                 ? of
                                 : phrase("Figures", "%1 · %2").with(Phrase(mean->key.last()), of),
                    .share = mean->value,
                    .interval = interval_of(*mean),
                    .chance = chance,
                    .kind = 1,
                    .singles = own == singles.end() ? std::vector<double>{} : own->second});
  }
}

}  // namespace

Figure share_forest(const ResultTable& table) { return forest_of(table, {}); }

Figure share_forest(const ResultTable& table, const AnalysisOutcome& outcome,
                    const MeansOfShares& means) {
  const ResultTable* const persons = table_named(outcome, means.table);
  if (persons == nullptr) return share_forest(table);
  const bool of_all = persons->columns.front().is_same(columns::kAllAnswers);
  return forest_of(table, rows_of_persons(*persons, outcome, means.analysis, !of_all));
}

Figure person_forest(const ResultTable& table, const AnalysisOutcome& outcome, const char* analysis,
                     const char* shares) {
  std::vector<ForestRow> rows = rows_of_persons(table, outcome, analysis, true);
  if (const ResultTable* const of_all = table_named(outcome, shares)) {
    const std::optional<double> chance = one_chance(*of_all);
    for (ForestRow& row : rows) row.chance = chance;
  }
  Figure figure{
      .name = table.name + "_forest",
      .title = table.title,
      .note =
          has_intervals(rows)
              ? phrase(
                    "Figures",
                    "Squares are means of the participants' own proportions; error bars show their "
                    "t-based 95 % CIs on the logit scale: the participant is the unit of analysis.")
              : phrase("Figures",
                       "Squares are means of the participants' own proportions: the participant is "
                       "the unit of analysis.")};
  add_rows(rows, {{}},
           has_intervals(rows) ? phrase("Figures", "mean proportion, with its 95 % CI")
                               : phrase("Figures", "mean proportion"),
           figure);
  for (FigureSeries& series : figure.series) series.style = 1;
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

Figure proportion_forest(const TidyInput& input, const FoundNumbers& found) {
  Figure figure{
      .name = "proportions",
      .title = phrase("Figures", "Proportions with their CIs"),
      .note = phrase("Figures", "Points are proportions; error bars show their Wilson 95 % CIs.")};
  std::vector<ForestRow> rows = rows_of(found, "phat");
  const TidyTable& table = input.table();
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<double> chances = table.all_numbers("p0");
  std::size_t row = 0;
  for (std::size_t i = 0; i < trials.size() && row < rows.size(); ++i) {
    if (trials[i] > 0) rows[row++].chance = chances[i];  // without trials there is no proportion
  }
  add_rows(rows, {{}}, share_axis(percent_of(found.all("phat"))), figure);
  return figure;
}

Figure selection_forest(const FoundNumbers& found) {
  Figure figure{
      .name = "choices",
      .title = phrase("Figures", "Proportion of choices of each alternative"),
      .note = phrase("Figures",
                     "Circles are proportions of the choices of a row with Wilson 95 % CIs, which "
                     "are too narrow where a participant chose more than once. Squares are means "
                     "of the participants' own proportions with t-based 95 % CIs.")};
  std::vector<ForestRow> rows = rows_of(found, "prop");
  std::set<std::string> alternatives{};
  for (const Finding* one : found.all("prop")) alternatives.insert(one->key.last());
  std::optional<double> chance{};
  if (!alternatives.empty()) chance = 1.0 / static_cast<double>(alternatives.size());
  for (ForestRow& row : rows) row.chance = chance;
  add_mean_of_people(found, chance, rows);
  add_rows(rows, pooled_and_people(), share_axis(percent_of(found.all("prop"))), figure);
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

Figure matching_forest(const FoundNumbers& found) {
  Figure figure{.name = "textures_matched",
                .title = phrase("Figures", "Proportion of correct matches of each texture"),
                .note = phrase("Figures",
                               "Proportions of the trials with that texture, with Wilson 95 % CIs; "
                               "the rows are not independent of each other.")};
  std::vector<ForestRow> rows = rows_of(found, "texture.prop");
  // Keys "n=4;k=0", "n=4;k=1", … up to all items.
  const std::size_t outcomes = found.all("null.pmf").size();
  for (ForestRow& row : rows) {
    if (outcomes > 1) row.chance = 1.0 / static_cast<double>(outcomes - 1);
  }
  add_rows(rows, {{}}, share_axis(percent_of(found.all("texture.prop"))), figure);
  return figure;
}

Figure recognition_forest(const FoundNumbers& found) {
  Figure figure{
      .name = "recognised",
      .title = phrase("Figures", "Proportion correct for each stimulus"),
      .note = phrase("Figures",
                     "Circles are proportions of the trials with that stimulus, with Wilson 95 % "
                     "CIs that treat trials as independent. The square is the mean of the "
                     "participants' own proportions with a t-based 95 % CI on the logit scale.")};
  std::vector<ForestRow> rows{};
  for (const Finding* recall : found.all("recall")) {
    // Its n counts participants; the number of trials is in the row of the confusions.
    double trials = 0.0;
    for (const Finding* one : found.all("confusion")) {
      if (one->key[0] == recall->key.last()) trials += one->value.value_or(0.0);
    }
    const double hits = found.value("confusion", {recall->key, recall->key}).value_or(0.0);
    rows.push_back({.label = count_phrase(recall->key.last(), static_cast<std::size_t>(hits),
                                          static_cast<std::size_t>(trials)),
                    .share = recall->value,
                    .interval = interval_of(*recall)});
  }
  const std::optional<double> chance =
      rows.empty() ? std::nullopt : std::optional(1.0 / static_cast<double>(rows.size()));
  if (const Finding* pc = found.find("pc")) {
    rows.push_back(
        {.label = count_phrase(phrase("Figures", "all together"),
                               static_cast<std::size_t>(found.value("correct").value_or(0.0)),
                               static_cast<std::size_t>(found.value("n").value_or(0.0))),
         .share = pc->value,
         .interval = interval_of(*pc)});
  }
  for (ForestRow& row : rows) row.chance = chance;
  add_mean_of_people(found, chance, rows);
  add_rows(rows, pooled_and_people(), share_axis(percent_of(found.all("pc"))), figure);
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

std::vector<Figure> seedpaper_forests(const FoundNumbers& found) {
  std::vector<Figure> figures{};
  const Phrase note = phrase("Figures",
                             "Proportions with Wilson 95 % CIs, one choice per participant and "
                             "experiment; choices in all experiments are treated as independent.");
  figures.push_back({.name = "table_1", .title = phrase("Figures", "Choices"), .note = note});
  std::vector<ForestRow> choices = rows_of(found, "t1.prop");
  std::set<std::string> renderers{};
  for (const Finding* one : found.all("t1.prop")) renderers.insert(one->key.last());
  for (ForestRow& row : choices) row.chance = 1.0 / static_cast<double>(renderers.size());
  add_rows(choices, {{}}, share_axis("95"), figures.back());
  for (const auto& [table, title] :
       {std::pair{std::string("t2"), phrase("Figures", "Textures matched to their pictures")},
        std::pair{std::string("t3"), phrase("Figures", "Textures recognised")}}) {
    Figure& figure = figures.emplace_back(
        Figure{.name = "table_" + table.substr(1), .title = title, .note = note});
    add_rows(rows_of(found, composed_quantity(table + ".prop")), {{}}, share_axis("95"), figure);
  }
  return figures;
}

}  // namespace asperity
