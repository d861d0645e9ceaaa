// Implements the texts of what a discrimination states.

#include "protocols/kind_keys/discrimination.h"

namespace asperity {

const char* text_of(CatchType type) noexcept {
  switch (type) {
    case CatchType::easy:
      return "easy";
    case CatchType::no_signal:
      return "no_signal";
    case CatchType::identical_pair:
      return "identical_pair";
  }
  return "";
}

}  // namespace asperity
