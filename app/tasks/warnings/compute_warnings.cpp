// Opens the first compute device, and warns if there is none or if it is not a GPU.

#include "app/tasks/warnings/compute_warnings.h"

#include "app/session/session_compute.h"
#include "app/words/phrase.h"
#include "protocols/file/json_document.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_compute(const Protocol& protocol,
                                               const std::string& file_name) {
  if (!protocol.computes_on_gpu) return {};
  std::string message;
  try {
    const ComputeDeviceName name = compute_on_simulated_clock()->device.name();
    if (name.is_gpu) return {};
    message = "the first OpenCL device of this computer, " + described(name) +
              ", is a processor, not a GPU; use --compute cpu on this computer, or install the "
              "OpenCL driver of its GPU";
  } catch (const PhrasedError& error) {
    message = "on this computer " + std::string(error.what());
  }
  const JsonDocument document(protocol.source, file_name);
  return {document.at("/device/compute", message)};
}

}  // namespace asperity
