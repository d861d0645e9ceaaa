// Where an experimenter sets the masking noise to its level before a session.

#pragma once

#include <memory>

#include <QtCore/QElapsedTimer>
#include <QtWidgets/QWidget>

#include "app/gui/sound/sound_output.h"
#include "app/session/sound/sound.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTimer;

namespace asperity {

class QtSound;
class StateLabel;

/// Plays the noise that a protocol declares, so that its level can be set and measured, and takes
/// down what was measured by whom. A test cue shows that cues are heard through the noise.
///
/// The sound card is opened by the first button that needs it, and let go when the widget is hidden.
/// One that does not open within some seconds, or is lost, is said to be so.
/// Turning the gain makes an earlier measurement void: it has to be made again.
class NoiseCheck final : public QWidget {
  Q_OBJECT
 public:
  explicit NoiseCheck(const MaskingNoise& declared, QWidget* parent = nullptr);
  NoiseCheck(const MaskingNoise& declared, SoundOutput output, QWidget* parent = nullptr);
  ~NoiseCheck() override;

  /// As declared, with the gain, the measured level and the name that stand here now.
  MaskingNoise value() const { return value_; }
  /// A sentence: no sound card, one that does not play, noise not measured, too loud, off by more than
  /// 3 dB, nobody signed. Empty when all is well.
  QString reservation() const;

 signals:
  void changed();

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  QtSound& sound();
  void play_noise(bool on);
  void set_gain(int slider);
  void look_at_card();
  void show_state();

  MaskingNoise value_{};
  SoundOutput output_{};
  std::unique_ptr<QtSound> sound_{};
  QTimer* watch_ = nullptr;  ///< while there is a sound
  QElapsedTimer silent_{};   ///< since it was last seen to play, or was asked to
  bool is_silent_ = false;
  QPushButton* noise_ = nullptr;
  QSlider* gain_ = nullptr;
  QLabel* gain_text_ = nullptr;
  QDoubleSpinBox* measured_ = nullptr;
  QLineEdit* verified_by_ = nullptr;
  StateLabel* state_ = nullptr;
};

}  // namespace asperity
