// An option that takes a file of a force model by its role.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "app/cli/command.h"
#include "renderers/force/force_model.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

/// Adds the file of ROLE=FILE to the files of a model with its name, and returns the role. Errors: WrongUsage for another
/// form and for a role that the model does not declare; ResultsError for a file that cannot be read.
template <class Inputs>
std::string add_asset(Inputs& inputs, const ModelDeclaration& model, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw WrongUsage("--asset " + text + " has no \"=\"; write ROLE=FILE");
  const std::string role = text.substr(0, equals);
  if (std::none_of(model.assets.begin(), model.assets.end(),
                   [&role](const AssetDeclaration& asset) { return asset.role == role; })) {
    throw WrongUsage("--asset " + text + ": the force model " + model.id + " needs no asset \"" +
                     role + "\"; asperity models lists those that it needs");
  }
  const std::string file = text.substr(equals + 1);
  if (const auto given = inputs.asset_names.find(role);
      given != inputs.asset_names.end() && given->second != file) {
    throw WrongUsage("--asset " + text + ": \"" + role + "\" is given twice; give it once");
  }
  inputs.assets[role] = std::make_shared<const std::string>(read_file(file));
  inputs.asset_names[role] = file;
  return role;
}

}  // namespace asperity
