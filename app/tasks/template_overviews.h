// Lists the protocols of the library for the choice of a template, and the reliefs of a study that can be its textures.

#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/tasks/protocol_templates.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"

namespace asperity {

struct TemplateOverview {
  std::string name{};  ///< in the library
  /// In each of its languages: first that of the reader if it has this one, and otherwise its own.
  std::vector<Protocol> protocols{};
  PlanCost cost{};  ///< of one session
  TexturesOfTemplate textures{};
};

/// All of them, in the order of the library. `language`: that of the reader, a BCP 47 tag.
std::vector<TemplateOverview> template_overviews(const ModelRegistry& models,
                                                 const std::string& language,
                                                 const std::stop_token& stop);

/// The stem of a file as a name of a protocol, to which a number can be added: "Brick wall-2" → "brick_wall_2".
std::string name_in_protocol(const std::string& stem);

/// The height fields in `stimuli/`, by file, each with the photograph that it was made from if the study has it, and with the
/// spacing of a computed surface. True reliefs of the demonstration are left out. Names are those of the files as names of a
/// protocol.
///
/// Errors: ResultsError for a folder that cannot be read.
std::vector<OwnTexture> reliefs_of_study(const std::filesystem::path& study);

}  // namespace asperity
