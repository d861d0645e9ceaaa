// A recording gives back every bit, and says where it does not hold.

#include "results_schema/recording.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "tests/results_schema/sync_watch.h"
#include "tests/results_schema/zstd_without_memory.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

const RecordingHeader kHeader{
    .rate_Hz = 100.0,
    .columns = {{.name = "x_m", .unit = "m", .meaning = "position of the probe, ü"},
                {.name = "force_N", .unit = "N", .meaning = "force on the hand"}},
    .context_json = R"({"participant":"P01","models":{"b":1,"a":"2"}})"};

std::vector<float> values_at(int record) {
  return {0.001F * static_cast<float>(record), 1.0F / static_cast<float>(record + 1)};
}

RecordingRow write(const std::filesystem::path& study, int records,
                   const std::string& path = "recordings/a.asprec") {
  RecordingWriter writer(study, path, kHeader);
  for (int i = 0; i < records; ++i) {
    writer.append(std::int64_t{10'000'000} * i - 5, values_at(i).data());
  }
  return writer.finish();
}

// The first recording of a participant makes two folders.
TEST(Recording, SyncsEveryNameOnTheWayToItsFile) {
  const TemporaryFolder study;
  const SyncWatch watch;
  write(study.path(), 1, "recordings/P01/session-01/a.asprec");
  EXPECT_THAT(watch.synced(),
              testing::IsSupersetOf({study.path(), study / "recordings", study / "recordings/P01",
                                     study / "recordings/P01/session-01"}));
}

std::string refusal_to_read(const std::filesystem::path& path) {
  return refusal_of<ResultsError>([&] { read_recording(path); });
}

void put(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

TEST(Recording, GivesBackEveryRecord) {
  for (const int records : {0, 1, 99, 100, 101, 250}) {
    const TemporaryFolder study;
    const RecordingRow row = write(study.path(), records);
    EXPECT_EQ(row.records, records);
    EXPECT_EQ(row.format, "asperity.recording/1");
    const Recording recording = read_recording(study / row.path);
    EXPECT_EQ(recording.header.rate_Hz, 100.0);
    ASSERT_EQ(recording.header.columns.size(), 2U);
    EXPECT_EQ(recording.header.columns[0].name, "x_m");
    EXPECT_EQ(recording.header.columns[0].unit, "m");
    EXPECT_EQ(recording.header.columns[0].meaning, "position of the probe, ü");
    EXPECT_EQ(recording.header.context_json, kHeader.context_json);
    ASSERT_EQ(recording.time_ns.size(), static_cast<std::size_t>(records));
    for (int i = 0; i < records; ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_EQ(recording.time_ns[at], std::int64_t{10'000'000} * i - 5);
      EXPECT_EQ(recording.columns[0][at], values_at(i)[0]);
      EXPECT_EQ(recording.columns[1][at], values_at(i)[1]);
    }
  }
}

// A study must not be restored from a copy because a computer was busy.
TEST(Recording, IsNotDamagedWhereMemoryIsMissing) {
  const TemporaryFolder study;
  const std::filesystem::path path = study / write(study.path(), 250).path;
  {
    const ZstdWithoutMemory none;
    const std::string refusal = refusal_to_read(path);
    EXPECT_THAT(refusal, HasSubstr(path.string()));
    EXPECT_THAT(refusal, HasSubstr("too little memory is free; close other programs"));
    EXPECT_THAT(refusal, testing::Not(HasSubstr("damaged")));
  }
  EXPECT_EQ(read_recording(path).time_ns.size(), 250U);
}

TEST(Recording, KeepsWhatIsNotANumberBitForBit) {
  const TemporaryFolder study;
  std::uint32_t payload_bits = 0x7fc12345;
  float odd_nan = 0.0F;
  std::memcpy(&odd_nan, &payload_bits, sizeof odd_nan);
  RecordingWriter writer(study.path(), "r", kHeader);
  const float values[] = {odd_nan, -std::numeric_limits<float>::infinity()};
  writer.append(std::numeric_limits<std::int64_t>::min(), values);
  const Recording recording = read_recording(study / writer.finish().path);
  EXPECT_EQ(std::memcmp(&recording.columns[0][0], &odd_nan, sizeof odd_nan), 0);
  EXPECT_EQ(recording.columns[1][0], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(recording.time_ns[0], std::numeric_limits<std::int64_t>::min());
}

TEST(Recording, VouchesForItsFile) {
  const TemporaryFolder study;
  const RecordingRow row = write(study.path(), 250);
  EXPECT_EQ(row.path, "recordings/a.asprec");
  EXPECT_EQ(row.sha256, sha256_of_file(study / row.path));
  EXPECT_EQ(static_cast<std::uintmax_t>(row.bytes), std::filesystem::file_size(study / row.path));
}

TEST(Recording, OfTheSameRecordsIsTheSameFile) {
  const TemporaryFolder one;
  const TemporaryFolder other;
  EXPECT_EQ(write(one.path(), 250).sha256, write(other.path(), 250).sha256);
}

TEST(Recording, IsAPartUntilItIsFinished) {
  const TemporaryFolder study;
  {
    RecordingWriter writer(study.path(), "recordings/a.asprec", kHeader);
    for (int i = 0; i < 150; ++i) writer.append(i, values_at(i).data());
    EXPECT_TRUE(std::filesystem::exists(study / "recordings/a.asprec.part"));
  }
  EXPECT_FALSE(std::filesystem::exists(study / "recordings/a.asprec"));
  // All that was appended is there: only the end is missing, after two chunks.
  EXPECT_THAT(refusal_to_read(study / "recordings/a.asprec.part"), HasSubstr("chunk 3"));
}

TEST(Recording, TakesTheNextNameWhereACrashLeftOne) {
  const TemporaryFolder study;
  { const RecordingWriter left_behind(study.path(), "recordings/a.asprec", kHeader); }
  const RecordingRow second = write(study.path(), 3);
  EXPECT_EQ(second.path, "recordings/a-2.asprec");
  EXPECT_EQ(write(study.path(), 4).path, "recordings/a-3.asprec");
  EXPECT_EQ(second.sha256, sha256_of_file(study / second.path));
  EXPECT_TRUE(std::filesystem::exists(study / "recordings/a.asprec.part"));
}

TEST(Recording, StaysInsideItsStudy) {
  const TemporaryFolder study;
  for (const char* const path : {"", "../a", "recordings/../../a", "/tmp/a", "recordings/"}) {
    EXPECT_THROW(RecordingWriter(study.path(), path, kHeader), ResultsError) << path;
  }
}

TEST(Recording, RefusesAHeaderThatIsWrong) {
  const TemporaryFolder study;
  const auto refused = [&study](RecordingHeader header) {
    EXPECT_THROW(RecordingWriter(study.path(), "r", header), std::invalid_argument);
  };
  RecordingHeader header = kHeader;
  header.rate_Hz = 0.0;
  refused(header);
  header.rate_Hz = std::nan("");
  refused(header);
  header = kHeader;
  header.context_json = "{";
  refused(header);
  header = kHeader;
  header.columns[1].name = "time_ns";
  refused(header);
  EXPECT_TRUE(std::filesystem::is_empty(study.path()));
}

// 250 records in chunks of 100: three chunks and the end.
TEST(Recording, NoticesEveryTruncation) {
  const TemporaryFolder study;
  const std::string whole = read_file(study / write(study.path(), 250).path);
  put(study / "cut", whole);
  for (std::size_t length = whole.size(); length-- > 0;) {
    std::filesystem::resize_file(study / "cut", length);
    ASSERT_NE(refusal_to_read(study / "cut"), "") << length;
  }
  put(study / "cut", whole.substr(0, whole.size() - 1));
  EXPECT_THAT(refusal_to_read(study / "cut"),
              HasSubstr("chunk 4, at byte " + std::to_string(whole.size() - 24) +
                        ": the file ends inside the chunk"));
  put(study / "cut", whole + "x");
  EXPECT_THAT(refusal_to_read(study / "cut"), HasSubstr("there are data after the end"));
}

TEST(Recording, NoticesEveryFlippedByte) {
  const TemporaryFolder study;
  const std::string whole = read_file(study / write(study.path(), 250).path);
  put(study / "flipped", whole);
  std::fstream file(study / "flipped", std::ios::binary | std::ios::in | std::ios::out);
  const auto set_byte = [&file](std::size_t at, int byte) {
    file.seekp(static_cast<std::streamoff>(at)).put(static_cast<char>(byte)).flush();
  };
  for (std::size_t at = 0; at < whole.size(); ++at) {
    set_byte(at, whole[at] ^ 0x10);
    ASSERT_NE(refusal_to_read(study / "flipped"), "") << at;
    set_byte(at, whole[at]);
  }
  EXPECT_EQ(refusal_to_read(study / "flipped"), "");
}

TEST(Recording, SaysInWhichChunkItIsDamaged) {
  const TemporaryFolder study;
  std::string content = read_file(study / write(study.path(), 250).path);
  const std::size_t text = content.find('\n', content.find('\n') + 1) + 1;
  std::uint32_t first_bytes = 0;
  std::memcpy(&first_bytes, content.data() + text + 4, sizeof first_bytes);
  const std::size_t second = text + 16 + first_bytes;
  content[second + 20] = static_cast<char>(content[second + 20] ^ 1);
  put(study / "damaged", content);
  EXPECT_THAT(refusal_to_read(study / "damaged"),
              HasSubstr("damaged in chunk 2, at byte " + std::to_string(second) +
                        ": the checksum does not match"));
}

TEST(Recording, IsRefusedInAnotherFormat) {
  const TemporaryFolder study;
  put(study / "a", "{\"format\":\"asperity.recording/2\"}\n\n");
  EXPECT_THAT(refusal_to_read(study / "a"), HasSubstr("asperity.recording/2"));
  put(study / "b", "PNG\n\n");
  EXPECT_THAT(refusal_to_read(study / "b"), HasSubstr("is not a recording"));
  EXPECT_THAT(refusal_to_read(study / "absent"), HasSubstr("No such file"));
}

// With the right digest, since anybody can write one.
TEST(Recording, IsRefusedWithoutARate) {
  const TemporaryFolder study;
  write(study.path(), 3, "a");
  const std::string good = read_file(study / "a");
  std::string header = good.substr(0, good.find('\n'));
  const std::string rate = "\"rate_Hz\":100.0";
  header.replace(header.find(rate), rate.size(), "\"rate_Hz\":0");
  put(study / "b", header + '\n' + sha256_of(header) + good.substr(good.find('\n') + 65));
  EXPECT_THAT(refusal_to_read(study / "b"),
              testing::AllOf(HasSubstr((study / "b").string()), HasSubstr("states rate_Hz 0"),
                             HasSubstr("Restore the file from a copy")));
}

TEST(Recording, DoesNotFinishAfterTheDiskWasFull) {
  const TemporaryFolder study;
  RecordingWriter writer(study.path(), "r", kHeader);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;  // the header fits, the first chunk does not
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal_of<ResultsError>([&] {
    for (int i = 0; i < 100; ++i) writer.append(i * 7919, values_at(i).data());
  });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, HasSubstr("disk is full"));
  EXPECT_THROW(writer.finish(), ResultsError);
  EXPECT_FALSE(std::filesystem::exists(study / "r"));
  EXPECT_TRUE(std::filesystem::exists(study / "r.part"));
}

}  // namespace
}  // namespace asperity
