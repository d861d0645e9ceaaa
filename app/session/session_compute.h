// Declares where the contacts of two textured bodies are evaluated in a session, and how that is stored.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"
#include "renderers/compute/compute_device.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The first compute device of this machine, for which a tick waits 0.4 ms; then the processor evaluates the contacts.
///
/// Errors: PhrasedError with the remedy, on a machine without one.
std::shared_ptr<const Compute> compute_in_real_time();

/// The same device, for which a tick waits as long as any needs.
std::shared_ptr<const Compute> compute_on_simulated_clock();

/// Throws PhrasedError if no stimulus of the protocol has a model with two bodies, whose contacts could be evaluated.
void require_two_bodies(const Protocol& protocol, const ModelRegistry& models);

/// `compute` in the data of `session_began` and `session_resumed`: the device on which models evaluate contacts; null
/// for the processor.
nlohmann::ordered_json json_of_compute(const ModelRegistry& models);

/// The device in the data of such an event; nullopt: the processor.
std::optional<ComputeDeviceName> stored_compute(const nlohmann::json& data);

/// Whether results are the same in every bit.
bool is_same(const ComputeDeviceName& one, const ComputeDeviceName& other);

}  // namespace asperity
