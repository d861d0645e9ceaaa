// `--model ID`: a force model on the command line.

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "protocols/design/wording.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Lives as long as the registry.
///
/// Errors: std::runtime_error for an id that there is not, naming one whose id is close, or else all.
inline const ForceModel& model_named(const ModelRegistry& models, const std::string& id) {
  if (const ForceModel* model = models.find(id)) return *model;
  std::vector<std::string> ids{};
  for (const ForceModel& model : models.models()) ids.push_back(model.declaration.id);
  const std::string guess = did_you_mean(id, ids);
  throw std::runtime_error("there is no force model " + in_quotes(id) +
                           (guess.empty() ? "; write " + one_of(ids) + "; if" : guess + " If") +
                           " it is in a plug-in, load the plug-in with --plugin FILE");
}

}  // namespace asperity
