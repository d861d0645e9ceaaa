// Measured surfaces written as files, for tests of what reads them.

#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <zip.h>
#include <zlib.h>

#include "analysis/numbers/number_text.h"
#include "stimuli/measured/measured_surface.h"

namespace asperity::test {

/// The lowest `width` bytes of a number, the lowest first.
inline std::string little_endian(std::uint64_t number, std::size_t width) {
  std::string bytes{};
  for (std::size_t i = 0; i < width; ++i) {
    bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  }
  return bytes;
}
inline std::string float_bytes(double number) {
  return little_endian(std::bit_cast<std::uint32_t>(static_cast<float>(number)), 4);
}
inline std::string double_bytes(double number) {
  return little_endian(std::bit_cast<std::uint64_t>(number), 8);
}

inline std::string zip_of(const std::map<std::string, std::string>& entries) {
  zip_source_t* const memory = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(memory);
  zip_t* const archive = zip_open_from_source(memory, ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto& [path, content] : entries) {
    zip_source_t* const entry = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t index = zip_file_add(archive, path.c_str(), entry, ZIP_FL_OVERWRITE);
    if (index < 0) throw std::runtime_error("no entry of a zip archive");
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 0);
  }
  zip_stat_t stat{};
  if (zip_close(archive) != 0 || zip_source_stat(memory, &stat) != 0) {
    throw std::runtime_error("no zip archive");
  }
  std::string bytes(stat.size, '\0');
  zip_source_open(memory);
  zip_source_read(memory, bytes.data(), bytes.size());
  zip_source_close(memory);
  zip_source_free(memory);
  return bytes;
}

/// How numbers are stored: level · step_m + offset_m; for F and D of X3P the level is not rounded.
struct StoredLevels {
  double step_m = 1e-9;
  double offset_m = 0.0;
};

inline double level_of(double height_m, const StoredLevels& levels) {
  return (height_m - levels.offset_m) / levels.step_m;
}

inline std::string main_xml_of(const MeasuredSurface& surface, char type,
                               const StoredLevels& levels, bool has_mask) {
  const auto axis = [](const std::string& name, const std::string& kind, char data, double step,
                       double offset) {
    return '<' + name + "><AxisType>" + kind + "</AxisType><DataType>" + data +
           "</DataType><Increment>" + number_text(step) + "</Increment><Offset>" +
           number_text(offset) + "</Offset></" + name + ">\n";
  };
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n"
         "<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>\n" +
         axis("CX", "I", 'D', surface.pitch_x_m, 0.0) +
         axis("CY", "I", 'D', surface.pitch_y_m, 0.0) +
         axis("CZ", "A", type, levels.step_m, levels.offset_m) +
         "</Axes></Record1>\n"
         "<Record3><MatrixDimension><SizeX>" +
         std::to_string(surface.columns) + "</SizeX><SizeY>" + std::to_string(surface.rows) +
         "</SizeY><SizeZ>1</SizeZ></MatrixDimension>\n"
         "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>" +
         (has_mask ? "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>" : "") +
         "</DataLink></Record3>\n"
         "</p:ISO5436_2>\n";
}

/// The entries of an X3P file by their paths. The type is I, L, F or D; whole numbers mark missing points by a mask, floating-point
/// numbers by NaN.
inline std::map<std::string, std::string> x3p_entries_of(const MeasuredSurface& surface, char type,
                                                         const StoredLevels& levels = {}) {
  const bool is_whole = type == 'I' || type == 'L';
  std::string data{};
  std::string valid((surface.heights_m.size() + 7) / 8, '\0');
  for (std::size_t i = 0; i < surface.heights_m.size(); ++i) {
    const double level = level_of(surface.heights_m[i], levels);
    const bool is_missing = std::isnan(level);
    if (!is_missing) valid[i / 8] = static_cast<char>(valid[i / 8] | 1 << (i % 8));
    if (type == 'F') data += float_bytes(level);
    if (type == 'D') data += double_bytes(level);
    if (!is_whole) continue;
    const std::int64_t whole = is_missing ? 7 : std::llround(level);
    data += little_endian(static_cast<std::uint64_t>(whole), type == 'I' ? 2 : 4);
  }
  std::map<std::string, std::string> entries{
      {"main.xml", main_xml_of(surface, type, levels, is_whole)}, {"bindata/data.bin", data}};
  if (is_whole) entries.emplace("bindata/valid.bin", valid);
  return entries;
}

inline std::string x3p_of(const MeasuredSurface& surface, char type = 'D',
                          const StoredLevels& levels = {}) {
  return zip_of(x3p_entries_of(surface, type, levels));
}

/// With the units mm along x, µm along y and nm for the heights.
inline std::string sur_of(const MeasuredSurface& surface, int bits = 32, bool is_compressed = false,
                          const StoredLevels& levels = {}) {
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(width, ' ');
    return text;
  };
  constexpr std::int64_t kLeast = -20000;
  std::string points{};
  for (const double height_m : surface.heights_m) {
    const std::int64_t level =
        std::isnan(height_m) ? kLeast - 2 : std::llround(level_of(height_m, levels));
    points += little_endian(static_cast<std::uint64_t>(level), static_cast<std::size_t>(bits) / 8);
  }
  std::string file = is_compressed ? "DSCOMPRESSED" : "DIGITAL SURF";
  file += little_endian(0, 2) + little_endian(1, 2) + little_endian(1, 2) + little_endian(2, 2);
  file += padded("made", 30) + padded("test", 30);
  for (const std::uint64_t word : {0, 0, 0, 1, 0}) file += little_endian(word, 2);
  file += std::string(8, '\0') + little_endian(static_cast<std::uint64_t>(bits), 2);
  file += little_endian(static_cast<std::uint64_t>(kLeast), 4) + little_endian(20000, 4);
  file += little_endian(surface.columns, 4) + little_endian(surface.rows, 4) +
          little_endian(surface.heights_m.size(), 4);
  file += float_bytes(surface.pitch_x_m * 1e3) + float_bytes(surface.pitch_y_m * 1e6) +
          float_bytes(levels.step_m * 1e9);
  for (const char* axis : {"X", "Y", "Z"}) file += padded(axis, 16);
  for (int repeated = 0; repeated < 2; ++repeated) {
    for (const char* unit : {"mm", "\xB5m", "nm"}) file += padded(unit, 16);
  }
  file += float_bytes(1) + float_bytes(1) + float_bytes(1);
  file += std::string(334 - file.size(), '\0');
  const std::string comment = "a comment";
  file += little_endian(comment.size(), 2) + little_endian(3, 2);
  file += padded("", 128) + float_bytes(0) + float_bytes(0) + float_bytes(levels.offset_m * 1e9);
  file += padded("", 34) + comment + "pri";
  if (!is_compressed) return file + points;
  std::string table = little_endian(2, 4);
  std::string streams{};
  const std::size_t half = points.size() / 2;
  for (const std::string& part : {points.substr(0, half), points.substr(half)}) {
    std::string stream(compressBound(part.size()), '\0');
    uLongf length = stream.size();
    compress(reinterpret_cast<Bytef*>(stream.data()), &length,
             reinterpret_cast<const Bytef*>(part.data()), part.size());
    table += little_endian(part.size(), 4) + little_endian(length, 4);
    streams += stream.substr(0, length);
  }
  return file + table + streams;
}

/// A component of a GWY file: name, type and the bytes of its value.
inline std::string gwy_component(const std::string& name, char type, const std::string& value) {
  return name + '\0' + type + value;
}

inline std::string gwy_object(const std::string& type, const std::string& components) {
  return type + '\0' + little_endian(components.size(), 4) + components;
}

inline std::string gwy_field(const MeasuredSurface& surface, const std::vector<double>& values,
                             const std::string& unit_z) {
  const auto unit = [](const std::string& text) {
    return gwy_object("GwySIUnit", gwy_component("unitstr", 's', text + '\0'));
  };
  std::string data = little_endian(values.size(), 4);
  for (const double value : values) data += double_bytes(value);
  return gwy_object(
      "GwyDataField",
      gwy_component("xres", 'i', little_endian(surface.columns, 4)) +
          gwy_component("yres", 'i', little_endian(surface.rows, 4)) +
          gwy_component("xreal", 'd',
                        double_bytes(surface.pitch_x_m * static_cast<double>(surface.columns))) +
          gwy_component("yreal", 'd',
                        double_bytes(surface.pitch_y_m * static_cast<double>(surface.rows))) +
          gwy_component("si_unit_xy", 'o', unit("m")) +
          gwy_component("si_unit_z", 'o', unit(unit_z)) + gwy_component("data", 'D', data));
}

/// Channel 0 is a phase in degrees, channel 2 the heights; a mask marks missing points.
inline std::string gwy_of(const MeasuredSurface& surface) {
  std::vector<double> heights = surface.heights_m;
  std::vector<double> mask(heights.size(), 0.0);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!std::isnan(heights[i])) continue;
    mask[i] = 1.0;
    heights[i] = 3.0;  // what stands at a masked point is not a height
  }
  const std::vector<double> phase(heights.size(), 30.0);
  return "GWYP" + gwy_object("GwyContainer",
                             gwy_component("/0/data", 'o', gwy_field(surface, phase, "deg")) +
                                 gwy_component("/2/data/title", 's', std::string("Height") + '\0') +
                                 gwy_component("/2/data/visible", 'b', "\1") +
                                 gwy_component("/2/mask", 'o', gwy_field(surface, mask, "")) +
                                 gwy_component("/2/data", 'o', gwy_field(surface, heights, "m")));
}

/// One strip of 32-bit floating-point numbers; with a text of `no_data`, as GDAL states the number of missing points.
inline std::string float_tiff_of(const MeasuredSurface& surface, double height_unit_m,
                                 const std::string& no_data = "") {
  std::string data{};
  for (const double height_m : surface.heights_m) data += float_bytes(height_m / height_unit_m);
  constexpr std::uint64_t kDirectory = 8;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> tags{{256, surface.columns},
                                                            {257, surface.rows},
                                                            {258, 32},
                                                            {259, 1},
                                                            {262, 1},
                                                            {273, 0},
                                                            {277, 1},
                                                            {278, surface.rows},
                                                            {279, data.size()},
                                                            {339, 3}};
  if (!no_data.empty()) tags.emplace_back(42113, 0);
  const std::uint64_t data_at = kDirectory + 2 + 12 * tags.size() + 4;
  std::string file =
      "II*" + std::string(1, '\0') + little_endian(kDirectory, 4) + little_endian(tags.size(), 2);
  for (const auto& [tag, value] : tags) {
    const bool is_short = tag == 258 || tag == 259 || tag == 262 || tag == 277 || tag == 339;
    if (tag == 42113) {
      file += little_endian(tag, 2) + little_endian(2, 2) + little_endian(no_data.size() + 1, 4) +
              little_endian(data_at + data.size(), 4);
      continue;
    }
    file += little_endian(tag, 2) + little_endian(is_short ? 3 : 4, 2) + little_endian(1, 4) +
            little_endian(tag == 273 ? data_at : value, 4);
  }
  file += little_endian(0, 4) + data;
  return no_data.empty() ? file : file + no_data + '\0';
}

}  // namespace asperity::test
