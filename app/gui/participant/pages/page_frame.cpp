// Reserves the rooms of progress, cue and controls, so that no page moves when they appear or disappear.

#include "app/gui/participant/pages/page_frame.h"

namespace asperity {

namespace {

using Action = ParticipantAction;

constexpr double kSmallestSpace = 0.5;
constexpr double kTwoLines = 84.0;  // a cue in a narrow window

}  // namespace

PageFrame::PageFrame(const ParticipantScene& scene, const ParticipantLayoutInputs& inputs)
    : scene_(scene), inputs_(inputs) {
  const QSizeF size = inputs.size;
  type_ = std::max({1.0, std::min(size.width() / 1366.0, size.height() / 768.0),
                    inputs.smallest_text_px / kText});
  const double usual_width = is_wide() ? 1366.0 : 683.0;
  space_ = std::clamp(std::min(size.width() / usual_width, size.height() / 768.0), kSmallestSpace,
                      type_);
}

QRectF PageFrame::take_side(double width) {
  QRectF strip = body_;
  strip.setWidth(width);
  if (inputs_.mirrored) {
    strip.moveRight(body_.right());
    body_.setRight(strip.left() - px(2 * kGap));
  } else {
    body_.setLeft(strip.right() + px(2 * kGap));
  }
  return strip;
}

void PageFrame::progress() {
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
double PageFrame::width_of_control(const ParticipantItem& item) const {
  if (item.kind == ParticipantItem::Kind::option) return width_of_answer(item.text);
  return width_of(item.text, item.size_px, item.bold) + width_of(item.key, item.size_px, false) +
         em(is_tight() ? 48.0 : 64.0);
}

void PageFrame::add_control(ParticipantItem item) {
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

void PageFrame::add_control(const QString& text, const QString& key, Action action, bool ready) {
  add_control({.kind = ParticipantItem::Kind::control,
               .text = text,
               .key = key,
               .size_px = letters(kText),
               .bold = true,
               .ready = ready,
               .action = std::move(action)});
}

void PageFrame::add_at_inner_end(ParticipantItem item, double width) {
  if (outer_x_ + inner_x_ + width > body_.width()) {
    outer_x_ = 0.0;
    inner_x_ = 0.0;
    row_bottom_ = controls_top_ - px(kGap) / 2.0;
  }
  width = std::min(width, body_.width());
  double height = tall(kControl);
  if (item.kind == ParticipantItem::Kind::option) {
    height = std::max(height, height_of_answer(item.text, width));
  }
  item.rect = QRectF(inputs_.mirrored ? body_.right() - inner_x_ - width : body_.left() + inner_x_,
                     row_bottom_ - height, width, height);
  inner_x_ += width + px(is_wide() ? kGap : kGap / 2.0);
  controls_top_ = std::min(controls_top_, item.rect.top());
  add(std::move(item));
}

QString PageFrame::key_name(const QString& name, const QString& sign) const {
  return is_tight() && inputs_.size.width() < em(800.0) ? sign : name;
}

QString PageFrame::return_key() const {
  return key_name(said(phrase("ParticipantLayout", "Return")), QStringLiteral("⏎"));
}

QString PageFrame::space_key() const {
  return key_name(said(phrase("ParticipantLayout", "Space")), QStringLiteral("␣"));
}

void PageFrame::begin_page(int page) {
  page_ = page;
  progress();
  outer_x_ = 0.0;
  inner_x_ = 0.0;
  row_bottom_ = inputs_.size.height() - px(kEdge) / 2.0;
  controls_top_ = row_bottom_ - tall(kControl);
}

void PageFrame::add_turning_controls(bool arrow_turns) {
  if (page_ < pages_) {
    add_control(said(phrase("ParticipantLayout", "Continue")), return_key(),
                Action{.what = Action::What::turn_to, .number = page_ + 1}, true);
  }
  if (page_ > 1) {
    add_control(said(phrase("ParticipantLayout", "Back")),
                arrow_turns ? QStringLiteral("←") : said(phrase("ParticipantLayout", "Page up")),
                Action{.what = Action::What::turn_to, .number = page_ - 1}, false);
  }
  if (pages_ > 1) {
    const QString text = said(phrase("ParticipantLayout", "Page %1 of %2")
                                  .with(std::to_string(page_), std::to_string(pages_)));
    add_at_inner_end({.text = text, .size_px = letters(kText), .muted = true},
                     width_of(text, letters(kText), false) + em(kGap));
  }
}

// --- cue ---

// The same room with and without controls and cues, so that nothing jumps from scene to scene.
void PageFrame::end_controls(double controls_top) {
  controls_top_ = controls_top;
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

void PageFrame::cue() {
  if (!shows_cue()) return;
  const QString text = words_of(scene_.cue_message, scene_.cue, scene_.language);
  const double width =
      std::min(cue_strip_.width(), width_of(text, letters(kText), false) + em(2 * kEdge));
  const double height =
      std::max(std::min(cue_strip_.height(), em(kLine)),
               height_of(text, letters(kText), false, width - em(kGap)) + em(2.0));
  const double top =
      is_tight() ? std::max(0.0, std::min(cue_strip_.top(), cue_strip_.center().y() - height / 2.0))
                 : cue_strip_.bottom() - height;
  add({.kind = ParticipantItem::Kind::cue,
       .rect = QRectF(cue_strip_.center().x() - width / 2.0, top, width, height),
       .text = text,
       .size_px = letters(kText)});
}

}  // namespace asperity
