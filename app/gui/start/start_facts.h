// What the page before a session shows of a study and of one of its protocols, read in one go.

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study_files/protocol_languages.h"
#include "app/tasks/unfinished_session.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"
#include "results_schema/rows.h"

namespace asperity {

/// A protocol file as it was when somebody chose it.
struct ChosenProtocol {
  std::filesystem::path file{};                ///< or its translation; empty: none is chosen
  std::shared_ptr<const Protocol> protocol{};  ///< null: not read yet, or not valid
  std::string sha256{};                        ///< of its text
  PlanCost cost{};                             ///< of an example plan
  std::string consent{};                       ///< the statement as it is read; empty: none
  std::vector<Diagnostic> problems{};          ///< why it is not valid
  std::string text{};                          ///< with the problems
  std::string failure{};                       ///< why the file cannot be read at all

  bool is_read() const noexcept {
    return protocol != nullptr || !problems.empty() || !failure.empty();
  }
};

struct StartFacts {
  struct SessionBefore {
    std::string participant{};
    SessionMode mode = SessionMode::run;
    SessionState state = SessionState::open;
    bool of_this_protocol = false;
    std::optional<std::string> group{};     ///< of a session of this protocol, whatever its version
    std::optional<std::string> language{};  ///< the same
  };

  /// A file of the study's `protocols/`, and what it states of itself, as far as it can be read.
  struct ProtocolFile {
    std::filesystem::path file{};
    std::string title{};
    std::string name{};  ///< the file's where the text has none
  };

  std::vector<ProtocolFile> files{};  ///< by file name
  ChosenProtocol chosen{};
  std::vector<ProtocolInLanguage> languages{};  ///< of the chosen one, its own first
  std::vector<ParticipantRow> people{};
  std::vector<SessionBefore> sessions{};
  /// How often each counterbalancing row of the protocol was used, by mode; of a valid one.
  std::map<SessionMode, std::vector<int>> rows_used{};
  /// The study is that of a station: its sessions in the mode run have the rows of the places that are dealt to it.
  bool has_dealt_places = false;
  std::vector<UnfinishedSession> unfinished{};  ///< of this very protocol
};

/// `chosen` with a file alone is read, and checked; one that was read stays as it was, whatever its
/// file says by now. Without a file the only protocol of the study is chosen, if there is only one.
///
/// Takes as long as the study is large. Errors: ResultsError as Study's.
StartFacts read_start_facts(const std::filesystem::path& study, const ChosenProtocol& chosen,
                            const ModelRegistry& models);

}  // namespace asperity
