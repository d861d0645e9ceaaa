// Lays the current scene out, draws it, and converts keys, clicks and drags to inputs with their time.

#include "app/gui/participant/participant_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QtGui/QPainter>
#include <QtWidgets/QPlainTextEdit>

#include "app/gui/participant/live_guide.h"
#include "app/gui/participant/pages/page_for.h"
#include "app/gui/participant/pages/participant_font.h"
#include "app/gui/participant/participant_keys.h"
#include "app/gui/participant/participant_painter.h"
#include "app/gui/participant/plan_pictures.h"
#include "app/gui/participant/shown_surface.h"
#include "app/gui/participant/type_size.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

namespace {

using Item = ParticipantItem;
using Scene = ParticipantScene;

constexpr int kSceneLook_ms = 16;
constexpr std::chrono::seconds kCueShown{5};
constexpr QSizeF kUsualPage(1366.0, 768.0);

bool same_question(const Scene& one, const Scene& other) {
  const auto is_number = [](const Scene& scene) {
    return scene.kind == Scene::Kind::question &&
           page_for(scene).typing(scene) == ParticipantPage::Typing::number;
  };
  // A number that is to be checked stays in its field under other words.
  const bool same_text = one.text == other.text || (is_number(one) && is_number(other));
  return one.kind == other.kind && same_text && one.question == other.question;
}

bool same_answer(const Scene& one, const Scene& other) {
  return one.scales == other.scales && one.line_step == other.line_step &&
         std::equal(one.choices.begin(), one.choices.end(), other.choices.begin(),
                    other.choices.end(), [](const Scene::Choice& left, const Scene::Choice& right) {
                      return left.chosen == right.chosen && left.assigned_to == right.assigned_to;
                    });
}

bool same_assignment(const Scene& one, const Scene& other) {
  return std::equal(one.choices.begin(), one.choices.end(), other.choices.begin(),
                    other.choices.end(), [](const Scene::Choice& left, const Scene::Choice& right) {
                      return left.assigned_to == right.assigned_to;
                    });
}

}  // namespace

ParticipantView::ParticipantView(const SessionMonitor& monitor, std::filesystem::path study,
                                 Role role, QWidget* parent)
    : QWidget(parent),
      monitor_(monitor),
      role_(role),
      shelf_(std::move(study)),
      event_clock_(stamps_of_platform()) {
  qRegisterMetaType<asperity::ParticipantInput>();
  setObjectName(role == Role::participant ? "participant_view" : "participant_mirror");
  setAccessibleName(role == Role::participant ? tr("Participant's view")
                                              : tr("Mirror of the participant's view"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  if (role == Role::participant) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    field_ = new QPlainTextEdit(this);
    field_->setObjectName("participant_text");
    field_->setTabChangesFocus(true);
    const ParticipantColors colors{};
    field_->setStyleSheet(QString("QPlainTextEdit { background: %1; color: %2; border: none; "
                                  "padding: 0px; selection-background-color: %3; "
                                  "selection-color: %4; }")
                              .arg(colors.panel.name(), colors.text.name(), colors.press.name(),
                                   colors.on_press.name()));
    field_->installEventFilter(this);
    // For the mirror: whoever types for a participant without eyes sees there what stands in the field.
    connect(field_, &QPlainTextEdit::textChanged, this, [this] {
      draft_.text = field_->toPlainText();
      arrange();
    });
    field_->hide();
  } else {
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  guide_ = new LiveGuide(monitor_, this);
  guide_->setAttribute(Qt::WA_TransparentForMouseEvents);
  guide_->hide();
  connect(&shelf_, &PictureShelf::arrived, this, [this] { update(); });
  connect(&shelf_, &PictureShelf::unreadable, this, [this](const QString& name) {
    if (role_ == Role::participant) emit remarked("picture_unreadable", name);
  });
  connect(&timer_, &QTimer::timeout, this, &ParticipantView::look);
  timer_.start(kSceneLook_ms);
  look();
}

ParticipantView::~ParticipantView() = default;

void ParticipantView::set_workspace(QWidget* workspace) {
  delete workspace_;
  workspace_ = workspace;
  if (workspace_ != nullptr) {
    workspace_->setParent(this);
    workspace_->setFocusPolicy(Qt::NoFocus);
    // What a mouse does over it is the view's, also without a button.
    workspace_->setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  arrange();
}

void ParticipantView::follow(ParticipantView& original) {
  original_ = &original;
  const auto take_over = [this] {
    if (original_) {
      draft_ = original_->draft_;
      page_ = original_->page_;
    }
    arrange();
  };
  connect(&original, &ParticipantView::arranged, this, take_over);
  take_over();
}

std::int64_t ParticipantView::session_now_ns() const {
  return monotonic_now_ns() + (facts_ ? facts_->clock_ahead_ns : 0);
}

std::int64_t ParticipantView::time_of_ns(std::uint64_t stamp_ms) {
  return event_clock_.happened_ns(stamp_ms, monotonic_now_ns()) +
         (facts_ ? facts_->clock_ahead_ns : 0);
}

int ParticipantView::rest_left_s() const {
  if (scene_->kind != Scene::Kind::rest || !scene_->rest_until_ns) return 0;
  const double left_s = static_cast<double>(*scene_->rest_until_ns - session_now_ns()) * 1e-9;
  return std::max(0, static_cast<int>(std::ceil(left_s)));
}

bool ParticipantView::waits() const {
  switch (scene_->kind) {
    case Scene::Kind::text:
    case Scene::Kind::feel:
    case Scene::Kind::question:
    case Scene::Kind::rest:
    case Scene::Kind::form:
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
      return true;
    case Scene::Kind::blank:
      return !scene_->surfaces.empty();
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      break;
  }
  return false;
}

bool ParticipantView::would_leave_out() const {
  return scene_->optional && scene_page().is_empty(*scene_, draft_);
}

bool ParticipantView::keys_are_private() const {
  return scene_->kind == Scene::Kind::form || scene_page().is_private();
}

const ParticipantPage& ParticipantView::scene_page() const { return page_for(*scene_); }

// --- looking and drawing ---

void ParticipantView::look() {
  if (!facts_) {
    facts_ = monitor_.facts();
    if (facts_) {
      if (facts_->protocol && facts_->protocol->shows_pictures_in_grey) shelf_.show_in_grey();
      prepare_pictures();
      arrange();
      emit scene_changed();
    }
  } else if (auto facts = monitor_.facts(); facts && facts != facts_) {
    // The plan has further trials, perhaps of another block with other pictures.
    // Before an external program has stated the first level there are no trials.
    const bool has_another_block =
        facts->plan && facts_->plan && !facts->plan->trials.empty() &&
        (facts_->plan->trials.empty() ||
         facts->plan->trials.back().block_ordinal != facts_->plan->trials.back().block_ordinal);
    facts_ = std::move(facts);
    if (has_another_block) prepare_pictures();
  }
  const SessionSnapshot snapshot = monitor_.snapshot();
  bool changed = false;
  if (snapshot.scene != scene_) {
    const std::shared_ptr<const Scene> before = std::exchange(scene_, snapshot.scene);
    const bool new_trial = snapshot.trial != trial_ || snapshot.attempt != attempt_;
    const bool same = !new_trial && same_question(*before, *scene_);
    trial_ = snapshot.trial;
    attempt_ = snapshot.attempt;
    if (!same) press_.reset();
    keep_draft();
    if (!original_ && !(same && same_assignment(*before, *scene_))) draft_.surface.reset();
    if (!original_) keep_page(*before, same);
    if (scene_->cue_number != cue_seen_) {
      cue_seen_ = scene_->cue_number;
      cue_until_ = std::chrono::steady_clock::now() + kCueShown;
    }
    changed = true;
  }
  const bool cue = std::chrono::steady_clock::now() < cue_until_ && !scene_->cue.empty();
  changed = changed || cue != cue_shown_ || rest_left_s() != rest_shown_s_ ||
            letters_px() != letters_shown_px_;
  if (!changed) return;
  cue_shown_ = cue;
  rest_shown_s_ = rest_left_s();
  arrange();
  emit scene_changed();
}

/// Through marks and cues in the question, and while a surface is felt again before its answer.
void ParticipantView::keep_draft() {
  const bool is_asked = scene_->kind == Scene::Kind::question || scene_->kind == Scene::Kind::form;
  if (!is_asked) return;
  const Asked asked{scene_->kind, trial_, attempt_, scene_->question};
  if (std::exchange(drafted_, asked) == asked) return;
  if (!original_) draft_ = {};
  if (field_ != nullptr) field_->clear();
}

/// Of the scene as it is shown, through marks and cues in it.
void ParticipantView::keep_page(const Scene& before, bool same) {
  if (!same || before.shown_ns != scene_->shown_ns) {
    page_ = 1;
    return;
  }
  // Of several options the one that was pressed stays in view.
  if (!same_answer(before, *scene_) && !scene_->is_answered_by<MultipleChoiceForm>()) page_ = 0;
  if (before.pages_turned == scene_->pages_turned) return;
  // A button of the device was pressed where there is more to read.
  if (const Item* next = turned_by(Qt::Key_PageDown)) page_ = next->action->number;
}

QSizeF ParticipantView::page_size() const {
  if (role_ == Role::participant) return size();
  return original_ ? QSizeF(original_->size()) : kUsualPage;
}

/// A mirror shows the letters of the screen that it mirrors.
double ParticipantView::letters_px() const {
  if (original_) return original_->letters_px();
  const QScreen* where = role_ == Role::participant ? screen() : nullptr;
  return where != nullptr ? smallest_text_px(measures_of(*where))
                          : ParticipantLayoutInputs{}.smallest_text_px;
}

/// A mirror shows the surface where its original has it.
double ParticipantView::surface_aspect() const {
  if (original_) return original_->surface_aspect();
  if (!pointer_is_probe_ || !facts_ || !facts_->protocol) return 0.0;
  const PlannedPresentation* const shown = shown_surface(*facts_, monitor_.snapshot());
  const glm::dvec2 extent_m =
      shown != nullptr ? shown->stimulus.patch.extent_m : facts_->protocol->patch.extent_m;
  return extent_m.x / extent_m.y;
}

std::optional<QRectF> ParticipantView::surface_rect() const {
  const auto surface = std::find_if(items_.begin(), items_.end(), [](const Item& item) {
    return item.kind == Item::Kind::surface;
  });
  if (surface == items_.end()) return {};
  return QRectF(page_offset() + surface->rect.topLeft() * page_scale(),
                surface->rect.size() * page_scale());
}

ParticipantLayoutInputs ParticipantView::layout_inputs() const {
  return {.size = page_size(),
          .smallest_text_px = letters_shown_px_,
          .page = page_,
          .draft = draft_,
          .mirrored = facts_ && facts_->mirrored,
          .surface_aspect = surface_aspect(),
          .cue_shown = cue_shown_,
          .rest_left_s = rest_shown_s_};
}

const ParticipantItem* ParticipantView::turned_by(int key) const {
  const bool on = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Right ||
                  key == Qt::Key_PageDown;
  const bool back = key == Qt::Key_Left || key == Qt::Key_PageUp;
  if (!on && !back) return nullptr;
  const bool is_arrow = key == Qt::Key_Right || key == Qt::Key_Left;
  if (is_arrow && action_of_key(*scene_, key, {})) return nullptr;  // it moves a mark
  for (const Item& item : items_) {
    // The way on is filled, the way back is not.
    const bool turns = item.action && item.action->what == ParticipantAction::What::turn_to;
    if (turns && item.ready == on) return &item;
  }
  return nullptr;
}

void ParticipantView::turn_to(int page) {
  page_ = page;
  arrange();
}

double ParticipantView::page_scale() const {
  const QSizeF page = page_size();
  return std::min(width() / page.width(), height() / page.height());
}

QPointF ParticipantView::page_offset() const {
  const QSizeF drawn = page_size() * page_scale();
  return {(width() - drawn.width()) / 2.0, (height() - drawn.height()) / 2.0};
}

QPointF ParticipantView::to_page(QPointF point) const {
  return (point - page_offset()) / page_scale();
}

int ParticipantView::side_px(double side) const {
  return std::max(1, static_cast<int>(std::lround(side * page_scale() * devicePixelRatioF())));
}

void ParticipantView::arrange() {
  letters_shown_px_ = letters_px();
  items_ = lay_out(*scene_, layout_inputs());
  if (const bool more = turned_by(Qt::Key_PageDown) != nullptr; more != told_more_) {
    told_more_ = more;
    emit more_to_read(more);
  }
  const Item* field = nullptr;
  const Item* workspace = nullptr;
  const Item* guide = nullptr;
  for (const Item& item : items_) {
    if (item.kind == Item::Kind::field) field = &item;
    if (item.kind == Item::Kind::workspace) workspace = &item;
    if (item.kind == Item::Kind::guide) guide = &item;
  }
  if (field_ != nullptr) {
    if (field != nullptr) {
      field_->setFont(participant_font(field->size_px, false));
      field_->setGeometry(field->rect.adjusted(16.0, 12.0, -16.0, -12.0).toRect());
      if (field_->isHidden()) {
        field_->show();
        field_->setFocus();
      }
    } else if (!field_->isHidden()) {
      field_->hide();
      setFocus();
    }
  }
  if (workspace_ != nullptr) place(workspace_, workspace);
  place(guide_, guide);
  if (guide != nullptr) guide_->set_number_size(page_scale() * guide->size_px);
  update();
  emit arranged();
}

/// Where its item is; nowhere without one.
void ParticipantView::place(QWidget* widget, const ParticipantItem* item) {
  if (item != nullptr) {
    const QPointF corner = page_offset() + item->rect.topLeft() * page_scale();
    widget->setGeometry(QRectF(corner, item->rect.size() * page_scale()).toAlignedRect());
  }
  widget->setVisible(item != nullptr);
}

void ParticipantView::prepare_pictures() {
  if (!facts_->plan) return;
  letters_shown_px_ = letters_px();
  const auto by_side = pictures_of_plan(*facts_->plan, layout_inputs(),
                                        [this](double side) { return side_px(side); });
  for (const auto& [side, names] : by_side) shelf_.prepare(names, side);
}

bool ParticipantView::pictures_are_there() const {
  return std::all_of(items_.begin(), items_.end(), [this](const Item& item) {
    return item.picture.isEmpty() || shelf_.is_settled(item.picture, side_px(item.side));
  });
}

void ParticipantView::paintEvent(QPaintEvent*) {
  const ParticipantColors colors{};
  QPainter painter(this);
  painter.fillRect(rect(), colors.ground);
  for (const Item& item : items_) {
    if (!item.picture.isEmpty()) shelf_.picture(item.picture, side_px(item.side));
  }
  const bool all_there = pictures_are_there();
  painter.translate(page_offset());
  painter.scale(page_scale(), page_scale());
  drawn_texts_ = paint(painter, scene_page(), items_, colors,
                       [this, all_there](const QString& name, double side) {
                         return all_there ? shelf_.picture(name, side_px(side)) : QPixmap();
                       });
  if (press_ && press_->dragging) {
    paint_dragged(painter, press_->letter, pointer_,
                  std::max(1.0, std::min(width() / 1366.0, height() / 768.0)), colors);
  }
  setAccessibleDescription(drawn_texts_.join(". "));
}

void ParticipantView::resizeEvent(QResizeEvent*) {
  press_.reset();
  arrange();
}

std::vector<ParticipantItem> ParticipantView::items() const {
  std::vector<Item> placed = items_;
  for (Item& item : placed) {
    item.rect =
        QRectF(page_offset() + item.rect.topLeft() * page_scale(), item.rect.size() * page_scale());
  }
  return placed;
}

}  // namespace asperity

#include "moc_participant_view.cpp"
