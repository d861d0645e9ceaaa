// Declares the interface through which checks of a protocol report problems.

#pragma once

#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

/// Collects the problems of a protocol by location in its file. A location is a JSON pointer ("/blocks/main/question");
/// a problem that is reported twice at one location counts once.
class ProblemSink {
 public:
  /// Reports a problem at the value of the pointer.
  virtual void report(const std::string& pointer, Phrase message) = 0;
  /// Windows could not translate it.
  void report(const std::string& pointer, const std::string& message) = delete;
  /// Reports a problem at the key of that value: for a key that is not permitted.
  virtual void report_key(const std::string& pointer, Phrase message) = 0;
  void report_key(const std::string& pointer, const std::string& message) = delete;

 protected:
  ProblemSink() = default;
  ProblemSink(const ProblemSink&) = default;
  ProblemSink& operator=(const ProblemSink&) = default;
  ~ProblemSink() = default;
};

}  // namespace asperity
