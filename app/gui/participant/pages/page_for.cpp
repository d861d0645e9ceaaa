// Selects the page by the kind of the scene, and where something is asked by the form of the answer.

#include "app/gui/participant/pages/page_for.h"

#include <variant>

#include "app/gui/participant/pages/assignment_page.h"
#include "app/gui/participant/pages/choice_page.h"
#include "app/gui/participant/pages/feel_page.h"
#include "app/gui/participant/pages/line_page.h"
#include "app/gui/participant/pages/number_page.h"
#include "app/gui/participant/pages/scale_page.h"
#include "app/gui/participant/pages/text_page.h"
#include "app/gui/participant/pages/words_page.h"

namespace asperity {

namespace {

const ParticipantPage& page_of_form(const ChoiceForm&) { return choice_page(); }
const ParticipantPage& page_of_form(const AssignmentForm&) { return assignment_page(); }
const ParticipantPage& page_of_form(const NumberForm&) { return number_page(); }
const ParticipantPage& page_of_form(const LineForm&) { return line_page(); }
const ParticipantPage& page_of_form(const ScaleForm&) { return scale_page(); }
const ParticipantPage& page_of_form(const MultipleChoiceForm&) { return choice_page(); }
const ParticipantPage& page_of_form(const TextForm&) { return text_page(); }

}  // namespace

const ParticipantPage& page_for(const ParticipantScene& scene) {
  switch (scene.kind) {
    case ParticipantScene::Kind::blank:
    case ParticipantScene::Kind::feel:
      return feel_page();
    case ParticipantScene::Kind::question:
    case ParticipantScene::Kind::form:
      return std::visit(
          [](const auto& form) -> const ParticipantPage& { return page_of_form(form); },
          scene.form);
    case ParticipantScene::Kind::text:
    case ParticipantScene::Kind::feedback:
    case ParticipantScene::Kind::rest:
    case ParticipantScene::Kind::mask_on:
    case ParticipantScene::Kind::mask_off:
    case ParticipantScene::Kind::paused:
    case ParticipantScene::Kind::ended:
      break;
  }
  return words_page();
}

}  // namespace asperity
