// The key that ends the visits to a surface, of a block with one question and of one with several.

#pragma once

#include "protocols/design/protocol.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

inline void store_revisits(const nlohmann::json& value, Protocol::Block& block) {
  if (!value.get<bool>()) block.arrangement.maximum_visits = 1;
}

consteval KeyOf<Protocol::Block> revisit_key() {
  return with_standard(
      custom_key<&store_revisits>(
          "allow_revisit", "Surfaces can be felt again",
          "Whether the participant may switch between the surfaces before responding.",
          TruthShape{}),
      [](const ProtocolKey&) { return nlohmann::json(true); });
}

}  // namespace asperity
