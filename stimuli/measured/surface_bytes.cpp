// Implements the reading of numbers from the bytes of a file.

#include <algorithm>

#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"

namespace asperity {

void SurfaceBytes::refuse(std::size_t at, const Phrase& problem) const {
  throw PhrasedRefusal(
      phrase("Stimuli", "%1: byte %2: %3").with(name_, std::to_string(at), problem));
}

bool SurfaceBytes::begins_with(std::string_view text) const noexcept {
  return bytes_.size() >= text.size() &&
         std::equal(text.begin(), text.end(), bytes_.begin(),
                    [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

std::span<const std::byte> SurfaceBytes::part(std::size_t at, std::size_t count) const {
  if (at > bytes_.size() || count > bytes_.size() - at) {
    refuse(at, phrase("Stimuli",
                      "the file ends %1 bytes after its beginning, before the %2 bytes that follow "
                      "here; copy or export it again")
                   .with(std::to_string(bytes_.size()), std::to_string(count)));
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
    refuse(at, phrase("Stimuli",
                      "the file ends within the text that begins here; copy or export it again"));
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
