// Makes the parts of a text for a paper.

#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/report/text/report_sections.h"

namespace asperity {

/// The keys of the cited publications.
using Sources = std::set<std::string>;
/// " (Holm, 1979)"; adds the key to the sources.
std::string cited(const std::string& key, Sources& sources);
/// The text with every " [Holm 1979]" replaced by " (Holm, 1979)"; adds the keys to the sources.
std::string with_citations(std::string text, Sources& sources);

/// Separated by blanks, without empty ones.
std::string with_sentences(const std::vector<std::string>& sentences);

/// The paragraphs on participants and apparatus, on the task, and on the procedure, each sentence derived from stored
/// data.
std::vector<std::string> paper_procedure(const ReportFacts& facts, const StudyMetadata& metadata,
                                         Sources& sources);

}  // namespace asperity
