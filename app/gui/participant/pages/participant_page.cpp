// Implements the default page, which draws common items and passes most actions on as inputs.

#include "app/gui/participant/pages/participant_page.h"

#include <algorithm>

#include "app/gui/participant/pages/participant_brush.h"

namespace asperity {

namespace {

using Action = ParticipantAction;

}  // namespace

void ParticipantPage::draw(ParticipantBrush& brush, const ParticipantItem& item) const {
  brush.draw(item);
}

bool ParticipantPage::is_empty(const ParticipantScene& scene, const ParticipantDraft&) const {
  return !scene.line_step &&
         std::ranges::none_of(scene.choices, &ParticipantScene::Choice::chosen) &&
         std::ranges::none_of(scene.scales, &ParticipantScene::Scale::counts);
}

ActionEffect ParticipantPage::act(const ParticipantScene&, const ParticipantAction& action,
                                  ParticipantDraft&) const {
  using Kind = ParticipantInput::Kind;
  switch (action.what) {
    case Action::What::choose:
      return {.told = ParticipantInput{.kind = Kind::option, .number = action.number}};
    case Action::What::surface:
      return {.told = ParticipantInput{.kind = Kind::surface, .number = action.number}};
    case Action::What::next:
      return {.told = ParticipantInput{.kind = Kind::next}};
    case Action::What::confirm:
      return {.told = ParticipantInput{.kind = Kind::confirm}};
    case Action::What::step:
      return {.told = ParticipantInput{.kind = Kind::step, .number = action.number}};
    case Action::What::select:
      return {.told = ParticipantInput{.kind = Kind::select, .number = action.number}};
    case Action::What::mark:
      return {.told = ParticipantInput{
                  .kind = Kind::mark, .number = action.number, .position = action.position}};
    case Action::What::write:
    case Action::What::erase:
    case Action::What::turn_to:  // the view's
      break;
  }
  return {};
}

}  // namespace asperity
