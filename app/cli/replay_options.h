// What `asperity replay` was asked for.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/records/other_model.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

struct ReplayOptions {
  std::string study{};
  std::optional<std::string> attempt{};
  int surface = 1;
  bool compare = false;  ///< a whole study, in place of one attempt
  std::optional<std::string> model{};
  std::vector<std::string> parameters{};
  std::vector<std::string> assets{};
  std::filesystem::path out{};
  std::filesystem::path plot{};
  int jobs = 0;  ///< 0: one for each processor
  bool json = false;
  bool force = false;
  std::vector<std::filesystem::path> plugins{};

  Overwrite overwrite() const noexcept { return force ? Overwrite::allow : Overwrite::refuse; }
};

/// The model of --model with its parameters and files; it lives as long as the registry. Nothing without --model.
///
/// Errors: WrongUsage for --param and --asset without --model; as model_named, parameters_from and add_asset.
std::optional<OtherModelSettings> other_model(const ReplayOptions& options,
                                              const ModelRegistry& models);

/// `asperity replay --compare`.
int run_replay_comparison(const ReplayOptions& options);

}  // namespace asperity
