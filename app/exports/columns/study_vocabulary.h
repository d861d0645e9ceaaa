// The vocabulary of a study: the names in its rows, and how protocols and force models declare them.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/age_bands.h"
#include "app/exports/columns/export_column.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "protocols/design/analysis_declaration.h"
#include "protocols/file/stored_protocol.h"

namespace asperity {

class ModelRegistry;
class Study;

/// The names that the rows and protocols of a study use, with their declarations by the protocols and the
/// force models.
struct StudyVocabulary {
  struct FactorMeaning {
    std::string meaning{};
    std::string unit{};
    std::string source = "plans of the trials";
    std::vector<std::string> levels{};
    std::map<std::string, LevelMeaning> level_meanings{};
    bool numeric = true;
  };
  struct ParameterMeaning {
    std::set<std::string> models{};    ///< with this parameter
    std::set<std::string> levels{};    ///< if it is not a number
    std::set<std::string> meanings{};  ///< as the models declare them
    std::optional<std::string> unit{};
    std::optional<double> minimum{};
    std::optional<double> maximum{};
  };
  struct AnswerMeaning {
    std::string prompt{};
    bool free_text = true;     ///< false if a protocol declares another form
    bool has_several = false;  ///< a multiple choice: an answer has several options
    /// The participant has no own scale for it: a point of a stated scale, or an additional question.
    bool has_no_own_scale = false;
    std::string unit{};        ///< of a number
    /// The condition under which it is asked, as `clause_of` states it; empty: always asked.
    std::string condition{};
    std::string asked_after{};  ///< the question whose answer the condition is about; empty without
    bool questionnaire = true;  ///< about a participant or a session, not about a trial
    std::vector<std::string> options{};
    std::map<std::string, LevelMeaning> option_meanings{};  ///< if shown as another text
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    std::string source{};
  };
  std::map<std::string, FactorMeaning> factors{};
  /// The kinds of experiment of the blocks, by the SHA-256 of the protocol file and the block.
  std::map<std::pair<std::string, std::string>, std::string> kinds_of_blocks{};
  /// The types of the catch trials, by the same; of blocks with catch trials only.
  std::map<std::pair<std::string, std::string>, std::string> catch_types{};
  struct BlockOfDiscrimination {
    DiscriminationTask task{};
    /// Factors whose level is drawn for every trial: they are not conditions.
    std::vector<std::string> drawn{};
    /// Of the procedure that chose its levels from the responses; empty without one.
    std::vector<ProcedureSettings> tracks{};
    Dimension levels{};
  };
  /// Those of the blocks that are discriminations with a standard of a known value, by the same.
  std::map<std::pair<std::string, std::string>, BlockOfDiscrimination> discriminations{};
  std::map<std::string, ParameterMeaning> parameters{};
  std::map<std::string, std::set<std::string>> limits{};  ///< kind → models that monitor it
  std::map<std::string, std::set<std::string>> assets{};  ///< declared role → models that used one
  /// The spacings of textures that protocol files for magnitude estimation declare, by the file's SHA-256.
  std::map<std::string, EstimationDeclaration> estimations{};
  std::map<std::string, std::string> titles{};  ///< by the SHA-256 of a protocol file
  /// What participants were to see and hear, by the same.
  std::map<std::string, StoredProtocol::Senses> senses{};
  /// The factor of the groups of participants, by the SHA-256 of a protocol file that has groups.
  std::map<std::string, std::string> group_factors{};
  std::set<std::string> groups{};  ///< of participants, as sessions store them
  std::set<std::string> participant_answers{};
  std::map<std::string, AnswerMeaning> questions{};  ///< by name, of all protocols
  /// The questions of questionnaires in each protocol file, by the SHA-256 of the file and the name.
  std::map<std::pair<std::string, std::string>, AnswerMeaning> questions_of_source{};
  /// By the SHA-256 of a protocol file, that of the first file that differs from it in texts only, which may be
  /// the file itself.
  std::map<std::string, std::string> first_wording{};
  /// By the SHA-256 of a protocol file, the language of its texts.
  std::map<std::string, std::string> languages{};
  std::vector<std::string> known_languages{};  ///< those, each once
  /// Questions of questionnaires that were named to be published.
  std::set<std::string> for_public{};
  /// In place of the ages; absent: the ages are exported.
  std::optional<AgeBands> age_bands{};

  /// Whether a public export includes the responses to this question of a questionnaire. False for free text,
  /// and for a question that no protocol declares.
  bool is_published(const std::string& question) const;
  /// Whether the responses to this question are texts in the participants' words.
  bool is_free_text(const std::string& question) const;
  bool has_several_answers(const std::string& question) const;
  bool has_no_own_scale(const std::string& question) const;
  /// Of the question of a questionnaire in the protocol file with this SHA-256; null if the file declares none.
  const AnswerMeaning* meaning_of(const std::string& source_sha256,
                                  const std::string& question) const;
};

/// A protocol that cannot be read and a model that this program does not know declare nothing: their columns
/// have only the facts from the rows.
StudyVocabulary vocabulary_of(const Study& study, const ModelRegistry& loaded);
/// Only what the protocols declare, for which no row of a session is read.
StudyVocabulary vocabulary_of_protocols(const Study& study);

}  // namespace asperity
