// Options of an analysis of a table.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace asperity {

/// A JSON value, independent of its syntax; members of an object keep their order.
struct OptionValue {
  using List = std::vector<OptionValue>;
  using Object = std::vector<std::pair<std::string, OptionValue>>;
  std::variant<std::monostate, bool, double, std::string, List, Object> value{};
};

/// Options by name, with the types that an analysis requests. A single value is accepted as a list
/// of one; null is the same as absent.
///
/// Errors: every function throws std::runtime_error naming the option: absent where there is no
/// default, of another type, or a list that contains a name twice.
class FamilyOptions final {
 public:
  FamilyOptions() = default;
  /// An object, or `[]` for none.
  static FamilyOptions of_json(const std::string& text, const std::string& file_name);
  /// Adds one option, as a value.
  void set(const std::string& name, double number);
  void set(const std::string& name, std::string text);
  void set(const std::string& name, const std::vector<std::string>& texts);
  /// An object of lists: factors with their levels, in order.
  void set(const std::string& name,
           const std::vector<std::pair<std::string, std::vector<std::string>>>& levels);
  /// Adds one option from the command line. Its text is read as JSON where it is valid JSON;
  /// `a,b,c` is a list. It takes the place of an option of `of_json`; refuses an option that was added before with
  /// another text.
  void add(const std::string& name, const std::string& text);

  /// All given options, in their order.
  std::vector<std::string> names() const;
  bool has(const std::string& name) const;

  double number(const std::string& name) const;
  double number_or(const std::string& name, double otherwise) const;
  std::optional<double> number_if(const std::string& name) const;
  std::string text(const std::string& name) const;
  std::string text_or(const std::string& name, const std::string& otherwise) const;
  std::vector<std::string> texts(const std::string& name) const;
  std::vector<double> numbers(const std::string& name) const;
  /// An object of lists: factors with their levels, in order. Empty where absent.
  std::vector<std::pair<std::string, std::vector<std::string>>> levels(
      const std::string& name) const;

  bool truth_or(const std::string& name, bool otherwise) const;
  /// An object of objects: the options of several items by their names, in order.
  std::vector<std::pair<std::string, FamilyOptions>> objects(const std::string& name) const;

  /// `conf`, 0.95 where absent. Rejects a value that is not a probability.
  double confidence() const;

  /// Options that no analysis has requested: misspelt, or of another family.
  std::vector<std::string> never_asked_for() const;

 private:
  const OptionValue* find(const std::string& name) const;
  const OptionValue& at(const std::string& name) const;

  OptionValue::Object options_{};
  std::map<std::string, std::string> added_{};  // texts of `add` by name
  mutable std::set<std::string> asked_for_{};
};

}  // namespace asperity
