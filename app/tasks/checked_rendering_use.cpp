// Changes the text of a protocol, and leaves out the warnings that it had before.

#include "app/tasks/checked_rendering_use.h"

#include <algorithm>
#include <utility>

#include "app/tasks/check_protocol.h"
#include "app/tasks/template_overviews.h"

namespace asperity {

namespace {

/// Lines differ: others come before them.
std::vector<Diagnostic> without_those(std::vector<Diagnostic> warnings,
                                      const std::vector<Diagnostic>& known) {
  std::erase_if(warnings, [&known](const Diagnostic& warning) {
    return std::any_of(known.begin(), known.end(), [&warning](const Diagnostic& each) {
      return each.pointer == warning.pointer && each.message == warning.message;
    });
  });
  return warnings;
}

}  // namespace

RenderingUse use_of_rendering(const RenderingUseInputs& inputs, const ModelRegistry& models) {
  const Rendering rendering = load_rendering(inputs.rendering);
  RenderingUse use{.remarks = remarks_about(rendering, models, inputs.study)};
  std::string picture{};
  for (const OwnTexture& relief : reliefs_of_study(inputs.study)) {
    if (relief.height_field == rendering.texture.height_field) picture = relief.picture;
  }
  const auto checked = [&](const std::string& protocol) {
    return check_protocol_text(protocol, inputs.file_name, models, inputs.study, std::nullopt);
  };
  const ProtocolCheck before = checked(inputs.protocol);
  use.problems_before = before.diagnostics;
  if (!before.is_valid()) return use;
  if (!inputs.place.keeps_texture) {
    if (const auto complaint = complaint_about_picture(*before.protocol, rendering, picture)) {
      use.remarks.problems.push_back(*complaint);
    }
  }
  use.after = with_rendering(inputs.protocol, rendering, rendering_name(inputs.rendering),
                             inputs.place, picture);
  use.changes = changed_values(inputs.protocol, use.after);
  const ProtocolCheck after = checked(use.after);
  use.problems = after.diagnostics;
  use.warnings = without_those(after.warnings, before.warnings);
  return use;
}

}  // namespace asperity
