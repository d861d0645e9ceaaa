// Implements the reading of XML elements.

#include "stimuli/measured/xml_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "analysis/numbers/look_alikes.h"
#include "analysis/words/phrased_error.h"

namespace asperity {
namespace {

constexpr std::size_t kDeepest = 32;
constexpr const char* kSpaces = " \t\r\n";

class XmlReader final {
 public:
  XmlReader(std::string_view xml, const std::string& name)
      : rest_(without_byte_order_mark(xml)), name_(name) {}

  XmlElement root() {
    skip_to_element();
    if (!rest_.starts_with('<')) {
      refuse_here(phrase("Stimuli", "the file is not XML; choose another file"));
    }
    XmlElement element = read_element(0);
    skip_to_element();
    if (!rest_.empty())
      refuse_here(phrase("Stimuli", "there is text after the root element; copy the file again"));
    return element;
  }

 private:
  [[noreturn]] void refuse_here(const Phrase& problem) const {
    refuse_xml_line(name_, line_, problem);
  }

  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    line_ += static_cast<std::size_t>(std::count(taken.begin(), taken.end(), '\n'));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  /// What stands before `mark`, which is taken as well.
  std::string_view take_until(std::string_view mark) {
    const std::size_t at = rest_.find(mark);
    if (at == std::string_view::npos) {
      refuse_here(phrase("Stimuli", "the file ends before \"%1\"; copy the file again")
                      .with(std::string(mark)));
    }
    const std::string_view taken = take(at);
    take(mark.size());
    return taken;
  }

  /// Comments and processing instructions; false where neither begins.
  bool skip_note() {
    if (rest_.starts_with("<!--")) {
      take_until("-->");
    } else if (rest_.starts_with("<?")) {
      take_until("?>");
    } else {
      return false;
    }
    return true;
  }

  void skip_to_element() {
    do {
      take(std::min(rest_.find_first_not_of(kSpaces), rest_.size()));
    } while (skip_note());
  }

  XmlElement read_element(std::size_t depth) {
    if (depth > kDeepest)
      refuse_here(phrase("Stimuli", "the elements are nested too deeply; choose another file"));
    XmlElement element{.line = line_};
    take(1);
    if (rest_.starts_with('!')) {
      refuse_here(
          phrase("Stimuli", "document types and CDATA are not read; save the file without them"));
    }
    std::string_view mark = take_until(">");
    const bool is_empty = mark.ends_with('/');
    if (is_empty) mark.remove_suffix(1);
    element.name = std::string(mark.substr(0, mark.find_first_of(kSpaces)));
    if (element.name.empty() || element.name.front() == '/') {
      refuse_here(
          phrase("Stimuli",
                 "there is a mark \"<%1>\" where an element should begin; copy the file again")
              .with(std::string(mark)));
    }
    if (is_empty) return element;
    while (true) {
      element.text += take(std::min(rest_.find('<'), rest_.size()));
      if (rest_.empty()) {
        refuse_here(
            phrase("Stimuli", "the element %1 of line %2 is not closed; copy the file again")
                .with(element.name, std::to_string(element.line)));
      }
      if (rest_.starts_with("</")) break;
      if (!skip_note()) element.children.push_back(read_element(depth + 1));
    }
    take(2);
    std::string_view closed = take_until(">");
    closed = closed.substr(0, closed.find_first_of(kSpaces));
    if (closed != element.name) {
      refuse_here(
          phrase("Stimuli", "the element %1 of line %2 is closed as %3; copy the file again")
              .with(element.name, std::to_string(element.line), std::string(closed)));
    }
    const std::size_t first = element.text.find_first_not_of(kSpaces);
    element.text =
        first == std::string::npos
            ? std::string()
            : element.text.substr(first, element.text.find_last_not_of(kSpaces) + 1 - first);
    return element;
  }

  std::string_view rest_{};
  const std::string& name_;
  std::size_t line_ = 1;
};

}  // namespace

std::string_view local_name(std::string_view name) noexcept {
  const std::size_t colon = name.find(':');
  return name.substr(colon == std::string_view::npos ? 0 : colon + 1);
}

const XmlElement* only_child(const XmlElement& parent, std::string_view child_name,
                             const std::string& name) {
  const XmlElement* found = nullptr;
  for (const XmlElement& each : parent.children) {
    if (local_name(each.name) != child_name) continue;
    if (found != nullptr) {
      refuse_xml_line(name, each.line,
                      phrase("Stimuli",
                             "the element %1 has a second %2, after that of line %3; keep the one "
                             "that is meant, or export the file again")
                          .with(parent.name, each.name, std::to_string(found->line)));
    }
    found = &each;
  }
  return found;
}

XmlElement xml_root_in(std::string_view xml, const std::string& name) {
  return XmlReader(xml, name).root();
}

double number_in_element(const XmlElement& element, const std::string& name) {
  double number = 0.0;
  const char* const end = element.text.data() + element.text.size();
  const auto read = std::from_chars(element.text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) {
    refuse_xml_line(
        name, element.line,
        phrase("Stimuli",
               "the element %1 has \"%2\", which is not a finite number; copy the file again")
            .with(element.name, element.text));
  }
  return number;
}

void refuse_xml_line(const std::string& name, std::size_t line, const Phrase& problem) {
  throw PhrasedRefusal(Phrase("%1:%2: %3").with(name, std::to_string(line), problem));
}

}  // namespace asperity
