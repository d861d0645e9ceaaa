// Recordings: written chunk by chunk, read with every checksum looked at.

#include "results_schema/recording.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>

#include <nlohmann/json.hpp>
#include <zstd.h>
#include <zstd_errors.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/files/file_system.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/hashes/sha256_stream.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "asperity.recording/1";
constexpr int kCompressionLevel =
    3;  // zstd's own default: 1 kHz of 24 columns costs 1 ms per second
constexpr std::size_t kChunkHead_bytes = 16;
constexpr std::size_t kChecksum_bytes = 8;

/// What stands before each chunk's payload.
struct ChunkHead {
  std::uint32_t records = 0;  ///< 0 in the last chunk
  std::uint32_t bytes = 0;
};

/// The first bytes of the SHA-256 of head and payload.
std::array<unsigned char, kChecksum_bytes> checksum_of(const ChunkHead& head, const void* payload) {
  Sha256Stream stream;
  stream.add(&head.records, sizeof head.records);
  stream.add(&head.bytes, sizeof head.bytes);
  stream.add(payload, head.bytes);
  std::array<unsigned char, kChecksum_bytes> checksum{};
  const auto digest = stream.digest();
  std::copy_n(digest.begin(), kChecksum_bytes, checksum.begin());
  return checksum;
}

/// One second of records.
std::size_t chunk_records(double rate_Hz) {
  return static_cast<std::size_t>(std::max(1.0, std::round(rate_Hz)));
}

std::size_t record_bytes(std::size_t columns) {
  return sizeof(std::int64_t) + columns * sizeof(float);
}

Json json_of(const RecordingHeader& header) {
  Json columns = Json::array();
  columns.push_back({{"name", "time_ns"},
                     {"type", "int64"},
                     {"unit", "ns"},
                     {"meaning", "monotonic time of the tick, on the session's clock"}});
  for (const RecordingColumn& column : header.columns) {
    columns.push_back({{"name", column.name},
                       {"type", "float32"},
                       {"unit", column.unit},
                       {"meaning", column.meaning}});
  }
  return {{"format", kFormat},
          {"rate_Hz", header.rate_Hz},
          {"chunk_records", chunk_records(header.rate_Hz)},
          {"columns", columns},
          {"context", Json::parse(header.context_json)}};
}

void refuse_bad_header(const RecordingHeader& header) {
  constexpr double kFastest_Hz = 1e6;
  if (!(header.rate_Hz > 0.0 && header.rate_Hz <= kFastest_Hz)) {
    throw std::invalid_argument("rate_Hz is " + Json(header.rate_Hz).dump() +
                                "; it must be above 0 and at most 1000000");
  }
  for (const RecordingColumn& column : header.columns) {
    if (column.name.empty() || column.name == "time_ns") {
      throw std::invalid_argument("a column has the name \"" + column.name +
                                  "\"; every column needs a name other than time_ns");
    }
  }
  if (!Json::accept(header.context_json)) {
    throw std::invalid_argument("context_json is not JSON; it must be a JSON text");
  }
}

/// "a/b.x", then "a/b-2.x", "a/b-3.x", …
std::string numbered(const std::string& path, int number) {
  if (number == 1) return path;
  const std::filesystem::path whole(path);
  return (whole.parent_path() / whole.stem()).string() + "-" + std::to_string(number) +
         whole.extension().string();
}

}  // namespace

struct RecordingWriter::File {
  File(std::string file_path, const std::filesystem::path& file_target, std::size_t columns,
       std::size_t records_per_chunk)
      : path(std::move(file_path)),
        target(file_target),
        output(part_of(file_target)),
        values(columns),
        chunk(records_per_chunk) {}

  void put(const void* data, std::size_t count) {
    // A write that failed has left a torn chunk: what follows it could not be read.
    if (torn) fail_on_file(output.path(), "written", EIO);
    torn = true;
    output.write(data, count);
    torn = false;
    sha256.add(data, count);
    bytes += static_cast<std::int64_t>(count);
  }

  void put_chunk(const ChunkHead& head, const void* payload) {
    std::array<unsigned char, kChunkHead_bytes> start{};
    std::memcpy(start.data(), &head.records, sizeof head.records);
    std::memcpy(start.data() + 4, &head.bytes, sizeof head.bytes);
    const auto checksum = checksum_of(head, payload);
    std::memcpy(start.data() + 8, checksum.data(), checksum.size());
    put(start.data(), start.size());
    put(payload, head.bytes);
  }

  void flush() {
    if (time_ns.empty()) return;
    std::vector<unsigned char> plain(time_ns.size() * record_bytes(values.size()));
    unsigned char* next = plain.data();
    const auto append_column = [&next](const auto& column) {
      const std::size_t count = column.size() * sizeof column[0];
      std::memcpy(next, column.data(), count);
      next += count;
    };
    append_column(time_ns);
    for (const auto& column : values) append_column(column);

    std::vector<unsigned char> packed(ZSTD_compressBound(plain.size()));
    const std::size_t size =
        ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), kCompressionLevel);
    // Of a buffer of the largest size that it may need, only its own memory can be missing.
    if (ZSTD_isError(size) != 0) fail_on_file(output.path(), "written", ENOMEM);
    put_chunk({.records = static_cast<std::uint32_t>(time_ns.size()),
               .bytes = static_cast<std::uint32_t>(size)},
              packed.data());
    time_ns.clear();
    for (auto& column : values) column.clear();
  }

  std::string path;
  std::filesystem::path target;
  OutputFile output;
  Sha256Stream sha256{};
  std::int64_t bytes = 0;
  std::int64_t records = 0;
  bool torn = false;
  bool finished = false;
  std::vector<std::int64_t> time_ns{};
  std::vector<std::vector<float>> values;
  std::size_t chunk;
};

RecordingWriter::RecordingWriter(const std::filesystem::path& study, const std::string& path,
                                 const RecordingHeader& header) {
  refuse_bad_header(header);
  make_folders(path_in_study(study, path).parent_path());
  for (int number = 1; !file_; ++number) {
    const std::string name = numbered(path, number);
    const std::filesystem::path target = path_in_study(study, name);
    if (std::filesystem::exists(target)) continue;
    try {
      file_ = std::make_unique<File>(name, target, header.columns.size(),
                                     chunk_records(header.rate_Hz));
    } catch (const ResultsError& taken) {
      if (taken.code() != EEXIST) throw;
    }
  }
  const std::string line = json_of(header).dump();
  const std::string start = line + "\n" + sha256_of(line) + "\n";
  file_->put(start.data(), start.size());
}

RecordingWriter::~RecordingWriter() {
  if (file_->finished || file_->torn) return;
  try {
    file_->flush();
  } catch (const std::exception&) {
    // The attempt is lost already; what is on disk stays there.
  }
}

void RecordingWriter::append(std::int64_t time_ns, const float* values) {
  file_->time_ns.push_back(time_ns);
  for (std::size_t i = 0; i < file_->values.size(); ++i) file_->values[i].push_back(values[i]);
  ++file_->records;
  if (file_->time_ns.size() == file_->chunk) file_->flush();
}

RecordingRow RecordingWriter::finish() {
  if (file_->finished)
    throw std::logic_error("the recording is already finished; finish it only once");
  file_->flush();
  const auto total = static_cast<std::uint64_t>(file_->records);
  file_->put_chunk({.records = 0, .bytes = sizeof total}, &total);
  file_->output.sync_and_close();
  if (!rename_to_free_name(file_->output.path(), file_->target)) {
    fail_on_file(file_->target, "made", EEXIST);
  }
  // Every name from the study down to the file: the folders of its participant and session may be new.
  const std::filesystem::path in_study(file_->path);
  std::filesystem::path folder = file_->target;
  for (auto left = std::distance(in_study.begin(), in_study.end()); left > 0; --left) {
    folder = folder.parent_path();
    sync_folder(folder);
  }
  file_->finished = true;
  return {.path = file_->path,
          .format = kFormat,
          .sha256 = file_->sha256.hexadecimal(),
          .records = file_->records,
          .bytes = file_->bytes};
}

namespace {

/// A recording in memory, taken from front to back.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : path_(path), content_(read_file(path, kRecordingFile)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw ResultsError("the recording " + path_.string() + " " + what, path_);
  }
  [[noreturn]] void fail_at(std::size_t chunk, std::size_t offset, const std::string& what) const {
    fail("is damaged in chunk " + std::to_string(chunk) + ", at byte " + std::to_string(offset) +
         ": " + what + "; restore the file from a copy of the study");
  }

  RecordingHeader header() {
    const std::string line = take_line();
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("format") || !json["format"].is_string()) {
      fail(
          "is not a recording: its first line must be a JSON object with \"format\"; "
          "name a recording");
    }
    const auto format = json["format"].get<std::string>();
    if (format != kFormat) {
      fail("has the format \"" + format + "\"; this program reads \"" + kFormat +
           "\". Read it with the version that wrote it");
    }
    if (take_line() != sha256_of(line)) {
      fail(
          "is damaged in its header, whose SHA-256 differs from the checksum in its second line; "
          "restore the file from a copy of the study");
    }
    try {
      RecordingHeader header;
      header.rate_Hz = json.at("rate_Hz").get<double>();
      if (!(header.rate_Hz > 0.0)) {
        fail("states rate_Hz " + json.at("rate_Hz").dump() +
             " in its header; it must be above 0. Restore the file from a copy of the study");
      }
      largest_chunk_ = json.at("chunk_records").get<std::size_t>();
      for (const Json& column : json.at("columns")) {
        header.columns.push_back({.name = column.at("name").get<std::string>(),
                                  .unit = column.at("unit").get<std::string>(),
                                  .meaning = column.at("meaning").get<std::string>()});
      }
      if (header.columns.empty() || header.columns.front().name != "time_ns") {
        fail(
            "does not have time_ns as its first column; restore the file from a copy of the study");
      }
      header.columns.erase(header.columns.begin());
      header.context_json = json.at("context").dump();
      return header;
    } catch (const nlohmann::json::exception&) {
      fail(
          "has a header in which an entry of its format is missing or has another type; "
          "restore the file from a copy of the study");
    }
  }

  /// False after the last chunk.
  bool take_chunk(Recording& recording) {
    const std::size_t chunk = ++chunk_;
    const std::size_t start = offset_;
    if (content_.size() - start < kChunkHead_bytes) {
      fail_at(chunk, start, "the file ends before the header of the chunk");
    }
    ChunkHead head;
    std::array<unsigned char, kChecksum_bytes> checksum{};
    std::memcpy(&head.records, content_.data() + start, 4);
    std::memcpy(&head.bytes, content_.data() + start + 4, 4);
    std::memcpy(checksum.data(), content_.data() + start + 8, kChecksum_bytes);
    const char* payload = content_.data() + start + kChunkHead_bytes;
    if (content_.size() - start - kChunkHead_bytes < head.bytes) {
      fail_at(chunk, start, "the file ends inside the chunk");
    }
    if (checksum_of(head, payload) != checksum) {
      fail_at(chunk, start, "the checksum does not match");
    }
    offset_ = start + kChunkHead_bytes + head.bytes;
    if (head.records == 0) {
      take_end(recording, head, payload, chunk, start);
      return false;
    }
    if (head.records > largest_chunk_) {
      fail_at(chunk, start, "it contains more records than a chunk can contain");
    }
    unpack(recording, head, payload, chunk, start);
    return true;
  }

 private:
  std::string take_line() {
    const std::size_t end = content_.find('\n', offset_);
    if (end == std::string::npos) {
      fail("is not a recording: it ends within its header; name a recording");
    }
    std::string line = content_.substr(offset_, end - offset_);
    offset_ = end + 1;
    return line;
  }

  void take_end(const Recording& recording, const ChunkHead& head, const char* payload,
                std::size_t chunk, std::size_t start) const {
    std::uint64_t total = 0;
    if (head.bytes == sizeof total) std::memcpy(&total, payload, sizeof total);
    if (head.bytes != sizeof total || total != recording.time_ns.size()) {
      fail_at(chunk, start, "the number of records differs from the one stated at the end");
    }
    if (offset_ != content_.size()) {
      fail_at(chunk + 1, offset_, "there are data after the end of the recording");
    }
  }

  void unpack(Recording& recording, const ChunkHead& head, const char* payload, std::size_t chunk,
              std::size_t start) const {
    std::vector<char> plain(head.records * record_bytes(recording.columns.size()));
    const std::size_t size = ZSTD_decompress(plain.data(), plain.size(), payload, head.bytes);
    // The payload is the one that was written: its checksum has been compared.
    if (ZSTD_getErrorCode(size) == ZSTD_error_memory_allocation) throw std::bad_alloc();
    if (ZSTD_isError(size) != 0 || size != plain.size()) {
      fail_at(chunk, start, "its decompressed size does not match its number of records");
    }
    const char* next = plain.data();
    const auto take_column = [&next, &head](auto& column) {
      const std::size_t before = column.size();
      column.resize(before + head.records);
      std::memcpy(column.data() + before, next, head.records * sizeof column[0]);
      next += head.records * sizeof column[0];
    };
    take_column(recording.time_ns);
    for (auto& column : recording.columns) take_column(column);
  }

  std::filesystem::path path_;
  std::string content_;
  std::size_t offset_ = 0;
  std::size_t chunk_ = 0;
  std::size_t largest_chunk_ = 0;
};

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  try {
    Reader reader(path);
    Recording recording;
    recording.header = reader.header();
    recording.columns.resize(recording.header.columns.size());
    while (reader.take_chunk(recording)) {
    }
    return recording;
  } catch (const std::bad_alloc&) {
    fail_on_file(path, "read", ENOMEM);
  }
}

std::int64_t records_stated_in(const std::filesystem::path& path) {
  std::int64_t records = 0;
  std::ifstream file(path, std::ios::binary);
  file.seekg(-static_cast<std::streamoff>(sizeof records), std::ios::end);
  if (!file.read(reinterpret_cast<char*>(&records), sizeof records)) {
    fail_on_file(path, "read", EIO);
  }
  return records;
}

}  // namespace asperity
