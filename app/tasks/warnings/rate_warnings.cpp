#include "app/tasks/warnings/rate_warnings.h"

#include <algorithm>
#include <optional>
#include <set>

#include "analysis/numbers/number_text.h"
#include "protocols/file/json_document.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_rate(const CheckedProtocol& checked,
                                            const ModelRegistry& models) {
  const Protocol& protocol = checked.protocol;
  const auto is_too_slow = [&protocol](const ForceModel& model) {
    const std::optional<double>& highest_Hz = model.declaration.maximum_rate_Hz;
    return highest_Hz && protocol.rate_Hz > *highest_Hz;
  };
  // A check while a protocol is edited lists all trials only where one may have such a model.
  if (std::none_of(models.models().begin(), models.models().end(), is_too_slow)) return {};
  std::vector<Diagnostic> warnings{};
  std::set<std::string> reported{};
  const JsonDocument document(protocol.source, checked.file_name);
  for (const auto& [trial, planned] : checked.presentations()) {
    const ForceModel* const model = models.find(planned.stimulus.model);
    if (model == nullptr || !is_too_slow(*model)) continue;
    if (!reported.insert(planned.stimulus.model).second) continue;
    warnings.push_back(document.at(
        "/device/rate_Hz", "a tick of the force model " + planned.stimulus.model +
                               " of the stimulus \"" + planned.stimulus_template +
                               "\" can take longer than a period of the servo loop at " +
                               number_text(protocol.rate_Hz) +
                               " Hz, and late ticks are missed deadlines; set rate_Hz to at most " +
                               number_text(*model->declaration.maximum_rate_Hz)));
  }
  return warnings;
}

}  // namespace asperity
