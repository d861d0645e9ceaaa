// Declares the lenient reading of a stored protocol.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/answers/question.h"
#include "protocols/design/analysis_declaration.h"
#include "protocols/design/dimension.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/permuted_blocks.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

/// Stores what can be read of a stored protocol. A study keeps the protocols of all its sessions, including those of
/// other versions of the program, which `read_protocol` may reject. Parts that do not have the expected form are
/// absent.
struct StoredProtocol {
  struct TrialQuestion {
    std::string name{};
    std::string prompt{};
    bool has_scale = false;  ///< it states a scale
    /// Of a scale: the labels of its ends; empty without labels.
    std::string low_label{};
    std::string high_label{};
    std::optional<double> minimum{};  ///< of a scale
    std::optional<double> maximum{};
    std::optional<double> points{};  ///< of a scale that has points
    std::string judgement{};         ///< "performance", "comparison"; empty: none
    /// Of the judgement "comparison": whether the question asks for less of the varied parameter; nothing where it is not
    /// stated.
    std::optional<bool> asks_for_less{};
    std::string rates{};  ///< of a similarity: "dissimilarity", "similarity"; empty: dissimilarity
    /// The question whose response it rates the confidence of; empty: none.
    std::string confidence_of{};
  };
  struct Block {
    std::string kind{};  ///< its own, or that of the protocol; empty where neither is stated
    std::string phase{};
    std::vector<TrialQuestion> questions{};
    std::optional<Dimension> vary{};   ///< without levels and unit
    std::string design{};              ///< of a discrimination; empty where none is stated
    bool is_sequential = true;         ///< surfaces are presented one after the other
    std::vector<std::string> drawn{};  ///< factors whose level is drawn for every trial
    bool has_procedure = false;  ///< that chose the levels from the responses; not constant stimuli
    std::string catch_type{};    ///< of its catch trials (CatchType); empty: it has none
    /// The block whose matches determine the amplitudes of its surfaces (`equal_roughness`); empty: none.
    std::string matched_in{};
    /// Of this procedure, for every combination of the other factors; empty where they cannot be used.
    std::vector<ProcedureSettings> tracks{};
    /// The factors whose levels determine its surfaces, each once, by name.
    std::vector<std::string> surface_factors{};
  };

  /// What the participant is to see and hear, as stated under `environment` or as the default; absent where another
  /// version states what this one does not know.
  struct Senses {
    std::optional<Vision> vision{};
    std::optional<Protocol::Noise> noise{};  ///< that masks the device
  };

  std::string title{};
  Senses senses{};
  std::map<std::string, Factor, std::less<>> factors{};
  std::map<std::string, Question, std::less<>> questions{};
  std::map<std::string, Block> blocks{};  ///< those with a question
  AnalysisDeclaration analysis{};
  std::optional<EstimationDeclaration> estimation{};
  /// Of matching and recognition: the pictures of the questions in their order, then the levels of the factors.
  std::vector<std::string> pictures{};
  /// The kinds of the blocks, each once.
  std::vector<std::string> kinds() const;

  /// Of a selection whose alternatives differ only in the level of one parameter: the parameter's name.
  std::optional<std::string> compared_parameter{};
  std::string group_factor{};  ///< whose levels are the groups of participants; empty: no groups
  std::vector<std::string> groups{};                ///< those levels, as text
  std::optional<PermutedBlocks> permuted_blocks{};  ///< in which the program assigns the groups
};

/// Accepts any text; for one that is not JSON, all parts are absent.
StoredProtocol stored_protocol(const std::string& source);

/// The canonical text of a protocol without its language and texts: those for participants (instructions, consent,
/// screens, breaks, wording of questions and options) and those that describe the protocol (title, description,
/// meanings, notes). Protocols with equal results ask the same questions in the same plan. For a text that is not JSON,
/// the text itself.
std::string without_texts(const std::string& source);

/// The language that the source states; "en" if it states none.
std::string language_of(const std::string& source);

/// The number of distinct protocols among the files, which contain no text twice. Files that differ in language and
/// texts only count as one protocol in several languages; two such files in the same language count as two, because the
/// texts for participants are part of the experiment.
std::size_t count_protocols(const std::vector<std::string>& sources);

}  // namespace asperity
