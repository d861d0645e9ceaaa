// The message with which something is refused.

#pragma once

#include <concepts>
#include <exception>
#include <string>

namespace asperity {

/// The message of the exception that `action` throws; empty where it throws nothing.
///
///   EXPECT_THAT(refusal_of<ResultsError>([&] { study.protocol(99); }), HasSubstr("has no protocol"));
///
/// An exception of another type than `Error` is passed on, and fails the test.
template <typename Error = std::exception, std::invocable Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace asperity
