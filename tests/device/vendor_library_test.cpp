// Loading a maker's library: what is found, and the sentence for each way in which it is not.

#include "device/vendor_library.h"

#include <clocale>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <sys/stat.h>

#include <dlfcn.h>
#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <libintl.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string library_refusal(const std::vector<std::filesystem::path>& names) {
  return refusal_of<std::runtime_error>(
      [&] { const VendorLibrary library("Tester's SDK", names); });
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
  EXPECT_THAT(library_refusal({"libnobody-has-this.so", "libnor-this.so.3"}),
              AllOf(HasSubstr("Tester's SDK is not installed"),
                    HasSubstr("libnobody-has-this.so, libnor-this.so.3"), HasSubstr("Install it")));
  EXPECT_THAT(library_refusal({"/no/such/folder/libm.so"}),
              AllOf(HasSubstr("/no/such/folder/libm.so: there is no such file"),
                    Not(HasSubstr("--library"))))
      << "whoever named it knows that";
}

// A catalogue (.mo) with one message of the C library in another language.
void write_catalogue(const std::filesystem::path& file, const std::string& message,
                     const std::string& translation) {
  constexpr std::uint32_t kHead = 28;
  const std::uint32_t texts = kHead + 16;
  const auto length = static_cast<std::uint32_t>(message.size());
  const auto translated = static_cast<std::uint32_t>(translation.size());
  const std::uint32_t words[] = {0x950412de, 0,      1,     kHead,      kHead + 8,         0,
                                 0,          length, texts, translated, texts + length + 1};
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(words), sizeof(words));
  stream << message << '\0' << translation << '\0';
}

// As in a German window: the loader's words are translated, and the second name is tried all the same.
TEST(VendorLibrary, TriesTheNextNameInAnyLanguage) {
  const TemporaryFolder folder;
  const std::string message = "cannot open shared object file";
  write_catalogue(folder / "de" / "LC_MESSAGES" / "libc.mo", message,
                  "Gemeinsame Objektdatei nicht da");
  const std::string language_before = setlocale(LC_MESSAGES, nullptr);
  const std::string folder_before = bindtextdomain("libc", nullptr);
  setenv("LOCPATH", ASPERITY_LOCALE_FOLDER, 1);
  ASSERT_NE(setlocale(LC_MESSAGES, "de_DE.UTF-8"), nullptr);
  bindtextdomain("libc", folder.path().c_str());
  ASSERT_EQ(dlopen("libnobody-has-this.so", RTLD_NOW), nullptr);
  const std::string words = dlerror();
  std::string file;
  const std::string refusal = refusal_of<std::runtime_error>([&] {
    file = VendorLibrary("Tester's SDK", {"libnobody-has-this.so", "libm.so.6"}).file();
  });
  bindtextdomain("libc", folder_before.c_str());
  setlocale(LC_MESSAGES, language_before.c_str());
  unsetenv("LOCPATH");
  EXPECT_THAT(words, HasSubstr("Gemeinsame Objektdatei"));  // or this test tests nothing
  EXPECT_EQ(refusal, "");
  EXPECT_THAT(file, HasSubstr("libm.so.6"));
}

// A maker's thread may still run in it. This one is small, of the C library, and used by nobody here: the stand-ins are
// C++, which the loader keeps anyway.
TEST(VendorLibrary, StaysLoaded) {
  constexpr const char* kFile = "libutil.so.1";
  ASSERT_EQ(dlopen(kFile, RTLD_NOW | RTLD_NOLOAD), nullptr);
  { const VendorLibrary library("Tester's SDK", {kFile}); }
  void* again = dlopen(kFile, RTLD_NOW | RTLD_NOLOAD);
  ASSERT_NE(again, nullptr);
  dlclose(again);
  dlclose(again);
  EXPECT_NE(dlopen(kFile, RTLD_NOW | RTLD_NOLOAD), nullptr);  // whoever closes it
}

TEST(VendorLibrary, NamesTheFunctionThatAnotherVersionLacks) {
  const VendorLibrary library("Tester's SDK", {"libm.so.6"});
  void (*missing)() = nullptr;
  EXPECT_THAT(refusal_of<std::runtime_error>([&] { library.find("hdInitDevice", missing); }),
              AllOf(HasSubstr("Tester's SDK"), HasSubstr("libm.so.6"),
                    HasSubstr("no function hdInitDevice"), HasSubstr("not the version")));
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
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "libforeign.so";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(&header), sizeof(header));
  EXPECT_THAT(library_refusal({file}),
              AllOf(HasSubstr(file.string()), HasSubstr("another architecture"),
                    HasSubstr("machine 22, 64 bits")));
}

TEST(VendorLibrary, SaysThatAFileIsNoLibrary) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "libtext.so";
  std::ofstream(file) << "INPUT(libc.so.6)";
  EXPECT_THAT(library_refusal({file}),
              AllOf(HasSubstr(file.string()), HasSubstr("not a shared library")));
}

// The loader would wait for a writer without end.
TEST(VendorLibrary, RefusesAPipeAtOnce) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.so").c_str(), 0600), 0);
  EXPECT_THAT(library_refusal({folder / "pipe.so"}),
              AllOf(HasSubstr((folder / "pipe.so").string()), HasSubstr("not a shared library")));
}

}  // namespace
}  // namespace asperity
