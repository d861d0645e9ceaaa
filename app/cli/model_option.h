// `--model ID`: a force model on the command line.

#pragma once

#include <stdexcept>
#include <string>

#include "renderers/force_model.h"

namespace asperity {

/// Lives as long as the registry.
///
/// Errors: std::runtime_error for an id that there is not, naming those that there are.
inline const ForceModel& model_named(const ModelRegistry& models, const std::string& id) {
  if (const ForceModel* model = models.find(id)) return *model;
  std::string sentence = "there is no force model \"" + id + "\"; there are:";
  for (const ForceModel& model : models.models()) sentence += ' ' + model.declaration.id;
  throw std::runtime_error(sentence);
}

}  // namespace asperity
