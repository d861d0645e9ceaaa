// Implements the decoding of X3P files (ISO 25178-72): a zip archive with main.xml and a matrix of numbers.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"
#include "stimuli/measured/xml_element.h"
#include "stimuli/measured/zip_archive.h"

namespace asperity {

namespace {

constexpr std::string_view kMain = "main.xml";
constexpr std::size_t kMostMainBytes = std::size_t{4} << 20;

/// The elements of main.xml by their paths.
class X3pDescription final {
 public:
  X3pDescription(std::string_view xml, const std::string& name)
      : name_(name), root_(xml_root_in(xml, name_)) {
    // Some programs write the name of the series of standards without its part.
    const std::string_view root = local_name(root_.name);
    if (root != "ISO5436_2" && root != "ISO5436") {
      refuse(root_,
             phrase("Stimuli",
                    "the root element is %1, not ISO5436_2 of an X3P file; choose an X3P file")
                 .with(root_.name));
    }
  }

  [[noreturn]] void refuse(const XmlElement& element, const Phrase& problem) const {
    refuse_xml_line(name_, element.line, problem);
  }

  /// Null if an element on the way is missing.
  const XmlElement* find(std::initializer_list<std::string_view> path) const {
    const XmlElement* element = &root_;
    for (const std::string_view name : path) {
      element = only_child(*element, name, name_);
      if (element == nullptr) return nullptr;
    }
    return element;
  }

  const XmlElement& at(std::initializer_list<std::string_view> path) const {
    const XmlElement* element = &root_;
    for (const std::string_view name : path) {
      const XmlElement* const next = only_child(*element, name, name_);
      if (next == nullptr) {
        refuse(*element,
               phrase("Stimuli", "the element %1 has no element %2; export the surface again")
                   .with(element->name, std::string(name)));
      }
      element = next;
    }
    return *element;
  }

  double number(std::initializer_list<std::string_view> path) const {
    return number_in_element(at(path), name_);
  }

  double number_or(std::initializer_list<std::string_view> path, double otherwise) const {
    const XmlElement* const element = find(path);
    return element == nullptr ? otherwise : number_in_element(*element, name_);
  }

  /// A whole number that is not negative.
  std::uint64_t count(std::initializer_list<std::string_view> path) const {
    const double value = number(path);
    constexpr double kGreatest = 4294967295.0;
    if (value < 0.0 || value > kGreatest || value != std::floor(value)) {
      refuse(at(path), phrase("Stimuli",
                              "the element %1 has \"%2\", which is not a number of points; export "
                              "the surface again")
                           .with(at(path).name, at(path).text));
    }
    return static_cast<std::uint64_t>(value);
  }

  void require(std::initializer_list<std::string_view> path, std::string_view wanted,
               const Phrase& meaning) const {
    const XmlElement& element = at(path);
    if (element.text == wanted) return;
    refuse(element, phrase("Stimuli",
                           "the element %1 has \"%2\", and only \"%3\", %4, is supported; export a "
                           "surface with a regular grid")
                        .with(element.name, element.text, std::string(wanted), meaning));
  }

 private:
  std::string name_;  // of the archive and the entry
  XmlElement root_;
};

/// The folder of main.xml within the archive, usually the root: "" or "FOLDER/".
std::string folder_of_main(const ZipArchive& archive, const std::string& name) {
  if (archive.bytes_of(std::string(kMain))) return {};
  std::vector<std::string> folders{};
  for (const std::string& path : archive.paths()) {
    if (path.ends_with('/' + std::string(kMain))) {
      folders.push_back(path.substr(0, path.size() - kMain.size()));
    }
  }
  if (folders.size() > 1) {
    throw PhrasedRefusal(
        phrase("Stimuli", "%1: there is a main.xml in %2 and in %3; export one surface per file")
            .with(name, folders[0], folders[1]));
  }
  if (folders.size() == 1) return folders.front();
  throw PhrasedRefusal(
      phrase("Stimuli",
             "%1 is a zip archive without main.xml, not an X3P file. Choose an X3P file.")
          .with(name));
}

std::size_t bytes_per_point(const X3pDescription& description) {
  const XmlElement& type = description.at({"Record1", "Axes", "CZ", "DataType"});
  if (type.text == "I") return 2;
  if (type.text == "L" || type.text == "F") return 4;
  if (type.text == "D") return 8;
  description.refuse(type, phrase("Stimuli",
                                  "the heights have the data type \"%1\"; I, L, F and D are "
                                  "possible; export the surface again")
                               .with(type.text));
}

/// An entry that must have `expected` bytes.
std::vector<std::byte> matrix(const ZipArchive& archive, const std::string& folder,
                              const XmlElement& link, std::size_t expected,
                              const X3pDescription& description) {
  const std::string path = folder + link.text;
  const std::optional<std::size_t> bytes = archive.bytes_of(path);
  if (!bytes) {
    description.refuse(
        link,
        phrase(
            "Stimuli",
            "the archive has no entry \"%1\", which is named here; copy or export the file again")
            .with(path));
  }
  if (*bytes != expected) {
    description.refuse(link, phrase("Stimuli",
                                    "the entry %1 has %2 bytes, and the points of the surface take "
                                    "%3; export the file again")
                                 .with(path, std::to_string(*bytes), std::to_string(expected)));
  }
  return archive.content(path, expected);
}

}  // namespace

MeasuredSurface decode_x3p(std::span<const std::byte> bytes, const std::string& name) {
  const ZipArchive archive(bytes, name);
  const std::string folder = folder_of_main(archive, name);
  const std::vector<std::byte> main = archive.content(folder + std::string(kMain), kMostMainBytes);
  const X3pDescription description(SurfaceBytes(main, name).text(0, main.size()),
                                   name + ": " + folder + std::string(kMain));
  description.require({"Record1", "FeatureType"}, "SUR", phrase("Stimuli", "a surface"));
  description.require({"Record1", "Axes", "CX", "AxisType"}, "I",
                      phrase("Stimuli", "equal distances"));
  description.require({"Record1", "Axes", "CY", "AxisType"}, "I",
                      phrase("Stimuli", "equal distances"));
  description.require({"Record1", "Axes", "CZ", "AxisType"}, "A",
                      phrase("Stimuli", "absolute heights"));
  const std::uint64_t columns = description.count({"Record3", "MatrixDimension", "SizeX"});
  const std::uint64_t rows = description.count({"Record3", "MatrixDimension", "SizeY"});
  const XmlElement& dimensions = description.at({"Record3", "MatrixDimension"});
  const Phrase problem = points_problem(columns, rows);
  if (!problem.empty()) description.refuse(dimensions, problem);
  if (description.count({"Record3", "MatrixDimension", "SizeZ"}) != 1) {
    description.refuse(dimensions,
                       phrase("Stimuli", "there are several layers; export one surface"));
  }
  if (const XmlElement* const list = description.find({"Record3", "DataList"})) {
    description.refuse(
        *list, phrase("Stimuli",
                      "the heights are a list of texts, which is not supported; export them "
                      "as a binary matrix"));
  }

  MeasuredSurface surface{.rows = rows, .columns = columns};
  surface.pitch_x_m = std::abs(description.number({"Record1", "Axes", "CX", "Increment"}));
  surface.pitch_y_m = std::abs(description.number({"Record1", "Axes", "CY", "Increment"}));
  const double step_m = description.number_or({"Record1", "Axes", "CZ", "Increment"}, 1.0);
  if (step_m == 0.0) {
    description.refuse(
        description.at({"Record1", "Axes", "CZ", "Increment"}),
        phrase("Stimuli",
               "the increment of the heights is 0, so that the surface is flat; correct "
               "it, or export the surface again"));
  }
  const double offset_m = description.number_or({"Record1", "Axes", "CZ", "Offset"}, 0.0);
  const std::string type = description.at({"Record1", "Axes", "CZ", "DataType"}).text;
  const std::size_t count = rows * columns;
  const std::vector<std::byte> stored =
      matrix(archive, folder, description.at({"Record3", "DataLink", "PointDataLink"}),
             count * bytes_per_point(description), description);
  const SurfaceBytes points(stored, name);
  surface.heights_m.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = type == "I"   ? points.i16(2 * i)
                         : type == "L" ? points.i32(4 * i)
                         : type == "F" ? points.f32(4 * i)
                                       : points.f64(8 * i);
    surface.heights_m[i] = value * step_m + offset_m;
  }
  if (const XmlElement* const link = description.find({"Record3", "DataLink", "ValidPointsLink"})) {
    // One bit for each point, the lowest bit of a byte first.
    const std::vector<std::byte> valid =
        matrix(archive, folder, *link, (count + 7) / 8, description);
    for (std::size_t i = 0; i < count; ++i) {
      if ((std::to_integer<unsigned>(valid[i / 8]) >> (i % 8) & 1U) == 0U) {
        surface.heights_m[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
  return surface;
}

}  // namespace asperity
