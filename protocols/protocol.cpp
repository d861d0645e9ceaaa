// Text of a level.

#include "protocols/protocol.h"

#include "protocols/wording.h"

namespace asperity {

std::string text_of(const Level& level) {
  const double* const number = std::get_if<double>(&level);
  return number == nullptr ? std::get<std::string>(level) : digits(*number);
}

}  // namespace asperity
