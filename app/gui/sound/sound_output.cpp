// Implements outputs for a sound card by QAudioSink and for none by a clock, in the best format of the card.

#include "app/gui/sound/sound_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtCore/QIODevice>
#include <QtCore/QTimer>
#include <QtMultimedia/QAudioDevice>
#include <QtMultimedia/QAudioFormat>
#include <QtMultimedia/QAudioSink>
#include <QtMultimedia/QMediaDevices>

namespace asperity {

namespace {

constexpr int kSampleRate_Hz = 48000;
// Three of the periods of 20 ms in which Qt feeds a sound server; its default is up to two seconds.
constexpr double kBuffer_s = 0.060;

bool is_heard(const QAudioDevice& card) { return !card.isNull() && card.id() != "auto_null"; }

std::optional<SampleForm> form_of(const QAudioFormat& format) {
  SampleForm form{.rate_Hz = format.sampleRate(), .channels = format.channelCount()};
  switch (format.sampleFormat()) {
    case QAudioFormat::Float:
      form.type = SampleForm::Type::float32;
      return form;
    case QAudioFormat::Int32:
      form.type = SampleForm::Type::int32;
      return form;
    case QAudioFormat::Int16:
      form.type = SampleForm::Type::int16;
      return form;
    case QAudioFormat::UInt8:
    case QAudioFormat::Unknown:
    case QAudioFormat::NSampleFormats:
      break;
  }
  return std::nullopt;
}

/// The first that the card takes: ours, then ours in 16 bits, then what it likes best.
QAudioFormat format_for(const QAudioDevice& card) {
  QAudioFormat wanted{};
  wanted.setSampleRate(kSampleRate_Hz);
  wanted.setChannelCount(2);
  for (const auto type : {QAudioFormat::Float, QAudioFormat::Int16}) {
    wanted.setSampleFormat(type);
    if (card.isFormatSupported(wanted)) return wanted;
  }
  return card.preferredFormat();
}

/// A sound card, through QAudioSink.
class CardConsumer final : public SampleConsumer {
 public:
  CardConsumer(const QAudioDevice& card, const QAudioFormat& format, QIODevice& samples)
      : card_(card), sink_(card, format) {
    sink_.setBufferSize(format.bytesForDuration(static_cast<qint64>(kBuffer_s * 1e6)));
    sink_.start(&samples);
  }
  ~CardConsumer() override { sink_.stop(); }

  /// A sound server moves the stream of a card that was pulled out to another one: headphones go
  /// on as loudspeakers. That is no masking any more.
  bool is_working() const override {
    return sink_.state() != QAudio::StoppedState && QMediaDevices::audioOutputs().contains(card_);
  }

 private:
  QAudioDevice card_;
  QAudioSink sink_;
};

/// Takes what a card would have taken, by the clock.
class NullConsumer final : public SampleConsumer {
 public:
  explicit NullConsumer(QIODevice& samples, const SampleForm& form)
      : samples_(samples), form_(form) {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { take(); });
    clock_.start();
    timer_.start(10);
  }
  bool is_working() const override { return true; }

 private:
  void take() {
    const std::int64_t due = clock_.nsecsElapsed() * form_.rate_Hz / 1'000'000'000;
    // After a sleep of the machine the gap is not made up for.
    taken_ = std::max(taken_, due - form_.rate_Hz / 4);
    while (taken_ < due) {
      const auto frame = static_cast<std::int64_t>(form_.bytes_per_frame());
      const std::int64_t frames =
          std::min(due - taken_, static_cast<std::int64_t>(dropped_.size()) / frame);
      if (samples_.read(dropped_.data(), frames * frame) <= 0) return;
      taken_ += frames;
    }
  }

  QIODevice& samples_;
  SampleForm form_{};
  QElapsedTimer clock_{};
  QTimer timer_{};
  std::int64_t taken_ = 0;
  std::array<char, 8192> dropped_{};
};

}  // namespace

int SampleForm::bytes_per_frame() const noexcept {
  return channels * (type == Type::int16 ? 2 : 4);
}

void write_frames(const SampleForm& form, std::span<const float> stereo, char* bytes) noexcept {
  const auto put = [&form, &bytes](float sample) {
    const double bounded = std::clamp(static_cast<double>(sample), -1.0, 1.0);
    switch (form.type) {
      case SampleForm::Type::int16: {
        const auto value = static_cast<std::int16_t>(std::lround(bounded * 32767.0));
        std::memcpy(bytes, &value, sizeof(value));
        bytes += sizeof(value);
        return;
      }
      case SampleForm::Type::int32: {
        const auto value = static_cast<std::int32_t>(std::llround(bounded * 2147483647.0));
        std::memcpy(bytes, &value, sizeof(value));
        bytes += sizeof(value);
        return;
      }
      case SampleForm::Type::float32:
        std::memcpy(bytes, &sample, sizeof(sample));
        bytes += sizeof(sample);
        return;
    }
  };
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    if (form.channels == 1) {
      put(0.5F * (stereo[i] + stereo[i + 1]));
      continue;
    }
    put(stereo[i]);
    put(stereo[i + 1]);
    for (int channel = 2; channel < form.channels; ++channel) put(0.0F);
  }
}

SoundOutput null_output(int rate_Hz) {
  SoundOutput output{};
  output.form.rate_Hz = rate_Hz;
  output.open = [form = output.form](QIODevice& samples) {
    return std::make_unique<NullConsumer>(samples, form);
  };
  return output;
}

SoundOutput default_output() {
  const QAudioDevice card = QMediaDevices::defaultAudioOutput();
  if (!is_heard(card)) return null_output();
  const QAudioFormat format = format_for(card);
  const std::optional<SampleForm> form = form_of(format);
  if (!form) return null_output();
  SoundOutput output{};
  output.name = card.description();
  output.is_null = false;
  output.form = *form;
  output.buffer_s = kBuffer_s;
  output.open = [card, format](QIODevice& samples) -> std::unique_ptr<SampleConsumer> {
    if (!QMediaDevices::audioOutputs().contains(card)) return nullptr;
    auto consumer = std::make_unique<CardConsumer>(card, format, samples);
    if (!consumer->is_working()) return nullptr;
    return consumer;
  };
  return output;
}

std::vector<QString> sound_outputs() {
  std::vector<QString> names{};
  const QAudioDevice first = QMediaDevices::defaultAudioOutput();
  if (is_heard(first)) names.push_back(first.description());
  for (const QAudioDevice& card : QMediaDevices::audioOutputs()) {
    if (is_heard(card) && card != first) names.push_back(card.description());
  }
  return names;
}

}  // namespace asperity
