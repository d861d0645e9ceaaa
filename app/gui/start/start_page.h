// Everything that is decided before a session, on one page.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/base/commands_button.h"
#include "app/gui/base/open_study.h"
#include "app/gui/look/background_task.h"
#include "app/gui/session/session_runner.h"
#include "app/gui/start/start_draft.h"
#include "app/gui/start/start_facts.h"
#include "app/session/new_seed.h"
#include "app/tasks/checks/session_check.h"
#include "app/tasks/simulation/simulation.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpinBox;
class QTimer;
class QVBoxLayout;

namespace asperity {

class Banner;
class CheckList;
class ConsentCard;
class ModeBand;
class NoiseCheck;
class ParticipantCard;
class ProgramChooser;
class SetupCard;
class StateLabel;

/// Protocol, participant, consent, device and screens, masking noise; beside them the checklist.
/// Always in sight, and never moved by what is chosen: above, Run | Pilot | Simulate; below, "Start
/// session" with the reason while it cannot be pressed.
///
/// One virtual participant in a simulation makes a SessionOrder like anybody else; several are only asked for, to be
/// simulated in the background.
///
/// Only reads the study, away from the GUI thread; whoever starts the session writes it. While it
/// reads nothing can be started: what is pressed acts on what is shown. Looks at nothing while it is
/// hidden: the checklist runs the servo loop, which nobody may do beside a session.
///
/// After the checks, which time the servo loop, the stimuli are examined for warnings; the session does not wait for them.
///
/// What is filled in stays when the page is made anew for another theme or language: it is left with
/// the study, where the next page finds it.
class StartPage final : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(OpenStudy& study, QWidget* parent = nullptr);
  ~StartPage() override;

  /// `participant`: somebody known, or a label for somebody new; otherwise the next one is
  /// suggested. `session`: the id of the unfinished session of theirs that goes on.
  void choose(const std::filesystem::path& protocol, const std::optional<std::string>& participant,
              std::optional<std::int64_t> session);
  void set_mode(SessionMode mode);
  /// Reads the protocol as it is now and looks at everything anew; what is filled in stays.
  void check_again();
  /// The next person is somebody else: nothing of the last one's answers or consent stays.
  void forget_person();
  SessionMode mode() const noexcept { return mode_; }
  /// False while the study or the protocol is being read: what is shown is not up to date.
  bool is_read() const noexcept { return is_read_; }
  /// While virtual participants are simulated in the background, nothing can be started.
  void set_simulating(bool now);

  /// What keeps the session from starting, a sentence each; empty when it can start.
  std::vector<QString> reasons() const;
  /// As it would be started now.
  SessionOrder order() const;

 signals:
  void start_wanted(const asperity::SessionOrder& order);
  /// Several virtual participants.
  void simulation_wanted(const asperity::SimulationInputs& inputs);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void make_head(QVBoxLayout& page);
  void make_protocol_card(QVBoxLayout& column);
  void make_simulation_card(QVBoxLayout& column);
  QWidget* make_footer();
  void connect_parts();

  /// Who is to take part, as soon as the study has been read; or all that was filled in on the page
  /// that this one stands for.
  struct Wish {
    std::optional<std::string> participant{};
    std::optional<std::int64_t> session{};
    std::optional<StartDraft> draft{};
  };
  /// What a page that goes leaves with the study.
  struct Left {
    std::filesystem::path protocol{};
    SessionMode mode = SessionMode::run;
    Wish wish{};
  };
  /// Reads the protocol file, and the study beside it.
  void pick(const std::filesystem::path& protocol);
  void read();
  void take(StartFacts facts);
  void grant(const Wish& wish);
  StartDraft draft() const;
  void fill_in(const StartDraft& draft);
  void list_protocols();
  void show_protocol();
  void show_noise();
  void make_noise_check(const MaskingNoise& noise);
  void show_mode();
  void show_person();
  void show_start();
  void go_on(bool wanted);
  QString session_text() const;
  /// The group of the participant's earlier sessions of this protocol and mode.
  std::optional<std::string> group_before() const;
  /// Those among which the experimenter has to choose.
  std::vector<std::string> groups_to_choose() const;
  /// That of the participant's earlier sessions of this protocol and mode.
  std::optional<std::string> language_before() const;
  void list_languages();
  /// Reads the protocol in the language of the participant's earlier sessions, if it is in another one, and in the chosen
  /// language again for a participant without such sessions.
  void keep_language();

  /// Null while there is none, or it is not valid.
  const Protocol* chosen() const noexcept { return facts_.chosen.protocol.get(); }
  bool read_has_failed() const { return !is_read_ && !read_task_.is_running(); }
  bool is_virtual() const noexcept { return mode_ == SessionMode::simulate; }
  bool needs_consent() const;
  void keep_attested_noise();
  std::optional<std::int64_t> resumed_session() const;
  bool is_batch() const;
  MaskingNoise noise() const;
  void check_soon();
  void check();
  void forget_checks();
  void examine_stimuli();
  void press_start();
  SimulationInputs simulation() const;
  std::vector<ShownCommand> commands() const;

  OpenStudy& study_;
  StartFacts facts_{};    ///< as last read; `chosen` is ahead of the rest while a file is read
  bool is_read_ = false;  ///< `facts_` is up to date
  std::optional<Wish> wish_{};
  SessionMode mode_ = SessionMode::run;
  std::uint64_t seed_ = new_seed();  ///< of what is started next
  std::optional<UnfinishedSession> unfinished_{};
  bool resume_ = false;
  std::optional<std::int64_t> going_on_{};  ///< the session that the page was opened to go on with
  bool stale_ = true;                       ///< to be read when the page is shown
  std::optional<std::vector<SessionCheck>> checks_{};  ///< absent: not up to date
  /// Of the device: computed once for a protocol, its stimuli and a profile.
  std::shared_ptr<RehearsalMemory> rehearsal_ = std::make_shared<RehearsalMemory>();
  bool check_outdated_ = false;  ///< what is looked at now is to be looked at once more
  bool is_simulating_ = false;
  bool check_cancelled_ = false;  ///< by a press, until something else is chosen

  ModeBand* band_ = nullptr;
  Banner* banner_ = nullptr;
  QLabel* title_ = nullptr;
  QScrollArea* area_ = nullptr;
  QWidget* form_ = nullptr;
  QComboBox* protocols_ = nullptr;
  QWidget* languages_row_ = nullptr;
  QComboBox* languages_ = nullptr;
  /// What the experimenter chose, while the protocol is read in a participant's language instead.
  std::optional<std::filesystem::path> chosen_by_experimenter_{};
  QLabel* protocol_text_ = nullptr;
  StateLabel* protocol_state_ = nullptr;
  ParticipantCard* participant_ = nullptr;
  QPushButton* run_ = nullptr;
  QPushButton* pilot_ = nullptr;
  QPushButton* simulate_ = nullptr;
  QLabel* mode_text_ = nullptr;
  QWidget* simulation_ = nullptr;
  QSpinBox* virtual_people_ = nullptr;
  QPushButton* fast_ = nullptr;
  QPushButton* real_time_ = nullptr;
  QLabel* simulation_text_ = nullptr;
  ConsentCard* consent_ = nullptr;
  ProgramChooser* program_ = nullptr;
  SetupCard* setup_ = nullptr;
  QWidget* noise_card_ = nullptr;
  QVBoxLayout* noise_layout_ = nullptr;
  NoiseCheck* noise_ = nullptr;
  CheckList* check_list_ = nullptr;
  StateLabel* reason_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* commands_ = nullptr;
  QTimer* check_timer_ = nullptr;
  BackgroundTask read_task_{};
  BackgroundTask check_task_{};
};

}  // namespace asperity
