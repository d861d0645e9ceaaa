// Mutates bytes, digits and archives of valid files, and counts how they are read or refused.

#include "tests/stimuli/surface_fuzz.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/random.h"
#include "stimuli/measured/surface_relief.h"
#include "tests/stimuli/surface_file.h"

namespace asperity::test {

namespace {

MeasuredSurface fuzzed_surface() {
  MeasuredSurface surface{.rows = 6, .columns = 9, .pitch_x_m = 2e-6, .pitch_y_m = 3e-6};
  for (int i = 0; i < 54; ++i) surface.heights_m.push_back(1e-9 * ((131 * i) % 1000));
  surface.heights_m[20] = std::numeric_limits<double>::quiet_NaN();
  return surface;
}

std::size_t place_in(const std::string& bytes, Random& random) {
  return static_cast<std::size_t>(random.below(bytes.size()));
}

/// Changes, inserts or removes bytes, or writes a number that is likely to be a bound.
void mutate(std::string& bytes, Random& random) {
  static constexpr std::array<std::uint64_t, 8> kNumbers{
      0, 1, 0x7F, 0xFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF, 1000000000};
  for (std::uint64_t change = 1 + random.below(4); change > 0 && !bytes.empty(); --change) {
    const std::size_t at = place_in(bytes, random);
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << random.below(8));
        break;
      case 2:
        bytes.insert(at, bytes.substr(place_in(bytes, random), random.below(40)));
        break;
      case 3:
        bytes.erase(at, random.below(20));
        break;
      case 4: {
        const std::string number = little_endian(kNumbers[random.below(kNumbers.size())],
                                                 std::size_t{1} << random.below(4));
        bytes.replace(at, number.size(), number);
        break;
      }
      default:
        if (random.below(8) == 0) bytes.resize(at);
        break;
    }
  }
}

/// Replaces digits of a text, so that it often remains valid XML.
void mutate_digits(std::string& text, Random& random) {
  for (std::uint64_t change = 1 + random.below(4); change > 0; --change) {
    const std::size_t at = text.find_first_of("0123456789", place_in(text, random));
    if (at == std::string::npos) continue;
    static constexpr std::array<const char*, 7> kTexts{"0", "9", "-", "e5", "", "999999999", "."};
    text.replace(at, 1, kTexts[random.below(kTexts.size())]);
  }
}

/// Half of the files are damaged as archives, the others have damaged entries with correct checksums.
std::string mutated_x3p(const MeasuredSurface& surface, Random& random) {
  const char type = "ILFD"[random.below(4)];
  std::map<std::string, std::string> entries = x3p_entries_of(surface, type);
  const std::uint64_t what = random.below(4);
  if (what == 1) mutate(entries["main.xml"], random);
  if (what == 2) mutate_digits(entries["main.xml"], random);
  if (what == 3) {
    for (auto& [path, content] : entries) {
      if (random.below(2) == 0) mutate(content, random);
    }
  }
  std::string file = zip_of(entries);
  if (what == 0) mutate(file, random);
  return file;
}

std::string mutated_file(SurfaceFormat format, const MeasuredSurface& surface, Random& random) {
  std::string file{};
  switch (format) {
    case SurfaceFormat::x3p:
      return mutated_x3p(surface, random);
    case SurfaceFormat::sur:
      file = sur_of(surface, random.below(2) == 0 ? 16 : 32, random.below(2) == 0);
      // Otherwise nearly all changes are among the heights or in texts.
      if (random.below(2) == 0) {
        std::string header = file.substr(84, 50);
        mutate(header, random);
        file.replace(84, 50, header);
      }
      break;
    case SurfaceFormat::gwy:
      file = gwy_of(surface);
      break;
    case SurfaceFormat::tiff:
      file = float_tiff_of(surface, 1e-6);
      if (random.below(2) == 0) {
        std::string directory = file.substr(4, 140);
        mutate(directory, random);
        file.replace(4, 140, directory);
      }
      break;
  }
  mutate(file, random);
  return file;
}

}  // namespace

FuzzTally fuzz_surfaces(SurfaceFormat format,
                        const std::function<bool(const FuzzTally&)>& is_enough) {
  Random random = Random(20261125).split(name_of(format));
  const MeasuredSurface surface = fuzzed_surface();
  SurfaceReading reading{};
  if (format == SurfaceFormat::tiff) reading = {.width_m = 1.8e-5, .height_unit_m = 1e-6};
  FuzzTally tally{};
  while (!is_enough(tally)) {
    const std::string file = mutated_file(format, surface, random);
    try {
      const MeasuredSurface decoded =
          decode_surface(std::as_bytes(std::span(file)), reading, "fuzzed");
      const SurfaceRelief relief = surface_relief(decoded, SurfaceForm::plane, "fuzzed");
      if (!std::isfinite(relief.field.rms_m())) throw std::logic_error("heights are not finite");
      ++tally.accepted;
    } catch (const std::invalid_argument& refusal) {
      if (!std::string(refusal.what()).starts_with("fuzzed"))
        throw std::logic_error(refusal.what());
      ++tally.refused;
    }
  }
  return tally;
}

}  // namespace asperity::test
