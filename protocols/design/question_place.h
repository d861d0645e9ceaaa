// Where a question of a block stands in the file of its protocol.

#pragma once

#include <cstddef>
#include <string>

#include "protocols/design/json_pointer.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// "/blocks/NAME/question", or "/blocks/NAME/questions/1".
inline std::string place_of_question(const Protocol::Block& block, std::size_t question) {
  const std::string pointer = pointer_to("/blocks", block.name);
  return block.has_question_list ? pointer_to(pointer + "/questions", question)
                                 : pointer + "/question";
}

}  // namespace asperity
