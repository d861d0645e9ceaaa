// Computes what a virtual hand feels of a surface outside a session.

#pragma once

#include "analysis/numbers/random.h"
#include "analysis/signals/force_features.h"
#include "device/virtual_hand.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The force features of a surface that a virtual hand with these habits strokes on the simulated device for 4 s of
/// contact, at the servo rate and with the force limit of the protocol. Equal random streams give equal strokes.
///
/// `inputs` has complete parameters; its seed is drawn. Takes some 10 ms for a model on a plane. Errors: as
/// `make_renderer`.
ForceFeatures felt_surface(const ForceModel& model, const RendererInputs& inputs,
                           const Protocol& protocol, const HandHabits& habits,
                           const Random& random);

}  // namespace asperity
