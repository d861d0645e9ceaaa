#include "app/gui/data/analysis_words.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace asperity {

namespace {

struct Word {
  std::string_view stored{};
  const char* shown = nullptr;
};

constexpr std::array kHeadings{
    Word{"achieved_maximum_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, maximum, N")},
    Word{"achieved_mean_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, mean, N")},
    Word{"achieved_minimum_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, minimum, N")},
    Word{"achieved_sd_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, SD, N")},
    Word{"against", QT_TRANSLATE_NOOP("AnalysisWords", "against")},
    Word{"all", QT_TRANSLATE_NOOP("AnalysisWords", "all")},
    Word{"answers", QT_TRANSLATE_NOOP("AnalysisWords", "answers")},
    Word{"chance", QT_TRANSLATE_NOOP("AnalysisWords", "chance")},
    Word{"chance 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "chance, 95 %")},
    Word{"chosen", QT_TRANSLATE_NOOP("AnalysisWords", "chosen")},
    Word{"clopper_pearson 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Clopper–Pearson, 95 %")},
    Word{"column", QT_TRANSLATE_NOOP("AnalysisWords", "column")},
    Word{"correct", QT_TRANSLATE_NOOP("AnalysisWords", "correct")},
    Word{"felt", QT_TRANSLATE_NOOP("AnalysisWords", "felt")},
    Word{"item", QT_TRANSLATE_NOOP("AnalysisWords", "item")},
    Word{"matched_mean_N", QT_TRANSLATE_NOOP("AnalysisWords", "aimed at, mean, N")},
    Word{"maximum", QT_TRANSLATE_NOOP("AnalysisWords", "maximum")},
    Word{"mean", QT_TRANSLATE_NOOP("AnalysisWords", "mean")},
    Word{"median", QT_TRANSLATE_NOOP("AnalysisWords", "median")},
    Word{"minimum", QT_TRANSLATE_NOOP("AnalysisWords", "minimum")},
    Word{"model", QT_TRANSLATE_NOOP("AnalysisWords", "model")},
    Word{"of", QT_TRANSLATE_NOOP("AnalysisWords", "of")},
    Word{"p", QT_TRANSLATE_NOOP("AnalysisWords", "p")},
    Word{"person", QT_TRANSLATE_NOOP("AnalysisWords", "person")},
    Word{"persons", QT_TRANSLATE_NOOP("AnalysisWords", "persons")},
    Word{"sd", QT_TRANSLATE_NOOP("AnalysisWords", "SD")},
    Word{"share", QT_TRANSLATE_NOOP("AnalysisWords", "share")},
    Word{"surfaces", QT_TRANSLATE_NOOP("AnalysisWords", "surfaces")},
    Word{"texture", QT_TRANSLATE_NOOP("AnalysisWords", "texture")},
    Word{"wilson 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Wilson, 95 %")}};

constexpr std::array kPersons{
    Word{"Female", QT_TRANSLATE_NOOP("AnalysisWords", "Female")},
    Word{"Male", QT_TRANSLATE_NOOP("AnalysisWords", "Male")},
    Word{"Other or not told", QT_TRANSLATE_NOOP("AnalysisWords", "Other or not told")},
    Word{"Total", QT_TRANSLATE_NOOP("AnalysisWords", "Total")}};

/// Null where the program has no word of its own for it.
const char* shown_in(const auto& words, const std::string& stored) {
  const auto* found = std::find_if(words.begin(), words.end(),
                                   [&](const Word& word) { return word.stored == stored; });
  return found == words.end() ? nullptr : found->shown;
}

}  // namespace

QString AnalysisWords::of_heading(const NamedTable& table, const std::string& column) {
  const bool is_picture = table.name == kConfusion && column != table.table.columns.front();
  if (is_picture) return QString::fromStdString(column);
  if (const char* shown = shown_in(kHeadings, column)) return tr(shown);
  constexpr std::string_view kColumn = "column_";  // and the level of the factor
  if (column.starts_with(kColumn)) {
    return tr("column %1").arg(QString::fromStdString(column.substr(kColumn.size())));
  }
  return QString::fromStdString(column);
}

QString AnalysisWords::of_cell(const std::string& column, const std::string& text) {
  const char* shown = nullptr;
  if (column == "person") shown = shown_in(kPersons, text);
  if ((column == "column" || column == "answers") && text == "all") shown = "all";
  if (column == "item" && text == "cannot_tell") {
    shown = QT_TRANSLATE_NOOP("AnalysisWords", "cannot tell");
  }
  return shown == nullptr ? QString::fromStdString(text) : tr(shown);
}

}  // namespace asperity
