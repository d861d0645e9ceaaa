// Firmware for a Falcon, which forgets it when it is switched off.

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "device/falcon/falcon_port.h"

namespace asperity::falcon {

using Firmware = std::vector<std::uint8_t>;

/// The bytes of a file that somebody points at; nothing of it comes with this program.
///
/// Errors: std::runtime_error naming the file, when it cannot be read, is empty, is text, or is far larger
/// than any firmware of a Falcon.
Firmware read_firmware(const std::filesystem::path& file);

/// Whether firmware runs: the device answers a frame that asks for nothing. False, too, when `stop` asks for it.
bool speaks_frames(FalconPort& port, const std::stop_token& stop) noexcept;

/// Likewise for a Falcon that nobody has open; false for one that cannot be opened now.
bool runs_firmware(const UsbSession& usb, const std::string& place, const std::stop_token& stop);

/// What to do about a Falcon without firmware when no file is known.
std::string no_firmware_sentence(const std::string& place);

/// Loads `firmware` and lets it run, in up to three tries: the boot loader is known to fail now and
/// then. The device sends every byte back, and each is compared.
///
/// Errors: std::runtime_error saying what the device did in the last try; nothing is thrown, and false
/// returned, when `stop` asks for it: after the transfer under way, which takes 0.5 s at the worst.
bool load_firmware(FalconPort& port, std::span<const std::uint8_t> firmware,
                   const std::stop_token& stop);

}  // namespace asperity::falcon
