// SHA-256 against the published examples.

#include "results_schema/hashes/sha256.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

// FIPS 180-2, appendices B.1 and B.2, and the digest of nothing.
TEST(Sha256, AgreesWithThePublishedExamples) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFileIsThatOfItsContent) {
  const TemporaryFolder folder;
  const std::string content(700'001, 'x');  // more than one piece, and not a whole number of them
  std::ofstream(folder / "file", std::ios::binary) << content;
  EXPECT_EQ(sha256_of_file(folder / "file"), sha256_of(content));
}

TEST(Sha256, OfAnAbsentFileIsRefusedByName) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_of<ResultsError>([&] { sha256_of_file(folder / "absent"); }),
              testing::HasSubstr("absent"));
  EXPECT_THROW(sha256_of_file(folder.path()), ResultsError);
}

}  // namespace
}  // namespace asperity
