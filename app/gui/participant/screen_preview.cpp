// Makes the scenes of a step of a plan, and shows them with the view of the participant's window.

#include "app/gui/participant/screen_preview.h"

#include <utility>
#include <variant>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/gui/participant/participant_view.h"
#include "protocols/answers/question.h"

namespace asperity {

namespace {

constexpr int kSmallestHeight = 200;

class ScreensOfStep final {
 public:
  ScreensOfStep(const Protocol& protocol, const Plan& plan) : protocol_(protocol), plan_(plan) {}

  void operator()(const Protocol::Screen& step) { screens.push_back(scene_to_read(step.text)); }
  void operator()(const Protocol::Check&) {}
  void operator()(const Protocol::Break& step) {
    screens.push_back({.kind = ParticipantScene::Kind::rest, .text = step.text});
  }
  void operator()(const Protocol::Ask& step) {
    for (const std::string& name : step.questions) {
      screens.push_back(scene_of_form(protocol_.questions.at(name)));
    }
  }
  void operator()(const TrialStep& step) {
    const Trial& trial = plan_.trials[step.trial];
    std::vector<int> felt{};
    if (trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side) {
      add_surface(trial, scene_of_patches(trial));
      for (const PlannedPresentation& surface : trial.presentations) {
        felt.push_back(surface.position);
      }
    } else {
      for (const PlannedPresentation& surface : trial.presentations) {
        add_surface(trial, scene_of_surface(trial, felt, surface.position));
        felt.push_back(surface.position);
      }
    }
    for (const auto& page : pages_of(trial)) {
      screens.push_back(scene_of_question(trial, page, felt));
    }
  }

  std::vector<ParticipantScene> screens{};

 private:
  void add_surface(const Trial& trial, ParticipantScene scene) {
    add_guide(scene, exploration_of(protocol_, trial), protocol_);
    screens.push_back(std::move(scene));
  }

  const Protocol& protocol_;
  const Plan& plan_;
};

/// Of the participant; empty without groups. All trials of a plan have the level of its group.
QString group_of(const Protocol& protocol, const Plan& plan) {
  if (!protocol.groups || plan.trials.empty()) return {};
  return text(text_of(plan.trials.front().factors.at(protocol.groups->factor)));
}

}  // namespace

std::vector<ParticipantScene> screens_of(const Protocol& protocol, const Plan& plan,
                                         std::size_t step) {
  ScreensOfStep found(protocol, plan);
  std::visit(found, plan.steps.at(step));
  for (ParticipantScene& screen : found.screens) screen.language = protocol.language;
  return std::move(found.screens);
}

ScreenPreview::ScreenPreview(std::filesystem::path study, QWidget* parent)
    : QWidget(parent), study_(std::move(study)) {
  layout_ = new QVBoxLayout(this);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(kGrid);
  row_ = new QHBoxLayout();
  back_ = make_button(tr("← Back"), ButtonRole::plain, this);
  back_->setObjectName("screen_back");
  next_ = make_button(tr("Next →"), ButtonRole::plain, this);
  next_->setObjectName("screen_next");
  // In one line, so that the buttons stay in their place from step to step.
  words_ = new FittedLabel(this);
  words_->setObjectName("screen_words");
  words_->setProperty("role", "muted");
  words_->set_smaller_font(text_font(TextSize::small));
  row_->addWidget(back_);
  row_->addStretch(1);
  row_->addWidget(next_);
  layout_->addLayout(row_);
  layout_->addWidget(words_);
  connect(back_, &QPushButton::clicked, this, [this] { turn(-1); });
  connect(next_, &QPushButton::clicked, this, [this] { turn(1); });
}

void ScreenPreview::add_group_choice(QWidget* choice) {
  row_->insertWidget(1, choice);
  has_group_choice_ = true;
}

ScreenPreview::~ScreenPreview() { delete view_; }  // before its monitor

/// A view for another protocol: pictures are in colours or in grey from the beginning.
void ScreenPreview::make_view() {
  delete view_;
  monitor_ = std::make_unique<SessionMonitor>();
  SessionFacts facts{};
  facts.protocol = protocol_;
  facts.plan = plan_;
  facts.study_folder = study_.string();
  monitor_->set_facts(std::move(facts));
  view_ = new ParticipantView(*monitor_, study_, ParticipantView::Role::mirror, this);
  view_->setObjectName("screen_view");
  view_->setAccessibleName(tr("The participant's screen"));
  view_->setMinimumHeight(kSmallestHeight);
  layout_->insertWidget(0, view_, 1);
}

void ScreenPreview::show_step(std::shared_ptr<const Protocol> protocol,
                              std::shared_ptr<const Plan> plan, std::size_t step) {
  // The same screen of the step after a change of the protocol.
  if (step != step_ || protocol_ == nullptr || protocol->name != protocol_->name) screen_ = 0;
  protocol_ = std::move(protocol);
  plan_ = std::move(plan);
  step_ = step;
  is_shown_ = false;
  if (isVisible()) show_wanted();
}

void ScreenPreview::forget() {
  delete std::exchange(view_, nullptr);
  protocol_ = nullptr;
  plan_ = nullptr;
  viewed_ = nullptr;
  screen_ = 0;
  words_->show_text(tr("The plan is being made…"));
  back_->setEnabled(false);
  next_->setEnabled(false);
}

void ScreenPreview::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!is_shown_ && plan_ != nullptr) show_wanted();
}

void ScreenPreview::show_wanted() {
  is_shown_ = true;
  if (viewed_ != plan_) make_view();
  viewed_ = plan_;
  screens_ = screens_of(*protocol_, *plan_, step_);
  if (std::exchange(from_the_end_, false) && !screens_.empty()) screen_ = screens_.size() - 1;
  if (screen_ >= screens_.size()) screen_ = 0;
  show_screen();
}

void ScreenPreview::turn(int by) {
  const auto wanted = static_cast<std::ptrdiff_t>(screen_) + by;
  if (wanted >= 0 && wanted < std::ssize(screens_)) {
    screen_ = static_cast<std::size_t>(wanted);
    show_screen();
  } else {
    from_the_end_ = by < 0;
    emit step_wanted(static_cast<int>(step_) + by);
  }
}

void ScreenPreview::show_screen() {
  const auto steps = static_cast<int>(plan_->steps.size());
  const bool is_last = screen_ + 1 >= screens_.size();
  back_->setEnabled(step_ > 0 || screen_ > 0);
  next_->setEnabled(static_cast<int>(step_) + 1 < steps || !is_last);
  QString words = tr("Step %1 of %2").arg(step_ + 1).arg(steps);
  const QString group = has_group_choice_ ? QString() : group_of(*protocol_, *plan_);
  if (!group.isEmpty()) {
    words = tr("%1, group %2").arg(words, group);
  }
  if (screens_.empty()) {
    words = tr("%1: the participant sees nothing new").arg(words);
  } else if (screens_.size() > 1) {
    words = tr("%1, screen %2 of %3").arg(words).arg(screen_ + 1).arg(screens_.size());
  }
  words_->show_text(words);
  monitor_->show(screens_.empty() ? ParticipantScene{} : screens_[screen_]);
}

}  // namespace asperity

#include "moc_screen_preview.cpp"
