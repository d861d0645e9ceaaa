// The first digits of a SHA-256, for texts.

#pragma once

#include <string>

namespace asperity {

/// The first eight digits.
inline std::string short_hash(const std::string& sha256) { return sha256.substr(0, 8); }

}  // namespace asperity
