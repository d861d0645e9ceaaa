#include "app/gui/start/start_page.h"

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSpinBox>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/sound/noise_check.h"
#include "app/gui/sound/sound_output.h"
#include "app/gui/start/check_list.h"
#include "app/gui/start/consent_card.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/question_form.h"
#include "app/gui/start/setup_card.h"
#include "app/gui/study/shown_text.h"
#include "app/tasks/participant_answers.h"
#include "app/tasks/protocol_files.h"
#include "protocols/plan.h"
#include "results_schema/sha256.h"

namespace asperity {

namespace {

// Somebody who types a label is let finish before everything is looked at.
constexpr int kCheckDelay_ms = 300;
constexpr int kNarrowestForm = 640;
constexpr int kFormWidth = 960;       // longer lines are hard to follow
constexpr int kCheckListWidth = 352;  // at least
constexpr int kFieldWidth = 320;
constexpr int kModeWidth = 160;
constexpr const char* kTall = "min-height: 46px;";
constexpr int kMostReasons = 3;

std::uint64_t new_seed() {
  std::random_device source;
  return (std::uint64_t{source()} << 32U) | source();
}

/// Several sentences as one text: the first few, and how many more there are.
QString text_of_reasons(const std::vector<QString>& reasons) {
  QStringList shown{};
  for (const QString& reason : reasons) {
    if (shown.size() < kMostReasons) shown << reason;
  }
  const int more = static_cast<int>(reasons.size()) - static_cast<int>(shown.size());
  if (more > 0) shown << StartPage::tr("And %n more.", nullptr, more);
  return shown.join(' ');
}

}  // namespace

StartPage::StartPage(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(0, 0, 0, 0);
  page->setSpacing(0);
  band_ = new ModeBand(this);
  page->addWidget(band_);
  auto* body = new QHBoxLayout();
  body->setContentsMargins(kMargin, kMargin, kMargin, 0);
  body->setSpacing(kMargin);

  auto* left_side = new QWidget(this);
  left_side->setMinimumWidth(kNarrowestForm);
  left_side->setMaximumWidth(kFormWidth);
  auto* left = new QVBoxLayout(left_side);
  left->setContentsMargins(0, 0, 0, 0);
  left->setSpacing(kMargin);
  title_ = make_title(tr("Start a session"), this);
  left->addWidget(title_);
  banner_ = new Banner(this);
  left->addWidget(banner_);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  area->viewport()->setAutoFillBackground(false);
  auto* form = new QWidget(area);
  form->setAutoFillBackground(false);
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, kGrid, kMargin);
  column->setSpacing(kMargin);
  make_protocol_card(*column);
  participant_ = new ParticipantCard(form);
  column->addWidget(participant_);
  make_mode_card(*column);
  make_simulation_card(*column);
  consent_ = new ConsentCard(form);
  column->addWidget(consent_);
  setup_ = new SetupCard(form);
  column->addWidget(setup_);
  noise_card_ = make_card(form, noise_layout_);
  noise_layout_->addWidget(make_heading(tr("Masking noise"), form));
  column->addWidget(noise_card_);
  column->addStretch(1);
  area->setWidget(form);
  left->addWidget(area, 1);
  body->addWidget(left_side, 3);

  QVBoxLayout* checks = nullptr;
  QFrame* check_card = make_card(this, checks);
  check_card->setMinimumWidth(kCheckListWidth);
  check_list_ = new CheckList(check_card);
  checks->addWidget(check_list_);
  auto* right = new QVBoxLayout();
  right->setContentsMargins(0, 0, 0, kMargin);
  right->addWidget(check_card);
  body->addLayout(right, 2);
  page->addLayout(body, 1);
  page->addWidget(make_footer());

  check_timer_ = new QTimer(this);
  check_timer_->setSingleShot(true);
  check_timer_->setInterval(kCheckDelay_ms);
  connect_parts();
  list_protocols();
  read_study();
  show_mode();
}

StartPage::~StartPage() = default;

// --- the parts -----------------------------------------------------------------------------------

void StartPage::make_protocol_card(QVBoxLayout& column) {
  QVBoxLayout* layout = nullptr;
  column.addWidget(make_card(this, layout));
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  row->addWidget(make_heading(tr("Protocol"), this), 1);
  protocols_ = new QComboBox(this);
  protocols_->setObjectName("protocols");
  protocols_->setAccessibleName(tr("Protocol"));
  protocols_->setPlaceholderText(tr("Choose"));
  protocols_->setFixedWidth(kFieldWidth);
  ignore_wheel(*protocols_);
  row->addWidget(protocols_);
  layout->addLayout(row);
  protocol_text_ = make_text({}, this);
  protocol_text_->setObjectName("protocol_text");
  layout->addWidget(protocol_text_);
  protocol_state_ = new StateLabel(this);
  protocol_state_->setObjectName("protocol_state");
  layout->addWidget(protocol_state_);
}

void StartPage::make_mode_card(QVBoxLayout& column) {
  QVBoxLayout* layout = nullptr;
  column.addWidget(make_card(this, layout));
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  row->addWidget(make_heading(tr("Mode"), this), 1);
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
  layout->addLayout(row);
  mode_text_ = make_text({}, this, true);
  mode_text_->setObjectName("mode_text");
  layout->addWidget(mode_text_);
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
  auto* row = new QHBoxLayout(footer);
  row->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  row->setSpacing(kMargin);
  reason_ = new StateLabel(footer);
  reason_->setObjectName("start_reason");
  row->addWidget(reason_, 1);
  progress_ = new QProgressBar(footer);
  progress_->setObjectName("simulation_progress");
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(kFieldWidth);
  progress_->hide();
  row->addWidget(progress_);
  cancel_ = make_button(tr("Stop the simulation"), ButtonRole::plain, footer);
  cancel_->setObjectName("simulation_cancel");
  cancel_->hide();
  row->addWidget(cancel_);
  start_ = make_button(tr("Start session"), ButtonRole::primary, footer);
  start_->setObjectName("start");
  start_->setStyleSheet(kTall);
  row->addWidget(start_);
  return footer;
}

void StartPage::connect_parts() {
  connect(protocols_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index >= 0) load(protocols_->itemData(index).toString().toStdString());
  });
  connect(participant_, &ParticipantCard::person_changed, this, [this] {
    consent_->forget();
    setup_->forget_hand();
    resume_ = false;
    show_mode();
  });
  connect(participant_, &ParticipantCard::changed, this, [this] {
    if (protocol_ && participant_->is_new() && !is_virtual()) {
      setup_->suggest_left_hand(uses_left_hand(participant_->new_person(*protocol_)));
    }
    show_start();
  });
  connect(participant_, &ParticipantCard::go_on_wanted, this, [this] { go_on(true); });
  connect(consent_, &ConsentCard::changed, this, &StartPage::show_start);
  connect(setup_, &SetupCard::changed, this, &StartPage::show_start);
  connect(setup_, &SetupCard::screens_changed, this, &StartPage::check_soon);
  connect(check_list_, &CheckList::again_wanted, this, [this] {
    // Whatever the file says now is what is checked, and shown.
    load(file_);
    check();
  });
  connect(start_, &QPushButton::clicked, this, &StartPage::press_start);
  connect(check_timer_, &QTimer::timeout, this, &StartPage::check);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    simulate_task_.cancel();
  });
  connect(&check_task_, &BackgroundTask::finished, this, [this] {
    if (std::exchange(check_outdated_, false)) check();
  });
  connect(&simulate_task_, &BackgroundTask::progressed, this, [this](double fraction) {
    progress_->setValue(static_cast<int>(fraction * progress_->maximum()));
  });
  connect(&simulate_task_, &BackgroundTask::started, this, [this] { emit simulating(true); });
  connect(&simulate_task_, &BackgroundTask::finished, this, [this] {
    emit simulating(false);
    show_start();
  });
  connect(&study_, &OpenStudy::changed, this, [this] {
    stale_ = !isVisible();
    if (!stale_) read_again();
  });
}

// --- what is chosen ------------------------------------------------------------------------------

void StartPage::choose(const std::filesystem::path& protocol,
                       const std::optional<std::string>& participant,
                       std::optional<std::int64_t> session) {
  banner_->hide();
  if (participant) {
    const std::optional<ParticipantRow> person = study_.study().participant(*participant);
    if (person && person->is_virtual) {
      set_mode(SessionMode::simulate);
    } else if (is_virtual()) {
      set_mode(SessionMode::run);
    }
  }
  going_on_.reset();
  load(protocol);
  show_person();
  if (participant) {
    participant_->choose(*participant);
  } else {
    participant_->choose_next();
  }
  if (!session) return;
  going_on_ = session;
  show_person();
  go_on(true);
  if (!resume_) {
    banner_->show_news(
        State::look, tr("The session of %1 cannot go on with this protocol: its text is another "
                        "one than when the session began. Put the earlier text back to go on; what "
                        "follows here is a new session.")
                         .arg(QString::fromStdString(participant.value_or(""))));
  }
}

void StartPage::forget_person() {
  going_on_.reset();
  resume_ = false;
  participant_->choose_next();
}

void StartPage::set_mode(SessionMode mode) {
  mode_ = mode;
  show_mode();
}

void StartPage::list_protocols() {
  const QSignalBlocker silent(protocols_);
  protocols_->clear();
  std::vector<std::filesystem::path> files{};
  std::error_code ignored{};
  for (const auto& entry :
       std::filesystem::directory_iterator(study_.folder() / "protocols", ignored)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (!file_.empty() && std::find(files.begin(), files.end(), file_) == files.end()) {
    files.push_back(file_);
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    protocols_->addItem(QString::fromStdString(file.stem().string()),
                        QString::fromStdString(file.string()));
  }
  protocols_->setCurrentIndex(protocols_->findData(QString::fromStdString(file_.string())));
  if (file_.empty() && files.size() == 1) load(files.front());
  if (file_.empty()) show_protocol();
}

void StartPage::load(const std::filesystem::path& protocol) {
  if (protocol.empty()) return;
  if (file_ != protocol) {
    resume_ = false;
    going_on_.reset();
  }
  file_ = protocol;
  protocol_.reset();
  protocol_sha256_.clear();
  protocol_problem_.clear();
  try {
    protocol_ =
        std::make_shared<const Protocol>(load_protocol(protocol, study_.models(), study_.folder()));
    protocol_sha256_ = sha256_of(protocol_->source);
  } catch (const ProtocolError& error) {
    const Diagnostic& first = error.diagnostics().front();
    const auto more = static_cast<int>(error.diagnostics().size()) - 1;
    protocol_problem_ = tr("This protocol is not valid, line %1: %2.")
                            .arg(first.line)
                            .arg(QString::fromStdString(first.message));
    if (more > 0) protocol_problem_ += ' ' + tr("And %n more.", nullptr, more);
  } catch (const std::exception& error) {
    protocol_problem_ = QString::fromUtf8(error.what());
  }
  const QString file = QString::fromStdString(protocol.string());
  if (protocols_->findData(file) < 0) list_protocols();
  const QSignalBlocker silent(protocols_);
  protocols_->setCurrentIndex(protocols_->findData(file));
  read_study();
  show_protocol();
  show_noise();
  show_mode();
}

void StartPage::go_on(bool wanted) {
  resume_ = wanted && unfinished_.has_value();
  if (resume_) {
    mode_ = unfinished_->row.mode;
    (unfinished_->row.pacing == "stepped" ? fast_ : real_time_)->setChecked(true);
    virtual_people_->setValue(1);
  }
  show_mode();
}

// --- what is shown -------------------------------------------------------------------------------

void StartPage::show_protocol() {
  protocol_state_->setVisible(!protocol_);
  protocol_text_->setVisible(protocol_ != nullptr);
  if (!protocol_) {
    if (protocols_->count() == 0) {
      protocol_state_->set_state(State::stop, tr("The study has no protocol yet: make one on the "
                                                 "Protocols page."));
    } else if (protocol_problem_.isEmpty()) {
      protocol_state_->set_state(State::unknown, tr("Choose what is to be run."));
    } else {
      protocol_state_->set_state(State::stop, protocol_problem_);
    }
    return;
  }
  const PlanCost cost = cost_of(*protocol_, make_plan(*protocol_, {1, 0}));
  const QString title =
      QString::fromStdString(protocol_->title.empty() ? protocol_->name : protocol_->title);
  const QString head =
      tr("%1 · version %2 · SHA-256 %3")
          .arg(text_of_kind(protocol_->kind), QString::fromStdString(protocol_->version),
               QString::fromStdString(short_hash(protocol_sha256_)));
  const QString trials = cost.trials == 1 ? tr("1 trial") : tr("%n trials", nullptr, cost.trials);
  const QString tail =
      tr("%1, about %2 · %3 · %4")
          .arg(trials, text_of_duration(cost.total_s), text_of_vision(protocol_->vision),
               text_of_noise(protocol_->masking_noise));
  protocol_text_->setTextFormat(Qt::RichText);
  protocol_text_->setText(
      QString("<b>%1</b><br>%2<br>%3")
          .arg(title.toHtmlEscaped(), head.toHtmlEscaped(), tail.toHtmlEscaped()));
  participant_->set_questions(protocol_->participant_questions);
  consent_->set_statement(*protocol_);
}

void StartPage::show_noise() {
  const MaskingNoise declared = protocol_ ? declared_noise(*protocol_) : MaskingNoise{};
  if (noise_ != nullptr) {
    const MaskingNoise now = noise_->value();
    if (now.kind == declared.kind && now.declared_dBA == declared.declared_dBA) return;
    delete noise_;
    noise_ = nullptr;
  }
  if (declared.kind == MaskingNoise::Kind::none) return;
  noise_ = new NoiseCheck(declared, noise_card_);
  noise_layout_->addWidget(noise_);
  connect(noise_, &NoiseCheck::changed, this, &StartPage::check_soon);
}

void StartPage::show_mode() {
  (mode_ == SessionMode::run     ? run_
   : mode_ == SessionMode::pilot ? pilot_
                                 : simulate_)
      ->setChecked(true);
  band_->set_mode(mode_);
  for (QPushButton* button : {run_, pilot_, simulate_}) button->setEnabled(!resume_);
  if (resume_) {
    mode_text_->setText(tr("A session goes on in the mode in which it began."));
  } else if (mode_ == SessionMode::run) {
    mode_text_->setText(tr("Study data. Plan and plots show codes in place of names."));
  } else if (mode_ == SessionMode::pilot) {
    mode_text_->setText(tr("A person tries it out. Kept apart from the study's data."));
  } else {
    mode_text_->setText(
        tr("Virtual participants exercise the study. Their answers say nothing "
           "about people."));
  }
  simulation_->setVisible(is_virtual());
  const bool real_time = real_time_->isChecked();
  if (real_time || resume_) {
    const QSignalBlocker silent(virtual_people_);
    virtual_people_->setValue(1);
  }
  virtual_people_->setEnabled(!real_time && !resume_);
  for (QPushButton* button : {fast_, real_time_}) button->setEnabled(!resume_);
  if (resume_) {
    simulation_text_->setText(tr("A simulated session goes on at the speed at which it began."));
  } else if (real_time) {
    simulation_text_->setText(tr("Real time takes one virtual participant at a time."));
  } else if (virtual_people_->value() == 1) {
    simulation_text_->setText(tr("One session, shown while it runs."));
  } else {
    simulation_text_->setText(tr("All of their sessions, in the background."));
  }
  setup_->set_virtual(is_virtual());
  noise_card_->setVisible(noise_ != nullptr && !is_virtual());
  consent_->setVisible(needs_consent());
  show_person();
  check_soon();
}

void StartPage::read_study() {
  people_ = study_.study().participants();
  sessions_.clear();
  rows_used_.clear();
  if (!protocol_) return;
  std::map<std::int64_t, bool> is_this{};
  for (const ProtocolRow& row : study_.study().protocols()) {
    is_this[row.id] = row.source_sha256 == protocol_sha256_;
  }
  for (const SessionRow& row : study_.study().sessions()) {
    sessions_.push_back({row.participant, row.mode, row.state, is_this[row.protocol_id]});
  }
  const int rows = counterbalance_rows(*protocol_);
  for (const SessionMode mode : {SessionMode::run, SessionMode::pilot, SessionMode::simulate}) {
    rows_used_[mode] = study_.study().counterbalance_counts(protocol_->name, rows, mode);
  }
}

void StartPage::show_person() {
  const int several = virtual_people_->value();
  const std::string first = next_virtual_label(people_);
  participant_->set_virtual(
      is_virtual(), several == 1
                        ? tr("The program names virtual participants; the next one is %1.")
                              .arg(QString::fromStdString(first))
                        : tr("The program names virtual participants; the next %n begin with %1.",
                             nullptr, several)
                              .arg(QString::fromStdString(first)));
  participant_->set_people(people_);
  const std::optional<ParticipantRow> known = participant_->known();
  unfinished_.reset();
  if (known && protocol_) {
    unfinished_ = unfinished_session(study_.study(), *protocol_, known->label, going_on_);
  }
  if (!unfinished_) resume_ = false;
  // Somebody came here to go on with it: no reading of the study in between makes it a new session.
  if (unfinished_ && !resume_ && going_on_) return go_on(true);
  participant_->set_unfinished(unfinished_, resume_);
  participant_->set_session_text(session_text());
  if (resume_) {
    setup_->fix_hand(unfinished_->row.mirrored);
  } else {
    setup_->free_hand();
    if (known) setup_->suggest_left_hand(uses_left_hand(*known));
  }
  consent_->setVisible(needs_consent());
  title_->setText(resume_ ? tr("Go on with a session") : tr("Start a session"));
  show_start();
}

QString StartPage::session_text() const {
  if (!protocol_ || is_batch() || resume_) return {};
  int sessions = 0;
  int of_this = 0;
  const std::string label = participant_->label();
  for (const SessionBefore& session : sessions_) {
    if (participant_->is_new() || session.participant != label) continue;
    ++sessions;
    if (session.of_this_protocol && session.mode == mode_ &&
        session.state == SessionState::completed) {
      ++of_this;
    }
  }
  const QString number = tr("This is session %1 of this participant; %2 of %3 planned ones of this "
                            "protocol are done.")
                             .arg(sessions + 1)
                             .arg(of_this)
                             .arg(protocol_->sessions);
  const std::vector<int>& used = rows_used_.at(mode_);
  const auto rows = static_cast<int>(used.size());
  if (rows <= 1) return tr("%1 No counterbalancing.").arg(number);
  const auto least = std::min_element(used.begin(), used.end()) - used.begin();
  return tr("%1 Counterbalancing row %2 of %3, the least used one.")
      .arg(number)
      .arg(least + 1)
      .arg(rows);
}

void StartPage::show_start() {
  const bool simulating = simulate_task_.is_running();
  progress_->setVisible(simulating);
  cancel_->setVisible(simulating);
  start_->setVisible(!simulating);
  if (resume_) {
    start_->setText(tr("Go on with session %1").arg(unfinished_->row.session));
  } else {
    start_->setText(is_batch() ? tr("Simulate %n participants", nullptr, virtual_people_->value())
                               : tr("Start session"));
  }
  if (simulating) {
    reason_->set_state(State::unknown, tr("Virtual participants go through their sessions."));
    return;
  }
  const std::vector<QString> why_not = reasons();
  start_->setEnabled(why_not.empty());
  if (why_not.empty()) {
    reason_->set_state(State::fine, tr("Ready."));
  } else {
    const bool only_waiting = !checks_ && why_not.size() == 1;
    reason_->set_state(only_waiting ? State::unknown : State::look, text_of_reasons(why_not));
  }
  QStringList all{};
  for (const QString& reason : why_not) all << reason;
  reason_->setToolTip(all.join('\n'));
}

// --- whether it can start ------------------------------------------------------------------------

bool StartPage::needs_consent() const {
  return protocol_ && !protocol_->consent_statement.empty() && !is_virtual() && !resume_;
}

std::optional<std::int64_t> StartPage::resumed_session() const {
  return resume_ ? std::optional(unfinished_->row.id) : std::nullopt;
}

bool StartPage::is_batch() const {
  return is_virtual() && participant_->is_new() && virtual_people_->value() > 1;
}

MaskingNoise StartPage::noise() const {
  return noise_ != nullptr && !is_virtual() ? noise_->value() : MaskingNoise{};
}

std::vector<QString> StartPage::reasons() const {
  if (!protocol_) {
    return {protocol_problem_.isEmpty() ? tr("No protocol is chosen.")
                                        : tr("The protocol is not valid.")};
  }
  std::vector<QString> reasons = participant_->complaints();
  if (needs_consent()) {
    for (QString& complaint : consent_->complaints()) reasons.push_back(std::move(complaint));
  }
  if (!checks_) {
    reasons.push_back(tr("The checklist is being gone through."));
    return reasons;
  }
  for (const SessionCheck& check : *checks_) {
    if (check.state != SessionCheck::State::stop) continue;
    // Said above already, in the words of the form.
    if (check.id == "participant" && !participant_->complaints().empty()) continue;
    reasons.push_back(
        tr("%1: %2").arg(CheckList::title_of(check), QString::fromStdString(check.text)));
  }
  return reasons;
}

void StartPage::read_again() {
  list_protocols();
  read_study();
  show_person();
  check_soon();
}

void StartPage::check_soon() {
  checks_.reset();
  show_start();
  if (isVisible()) check_timer_->start();
}

void StartPage::check() {
  check_timer_->stop();
  checks_.reset();
  if (file_.empty() || !isVisible()) return;
  if (check_task_.is_running()) {
    // The loop that it tries runs for a while yet: nobody waits for it here.
    check_task_.cancel();
    check_outdated_ = true;
    return;
  }
  const CheckInputs inputs{
      .study = study_.folder(),
      .protocol = file_,
      .protocol_sha256 = protocol_sha256_,
      .participant = participant_->label(),
      .mode = mode_,
      .resume = resume_,
      .resumed_session = resumed_session(),
      .pacing = order().inputs.pacing,
      .noise = noise(),
      .sound_card = !sound_outputs().empty(),
      .screens = static_cast<int>(QGuiApplication::screens().size()),
  };
  check_list_->set_running(true);
  check_task_.run<std::vector<SessionCheck>>(
      [inputs, models = built_in_models()](const std::stop_token& stop,
                                           const BackgroundTask::Progress&) {
        return check_session(inputs, models, stop);
      },
      [this](std::vector<SessionCheck> checks) {
        if (check_outdated_ || check_timer_->isActive() || !isVisible()) return;
        check_list_->set_running(false);
        check_list_->set_checks(checks);
        checks_ = std::move(checks);
        show_start();
      },
      [this](const QString& what) {
        check_list_->set_running(false);
        banner_->show_news(State::stop, what);
      });
  show_start();
}

SessionOrder StartPage::order() const {
  SessionOrder order{};
  RunInputs& inputs = order.inputs;
  inputs.protocol = file_;
  inputs.study = study_.folder();
  inputs.participant = participant_->label();
  inputs.seed = new_seed();
  inputs.mode = mode_;
  inputs.resume = resume_;
  inputs.resumed_session = resumed_session();
  inputs.is_virtual = is_virtual();
  inputs.pacing = is_virtual() && fast_->isChecked() ? RunPacing::stepped : RunPacing::real_time;
  inputs.mirrored = setup_->is_mirrored();
  if (protocol_ && !is_virtual() && participant_->is_new()) {
    inputs.new_person = participant_->new_person(*protocol_);
  }
  if (needs_consent()) {
    inputs.has_consented = consent_->is_given();
    order.consent_seen_by = consent_->seen_by();
  }
  order.noise = noise();
  order.own_keyboard = setup_->own_keyboard();
  order.participant_screen = setup_->participant_screen();
  if (protocol_) {
    for (const auto& [cue, path] : protocol_->speech) order.speech[cue] = study_.folder() / path;
  }
  order.protocol_sha256 = protocol_sha256_;
  return order;
}

void StartPage::press_start() {
  if (!reasons().empty()) return;
  if (is_batch()) {
    simulate_several();
    return;
  }
  // What was found holds for one start: the next one looks again.
  const SessionOrder ordered = order();
  checks_.reset();
  show_start();
  emit start_wanted(ordered);
}

void StartPage::simulate_several() {
  SimulationInputs inputs{};
  inputs.protocols = {file_};
  inputs.study = study_.folder();
  inputs.participants = virtual_people_->value();
  inputs.seed = new_seed();
  inputs.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency() / 2));
  auto answers = std::make_shared<std::atomic<int>>(0);
  progress_->setValue(0);
  cancel_->setEnabled(true);
  simulate_task_.run<SimulationResult>(
      [inputs, answers, models = built_in_models()](const std::stop_token& stop,
                                                    const BackgroundTask::Progress& progress) {
        return simulate(inputs, models, stop, progress,
                        [answers](const AttemptDone&) { ++*answers; });
      },
      [this](const SimulationResult& result) {
        banner_->show_news(State::fine,
                           tr("%1 sessions, %2 answers: look at the table.")
                               .arg(result.sessions)
                               .arg(result.attempts),
                           tr("Show the sessions"), [this] { emit sessions_wanted(); });
        study_.announce_change();
      },
      [this, answers](const QString& what) {
        if (cancel_->isEnabled()) {
          banner_->show_news(State::stop, what);
        } else {
          banner_->show_news(State::look,
                             tr("The simulation was stopped. Trials that are finished and stored: "
                                "%1.")
                                 .arg(*answers));
        }
        study_.announce_change();
      });
  show_start();
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setProperty("keep",
              tr("Theme and language are changed from another page: what is filled in for a "
                 "session would be lost."));
  if (std::exchange(stale_, false)) {
    read_again();
  } else {
    check_soon();
  }
}

void StartPage::hideEvent(QHideEvent* event) {
  check_timer_->stop();
  check_task_.cancel();
  setProperty("keep", {});
  QWidget::hideEvent(event);
}

}  // namespace asperity
