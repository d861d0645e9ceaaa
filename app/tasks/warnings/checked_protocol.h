// A protocol that is checked, and what its sessions can present.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// The lists are made when a check first looks at them, and then serve all checks. Not for several threads at once.
class CheckedProtocol final {
 public:
  /// The protocol must outlive this. `file_name`: in problems and warnings.
  CheckedProtocol(const Protocol& checked, std::string name)
      : protocol(checked), file_name(std::move(name)) {}

  const Protocol& protocol;
  const std::string file_name{};

  /// `possible_trials`
  const std::vector<Trial>& trials() const;

  struct Presentation {
    const Trial& trial;
    const PlannedPresentation& planned;
  };
  /// Every presentation of these trials, in their order.
  std::vector<Presentation> presentations() const;

  /// A problem or a warning at a body or a stimulus template of the file.
  Diagnostic at_body(const std::string& name, Phrase message) const;
  Diagnostic at_stimulus(const std::string& name, Phrase message) const;
  /// The problem of a stimulus that fails for this reason.
  Diagnostic cannot_be_rendered(const PlannedPresentation& planned, const Phrase& reason) const;

 private:
  mutable std::optional<std::vector<Trial>> trials_{};
};

}  // namespace asperity
