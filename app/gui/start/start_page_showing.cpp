// How the page before a session shows what is chosen.

#include <algorithm>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QSpinBox>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/sound/noise_check.h"
#include "app/gui/start/consent_card.h"
#include "app/gui/start/device_chooser.h"
#include "app/gui/start/group_chooser.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/program_chooser.h"
#include "app/gui/start/setup_card.h"
#include "app/gui/start/start_page.h"
#include "app/records/participant_answers.h"
#include "app/tasks/checks/noise_check.h"
#include "app/tasks/checks/protocol_check.h"
#include "protocols/plan/groups.h"
#include "results_schema/hashes/short_hash.h"

namespace asperity {

namespace {

constexpr int kMostReasons = 2;  // the room beside Start does not grow

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

/// What is wrong with a file that was read.
QString text_of_problem(const ChosenProtocol& chosen) {
  if (chosen.problems.empty()) return QString::fromStdString(chosen.failure);
  const Diagnostic& first = chosen.problems.front();
  if (first.line == 0) return words_of(first.message);  // it could not be read
  const auto more = static_cast<int>(chosen.problems.size()) - 1;
  QString text =
      StartPage::tr("This protocol is not valid. %1.")
          .arg(remark_in_form(nlohmann::json::parse(chosen.text, nullptr, false), first));
  if (more > 0) text += ' ' + StartPage::tr("And %n more.", nullptr, more);
  return text;
}

}  // namespace

void StartPage::show_protocol() {
  const ChosenProtocol& now = facts_.chosen;
  setup_->device().set_protocol(now.protocol);
  // What stands there of the one before is grey for a moment rather than gone and back.
  protocol_text_->setEnabled(now.is_read());
  if (!is_read_ && !now.is_read()) {
    if (protocol_text_->text().isEmpty()) {
      protocol_state_->set_state(State::unknown, tr("The study is being read."));
    }
    return;
  }
  const Protocol* protocol = chosen();
  protocol_state_->setVisible(protocol == nullptr);
  protocol_text_->setVisible(protocol != nullptr);
  if (protocol == nullptr) {
    if (protocols_->count() == 0) {
      protocol_state_->set_state(
          State::stop, tr("The study has no protocol yet: create one on the Protocols page."));
    } else if (now.is_read()) {
      protocol_state_->set_state(State::stop, text_of_problem(now));
    } else {
      protocol_state_->set_state(State::unknown, tr("Choose a protocol."));
    }
    return;
  }
  const PlanCost& cost = now.cost;
  const QString title =
      QString::fromStdString(protocol->title.empty() ? protocol->name : protocol->title);
  const QString head =
      tr("%1 · version %2 · SHA-256 %3")
          .arg(text_of_kind(protocol->kind), QString::fromStdString(protocol->version),
               QString::fromStdString(short_hash(now.sha256)));
  QString trials = cost.trials == 1 ? tr("1 trial") : tr("%n trials", nullptr, cost.trials);
  if (is_length_estimated(*protocol)) trials = tr("about %1").arg(trials);
  const QString tail =
      tr("%1, about %2 · %3 · %4")
          .arg(trials, text_of_duration(cost.total_s), text_of_vision(protocol->vision),
               text_of_noise(protocol->masking_noise));
  protocol_text_->setTextFormat(Qt::RichText);
  protocol_text_->setText(
      QString("<b>%1</b><br>%2<br>%3")
          .arg(title.toHtmlEscaped(),
               QString("%1 · %2").arg(QString::fromStdString(protocol->name), head).toHtmlEscaped(),
               tail.toHtmlEscaped()));
  participant_->set_questions(questions_about_participant(*protocol));
  consent_->set_statement(QString::fromStdString(now.consent),
                          QString::fromStdString(protocol->consent_version));
}

void StartPage::show_noise() {
  const MaskingNoise declared = chosen() != nullptr ? declared_noise(*chosen()) : MaskingNoise{};
  if (noise_ != nullptr) {
    const MaskingNoise now = noise_->value();
    if (now.kind == declared.kind && now.declared_dBA == declared.declared_dBA) return;
    delete noise_;
    noise_ = nullptr;
  }
  if (declared.kind != MaskingNoise::Kind::none) make_noise_check(declared);
}

void StartPage::make_noise_check(const MaskingNoise& noise) {
  delete noise_;
  noise_ = new NoiseCheck(noise, noise_card_);
  noise_layout_->addWidget(noise_);
  // What is made later comes last otherwise, wherever it stands.
  QWidget* before = setup_;
  for (QWidget* const card : std::initializer_list<QWidget*>{setup_, noise_}) {
    for (QWidget* const control : card->findChildren<QWidget*>()) {
      if ((control->focusPolicy() & Qt::TabFocus) != Qt::TabFocus) continue;
      if (card == noise_) setTabOrder(before, control);
      before = control;
    }
  }
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
    mode_text_->setText(tr("A session is resumed in the mode in which it began."));
  } else if (mode_ == SessionMode::run) {
    mode_text_->setText(tr("Study data. Plan and plots show codes in place of names."));
  } else if (mode_ == SessionMode::pilot) {
    mode_text_->setText(
        tr("A test of the experiment with a participant. Stored separately from the study data."));
  } else {
    mode_text_->setText(
        tr("Virtual participants test the study. Their responses are not data about human "
           "perception."));
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
    simulation_text_->setText(tr("A simulated session is resumed at the speed at which it began."));
  } else if (real_time) {
    simulation_text_->setText(
        tr("In real time, only one virtual participant can be simulated at a time."));
  } else if (virtual_people_->value() == 1) {
    simulation_text_->setText(tr("One session, shown while it runs."));
  } else {
    simulation_text_->setText(tr("All sessions, run in the background."));
  }
  setup_->set_virtual(is_virtual());
  setup_->device().set_for(!is_virtual() ? DeviceChooser::For::people
                           : is_batch()  ? DeviceChooser::For::virtual_participants
                                         : DeviceChooser::For::virtual_participant);
  noise_card_->setVisible(noise_ != nullptr && !is_virtual());
  consent_->setVisible(needs_consent());
  show_person();
  check_soon();
}

void StartPage::show_person() {
  const int several = virtual_people_->value();
  const std::string first = next_virtual_label(facts_.people);
  participant_->set_virtual(
      is_virtual(),
      several == 1
          ? tr("The program assigns the labels of virtual participants; the next one is %1.")
                .arg(QString::fromStdString(first))
          : tr("The program assigns the labels of virtual participants; the first of the next %n "
               "is %1.",
               nullptr, several)
                .arg(QString::fromStdString(first)));
  participant_->set_people(facts_.people);
  const std::optional<ParticipantRow> known = participant_->known();
  unfinished_.reset();
  if (known) unfinished_ = unfinished_of(facts_.unfinished, known->label, going_on_);
  if (!unfinished_) resume_ = false;
  // Somebody came here to go on with it: no reading of the study in between makes it a new session.
  if (unfinished_ && !resume_ && going_on_) return go_on(true);
  participant_->set_unfinished(unfinished_, resume_);
  participant_->ask_late_reason(resume_ && unfinished_->late.has_value());
  if (is_read_) {
    // A session whose levels are all stored is resumed without a program.
    const bool takes_levels = !resume_ || unfinished_->lacks_levels;
    program_->set_protocol(takes_levels ? facts_.chosen.protocol : nullptr);
  }
  participant_->group().set_groups(groups_to_choose());
  keep_language();
  participant_->set_session_text(session_text());
  if (resume_) {
    setup_->fix_hand(unfinished_->row.mirrored);
  } else {
    setup_->free_hand();
    if (known) setup_->suggest_left_hand(uses_left_hand(*known));
  }
  consent_->setVisible(needs_consent());
  title_->setText(resume_ ? tr("Resume a session") : tr("Start a session"));
  show_start();
}

QString StartPage::session_text() const {
  const Protocol* protocol = chosen();
  if (protocol == nullptr || is_batch() || resume_) return {};
  int sessions = 0;
  int of_this = 0;
  const std::string label = participant_->label();
  for (const StartFacts::SessionBefore& session : facts_.sessions) {
    if (participant_->is_new() || session.participant != label) continue;
    ++sessions;
    if (session.of_this_protocol && session.mode == mode_ &&
        session.state == SessionState::completed) {
      ++of_this;
    }
  }
  const QString number =
      tr("Session %1 of this participant; sessions of this protocol completed: %2 "
         "of %3.")
          .arg(sessions + 1)
          .arg(of_this)
          .arg(protocol->sessions);
  if (protocol->groups) {
    if (const std::optional<std::string> group = group_before()) {
      return tr("%1 Group %2, as before.").arg(number, QString::fromStdString(*group));
    }
    if (protocol->groups->assigned != Protocol::Groups::Assignment::by_experimenter) {
      return tr("%1 The program assigns the group.").arg(number);
    }
    return number;
  }
  const std::vector<int>& used = facts_.rows_used.at(mode_);
  const auto rows = static_cast<int>(used.size());
  if (rows <= 1) return tr("%1 No counterbalancing.").arg(number);
  if (facts_.has_dealt_places && mode_ == SessionMode::run) {
    return tr("%1 Counterbalancing row of the participant's place among those dealt to this study.")
        .arg(number);
  }
  const auto least = std::min_element(used.begin(), used.end()) - used.begin();
  return tr("%1 Counterbalancing row %2 of %3, the least used one.")
      .arg(number)
      .arg(least + 1)
      .arg(rows);
}

std::optional<std::string> StartPage::group_before() const {
  const std::string label = participant_->label();
  for (const StartFacts::SessionBefore& session : facts_.sessions) {
    if (participant_->is_new() || session.participant != label || session.mode != mode_) continue;
    if (session.group) return session.group;
  }
  return {};
}

std::vector<std::string> StartPage::groups_to_choose() const {
  const Protocol* protocol = chosen();
  if (protocol == nullptr || !protocol->groups || is_batch() || resume_ || group_before() ||
      protocol->groups->assigned != Protocol::Groups::Assignment::by_experimenter) {
    return {};
  }
  return groups_of(*protocol);
}

void StartPage::set_simulating(bool now) {
  is_simulating_ = now;
  show_start();
}

void StartPage::show_start() {
  if (resume_) {
    start_->setText(tr("Resume session %1").arg(unfinished_->row.session));
  } else {
    start_->setText(is_batch() ? tr("Simulate %n participants", nullptr, virtual_people_->value())
                               : tr("Start session"));
  }
  commands_->setEnabled(chosen() != nullptr);
  if (is_simulating_) {
    start_->setEnabled(false);
    reason_->set_state(State::unknown,
                       tr("The sessions of virtual participants are being simulated."));
    return;
  }
  const std::vector<QString> why_not = reasons();
  start_->setEnabled(why_not.empty());
  if (why_not.empty()) {
    reason_->set_state(State::fine, tr("Ready."));
  } else {
    const bool only_waiting =
        !checks_ && !check_cancelled_ && why_not.size() == 1 && !read_has_failed();
    reason_->set_state(only_waiting ? State::unknown : State::look, text_of_reasons(why_not));
  }
  QStringList all{};
  for (const QString& reason : why_not) all << reason;
  reason_->setToolTip(all.join('\n'));
}

}  // namespace asperity
