// What the stored text of a protocol specifies, read leniently.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/analysis_declaration.h"

namespace asperity {

/// A study keeps the protocols of all its sessions, also those of other versions of the program, which `read_protocol`
/// may refuse. This is what can be read of any of them: what is not there in the expected form is absent.
struct StoredProtocol {
  struct Factor {
    std::string meaning{};
    std::string unit{};
    std::map<std::string, std::string> hed{};  ///< level → its HED tags
  };
  /// Of a questionnaire.
  struct Question {
    std::string prompt{};
    std::string form{};  ///< "choice", "number", "text"
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    std::vector<std::string> options{};
    std::map<std::string, std::string> option_texts{};  ///< by option, where another text was shown
  };
  struct TrialQuestion {
    std::string name{};
    std::string prompt{};
  };

  std::string title{};
  std::map<std::string, Factor> factors{};
  std::map<std::string, Question> questions{};
  std::map<std::string, TrialQuestion> trial_questions{};  ///< by block
  AnalysisDeclaration analysis{};
  std::optional<EstimationDeclaration> estimation{};
  /// Of matching and recognition: the pictures of its questions in their order, then the levels of its factors.
  std::vector<std::string> pictures{};
  /// Of a selection whose alternatives differ in nothing but the level of one parameter: its name.
  std::optional<std::string> compared_parameter{};
};

/// Of any text, also of one that is not JSON: then nothing is specified.
StoredProtocol stored_protocol(const std::string& source);

/// The same for all protocols that differ in nothing but their language and their texts: what participants read
/// (instructions, consent, screens, breaks, wording of questions and options) and what describes the protocol (title,
/// description, meanings, notes). Two of them ask the same in the same plan. Of a text that is not JSON, the text.
std::string without_texts(const std::string& source);

/// The language that the source states; "en" where it states none.
std::string language_of(const std::string& source);

/// How many protocols the files (no text twice) are. Those that differ in language and texts only are one in several
/// languages; two of them in one language are two, because what participants read is part of the experiment.
std::size_t count_protocols(const std::vector<std::string>& sources);

}  // namespace asperity
