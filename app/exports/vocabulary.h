// What the rows, the protocols and the force models of one study say of its columns.

#pragma once

#include "app/exports/columns.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// A protocol that cannot be read and a model that this program does not know add nothing: their
/// columns are there, with what the rows tell of them.
StudyVocabulary vocabulary_of(const Study& study, const ModelRegistry& models);

}  // namespace asperity
