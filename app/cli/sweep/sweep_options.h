// The options of asperity sweep, and the order that they amount to.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/sweep.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The options as given on the command line, with their defaults.
struct SweepOptions {
  std::string model{};
  std::vector<std::string> parameters{};
  std::vector<std::string> assets{};
  SweepOrder order{};
  std::string values{};
  std::string spacings = "0.0005:0.008:40";
  std::string texture = "sinusoid,amplitude_m=0.0002";
  std::optional<std::string> tool{};
  std::optional<double> probe_diameter_m{};
  std::optional<double> applied_force_N{};
  std::optional<double> exploratory_speed_m_per_s{};
  std::optional<double> turning_rad{};
  std::optional<double> turning_radius_m{};
  std::optional<std::string> stimulus{};
  std::vector<std::filesystem::path> plugins{};
  std::optional<DragMode> drag{};
  std::optional<double> stiffness_N_per_m{};
  std::string hand = hand_presets().front().name;
  int jobs = 0;
  std::string out{};
  SweepMeasure measure = SweepMeasure::max_accel;
  std::string plot{};
  std::string beside{};
  std::optional<std::string> protocol{};
  bool force = false;
  std::optional<Shard> shard{};
};

/// Completes `options.order` from the texts of the options. The order refers to a model of `models`.
///
/// Errors: WrongUsage naming the option and the correct form; std::runtime_error for a file that does not exist; as
/// load_height_field and load_textured_mesh.
void complete_order(SweepOptions& options, const ModelRegistry& models);

}  // namespace asperity
