// The confusion matrix: stimuli in rows, responses in columns.

#include "app/findings/shared/figures/confusion_figure.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

struct Confusions {
  std::vector<std::string> felt{};
  std::vector<std::string> chosen{};
  std::vector<std::vector<double>> counts{};  ///< by felt, then by chosen
};

std::size_t place_of_name(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

Phrase word_of_name(const std::string& name) {
  return name == kCannotTell ? phrase("Figures", "cannot tell") : Phrase(name);
}

Figure figure_of(const Confusions& confusions) {
  Figure figure{
      .name = "confusions",
      .title = phrase("Figures", "Confusion matrix"),
      .note = phrase("Figures",
                     "Numbers are counts of responses; the shade is their proportion among the "
                     "responses to the stimulus. Correct responses are framed."),
      .shape = FigureShape::square,
      .shade_name = phrase("Figures", "proportion of the row")};
  double all = 0.0;
  figure.x.name = phrase("Figures", "response");
  figure.y.name = phrase("Figures", "stimulus");
  for (const std::string& name : confusions.chosen) figure.x.places.push_back(word_of_name(name));
  for (std::size_t row = 0; row < confusions.felt.size(); ++row) {
    figure.y.places.push_back(confusions.felt[row]);
    double sum = 0.0;
    for (const double count : confusions.counts[row]) sum += count;
    all += sum;
    for (std::size_t column = 0; column < confusions.chosen.size(); ++column) {
      const double count = confusions.counts[row][column];
      FigureCell cell{.column = column,
                      .row = row,
                      .text = number_text(count),
                      .framed = confusions.felt[row] == confusions.chosen[column]};
      if (sum > 0.0) cell.shade = count / sum;
      figure.cells.push_back(std::move(cell));
    }
  }
  if (!(all > 0.0)) {
    figure.instead = phrase(
        "Figures", "There are no responses and therefore no confusions; collect responses first.");
  }
  return figure;
}

}  // namespace

Figure confusion_figure(const FoundNumbers& found) {
  Confusions confusions{};
  for (const Finding* one : found.all("confusion")) {
    const std::vector<std::string>& parts = one->key.names();
    if (parts.size() != 2) continue;
    const std::size_t row = place_of_name(confusions.felt, parts[0]);
    const std::size_t column = place_of_name(confusions.chosen, parts[1]);
    confusions.counts.resize(confusions.felt.size());
    std::vector<double>& counts = confusions.counts[row];
    counts.resize(std::max(counts.size(), column + 1));
    counts[column] = one->value.value_or(0.0);
  }
  for (std::vector<double>& counts : confusions.counts) counts.resize(confusions.chosen.size());
  return figure_of(confusions);
}

std::vector<Figure> confusion_figures(const ResultTable& table, const AnalysisOutcome&) {
  Confusions confusions{};
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    confusions.chosen.push_back(table.columns[i].id);
  }
  for (const ResultRow& cells : table.rows) {
    const auto* felt = std::get_if<std::string>(&cells.front());
    confusions.felt.push_back(felt == nullptr ? "–" : *felt);
    std::vector<double>& counts = confusions.counts.emplace_back();
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const auto* count = std::get_if<std::int64_t>(&cells[i]);
      counts.push_back(count == nullptr ? 0.0 : static_cast<double>(*count));
    }
  }
  return {answering("confusions", figure_of(confusions))};
}

}  // namespace asperity
