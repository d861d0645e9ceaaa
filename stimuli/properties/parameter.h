// What a force model or a synthetic surface can be told, declared once.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

enum class ParameterKind { number, integer, choice };

/// A number (also for integers, which must be whole) or the name of a choice.
using ParameterValue = std::variant<double, std::string>;

/// The values of one stimulus, by parameter name. Ordered, so that what is hashed or written is
/// stable.
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// One parameter of a force model or a synthetic surface: what it is called, in what unit, what it
/// may be and what it means.
///
/// The declaration is the only place where this is said. Validation of protocols, the command line,
/// the codebook of an export and the editor's form are all driven by it.
///
/// Units: `unit` is spelt as SI writes it ("N/m", "m", "1" for a dimensionless number), and the
/// name ends in the same unit (`stiffness_N_per_m`).
struct Parameter {
  std::string name{};
  ParameterKind kind = ParameterKind::number;
  std::string unit{};
  double minimum = 0.0;                ///< inclusive; meaningless for a choice
  double maximum = 0.0;                ///< inclusive; meaningless for a choice
  std::vector<std::string> choices{};  ///< of a choice; empty otherwise
  ParameterValue default_value{};
  std::string meaning{};
};

/// Values that are acceptable one by one, and not together.
struct ParameterConflict {
  std::vector<std::string> parameters{};  ///< any of which could be changed, the likeliest first
  std::string message{};                  ///< the values, and what would be right
};

/// A force model as everybody but the servo knows it.
struct ModelDeclaration {
  std::string id{};       ///< `[a-z][a-z0-9_]*`, used in protocols and on the command line
  std::string version{};  ///< changes whenever the same inputs would give another force
  std::string summary{};
  std::string source{};  ///< the publication the law comes from
  bool needs_height_field = false;
  bool needs_bodies = false;  ///< a tool and a surface, meshes with haptic textures
  /// Whether its texture is felt differently by a hand that presses harder. How wide the tip is, only a
  /// model of bodies can know.
  bool feels_applied_force = true;
  /// The one parameter that scales the texture alone and that matching of forces may solve for;
  /// absent where there is none.
  std::optional<std::string> amplitude_parameter{};
  /// Largest difference, in newtons per axis, between a live force and its replay on another
  /// instruction set or maths library. On the same machine a replay is exact.
  double replay_tolerance_N = 1e-9;
  std::vector<Parameter> parameters{};
  /// What is wrong with complete values, each of them acceptable, together; empty for a model whose
  /// values never contradict each other.
  std::function<std::optional<ParameterConflict>(const ParameterValues&)> conflict_among{};
};

/// What is wrong with one value, as a sentence; nothing when it is acceptable.
std::optional<std::string> complaint_about(const Parameter& parameter, const ParameterValue& value);

/// The values given, completed by the declared defaults.
///
/// Errors: std::invalid_argument naming the model, the parameter and what would be right, for a
/// parameter that is not declared, of the wrong kind or out of range.
ParameterValues complete_values(const ModelDeclaration& declaration, const ParameterValues& given);

/// The same for anything else that declares parameters; `of` is its name in messages.
ParameterValues complete_values(std::string_view of, const std::vector<Parameter>& parameters,
                                const ParameterValues& given);

/// Read a value that `complete_values` has checked. Throw std::invalid_argument, naming it, where
/// there is none of that name and kind.
double number_of(const ParameterValues& values, std::string_view name);
const std::string& choice_of(const ParameterValues& values, std::string_view name);

}  // namespace asperity
