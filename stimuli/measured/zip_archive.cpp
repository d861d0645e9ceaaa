// Implements the reading of a zip archive with libzip.

#include "stimuli/measured/zip_archive.h"

#include <new>
#include <set>

#include <zip.h>

#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"

namespace asperity {

namespace {

/// What failed for want of memory is no fault of the archive.
void refuse_memory(zip_error_t* error) {
  if (zip_error_code_zip(error) == ZIP_ER_MEMORY) throw std::bad_alloc();
}

}  // namespace

void ZipArchive::Close::operator()(zip* archive) const noexcept { zip_discard(archive); }

void ZipArchive::refuse(const Phrase& sentence) const {
  throw PhrasedRefusal(Phrase("%1: %2").with(name_, sentence));
}

ZipArchive::ZipArchive(std::span<const std::byte> bytes, const std::string& name)
    : bytes_(bytes), name_(name) {
  zip_error_t error{};
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source != nullptr) archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  const bool has_no_memory = zip_error_code_zip(&error) == ZIP_ER_MEMORY;
  if (source != nullptr && archive_ == nullptr) zip_source_free(source);
  zip_error_fini(&error);
  if (has_no_memory) throw std::bad_alloc();
  if (archive_ == nullptr) {
    refuse(phrase(
        "Stimuli",
        "the directory of the zip archive cannot be read: the file is incomplete or damaged; "
        "copy or export it again"));
  }
  std::set<std::string> known{};
  for (std::string& path : paths()) {
    const auto [at, is_new] = known.insert(std::move(path));
    if (!is_new) {
      refuse(phrase("Stimuli",
                    "the archive has the entry %1 twice, and which one is meant is unknown; export "
                    "the file again")
                 .with(*at));
    }
  }
}

std::vector<std::string> ZipArchive::paths() const {
  std::vector<std::string> paths{};
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const path =
        zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
    if (path != nullptr) paths.emplace_back(path);
  }
  return paths;
}

std::optional<std::size_t> ZipArchive::bytes_of(const std::string& path) const {
  zip_stat_t stat{};
  if (zip_stat(archive_.get(), path.c_str(), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
    return std::nullopt;
  }
  return stat.size;
}

std::vector<std::byte> ZipArchive::content(const std::string& path, std::size_t most) const {
  zip_stat_t stat{};
  constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_COMP_METHOD;
  if (zip_stat(archive_.get(), path.c_str(), 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded) {
    refuse(
        phrase("Stimuli", "the archive has no entry %1; copy or export the file again").with(path));
  }
  if (stat.size > most) {
    refuse(phrase("Stimuli",
                  "the entry %1 has %2 bytes; at most %3 are possible; export the file again")
               .with(path, std::to_string(stat.size), std::to_string(most)));
  }
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) {
    refuse(phrase("Stimuli",
                  "the entry %1 is compressed by another method than deflate, the only one of X3P; "
                  "export the file again")
               .with(path));
  }
  if (!can_expand_to(bytes_.size(), stat.size)) {
    refuse(phrase("Stimuli",
                  "the entry %1 states more bytes than the archive can contain; copy or export the "
                  "file again")
               .with(path));
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen(archive_.get(), path.c_str(), 0), &zip_fclose);
  if (file == nullptr) {
    refuse_memory(zip_get_error(archive_.get()));
    refuse(phrase("Stimuli",
                  "the entry %1 cannot be opened: the archive is damaged or encrypted; copy or "
                  "export the file again")
               .with(path));
  }
  std::vector<std::byte> content(stat.size);
  std::size_t done = 0;
  zip_int64_t read = 1;
  while (done < content.size() && read > 0) {
    read = zip_fread(file.get(), content.data() + done, content.size() - done);
    if (read > 0) done += static_cast<std::size_t>(read);
  }
  // libzip compares the checksum when it reaches the end.
  std::byte beyond{};
  if (read >= 0) read = zip_fread(file.get(), &beyond, 1);
  if (done != content.size() || read != 0) {
    refuse_memory(zip_file_get_error(file.get()));
    refuse(phrase("Stimuli", "the entry %1 is damaged; copy or export the file again").with(path));
  }
  return content;
}

}  // namespace asperity
