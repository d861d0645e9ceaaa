// Pieces that every page is made of.

#pragma once

#include <functional>

#include <QtCore/QString>
#include <QtCore/Qt>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFrame>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QWidget>

#include "app/gui/look/theme.h"
#include "results_schema/rows.h"

class QSplitter;
class QTableView;
class QVBoxLayout;

namespace asperity {

enum class ButtonRole {
  plain,
  primary,   ///< the one filled button of a page
  danger,    ///< names what it does, stands apart
  link,      ///< words in blue
  selector,  ///< one of several, checkable
};
QPushButton* make_button(const QString& verb, ButtonRole role, QWidget* parent);
/// For a button that now does something else; not to or from `selector`.
void set_role(QPushButton& button, ButtonRole role);

/// A list to choose from. Where the box has no room for what is chosen, it shows the value of an item that has one, without the
/// explanation; otherwise the middle is left out: both ends stay. The list is as wide as its longest text; with
/// QComboBox::AdjustToContents the box has room for it as well.
class ChoiceBox final : public QComboBox {
  Q_OBJECT
 public:
  using QComboBox::QComboBox;
  /// Of an item whose text is its value and an explanation: the value.
  static constexpr int kValueRole = Qt::UserRole + 1;
  /// What the box shows now.
  QString shown_text() const;
  /// The width that the box needs to show this text.
  int width_for(const QString& text) const;
  void showPopup() override;
  QSize sizeHint() const override { return with_room(QComboBox::sizeHint()); }
  QSize minimumSizeHint() const override { return with_room(QComboBox::minimumSizeHint()); }

 protected:
  void initStyleOption(QStyleOptionComboBox* option) const override;

 private:
  QSize with_room(QSize size) const;
  int room_in(const QStyleOptionComboBox& option) const;
};

QLabel* make_title(const QString& text, QWidget* parent);    ///< of a page
QLabel* make_heading(const QString& text, QWidget* parent);  ///< of a group
/// Wraps; `muted` for secondary text.
QLabel* make_text(const QString& text, QWidget* parent, bool muted = false);
/// A panel with a border; its layout has the usual margins.
QFrame* make_card(QWidget* parent, QVBoxLayout*& layout);

/// Deletes the widgets of a layout, later, because one of them may have caused this.
void clear_layout(QLayout& layout);

/// Sides that cannot be collapsed, with a gap of `gap` pixels between them that can be dragged.
QSplitter* make_splitter(Qt::Orientation orientation, QWidget* parent, int gap = kMargin);

/// How something stands, as a shape and a word: never colour alone. In the colours of the theme,
/// also when that changes.
enum class State { fine, look, stop, unknown };
class StateLabel final : public QLabel {
  Q_OBJECT
 public:
  explicit StateLabel(QWidget* parent = nullptr);
  /// "✓ text", "▲ text", "✕ text" or "· text".
  void set_state(State state, const QString& text);
  State state() const noexcept { return state_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void write();

  State state_ = State::unknown;
  QString words_{};
};
QString shape_of(State state);
QColor color_of(State state);

/// News in place, with the button that helps, in the colours of the theme, also when that changes; in
/// a narrow window the buttons stand under the words. Hidden until `show_news`. Tab visits its buttons
/// after what its page shows above it.
///
/// The names of its parts: "banner_action", "banner_dismiss".
class Banner final : public QFrame {
  Q_OBJECT
 public:
  explicit Banner(QWidget* parent = nullptr);
  /// `action` empty: no button but the one that takes the banner away.
  void show_news(State state, const QString& text, const QString& action = {},
                 std::function<void()> on_action = {});
  QString text() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void restyle();

  State state_ = State::unknown;
  QLabel* shape_ = nullptr;
  QLabel* text_ = nullptr;
  QPushButton* action_ = nullptr;
  QPushButton* away_ = nullptr;
  std::function<void()> on_action_{};
};

/// The coloured band on top of a window: amber for a pilot, violet for a simulation, none in a run.
class ModeBand final : public QLabel {
  Q_OBJECT
 public:
  explicit ModeBand(QWidget* parent = nullptr);
  void set_mode(SessionMode mode);
};

/// What a page shows while it has nothing: what it is for and the next step.
class EmptyState final : public QWidget {
  Q_OBJECT
 public:
  EmptyState(const QString& title, const QString& text, QWidget* parent = nullptr);
  QPushButton* add_action(const QString& verb, ButtonRole role, std::function<void()> on_click);

 private:
  QVBoxLayout* layout_ = nullptr;
};

/// Rows are selected as a whole, sorted by a click on a header, and copied as tab-separated text by
/// Ctrl+C. Tab goes on to what comes after the table.
void style_table(QTableView& table);

}  // namespace asperity
