// Checks a protocol file completely: its text, its files in a study, a device, its plan and its translations.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/study_files/height_field_files.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Every problem of one file, and a summary of its plan when there is none.
struct ProtocolCheck {
  std::string file{};
  std::string text{};                     ///< that was checked; empty if the file could not be read
  std::vector<Diagnostic> diagnostics{};  ///< from all layers, in the order of lines
  std::vector<Diagnostic>
      warnings{};  ///< about content that is formally valid (`warnings_about`), in the order of lines
  std::optional<Protocol> protocol{};
  PlanCost cost{};
  /// The design of each main block that has one in words (`design_of`), by the name of the block.
  std::map<std::string, Phrase> designs{};

  bool is_valid() const noexcept { return protocol && diagnostics.empty(); }
};

/// Never throws because of the file's content. A translation that cannot be used is a problem of its own file, and a
/// warning about the protocol's. With a study, the files that the protocol names are
/// looked up and the height fields read; with a simulated device, its capability is compared.
/// Errors: those of `simulated_settings` for the name of the device, which are no problems of the protocol.
ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device);
/// The same for a text that need not be on disk. `file_name` names the file in its problems. `kept` (null: none) has height
/// fields that earlier checks have read.
ProtocolCheck check_protocol_text(const std::string& text, const std::string& file_name,
                                  const ModelRegistry& models,
                                  const std::optional<std::filesystem::path>& study,
                                  const std::optional<std::string>& device,
                                  KeptHeightFields* kept = nullptr);

}  // namespace asperity
