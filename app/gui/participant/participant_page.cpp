#include "app/gui/participant/participant_page.h"

namespace asperity {

namespace {

QString minutes_and_seconds(int seconds) {
  return QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
}

constexpr double kSmallestSpace = 0.5;
constexpr double kTwoLines = 84.0;  // a cue in a narrow window

}  // namespace

ParticipantPage::ParticipantPage(const ParticipantScene& scene,
                                 const ParticipantLayoutInputs& inputs)
    : scene_(scene), inputs_(inputs) {
  const QSizeF size = inputs.size;
  type_ = std::max({1.0, std::min(size.width() / 1366.0, size.height() / 768.0),
                    inputs.smallest_text_px / kText});
  const double usual_width = is_wide() ? 1366.0 : 683.0;
  space_ = std::clamp(std::min(size.width() / usual_width, size.height() / 768.0), kSmallestSpace,
                      type_);
}

void ParticipantPage::progress() {
  const double edge = std::min(px(kEdge), inputs_.size.width() / 28.0);
  body_ = QRectF(QPointF(0.0, 0.0), inputs_.size).adjusted(edge, edge / 2.0, -edge, -edge);
  QRectF line = body_;
  // Where there is little room it is the place of cues as well, which take two lines there.
  const bool has_two_lines = is_tight() && !is_wide() && inputs_.size.height() >= em(660.0);
  line.setHeight(has_two_lines ? em(kTwoLines) : tall(kLine, 40.0));
  body_.setTop(line.bottom());
  progress_strip_ = line;
  if (is_tight() && shows_cue()) return;
  if (scene_.block <= 0) return;
  add({.rect = line,
       .text = said(phrase("ParticipantLayout", "Block %1 of %2")
                        .with(std::to_string(scene_.block), std::to_string(scene_.blocks))),
       .size_px = letters(kText),
       .muted = true});
}

// --- the row of controls ---

// As it is drawn: a control says its key in words, an answer in a circle.
double ParticipantPage::width_of_control(const Item& item) const {
  if (item.kind == Item::Kind::option) return width_of_answer(item.text);
  return width_of(item.text, item.size_px, item.bold) + width_of(item.key, item.size_px, false) +
         em(is_tight() ? 48.0 : 64.0);
}

void ParticipantPage::add_control(Item item) {
  double width = width_of_control(item);
  double height = tall(kControl);
  if (width > body_.width()) {
    // Words and key of such a one stand in two lines or more.
    const double around = width - width_of(item.text, item.size_px, item.bold);
    width = body_.width();
    height =
        std::max(height, height_of(item.text, item.size_px, item.bold, width - around) + em(12.0));
  }
  // Outermost first, at the side of the free hand; what finds no room goes into a row above.
  if (outer_x_ > 0.0 && outer_x_ + inner_x_ + width > body_.width()) {
    outer_x_ = 0.0;
    inner_x_ = 0.0;
    row_bottom_ = controls_top_ - px(kGap) / 2.0;
  }
  item.rect = QRectF(inputs_.mirrored ? body_.left() + outer_x_ : body_.right() - outer_x_ - width,
                     row_bottom_ - height, width, height);
  outer_x_ += width + px(is_wide() ? kGap : kGap / 2.0);
  controls_top_ = std::min(controls_top_, item.rect.top());
  add(std::move(item));
}

void ParticipantPage::add_control(const QString& text, const QString& key, Action action,
                                  bool ready) {
  add_control({.kind = Item::Kind::control,
               .text = text,
               .key = key,
               .size_px = letters(kText),
               .bold = true,
               .ready = ready,
               .action = std::move(action)});
}

void ParticipantPage::add_at_inner_end(Item item, double width) {
  if (outer_x_ + inner_x_ + width > body_.width()) {
    outer_x_ = 0.0;
    inner_x_ = 0.0;
    row_bottom_ = controls_top_ - px(kGap) / 2.0;
  }
  width = std::min(width, body_.width());
  double height = tall(kControl);
  if (item.kind == Item::Kind::option) {
    height = std::max(height, height_of_answer(item.text, width));
  }
  item.rect = QRectF(inputs_.mirrored ? body_.right() - inner_x_ - width : body_.left() + inner_x_,
                     row_bottom_ - height, width, height);
  inner_x_ += width + px(is_wide() ? kGap : kGap / 2.0);
  controls_top_ = std::min(controls_top_, item.rect.top());
  add(std::move(item));
}

QString ParticipantPage::again_text() const {
  const std::optional<int> picked = inputs_.draft.surface;
  const bool names_it = picked && static_cast<std::size_t>(*picked) <= scene_.surfaces.size();
  // Where controls have little room their size stays the same.
  if (!names_it || !is_wide()) {
    return said(phrase("ParticipantLayout", "Feel again"));
  }
  return said(phrase("ParticipantLayout", "Feel %1 again")
                  .with(scene_.surfaces[static_cast<std::size_t>(*picked - 1)].code));
}

/// As it is printed on the key, where there is no room for its name.
QString ParticipantPage::key_name(const QString& name, const QString& sign) const {
  return is_tight() && inputs_.size.width() < em(800.0) ? sign : name;
}

void ParticipantPage::turning_controls() {
  if (page_ < pages_) {
    add_control(said(phrase("ParticipantLayout", "Continue")),
                key_name(said(phrase("ParticipantLayout", "Return")), QStringLiteral("⏎")),
                Action{.what = Action::What::turn_to, .number = page_ + 1}, true);
  }
  if (page_ > 1) {
    // In a field for text the arrow moves among the letters.
    const bool is_text = scene_.kind == Scene::Kind::form && scene_.question &&
                         scene_.question->form == Question::Form::text && page_ == pages_;
    // On a scale it moves the mark.
    const bool is_scale =
        scene_.kind == Scene::Kind::question && scene_.is_answered_by<ScaleForm>();
    add_control(
        said(phrase("ParticipantLayout", "Back")),
        is_text || is_scale ? said(phrase("ParticipantLayout", "Page up")) : QStringLiteral("←"),
        Action{.what = Action::What::turn_to, .number = page_ - 1}, false);
  }
  if (pages_ > 1) {
    const QString text = said(phrase("ParticipantLayout", "Page %1 of %2")
                                  .with(std::to_string(page_), std::to_string(pages_)));
    add_at_inner_end({.text = text, .size_px = letters(kText), .muted = true},
                     width_of(text, letters(kText), false) + em(kGap));
  }
}

void ParticipantPage::controls() {
  outer_x_ = 0.0;
  inner_x_ = 0.0;
  row_bottom_ = inputs_.size.height() - px(kEdge) / 2.0;
  controls_top_ = row_bottom_ - tall(kControl);
  if (page_ < pages_) {
    turning_controls();
    return;
  }
  const Action confirm{.what = Action::What::confirm};
  const Action next{.what = Action::What::next};
  const QString return_key =
      key_name(said(phrase("ParticipantLayout", "Return")), QStringLiteral("⏎"));
  const QString space_key =
      key_name(said(phrase("ParticipantLayout", "Space")), QStringLiteral("␣"));
  switch (scene_.kind) {
    case Scene::Kind::text:
      add_control(said(phrase("ParticipantLayout", "Continue")), return_key, confirm, true);
      break;
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
      add_control(said(phrase("ParticipantLayout", "Done")), return_key, confirm, true);
      break;
    case Scene::Kind::rest:
      add_control(said(phrase("ParticipantLayout", "Continue")), return_key, confirm,
                  inputs_.rest_left_s <= 0);
      break;
    case Scene::Kind::feel:
      add_control(said(phrase("ParticipantLayout", "Finish with this surface")), space_key, next,
                  false);
      break;
    case Scene::Kind::question:
      add_control(
          said(phrase("ParticipantLayout", "Confirm")), return_key, confirm,
          scene_.is_answered_by<NumberForm>()
              ? !inputs_.draft.number.isEmpty() && !is_no_number(scene_, inputs_.draft.number)
              : scene_.can_confirm);
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
        add_control(said(phrase("ParticipantLayout", "Skip")), return_key, confirm, true);
      } else {
        const bool is_amiss =
            takes_typed_number(scene_) && is_no_number(scene_, inputs_.draft.number);
        add_control(said(phrase("ParticipantLayout", "Confirm")), return_key, confirm,
                    !empty && !is_amiss);
      }
      break;
    }
    case Scene::Kind::blank:
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      break;
  }
  turning_controls();
}

// --- cue ---

// The same room with and without controls and cues, so that nothing jumps from scene to scene.
void ParticipantPage::reserve_cue() {
  body_.setBottom(controls_top_ - px(kGap));
  cue_strip_ = body_;
  if (is_tight()) {
    cue_strip_ = progress_strip_;
    return;
  }
  // In a narrow window they take two lines.
  cue_strip_.setTop(cue_strip_.bottom() - (is_wide() ? tall(kLine, 40.0) : em(kTwoLines)));
  body_.setBottom(cue_strip_.top() - px(kGap) / 2.0);
}

// Last of all: one that takes more lines covers what is above it.
void ParticipantPage::cue() {
  if (!shows_cue()) return;
  const QString text = words_of(scene_.cue_saying, scene_.cue, scene_.language);
  const double width =
      std::min(cue_strip_.width(), width_of(text, letters(kText), false) + em(2 * kEdge));
  const double height =
      std::max(std::min(cue_strip_.height(), em(kLine)),
               height_of(text, letters(kText), false, width - em(kGap)) + em(2.0));
  const double top =
      is_tight() ? std::max(0.0, std::min(cue_strip_.top(), cue_strip_.center().y() - height / 2.0))
                 : cue_strip_.bottom() - height;
  add({.kind = Item::Kind::cue,
       .rect = QRectF(cue_strip_.center().x() - width / 2.0, top, width, height),
       .text = text,
       .size_px = letters(kText)});
}

// --- all ---

std::vector<ParticipantItem> ParticipantPage::lay_out() {
  if (scene_.kind == Scene::Kind::blank) {
    if (!inputs_.cue_shown) return {};
    // Where it stands in other scenes; the ground stays empty but for it.
    progress();
    controls();
    items_.clear();
    reserve_cue();
    cue();
    return std::move(items_);
  }
  for (;;) {
    const int pages = pages_;
    const int answer_page = answer_page_;
    // On every page of a text the words have the same room: that which the fullest row of controls
    // leaves.
    double top = inputs_.size.height();
    progress();
    for (const int page : {1, std::min(2, pages_), pages_}) {
      page_ = page;
      controls();
      top = std::min(top, controls_top_);
    }
    items_.clear();
    const int last = answer_page_ > 0 ? answer_page_ : pages_;
    page_ = inputs_.page == 0 ? last : std::clamp(inputs_.page, 1, pages_);
    progress();
    controls();
    controls_top_ = top;
    reserve_cue();
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
                  ? said(phrase("ParticipantLayout", "You can continue in %1")
                             .with(minutes_and_seconds(inputs_.rest_left_s).toStdString()))
                  : said(phrase("ParticipantLayout", "You can continue when you are ready.")));
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
        words(scene_.text.empty() ? said(phrase("ParticipantLayout",
                                                "One moment, please. You may release the handle."))
                                  : scene_text());
        break;
      case Scene::Kind::ended:
        words(scene_.text.empty()
                  ? said(phrase("ParticipantLayout", "Thank you. You may release the handle."))
                  : scene_text());
        break;
    }
    cue();
    // More pages take more room for the controls that turn them, never less: it comes to an end.
    if (pages_ == pages && answer_page_ == answer_page) return std::move(items_);
    items_.clear();
  }
}

}  // namespace asperity
