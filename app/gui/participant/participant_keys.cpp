// Recognises digits by scan codes, and asks the page of the scene for the action of any other key.

#include "app/gui/participant/participant_keys.h"

#include <QtGui/QKeyEvent>

#include "app/gui/participant/pages/page_for.h"

namespace asperity {

namespace {

// Of the keys 1 … 9, 0 above the letters, under xcb and Wayland alike.
constexpr quint32 kScanCodeOf1 = 10;
constexpr quint32 kScanCodeOf0 = 19;

std::optional<ParticipantAction> known_action(const ParticipantScene& scene, int key,
                                              const QString& sign) {
  return page_for(scene).action_of_key(scene, key, sign.toUpper());
}

bool takes_typed_number(const ParticipantScene& scene) {
  return page_for(scene).typing(scene) == ParticipantPage::Typing::number;
}

}  // namespace

bool is_command_key(const QKeyEvent& event) {
  return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
}

QString sign_of_key(const ParticipantScene& scene, const QKeyEvent& event) {
  const quint32 code = event.nativeScanCode();
  if (code < kScanCodeOf1 || code > kScanCodeOf0) return event.text();
  if (known_action(scene, event.key(), event.text())) return event.text();
  // Digits that are typed without Shift are what the row is for; with it, "/" of a German keyboard is no 7.
  const bool shifted = (event.modifiers() & Qt::ShiftModifier) != 0;
  if (shifted && takes_typed_number(scene)) return event.text();
  return QString::number((code - kScanCodeOf1 + 1) % 10);
}

std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                               const QString& sign) {
  if (auto action = known_action(scene, key, sign)) return action;
  if (!takes_typed_number(scene) || sign.size() != 1) return {};
  if (!sign.front().isPrint() || sign.front().isSpace()) return {};
  return ParticipantAction{.what = ParticipantAction::What::write, .text = sign};
}

}  // namespace asperity
