// What is chosen on the page before a session, and what the study says about it.

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtCore/QTimer>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/sound/noise_check.h"
#include "app/gui/start/consent_card.h"
#include "app/gui/start/participant_card.h"
#include "app/gui/start/program_chooser.h"
#include "app/gui/start/setup_card.h"
#include "app/gui/start/start_page.h"

namespace asperity {

void StartPage::choose(const std::filesystem::path& protocol,
                       const std::optional<std::string>& participant,
                       std::optional<std::int64_t> session) {
  banner_->hide();
  chosen_by_experimenter_.reset();
  going_on_.reset();
  resume_ = false;
  wish_ = Wish{participant, session};
  form_->setEnabled(false);
  pick(protocol);
}

void StartPage::pick(const std::filesystem::path& protocol) {
  if (protocol.empty()) return;
  if (facts_.chosen.file != protocol) {
    resume_ = false;
    going_on_.reset();
  }
  facts_.chosen = {.file = protocol};
  read();
}

void StartPage::read() {
  stale_ = false;
  is_read_ = false;
  forget_checks();
  check_timer_->stop();
  read_task_.run<StartFacts>(
      [folder = study_.folder(), chosen = facts_.chosen, &models = study_.models()](
          const std::stop_token&, const BackgroundTask::Progress&) {
        return read_start_facts(folder, chosen, models);
      },
      [this](StartFacts facts) { take(std::move(facts)); },
      [this](const QString& what) {
        banner_->show_news(State::stop, tr("The study could not be read: %1").arg(what),
                           tr("Try again"), [this] { read(); });
        show_start();
      });
  show_protocol();
  show_start();
}

void StartPage::take(StartFacts facts) {
  facts_ = std::move(facts);
  is_read_ = true;
  list_protocols();
  list_languages();
  show_protocol();
  show_noise();
  if (const auto wish = std::exchange(wish_, std::nullopt)) {
    grant(*wish);
    form_->setEnabled(true);
    // A page that is opened has the focus in its first field; what is greyed cannot take it.
    const QWidget* focus = QApplication::focusWidget();
    if (isVisible() && (focus == nullptr || !form_->isAncestorOf(focus))) protocols_->setFocus();
  }
  show_mode();
}

void StartPage::grant(const Wish& wish) {
  if (wish.draft) return fill_in(*wish.draft);
  if (wish.participant) {
    const auto person = std::find_if(
        facts_.people.begin(), facts_.people.end(),
        [&wish](const ParticipantRow& known) { return known.label == *wish.participant; });
    if (person != facts_.people.end() && person->is_virtual) {
      mode_ = SessionMode::simulate;
    } else if (is_virtual()) {
      mode_ = SessionMode::run;
    }
  }
  show_mode();  // the card lists those whom the mode allows
  if (wish.participant) {
    participant_->choose(*wish.participant);
  } else {
    participant_->choose_next();
  }
  if (!wish.session) return;
  going_on_ = wish.session;
  show_person();
  go_on(true);
  if (!resume_) {
    banner_->show_news(State::look,
                       tr("The session of %1 cannot be resumed with this protocol: its text has "
                          "changed since the session began. To resume it, restore the earlier "
                          "text; a session started here is a new one.")
                           .arg(QString::fromStdString(wish.participant.value_or(""))));
  }
}

StartDraft StartPage::draft() const {
  StartDraft draft{};
  draft.person = participant_->draft();
  draft.session = resumed_session();
  draft.virtual_people = virtual_people_->value();
  draft.as_fast_as_possible = fast_->isChecked();
  draft.has_consented = consent_->is_given();
  draft.consent_seen_by = consent_->seen_by();
  draft.level_program = program_->program();
  draft.left_hand = setup_->chosen_left();
  if (noise_ != nullptr) draft.noise = noise_->value();
  return draft;
}

void StartPage::fill_in(const StartDraft& draft) {
  (draft.as_fast_as_possible ? fast_ : real_time_)->setChecked(true);
  show_mode();
  virtual_people_->setValue(draft.virtual_people);
  participant_->fill_in(draft.person);
  consent_->fill_in(draft.has_consented, draft.consent_seen_by);
  program_->choose(draft.level_program);
  if (draft.left_hand) setup_->choose_left(*draft.left_hand);
  if (draft.noise && noise_ != nullptr) make_noise_check(*draft.noise);
  going_on_ = draft.session;
  show_person();  // goes on with the session, if it still can
}

void StartPage::forget_person() {
  going_on_.reset();
  resume_ = false;
  participant_->choose_next();
}

void StartPage::set_mode(SessionMode mode) {
  const bool was_virtual = is_virtual();
  mode_ = mode;
  show_mode();
  // Other cards stand there now, and where somebody had scrolled to means nothing in them.
  if (is_virtual() != was_virtual) area_->verticalScrollBar()->setValue(0);
}

void StartPage::check_again() {
  // Whatever the file says now is what is checked, and shown.
  pick(facts_.chosen.file);
}

void StartPage::list_protocols() {
  const QSignalBlocker silent(protocols_);
  protocols_->clear();
  const auto add = [this](const std::filesystem::path& file, const QString& words) {
    protocols_->addItem(words, QString::fromStdString(file.string()));
    protocols_->setItemData(protocols_->count() - 1, words, Qt::ToolTipRole);
  };
  for (const StartFacts::ProtocolFile& each : facts_.files) {
    const QString name = QString::fromStdString(each.name);
    add(each.file, each.title.empty()
                       ? name
                       : QString("%1 (%2)").arg(QString::fromStdString(each.title), name));
  }
  const std::filesystem::path& chosen =
      facts_.languages.empty() ? facts_.chosen.file : facts_.languages.front().file;
  const auto is_chosen = [&chosen](const StartFacts::ProtocolFile& each) {
    return each.file == chosen;
  };
  if (!chosen.empty() && std::none_of(facts_.files.begin(), facts_.files.end(), is_chosen)) {
    add(chosen, QString::fromStdString(chosen.stem().string()));
  }
  protocols_->setCurrentIndex(protocols_->findData(QString::fromStdString(chosen.string())));
}

void StartPage::list_languages() {
  const QSignalBlocker silent(languages_);
  languages_->clear();
  for (const ProtocolInLanguage& each : facts_.languages) {
    languages_->addItem(text_of_language(each.language),
                        QString::fromStdString(each.file.string()));
  }
  languages_->setCurrentIndex(
      languages_->findData(QString::fromStdString(facts_.chosen.file.string())));
  languages_row_->setVisible(facts_.languages.size() > 1);
}

std::optional<std::string> StartPage::language_before() const {
  std::optional<std::string> before{};
  if (participant_->is_new()) return before;
  for (const StartFacts::SessionBefore& session : facts_.sessions) {
    if (session.participant != participant_->label() || session.mode != mode_) continue;
    if (session.language) before = session.language;
  }
  return before;
}

void StartPage::keep_language() {
  const std::optional<std::string> before = language_before();
  languages_->setEnabled(!before);
  languages_->setToolTip(before ? tr("The participant keeps the language of the earlier sessions.")
                                : QString{});
  if (resume_ || !is_read_ || chosen() == nullptr) return;
  // Not within the reading that led here.
  const auto pick_soon = [this](const std::filesystem::path& file) {
    QTimer::singleShot(0, this, [this, file] { pick(file); });
  };
  if (!before) {
    if (const auto own = std::exchange(chosen_by_experimenter_, std::nullopt)) pick_soon(*own);
    return;
  }
  if (chosen()->language == *before) return;
  for (const ProtocolInLanguage& each : facts_.languages) {
    if (each.language != *before) continue;
    if (!chosen_by_experimenter_) chosen_by_experimenter_ = facts_.chosen.file;
    pick_soon(each.file);
  }
}

void StartPage::go_on(bool wanted) {
  resume_ = wanted && unfinished_.has_value();
  if (resume_) {
    mode_ = unfinished_->row.mode;
    (unfinished_->row.pacing == "stepped" ? fast_ : real_time_)->setChecked(true);
    virtual_people_->setValue(1);
    keep_attested_noise();
  }
  show_mode();
}

// A level that was measured elsewhere before the interruption is not asked for again.
void StartPage::keep_attested_noise() {
  const RecordedNoise& before = unfinished_->noise;
  if (noise_ == nullptr || before.source != RecordedNoise::Source::elsewhere) return;
  MaskingNoise noise = noise_->value();
  if (noise.measured_dBA || !noise.verified_by.empty()) return;
  noise.measured_dBA = before.measured_dBA;
  noise.verified_by = before.verified_by;
  make_noise_check(noise);
}

bool StartPage::needs_consent() const {
  const Protocol* protocol = chosen();
  return protocol != nullptr && !protocol->consent_statement.empty() && !is_virtual() && !resume_;
}

std::optional<std::int64_t> StartPage::resumed_session() const {
  return resume_ ? std::optional(unfinished_->row.id) : std::nullopt;
}

bool StartPage::is_batch() const {
  return is_virtual() && participant_->is_new() && virtual_people_->value() > 1;
}

}  // namespace asperity
