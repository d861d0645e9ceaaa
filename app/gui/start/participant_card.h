// Who takes part: somebody new, or somebody whom the study knows.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/start/start_draft.h"
#include "app/tasks/unfinished_session.h"
#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class GroupChooser;
class QuestionForm;
class StateLabel;

/// Somebody new gets a suggested label and the protocol's questions; somebody known is picked, and
/// their unfinished session is offered.
class ParticipantCard final : public QWidget {
  Q_OBJECT
 public:
  explicit ParticipantCard(QWidget* parent = nullptr);

  void set_questions(const std::vector<Question>& questions);
  /// Everybody in the study. What is chosen stays chosen.
  void set_people(const std::vector<ParticipantRow>& people);
  /// Virtual participants get their labels from the program: there is nothing to choose.
  void set_virtual(bool is_virtual, const QString& labels);
  /// Of the one who is chosen; `goes_on` once that was accepted.
  void set_unfinished(const std::optional<UnfinishedSession>& session, bool goes_on);
  /// Whether it is so old that a reason is to be entered.
  void ask_late_reason(bool asked);
  /// Empty where none is asked for.
  std::string late_reason() const;
  GroupChooser& group() noexcept { return *group_; }
  const GroupChooser& group() const noexcept { return *group_; }
  /// "Session 2 of P012 …", below everything.
  void set_session_text(const QString& text);

  /// Somebody known, or a label for somebody new.
  void choose(const std::string& label);
  /// Ready for the next person: a new label, empty answers.
  void choose_next();
  StartDraft::Person draft() const;
  void fill_in(const StartDraft::Person& draft);
  std::string label() const;
  bool is_new() const;
  /// Somebody known who is chosen.
  std::optional<ParticipantRow> known() const;
  /// Somebody new with the answers as they are.
  ParticipantRow new_person(const Protocol& protocol) const;
  /// What is missing, a sentence each.
  std::vector<QString> complaints() const;

 signals:
  void changed();
  void person_changed();  ///< the label, or who is chosen
  void go_on_wanted();
  void late_reason_changed();

 private:
  void show_kind();

  std::vector<ParticipantRow> people_{};
  bool is_virtual_ = false;
  bool has_suggested_ = false;  ///< a label for somebody new
  QPushButton* new_ = nullptr;
  QPushButton* known_ = nullptr;
  QWidget* switches_ = nullptr;
  QWidget* new_fields_ = nullptr;
  QLineEdit* label_ = nullptr;
  QuestionForm* form_ = nullptr;
  QWidget* known_fields_ = nullptr;
  QComboBox* list_ = nullptr;
  QLabel* known_text_ = nullptr;
  QLabel* virtual_text_ = nullptr;
  GroupChooser* group_ = nullptr;
  QWidget* unfinished_ = nullptr;
  StateLabel* unfinished_text_ = nullptr;
  QPushButton* go_on_ = nullptr;
  QWidget* late_ = nullptr;
  QLineEdit* late_reason_ = nullptr;
  QLabel* session_text_ = nullptr;
};

}  // namespace asperity
