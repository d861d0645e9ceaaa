// Builds the cards, and repeats the checklist after a pause when one of them changes.

#include "app/gui/start/start_page.h"

#include <any>

#include <QtCore/QTimer>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/question_form.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/start/check_list.h"
#include "app/gui/start/consent_card.h"
#include "app/gui/start/device_chooser.h"
#include "app/gui/start/group_chooser.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/program_chooser.h"
#include "app/gui/start/setup_card.h"
#include "app/records/participant_answers.h"

namespace asperity {

namespace {

// Somebody who types a label is let finish before everything is looked at.
constexpr int kCheckDelay_ms = 300;
constexpr const char* kPage = "start";
constexpr int kNarrowestForm = 648;
constexpr int kFormWidth = 960;       // longer lines are hard to follow
constexpr int kCheckListWidth = 328;  // at least
constexpr int kChoiceWidth = 320;
constexpr int kModeWidth = 160;
constexpr int kLanguageWidth = 240;
constexpr const char* kTall = "min-height: 46px;";
constexpr int kFooterHeight = 80;  // whatever the reason says

}  // namespace

StartPage::StartPage(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(0, 0, 0, 0);
  page->setSpacing(0);
  band_ = new ModeBand(this);
  // Its room is there in a run as well: whoever chooses a mode sees nothing move.
  QSizePolicy steady = band_->sizePolicy();
  steady.setRetainSizeWhenHidden(true);
  band_->setSizePolicy(steady);
  page->addWidget(band_);
  auto* below = new QVBoxLayout();
  below->setContentsMargins(kMargin, kGrid, kMargin, 0);
  below->setSpacing(kMargin);
  page->addLayout(below, 1);
  make_head(*below);
  banner_ = new Banner(this);
  below->addWidget(banner_);
  auto* body = new QHBoxLayout();
  body->setSpacing(kMargin);
  below->addLayout(body, 1);

  area_ = new QScrollArea(this);
  area_->setObjectName("start_form");
  area_->setMinimumWidth(kNarrowestForm);
  area_->setMaximumWidth(kFormWidth);
  area_->setWidgetResizable(true);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->viewport()->setAutoFillBackground(false);
  form_ = new QWidget(area_);
  form_->setAutoFillBackground(false);
  auto* column = new QVBoxLayout(form_);
  column->setContentsMargins(0, 0, kGrid, kMargin);
  column->setSpacing(kMargin);
  make_protocol_card(*column);
  participant_ = new ParticipantCard(form_);
  column->addWidget(participant_);
  make_simulation_card(*column);
  consent_ = new ConsentCard(form_);
  column->addWidget(consent_);
  program_ = new ProgramChooser(form_);
  column->addWidget(program_);
  setup_ = new SetupCard(study_, form_);
  column->addWidget(setup_);
  noise_card_ = make_card(form_, noise_layout_);
  noise_layout_->addWidget(make_heading(tr("Masking noise"), form_));
  column->addWidget(noise_card_);
  column->addStretch(1);
  area_->setWidget(form_);
  body->addWidget(area_, 3);

  QVBoxLayout* checks = nullptr;
  QFrame* check_card = make_card(this, checks);
  check_card->setMinimumWidth(kCheckListWidth);
  check_list_ = new CheckList(check_card);
  checks->addWidget(check_list_);
  auto* right = new QVBoxLayout();
  right->setContentsMargins(0, 0, 0, kMargin);
  right->addWidget(check_card);
  body->addLayout(right, 2);
  page->addWidget(make_footer());

  check_timer_ = new QTimer(this);
  check_timer_->setSingleShot(true);
  check_timer_->setInterval(kCheckDelay_ms);
  connect_parts();
  const std::any before = study_.take_left(kPage);
  if (const auto* done = std::any_cast<Left>(&before)) {
    facts_.chosen.file = done->protocol;
    mode_ = done->mode;
    wish_ = done->wish;
    form_->setEnabled(false);
  }
  show_mode();
}

StartPage::~StartPage() {
  if (facts_.chosen.file.empty()) return;
  study_.leave(kPage, Left{.protocol = facts_.chosen.file,
                           .mode = mode_,
                           .wish = wish_ ? *wish_ : Wish{.draft = draft()}});
}

void StartPage::make_protocol_card(QVBoxLayout& column) {
  QVBoxLayout* layout = nullptr;
  column.addWidget(make_card(this, layout));
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  row->addWidget(make_heading(tr("Protocol"), this));
  protocols_ = new ChoiceBox(this);
  protocols_->setObjectName("protocols");
  protocols_->setAccessibleName(tr("Protocol"));
  protocols_->setPlaceholderText(tr("Choose"));
  // Titles are long; the page does not grow with them.
  protocols_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  protocols_->setMinimumWidth(kChoiceWidth);
  ignore_wheel(*protocols_);
  row->addWidget(protocols_, 1);
  layout->addLayout(row);
  languages_row_ = new QWidget(this);
  auto* languages = new QHBoxLayout(languages_row_);
  languages->setContentsMargins(0, 0, 0, 0);
  languages->setSpacing(kMargin);
  languages_ = new ChoiceBox(this);
  languages_->setObjectName("languages");
  languages_->setMinimumWidth(kLanguageWidth);
  ignore_wheel(*languages_);
  QLabel* language_label = make_text(tr("Language of the participant"), languages_row_);
  language_label->setBuddy(languages_);
  languages->addWidget(language_label, 1);
  languages->addWidget(languages_);
  languages_row_->hide();
  layout->addWidget(languages_row_);
  protocol_text_ = make_text({}, this);
  protocol_text_->setObjectName("protocol_text");
  protocol_text_->hide();
  layout->addWidget(protocol_text_);
  protocol_state_ = new StateLabel(this);
  protocol_state_->setObjectName("protocol_state");
  layout->addWidget(protocol_state_);
}

// The mode stands above what scrolls: it decides about most of what there is to fill in.
void StartPage::make_head(QVBoxLayout& page) {
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  title_ = make_title(tr("Start a session"), this);
  row->addWidget(title_, 1);
  auto* modes = new QButtonGroup(this);
  const auto add = [&](const QString& text, const QString& name, SessionMode mode) {
    QPushButton* button = make_button(text, ButtonRole::selector, this);
    button->setObjectName(name);
    button->setFont(text_font(TextSize::heading));
    button->setMinimumWidth(kModeWidth);
    button->setStyleSheet(kTall);
    modes->addButton(button);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, mode] { set_mode(mode); });
    return button;
  };
  run_ = add(tr("Run"), "mode_run", SessionMode::run);
  pilot_ = add(tr("Pilot"), "mode_pilot", SessionMode::pilot);
  simulate_ = add(tr("Simulate"), "mode_simulate", SessionMode::simulate);
  page.addLayout(row);
  mode_text_ = make_text({}, this, true);
  mode_text_->setObjectName("mode_text");
  mode_text_->setWordWrap(false);  // one line for every mode
  page.addSpacing(kGrid - kMargin);
  page.addWidget(mode_text_);
}

void StartPage::make_simulation_card(QVBoxLayout& column) {
  QVBoxLayout* layout = nullptr;
  simulation_ = make_card(this, layout);
  layout->addWidget(make_heading(tr("Simulation"), simulation_));
  auto* people = new QHBoxLayout();
  people->setSpacing(kMargin);
  virtual_people_ = new QSpinBox(simulation_);
  virtual_people_->setObjectName("virtual_participants");
  virtual_people_->setRange(1, 9999);
  virtual_people_->setAlignment(Qt::AlignRight);
  virtual_people_->setFixedWidth(kModeWidth);
  ignore_wheel(*virtual_people_);
  QLabel* people_label = make_text(tr("Virtual participants"), simulation_);
  people_label->setBuddy(virtual_people_);
  people->addWidget(people_label, 1);
  people->addWidget(virtual_people_);
  layout->addLayout(people);
  auto* speed = new QHBoxLayout();
  speed->setSpacing(kGrid);
  speed->addWidget(make_text(tr("Speed"), simulation_), 1);
  auto* speeds = new QButtonGroup(this);
  fast_ = make_button(tr("As fast as possible"), ButtonRole::selector, simulation_);
  fast_->setObjectName("speed_fast");
  real_time_ = make_button(tr("Real time"), ButtonRole::selector, simulation_);
  real_time_->setObjectName("speed_real_time");
  speeds->addButton(fast_);
  speeds->addButton(real_time_);
  fast_->setChecked(true);
  speed->addWidget(fast_);
  speed->addWidget(real_time_);
  layout->addLayout(speed);
  simulation_text_ = make_text({}, simulation_, true);
  simulation_text_->setObjectName("simulation_text");
  layout->addWidget(simulation_text_);
  column.addWidget(simulation_);
  connect(virtual_people_, &QSpinBox::valueChanged, this, [this] { show_mode(); });
  connect(speeds, &QButtonGroup::buttonClicked, this, [this] { show_mode(); });
}

QWidget* StartPage::make_footer() {
  auto* footer = new QFrame(this);
  footer->setObjectName("start_footer");
  footer->setStyleSheet(QString("#start_footer { background: %1; border-top: 1px solid %2; }")
                            .arg(theme().panel.name(), theme().line.name()));
  footer->setFixedHeight(kFooterHeight);
  auto* row = new QHBoxLayout(footer);
  row->setContentsMargins(kMargin, 0, kMargin, 0);
  row->setSpacing(kMargin);
  reason_ = new StateLabel(footer);
  reason_->setObjectName("start_reason");
  row->addWidget(reason_, 1);
  commands_ = make_commands_button([this] { return commands(); }, footer);
  row->addWidget(commands_);
  start_ = make_button(tr("Start session"), ButtonRole::primary, footer);
  start_->setObjectName("start");
  start_->setStyleSheet(kTall);
  row->addWidget(start_);
  return footer;
}

void StartPage::connect_parts() {
  connect(protocols_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index < 0) return;
    chosen_by_experimenter_.reset();
    pick(protocols_->itemData(index).toString().toStdString());
  });
  connect(languages_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index < 0) return;
    chosen_by_experimenter_.reset();
    pick(languages_->itemData(index).toString().toStdString());
  });
  connect(participant_, &ParticipantCard::person_changed, this, [this] {
    consent_->forget();
    setup_->forget_hand();
    participant_->group().choose({});
    resume_ = false;
    going_on_.reset();
    show_mode();
  });
  connect(participant_, &ParticipantCard::changed, this, [this] {
    if (chosen() != nullptr && participant_->is_new() && !is_virtual()) {
      setup_->suggest_left_hand(uses_left_hand(participant_->new_person(*chosen())));
    }
    show_start();
  });
  connect(participant_, &ParticipantCard::go_on_wanted, this, [this] { go_on(true); });
  connect(participant_, &ParticipantCard::late_reason_changed, this, &StartPage::check_soon);
  connect(consent_, &ConsentCard::changed, this, &StartPage::show_start);
  connect(program_, &ProgramChooser::changed, this, &StartPage::show_start);
  connect(setup_, &SetupCard::changed, this, &StartPage::show_start);
  connect(setup_, &SetupCard::screens_changed, this, &StartPage::check_soon);
  connect(&setup_->device(), &DeviceChooser::changed, this, [this] {
    // A page that is made anew would wait for it.
    setProperty("keep", setup_->device().is_trying()
                            ? tr("A device is being tried: wait for the result.")
                            : QString());
    check_soon();
  });
  connect(&check_task_, &BackgroundTask::progressed, this, [this](double fraction) {
    if (!checks_ && !check_outdated_) check_list_->set_progress(fraction);
  });
  connect(check_list_, &CheckList::again_wanted, this, &StartPage::check_again);
  connect(check_list_, &CheckList::cancel_wanted, this, [this] {
    check_cancelled_ = true;
    check_task_.cancel();
  });
  connect(start_, &QPushButton::clicked, this, &StartPage::press_start);
  connect(check_timer_, &QTimer::timeout, this, &StartPage::check);
  connect(&check_task_, &BackgroundTask::finished, this, [this] {
    if (std::exchange(check_outdated_, false)) check();
  });
  connect(&study_, &OpenStudy::changed, this, [this] {
    stale_ = !isVisible();
    if (!stale_) read();
  });
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setup_->device().look_once();
  if (stale_) {
    read();
  } else {
    check_soon();
  }
}

void StartPage::hideEvent(QHideEvent* event) {
  check_timer_->stop();
  check_task_.cancel();
  study_.examiner().withdraw(this);
  QWidget::hideEvent(event);
}

}  // namespace asperity

#include "moc_start_page.cpp"
