// Where checks of a protocol report what is wrong with it.

#pragma once

#include <string>

namespace asperity {

/// Collects the problems of a protocol by their places in its file. A place is a JSON pointer
/// ("/blocks/main/question"); the same problem at the same place counts once.
class ProblemSink {
 public:
  /// At the value that the pointer names.
  virtual void report(const std::string& pointer, std::string message) = 0;
  /// At the key of that value: for a key that should not be there.
  virtual void report_key(const std::string& pointer, std::string message) = 0;

 protected:
  ProblemSink() = default;
  ProblemSink(const ProblemSink&) = default;
  ProblemSink& operator=(const ProblemSink&) = default;
  ~ProblemSink() = default;
};

}  // namespace asperity
