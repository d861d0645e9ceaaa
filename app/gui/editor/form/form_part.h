// Declares the parts of a form, each of which shows one value of the text.

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/editor/form/form_source.h"
#include "app/gui/look/controls.h"
#include "protocols/form/form_edits.h"

class QLabel;
class QLayout;
class QToolButton;

namespace asperity {

/// A problem (State::stop) or a warning (State::look).
struct Remark {
  State state = State::stop;
  QString sentence{};
};

/// What all parts of a form share. Belongs to the form.
struct FormContext {
  using Edit = std::function<FormEdit(const JsonDocument&)>;

  std::shared_ptr<const FormSource> source{};
  /// Edits the text. Edits in succession with the same `step` that is not empty are one step of the undo. Returns why the edit
  /// is refused, or an empty text.
  std::function<QString(const Edit& edit, const std::string& step)> edit{};
  std::function<void(const std::string& pointer)> show_in_text{};
  /// Shows the page with the value, whose field gets the focus.
  std::function<void(const std::string& pointer)> go_to{};
  /// The paths that fields of files offer, relative to the study; empty where there is no study.
  std::function<QStringList()> files{};
  /// Shows all parts again, of which some are unfolded.
  std::function<void()> refresh{};
  /// Of the check, by pointer.
  std::map<std::string, std::vector<Remark>> problems{};
  /// Writes a name that was typed and is not complete; empty if there is none. It comes before any other edit.
  std::function<void()> write_pending{};
  /// Parts have been made: the order of the keyboard has to be that of the layout again.
  bool has_new_parts = false;
  /// While a text with other names is shown: the pointer to a value by its pointer in the text before.
  std::function<std::string(const std::string& pointer)> renamed{};
  bool is_refreshing = false;  ///< parts are shown or made again, which is no edit
  std::set<std::string>
      opened{};  ///< the cards and lists of settings that are unfolded, by pointer
};

/// Shows the value at a JSON pointer and edits it. Its object name is the pointer, that of the field of a key "name:" and the
/// pointer of the member.
class FormPart : public QWidget {
  Q_OBJECT
 public:
  FormPart(FormContext& context, std::string pointer, QWidget* parent);

  const std::string& pointer() const noexcept { return pointer_; }
  /// Shows the present text; makes again what has another structure.
  virtual void refresh() = 0;
  /// Chooses the value at the pointer among those that the part shows in one control.
  virtual void point_to(const std::string& /*pointer*/) {}
  /// The name of its control for screen readers.
  virtual void set_name(const QString& name);
  /// The meaning of the value, for help.
  const QString& meaning() const noexcept { return meaning_; }
  void set_meaning(const QString& meaning) { meaning_ = meaning; }

 protected:
  FormContext& context() const noexcept { return context_; }
  const FormSource& source() const { return *context_.source; }
  /// Null if the text has none.
  const nlohmann::json* value() const { return source().find(pointer_); }
  void write(const std::string& json) const;
  /// Typing in a field is one step.
  void write_typed(const std::string& json) const;
  /// Without the value at the pointer, if there is one: the default applies. `step`: see FormContext::edit.
  void remove(const std::string& pointer, const std::string& step = {}) const;

 private:
  FormContext& context_;
  std::string pointer_{};
  QString meaning_{};
};

/// The remarks about the value at a pointer; with `within`, also those about what it contains.
enum class Problems { of_value, within };
std::vector<Remark> problems_at(const FormContext& context, const std::string& pointer,
                                Problems which);

/// A hidden label for remarks.
QLabel* make_problem_label(QWidget* parent);
/// Each in a line with the mark of its state, in the colour of the worst.
void show_problems(QLabel& label, const std::vector<Remark>& remarks);
/// One problem; hides the label if the sentence is empty.
void show_problem(QLabel& label, const QString& sentence);

/// The object name of every button that removes something begins with this.
inline constexpr QLatin1StringView kRemoving("remove");
/// The object name of a button that removes a value, before the pointer.
inline constexpr QLatin1StringView kRemovingValue("remove:");
/// That of the box that ticks an entry.
inline constexpr QLatin1StringView kChoosing("choose:");

/// A small button with a sign, whose name is read aloud and shown as its tip.
QToolButton* make_tool(const QString& sign, const QString& name, QWidget* parent);

/// The name of a field: as wide as those of other fields where there is room, otherwise in more lines. No word of it is cut.
QLabel* make_field_label(const QString& words, QWidget* parent);
/// Those of one object are as wide as the widest of them where there is room, so that their fields begin below each other.
void align_field_labels(const std::vector<QLabel*>& labels);

}  // namespace asperity
