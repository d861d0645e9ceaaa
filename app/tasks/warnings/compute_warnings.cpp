// Opens the first compute device, and warns if there is none or if it is not a GPU.

#include "app/tasks/warnings/compute_warnings.h"

#include "app/session/session_compute.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/json_document.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_compute(const Protocol& protocol,
                                               const std::string& file_name) {
  if (!protocol.computes_on_gpu) return {};
  Phrase message{};
  try {
    const ComputeDeviceName name = compute_on_simulated_clock()->device.name();
    if (name.is_gpu) return {};
    message = phrase("Protocols",
                     "the first OpenCL device of this computer, %1, is a processor, not a GPU; use "
                     "--compute cpu on this computer, or install the OpenCL driver of its GPU")
                  .with(described(name));
  } catch (const PhrasedError& error) {
    message = phrase("Protocols", "on this computer %1").with(error.said());
  }
  const JsonDocument document(protocol.source, file_name);
  return {document.at("/device/compute", message)};
}

}  // namespace asperity
