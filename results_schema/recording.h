// The tick records of one attempt, in one hashed file.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

/// One column of a recording: its name (unit included) and what it means. Column 0 is always
/// `time_ns` (int64); the others are float32.
struct RecordingColumn {
  std::string name{};
  std::string unit{};
  std::string meaning{};
};

struct RecordingHeader {
  double rate_Hz = 0.0;
  std::vector<RecordingColumn> columns{};  ///< without time_ns
  std::string context_json = "{}";  ///< models with versions, participant, session, trial, attempt
};

/// Writes a recording: `.part` while it grows, one zstd chunk per second of records, a checksum per
/// chunk; `finish` syncs, renames and syncs the folder.
///
/// Format: docs/formats/recording.md. Deterministic: the same records give the same bytes.
///
/// Nothing that a hand did is thrown away by us: the destructor of an unfinished writer leaves the
/// `.part` file with all that was appended, which `verify` lists, and where a file of this name is
/// already there (a program died between the recording and its row) the next free name is taken,
/// "…-2" and so on; the row has it.
///
/// Errors: std::invalid_argument for a header that is wrong; ResultsError (no space, no
/// permission). After one, `finish` refuses.
class RecordingWriter final {
 public:
  /// `path` inside `study`, without ".part".
  RecordingWriter(const std::filesystem::path& study, const std::string& path,
                  const RecordingHeader& header);
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// `values` has one float per column of the header.
  void append(std::int64_t time_ns, const float* values);
  RecordingRow finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

struct Recording {
  RecordingHeader header{};
  std::vector<std::int64_t> time_ns{};
  std::vector<std::vector<float>> columns{};  ///< column by column
};

/// Errors: ResultsError naming the file and the first thing that does not hold (format, a checksum,
/// a file that ends too early), with the number of the chunk from 1 and its offset in bytes; with the code ENOMEM where
/// too little memory is free, which is no damage.
Recording read_recording(const std::filesystem::path& path);

/// The number of records that a whole recording states at its end; nothing else of it is read.
/// Errors: ResultsError for a file that cannot be read.
std::int64_t records_stated_in(const std::filesystem::path& path);

}  // namespace asperity
