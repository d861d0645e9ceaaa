// Declares the shapes of the values in a protocol, as values: what a file may contain at a key.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

struct ValueShape;
struct KeyTable;

inline constexpr std::size_t kMaximumNameLength = 64;

/// A unit for display: one `unit` is `factor` · 10^`power` of the unit in the file. Without a factor a number is converted
/// as a decimal: 2.3 mm is 0.0023 m exactly.
struct DisplayUnit {
  std::string_view unit{};
  int power = 0;
  double factor = 1.0;  ///< of degrees: π / 180
};

/// A finite number. Limits that are absent do not apply.
struct NumberShape {
  std::optional<double> minimum{};
  std::optional<double> above{};  ///< the number is greater than this
  std::optional<double> maximum{};
  std::optional<double> below{};  ///< the number is less than this
  bool is_whole = false;
  std::string_view
      unit{};  ///< SI, as the name of the key ends with: "N s/m" of damping_N_s_per_m; empty: none
  DisplayUnit display{};  ///< without a unit: the number is displayed in `unit`
};

/// Whether the number is within the limits.
bool lies_within(const NumberShape& shape, double number);

/// The number in the unit of the file, of one in the unit for display, and the reverse, as texts. Where the unit has a
/// factor, a displayed number has at most 12 digits. nullopt if the text is not a number of JSON.
std::optional<std::string> number_in_file(const NumberShape& shape, std::string_view displayed);
std::optional<std::string> displayed_number(const NumberShape& shape, std::string_view in_file);

/// true or false.
struct TruthShape {};

/// One of the words of a list.
struct KeyWord {
  std::string_view name{};
  int value = 0;  ///< the enumerator, or the truth value, that the word stands for
  std::string_view meaning{};
};
struct WordShape {
  std::span<const KeyWord> words{};
};

/// Whether a translation of the protocol replaces a text.
enum class Translated {
  never,
  if_present,  ///< it describes the protocol; without a translation it stays in the protocol's language
  always       ///< participants read it
};

// The registries of names: every map at the top of a protocol, by its key ("factors", "blocks"), and these.
inline constexpr std::string_view kFactorNames = "factors";
inline constexpr std::string_view kModelNames = "force models";  ///< of the program
inline constexpr std::string_view kRoleNames = "roles";          ///< of surfaces: of the program
inline constexpr std::string_view kAnswerNames = "answers";      ///< the questions of trials
inline constexpr std::string_view kItemNames = "items";          ///< surfaces in the responses
inline constexpr std::string_view kTestNames = "tests";          ///< of the kinds: of the program
/// The levels of a factor: of the one by whose name the value is stored (levels by factor), or else of the one that a key
/// with `governs_levels` states.
inline constexpr std::string_view kLevelNames = "levels";
/// The groups of participants: the levels of the factor that has them as its `levels`.
inline constexpr std::string_view kGroupNames = "groups of participants";
// Parts of registries, to which a reference can be limited.
inline constexpr std::string_view kChosenItems = "items of main blocks";
inline constexpr std::string_view kRatedScales = "scales of main blocks";

/// A name, and what it refers to. Entries of one registry with the same name are one thing.
struct NameShape {
  std::string_view registry{};  ///< empty: nothing refers to the name
  bool is_declared = false;     ///< what has the name is declared here; otherwise elsewhere
  /// Of a factor: levels in this object, and those next to it, are its levels.
  bool governs_levels = false;
  std::string_view levels{};  ///< of a factor: the registry in which its levels are names
  std::string_view
      among{};  ///< of a reference: the part of the registry that it is limited to; empty: all
};

/// A text for people, or in a form that a pattern states.
struct TextShape {
  bool may_be_empty = false;
  std::size_t longest = 200;  ///< in characters
  std::string_view
      pattern{};         ///< a regular expression (ECMAScript); only with at most 256 characters
  bool is_long = false;  ///< a form shows several lines
  Translated translated = Translated::never;
  /// The text is stored as well: a translation makes it {"value": the text, "text": the translation}.
  bool is_value = false;
  /// With a registry: the text is a name that can have any characters.
  NameShape name{};
  bool is_formula = false;  ///< it contains such names instead (arithmetic.h)
  bool is_file = false;     ///< the path of a file, relative to the study
};

struct ListShape {
  const ValueShape* entry = nullptr;
  std::string_view meaning{};  ///< of an entry
  std::size_t shortest = 0;
  std::optional<std::size_t> longest{};
  bool is_distinct = false;  ///< no entry occurs twice
};

/// An object whose keys are chosen by the author.
struct MapShape {
  const ValueShape* entry = nullptr;
  std::string_view meaning{};  ///< of an entry
  bool has_names = true;       ///< its keys are names; otherwise any texts
  NameShape key{};             ///< what its keys refer to; at the top of a protocol they declare
  std::size_t longest_name = kMaximumNameLength;
  std::size_t shortest = 0;
  std::optional<std::size_t> longest{};
};

/// An object with declared keys.
struct ObjectShape {
  const KeyTable* table = nullptr;
};

/// A value, or {"factor": NAME}: the level of that factor in the trial.
struct BoundShape {
  const ValueShape* value = nullptr;
};

/// One of several shapes, which the JSON type of the value decides: no two of them have a type in common. A choice that
/// a key decides is a property of a table (`KeyTable::deciding`).
struct FormsShape {
  std::span<const ValueShape> forms{};
};

/// A closed set: whoever examines shapes (form, schema, page, editor) visits all of them, and a new shape does not compile
/// until each of these has a part for it. A variant of plain structs, because tables of them are constants: a table needs
/// no code to be built, no order of initialization and no ownership.
struct ValueShape : std::variant<NumberShape, TruthShape, WordShape, TextShape, NameShape,
                                 ListShape, MapShape, ObjectShape, BoundShape, FormsShape> {
  using variant::variant;
};

/// The types of the values of a shape, as the schema names them: "integer", "string".
std::vector<std::string> types_of(const ValueShape& shape);

/// A name: lower-case letters, digits and underscores, starting with a letter, at most 64 characters.
inline constexpr std::string_view kNamePattern = "^[a-z][a-z0-9_]*$";
inline constexpr std::string_view kNameMeaning =
    "A name: lower-case letters, digits and underscores, starting with a letter.";
bool is_name(std::string_view text);

}  // namespace asperity
