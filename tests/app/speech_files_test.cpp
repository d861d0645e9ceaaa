// Recorded speech that a protocol names is part of the study like its pictures.

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "app/session/session_setup.h"
#include "app/tasks/check_protocol.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class SpeechFiles : public testing::Test {
 protected:
  SpeechFiles() { make_small_study(study_); }

  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((study_ / name).parent_path());
    std::ofstream(study_ / name, std::ios::binary) << content;
  }
  static std::string protocol() {
    std::string text = small_protocol();
    return text.insert(text.find("\"textures\""),
                       R"("environment": {"speech": {"question": "speech/which.wav"}},
  )");
  }
  std::vector<Diagnostic> problems() const {
    write("protocols/small.json", protocol());
    return check_protocol(study_ / "protocols" / "small.json", models_, study_, {}).diagnostics;
  }

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_.path() / "study";
  ModelRegistry models_ = built_in_models();
};

TEST_F(SpeechFiles, AreMissedWhereTheProtocolNamesThem) {
  const std::vector<Diagnostic> found = problems();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().pointer, "/environment/speech/question");
  EXPECT_NE(found.front().message.english().find("speech/which.wav is not in the study"),
            std::string::npos);
}

TEST_F(SpeechFiles, HaveToBeWav) {
  for (const char* const content : {"", "RIFF", "RIFF1234AVI fmt "}) {
    write("speech/which.wav", content);
    const std::vector<Diagnostic> found = problems();
    ASSERT_EQ(found.size(), 1U) << content;
    EXPECT_NE(found.front().message.english().find("is not a WAV file"), std::string::npos);
  }
  write("speech/which.wav", "RIFF1234WAVEfmt ");
  EXPECT_TRUE(problems().empty());
}

TEST_F(SpeechFiles, AreHashedWithTheFilesOfASession) {
  write("speech/which.wav", "RIFF1234WAVEfmt ");
  const auto rows = hash_files(read_small_protocol(models_, protocol()), study_);
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(),
                          [](const auto& row) { return row.path == "speech/which.wav"; }));
}

}  // namespace
}  // namespace asperity
