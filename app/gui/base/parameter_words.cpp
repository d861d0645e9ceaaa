// Names parameters, their choices and computed surfaces in the language of the windows.

#include "app/gui/base/parameter_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include <QtCore/QCoreApplication>

#include "analysis/words/phrase.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

using Words = std::map<std::string_view, Phrase>;

struct ParameterWords {
  Q_DECLARE_TR_FUNCTIONS(ParameterWords)
};

/// By the name without its unit and without the number of one of several.
const Words& names_of_parameters() {
  static const Words kWords{
      {"amplitude", phrase("NamesOfParameters", "Amplitude")},
      {"angle_rad", phrase("NamesOfParameters", "Angle (rad)")},
      {"axis", phrase("NamesOfParameters", "Axis")},
      {"axis_of_spectrum", phrase("NamesOfParameters", "Axis of spectrum")},
      {"base_diameter", phrase("NamesOfParameters", "Base diameter")},
      {"bits", phrase("NamesOfParameters", "Bits")},
      {"brick_length", phrase("NamesOfParameters", "Brick length")},
      {"cell", phrase("NamesOfParameters", "Cell")},
      {"coefficient", phrase("NamesOfParameters", "Coefficient")},
      {"contact_damping", phrase("NamesOfParameters", "Contact damping")},
      {"cosine_amplitude", phrase("NamesOfParameters", "Cosine amplitude")},
      {"coupling", phrase("NamesOfParameters", "Coupling")},
      {"coupling_angular_damping", phrase("NamesOfParameters", "Coupling angular damping")},
      {"coupling_angular_stiffness", phrase("NamesOfParameters", "Coupling angular stiffness")},
      {"coupling_damping", phrase("NamesOfParameters", "Coupling damping")},
      {"coupling_stiffness", phrase("NamesOfParameters", "Coupling stiffness")},
      {"course_height", phrase("NamesOfParameters", "Course height")},
      {"depth_limit", phrase("NamesOfParameters", "Depth limit")},
      {"depth_scale", phrase("NamesOfParameters", "Depth scale")},
      {"device_step", phrase("NamesOfParameters", "Device step")},
      {"direction", phrase("NamesOfParameters", "Direction")},
      {"effective_mass", phrase("NamesOfParameters", "Effective mass")},
      {"exponent", phrase("NamesOfParameters", "Exponent")},
      {"face", phrase("NamesOfParameters", "Face")},
      {"face_rms", phrase("NamesOfParameters", "Face RMS")},
      {"flank_width", phrase("NamesOfParameters", "Flank width")},
      {"force_direction", phrase("NamesOfParameters", "Force direction")},
      {"force_exponent", phrase("NamesOfParameters", "Force exponent")},
      {"foundation", phrase("NamesOfParameters", "Foundation")},
      {"friction_damping", phrase("NamesOfParameters", "Friction damping")},
      {"friction_delay", phrase("NamesOfParameters", "Friction delay")},
      {"friction_law", phrase("NamesOfParameters", "Friction law")},
      {"friction_mass", phrase("NamesOfParameters", "Friction mass")},
      {"friction_sd", phrase("NamesOfParameters", "Friction SD")},
      {"friction_smoothing", phrase("NamesOfParameters", "Friction smoothing")},
      {"friction_speed", phrase("NamesOfParameters", "Friction threshold")},
      {"friction_static_ratio", phrase("NamesOfParameters", "Static friction ratio")},
      {"friction_stiffness", phrase("NamesOfParameters", "Friction stiffness")},
      {"gain", phrase("NamesOfParameters", "Gain")},
      {"gamma_high", phrase("NamesOfParameters", "Detail gain")},
      {"gamma_low", phrase("NamesOfParameters", "Lighting gain")},
      {"gaussian_wavelength", phrase("NamesOfParameters", "Longest wavelength kept")},
      {"grain_height", phrase("NamesOfParameters", "Grain height")},
      {"grain_spacing", phrase("NamesOfParameters", "Grain spacing")},
      {"height", phrase("NamesOfParameters", "Height")},
      {"height_scale", phrase("NamesOfParameters", "Height scale")},
      {"histogram", phrase("NamesOfParameters", "Brightness")},
      {"homomorphic_wavelength", phrase("NamesOfParameters", "Shortest lighting wavelength")},
      {"index", phrase("NamesOfParameters", "Index")},
      {"jitter", phrase("NamesOfParameters", "Jitter")},
      {"joint_depth", phrase("NamesOfParameters", "Joint depth")},
      {"joint_width", phrase("NamesOfParameters", "Joint width")},
      {"k1", phrase("NamesOfParameters", "Plate stiffness k1")},
      {"lateral_gradient_gain", phrase("NamesOfParameters", "Lateral gradient gain")},
      {"law", phrase("NamesOfParameters", "Law")},
      {"light_azimuth", phrase("NamesOfParameters", "Light azimuth")},
      {"light_elevation", phrase("NamesOfParameters", "Light elevation")},
      {"longest_wavelength", phrase("NamesOfParameters", "Longest wavelength")},
      {"maximum", phrase("NamesOfParameters", "Maximum")},
      {"method", phrase("NamesOfParameters", "Method")},
      {"most_halvings", phrase("NamesOfParameters", "Most halvings")},
      {"most_samples", phrase("NamesOfParameters", "Most samples")},
      {"noise_length", phrase("NamesOfParameters", "Noise length")},
      {"noise_mean", phrase("NamesOfParameters", "Noise, mean")},
      {"noise_rate", phrase("NamesOfParameters", "Noise rate")},
      {"noise_sd", phrase("NamesOfParameters", "Noise, standard deviation")},
      {"octaves", phrase("NamesOfParameters", "Octaves")},
      {"offset", phrase("NamesOfParameters", "Offset")},
      {"peak_wavelength", phrase("NamesOfParameters", "Peak wavelength")},
      {"period_x", phrase("NamesOfParameters", "Period x")},
      {"period_y", phrase("NamesOfParameters", "Period y")},
      {"pit_depth", phrase("NamesOfParameters", "Pit depth")},
      {"pixels", phrase("NamesOfParameters", "Pixels")},
      {"poisson_ratio", phrase("NamesOfParameters", "Poisson ratio")},
      {"pole_radius", phrase("NamesOfParameters", "Pole radius")},
      {"pore_rms", phrase("NamesOfParameters", "Pore RMS")},
      {"reference_force", phrase("NamesOfParameters", "Reference force")},
      {"relaxation_ratio", phrase("NamesOfParameters", "Relaxation ratio")},
      {"relaxation_time", phrase("NamesOfParameters", "Relaxation time")},
      {"relief", phrase("NamesOfParameters", "Relief")},
      {"resonance_ratio", phrase("NamesOfParameters", "Resonance ratio")},
      {"resonance_threshold", phrase("NamesOfParameters", "Resonance threshold")},
      {"ridge_width", phrase("NamesOfParameters", "Ridge width")},
      {"ring_height", phrase("NamesOfParameters", "Ring height")},
      {"rms", phrase("NamesOfParameters", "Roughness RMS")},
      {"scratch_length", phrase("NamesOfParameters", "Scratch length")},
      {"seed", phrase("NamesOfParameters", "Seed")},
      {"shortest_wavelength", phrase("NamesOfParameters", "Shortest wavelength")},
      {"sine_amplitude", phrase("NamesOfParameters", "Sine amplitude")},
      {"single_speed", phrase("NamesOfParameters", "Single speed")},
      {"spacing", phrase("NamesOfParameters", "Spacing")},
      {"spectral_tilt", phrase("NamesOfParameters", "Spectral tilt")},
      {"step", phrase("NamesOfParameters", "Step")},
      {"tau", phrase("NamesOfParameters", "Tau")},
      {"texture_gain", phrase("NamesOfParameters", "Texture gain")},
      {"tip", phrase("NamesOfParameters", "Tip")},
      {"tip_radius", phrase("NamesOfParameters", "Tip radius")},
      {"tool_inertia", phrase("NamesOfParameters", "Tool inertia")},
      {"tool_mass", phrase("NamesOfParameters", "Tool mass")},
      {"tool_texture_gain", phrase("NamesOfParameters", "Tool texture gain")},
      {"tool_turns", phrase("NamesOfParameters", "Tool turns")},
      {"top_diameter", phrase("NamesOfParameters", "Top diameter")},
      {"variance", phrase("NamesOfParameters", "Variance")},
      {"velocity_threshold", phrase("NamesOfParameters", "Noise threshold")},
      {"wavelength", phrase("NamesOfParameters", "Wavelength")},
      {"waves_x", phrase("NamesOfParameters", "Waves x")},
      {"waves_y", phrase("NamesOfParameters", "Waves y")},
      {"waviness", phrase("NamesOfParameters", "Waviness")},
      {"width", phrase("NamesOfParameters", "Picture width")},
      {"youngs_modulus", phrase("NamesOfParameters", "Young's modulus")},
  };
  return kWords;
}

/// By the word in files.
const Words& names_of_choices() {
  static const Words kWords{
      {"accepted", phrase("NamesOfChoices", "Accepted")},
      {"ball", phrase("NamesOfChoices", "Ball")},
      {"binormal", phrase("NamesOfChoices", "Binormal")},
      {"bounded", phrase("NamesOfChoices", "Bounded")},
      {"constant", phrase("NamesOfChoices", "Constant")},
      {"corrected", phrase("NamesOfChoices", "Corrected")},
      {"crest", phrase("NamesOfChoices", "Crest")},
      {"dahl", phrase("NamesOfChoices", "Dahl")},
      {"device", phrase("NamesOfChoices", "Device")},
      {"distance", phrase("NamesOfChoices", "Distance")},
      {"elastoplastic", phrase("NamesOfChoices", "Elastoplastic")},
      {"fixed", phrase("NamesOfChoices", "Fixed")},
      {"flat", phrase("NamesOfChoices", "Flat")},
      {"force", phrase("NamesOfChoices", "Force")},
      {"gradient", phrase("NamesOfChoices", "Gradient")},
      {"grey_level", phrase("NamesOfChoices", "Grey level")},
      {"hard", phrase("NamesOfChoices", "Hard")},
      {"linear", phrase("NamesOfChoices", "Linear")},
      {"literal", phrase("NamesOfChoices", "Literal")},
      {"local_normal", phrase("NamesOfChoices", "Local normal")},
      {"logarithmic", phrase("NamesOfChoices", "Logarithmic")},
      {"lugre", phrase("NamesOfChoices", "LuGre")},
      {"mean", phrase("NamesOfChoices", "Mean")},
      {"motion", phrase("NamesOfChoices", "Motion")},
      {"none", phrase("NamesOfChoices", "None")},
      {"normal", phrase("NamesOfChoices", "Normal")},
      {"physical", phrase("NamesOfChoices", "Physical")},
      {"proxy", phrase("NamesOfChoices", "Proxy")},
      {"refused", phrase("NamesOfChoices", "Refused")},
      {"rounded", phrase("NamesOfChoices", "Rounded")},
      {"smooth", phrase("NamesOfChoices", "Smooth")},
      {"spatial", phrase("NamesOfChoices", "Spatial")},
      {"subtract_min", phrase("NamesOfChoices", "Minimum subtracted")},
      {"temporal", phrase("NamesOfChoices", "Temporal")},
      {"time", phrase("NamesOfChoices", "Time")},
      {"virtual", phrase("NamesOfChoices", "Virtual")},
  };
  return kWords;
}

/// By the kind.
const Words& names_of_surfaces() {
  static const Words kWords{
      {"brick", phrase("NamesOfSurfaces", "Brick")},
      {"cones", phrase("NamesOfSurfaces", "Cones")},
      {"grating", phrase("NamesOfSurfaces", "Grating")},
      {"metal", phrase("NamesOfSurfaces", "Metal")},
      {"noise", phrase("NamesOfSurfaces", "Noise")},
      {"sandpaper", phrase("NamesOfSurfaces", "Sandpaper")},
      {"sinusoid", phrase("NamesOfSurfaces", "Sinusoid")},
      {"stone", phrase("NamesOfSurfaces", "Stone")},
      {"wood", phrase("NamesOfSurfaces", "Wood")},
  };
  return kWords;
}

/// Of names that the program does not know: those of plug-ins.
QString derived_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z')
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return text(name);
}

QString found_in(const Words& words, const std::string& name) {
  const auto found = words.find(name);
  return found == words.end() ? derived_words(name) : words_of(found->second);
}

std::string without_unit(const Parameter& parameter) {
  std::string name = parameter.name;
  std::string unit = parameter.unit == "1" ? std::string() : parameter.unit;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kInNames{
      {{"/", "_per_"}, {" ", "_"}, {"²", "2"}, {"³", "3"}, {"°", "deg"}}};
  for (const auto& [sign, in_name] : kInNames) {
    for (std::size_t at = unit.find(sign); at != std::string::npos; at = unit.find(sign)) {
      unit.replace(at, sign.size(), in_name);
    }
  }
  const std::string suffix = '_' + unit;
  if (!unit.empty() && name.size() > suffix.size() && name.ends_with(suffix)) {
    name.resize(name.size() - suffix.size());
  }
  return name;
}

}  // namespace

QString caption_of(const Parameter& parameter) {
  std::string name = without_unit(parameter);
  const std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size() || name[end] != '_') {
    return found_in(names_of_parameters(), name);
  }
  const QString number = text(name.substr(end + 1));
  name.resize(end);
  return found_in(names_of_parameters(), name) + ' ' + number;
}

QString choice_name(const Parameter& parameter, const std::string& choice) {
  if (parameter.name == "method") {
    const std::map<std::string, QString, std::less<>> methods{
        {"wu", ParameterWords::tr("Wu et al. (2009)")},
        {"brightness", ParameterWords::tr("Brightness")},
        {"pentland", ParameterWords::tr("Pentland (1990)")},
        {"tsai_shah", ParameterWords::tr("Tsai and Shah (1994)")},
    };
    const auto found = methods.find(choice);
    return found == methods.end() ? derived_words(choice) : found->second;
  }
  if (parameter.name == "histogram") {
    return choice == "none" ? ParameterWords::tr("Original") : ParameterWords::tr("Equalized");
  }
  return found_in(names_of_choices(), choice);
}

QString choice_with_word(const Parameter& parameter, const std::string& choice) {
  const QString name = choice_name(parameter, choice);
  const auto known = names_of_choices().find(choice);
  const bool is_translated = known != names_of_choices().end() && words_of(known->second) == name &&
                             name != derived_words(choice);
  return is_translated ? ParameterWords::tr("%1 (%2)").arg(name, text(choice)) : name;
}

QString surface_name(const std::string& kind) { return found_in(names_of_surfaces(), kind); }

}  // namespace asperity
