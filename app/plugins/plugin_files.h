// Loads force models of plug-ins from their files.

#pragma once

#include <filesystem>
#include <vector>

#include "app/plugins/plugin_builds.h"
#include "renderers/conformance/conformance.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Loads a plug-in and checks its description (renderers/plugin/plugin_model.h). ForceModel::plugin has the name and the
/// SHA-256 of the file. The plug-in is unloaded when the last copy of the model and its last renderer are destroyed.
///
/// A copy of the file is loaded, with the content that was hashed: a plug-in that is built anew can be loaded beside its former
/// state, and the file may change while it is in use. Libraries that it needs are therefore not found relative to its folder.
///
/// Code of a plug-in that ends the program with a signal is named on standard error first (renderers/plugin/plugin_call.h).
///
/// A plug-in is part of the program: its code can do everything that the user can. It is therefore loaded only if the user
/// names it, never because a study or a protocol does.
///
/// Errors: std::runtime_error, naming the file, the problem and the remedy, for a file that is not a plug-in, another version of
/// the interface and an invalid description.
ForceModel open_plugin(const std::filesystem::path& file);

/// Adds the model of a plug-in, which meets the conformance suite, to others.
///
/// Errors: as `open_plugin`; std::runtime_error for a model whose id is taken, for one that violates a check, and when the checks
/// were stopped.
void add_plugin(const std::filesystem::path& file, ModelRegistry& models,
                const ConformanceCourse& course = {});

/// The built-in models and those of these plug-ins, each of which meets the conformance suite.
///
/// Errors: as `add_plugin`.
ModelRegistry models_with(const std::vector<std::filesystem::path>& plugins);

/// The same with any number of builds of one plug-in, for a program that renders stored attempts again.
ModelBuilds models_with_builds(const std::vector<std::filesystem::path>& plugins);

/// `models_with` without the conformance suite, for a program that prints its table.
ModelRegistry models_with_unchecked(const std::vector<std::filesystem::path>& plugins);

}  // namespace asperity
