// Implements JPEG decoding with libjpeg.

#include "stimuli/pictures/jpeg_decoding.h"

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <new>

// libjpeg's header requires the two headers before it.
#include <jpeglib.h>
//
#include <jerror.h>  // needs jpeglib.h before it

namespace asperity {

namespace {

/// The state of libjpeg and of this decoder. `errors` is the first member, because libjpeg returns a pointer to it.
struct Decoding {
  jpeg_error_mgr errors{};
  jpeg_decompress_struct picture{};
  std::jmp_buf on_error{};
  char words[JMSG_LENGTH_MAX]{};
};

void note_and_leave(j_common_ptr common) {
  auto* decoding = reinterpret_cast<Decoding*>(common->err);
  decoding->errors.format_message(common, decoding->words);
  std::longjmp(decoding->on_error, 1);
}

// Negative levels are warnings about data that libjpeg would replace by guesses. Other levels are trace messages.
void note_warning(j_common_ptr common, int level) {
  if (level < 0) note_and_leave(common);
}

/// No object in this function may need a destructor: errors leave it by longjmp.
bool decode_picture(Decoding& decoding, std::span<const std::byte> bytes, JpegPixels wanted,
                    std::span<std::uint8_t> pixels, std::size_t columns) {
  const std::size_t row = columns * (wanted == JpegPixels::colour ? 3 : 1);
  jpeg_decompress_struct& picture = decoding.picture;
  if (setjmp(decoding.on_error) != 0) {
    jpeg_destroy_decompress(&picture);
    return false;
  }
  jpeg_create_decompress(&picture);
  jpeg_mem_src(&picture, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&picture, TRUE);
  picture.out_color_space = wanted == JpegPixels::colour ? JCS_RGB : JCS_GRAYSCALE;
  picture.dct_method = JDCT_ISLOW;  // the accurate one, the same on every processor
  jpeg_start_decompress(&picture);
  if (picture.output_width != columns ||
      std::size_t{picture.output_height} * row != pixels.size()) {
    jpeg_destroy_decompress(&picture);
    return false;
  }
  while (picture.output_scanline < picture.output_height) {
    JSAMPROW next = pixels.data() + std::size_t{picture.output_scanline} * row;
    jpeg_read_scanlines(&picture, &next, 1);
  }
  jpeg_finish_decompress(&picture);
  jpeg_destroy_decompress(&picture);
  return true;
}

}  // namespace

bool decode_jpeg(std::span<const std::byte> bytes, JpegPixels wanted,
                 std::span<std::uint8_t> pixels, std::size_t columns, std::string& complaint) {
  Decoding decoding{};
  decoding.picture.err = jpeg_std_error(&decoding.errors);
  decoding.errors.error_exit = note_and_leave;
  decoding.errors.emit_message = note_warning;
  const bool done = decode_picture(decoding, bytes, wanted, pixels, columns);
  if (!done && decoding.errors.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
  complaint = decoding.words;
  return done;
}

}  // namespace asperity
