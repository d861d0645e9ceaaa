// What every analysis returns and every face shows.

#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

/// For whom or what a number is: names in their order, such as participant, condition and level; none for the only number. Keys are
/// compared by their texts.
class FindingKey final {
 public:
  FindingKey() = default;
  FindingKey(std::string name) : text_(std::move(name)) {
    if (!text_.empty()) names_.push_back(text_);
  }
  FindingKey(std::string_view name) : FindingKey(std::string(name)) {}
  FindingKey(const char* name) : FindingKey(std::string(name)) {}
  /// The names of all parts.
  FindingKey(std::initializer_list<FindingKey> parts) {
    for (const FindingKey& part : parts) {
      for (const std::string& name : part.names_) add(name);
    }
  }

  bool empty() const noexcept { return names_.empty(); }
  std::size_t size() const noexcept { return names_.size(); }
  const std::vector<std::string>& names() const noexcept { return names_; }
  /// An empty name where there are fewer.
  const std::string& operator[](std::size_t place) const noexcept {
    static const std::string kNone{};
    return place < names_.size() ? names_[place] : kNone;
  }
  const std::string& last() const noexcept { return (*this)[names_.size() - 1]; }
  FindingKey without_first() const {
    FindingKey key{};
    for (std::size_t i = 1; i < names_.size(); ++i) key.add(names_[i]);
    return key;
  }
  FindingKey without_last() const {
    FindingKey key{};
    for (std::size_t i = 0; i + 1 < names_.size(); ++i) key.add(names_[i]);
    return key;
  }
  /// "P01|wood", as files have it.
  const std::string& text() const noexcept { return text_; }

  bool operator==(const FindingKey& other) const noexcept { return text_ == other.text_; }
  auto operator<=>(const FindingKey& other) const noexcept { return text_ <=> other.text_; }

 private:
  void add(const std::string& name) {
    text_ += (names_.empty() ? "" : "|") + name;
    names_.push_back(name);
  }

  std::string text_{};
  std::vector<std::string> names_{};
};

inline std::ostream& operator<<(std::ostream& out, const FindingKey& key) {
  return out << key.text();
}

/// One number with everything that a reader needs to use it: a row of a table of results.
///
/// `quantity` says what was computed ("proportion"), `key` for whom or what ("model=sinusoid").
/// An analysis that cannot answer says so in `status`, in a sentence for the person who must act,
/// and leaves `value` empty; it does not leave out the row. Where the answer is no number, `word`
/// is it, fixed for programs: TRUE, FALSE, Inf, -Inf, NA (undefined for these data), ok, or why
/// there is none, like not_estimable.
struct Finding {
  std::string quantity{};
  FindingKey key{};
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
