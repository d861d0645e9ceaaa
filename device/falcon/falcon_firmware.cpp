// Firmware for a Falcon: asked for, and loaded through its boot loader.

#include "device/falcon/falcon_firmware.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"
#include "device/falcon/falcon_frame.h"

namespace asperity::falcon {
namespace {

using std::chrono::milliseconds;

constexpr int kTries = 3;
// Firmware of a Falcon is about 8 KB.
constexpr std::size_t kLargest_bytes = 65536;
// What fits into a packet with its two bytes of modem lines, as it comes back.
constexpr std::size_t kPiece_bytes = 62;
constexpr milliseconds kAnswerPatience{500};
constexpr milliseconds kCallPatience{50};
constexpr milliseconds kFramePatience{30};
constexpr int kCalls = 100;   // of the boot loader, until it answers
constexpr int kFrames = 8;    // to a firmware that may be there
constexpr int kPackets = 64;  // with nothing in them, while an echo is waited for

constexpr std::array<std::uint8_t, 3> kCall{0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> kReady{0x0a, 0x44, 0x2c, 0x0d};
constexpr std::array<std::uint8_t, 1> kStart{0x41};

// Reads until `is_enough` of what came, or the device says nothing for long.
template <typename Enough>
Transfer read_until(FalconPort& port, std::vector<std::uint8_t>& bytes, const std::stop_token& stop,
                    const Enough& is_enough) {
  bytes.clear();
  FalconPort::Packet packet{};
  for (int packets = 0; packets < kPackets && !stop.stop_requested(); ++packets) {
    std::size_t count = 0;
    if (const Transfer ended = port.read(packet, count, kAnswerPatience); ended != Transfer::done) {
      return ended;
    }
    bytes.insert(bytes.end(), packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(count));
    if (is_enough()) return Transfer::done;
  }
  return Transfer::timed_out;
}

bool reaches_boot_loader(FalconPort& port, const std::stop_token& stop) {
  for (int call = 0; call < kCalls && !stop.stop_requested(); ++call) {
    if (port.write(kCall, kCallPatience) == Transfer::gone) return false;
    FalconPort::Packet packet{};
    std::size_t count = 0;
    if (port.read(packet, count, kCallPatience) == Transfer::gone) return false;
    const auto end = packet.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::search(packet.begin(), end, kReady.begin(), kReady.end()) != end) return true;
  }
  return false;
}

// What went wrong, if anything.
std::optional<std::string> complaint_of_load(FalconPort& port,
                                             std::span<const std::uint8_t> firmware,
                                             const std::stop_token& stop) {
  if (port.begin_boot_loader() != Transfer::done) return "its serial chip rejects settings";
  if (!reaches_boot_loader(port, stop)) return "its boot loader does not respond";
  if (port.begin_firmware() != Transfer::done) return "its serial chip rejects settings";
  std::vector<std::uint8_t> echo;
  if (port.write(kStart, kAnswerPatience) != Transfer::done ||
      // Before it may come what the loader still had to say to earlier calls.
      read_until(port, echo, stop, [&] {
        return !echo.empty() && echo.back() == kStart.front();
      }) != Transfer::done) {
    return "its boot loader does not start loading";
  }
  for (std::size_t at = 0; at < firmware.size() && !stop.stop_requested(); at += kPiece_bytes) {
    const auto piece = firmware.subspan(at, std::min(kPiece_bytes, firmware.size() - at));
    if (port.write(piece, kAnswerPatience) != Transfer::done ||
        read_until(port, echo, stop, [&] { return echo.size() >= piece.size(); }) !=
            Transfer::done) {
      return "it stopped accepting the firmware at byte " + std::to_string(at);
    }
    const auto [sent, came] = std::mismatch(piece.begin(), piece.end(), echo.begin(), echo.end());
    if (sent != piece.end() || came != echo.end()) {
      return "byte " + std::to_string(at + static_cast<std::size_t>(sent - piece.begin())) +
             " of the firmware was read back with another value";
    }
  }
  if (port.begin_frames() != Transfer::done) return "its serial chip rejects settings";
  if (!speaks_frames(port, stop)) {
    return "the firmware was loaded but does not respond; it may be that of another device";
  }
  return {};
}

}  // namespace

Firmware read_firmware(const std::filesystem::path& file) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(file, error);  // a pipe would be waited for
  std::ifstream stream;
  if (is_file) stream.open(file, std::ios::binary);
  if (!is_file || !stream) {
    throw std::runtime_error("the Falcon's firmware " + file.string() +
                             " cannot be read: name the file that came with the device's software");
  }
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error || bytes == 0 || bytes > kLargest_bytes) {
    throw std::runtime_error(file.string() + " has " + counted(error ? 0 : bytes, "byte", "bytes") +
                             " and is not the firmware of a Falcon, which has about 8000 "
                             "bytes; name the file that came with the device's software");
  }
  const Firmware firmware{std::istreambuf_iterator<char>(stream), {}};
  const auto is_of_text = [](std::uint8_t byte) {
    return (byte >= 0x20 && byte < 0x7f) || byte == '\n' || byte == '\r' || byte == '\t';
  };
  if (std::all_of(firmware.begin(), firmware.end(), is_of_text)) {
    throw std::runtime_error(file.string() +
                             " is a text file, not the firmware of a Falcon; name the file that "
                             "came with the device's software");
  }
  return firmware;
}

bool speaks_frames(FalconPort& port, const std::stop_token& stop) noexcept {
  const Frame nothing = frame_of({});
  FrameReader reader;
  for (int frame = 0; frame < kFrames && !stop.stop_requested(); ++frame) {
    if (port.write(nothing, kFramePatience) == Transfer::gone) return false;
    const auto until = std::chrono::steady_clock::now() + kFramePatience;
    do {
      FalconPort::Packet packet{};
      std::size_t count = 0;
      if (port.read(packet, count, kFramePatience) == Transfer::gone) return false;
      for (std::size_t i = 0; i < count; ++i) {
        if (reader.take(packet[i])) return true;
      }
    } while (std::chrono::steady_clock::now() < until);
  }
  return false;
}

bool runs_firmware(const UsbSession& usb, const std::string& place, const std::stop_token& stop) {
  try {
    FalconPort port(usb, place);
    return port.begin_frames() == Transfer::done && speaks_frames(port, stop);
  } catch (const std::exception&) {
    return false;
  }
}

std::string no_firmware_sentence(const std::string& place) {
  return "the Novint Falcon at " + place +
         " has no firmware, because it was switched off since its last use: name the file that "
         "came with the device's software (--firmware FILE)";
}

bool load_firmware(FalconPort& port, std::span<const std::uint8_t> firmware,
                   const std::stop_token& stop) {
  std::optional<std::string> complaint;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    complaint = complaint_of_load(port, firmware, stop);
    if (stop.stop_requested()) return false;
    if (!complaint) return true;
  }
  throw std::runtime_error(
      "the Falcon's firmware could not be loaded in three tries: " + *complaint +
      ". Switch the Falcon off and on, plug it into another socket without a hub, and check that "
      "the file is its firmware");
}

}  // namespace asperity::falcon
