// Implements the file format: a line of JSON, a digest, and five compressed arrays.

#include "stimuli/meshes/textured_mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <openssl/evp.h>
#include <zstd.h>
#include <zstd_errors.h>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little,
              "the arrays are written as they lie in memory, and the format is little-endian");

constexpr const char* kMeshFormat = "asperity.textured_mesh/1";
constexpr std::size_t kDigest_bytes = 64;
constexpr std::size_t kLongestHeader_bytes = 1 << 20;
constexpr std::size_t kMostItems = std::size_t{1} << 28;
constexpr int kCompressionLevel = 3;
// Four bytes of a zstd block expand to at most 128 KiB.
constexpr std::size_t kMostUnpacked = std::size_t{1} << 15;
// A felt body measures up to 10 m (mesh_repair.h) and lies near its frame's origin. The tick computes in single
// precision, and cubes of lengths must stay within its range.
constexpr double kFurthest_m = 20.0;
constexpr double kLargestTexel = 32767.0;

std::string sha256_of(std::initializer_list<std::string_view> parts) {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  std::array<unsigned char, 32> digest{};
  bool good = context != nullptr && EVP_DigestInit_ex(context, EVP_sha256(), nullptr) == 1;
  for (const std::string_view part : parts) {
    good = good && EVP_DigestUpdate(context, part.data(), part.size()) == 1;
  }
  good = good && EVP_DigestFinal_ex(context, digest.data(), nullptr) == 1;
  EVP_MD_CTX_free(context);
  if (!good) throw std::runtime_error("libcrypto offers no SHA-256; check its installation");
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) text += {kDigits[byte >> 4], kDigits[byte & 15]};
  return text;
}

/// The name, type and numbers per item of one of the arrays.
struct ArrayKind {
  const char* name;
  const char* type;
  std::size_t components;
};
constexpr std::array<ArrayKind, 5> kArrays{{{"vertices_m", "float64", 3},
                                            {"normals", "float64", 3},
                                            {"triangles", "uint32", 3},
                                            {"places", "float64", 6},
                                            {"atlas", "int16", 1}}};

template <class Item>
std::string packed(const std::vector<Item>& items) {
  const std::size_t size = items.size() * sizeof(Item);
  std::string bytes(ZSTD_compressBound(size), '\0');
  const std::size_t written =
      ZSTD_compress(bytes.data(), bytes.size(), items.data(), size, kCompressionLevel);
  // Of a buffer of the largest size that it may need, only its own memory can be missing.
  if (ZSTD_isError(written) != 0) throw std::bad_alloc();
  bytes.resize(written);
  return bytes;
}

Json error_json(const GeometricError& error) {
  return {{"rms_m", error.rms_m}, {"max_m", error.max_m}};
}

class Reader final {
 public:
  Reader(std::string_view bytes, std::string name) : name_(std::move(name)) {
    const std::size_t end = bytes.substr(0, kLongestHeader_bytes).find('\n');
    const std::string_view header = bytes.substr(0, std::min(end, bytes.size()));
    if (end != std::string_view::npos) json_ = Json::parse(header, nullptr, false);
    const auto format = json_.is_object() ? json_.find("format") : json_.end();
    if (!json_.is_object() || format == json_.end() || !format->is_string() ||
        !format->get_ref<const std::string&>().starts_with("asperity.textured_mesh/")) {
      refuse_file(phrase("Stimuli", "%1 is not a textured mesh of Asperity."));
    }
    if (*format != kMeshFormat) {
      refuse_file(phrase("Stimuli", "%1 is in the format %2; this program reads %3."),
                  format->get<std::string>(), kMeshFormat);
    }
    const std::string_view rest = bytes.substr(end + 1);
    if (rest.size() < kDigest_bytes + 1 || rest[kDigest_bytes] != '\n')
      refuse_file(phrase("Stimuli", "%1 is truncated."));
    payload_ = rest.substr(kDigest_bytes + 1);
    check_length();
    if (sha256_of({header, payload_}) != rest.substr(0, kDigest_bytes)) {
      refuse_file(
          phrase("Stimuli", "%1 is damaged: its SHA-256 differs from the one stored in it."));
    }
  }

  StoredTexturedMesh read() {
    StoredTexturedMesh stored{};
    TexturedMesh& mesh = stored.mesh;
    mesh.vertices_m = next<glm::dvec3>();
    mesh.normals = next<glm::dvec3>();
    mesh.triangles = next<std::array<std::uint32_t, 3>>();
    mesh.places = next<std::array<glm::dvec2, 3>>();
    mesh.atlas.values = next<std::int16_t>();
    const Json& atlas = object(json_, "atlas");
    mesh.atlas.rows = whole(atlas, "rows");
    mesh.atlas.columns = whole(atlas, "columns");
    mesh.atlas.step_m = number(atlas, "step_m");
    check(mesh);
    stored.plain = error("error");
    stored.textured = error("textured_error");
    const Json& provenance = object(json_, "provenance");
    stored.provenance.source_name = text(provenance, "source_name");
    stored.provenance.source_sha256 = text(provenance, "source_sha256");
    stored.provenance.source_unit_m = number(provenance, "source_unit_m");
    stored.provenance.source_triangles = whole(provenance, "source_triangles");
    stored.provenance.program_version = text(provenance, "program_version");
    const auto findings = provenance.find("findings");
    if (findings == provenance.end() || !findings->is_array())
      refuse("needs a list provenance/findings in its first line.");
    for (const Json& finding : *findings) {
      if (!finding.is_string()) refuse("has an entry of provenance/findings that is not a string.");
      stored.provenance.findings.push_back(finding.get<std::string>());
    }
    return stored;
  }

 private:
  /// %1 of the sentence is the name of the file.
  template <class... Values>
  [[noreturn]] void refuse_file(const Phrase& sentence, const Values&... values) const {
    throw PhrasedRefusal(
        Phrase("%1 %2").with(sentence.with(name_, values...),
                             phrase("Stimuli", "Make the mesh again with asperity bake.")));
  }
  /// Of a content that no version of the program writes: English in every language.
  [[noreturn]] void refuse(const std::string& sentence) const {
    refuse_file(Phrase("%1 %2"), sentence);
  }

  const Json& array(std::size_t which) const {
    const auto arrays = json_.find("arrays");
    if (arrays == json_.end() || !arrays->is_array() || arrays->size() != kArrays.size() ||
        !(*arrays)[which].is_object() || text((*arrays)[which], "name") != kArrays[which].name ||
        text((*arrays)[which], "type") != kArrays[which].type ||
        whole((*arrays)[which], "components") != kArrays[which].components) {
      refuse("does not list the five arrays of a textured mesh.");
    }
    return (*arrays)[which];
  }

  void check_length() const {
    std::size_t bytes = 0;
    for (std::size_t which = 0; which < kArrays.size(); ++which) {
      bytes += whole(array(which), "bytes");
    }
    if (bytes != payload_.size()) {
      refuse((bytes > payload_.size() ? "is truncated: its arrays take "
                                      : "has data after its end: its arrays take ") +
             counted(bytes, "byte", "bytes") + ", and it has " + std::to_string(payload_.size()) +
             ".");
    }
  }

  template <class Item>
  std::vector<Item> next() {
    const Json& kind = array(which_++);
    const std::size_t count = whole(kind, "count");
    const std::size_t bytes = whole(kind, "bytes");
    // Checked before memory is allocated.
    const unsigned long long unpacked = ZSTD_getFrameContentSize(payload_.data(), bytes);
    const bool states_size = unpacked != ZSTD_CONTENTSIZE_UNKNOWN;
    if ((states_size && unpacked != count * sizeof(Item)) ||
        count * sizeof(Item) / kMostUnpacked > bytes) {
      refuse("contains an array \"" + text(kind, "name") + "\" that cannot be decompressed: " +
             "the number of items stated, " + std::to_string(count) + ", does not match its " +
             counted(bytes, "byte", "bytes") + ".");
    }
    std::vector<Item> items(count);
    const std::size_t size =
        ZSTD_decompress(items.data(), count * sizeof(Item), payload_.data(), bytes);
    if (ZSTD_getErrorCode(size) == ZSTD_error_memory_allocation) throw std::bad_alloc();
    if (ZSTD_isError(size) != 0 || size != count * sizeof(Item)) {
      refuse("contains an array \"" + text(kind, "name") + "\" that cannot be decompressed.");
    }
    payload_.remove_prefix(bytes);
    return items;
  }

  /// A file with the correct digest may still be invalid, since it may have been written by another program.
  void check(const TexturedMesh& mesh) const {
    const DisplacementAtlas& atlas = mesh.atlas;
    if (mesh.vertices_m.empty() || mesh.triangles.empty()) refuse("has no triangles.");
    if (mesh.normals.size() != mesh.vertices_m.size()) {
      refuse("does not have one normal for each vertex.");
    }
    if (mesh.places.size() != mesh.triangles.size()) {
      refuse("does not have exactly one place in its atlas for each triangle.");
    }
    if (atlas.rows < 2 || atlas.columns < 2 || atlas.rows > kMostItems ||
        atlas.columns > kMostItems || atlas.rows * atlas.columns != atlas.values.size()) {
      refuse("has an atlas whose rows and columns do not match its texels.");
    }
    if (!(atlas.step_m >= 0.0 && atlas.step_m * kLargestTexel <= kFurthest_m)) {
      refuse("has an atlas with step_m " + number_text(atlas.step_m) +
             ", which displaces a surface by up to " + number_text(atlas.step_m * kLargestTexel) +
             " m; at most " + number_text(kFurthest_m) + " m is allowed.");
    }
    constexpr double kUnit = 1e-6;
    for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const double place_m = mesh.vertices_m[i][axis];
        if (std::abs(place_m) <= kFurthest_m) continue;  // false for NaN
        const std::string place =
            std::isnan(place_m) ? "not a number" : number_text(place_m) + " m";
        refuse("has vertex " + std::to_string(i) + " with " + "xyz"[axis] + " = " + place +
               "; each coordinate must lie between -" + number_text(kFurthest_m) + " m and " +
               number_text(kFurthest_m) + " m.");
      }
      if (!(std::abs(glm::length(mesh.normals[i]) - 1.0) < kUnit)) {
        refuse("has a normal at vertex " + std::to_string(i) + " that is not of unit length.");
      }
    }
    // Interpolation on the border of a face may access the next texel.
    const glm::dvec2 furthest{static_cast<double>(atlas.columns) - 2.0,
                              static_cast<double>(atlas.rows) - 2.0};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (mesh.triangles[i][corner] >= mesh.vertices_m.size()) {
          refuse("has a triangle with a vertex that does not exist.");
        }
        const glm::dvec2& place = mesh.places[i][corner];
        if (!(place.x >= 1.0 && place.y >= 1.0 && place.x <= furthest.x && place.y <= furthest.y)) {
          refuse("has a triangle whose texture lies outside the atlas.");
        }
      }
    }
  }

  GeometricError error(const char* key) const {
    const Json& found = object(json_, key);
    return {number(found, "rms_m"), number(found, "max_m")};
  }

  const Json& object(const Json& json, const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_object()) {
      refuse("needs an object " + std::string(key) + " in its first line.");
    }
    return *found;
  }
  std::size_t whole(const Json& json, const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_unsigned() ||
        found->get<std::uint64_t>() > kMostItems * sizeof(glm::dvec3)) {
      refuse("needs a whole number " + std::string(key) + " in its first line.");
    }
    return found->get<std::size_t>();
  }
  double number(const Json& json, const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number() || !std::isfinite(found->get<double>())) {
      refuse("needs a number " + std::string(key) + " in its first line.");
    }
    return found->get<double>();
  }
  std::string text(const Json& json, const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) {
      refuse("needs a string \"" + std::string(key) + "\" in its first line.");
    }
    return found->get<std::string>();
  }

  std::string name_;
  Json json_{};
  std::string_view payload_{};
  std::size_t which_ = 0;
};

}  // namespace

std::vector<std::byte> encode_textured_mesh(const StoredTexturedMesh& stored) {
  const TexturedMesh& mesh = stored.mesh;
  const std::array<std::string, 5> arrays{packed(mesh.vertices_m), packed(mesh.normals),
                                          packed(mesh.triangles), packed(mesh.places),
                                          packed(mesh.atlas.values)};
  const std::array<std::size_t, 5> counts{mesh.vertices_m.size(), mesh.normals.size(),
                                          mesh.triangles.size(), mesh.places.size(),
                                          mesh.atlas.values.size()};
  Json list = Json::array();
  std::string payload;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    list.push_back({{"name", kArrays[i].name},
                    {"type", kArrays[i].type},
                    {"components", kArrays[i].components},
                    {"count", counts[i]},
                    {"bytes", arrays[i].size()}});
    payload += arrays[i];
  }
  const TexturedMeshProvenance& provenance = stored.provenance;
  const Json json{
      {"format", kMeshFormat},
      {"atlas",
       {{"rows", mesh.atlas.rows}, {"columns", mesh.atlas.columns}, {"step_m", mesh.atlas.step_m}}},
      {"error", error_json(stored.plain)},
      {"textured_error", error_json(stored.textured)},
      {"provenance",
       {{"source_name", provenance.source_name},
        {"source_sha256", provenance.source_sha256},
        {"source_unit_m", provenance.source_unit_m},
        {"source_triangles", provenance.source_triangles},
        {"findings", provenance.findings},
        {"program_version", provenance.program_version}}},
      {"arrays", list}};
  // A file name may contain bytes that are not UTF-8; they are replaced, because the header is always UTF-8.
  const std::string header = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string whole = header + '\n' + sha256_of({header, payload}) + '\n' + payload;
  const auto* first = reinterpret_cast<const std::byte*>(whole.data());
  return {first, first + whole.size()};
}

StoredTexturedMesh decode_textured_mesh(std::span<const std::byte> bytes, const std::string& name) {
  return Reader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name).read();
}

}  // namespace asperity
