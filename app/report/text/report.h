// A report as a value: what it says, before anybody decides how it looks.

#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/findings/figure.h"
#include "app/findings/study/gathered_answers.h"

namespace asperity {

/// A paragraph. All text of a report is plain, in English, and may hold any character.
struct ReportText {
  enum class Tone {
    plain,
    lead,    ///< the sentence for a reader in a hurry
    notice,  ///< to be read before believing a number
  };
  std::string text{};
  Tone tone = Tone::plain;
};

/// Sentences that stand beside each other.
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
  std::vector<std::vector<std::string>> rows{};  ///< as they are to be read
  std::string note{};
  bool is_reference = false;  ///< to look something up in, not to be read
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

/// What belongs to one version of one protocol and one group of participants, or to the study as a
/// whole. No two chapters share a page.
struct ReportChapter {
  std::string heading{};
  /// Stands in the heading of every page: "SIMULATED: no human participant"; empty for what was measured with
  /// people in sessions that count.
  std::string mark{};
  AnswerGroup group = AnswerGroup::people;  ///< whose mark it is
  std::vector<ReportSection> sections{};
};

struct Report {
  std::string title{};
  std::string subtitle{};  ///< from when the data are
  std::string program{};   ///< which one made it
  std::vector<ReportChapter> chapters{};
};

}  // namespace asperity
