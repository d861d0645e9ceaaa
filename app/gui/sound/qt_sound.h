// Masking noise and cues over the computer's sound card.

#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "app/conductor/masking_sound.h"
#include "app/conductor/sound.h"
#include "app/gui/sound/sound_stream.h"

namespace asperity {

/// Plays what MaskingSound makes. Where there is no sound card, samples are taken at the same pace
/// and nobody hears them: `is_null` says so, and so does what is stored.
///
/// The stream runs from construction to destruction, silent while nothing is to be heard, so that a
/// cue never waits for a card to open.
///
/// Errors: the constructor throws std::runtime_error or std::invalid_argument, a sentence, for speech
/// that cannot be read and as MaskingSound.
///
/// Threads: construction and destruction on one thread; everything else from any, at once.
class QtSound final : public QObject, public Sound {
  Q_OBJECT
 public:
  /// `speech` by cue, as a protocol names them ("surface_1", "question").
  explicit QtSound(const MaskingNoise& noise,
                   const std::map<std::string, std::filesystem::path>& speech = {},
                   QObject* parent = nullptr);
  QtSound(const MaskingNoise& noise, const std::map<std::string, std::filesystem::path>& speech,
          SoundOutput output, QObject* parent = nullptr);
  ~QtSound() override;

  void set_masking(bool on) override;
  void play(Cue cue, int number) override;
  bool is_running() const override { return stream_.is_running(); }
  std::string description_json() const override;

  bool is_null() const noexcept { return stream_.output().is_null; }
  /// Of the sound card; empty where there is none.
  QString device_name() const { return stream_.output().name; }
  /// As MaskingSound; what was measured at another gain does not hold any more.
  void set_gain(double gain);

 private:
  const MaskingNoise noise_{};
  MaskingSound samples_;
  SoundStream stream_;  // ends before what it plays
};

}  // namespace asperity
