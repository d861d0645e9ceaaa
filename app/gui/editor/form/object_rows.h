// Declares the fields of an object, one below the other.

#pragma once

#include <string>
#include <vector>

#include "app/gui/editor/form/form_part.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace asperity {

/// Labels, fields and their states: "default" next to an unchanged field, a button that resets a changed one. Keys without
/// a value that are not required are folded, except for what the page is named after.
class ObjectRows final : public FormPart {
  Q_OBJECT
 public:
  /// `part`: the keys that are shown; null: all.
  ObjectRows(FormContext& context, const KeyTable& table, const std::string& pointer,
             const PagePart* part, QWidget* parent);
  /// The keys of a page of the form.
  ObjectRows(FormContext& context, const FormPage& page, QWidget* parent);
  void refresh() override;

 private:
  struct Row {
    FormEntry entry{};
    FormPart* content = nullptr;  ///< null: a button that adds the key
    QLabel* state = nullptr;
    QToolButton* reset = nullptr;
    QLabel* problem = nullptr;
  };

  std::vector<FormEntry> entries() const;
  const PagePart* part_of(std::string_view key) const;
  /// The number of settings that can be folded: none where they are few or all that there are.
  std::size_t foldable(const std::vector<FormEntry>& entries) const;
  bool is_unfolded(const std::vector<FormEntry>& entries) const;
  bool can_be_folded(const FormEntry& entry) const;
  /// What the rows follow from: a change makes them again.
  std::string structure(const std::vector<FormEntry>& entries) const;
  void make_rows(const std::vector<FormEntry>& entries);
  void add_field(const FormEntry& entry);
  void add_section(const FormEntry& entry);
  void add_key_button(const FormEntry& entry);
  void add_fold(std::size_t count, bool is_open);
  void add_unknown_keys();
  void show_state(const Row& row) const;

  const KeyTable& table_;
  const FormPage* page_ = nullptr;
  const PagePart* part_ = nullptr;
  std::string made_{};
  std::vector<Row> rows_{};
  std::vector<QLabel*> labels_{};  ///< of fields
  QVBoxLayout* layout_ = nullptr;
};

/// The part of a form for a value that is present, of any shape. `part` as for ObjectRows, of the objects in it.
FormPart* make_part(FormContext& context, const ValueShape& shape, const ProtocolKey* key,
                    const std::string& pointer, const PagePart* part, QWidget* parent);

}  // namespace asperity
