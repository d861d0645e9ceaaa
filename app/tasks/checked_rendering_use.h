// Declares the use of a rendering of a study in a protocol of the study, which is checked before and after the change.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/tasks/rendering_use.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"

namespace asperity {

struct RenderingUseInputs {
  std::filesystem::path study{};
  std::filesystem::path rendering{};  ///< the file
  std::string protocol{};             ///< the text
  std::string file_name{};            ///< names the text in problems and warnings
  RenderingPlace place{};
};
struct RenderingUse {
  RenderingRemarks remarks{};
  std::vector<Diagnostic> problems_before{};  ///< of the protocol; nothing is changed then
  std::string after{};                        ///< the changed text
  std::vector<ChangedValue> changes{};
  std::vector<Diagnostic> problems{};  ///< of the changed protocol
  std::vector<Diagnostic> warnings{};  ///< that the protocol did not have before
};
/// Writes nothing. Errors: as `load_rendering` and `with_rendering`.
RenderingUse use_of_rendering(const RenderingUseInputs& inputs, const ModelRegistry& models);

}  // namespace asperity
