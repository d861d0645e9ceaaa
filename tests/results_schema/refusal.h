// What a function says when it refuses.

#pragma once

#include <string>

#include "results_schema/study.h"

namespace asperity {

/// The sentence of the ResultsError; empty when the function does not throw.
template <typename Function>
std::string refusal(Function function) {
  try {
    function();
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "";
}

}  // namespace asperity
