// Implements the reading of a texture of the Penn Haptic Texture Toolkit.

#include "renderers/vibrations/haptic_texture_toolkit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/autoregression.h"
#include "analysis/signals/line_spectrum.h"
#include "renderers/recordings/number_table.h"
#include "stimuli/measured/xml_element.h"

namespace asperity {
namespace {

constexpr std::size_t kReplacingOrder = 20;  // within 0.23 dB of the published textures
constexpr std::size_t kLines = 4096;         // of the spectrum, for poles up to a radius of 0.999
constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kGreatestFriction = 2.0;  // of a material of a protocol

const XmlElement& required_child(const XmlElement& parent, const char* child_name,
                                 const std::string& name) {
  const XmlElement* const found = only_child(parent, child_name, name);
  if (found == nullptr) {
    refuse_table_line(name, parent.line,
                      "the element " + parent.name + " has no " + child_name +
                          "; choose an XML file of the Penn Haptic Texture Toolkit");
  }
  return *found;
}

void require_text(const XmlElement& set, const char* child_name, const std::string& wanted,
                  const std::string& name) {
  const XmlElement& element = required_child(set, child_name, name);
  if (element.text == wanted) return;
  refuse_table_line(name, element.line,
                    std::string(child_name) + " is \"" + element.text + "\", and only \"" + wanted +
                        "\" is supported; use a file with this value");
}

/// The line spectral frequencies of an element, in increasing order within (0, π).
std::vector<double> lines_in(const XmlElement& element, const std::string& name) {
  std::vector<double> lines_rad{};
  for (const XmlElement& value : element.children) {
    lines_rad.push_back(number_in_element(value, name));
    const double before = lines_rad.size() > 1 ? lines_rad[lines_rad.size() - 2] : 0.0;
    if (!(lines_rad.back() > before) || !(lines_rad.back() < std::numbers::pi)) {
      refuse_table_line(name, value.line,
                        "the frequencies of " + element.name +
                            " must increase from above 0 to below pi; copy the file again");
    }
  }
  if (lines_rad.empty() || lines_rad.size() > kMostSpectralLines) {
    refuse_table_line(name, element.line,
                      element.name + " has " + std::to_string(lines_rad.size()) +
                          " frequencies, and 1 to " + std::to_string(kMostSpectralLines) +
                          " are supported; use another file");
  }
  return lines_rad;
}

/// |1 − Σ c_j·exp(−i·ω·j)|² at kLines angles, half of a turn.
std::vector<double> squared_gain(const std::vector<double>& lines_rad) {
  std::vector<double> coefficients(lines_rad.size());
  coefficients_of_lines(lines_rad, coefficients);
  std::vector<double> gains{};
  for (std::size_t k = 0; k < kLines; ++k) {
    const double angle_rad =
        std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(kLines);
    std::complex<double> sum = 1.0;
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
      sum -= coefficients[j] * std::polar(1.0, -angle_rad * static_cast<double>(j + 1));
    }
    gains.push_back(std::norm(sum));
  }
  return gains;
}

/// The greatest difference in third octaves from 20 to 400 Hz.
double difference_dB(const std::vector<double>& power, const std::vector<double>& other) {
  double largest_dB = 0.0;
  for (int third = -17; third <= -4; ++third) {
    double sum = 0.0;
    double sum_of_other = 0.0;
    for (std::size_t k = 0; k < kLines; ++k) {
      const double frequency_Hz =
          0.5 * kVibrationRate_Hz * (static_cast<double>(k) + 0.5) / static_cast<double>(kLines);
      const double third_of_line = 3.0 * std::log2(frequency_Hz / 1000.0);
      if (std::abs(third_of_line - third) > 0.5) continue;
      sum += power[k];
      sum_of_other += other[k];
    }
    largest_dB = std::max(largest_dB, std::abs(10.0 * std::log10(sum / sum_of_other)));
  }
  return largest_dB;
}

/// The process with the same first covariances.
Autoregression without_moving_average(const std::vector<double>& power) {
  std::vector<double> covariance(kReplacingOrder + 1, 0.0);
  for (std::size_t lag = 0; lag < covariance.size(); ++lag) {
    for (std::size_t k = 0; k < kLines; ++k) {
      covariance[lag] += power[k] / static_cast<double>(kLines) *
                         std::cos(std::numbers::pi * static_cast<double>(lag) *
                                  (static_cast<double>(k) + 0.5) / static_cast<double>(kLines));
    }
  }
  return autoregression_of_covariance(covariance);
}

void replace_moving_average(const std::vector<double>& moving_rad, VibrationModel& model,
                            ToolkitTexture& texture) {
  std::vector<double> power = squared_gain(moving_rad);
  const std::vector<double> inverse = squared_gain(model.lines_rad);
  for (std::size_t k = 0; k < kLines; ++k) power[k] /= inverse[k];
  const Autoregression replaced = without_moving_average(power);
  model.lines_rad = line_spectral_frequencies(replaced.coefficients);
  model.variance_m2_per_s4 *= replaced.innovation_variance;
  std::vector<double> power_of_replaced = squared_gain(model.lines_rad);
  for (double& each : power_of_replaced) each = replaced.innovation_variance / each;
  texture.largest_difference_dB =
      std::max(texture.largest_difference_dB, difference_dB(power_of_replaced, power));
}

}  // namespace

ToolkitTexture toolkit_texture_in(std::string_view xml, const std::string& name) {
  const XmlElement root = xml_root_in(xml, name);
  if (root.name != "modelSet") {
    refuse_table_line(name, root.line,
                      "the root element is " + root.name +
                          ", not modelSet; choose an XML file of the Penn Haptic Texture Toolkit");
  }
  require_text(root, "AccelUnits", "m/s^2", name);
  require_text(root, "SpeedUnits", "mm/s", name);
  require_text(root, "ForceUnits", "N", name);
  require_text(root, "SampleRate", "1000", name);
  ToolkitTexture texture{};
  if (const XmlElement* const friction = only_child(root, "mu", name)) {
    texture.friction = number_in_element(*friction, name);
    if (!(*texture.friction >= 0.0 && *texture.friction <= kGreatestFriction)) {
      refuse_table_line(
          name, friction->line,
          "mu is " + number_text(*texture.friction) + "; a coefficient of friction from 0 to " +
              number_text(kGreatestFriction) + " is supported. Correct it, or remove the element");
    }
  }
  for (const XmlElement& each : root.children) {
    if (each.name != "model") continue;
    const auto number = [&](const char* child_name) {
      return number_in_element(required_child(each, child_name, name), name);
    };
    VibrationModel model{.speed_m_per_s = kMetresPerMillimetre * number("speedMod"),
                         .normal_N = number("forceMod"),
                         .variance_m2_per_s4 = number("var"),
                         .lines_rad = lines_in(required_child(each, "ARlsf", name), name)};
    if (only_child(each, "gain", name) != nullptr)
      model.variance_m2_per_s4 *= std::pow(number("gain"), 2);
    const XmlElement* const moving = only_child(each, "MAlsf", name);
    if (moving != nullptr && !moving->children.empty()) {
      texture.has_moving_average = true;
      replace_moving_average(lines_in(*moving, name), model, texture);
    }
    if (model.variance_m2_per_s4 == 0.0) ++texture.silent;
    texture.set.models.push_back(std::move(model));
  }
  if (const XmlElement* const count = only_child(root, "numMod", name)) {
    const double stated = number_in_element(*count, name);
    if (stated != static_cast<double>(texture.set.models.size())) {
      refuse_table_line(name, count->line,
                        "numMod is " + number_text(stated) + ", and the file has " +
                            std::to_string(texture.set.models.size()) +
                            " models; copy the file again");
    }
  }
  require_models(texture.set, name);
  return texture;
}

}  // namespace asperity
