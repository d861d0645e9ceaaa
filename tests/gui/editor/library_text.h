// The text of a protocol of the library.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "protocols/file/library_protocols.h"

namespace asperity {

inline std::string library_text(std::string_view name) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (protocol.name == name) return std::string(protocol.text);
  }
  throw std::runtime_error("no such protocol");
}

}  // namespace asperity
