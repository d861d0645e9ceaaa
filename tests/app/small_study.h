// A study small enough for a unit test: one texture, two models, a few short trials.

#pragma once

#include <filesystem>
#include <string>

#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Makes a study with stimuli/grain.png in it. `folder` must not exist.
void make_small_study(const std::filesystem::path& folder);

/// The protocol of that study: `main` has three trials of two surfaces each, felt for half a
/// second. `block` and `exploration` are JSON members added to the block and the exploration, each
/// with a comma before it; empty for none.
std::string small_protocol(const std::string& block = "", const std::string& exploration = "");

Protocol read_small_protocol(const ModelRegistry& models, const std::string& text);

}  // namespace asperity
