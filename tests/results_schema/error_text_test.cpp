// Errors of the system and of libraries are shown as what is wrong, where, and what to do.

#include "results_schema/error_text.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <string>
#include <system_error>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string message_of_thrown(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return message_of(error);
  }
  return {};
}

TEST(ErrorText, NamesTheFileThatTheSystemRefusesAndARemedy) {
  const TemporaryFolder folder;
  const std::filesystem::path loop = folder / "loop.png";
  std::filesystem::create_symlink("loop.png", loop);
  const std::string message =
      message_of_thrown([&] { static_cast<void>(std::filesystem::is_regular_file(loop)); });
  EXPECT_EQ(message.find(loop.string() + ": "), 0U) << message;
  EXPECT_THAT(message, AllOf(HasSubstr("replace the link"), Not(HasSubstr("filesystem error"))));
}

TEST(ErrorText, HasNoWordsOfALibrary) {
  EXPECT_EQ(message_of(std::bad_alloc()),
            "too little memory is free; close other programs, then try again");
  EXPECT_THAT(message_of(std::system_error(EAGAIN, std::generic_category())),
              AllOf(HasSubstr("does not start another thread or process"),
                    HasSubstr("close other programs")));
  const std::string message =
      message_of_thrown([] { [[maybe_unused]] const auto read = nlohmann::json::parse("{"); });
  EXPECT_THAT(message, AllOf(HasSubstr("asperity verify"), Not(HasSubstr("json.exception"))));
}

TEST(ErrorText, IsTheMessageOfTheProgramsErrors) {
  EXPECT_EQ(message_of(ResultsError("the study is in use; close it", "study")),
            "the study is in use; close it");
}

TEST(ErrorText, StatesThatMemoryIsMissing) {
  EXPECT_THAT(text_of_error_number(ENOMEM), HasSubstr("too little memory is free"));
  EXPECT_THAT(text_of_error_number(EMFILE), HasSubstr("ulimit -n"));
}

}  // namespace
}  // namespace asperity
