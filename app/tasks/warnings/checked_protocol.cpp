// Expands the possible trials once, and places diagnostics at bodies and stimuli of the file.

#include "app/tasks/warnings/checked_protocol.h"

#include <utility>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/plan.h"

namespace asperity {

const std::vector<Trial>& CheckedProtocol::trials() const {
  if (!trials_) trials_ = possible_trials(protocol);
  return *trials_;
}

std::vector<CheckedProtocol::Presentation> CheckedProtocol::presentations() const {
  std::vector<Presentation> presentations{};
  for (const Trial& trial : trials()) {
    for (const PlannedPresentation& planned : trial.presentations) {
      presentations.push_back({trial, planned});
    }
  }
  return presentations;
}

Diagnostic CheckedProtocol::at_body(const std::string& name, Phrase message) const {
  return JsonDocument(protocol.source, file_name)
      .at_key(pointer_to("/bodies", name), std::move(message));
}

Diagnostic CheckedProtocol::at_stimulus(const std::string& name, Phrase message) const {
  return JsonDocument(protocol.source, file_name)
      .at_key(pointer_to("/stimuli", name), std::move(message));
}

Diagnostic CheckedProtocol::cannot_be_rendered(const PlannedPresentation& planned,
                                               const Phrase& reason) const {
  return at_stimulus(planned.stimulus_template,
                     phrase("Protocols", "the stimulus %1 cannot be rendered: %2")
                         .with(in_quotes(planned.stimulus.name), reason));
}

}  // namespace asperity
