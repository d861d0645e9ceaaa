// Loading a maker's library: what is found, and the sentence for each way in which it is not.

#include "device/vendor_library.h"

#include <fstream>
#include <stdexcept>

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal_of(const std::vector<std::filesystem::path>& names) {
  try {
    const VendorLibrary library("Tester's SDK", names);
  } catch (const std::runtime_error& refusal) {
    return refusal.what();
  }
  return "none";
}

std::filesystem::path file_in_temporary_folder(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

TEST(VendorLibrary, LoadsTheFirstThatIsThere) {
  const VendorLibrary library("Tester's SDK", {"libnobody-has-this.so", "libm.so.6"});
  EXPECT_THAT(library.file().string(), HasSubstr("libm.so.6"));
  EXPECT_TRUE(library.file().is_absolute());
  double (*cosine)(double) = nullptr;
  library.find("cos", cosine);
  EXPECT_EQ(cosine(0.0), 1.0);
}

TEST(VendorLibrary, NamesWhatItLookedForWhenThereIsNothing) {
  EXPECT_THAT(refusal_of({"libnobody-has-this.so", "libnor-this.so.3"}),
              AllOf(HasSubstr("Tester's SDK is not installed"),
                    HasSubstr("libnobody-has-this.so, libnor-this.so.3"), HasSubstr("Install it")));
  EXPECT_THAT(refusal_of({"/no/such/folder/libm.so"}), HasSubstr("/no/such/folder/libm.so"));
}

TEST(VendorLibrary, NamesTheFunctionThatAnotherVersionLacks) {
  const VendorLibrary library("Tester's SDK", {"libm.so.6"});
  void (*missing)() = nullptr;
  try {
    library.find("hdInitDevice", missing);
    FAIL() << "found it";
  } catch (const std::runtime_error& refusal) {
    EXPECT_THAT(refusal.what(),
                AllOf(HasSubstr("Tester's SDK"), HasSubstr("libm.so.6"),
                      HasSubstr("no function hdInitDevice"), HasSubstr("another version")));
  }
  library.find_if_there("hdInitDevice", missing);
  EXPECT_EQ(missing, nullptr);
}

TEST(VendorLibrary, NamesTheArchitectureOfAFileForAnotherOne) {
  Elf64_Ehdr header{};
  for (int i = 0; i < SELFMAG; ++i) header.e_ident[i] = static_cast<unsigned char>(ELFMAG[i]);
  header.e_ident[EI_CLASS] = ELFCLASS64;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_ident[EI_VERSION] = EV_CURRENT;
  header.e_type = ET_DYN;
  header.e_machine = EM_S390;
  header.e_version = EV_CURRENT;
  header.e_ehsize = sizeof(header);
  const std::filesystem::path file = file_in_temporary_folder("libforeign.so");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(&header), sizeof(header));
  EXPECT_THAT(refusal_of({file}), AllOf(HasSubstr(file.string()), HasSubstr("another architecture"),
                                        HasSubstr("machine 22, 64 bits")));
}

TEST(VendorLibrary, SaysThatAFileIsNoLibrary) {
  const std::filesystem::path file = file_in_temporary_folder("libtext.so");
  std::ofstream(file) << "INPUT(libc.so.6)";
  EXPECT_THAT(refusal_of({file}), AllOf(HasSubstr(file.string()), HasSubstr("no shared library")));
}

}  // namespace
}  // namespace asperity
