// Declares the parameters of force models and synthetic surfaces.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

enum class ParameterKind { number, integer, choice };

/// A number (also for integers, which must be whole) or the name of a choice.
using ParameterValue = std::variant<double, std::string>;

/// The values of one stimulus by parameter name, ordered so that hashes and files are stable.
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// Declares one parameter of a force model or a synthetic surface: its name, unit, range and meaning.
///
/// The declaration is the single source of this information for the validation of protocols, the command line, the
/// codebook of an export and the editor's form.
///
/// Units: `unit` is in SI notation ("N/m", "m", "1" for a dimensionless number), and the name ends in the same unit
/// (`stiffness_N_per_m`).
struct Parameter {
  std::string name{};
  ParameterKind kind = ParameterKind::number;
  std::string unit{};
  double minimum = 0.0;                ///< inclusive; not used for a choice
  double maximum = 0.0;                ///< inclusive; not used for a choice
  std::vector<std::string> choices{};  ///< of a choice; empty otherwise
  ParameterValue default_value{};
  Phrase meaning{};
};

Parameter number_parameter(std::string name, std::string unit, double minimum, double maximum,
                           double default_value, Phrase meaning);
Parameter integer_parameter(std::string name, double minimum, double maximum, double default_value,
                            Phrase meaning);
/// The default is the first choice.
Parameter choice_parameter(std::string name, std::vector<std::string> choices, Phrase meaning);

/// A conflict between values that are valid individually.
struct ParameterConflict {
  std::vector<std::string> parameters{};  ///< any of which could be changed, the most likely first
  Phrase message{};                       ///< the values and the correction
};

/// A file that a force model needs in addition to a height field and bodies, such as recorded vibrations.
///
/// The declaration is the only place where its role is listed: a protocol states the file of each texture under this
/// role, the session hashes and stores it under this role, and the model finds its content under it in RendererInputs.
struct AssetDeclaration {
  std::string
      role{};  ///< `[a-z][a-z0-9_]*`; not that of a height field or a body (stimulus_description.h)
  Phrase meaning{};  ///< what the file contains
};

/// A force model as everybody but the servo knows it.
struct ModelDeclaration {
  std::string id{};       ///< `[a-z][a-z0-9_]*`, used in protocols and on the command line
  std::string version{};  ///< changes whenever the same inputs would give another force
  Phrase summary{};
  std::string source{};  ///< the publication of the law
  bool needs_height_field = false;
  bool needs_bodies = false;  ///< a tool and a surface, meshes with haptic textures
  /// Whether the rendered texture depends on how hard the hand presses. Only models with bodies take the width of the tip
  /// into account.
  bool feels_applied_force = true;
  /// The one parameter that scales only the texture, for which force matching may solve; absent if there is none.
  std::optional<std::string> amplitude_parameter{};
  /// Largest difference, in newtons per axis, between a live force and its replay with another instruction set or maths
  /// library. On the same machine a replay is exact.
  double replay_tolerance_N = 1e-9;
  /// The highest rate of the servo loop at which a tick takes less than a period; absent if no rate is known to be too high.
  std::optional<double> maximum_rate_Hz{};
  std::vector<Parameter> parameters{};
  std::vector<AssetDeclaration> assets{};  ///< all of them are needed
  /// What is wrong with complete values, each of them acceptable, together; empty for a model whose
  /// values never contradict each other.
  std::function<std::optional<ParameterConflict>(const ParameterValues&)> conflict_among{};
};

/// The problem with one value, for use within a sentence; nullopt if the value is valid.
std::optional<Phrase> problem_of_value(const Parameter& parameter, const ParameterValue& value);
/// The same as a sentence, with a full stop.
std::optional<Phrase> complaint_about(const Parameter& parameter, const ParameterValue& value);

/// Completes the given values with the declared defaults.
///
/// Errors: std::invalid_argument, naming the model, the parameter and the correction, for a parameter that is not
/// declared, of the wrong kind or out of range.
ParameterValues complete_values(const ModelDeclaration& declaration, const ParameterValues& given);

/// The same for other owners of parameters; `of` is the owner's name in messages.
ParameterValues complete_values(std::string_view of, const std::vector<Parameter>& parameters,
                                const ParameterValues& given);

/// Read a value that `complete_values` has checked. Throw std::invalid_argument, naming the value, if there is none of
/// this name and kind.
double number_of(const ParameterValues& values, std::string_view name);
const std::string& choice_of(const ParameterValues& values, std::string_view name);

}  // namespace asperity
