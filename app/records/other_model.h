// Gives recorded surfaces to another force model than the one that rendered them.

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>

#include "app/records/recorded_attempt.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// A recording of two bodies contains nothing for a model that feels a height field with a point, nor the other way round.
bool feel_alike(const ForceModel& one, const ForceModel& other) noexcept;

/// A force model, with what was stated for it.
struct OtherModelSettings {
  const ForceModel* model = nullptr;  ///< must outlive its uses
  ParameterValues parameters{};
  /// Files in place of those of the texture, as in RendererInputs.
  std::map<std::string, std::shared_ptr<const std::string>, std::less<>> assets{};
  std::map<std::string, std::string, std::less<>> asset_names{};
};

/// The inputs with which another model renders recorded surfaces. What a texture suggests is computed once.
///
/// Threads: any.
class OtherModel final {
 public:
  explicit OtherModel(OtherModelSettings settings) : settings_(std::move(settings)) {}

  const ForceModel& model() const noexcept { return *settings_.model; }

  /// For the surface at `position`, from 1. The parameters that are not stated are the recorded ones if the surface was
  /// rendered with a model of this id; otherwise those that the texture suggests, and the defaults. The files that are
  /// not stated are those of the texture.
  ///
  /// Errors: ResultsError for a file that cannot be read.
  RendererInputs inputs_for(const RecordedAttempt& recorded, int position,
                            StimulusBuilder& builder);

 private:
  ParameterValues suggested_by(const RendererInputs& inputs);

  OtherModelSettings settings_{};
  std::mutex mutex_{};
  /// By the texture and the material under it.
  std::map<std::tuple<std::shared_ptr<const HeightField>, double, double>, ParameterValues>
      suggestions_{};
};

}  // namespace asperity
