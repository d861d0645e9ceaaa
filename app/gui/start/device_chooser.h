// The device that a session is to run on: chosen among what is there, and tried before anybody holds it.

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

#include "app/device_bench/device_choice.h"
#include "app/device_bench/tried_device.h"
#include "app/gui/look/background_task.h"
#include "protocols/design/protocol.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace asperity {

class DriverSetup;
class OpenStudy;
class StateLabel;

/// Lists the simulated device and what it can stand for, the mouse, and what the drivers find attached; what
/// cannot be used is listed with the reason. Looks for devices in the background when it is first asked to,
/// again when somebody wants it, and when drivers are told something else (`DriverSetup`, here or on the page Devices).
///
/// An attached device is opened by a person's press alone: it is tried for a third of a second without force,
/// and what it wants meanwhile ("pull the grip out") stands here. One that has to move by itself is let go of
/// unmoved first; what its driver says of the movement is asked here, and it is opened again by a yes to that.
///
/// The choice is remembered for the study. A device that is remembered and not there stays chosen, and is
/// said not to be there: nothing else takes its place unasked.
class DeviceChooser final : public QWidget {
  Q_OBJECT
 public:
  /// `study` outlives it.
  explicit DeviceChooser(OpenStudy& study, QWidget* parent = nullptr);

  enum class For { people, virtual_participant, virtual_participants };
  void set_for(For whom);
  /// Whose rate and force limit a device is tried with; may be null.
  void set_protocol(std::shared_ptr<const Protocol> protocol);
  /// Looks for devices, unless that has been done and drivers are still told the same.
  void look_once();

  /// As RunInputs::device.
  std::string device() const;
  QString name() const;  ///< of the chosen device, as in the list
  DeviceKind kind() const { return chosen().kind; }
  /// A sentence: why the chosen one cannot be used; empty: it can.
  const std::string& blocker() const { return chosen().blocker; }
  /// Of an attached device, at the rate of the protocol; null while it was not tried.
  std::shared_ptr<const TriedDevice> tried() const;
  /// The next session tries anew.
  void forget_try();
  bool is_trying() const { return try_task_.is_running(); }
  /// A sentence while nothing can be said of the chosen device yet; otherwise empty.
  QString waits_for() const;

 signals:
  void changed();

 protected:
  /// While a device is tried, the keys that stop a session's device stop this one.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void look();
  void list();
  void show_chosen();
  const DeviceChoice& chosen() const;
  /// `agreed`: what the driver has said of how the device moves by itself, and somebody has agreed to.
  void try_now(const std::string& agreed = {});
  /// `is_as_told`: drivers are still told what they were when it began.
  void show_try(const TriedDevice& found, bool is_as_told);
  /// In the room below the device: what is asked stays until it is answered.
  void ask(const QString& question, const QString& verb, std::function<void()> yes);
  void drop_question();
  void set_up();

  OpenStudy& study_;
  For whom_ = For::people;
  std::shared_ptr<const Protocol> protocol_{};
  std::vector<DeviceChoice> choices_ = devices_without_hardware();
  /// What is chosen for people and not among them: a session must not run on another one unasked.
  DeviceChoice gone_{};
  std::string of_people_ = "simulated";   ///< as chosen for them
  std::string of_virtual_ = "simulated";  ///< likewise
  bool has_looked_ = false;
  std::map<std::string, std::string> told_{};  ///< driver_places() when it looked last
  std::vector<SurveyedDriver> drivers_{};      ///< as it found them
  std::shared_ptr<const TriedDevice> tried_{};
  std::function<void()> on_yes_{};

  QComboBox* devices_ = nullptr;
  QLabel* text_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* try_ = nullptr;
  QPushButton* set_up_ = nullptr;
  QPointer<DriverSetup> setup_{};
  StateLabel* state_ = nullptr;
  QWidget* question_ = nullptr;
  StateLabel* question_text_ = nullptr;
  QPushButton* yes_ = nullptr;
  QPushButton* why_ = nullptr;
  QLabel* why_text_ = nullptr;
  BackgroundTask survey_task_{};
  BackgroundTask try_task_{};
};

}  // namespace asperity
