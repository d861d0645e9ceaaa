// Decodes 16-bit PCM of limited length, and averages two channels.

#include "app/gui/sound/speech_file.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include <QtCore/QBuffer>
#include <QtCore/QByteArray>
#include <QtMultimedia/QAudioFormat>
#include <QtMultimedia/QWaveDecoder>

#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

constexpr int kLongest_s = 30;

std::runtime_error error_about(const std::filesystem::path& file, const std::string& what) {
  return std::runtime_error(file.string() + ": " + what);
}

}  // namespace

CueRecording read_speech(const std::filesystem::path& file) {
  QByteArray content = QByteArray::fromStdString(read_file(file, kSpeechFile));
  QBuffer bytes(&content);
  bytes.open(QIODevice::ReadOnly);
  QWaveDecoder wave(&bytes);
  const bool opened = wave.open(QIODevice::ReadOnly);
  const QAudioFormat format = wave.audioFormat();
  if (!opened || !format.isValid()) throw error_about(file, "is not a WAV file; save it as WAV");
  if (format.sampleFormat() != QAudioFormat::Int16 || format.channelCount() > 2) {
    throw error_about(file, "is not 16-bit PCM with one or two channels; convert it");
  }
  const int channels = format.channelCount();
  const qint64 longest = qint64{kLongest_s} * format.sampleRate() * format.bytesPerFrame();
  const QByteArray pcm = wave.read(longest + format.bytesPerFrame());
  if (pcm.size() > longest) {
    throw error_about(file, "is longer than " + std::to_string(kLongest_s) + " s; shorten it");
  }
  CueRecording recording{};
  recording.rate_Hz = format.sampleRate();
  recording.samples.resize(static_cast<std::size_t>(pcm.size() / format.bytesPerFrame()));
  const char* next = pcm.constData();
  for (float& sample : recording.samples) {
    int sum = 0;
    for (int channel = 0; channel < channels; ++channel, next += 2) {
      std::int16_t value = 0;
      std::memcpy(&value, next, sizeof(value));
      sum += value;
    }
    sample = static_cast<float>(sum) / (32768.0F * static_cast<float>(channels));
  }
  return recording;
}

}  // namespace asperity
