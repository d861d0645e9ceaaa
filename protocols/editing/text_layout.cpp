// Implements the layout of new entries.

#include "protocols/editing/text_layout.h"

#include <algorithm>

#include "protocols/design/json_pointer.h"

namespace asperity {

namespace {

constexpr std::size_t kLongestLine = 120;

/// The last line break of white space and the indentation after it; the white space itself if it has none.
std::string_view last_line(std::string_view space) {
  const std::size_t newline = space.rfind('\n');
  if (newline == std::string_view::npos) return space;
  const bool has_return = newline > 0 && space[newline - 1] == '\r';
  return space.substr(has_return ? newline - 1 : newline);
}

std::string_view after_newline(std::string_view space) {
  return space.substr(space.rfind('\n') + 1);  // all of it if it has none
}

bool has_newline(std::string_view space) { return space.find('\n') != std::string_view::npos; }

/// The indentation of the outermost entries; two spaces if they are not on lines of their own.
std::string indent_of(const TextContainer& root) {
  const std::string_view space = root.space_before(0);
  const std::string_view indent = after_newline(space);
  return has_newline(space) && !root.entries().empty() && !indent.empty() ? std::string(indent)
                                                                          : "  ";
}

/// What stands between the first key of the object and its value; nothing if that is more than one line.
std::string colon_of(const TextContainer& object) {
  if (!object.is_object() || object.entries().empty()) return {};
  const std::string_view before = object.text_before_value(0);
  const std::string_view colon = before.substr(before.find_last_of('"') + 1);
  return has_newline(colon) ? std::string() : std::string(colon);
}

/// The white space before a new entry, as before its neighbours.
std::string_view space_like(const TextContainer& container, std::size_t index,
                            std::string_view after_comma) {
  const std::size_t count = container.entries().size();
  if (count > 1) return container.space_before(std::clamp(index, std::size_t{1}, count - 1));
  const std::string_view first = container.space_before(0);
  return has_newline(first) ? first : after_comma;
}

/// Writes values on one line or on several.
class Layout final {
 public:
  Layout(const JsonDocument& document, const EntryGap& gap)
      : document_(document), gap_(gap), comma_(gap.colon == ":" ? "," : ", ") {}

  std::string text(const std::string& pointer, const std::string& margin,
                   std::size_t column) const {
    std::string line = on_one_line(pointer);
    if (gap_.line_break.empty() || column + line.size() <= kLongestLine) return line;
    const std::string inner = margin + gap_.indent;
    std::string text{};
    for_each_entry(pointer, [&](const std::string& key, const std::string& entry) {
      text += (text.empty() ? "" : ",") + gap_.line_break + inner + key;
      text += this->text(entry, inner, inner.size() + key.size());
    });
    if (text.empty()) return line;
    return line.front() + text + gap_.line_break + margin + line.back();
  }

 private:
  template <class Visit>
  void for_each_entry(const std::string& pointer, const Visit& visit) const {
    if (!value_at(document_, pointer).is_structured()) return;
    const TextContainer container(document_, pointer);
    for (std::size_t i = 0; i < container.entries().size(); ++i) {
      std::string key(container.text_before_value(i));
      if (container.is_object()) key = key.substr(0, key.find_last_of('"') + 1) + gap_.colon;
      visit(key, container.is_object() ? pointer_to(pointer, container.entries()[i].key)
                                       : pointer_to(pointer, i));
    }
  }

  std::string on_one_line(const std::string& pointer) const {
    const nlohmann::json& value = value_at(document_, pointer);
    const JsonPlace place = document_.place_of(pointer).value();
    if (!value.is_structured()) {
      return std::string(document_.text().substr(place.value, place.end - place.value));
    }
    std::string text{};
    for_each_entry(pointer, [&](const std::string& key, const std::string& entry) {
      text += (text.empty() ? "" : comma_) + key + on_one_line(entry);
    });
    return document_.text()[place.value] + text + document_.text()[place.end - 1];
  }

  const JsonDocument& document_;
  const EntryGap& gap_;
  std::string comma_;
};

}  // namespace

EntryGap gap_at(const JsonDocument& document, const TextContainer& container, std::size_t index) {
  EntryGap gap{};
  const TextContainer root(document, "");
  gap.indent = indent_of(root);
  gap.colon = colon_of(container);
  if (gap.colon.empty()) gap.colon = colon_of(root);
  if (gap.colon.empty()) gap.colon = ": ";
  std::string space{};
  if (container.entries().empty()) {
    space = last_line(container.space_before(0));
    if (has_newline(space)) space += gap.indent;
    gap.offset = container.begin();
    gap.before = space;
  } else {
    space = last_line(space_like(container, index, gap.colon == ":" ? "" : " "));
    if (index == 0) {
      gap.offset = container.entries().front().place.key;
      gap.after = "," + space;
    } else {
      gap.offset = container.entries()[index - 1].place.end;
      gap.before = "," + space;
    }
  }
  if (has_newline(space)) {
    gap.margin = after_newline(space);
    gap.line_break = space.substr(0, space.size() - gap.margin.size());
  }
  return gap;
}

std::string laid_out(const JsonDocument& value, const EntryGap& gap, std::string_view key) {
  const std::size_t column = gap.margin.size() + key.size() + gap.colon.size();
  return Layout(value, gap).text("", gap.margin, column);
}

}  // namespace asperity
