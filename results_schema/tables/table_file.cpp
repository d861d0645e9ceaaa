// Writes through a buffer as TSV, CSV or gzip, marks texts that look like formulas, and hashes the bytes.

#include "results_schema/tables/table_file.h"

#include <charconv>
#include <new>
#include <stdexcept>

#include <zlib.h>

#include "results_schema/files/file_system.h"
#include "results_schema/hashes/sha256_stream.h"
#include "results_schema/tables/table_words.h"

namespace asperity {
namespace {

constexpr std::size_t kBuffer_bytes = std::size_t{1} << 18;

/// "-2", "-0.5e-3": what a spreadsheet reads as a number, with the value that the text has.
bool is_negative_number(std::string_view text) {
  if (text.size() < 2 || text.front() != '-' || text[1] < '0' || text[1] > '9') return false;
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc{} && read.ptr == end;
}

bool needs_mark(std::string_view text) {
  return text == kMissingCell ||
         (!text.empty() &&
          std::string_view("=+-@'\t\r\n").find(text.front()) != std::string_view::npos &&
          !is_negative_number(text));
}

template <typename Number>
void append_number(std::string& text, Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

/// Gzip with neither name nor time, so that the same rows give the same bytes.
class Gzip final {
 public:
  Gzip() {
    constexpr int kGzipWindow = 15 + 16;
    constexpr int kMemory = 8;
    if (deflateInit2(&stream_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemory,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();  // the only failure with these arguments
    }
  }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;
  ~Gzip() { deflateEnd(&stream_); }

  std::string compressed(std::string& text, int flush) {
    std::string out{};
    stream_.next_in = reinterpret_cast<Bytef*>(text.data());
    stream_.avail_in = static_cast<uInt>(text.size());
    do {
      const std::size_t before = out.size();
      out.resize(before + kBuffer_bytes);
      stream_.next_out = reinterpret_cast<Bytef*>(out.data() + before);
      stream_.avail_out = static_cast<uInt>(kBuffer_bytes);
      deflate(&stream_, flush);
      out.resize(out.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
    return out;
  }

 private:
  z_stream stream_{};
};

}  // namespace

struct TableFile::State {
  State(const std::filesystem::path& path, Format table_format, std::size_t count)
      : file(path), format(table_format), columns(count) {
    if (format == Format::bare_tsv_gz) gzip = std::make_unique<Gzip>();
    buffer.reserve(kBuffer_bytes + 4096);
  }

  void write(std::string& text) {
    if (text.empty()) return;
    sha256.add(text.data(), text.size());
    file.write(text.data(), text.size());
  }

  void flush(int how) {
    if (gzip) {
      std::string text = gzip->compressed(buffer, how);
      write(text);
    } else {
      write(buffer);
    }
    buffer.clear();
  }

  void add_text(std::string_view text) {
    const bool marked = needs_mark(text);
    if (marked) ++written.marked_cells;
    if (format == Format::csv) {
      const bool quoted = text.empty() || text.find_first_of(",;\"\r\n") != std::string_view::npos;
      if (quoted) buffer += '"';
      if (marked) buffer += '\'';
      for (const char character : text) {
        if (character == '"') buffer += '"';
        buffer += character;
      }
      if (quoted) buffer += '"';
      return;
    }
    if (marked) buffer += '\'';
    bool spaced = false;
    for (const char character : text) {
      const bool breaks = character == '\t' || character == '\n' || character == '\r';
      buffer += breaks ? ' ' : character;
      spaced = spaced || breaks;
    }
    if (spaced) ++written.spaced_cells;
  }

  void add_cell(const Cell& cell) {
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
      append_number(buffer, *whole);
    } else if (const auto* number = std::get_if<double>(&cell)) {
      buffer += text_of_number(*number);
    } else if (const auto* text = std::get_if<std::string>(&cell)) {
      add_text(*text);
    } else if (format != Format::csv) {
      buffer += kMissingCell;
    }
  }

  void end_row() {
    buffer += format == Format::csv ? "\r\n" : "\n";
    if (buffer.size() >= kBuffer_bytes) flush(Z_NO_FLUSH);
  }

  OutputFile file;
  Format format;
  std::size_t columns;
  std::unique_ptr<Gzip> gzip{};
  std::string buffer{};
  Sha256Stream sha256{};
  WrittenTable written{};
};

TableFile::TableFile(const std::filesystem::path& path, Format format,
                     const std::vector<std::string>& columns)
    : state_(std::make_unique<State>(path, format, columns.size())) {
  if (format == Format::bare_tsv_gz) return;
  const char separator = format == Format::csv ? ',' : '\t';
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) state_->buffer += separator;
    state_->add_text(columns[i]);
  }
  state_->end_row();
}

TableFile::TableFile(TableFile&&) noexcept = default;
TableFile& TableFile::operator=(TableFile&&) noexcept = default;
TableFile::~TableFile() = default;

void TableFile::add(const std::vector<Cell>& row) {
  if (row.size() != state_->columns) {
    throw std::invalid_argument("row: the number of cells is " + std::to_string(row.size()) +
                                "; it must be the number of columns, " +
                                std::to_string(state_->columns));
  }
  const char separator = state_->format == Format::csv ? ',' : '\t';
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) state_->buffer += separator;
    state_->add_cell(row[i]);
  }
  state_->end_row();
  ++state_->written.rows;
}

void TableFile::add(double first, const std::vector<float>& rest) {
  if (rest.size() + 1 != state_->columns) {
    throw std::invalid_argument("rest: the number of values is " + std::to_string(rest.size()) +
                                "; it must be the number of columns after the first, " +
                                std::to_string(state_->columns - 1));
  }
  append_number(state_->buffer, first);
  for (const float number : rest) {
    state_->buffer += state_->format == Format::csv ? ',' : '\t';
    append_number(state_->buffer, number);
  }
  state_->end_row();
  ++state_->written.rows;
}

WrittenTable TableFile::finish() {
  state_->flush(Z_FINISH);
  state_->written.sha256 = state_->sha256.hexadecimal();
  return state_->written;
}

}  // namespace asperity
