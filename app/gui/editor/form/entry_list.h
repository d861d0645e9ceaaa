// Declares the entries of a list or of an object whose keys are names, one below the other.

#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QtGui/QKeySequence>

#include "app/gui/editor/form/form_part.h"
#include "protocols/form/form_pages.h"
#include "protocols/shapes/shape.h"

class QCheckBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace asperity {

class FittedLabel;

/// What a button of an entry does.
enum class EntryAction { move_up, move_down, duplicate, remove };
/// With the keyboard, for the entry with the focus.
QKeySequence keys_of(EntryAction action);

/// Entries that are moved, duplicated, removed and added. One that fits in a line is a field; another is a card with its
/// name and a summary, which is unfolded. Entries whose boxes are ticked are moved, duplicated and removed together.
class EntryList final : public FormPart {
  Q_OBJECT
 public:
  /// `shape`: of a list or a map. `part`: which keys of the entries are shown; with an excerpt of them, entries are neither
  /// added nor removed here.
  EntryList(FormContext& context, const ValueShape& shape, const std::string& pointer,
            const PagePart* part, QWidget* parent);
  void refresh() override;
  /// As the button of the entry that contains the widget, which keeps the focus; false if no entry contains it.
  bool act(const QWidget& focus, EntryAction action);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Tool {
    QToolButton* button = nullptr;
    QString sentence{};  ///< what it does to "%1"
    QString keys{};      ///< of its shortcut; can be empty
    EntryAction action = EntryAction::remove;
  };
  struct Entry {
    std::string pointer{};
    std::string name{};  ///< of a member of a map, or what a list entry is called; can be empty
    FormPart* content = nullptr;   ///< null while a card is folded
    FormPart* key = nullptr;       ///< the field of the name
    FittedLabel* title = nullptr;  ///< of a card, as its summary
    FittedLabel* summary = nullptr;
    QGridLayout* head = nullptr;  ///< of a card
    QLabel* problem = nullptr;
    QCheckBox* chosen = nullptr;
    std::vector<Tool> tools{};
  };

  const ValueShape& entry_shape() const;
  bool is_excerpt() const {
    return part_ != nullptr && !part_->of_entries.empty() && !part_->are_left_out;
  }
  std::vector<Entry> present_entries() const;
  std::string structure(const std::vector<Entry>& entries) const;
  void make_entries(std::vector<Entry> entries);
  void add_line(Entry& entry, std::size_t index);
  void add_card(Entry& entry, std::size_t index);
  QHBoxLayout* make_tools(Entry& entry, std::size_t index);
  void place_summary(const Entry& entry) const;
  void show_entry(const Entry& entry, std::size_t index) const;
  void add_adding();
  /// The keys that a new entry can have, or the kinds that it can be of, with their words.
  QStringList keys_to_add(QStringList& labels) const;
  /// Of the parameters of a stimulus.
  std::string stimulus() const { return pointer().substr(0, pointer().rfind('/')); }
  QString title_of(const Entry& entry, std::size_t index) const;
  std::optional<std::size_t> entry_with(const QWidget& widget) const;
  void toggle(const std::string& pointer);
  // These return the position afterwards: of the entry, of its copy, of the entry after the one that is gone.
  std::size_t move(std::size_t index, int by);
  std::size_t duplicate(std::size_t index);
  std::size_t remove(std::size_t index);
  void add(const std::string& key);
  /// The entry, or all that are ticked if it is one of them, in their order.
  std::vector<std::size_t> together(std::size_t index) const;
  /// Edits the text, after which the entries of a list stand at other positions: what is unfolded and ticked goes with them.
  /// `position`: of an entry afterwards; nullopt: it is gone.
  void rearrange(const FormContext::Edit& edit,
                 const std::function<std::optional<std::size_t>(std::size_t)>& position);

  ValueShape shape_{};
  const PagePart* part_ = nullptr;
  std::string made_{};
  std::set<std::string> ticked_{};  ///< pointers
  std::vector<Entry> entries_{};
  QVBoxLayout* layout_ = nullptr;
  bool is_narrow_ = false;
};

}  // namespace asperity
