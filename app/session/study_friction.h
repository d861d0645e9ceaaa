// Declares which friction a study has where its protocols state none.

#pragma once

#include <filesystem>
#include <optional>

#include "renderers/force/force_model.h"
#include "results_schema/rows.h"

namespace asperity {

/// The first session of the study with a point model, if a version without the laws of friction recorded it: the study
/// then has the law `rounded` wherever a protocol states none, in resumed and in new sessions. nullopt: the study has
/// the law of new studies (friction_of_new_studies).
///
/// Every presentation is stored with the complete parameters of its model. One of a model that declares `friction_law`
/// without this parameter is therefore of such a version. A study without sessions, and one that cannot be read, has none.
std::optional<SessionRow> session_with_earlier_friction(const std::filesystem::path& study,
                                                        const ModelRegistry& models);

/// Which law a model has where a protocol states none: the declared default, or that of new studies.
enum class UnstatedFriction { declared, of_new_studies };

/// That of the study. Without one: that of a new study.
UnstatedFriction unstated_friction_of(const std::optional<std::filesystem::path>& study,
                                      const ModelRegistry& models);

/// The values of a model's parameters that state this law; none where it is the declared default.
ParameterValues values_of(UnstatedFriction friction, const ForceModel& model);

}  // namespace asperity
