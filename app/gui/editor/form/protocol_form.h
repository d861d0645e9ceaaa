// Declares a protocol as a form: its pages, and the fields of the page that is shown.

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

#include "app/gui/editor/form/entry_list.h"
#include "app/gui/editor/form/form_part.h"
#include "protocols/file/diagnostic.h"
#include "protocols/form/form_pages.h"

class QLabel;
class QListWidget;
class QScrollArea;
class QVBoxLayout;

namespace asperity {

class UsedControl;

/// A view of a text, which is the only state: `edit_made` has the text after a change in a field, and `show_text` shows what
/// has become of it.
class ProtocolForm final : public QWidget {
  Q_OBJECT
 public:
  /// `models` outlives it.
  explicit ProtocolForm(const std::vector<ModelDeclaration>& models, QWidget* parent = nullptr);
  ~ProtocolForm() override;

  /// The paths that fields of files offer, relative to the study.
  void offer_files(std::function<QStringList()> files) { context_.files = std::move(files); }
  /// The fields show this text. One that is no JSON leaves them as they are, and none can be edited.
  void show_text(const std::string& text);
  bool can_be_edited() const noexcept { return can_be_edited_; }
  void set_read_only(bool read_only);
  /// Another file: nothing of the text before stays.
  void forget();
  /// Writes a name that was typed and not confirmed, before the text is saved or left. False where it is refused.
  bool commit();
  /// The problems and warnings of the text, next to their fields.
  void show_problems(const std::vector<Diagnostic>& problems,
                     const std::vector<Diagnostic>& warnings);

  /// The sentence of a problem or a warning, as its field shows it.
  QString sentence_of(const Diagnostic& remark) const;

  /// The values that are found with these words, of all pages: see `form_search.h`.
  std::vector<std::string> places_with(const QString& words) const;

  /// Shows the page with the value, unfolded, and gives its field the focus; without a field the first control that belongs to
  /// it. With `mark` the focus stays where it is, and the control has a frame until the focus comes to a field. Selects the first
  /// of `words` in a field of text.
  enum class Lead { focus, mark };
  void go_to(const std::string& pointer, Lead lead = Lead::focus, const QString& words = {});
  /// Gives the focus to the control with the frame; false if there is none.
  bool enter_marked();
  void show_page(std::string_view id);
  const FormPage& page() const noexcept { return *page_; }

  /// What is shown of a text.
  struct Shown {
    std::string_view page{};
    std::set<std::string> opened{};  ///< see FormContext
    std::string pointer{};           ///< of the part that had the focus last; empty: none
  };
  Shown shown() const;
  /// Shows the same of the same text, and gives its field the focus.
  void resume(const Shown& shown);

 signals:
  /// A field has been changed. `step`: see FormContext::edit.
  void edit_made(const std::string& text, const std::string& step);
  void edit_refused(const QString& why);
  void text_wanted(const std::string& pointer);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_page();
  QString edit(const FormContext::Edit& edit, const std::string& step);
  void act_on_entry(EntryAction action);
  void show_unreadable(const QString& why);
  void follow_names(const std::shared_ptr<const FormSource>& before);
  void refresh();
  void show_help(const QWidget* control);
  void mark(QWidget* control);
  void select_found(QWidget* control, const QString& words);
  void order_for_keyboard();
  void scroll_to(int value);
  /// To the control of this object name or of this part, after it was made again.
  struct Focus {
    QString name{};         ///< of the control; can be empty
    QString part{};         ///< the object name of the part around it
    std::string pointer{};  ///< of that part
    int cursor = -1;        ///< in a line; negative: none
  };
  Focus focus_of(const QWidget& focused) const;
  void give_focus_back(const Focus& focus);
  void count_problems();
  void fit_pages();
  FormPart* part_at(const std::string& pointer) const;
  QWidget* control_at(const FormPart& part, const std::string& pointer) const;

  FormContext context_{};
  const std::vector<ModelDeclaration>& models_;
  const FormPage* page_ = nullptr;
  bool can_be_edited_ = false;
  bool read_only_ = false;
  bool was_refused_ = false;  ///< the last edit
  std::vector<FormPart*> parts_{};
  std::map<std::string_view, int> scrolled_{};  ///< by the page that was left
  QListWidget* pages_ = nullptr;
  QLabel* state_ = nullptr;
  QScrollArea* area_ = nullptr;
  std::unique_ptr<UsedControl> used_{};
  QPointer<QWidget> marked_{};
  QPointer<QWidget> found_{};  ///< in which words are selected
  QWidget* content_ = nullptr;
  QScrollArea* help_area_ = nullptr;
  QLabel* help_ = nullptr;
  QMetaObject::Connection helped_{};  ///< to the part whose meaning is shown, until it is gone
};

}  // namespace asperity
