// What every analysis returns and every face shows.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace asperity {

/// One number with everything that a reader needs to use it: a row of a table of results.
///
/// `quantity` says what was computed ("proportion"), `key` for whom or what ("model=sinusoid").
/// An analysis that cannot answer says so in `status`, in a sentence for the person who must act,
/// and leaves `value` empty; it does not leave out the row. Where the answer is no number, `word`
/// is it, fixed for programs: TRUE, FALSE, Inf, -Inf, NA (undefined for these data), ok, or why
/// there is none, like not_estimable.
struct Finding {
  std::string quantity{};
  std::string key{};
  std::optional<double> value{};
  std::string word{};  ///< the answer where it is no number; empty where it is
  std::string unit{};  ///< as SI writes it; "1" for a pure number
  std::optional<double> low{};
  std::optional<double> high{};
  std::optional<double> confidence{};  ///< of the interval from low to high
  std::string method{};                ///< what was computed, and against which chance
  std::string status = "ok";
  std::size_t n = 0;  ///< independent units behind the value
  std::string
      analysis{};  ///< which of several that stand together: "choice", "position"; may be empty

  bool operator==(const Finding&) const = default;
};

}  // namespace asperity
