// Declares the two views of a protocol that is edited: form and text.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/schema_help.h"
#include "protocols/file/diagnostic.h"
#include "stimuli/properties/parameter.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace asperity {

class FindBar;
class ProtocolTextEdit;

/// The text is the only state, with one list of undo: a change in the form replaces the characters that differ, and typing in
/// a field is one step.
class ProtocolViews final : public QWidget {
  Q_OBJECT
 public:
  enum class View { form, text };

  explicit ProtocolViews(std::vector<ModelDeclaration> models, QWidget* parent = nullptr);
  ~ProtocolViews() override;

  /// See ProtocolForm.
  void offer_files(std::function<QStringList()> files);
  void set_view(View view);
  View view() const;
  /// The form of a text that is JSON, else the text.
  void show_form_if_possible();
  ProtocolTextEdit& text() const noexcept { return *edit_; }
  void set_read_only(bool read_only);
  /// The text is that of another file.
  void forget();
  /// What was typed in the form and is not written yet. False where it is refused.
  bool commit();
  void show_problems(const std::vector<Diagnostic>& problems,
                     const std::vector<Diagnostic>& warnings);
  /// The sentence of one of them in the words of the view that is shown.
  QString sentence_of(const Diagnostic& remark) const;
  /// The place of a problem, in the view that is shown.
  void go_to_problem(std::size_t index);
  void find();
  void give_focus();
  /// To the control of the view that had it last.
  void return_focus();

  /// What is shown of a text.
  struct Shown {
    View view = View::form;
    ProtocolForm::Shown form{};
    int cursor = 0;  ///< in the text
  };
  Shown shown() const;
  /// Shows the same of the same text.
  void resume(const Shown& shown);

 signals:
  void view_changed();
  /// An edit of the form that is not possible, such as a name that is taken.
  void refused(const QString& why);

 private:
  QWidget* make_switch();
  QWidget* make_text_view();
  void take_edit(const std::string& after, const std::string& step);
  void undo_or_redo(bool is_undo);
  void show_in_text(const std::string& pointer);
  void show_help();

  std::vector<ModelDeclaration> models_{};
  SchemaHelp help_;
  std::vector<Diagnostic> places_{};  ///< of the problems and warnings
  std::string step_{};  ///< of the last edit of the form; empty after any other change
  bool is_editing_ = false;
  QStackedWidget* stack_ = nullptr;
  ProtocolForm* form_ = nullptr;
  ProtocolTextEdit* edit_ = nullptr;
  FindBar* find_ = nullptr;
  QLabel* key_help_ = nullptr;
  QPushButton* to_form_ = nullptr;
  QPushButton* to_text_ = nullptr;
};

}  // namespace asperity
