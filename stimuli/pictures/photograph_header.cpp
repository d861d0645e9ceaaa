// Implements the parsing of picture headers and the check that a file is complete.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/pictures/float_tiff.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

namespace {

using Bytes = std::span<const std::byte>;

class HeaderReader final {
 public:
  HeaderReader(Bytes bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  /// %1 of the sentence is the name of the file.
  template <class... Values>
  [[noreturn]] void refuse(const Phrase& sentence, const Values&... values) const {
    throw PhrasedRefusal(sentence.with(name_, values...));
  }
  [[noreturn]] void refuse_cut_off() const {
    refuse(
        phrase("Stimuli",
               "%1 is truncated or damaged: the file ends before the end of the picture. Copy or "
               "export it again."));
  }

  // The size is checked first: a picture that is too large is rejected for its size, complete or not.
  void refuse_wrong_size(const PictureFacts& facts) const {
    const std::string columns = std::to_string(facts.columns);
    const std::string rows = std::to_string(facts.rows);
    if (facts.rows == 0 || facts.columns == 0) {
      refuse(phrase("Stimuli",
                    "%1 cannot be read: its header states %2 by %3 pixels. Copy or export it "
                    "again."),
             columns, rows);
    }
    if (facts.rows > kLargestPictureSide || facts.columns > kLargestPictureSide) {
      refuse(
          phrase("Stimuli",
                 "%1 is %2 by %3 pixels; at most %4 per side are possible. Scale it down or crop "
                 "it."),
          columns, rows, std::to_string(kLargestPictureSide));
    }
  }

  std::size_t size() const noexcept { return bytes_.size(); }

  std::uint32_t big_endian(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8U | byte(at + i);
    return value;
  }
  std::uint32_t little_endian(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8U | byte(at + i);
    return value;
  }
  std::uint32_t byte(std::size_t at) const {
    if (at >= bytes_.size()) refuse_cut_off();
    return std::to_integer<std::uint32_t>(bytes_[at]);
  }
  bool has(std::size_t at, std::string_view text) const {
    if (at + text.size() > bytes_.size()) return false;
    return std::equal(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
  }
  Bytes part(std::size_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) refuse_cut_off();
    return bytes_.subspan(at, count);
  }

 private:
  Bytes bytes_;
  const std::string& name_;
};

std::uint32_t crc32(Bytes bytes) noexcept {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) {
        value = (value & 1U) != 0 ? 0xEDB88320U ^ (value >> 1U) : value >> 1U;
      }
      table[i] = value;
    }
    return table;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::byte b : bytes) {
    crc = kTable[(crc ^ std::to_integer<std::uint32_t>(b)) & 0xFFU] ^ (crc >> 8U);
  }
  return ~crc;
}

PictureFacts inspect_png(const HeaderReader& file) {
  constexpr std::size_t kSignature = 8;
  if (!file.has(kSignature + 4, "IHDR")) {
    file.refuse(phrase("Stimuli",
                       "%1 is truncated or damaged: a PNG begins with its size (IHDR), and this "
                       "one does not. Copy "
                       "or export it again."));
  }
  PictureFacts facts{.format = PictureFormat::png,
                     .rows = file.big_endian(kSignature + 12, 4),
                     .columns = file.big_endian(kSignature + 8, 4),
                     .bits_per_channel = static_cast<int>(file.byte(kSignature + 16)),
                     .channels = 1};
  switch (file.byte(kSignature + 17)) {
    case 0:
      break;
    case 2:
    case 3:  // a palette
      facts.channels = 3;
      break;
    case 4:
      facts.channels = 2;
      break;
    case 6:
      facts.channels = 4;
      break;
    default:
      file.refuse(
          phrase("Stimuli",
                 "%1 is damaged: its colour type does not exist in PNG. Copy or export it again."));
  }
  if (facts.bits_per_channel < 8) facts.bits_per_channel = 8;  // the decoded depth

  file.refuse_wrong_size(facts);
  // Every chunk has a checksum, so that this loop detects truncated and changed files.
  for (std::size_t at = kSignature;;) {
    const std::size_t length = file.big_endian(at, 4);
    if (crc32(file.part(at + 4, length + 4)) != file.big_endian(at + 8 + length, 4)) {
      file.refuse(phrase(
          "Stimuli", "%1 is damaged: a checksum in it does not match. Copy or export it again."));
    }
    if (file.has(at + 4, "IEND")) return facts;
    at += 12 + length;
  }
}

/// True for the frame headers SOF0 to SOF15, which contain the size; C4, C8 and CC are other markers.
bool is_frame_header(std::uint32_t marker) noexcept {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

PictureFacts inspect_jpeg(const HeaderReader& file) {
  PictureFacts facts{.format = PictureFormat::jpeg};
  std::size_t at = 2;  // after the start of image
  for (;;) {
    // Within a scan a data byte FF is followed by 00, and restart markers (D0 to D7) have no length.
    while (file.byte(at) != 0xFF) ++at;
    const std::uint32_t marker = file.byte(at + 1);
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    at += 2;
    if (marker == 0x00 || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD7)) continue;
    if (marker == 0xD9) break;
    const std::size_t length = file.big_endian(at, 2);
    if (length < 2)
      file.refuse(
          phrase("Stimuli",
                 "%1 is damaged: a segment of this JPEG has no length. Copy or export it again."));
    if (is_frame_header(marker)) {
      facts.bits_per_channel = static_cast<int>(file.byte(at + 2));
      facts.rows = file.big_endian(at + 3, 2);
      facts.columns = file.big_endian(at + 5, 2);
      facts.channels = static_cast<int>(file.byte(at + 7));
      file.refuse_wrong_size(facts);
    }
    at += length;
  }
  if (facts.channels == 0) file.refuse_cut_off();
  if (facts.bits_per_channel != 8) {
    file.refuse(
        phrase("Stimuli",
               "%1 is a JPEG with %2 per channel; only 8 are supported. Save it as a 16-bit "
               "PNG or TIFF instead."),
        (facts.bits_per_channel == 1 ? phrase("Stimuli", "%1 bit") : phrase("Stimuli", "%1 bits"))
            .with(std::to_string(facts.bits_per_channel)));
  }
  if (facts.channels != 1 && facts.channels != 3) {
    file.refuse(phrase("Stimuli",
                       "%1 is a JPEG with %2 colour channels (probably CMYK); save it as greyscale "
                       "or RGB."),
                std::to_string(facts.channels));
  }
  return facts;
}

/// The first directory of a TIFF. The offsets and lengths of its strips or tiles are numbers at these places.
struct TiffDirectory {
  struct Entry {
    std::size_t count = 0;
    std::size_t width = 0;
    std::size_t at = 0;
  };
  PictureFacts facts{
      .format = PictureFormat::tiff, .rows = 0, .columns = 0, .bits_per_channel = 1, .channels = 1};
  std::uint32_t sample_format = 1;  // 1: whole numbers, 2: with a sign, 3: floating-point numbers
  Entry offsets{};
  Entry lengths{};
};

std::uint32_t tiff_number(const HeaderReader& file, std::size_t at, std::size_t count) {
  return file.has(0, "MM") ? file.big_endian(at, count) : file.little_endian(at, count);
}

bool is_tiff(const HeaderReader& file) {
  if (file.size() <= 3) return false;
  return (file.has(0, "II") && file.byte(3) == 0) || (file.has(0, "MM") && file.byte(2) == 0);
}

/// The number in the text of GDAL's entry for missing points.
float no_data_in(const HeaderReader& file, std::size_t at, std::size_t count) {
  std::string text{};
  for (std::size_t i = 0; i < count; ++i) text += static_cast<char>(file.byte(at + i));
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  const std::size_t begin = std::min(text.find_first_not_of(" +"), text.size());
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + begin, end, number);
  if (read.ec != std::errc() || read.ptr != end) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    file.refuse(phrase("Stimuli",
                       "%1 is a TIFF that states \"%2\" as the value of missing points, which is "
                       "not a number; export it again."),
                text.substr(0, 40));
  }
  return static_cast<float>(number);  // as the points are stored
}

TiffDirectory tiff_directory(const HeaderReader& file) {
  const auto number = [&file](std::size_t at, std::size_t count) {
    return tiff_number(file, at, count);
  };
  if (number(2, 2) != 42) {
    file.refuse(phrase(
        "Stimuli",
        "%1 is a BigTIFF or another kind of TIFF that is not supported; save it as plain TIFF or "
        "PNG."));
  }
  TiffDirectory read{};
  PictureFacts& facts = read.facts;
  std::set<std::uint32_t> tags{};
  const std::size_t directory = number(4, 4);
  const std::size_t entries = number(directory, 2);
  file.part(directory, 2 + 12 * entries + 4);  // it ends with the offset of the next directory
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    const std::uint32_t type = number(at + 2, 2);
    const std::size_t width = type == 3 ? 2 : type == 4 ? 4 : 1;
    const std::size_t count = number(at + 4, 4);
    const bool inside = count * width <= 4;
    const TiffDirectory::Entry entry{
        .count = count, .width = width, .at = inside ? at + 8 : number(at + 8, 4)};
    if (!inside) file.part(entry.at, count * width);
    const auto first = [&] { return number(entry.at, entry.width); };
    const std::uint32_t tag = number(at, 2);
    if (!tags.insert(tag).second) {
      file.refuse(phrase("Stimuli",
                         "%1 is a TIFF that states the entry %2 of its directory twice; export it "
                         "again."),
                  std::to_string(tag));
    }
    switch (tag) {
      case 256:
        facts.columns = first();
        break;
      case 257:
        facts.rows = first();
        break;
      case 258:
        facts.bits_per_channel = static_cast<int>(first());
        break;
      case 274:
        if (first() > 1) {
          file.refuse(phrase("Stimuli",
                             "%1 is a TIFF that is to be turned or mirrored when it is shown "
                             "(orientation %2), so that the directions of its rows and columns are "
                             "unclear; save it upright, with the orientation 1."),
                      std::to_string(first()));
        }
        break;
      case 277:
        facts.channels = static_cast<int>(first());
        break;
      case 339:
        read.sample_format = first();
        break;
      case 42113:
        facts.no_data = no_data_in(file, entry.at, count);
        break;
      case 273:  // strips or
      case 324:  // tiles
        read.offsets = entry;
        break;
      case 279:
      case 325:
        read.lengths = entry;
        break;
      default:
        break;
    }
  }
  facts.has_further_pages = number(directory + 2 + 12 * entries, 4) != 0;
  file.refuse_wrong_size(facts);
  return read;
}

/// Checks that the strips or tiles lie within the file.
void check_tiff_data(const HeaderReader& file, const TiffDirectory& read) {
  const auto number = [&file](const TiffDirectory::Entry& entry, std::size_t i) {
    return tiff_number(file, entry.at + i * entry.width, entry.width);
  };
  if (read.offsets.count == 0 || read.offsets.count != read.lengths.count) file.refuse_cut_off();
  for (std::size_t i = 0; i < read.offsets.count; ++i) {
    file.part(number(read.offsets, i), number(read.lengths, i));
  }
}

PictureFacts inspect_tiff(const HeaderReader& file) {
  const TiffDirectory read = tiff_directory(file);
  const PictureFacts& facts = read.facts;
  const std::uint32_t sample_format = read.sample_format;
  if (sample_format != 1 || (facts.bits_per_channel != 8 && facts.bits_per_channel != 16)) {
    const Phrase numbers = sample_format == 3 ? phrase("Stimuli", "%1-bit floating-point numbers")
                           : sample_format == 2
                               ? phrase("Stimuli", "%1-bit whole numbers with a sign")
                               : phrase("Stimuli", "%1-bit channels");
    file.refuse(phrase("Stimuli",
                       "%1 is a TIFF with %2; save a photograph with whole numbers of 8 or 16 bits "
                       "without a sign, and measured heights with 32-bit floating-point numbers."),
                numbers.with(std::to_string(facts.bits_per_channel)));
  }
  if (facts.channels < 1 || facts.channels > 4) {
    file.refuse(phrase("Stimuli",
                       "%1 is a TIFF with %2 channels; save it with 1 to 4 (greyscale or colour, "
                       "with or without alpha)."),
                std::to_string(facts.channels));
  }
  check_tiff_data(file, read);
  return facts;
}

PictureFacts inspect_bmp(const HeaderReader& file) {
  const std::size_t data = file.little_endian(10, 4);
  if (file.little_endian(14, 4) < 40) {
    file.refuse(phrase(
        "Stimuli",
        "%1 is a BMP in the format used before 1990, which is not supported; save it as PNG."));
  }
  const auto rows = static_cast<std::int32_t>(file.little_endian(22, 4));
  const auto columns = static_cast<std::int32_t>(file.little_endian(18, 4));
  const std::size_t bits = file.little_endian(28, 2);
  const std::uint32_t compression = file.little_endian(30, 4);
  // A negative number of rows means that the top row comes first.
  const PictureFacts facts{.format = PictureFormat::bmp,
                           .rows = static_cast<std::size_t>(std::abs(std::int64_t{rows})),
                           .columns = columns > 0 ? static_cast<std::size_t>(columns) : 0,
                           .bits_per_channel = 8,
                           .channels = bits == 32 ? 4 : 3};
  file.refuse_wrong_size(facts);
  if (compression == 1 || compression == 2) {
    // The length of run-length data is not stored; the file's size is.
    file.part(0, file.little_endian(2, 4));
  } else {
    file.part(data, (facts.columns * bits + 31) / 32 * 4 * facts.rows);
  }
  return facts;
}

PictureFacts inspect_webp(const HeaderReader& file) {
  PictureFacts facts{.format = PictureFormat::webp, .bits_per_channel = 8, .channels = 3};
  if (file.has(12, "VP8 ")) {
    facts.columns = file.little_endian(26, 2) & 0x3FFFU;
    facts.rows = file.little_endian(28, 2) & 0x3FFFU;
  } else if (file.has(12, "VP8L")) {
    const std::uint32_t packed = file.little_endian(21, 4);
    facts.columns = (packed & 0x3FFFU) + 1;
    facts.rows = (packed >> 14U & 0x3FFFU) + 1;
    facts.channels = (packed >> 28U & 1U) != 0 ? 4 : 3;
  } else if (file.has(12, "VP8X")) {
    const std::uint32_t flags = file.byte(20);
    if ((flags & 0x02U) != 0)
      file.refuse(phrase("Stimuli", "%1 is an animation; save a single picture of it."));
    facts.columns = file.little_endian(24, 3) + 1;
    facts.rows = file.little_endian(27, 3) + 1;
    facts.channels = (flags & 0x10U) != 0 ? 4 : 3;
  } else {
    file.refuse(phrase(
        "Stimuli",
        "%1 is damaged: a WebP contains a VP8 picture, and this one does not. Copy or export it "
        "again."));
  }
  file.refuse_wrong_size(facts);
  file.part(8, file.little_endian(4, 4));
  return facts;
}

PictureFacts inspect_any(const HeaderReader& file) {
  if (file.size() == 0) {
    file.refuse(
        phrase("Stimuli",
               "%1 is empty; copy or export the picture (PNG, JPEG, TIFF, BMP or WebP) again."));
  }
  if (file.has(0, "\x89PNG\r\n\x1A\n")) return inspect_png(file);
  if (file.has(0, "\xFF\xD8\xFF")) return inspect_jpeg(file);
  if (is_tiff(file)) return inspect_tiff(file);
  if (file.has(0, "BM")) return inspect_bmp(file);
  if (file.has(0, "RIFF") && file.has(8, "WEBP")) return inspect_webp(file);
  file.refuse(phrase(
      "Stimuli",
      "%1 is not a picture in a supported format; save it as PNG, JPEG, TIFF, BMP or WebP."));
}

}  // namespace

std::string_view name_of(PictureFormat format) noexcept {
  switch (format) {
    case PictureFormat::png:
      return "PNG";
    case PictureFormat::jpeg:
      return "JPEG";
    case PictureFormat::tiff:
      return "TIFF";
    case PictureFormat::bmp:
      return "BMP";
    case PictureFormat::webp:
      return "WebP";
  }
  return "";
}

PictureFacts inspect_picture(Bytes bytes, const std::string& name) {
  return inspect_any(HeaderReader(bytes, name));
}

bool is_float_tiff(Bytes bytes, const std::string& name) {
  const HeaderReader file(bytes, name);
  return is_tiff(file) && tiff_directory(file).sample_format == 3;
}

PictureFacts inspect_float_tiff(Bytes bytes, const std::string& name) {
  const HeaderReader file(bytes, name);
  if (!is_tiff(file)) file.refuse(phrase("Stimuli", "%1 is not a TIFF; save the heights as TIFF."));
  const TiffDirectory read = tiff_directory(file);
  if (read.sample_format != 3 || read.facts.bits_per_channel != 32 || read.facts.channels != 1) {
    file.refuse(read.facts.channels == 1
                    ? phrase("Stimuli",
                             "%1 is a TIFF with %2 channel of %3 bits; save the heights as one "
                             "channel of 32-bit floating-point numbers.")
                    : phrase("Stimuli",
                             "%1 is a TIFF with %2 channels of %3 bits; save the heights as one "
                             "channel of 32-bit floating-point numbers."),
                std::to_string(read.facts.channels), std::to_string(read.facts.bits_per_channel));
  }
  check_tiff_data(file, read);
  return read.facts;
}

}  // namespace asperity
