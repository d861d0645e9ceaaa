// The device, the hand that holds it, and who sees and presses what.

#pragma once

#include <optional>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace asperity {

class DeviceChooser;
class OpenStudy;

class SetupCard final : public QWidget {
  Q_OBJECT
 public:
  /// `study` outlives it.
  explicit SetupCard(OpenStudy& study, QWidget* parent = nullptr);

  DeviceChooser& device() noexcept { return *device_; }
  const DeviceChooser& device() const noexcept { return *device_; }

  bool is_mirrored() const;
  /// What somebody chose themselves.
  std::optional<bool> chosen_left() const;
  void choose_left(bool left);
  /// As the participant's hand suggests, until somebody chooses otherwise.
  void suggest_left_hand(bool left);
  /// As the session began; it cannot be chosen any more.
  void fix_hand(bool left);
  void free_hand();
  /// Another person: what was chosen for the one before says nothing about them.
  void forget_hand();
  /// Nobody sits there in a simulation: no screen and no keyboard.
  void set_virtual(bool is_virtual);

  /// Name of the screen that the participant's window fills; empty: it stands beside the other.
  QString participant_screen() const;
  bool own_keyboard() const;

 signals:
  void changed();
  void screens_changed();

 private:
  void list_screens();
  void set_left(bool left);

  DeviceChooser* device_ = nullptr;
  bool hand_chosen_ = false;
  QPushButton* right_ = nullptr;
  QPushButton* left_ = nullptr;
  QLabel* hand_text_ = nullptr;
  QWidget* screen_row_ = nullptr;
  QComboBox* screens_ = nullptr;
  QCheckBox* own_keyboard_ = nullptr;
  QLabel* keyboard_text_ = nullptr;
};

}  // namespace asperity
