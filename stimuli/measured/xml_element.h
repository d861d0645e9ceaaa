// Declares the elements of an XML file.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// An element with its text and the elements within it; attributes, comments and processing instructions are left out.
struct XmlElement {
  std::string name{};
  std::string text{};    ///< of the element itself, without spaces at its ends
  std::size_t line = 0;  ///< of its beginning, from 1
  std::vector<XmlElement> children{};
};

/// The name of an element without the prefix of its namespace.
std::string_view local_name(std::string_view name) noexcept;

/// The child of this name, whatever its prefix; null without one. `name` names the file in messages.
///
/// Errors: std::invalid_argument that begins with `name` and a line, for an element that has two of them.
const XmlElement* only_child(const XmlElement& parent, std::string_view child_name,
                             const std::string& name);

/// Reads the root element of an XML file as far as tables of numbers need it: entities are kept as they are written, and the
/// prefix of a namespace is part of an element's name. A byte order mark is skipped. `name` names the file in messages.
///
/// Errors: std::invalid_argument that begins with `name` and the line, for an element that is not closed, a mark that is not
/// complete, a document type, and nesting of more than 32 elements.
XmlElement xml_root_in(std::string_view xml, const std::string& name);

/// The finite number that is the text of an element.
///
/// Errors: std::invalid_argument that begins with `name` and the line of the element.
double number_in_element(const XmlElement& element, const std::string& name);

/// Throws std::invalid_argument: "NAME:LINE: PROBLEM".
[[noreturn]] void refuse_xml_line(const std::string& name, std::size_t line, const Phrase& problem);

}  // namespace asperity
