// What is chosen on the page before a session, and what the study says about it.

#include <algorithm>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include "app/gui/look/controls.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/start_page.h"
#include "app/tasks/protocol_files.h"
#include "protocols/plan.h"
#include "results_schema/sha256.h"

namespace asperity {

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

void StartPage::check_again() {
  // Whatever the file says now is what is checked, and shown.
  load(file_);
  check();
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

bool StartPage::needs_consent() const {
  return protocol_ && !protocol_->consent_statement.empty() && !is_virtual() && !resume_;
}

std::optional<std::int64_t> StartPage::resumed_session() const {
  return resume_ ? std::optional(unfinished_->row.id) : std::nullopt;
}

bool StartPage::is_batch() const {
  return is_virtual() && participant_->is_new() && virtual_people_->value() > 1;
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

void StartPage::read_again() {
  list_protocols();
  read_study();
  show_person();
  check_soon();
}

}  // namespace asperity
