// Masking noise and cues over the computer's sound card.

#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <QtCore/QString>

#include "app/gui/sound/sound_stream.h"
#include "app/session/sound/masking_sound.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// Plays what MaskingSound makes. Where there is no sound card, samples are taken at the same pace
/// and nobody hears them: `is_null` says so, and so does what is stored.
///
/// The stream runs from construction to destruction, silent while nothing is to be heard, so that a
/// cue never waits for a card to open. The card is opened beside everything else: `is_running` says
/// when. One that does not open, or takes long, makes no session hang: with masking noise the session
/// pauses before its first trial, as it does when a card is lost, and goes on once the card is there.
///
/// Errors: the constructor throws std::runtime_error or std::invalid_argument, a sentence, for speech
/// that cannot be read and as MaskingSound.
///
/// Threads: any. The constructor reads speech and asks the system for its card, and is best not called
/// by a window that has recorded cues. The rest answers at once, but for `description_json`: what is
/// stored says whether the card was heard, so it waits until the card takes samples,
/// SoundStream::kOpens_s at most.
class QtSound final : public Sound {
 public:
  /// `speech` by cue, as a protocol names them ("surface_1", "question").
  explicit QtSound(const MaskingNoise& noise,
                   const std::map<std::string, std::filesystem::path>& speech = {});
  QtSound(const MaskingNoise& noise, const std::map<std::string, std::filesystem::path>& speech,
          SoundOutput output);
  ~QtSound() override;

  void set_masking(bool on) override;
  void play(Cue cue, int number) override;
  void set_guide(GuideTone tone) override;
  bool is_running() const override { return stream_.is_running(); }
  bool is_heard() const override { return !is_null(); }
  bool is_attested() const override { return noise_.is_attested(); }
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
