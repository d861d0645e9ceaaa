// The sentences of drivers, which windows translate.

#pragma once

#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

/// What a driver states: translated where it is one of its constant sentences, which scripts/key_texts.py lists; in English where it
/// names a device, a file or a service.
inline Phrase phrase_of_driver(const std::string& stated) {
  return stated.empty() ? Phrase() : Phrase("Drivers", stated.c_str());
}

}  // namespace asperity
