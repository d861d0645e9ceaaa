// Declares the conversion of a plug-in's description into a force model.

#pragma once

#include <memory>
#include <string>

#include "renderers/force/force_model.h"
#include "renderers/plugin/asperity_plugin.h"

namespace asperity {

/// The force model that a plug-in describes, like a built-in one: SurfaceContact gives it its place, border and friction, and
/// it has the parameters of the shared layers after its own.
///
/// The model and its renderers keep `library`, so that the plug-in stays loaded while one of them exists. `file` is the name of
/// the file, for PluginCall.
///
/// A renderer whose plug-in reports an error, throws, or returns a number that is not finite as stored (rendered_tick.h) or a
/// negative normal force or penetration returns NaN from then on, until `reset`: ServoLoop raises Fault::not_finite, which latches the force at zero.
/// ForceRenderer::error states the reason, and the limits `plugin_error` and `plugin_not_valid` count the ticks.
///
/// Errors: std::invalid_argument, naming the field and the correction, for another version of the interface and for a
/// description that is incomplete or contradicts itself. `make` and `band` throw std::invalid_argument with the plug-in's message.
ForceModel model_of_plugin(const asperity_model& description, std::shared_ptr<const void> library,
                           const std::string& file);

}  // namespace asperity
