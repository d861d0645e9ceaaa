// A report as a value: its content, independent of its layout.

#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// A paragraph. All text of a report is plain, in English, and may contain any character.
struct ReportText {
  enum class Tone {
    plain,
    lead,    ///< the summary sentence
    notice,  ///< qualifies the results
  };
  std::string text{};
  Tone tone = Tone::plain;
};

/// Parallel sentences.
struct ReportList {
  std::vector<std::string> items{};
};

struct ReportColumn {
  std::string heading{};
  bool holds_numbers = false;
};

struct ReportTable {
  int number = 0;  ///< in reading order, from 1
  std::string title{};
  std::vector<ReportColumn> columns{};
  std::vector<std::vector<std::string>> rows{};  ///< as they are displayed
  std::string note{};
  bool is_reference = false;  ///< for reference, not for continuous reading
};

struct ReportFigure {
  int number = 0;  ///< in reading order, from 1
  Figure figure{};
};

using ReportPart = std::variant<ReportText, ReportList, ReportTable, ReportFigure>;

struct ReportSection {
  std::string heading{};
  std::vector<ReportPart> parts{};
};

/// The content for one version of one protocol and one group of participants, or for the study as a
/// whole. Every chapter begins on a new page.
struct ReportChapter {
  std::string heading{};
  /// In the heading of every page: "SIMULATED: no human participant"; empty for data of people in
  /// sessions that count.
  std::string mark{};
  AnswerGroup group = AnswerGroup::people;  ///< the group that the mark refers to
  std::vector<ReportSection> sections{};
};

struct Report {
  std::string title{};
  std::string subtitle{};  ///< the period of the data
  std::string program{};   ///< the program that made the report
  std::vector<ReportChapter> chapters{};
};

}  // namespace asperity
