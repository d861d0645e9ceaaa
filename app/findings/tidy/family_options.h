// What an analysis of a table is told beside the table.

#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace asperity {

/// A JSON value without its syntax; an object keeps its order.
struct OptionValue {
  using List = std::vector<OptionValue>;
  using Object = std::vector<std::pair<std::string, OptionValue>>;
  std::variant<std::monostate, bool, double, std::string, List, Object> value{};
};

/// Options by name, with the types that an analysis asks for. One value stands for a list of one;
/// null is the same as absent.
///
/// Errors: every function throws std::runtime_error naming the option: absent where there is no
/// default, of another type, or a list in which a name stands twice.
class FamilyOptions final {
 public:
  FamilyOptions() = default;
  /// An object, or `[]` for none.
  static FamilyOptions of_json(const std::string& text, const std::string& file_name);
  /// One more, as a value.
  void set(const std::string& name, double number);
  void set(const std::string& name, std::string text);
  void set(const std::string& name, const std::vector<std::string>& texts);
  /// An object of lists: factors with their levels, in order.
  void set(const std::string& name,
           const std::vector<std::pair<std::string, std::vector<std::string>>>& levels);
  /// One more from the command line. Its text is read as JSON where it is that; `a,b,c` is a list.
  void add(const std::string& name, const std::string& text);

  /// Of all that are given, in their order.
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

  /// `conf`, 0.95 where absent. Refuses what is no probability.
  double confidence() const;

  /// Those that no analysis has asked for: misspelt, or of another family.
  std::vector<std::string> never_asked_for() const;

 private:
  const OptionValue* find(const std::string& name) const;
  const OptionValue& at(const std::string& name) const;

  OptionValue::Object options_{};
  mutable std::set<std::string> asked_for_{};
};

}  // namespace asperity
