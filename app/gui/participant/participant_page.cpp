#include "app/gui/participant/participant_page.h"

namespace asperity {

namespace {

QString minutes_and_seconds(int seconds) {
  return QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
}

}  // namespace

void ParticipantPage::progress() {
  QRectF line = body_;
  line.setHeight(px(kLine));
  body_.setTop(line.bottom());
  if (scene_.block <= 0) return;
  add({.rect = line,
       .text = tr("Block %1 of %2").arg(scene_.block).arg(scene_.blocks),
       .size_px = letters(kText_px),
       .muted = true});
}

void ParticipantPage::add_control(Item item) {
  // As it is drawn: a control says its key in words, an answer in a circle.
  const double width = item.kind == Item::Kind::option
                           ? width_of_answer(item.text)
                           : width_of(item.text, item.size_px, item.bold) +
                                 width_of(item.key, item.size_px, false) +
                                 px(is_wide() ? 64.0 : 44.0);
  // Outermost first, at the side of the free hand; what finds no room goes into a row above.
  if (control_x_ > 0.0 && control_x_ + width > body_.width()) {
    control_x_ = 0.0;
    controls_top_ -= px(kControl) + px(kGap) / 2.0;
  }
  item.rect =
      QRectF(inputs_.mirrored ? body_.left() + control_x_ : body_.right() - control_x_ - width,
             controls_top_, width, px(kControl));
  control_x_ += width + px(is_wide() ? kGap : kGap / 2.0);
  add(std::move(item));
}

void ParticipantPage::add_control(const QString& text, const QString& key, Action action,
                                  bool ready) {
  add_control({.kind = Item::Kind::control,
               .text = text,
               .key = key,
               .size_px = letters(kText_px),
               .bold = true,
               .ready = ready,
               .action = std::move(action)});
}

QString ParticipantPage::again_text() const {
  const std::optional<int> picked = inputs_.draft.surface;
  const bool names_it = picked && static_cast<std::size_t>(*picked) <= scene_.surfaces.size();
  // Where controls have little room their size stays the same.
  if (!names_it || !is_wide()) {
    return tr("Feel again");
  }
  return tr("Feel %1 again")
      .arg(text_from(scene_.surfaces[static_cast<std::size_t>(*picked - 1)].code));
}

void ParticipantPage::controls() {
  const Action confirm{.what = Action::What::confirm};
  const Action next{.what = Action::What::next};
  controls_top_ = inputs_.size.height() - px(kEdge) / 2.0 - px(kControl);
  const QString return_key = tr("Return");
  const QString space_key = tr("Space");
  switch (scene_.kind) {
    case Scene::Kind::text:
      add_control(tr("Go on"), return_key, confirm, true);
      break;
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
      add_control(tr("Done"), return_key, confirm, true);
      break;
    case Scene::Kind::rest:
      add_control(tr("Go on"), return_key, confirm, inputs_.rest_left_s <= 0);
      break;
    case Scene::Kind::feel:
      add_control(tr("Enough of this surface"), space_key, next, false);
      break;
    case Scene::Kind::question:
      add_control(tr("Confirm"), return_key, confirm, scene_.can_confirm);
      if (scene_.can_switch) add_control(again_text(), space_key, next, false);
      if (shows_pictures()) answers_in_words_as_controls();
      break;
    case Scene::Kind::form: {
      if (!scene_.question) break;
      const bool empty =
          scene_.question->form == Question::Form::choice
              ? !inputs_.draft.option
              : scene_.question->form == Question::Form::number && inputs_.draft.number.isEmpty();
      if (scene_.question->optional && empty) {
        add_control(tr("Leave out"), return_key, confirm, true);
      } else {
        add_control(tr("Confirm"), return_key, confirm, !empty);
      }
      break;
    }
    case Scene::Kind::blank:
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      break;
  }
  // The same room with and without controls, so that nothing jumps from scene to scene.
  body_.setBottom(controls_top_ - px(kGap));
}

void ParticipantPage::cue() {
  QRectF line = body_;
  line.setTop(line.bottom() - px(kLine));
  body_.setBottom(line.top() - px(kGap) / 2.0);
  if (!inputs_.cue_shown || scene_.cue.empty()) return;
  const QString text = words_of(scene_.cue_saying, scene_.cue);
  const double width =
      std::min(line.width(), width_of(text, letters(kText_px), false) + px(2 * kEdge));
  line.setLeft(line.center().x() - width / 2.0);
  line.setWidth(width);
  add({.kind = Item::Kind::cue, .rect = line, .text = text, .size_px = letters(kText_px)});
}

void ParticipantPage::prompt(const QString& text, int size_px) {
  if (text.isEmpty()) return;
  const QRectF rect = place_of(text, size_px, true, column());
  add({.rect = rect, .text = text, .size_px = size_px, .bold = true});
  body_.setTop(rect.bottom() + px(kGap));
}

void ParticipantPage::words(const QString& text, const QString& below) {
  const QRectF room = column();
  const double gap = below.isEmpty() ? 0.0 : px(2 * kGap);
  // A short sentence is read from afar.
  const bool short_text =
      height_of(text, letters(kLarge_px), false, room.width()) < 3.0 * letters(kLarge_px);
  int size_px = letters(short_text ? kLarge_px : kPrompt_px);
  const auto heights = [&] {
    return std::pair(height_of(text, size_px, false, room.width()),
                     below.isEmpty() ? 0.0 : height_of(below, size_px, true, room.width()));
  };
  auto [first, second] = heights();
  while (first + gap + second > room.height() && size_px > kText_px / 2) {
    size_px -= 2;
    std::tie(first, second) = heights();
  }
  QRectF left = room;
  left.setTop(room.center().y() - (first + gap + second) / 2.0);
  add({.rect = place_of(text, size_px, false, left),
       .text = text,
       .size_px = size_px,
       // Lines of a paragraph are found again where they begin at one edge.
       .left_aligned = first > 3.0 * size_px});
  if (below.isEmpty()) return;
  left.setTop(left.top() + first + gap);
  add({.rect = place_of(below, size_px, true, left),
       .text = below,
       .size_px = size_px,
       .bold = true});
}

std::vector<ParticipantItem> ParticipantPage::lay_out() {
  if (scene_.kind == Scene::Kind::blank) return {};
  progress();
  controls();
  cue();
  switch (scene_.kind) {
    case Scene::Kind::blank:
      break;
    case Scene::Kind::text:
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
    case Scene::Kind::feedback:
      words(scene_text());
      break;
    case Scene::Kind::rest:
      words(scene_text(),
            inputs_.rest_left_s > 0
                ? tr("You can go on in %1").arg(minutes_and_seconds(inputs_.rest_left_s))
                : tr("You can go on when you are ready."));
      break;
    case Scene::Kind::feel:
      feel();
      break;
    case Scene::Kind::question:
      question();
      break;
    case Scene::Kind::form:
      form();
      break;
    case Scene::Kind::paused:
      words(scene_.text.empty() ? tr("One moment, please. You may let go of the handle.")
                                : scene_text());
      break;
    case Scene::Kind::ended:
      words(scene_.text.empty() ? tr("Thank you. You may let go of the handle.") : scene_text());
      break;
  }
  return std::move(items_);
}

}  // namespace asperity
