// The words of a report, and its sections by their headings.

#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "app/report/text/report.h"

namespace asperity {

/// Every word of a section, a line per part or row.
inline std::string words_of(const ReportSection& section) {
  std::string text = section.heading + '\n';
  for (const ReportPart& part : section.parts) {
    if (const auto* words = std::get_if<ReportText>(&part)) text += words->text + '\n';
    if (const auto* list = std::get_if<ReportList>(&part)) {
      for (const std::string& item : list->items) text += item + '\n';
    }
    if (const auto* table = std::get_if<ReportTable>(&part)) {
      text += table->title + '\n';
      for (const std::vector<std::string>& row : table->rows) {
        for (const std::string& cell : row) text += cell + " | ";
        text += '\n';
      }
      text += table->note + '\n';
    }
  }
  return text;
}

inline std::string words_of(const ReportChapter& chapter) {
  std::string text = chapter.heading + '\n';
  for (const ReportSection& section : chapter.sections) text += words_of(section);
  return text;
}

inline const ReportSection& section(const ReportChapter& chapter, const std::string& heading) {
  const auto found =
      std::find_if(chapter.sections.begin(), chapter.sections.end(),
                   [&heading](const ReportSection& each) { return each.heading == heading; });
  if (found == chapter.sections.end()) throw std::runtime_error("no section " + heading);
  return *found;
}

}  // namespace asperity
