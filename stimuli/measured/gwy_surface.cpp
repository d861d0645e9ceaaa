// Implements the decoding of GWY files: the serialised objects of Gwyddion.

#include <charconv>
#include <limits>
#include <map>

#include "stimuli/measured/surface_decoding.h"

namespace asperity {

namespace {

constexpr std::size_t kMagicBytes = 4;
constexpr double kMasked = 0.5;  // a mask has the values 0 and 1

/// The value of a component: its type and its first byte; of an array the number of values.
struct GwyComponent {
  char type = '\0';
  std::size_t at = 0;
  std::size_t count = 0;
};

/// An object: the name of its class, and its components by name.
struct GwyObject {
  std::string_view type{};
  std::size_t at = 0;
  std::map<std::string_view, GwyComponent> components{};
};

class GwyReader final {
 public:
  explicit GwyReader(const SurfaceBytes& file) : file_(file) {}

  /// Reads the components of an object without those of the objects within it.
  GwyObject object_at(std::size_t at) const {
    GwyObject object{.type = file_.text_until_zero(at), .at = at};
    const std::size_t content = at + object.type.size() + 1 + 4;
    const std::size_t end = content + file_.u32(content - 4);
    file_.part(content, end - content);
    for (std::size_t next = content; next < end;) {
      const std::string_view name = file_.text_until_zero(next);
      const std::size_t type_at = next + name.size() + 1;
      const GwyComponent component = component_at(type_at, next);
      next = end_of(component);
      if (next > end) {
        file_.refuse(type_at,
                     phrase("Stimuli",
                            "the component \"%1\" is longer than its object; copy or export "
                            "the file again")
                         .with(shown(name)));
      }
      if (!object.components.emplace(name, component).second) {
        file_.refuse(type_at, phrase("Stimuli",
                                     "the component \"%1\" occurs twice in its object; export the "
                                     "file again")
                                  .with(shown(name)));
      }
    }
    return object;
  }

  /// Null without a component of this name and type.
  static const GwyComponent* find(const GwyObject& object, std::string_view name, char type) {
    const auto found = object.components.find(name);
    return found != object.components.end() && found->second.type == type ? &found->second
                                                                          : nullptr;
  }

  const GwyComponent& at(const GwyObject& object, std::string_view name, char type) const {
    const GwyComponent* const found = find(object, name, type);
    if (found == nullptr) {
      file_.refuse(object.at,
                   phrase("Stimuli", "the %1 has no component %2; copy or export the file again")
                       .with(shown(object.type), std::string(name)));
    }
    return *found;
  }

  std::string text(const GwyComponent& component) const {
    return shown(file_.text_until_zero(component.at));
  }

  /// Printable characters, at most 60 of them.
  static std::string shown(std::string_view text) {
    std::string shown(text.substr(0, 60));
    for (char& c : shown) {
      if (c >= '\0' && c < ' ') c = '?';
    }
    return shown;
  }

 private:
  /// `name_at` is the place for messages.
  GwyComponent component_at(std::size_t type_at, std::size_t name_at) const {
    const char type = file_.text(type_at, 1)[0];
    GwyComponent component{.type = type, .at = type_at + 1, .count = 1};
    if (std::string_view("bciqdso").find(type) != std::string_view::npos) return component;
    if (std::string_view("CIQDSO").find(type) == std::string_view::npos) {
      file_.refuse(type_at,
                   phrase("Stimuli",
                          "the component \"%1\" has an unknown type; copy or export the file "
                          "again")
                       .with(shown(file_.text_until_zero(name_at))));
    }
    component.count = file_.u32(component.at);
    component.at += 4;
    return component;
  }

  std::size_t end_of(const GwyComponent& component) const {
    switch (component.type) {
      case 'b':
      case 'c':
      case 'C':
        return fixed_end(component, 1);
      case 'i':
      case 'I':
        return fixed_end(component, 4);
      case 's':
      case 'S':
        return listed_end(component, [this](std::size_t at) {
          return at + file_.text_until_zero(at).size() + 1;
        });
      case 'o':
      case 'O':
        return listed_end(component, [this](std::size_t at) {
          const std::size_t size_at = at + file_.text_until_zero(at).size() + 1;
          const std::size_t size = file_.u32(size_at);
          file_.part(size_at + 4, size);
          return size_at + 4 + size;
        });
      default:
        return fixed_end(component, 8);
    }
  }

  std::size_t fixed_end(const GwyComponent& component, std::size_t width) const {
    file_.part(component.at, width * component.count);
    return component.at + width * component.count;
  }

  template <typename Next>
  std::size_t listed_end(const GwyComponent& component, const Next& next) const {
    std::size_t at = component.at;
    for (std::size_t i = 0; i < component.count; ++i) at = next(at);
    return at;
  }

  const SurfaceBytes& file_;
};

/// N of "/N/data"; nullopt for every other name.
std::optional<int> channel_in(std::string_view key) {
  if (!key.starts_with('/') || !key.ends_with("/data")) return std::nullopt;
  const std::string_view digits = key.substr(1, key.size() - 1 - std::string_view("/data").size());
  int number = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (read.ec != std::errc() || std::to_string(number) != digits) return std::nullopt;
  return number;
}

std::string unit_of(const GwyReader& reader, const GwyObject& field, std::string_view name) {
  const GwyComponent* const unit = GwyReader::find(field, name, 'o');
  if (unit == nullptr) return {};
  const GwyObject object = reader.object_at(unit->at);
  const GwyComponent* const text = GwyReader::find(object, "unitstr", 's');
  return text == nullptr ? std::string() : reader.text(*text);
}

/// A GwyDataField whose number of values matches its size.
struct GwyField {
  GwyObject object{};
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t data_at = 0;
};

GwyField field_at(const SurfaceBytes& file, const GwyReader& reader, std::size_t at) {
  GwyField field{.object = reader.object_at(at)};
  if (field.object.type != "GwyDataField") {
    file.refuse(at, phrase("Stimuli",
                           "the object is a %1, not a GwyDataField; copy or export the file again")
                        .with(GwyReader::shown(field.object.type)));
  }
  const GwyComponent& columns = reader.at(field.object, "xres", 'i');
  field.columns = file.u32(columns.at);
  field.rows = file.u32(reader.at(field.object, "yres", 'i').at);
  const Phrase problem = points_problem(field.columns, field.rows);
  if (!problem.empty()) file.refuse(columns.at, problem);
  const GwyComponent& data = reader.at(field.object, "data", 'D');
  if (data.count != field.columns * field.rows) {
    file.refuse(data.at, phrase("Stimuli",
                                "there are %1 heights for %2 by %3 points; copy or export the file "
                                "again")
                             .with(std::to_string(data.count), std::to_string(field.columns),
                                   std::to_string(field.rows)));
  }
  field.data_at = data.at;
  return field;
}

/// The channel that is asked for, or the first whose heights are in metres.
int chosen_channel(const SurfaceBytes& file, const GwyReader& reader, const GwyObject& container,
                   const std::optional<int>& wanted) {
  std::map<int, std::size_t> channels{};
  for (const auto& [key, component] : container.components) {
    const std::optional<int> number = channel_in(key);
    if (number && component.type == 'o') channels.emplace(*number, component.at);
  }
  Phrase found{};
  for (const auto& [number, at] : channels) {
    const std::string unit = unit_of(reader, reader.object_at(at), "si_unit_z");
    if (wanted ? number == *wanted && unit == "m" : unit == "m") return number;
    if (found.english().size() > 400) continue;
    const Phrase one = (unit.empty() ? phrase("Stimuli", "%1 in no unit") : Phrase("%1 in %2"))
                           .with(std::to_string(number), unit);
    found = found.empty() ? one : Phrase("%1, %2").with(found, one);
  }
  file.refuse(
      kMagicBytes,
      (wanted
           ? phrase("Stimuli",
                    "there is no channel %2 with heights in m; the channels are %1. Choose a "
                    "channel of heights")
           : phrase("Stimuli",
                    "there is no channel with heights in m; the channels are %1. Choose a channel "
                    "of heights"))
          .with(found.empty() ? phrase("Stimuli", "none") : found,
                wanted ? std::to_string(*wanted) : std::string()));
}

}  // namespace

MeasuredSurface decode_gwy(std::span<const std::byte> bytes, const SurfaceReading& reading,
                           const std::string& name) {
  const SurfaceBytes file(bytes, name);
  const GwyReader reader(file);
  const GwyObject container = reader.object_at(kMagicBytes);
  if (container.type != "GwyContainer") {
    file.refuse(kMagicBytes,
                phrase("Stimuli",
                       "the file has a %1 in place of a GwyContainer; copy or export it "
                       "again")
                    .with(GwyReader::shown(container.type)));
  }
  const int number = chosen_channel(file, reader, container, reading.channel);
  const std::string key = '/' + std::to_string(number);
  const GwyField field = field_at(file, reader, container.components.at(key + "/data").at);
  const std::string lateral = unit_of(reader, field.object, "si_unit_xy");
  if (lateral != "m") {
    file.refuse(field.object.at, phrase("Stimuli",
                                        "the lateral unit is \"%1\", not m; set the physical "
                                        "dimensions in Gwyddion")
                                     .with(lateral));
  }

  MeasuredSurface surface{.rows = field.rows, .columns = field.columns};
  surface.pitch_x_m =
      file.f64(reader.at(field.object, "xreal", 'd').at) / static_cast<double>(field.columns);
  surface.pitch_y_m =
      file.f64(reader.at(field.object, "yreal", 'd').at) / static_cast<double>(field.rows);
  const GwyComponent* const title = GwyReader::find(container, key + "/data/title", 's');
  surface.channel =
      std::to_string(number) + (title == nullptr ? "" : " (" + reader.text(*title) + ')');
  surface.heights_m.resize(field.rows * field.columns);
  for (std::size_t i = 0; i < surface.heights_m.size(); ++i) {
    surface.heights_m[i] = file.f64(field.data_at + 8 * i);
  }
  if (const GwyComponent* const masked = GwyReader::find(container, key + "/mask", 'o')) {
    const GwyField mask = field_at(file, reader, masked->at);
    if (mask.columns != field.columns || mask.rows != field.rows) {
      file.refuse(masked->at,
                  phrase("Stimuli",
                         "the mask and its channel differ in size; remove the mask in Gwyddion"));
    }
    for (std::size_t i = 0; i < surface.heights_m.size(); ++i) {
      if (file.f64(mask.data_at + 8 * i) >= kMasked) {
        surface.heights_m[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
  return surface;
}

}  // namespace asperity
