// Implements the reader of PLY, as text and as binary of either byte order.

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "stimuli/meshes/mesh_decoding.h"

namespace asperity {

namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(Scalar type) {
  switch (type) {
    case Scalar::int8:
    case Scalar::uint8:
      return 1;
    case Scalar::int16:
    case Scalar::uint16:
      return 2;
    case Scalar::int32:
    case Scalar::uint32:
    case Scalar::float32:
      return 4;
    case Scalar::float64:
      return 8;
  }
  return 8;
}

struct Property {
  std::string name{};
  Scalar type = Scalar::float32;
  std::optional<Scalar> length_type{};  ///< of a list
};

struct Element {
  std::string name{};
  std::size_t count = 0;
  std::vector<Property> properties{};
};

enum class Encoding { text, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements{};
};

Scalar scalar_type(const MeshText& text, std::string_view word) {
  constexpr std::pair<const char*, Scalar> kTypes[] = {
      {"char", Scalar::int8},      {"int8", Scalar::int8},       {"uchar", Scalar::uint8},
      {"uint8", Scalar::uint8},    {"short", Scalar::int16},     {"int16", Scalar::int16},
      {"ushort", Scalar::uint16},  {"uint16", Scalar::uint16},   {"int", Scalar::int32},
      {"int32", Scalar::int32},    {"uint", Scalar::uint32},     {"uint32", Scalar::uint32},
      {"float", Scalar::float32},  {"float32", Scalar::float32}, {"double", Scalar::float64},
      {"float64", Scalar::float64}};
  for (const auto& [name, type] : kTypes) {
    if (word == name) return type;
  }
  text.refuse('"' + std::string(word.substr(0, 40)) + "\" is not a type of PLY.");
}

Header read_header(MeshText& text) {
  Header header{};
  bool has_format = false;
  text.next_line();  // ply
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "end_header") {
      if (!has_format) text.refuse("the header states no format.");
      return header;
    }
    if (keyword == "format") {
      const std::string_view encoding = text.word();
      if (encoding == "ascii") {
        header.encoding = Encoding::text;
      } else if (encoding == "binary_little_endian") {
        header.encoding = Encoding::little_endian;
      } else if (encoding == "binary_big_endian") {
        header.encoding = Encoding::big_endian;
      } else {
        text.refuse('"' + std::string(encoding.substr(0, 40)) + "\" is not a format of PLY.");
      }
      has_format = true;
    } else if (keyword == "element") {
      Element element{std::string(text.word()), 0, {}};
      const std::int64_t count = text.integer_in(text.word());
      if (count < 0) text.refuse("an element cannot occur " + std::to_string(count) + " times.");
      element.count = static_cast<std::size_t>(count);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) text.refuse("a property precedes the first element.");
      Property property{};
      std::string_view type = text.word();
      if (type == "list") {
        property.length_type = scalar_type(text, text.word());
        type = text.word();
      }
      property.type = scalar_type(text, type);
      property.name = text.word();
      header.elements.back().properties.push_back(std::move(property));
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      text.refuse('"' + std::string(keyword.substr(0, 40)) +
                  "\" is not a keyword of a PLY header.");
    }
  }
  text.refuse("the file ends within its header.");
}

/// Reads the numbers of the body in any encoding. A double represents every integer of PLY exactly.
class Numbers {
 public:
  virtual ~Numbers() = default;
  /// The next number; nullopt at the end of the file.
  virtual std::optional<double> next(Scalar type) = 0;
  virtual std::size_t rest_bytes() const = 0;
};

class TextNumbers final : public Numbers {
 public:
  explicit TextNumbers(MeshText& text) : text_(text) {}
  std::optional<double> next(Scalar /*type*/) override {
    const std::string_view word = text_.word_of_any_line();
    if (word.empty()) return {};
    return text_.number_in(word);
  }
  // The current line is included; no line is much longer than this.
  std::size_t rest_bytes() const override { return text_.rest_bytes() + 4096; }

 private:
  MeshText& text_;
};

class BinaryNumbers final : public Numbers {
 public:
  BinaryNumbers(std::string_view bytes, Encoding encoding)
      : bytes_(bytes),
        swapped_((encoding == Encoding::big_endian) ==
                 (std::endian::native == std::endian::little)) {}

  std::optional<double> next(Scalar type) override {
    const std::size_t size = bytes_of(type);
    if (bytes_.size() < size) return {};
    std::array<char, 8> own{};
    for (std::size_t i = 0; i < size; ++i) own[i] = bytes_[swapped_ ? size - 1 - i : i];
    bytes_.remove_prefix(size);
    switch (type) {
      case Scalar::int8:
        return number<std::int8_t>(own);
      case Scalar::uint8:
        return number<std::uint8_t>(own);
      case Scalar::int16:
        return number<std::int16_t>(own);
      case Scalar::uint16:
        return number<std::uint16_t>(own);
      case Scalar::int32:
        return number<std::int32_t>(own);
      case Scalar::uint32:
        return number<std::uint32_t>(own);
      case Scalar::float32:
        return number<float>(own);
      case Scalar::float64:
        return number<double>(own);
    }
    return {};
  }
  std::size_t rest_bytes() const override { return bytes_.size(); }

 private:
  template <class Type>
  static double number(const std::array<char, 8>& bytes) {
    Type value{};
    std::memcpy(&value, bytes.data(), sizeof(Type));
    return static_cast<double>(value);
  }

  std::string_view bytes_;
  bool swapped_;
};

class Body final {
 public:
  Body(Numbers& numbers, GrowingMesh& mesh, std::string name)
      : numbers_(numbers), mesh_(mesh), name_(std::move(name)) {}

  void read(const Element& element) {
    element_ = &element;
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    const bool is_strips = element.name == "tristrips";
    if (element.properties.empty()) return;  // occupies no bytes in the file
    if (element.count > numbers_.rest_bytes()) cut_off(0);
    const std::array<std::optional<std::size_t>, 3> axes{property("x"), property("y"),
                                                         property("z")};
    if (is_vertex && !(axes[0] && axes[1] && axes[2])) {
      throw std::invalid_argument(name_ + " has vertices without properties x, y and z. " +
                                  kExportAgain);
    }
    std::optional<std::size_t> indices = property("vertex_indices");
    if (!indices) indices = property("vertex_index");
    if ((is_face || is_strips) && element.count > 0 &&
        !(indices && element.properties[*indices].length_type)) {
      throw std::invalid_argument(name_ + " has an element " + element.name +
                                  " without the list property vertex_indices. " + kExportAgain);
    }
    if (is_vertex) mesh_.reserve(element.count, 0);
    if (is_face) mesh_.reserve(0, element.count);
    std::vector<double> values(element.properties.size());
    for (std::size_t item = 0; item < element.count; ++item) {
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& one = element.properties[i];
        if (!one.length_type) {
          values[i] = next(one.type, item);
        } else {
          read_list(one, item, (is_face || is_strips) && i == *indices);
        }
      }
      if (is_vertex) mesh_.add_vertex({values[*axes[0]], values[*axes[1]], values[*axes[2]]});
      if (is_face) mesh_.add_face(corners_);
      if (is_strips) mesh_.add_strips(corners_);
    }
  }

 private:
  std::optional<std::size_t> property(const char* name) const {
    for (std::size_t i = 0; i < element_->properties.size(); ++i) {
      if (element_->properties[i].name == name) return i;
    }
    return {};
  }

  void read_list(const Property& list, std::size_t item, bool wanted) {
    const double length = next(*list.length_type, item);
    if (!(length >= 0.0) || length > static_cast<double>(numbers_.rest_bytes())) {
      throw std::invalid_argument(name_ + " states a list of the length " + number_text(length) +
                                  " in its " + element_->name + ' ' + std::to_string(item + 1) +
                                  ", which the file does not contain. " + kExportAgain);
    }
    if (wanted) corners_.clear();
    for (auto i = static_cast<std::size_t>(length); i > 0; --i) {
      const double entry = next(list.type, item);
      if (!wanted) continue;
      if (!(std::abs(entry) <= 4294967295.0) || entry != std::floor(entry)) {
        throw std::invalid_argument(
            name_ + " has an entry that is not the number of a vertex in its " + element_->name +
            ' ' + std::to_string(item + 1) + ". " + kExportAgain);
      }
      corners_.push_back(static_cast<std::int64_t>(entry));
    }
  }

  double next(Scalar type, std::size_t item) {
    const std::optional<double> number = numbers_.next(type);
    if (!number) cut_off(item);
    return *number;
  }

  [[noreturn]] void cut_off(std::size_t item) const {
    throw std::invalid_argument(name_ + " is truncated: its header states " +
                                std::to_string(element_->count) + " as the number of \"" +
                                element_->name + "\", and the file contains " +
                                std::to_string(item) + ". " + kExportAgain);
  }

  Numbers& numbers_;
  GrowingMesh& mesh_;
  std::string name_;
  const Element* element_ = nullptr;
  std::vector<std::int64_t> corners_{};
};

}  // namespace

ReadMesh decode_ply(std::string_view content, const MeshReading& reading, const std::string& name) {
  MeshText text(content, name);
  const Header header = read_header(text);
  GrowingMesh mesh(reading, name);
  const auto read_all = [&](Numbers& numbers) {
    Body body(numbers, mesh, name);
    for (const Element& element : header.elements) body.read(element);
  };
  if (header.encoding == Encoding::text) {
    TextNumbers numbers(text);
    read_all(numbers);
    return mesh.finish(MeshFormat::ply_ascii);
  }
  const auto begin = static_cast<std::size_t>(text.position() - content.data());
  BinaryNumbers numbers(content.substr(begin), header.encoding);
  read_all(numbers);
  return mesh.finish(MeshFormat::ply_binary);
}

}  // namespace asperity
