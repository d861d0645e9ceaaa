// Walks over the tables; what is drawn of a table, and how, is declared where the table is made.

#include "app/findings/outcome/figures_of.h"

#include <utility>

namespace asperity {

std::vector<Figure> figures_of(const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  for (const ResultTable& table : outcome.tables) {
    if (table.figures == nullptr) continue;
    for (Figure& figure : table.figures(table, outcome)) {
      figure.table = table.name;
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

}  // namespace asperity
