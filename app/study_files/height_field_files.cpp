// Writes PNG and sidecar together or not at all, and checks a sidecar against its picture.

#include "app/study_files/height_field_files.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/study_files/program.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

std::span<const std::byte> bytes_of(const std::string& content) {
  return std::as_bytes(std::span(content.data(), content.size()));
}

std::string_view text_in(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// By its ending: of the files that `bake` reads.
bool is_mesh(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 4> kEndings{".obj", ".ply", ".stl", ".off"};
  const std::string ending = file.extension().string();
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

struct FilesRead {
  StoredHeightField stored;
  std::string sidecar{};
};

FilesRead read_files(const std::filesystem::path& png) {
  const std::string content = read_file(png, kPictureFile);
  const std::filesystem::path beside = sidecar_of(png);
  if (!std::filesystem::exists(beside)) {
    if (is_mesh(png)) {
      throw ResultsError(png.string() +
                             " is a mesh, not a height field; make a textured mesh with asperity "
                             "bake, and use it as a body",
                         png);
    }
    throw ResultsError(png.string() + " is a picture, not a height field: there is no " +
                           beside.string() +
                           ", which would state its heights; to make a height field from a "
                           "photograph, use asperity texture",
                       png);
  }
  const std::string sidecar = read_file(beside, kSidecarFile);
  StoredHeightField stored = decode_height_field(bytes_of(content), sidecar, png.string());
  if (sha256_of(content) != stored.sha256) {
    throw std::runtime_error(png.string() + " is not the picture that its sidecar " +
                             beside.string() + " describes: the SHA-256 differs; make both again");
  }
  return {std::move(stored), sidecar};
}

}  // namespace

std::filesystem::path sidecar_of(const std::filesystem::path& png) {
  std::filesystem::path sidecar = png;
  sidecar += ".json";
  return sidecar;
}

void refuse_existing(const std::vector<std::filesystem::path>& files, Overwrite overwrite) {
  if (overwrite == Overwrite::allow) return;
  for (const std::filesystem::path& file : files) {
    if (std::filesystem::exists(file)) {
      throw ResultsError(file.string() + " already exists; use --force to replace it", file);
    }
  }
}

void write_files_or_refuse(const std::vector<NewFile>& files, Overwrite overwrite) {
  for (const NewFile& file : files) {
    if (&file == &files.back() || !holds(file)) refuse_existing({file.path}, overwrite);
  }
  write_files_together(files, overwrite);
}

LoadedHeightField load_height_field(const std::filesystem::path& png) {
  FilesRead read = read_files(png);
  return {.field = std::make_shared<const HeightField>(std::move(read.stored.field)),
          .sha256 = sha256_of(read.sidecar)};
}

LoadedHeightField KeptHeightFields::load(const std::filesystem::path& png) {
  const std::array<FileState, 2> files{state_of(png), state_of(sidecar_of(png))};
  const auto found = kept_.find(png);
  if (found != kept_.end() && files[0] && files[1] && found->second.files == files) {
    found->second.is_used = true;
    return found->second.loaded;
  }
  if (found != kept_.end()) kept_.erase(found);
  return kept_.emplace(png, Kept{.files = files, .loaded = load_height_field(png)})
      .first->second.loaded;
}

void KeptHeightFields::forget_unused() {
  for (auto field = kept_.begin(); field != kept_.end();) {
    const bool is_used = std::exchange(field->second.is_used, false);
    field = is_used ? std::next(field) : kept_.erase(field);
  }
}

KeptHeightFields::FileState KeptHeightFields::state_of(const std::filesystem::path& file) {
  std::error_code failed{};
  const auto time = std::filesystem::last_write_time(file, failed);
  if (failed) return {};
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  if (failed) return {};
  return std::pair(time, size);
}

bool has_hash(const std::filesystem::path& png, const std::string& sha256) {
  const std::filesystem::path beside = sidecar_of(png);
  if (!std::filesystem::exists(png) || !std::filesystem::exists(beside)) return false;
  const std::string sidecar = read_file(beside, kSidecarFile);
  return sha256_of(sidecar) == sha256 && nlohmann::json::parse(sidecar).value("sha256", "") ==
                                             sha256_of(read_file(png, kPictureFile));
}

HeightFieldProvenance provenance_of(const std::filesystem::path& png) {
  return read_files(png).stored.provenance;
}

void save_height_field(const std::filesystem::path& png, const HeightField& field,
                       HeightFieldProvenance provenance, Overwrite overwrite,
                       const std::vector<PictureFile>& pictures) {
  provenance.program_version = version_line();
  const std::vector<std::byte> content = encode_height_field_png(field);
  const std::string text =
      encode_height_field_sidecar(field, provenance, sha256_of(text_in(content)));
  std::vector<NewFile> files{{sidecar_of(png), text}};
  for (const PictureFile& one : pictures) {
    files.push_back({one.png, one.content});
  }
  files.push_back({png, std::string(text_in(content))});
  write_files_or_refuse(files, overwrite);
}

PictureFile picture_file(const std::filesystem::path& png, const GreyImage& picture) {
  const std::vector<std::byte> content = encode_png(picture);
  return {png, std::string(text_in(content))};
}

void save_picture(const std::filesystem::path& png, const GreyImage& picture, Overwrite overwrite) {
  write_file(png, encode_png(picture), overwrite);
}

void save_color_picture(const std::filesystem::path& png, const ColorPlanes& picture,
                        Overwrite overwrite) {
  write_file(png, encode_color_png(picture), overwrite);
}

LoadedPhotograph load_photograph(const std::filesystem::path& file) {
  const std::string content = read_file(file, kPictureFile);
  return {decode_photograph(bytes_of(content), file.string()), sha256_of(content)};
}

ColorPlanes load_color_picture(const std::filesystem::path& file) {
  return decode_color_picture(bytes_of(read_file(file, kPictureFile)), file.string());
}

}  // namespace asperity
