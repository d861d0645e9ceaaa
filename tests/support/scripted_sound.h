// Loudspeakers that a test sets up, and a log of what they were asked for.

#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/session/sound/sound.h"

namespace asperity {

/// The state of a ScriptedSound and all that it was asked for, in order. It outlives the sound, which a session may own.
///
/// Threads: any.
class SoundLog final {
 public:
  struct MaskingSwitch {
    std::int64_t time_ns = 0;
    bool on = false;
  };

  std::atomic<bool> is_running{true};
  std::atomic<bool> is_heard{true};
  std::atomic<bool> is_attested{false};
  std::function<std::int64_t()> now_ns = [] {
    return 0;
  };  ///< for `masking`; set before the session

  /// With the number of the surface or option where there is one: "surface 1", "next".
  std::vector<std::string> cues() const { return copy_of(cues_); }
  int count(Cue cue) const {
    const std::vector<std::string> played = cues();
    return static_cast<int>(std::count(played.begin(), played.end(), text_of(cue)));
  }
  /// Each once, until another one is set.
  std::vector<GuideTone> guides() const { return copy_of(guides_); }
  GuideTone guide() const { return guides().empty() ? GuideTone::none : guides().back(); }
  std::vector<MaskingSwitch> masking() const { return copy_of(masking_); }
  bool is_masking() const { return !masking().empty() && masking().back().on; }

 private:
  friend class ScriptedSound;
  template <typename List>
  List copy_of(const List& list) const {
    const std::lock_guard lock(mutex_);
    return list;
  }

  mutable std::mutex mutex_{};
  std::vector<std::string> cues_{};
  std::vector<GuideTone> guides_{};
  std::vector<MaskingSwitch> masking_{};
};

/// Plays nothing and logs everything.
class ScriptedSound final : public Sound {
 public:
  explicit ScriptedSound(SoundLog& log) : log_(log) {}

  void set_masking(bool on) override {
    const std::lock_guard lock(log_.mutex_);
    log_.masking_.push_back({log_.now_ns(), on});
  }
  void play(Cue cue, int number) override {
    const std::lock_guard lock(log_.mutex_);
    log_.cues_.push_back(text_of(cue) + (number > 0 ? " " + std::to_string(number) : ""));
  }
  void set_guide(GuideTone tone) override {
    const std::lock_guard lock(log_.mutex_);
    if (log_.guides_.empty() || log_.guides_.back() != tone) log_.guides_.push_back(tone);
  }
  bool is_running() const override { return log_.is_running; }
  bool is_heard() const override { return log_.is_heard; }
  bool is_attested() const override { return log_.is_attested; }
  std::string description_json() const override { return R"({"kind":"pink"})"; }

 private:
  SoundLog& log_;
};

}  // namespace asperity
