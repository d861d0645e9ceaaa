// Names the computer on which a time was measured.

#pragma once

#include <fstream>
#include <string>

namespace asperity {

/// The name of the processor.
inline std::string machine() {
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace asperity
