// Declares where the contacts of two textured bodies are evaluated in a session, and how that is stored.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "renderers/compute/compute_device.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The first compute device of this machine, with the time for which a tick of the session waits for it: 0.4 ms in real
/// time, after which the processor evaluates the contacts; on a simulated clock long enough for any device.
///
/// Errors: PhrasedError with the remedy, on a machine without one.
std::shared_ptr<const Compute> compute_of_session(bool in_real_time);

/// `compute` in the data of `session_began` and `session_resumed`: the device on which models evaluate contacts; null
/// for the processor.
nlohmann::ordered_json json_of_compute(const ModelRegistry& models);

/// The device in the data of such an event; nullopt: the processor.
std::optional<ComputeDeviceName> stored_compute(const nlohmann::json& data);

/// Whether results are the same in every bit.
bool is_same(const ComputeDeviceName& one, const ComputeDeviceName& other);

}  // namespace asperity
