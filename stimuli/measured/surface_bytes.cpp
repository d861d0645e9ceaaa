// Implements the reading of numbers from the bytes of a file.

#include <algorithm>
#include <stdexcept>

#include "stimuli/measured/surface_decoding.h"

namespace asperity {

void SurfaceBytes::refuse(std::size_t at, const std::string& problem) const {
  throw std::invalid_argument(name_ + ": byte " + std::to_string(at) + ": " + problem);
}

bool SurfaceBytes::begins_with(std::string_view text) const noexcept {
  return bytes_.size() >= text.size() &&
         std::equal(text.begin(), text.end(), bytes_.begin(),
                    [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

std::span<const std::byte> SurfaceBytes::part(std::size_t at, std::size_t count) const {
  if (at > bytes_.size() || count > bytes_.size() - at) {
    refuse(at, "the file ends " + std::to_string(bytes_.size()) +
                   " bytes after its beginning, before the " + std::to_string(count) +
                   " bytes that follow here; copy or export it again");
  }
  return bytes_.subspan(at, count);
}

std::string_view SurfaceBytes::text(std::size_t at, std::size_t count) const {
  const std::span<const std::byte> bytes = part(at, count);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view SurfaceBytes::text_until_zero(std::size_t at) const {
  const std::string_view rest = text(std::min(at, size()), size() - std::min(at, size()));
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos) {
    refuse(at, "the file ends within the text that begins here; copy or export it again");
  }
  return rest.substr(0, end);
}

std::uint64_t SurfaceBytes::whole(std::size_t at, std::size_t width) const {
  const std::span<const std::byte> bytes = part(at, width);
  std::uint64_t number = 0;
  for (std::size_t i = width; i-- > 0;) {
    number = number << 8U | std::to_integer<std::uint64_t>(bytes[i]);
  }
  return number;
}

}  // namespace asperity
