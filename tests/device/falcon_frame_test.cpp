// A Falcon's frames, byte for byte.

#include "device/falcon/falcon_frame.h"

#include <string>

#include <gtest/gtest.h>

namespace asperity::falcon {
namespace {

std::string text_of(const Frame& frame) { return {frame.begin(), frame.end()}; }

Frame frame_from(const std::string& text) {
  Frame frame{};
  std::copy_n(text.begin(), kFrame_bytes, frame.begin());
  return frame;
}

TEST(FalconFrame, WritesWordsAsNibblesTheLeastFirst) {
  EXPECT_EQ(text_of(frame_of({})), "<AAAAAAAAAAAAAA>");
  // 0x1234 is 4, 3, 2, 1; -1 is four times 15; -4096 is 0xf000.
  EXPECT_EQ(text_of(frame_of({.motor_words = {0x1234, -1, -4096}})), "<EDCBPPPPAAAPAA>");
  EXPECT_EQ(text_of(frame_of({.motor_words = {4096, 32767, -32768}})), "<AAABPPPHAAAIAA>");
}

TEST(FalconFrame, WritesLampsAndHomingIntoOneByte) {
  EXPECT_EQ(text_of(frame_of({.lamp = Lamp::green})), "<AAAAAAAAAAAACA>");
  EXPECT_EQ(text_of(frame_of({.lamp = Lamp::blue})), "<AAAAAAAAAAAAEA>");
  EXPECT_EQ(text_of(frame_of({.lamp = Lamp::red, .is_homing = true})), "<AAAAAAAAAAAAJA>");
}

TEST(FalconFrame, ReadsCountsButtonsAndHoming) {
  const auto answer =
      answer_in(frame_from("<EDCBPPPPAAAI\xb6"
                           "A>"));  // 0xb6 - 'A' = 0x75
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->counts, (std::array<std::int16_t, 3>{0x1234, -1, -32768}));
  EXPECT_EQ(answer->buttons, 0x5);
  EXPECT_TRUE(answer->is_homed());
  EXPECT_FALSE(answer_in(frame_from("<AAAAAAAAAAAA\x71"
                                    "A>"))
                   ->is_homed());  // two of three
}

TEST(FalconFrame, ReadsBackEveryWord) {
  for (int word = -32768; word <= 32767; ++word) {
    const auto as_word = static_cast<std::int16_t>(word);
    const auto answer = answer_in(frame_of({.motor_words = {as_word, 0, as_word}}));
    ASSERT_EQ(answer->counts[0], word);
    ASSERT_EQ(answer->counts[2], word);
  }
}

TEST(FalconFrame, RefusesWhatIsNone) {
  for (const char* text : {"(AAAAAAAAAAAAAA>", "<AAAAAAAAAAAAAA)", "<AAAQAAAAAAAAAA>",
                           "<AA@AAAAAAAAAAA>", "<AAAAAAAAAAAA@A>",
                           "<AAAAAAAAAAAA\xc1"
                           "A>"}) {
    EXPECT_FALSE(answer_in(frame_from(text)).has_value()) << text;
  }
}

TEST(FalconFrame, IsFoundInPiecesAndBehindNoise) {
  FrameReader reader;
  int found = 0;
  const std::string noise = std::string("AB>") +
                            "<AAAA<AAAAAAAAAAAA"
                            "BA>" +
                            ">>" + "<AAAAAAAAAAAAAA)" + "<PPPPAAAAAAAAAA>";
  std::int16_t last = 0;
  for (const char byte : noise) {
    if (const auto answer = reader.take(static_cast<std::uint8_t>(byte))) {
      ++found;
      last = answer->counts[0];
      EXPECT_EQ(answer->buttons, found == 1 ? 1 : 0);
    }
  }
  EXPECT_EQ(found, 2);
  EXPECT_EQ(last, -1);
  EXPECT_EQ(reader.malformed(), 2U);
}

}  // namespace
}  // namespace asperity::falcon
