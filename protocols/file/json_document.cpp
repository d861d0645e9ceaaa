// Implements the parsing of JSON text to a tree with positions, with nlohmann's event parser.

#include "protocols/file/json_document.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "analysis/numbers/look_alikes.h"
#include "protocols/design/json_pointer.h"
#include "protocols/file/json_corrections.h"

namespace asperity {

namespace {

constexpr std::size_t kMaximumBytes = 4U << 20U;
constexpr std::size_t kMaximumDepth = 64;
constexpr std::size_t kMaximumEntries = 4096;
constexpr std::size_t kMaximumString = 8192;
constexpr std::size_t kMaximumKey = 256;

bool has_zero(std::string_view text) { return text.find('\0') != std::string_view::npos; }

/// Counts the characters that the parser has read.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  std::size_t* read = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*read;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

std::string printable(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  for (char& c : shown) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7f) c = '?';
  }
  return "'" + shown + (text.size() > kShown ? "…'" : "'");
}

/// Whether the beginning is binary data: a first byte that is not ASCII text, as in a PNG or a JPEG, or an early zero
/// byte.
bool is_binary(std::string_view text) {
  constexpr std::size_t kBeginning = 512;
  if (text.substr(0, kBeginning).find('\0') != std::string_view::npos) return true;
  const auto first = text.empty() ? ' ' : text.front();
  return static_cast<unsigned char>(first) >= 0x80 ||
         (static_cast<unsigned char>(first) < 0x20 && first != '\t' && first != '\n' &&
          first != '\r');
}

}  // namespace

/// Receives the parser's events. nlohmann emits each event immediately after reading the token, so a token starts at
/// the first character after the last event that is neither space nor punctuation.
class JsonDocument::Handler {
 public:
  Handler(JsonDocument& document, const std::size_t& read) : document_(document), read_(read) {}

  bool null() { return value(nullptr); }
  bool boolean(bool given) { return value(given); }
  bool number_integer(nlohmann::json::number_integer_t given) { return value(given); }
  bool number_unsigned(nlohmann::json::number_unsigned_t given) { return value(given); }
  bool number_float(nlohmann::json::number_float_t given, const std::string&) {
    return value(given);
  }
  bool string(std::string& given) {
    if (given.size() > kMaximumString) {
      return refuse(start(), phrase("Protocols", "this text is longer than %1 bytes; shorten it")
                                 .with(std::to_string(kMaximumString)));
    }
    const std::size_t from = start();
    const bool contains_zero = has_zero(given);
    std::string pointer{};
    if (place(std::move(given), pointer) == nullptr) return false;
    if (contains_zero) {
      problems_.push_back(document_.diagnostic(
          from, pointer,
          phrase("Protocols", "this text contains U+0000 (\\u0000); delete this character")));
    }
    return true;
  }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(nlohmann::json::object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(nlohmann::json::array()); }
  bool end_array() { return close(); }

  bool key(std::string& given) {
    key_start_ = start();
    last_end_ = read_;
    if (given.size() > kMaximumKey) {
      return refuse(key_start_, phrase("Protocols", "this key is longer than %1 bytes; shorten it")
                                    .with(std::to_string(kMaximumKey)));
    }
    Open& parent = stack_.back();
    key_ = given;
    if (parent.node->contains(given)) {
      problems_.push_back(document_.diagnostic(
          key_start_, pointer_to(parent.pointer, given),
          phrase("Protocols", "the key %1 occurs twice in this object; keep one")
              .with(printable(given))));
    }
    if (has_zero(given)) {
      problems_.push_back(document_.diagnostic(
          key_start_, parent.pointer,
          phrase("Protocols", "the key %1 contains U+0000 (\\u0000); delete this character")
              .with(printable(given))));
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) {
    const std::string_view text = document_.text_;
    const std::string what = error.what();
    const std::size_t from = start();
    if (error.id == 406) {  // out_of_range: the number does not fit into a double
      const std::size_t end = std::min(text.find_first_of(" \t\r\n,]}", from), text.size());
      return refuse(
          from, phrase("Protocols", "the number %1 is too large to be read; write a smaller one")
                    .with(printable(text.substr(from, end - from))));
    }
    if (const std::size_t at = what.find("invalid string: "); at != std::string::npos) {
      const std::size_t end = what.find("; last read", at);
      const std::string reason =
          what.substr(at + 16, end == std::string::npos ? end : end - at - 16);
      const std::size_t where = position == 0 ? 0 : std::min(position - 1, text.size());
      if (reason.find("UTF-8") != std::string::npos) {
        return refuse(where, phrase("Protocols", "this text is not UTF-8; save the file as UTF-8"));
      }
      return refuse(where, problem_of_text(reason));
    }
    if (from >= text.size()) {
      return refuse(text.size(),
                    stack_.empty() && !began_
                        ? phrase("Protocols", "the file is empty; write a JSON object {…}")
                        : phrase("Protocols",
                                 "the text ends before the JSON is complete; close every quotation "
                                 "mark and bracket"));
    }
    if (const auto other = look_alike_at(text.substr(from))) {
      return refuse(
          from,
          phrase("Protocols", "there is %1 here; %2").with(other->character, other->correction));
    }
    std::string expected{};
    if (const std::size_t at = what.find("; expected "); at != std::string::npos) {
      expected = "; expected " + what.substr(at + 11);
      constexpr std::string_view kString = "string literal";
      if (const std::size_t found = expected.find(kString); found != std::string::npos) {
        expected.replace(found, kString.size(), "a key in \"quotation marks\"");
      }
    }
    if (const Phrase correction = correction_at(text, from, expected); !correction.empty()) {
      return refuse(from, phrase("Protocols", "unexpected %1; %2")
                              .with(printable(token_at(text, from)), correction));
    }
    if (is_of_word(text[from])) {
      return refuse(from,
                    phrase("Protocols",
                           "%1 is not JSON: write a finite number, text in quotation marks, true, "
                           "false, null, […] or {…}")
                        .with(printable(token_at(text, from))));
    }
    return refuse(from, unexpected(expected).with(printable(text.substr(from, 1))));
  }

  std::vector<Diagnostic> take_problems() { return std::move(problems_); }

 private:
  struct Open {
    nlohmann::json* node = nullptr;
    std::string pointer{};
  };

  std::size_t start() const {
    const std::string_view text = document_.text_;
    std::size_t at = last_end_;
    // A comma or colon that was read last is itself the next token: a syntax error.
    while (at < text.size() &&
           (text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r' ||
            ((text[at] == ',' || text[at] == ':') && at < read_ && at + 1 < text.size() &&
             at + 1 < read_))) {
      ++at;
    }
    return at;
  }

  bool refuse(std::size_t offset, Phrase message) {
    std::string pointer = stack_.empty() ? "" : stack_.back().pointer;
    // The first syntax error ends the reading; what was found before it is reported with it.
    problems_.push_back(document_.diagnostic(offset, pointer, std::move(message)));
    return false;
  }

  nlohmann::json* place(nlohmann::json given, std::string& pointer) {
    const std::size_t from = start();
    std::size_t key_start = from;
    nlohmann::json* node = nullptr;
    if (stack_.empty()) {
      document_.root_ = std::move(given);
      node = &document_.root_;
    } else {
      Open& parent = stack_.back();
      if (parent.node->size() >= kMaximumEntries) {
        refuse(from, phrase("Protocols", "more than %1 entries in one place; reduce their number")
                         .with(std::to_string(kMaximumEntries)));
        return nullptr;
      }
      if (parent.node->is_array()) {
        pointer = pointer_to(parent.pointer, parent.node->size());
        parent.node->push_back(std::move(given));
        node = &parent.node->back();
      } else {
        key_start = key_start_;
        pointer = pointer_to(parent.pointer, key_);
        node = &(*parent.node)[key_];
        *node = std::move(given);
      }
    }
    began_ = true;
    last_end_ = read_;
    if (node->is_number()) {  // its end is known only after reading one more character
      last_end_ = std::min(document_.text_.find_first_not_of("+-.0123456789eE", from), read_);
    }
    document_.places_[pointer] = {key_start, from, last_end_};
    return node;
  }

  bool value(nlohmann::json given) {
    std::string pointer{};
    return place(std::move(given), pointer) != nullptr;
  }

  bool open(nlohmann::json container) {
    if (stack_.size() >= kMaximumDepth) {
      return refuse(start(), phrase("Protocols", "nested deeper than %1 levels; reduce the nesting")
                                 .with(std::to_string(kMaximumDepth)));
    }
    std::string pointer{};
    nlohmann::json* node = place(std::move(container), pointer);
    if (node == nullptr) return false;
    stack_.push_back({node, std::move(pointer)});
    return true;
  }

  bool close() {
    last_end_ = read_;
    document_.places_[stack_.back().pointer].end = last_end_;
    stack_.pop_back();
    return true;
  }

  JsonDocument& document_;
  const std::size_t& read_;
  std::vector<Open> stack_{};
  std::string key_{};
  std::size_t key_start_ = 0;
  std::size_t last_end_ = 0;
  bool began_ = false;
  std::vector<Diagnostic> problems_{};
};

JsonDocument::JsonDocument(std::string_view text, std::string file,
                           std::vector<Diagnostic>* problems_of_texts)
    : text_(text), file_(std::move(file)) {
  const auto refuse = [this](Phrase message) {
    throw ProtocolError({diagnostic(0, "", std::move(message))});
  };
  if (text.size() > kMaximumBytes) {
    refuse(phrase("Protocols",
                  "larger than 4 MiB, the maximum size of a protocol; name another file"));
  }
  if (text.starts_with(kByteOrderMark)) {
    refuse(
        phrase("Protocols", "begins with a byte order mark; save the file as UTF-8 without one"));
  }
  const bool has_every_other_zero =
      text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');  // a letter in two bytes
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") || has_every_other_zero) {
    refuse(phrase("Protocols",
                  "this is not UTF-8 text (it looks like UTF-16); save the file as UTF-8"));
  }
  if (is_binary(text)) {
    refuse(phrase("Protocols",
                  "this is not a JSON text file, but a binary one, such as a picture; name a text "
                  "file in UTF-8 with a JSON object {…}"));
  }
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    throw ProtocolError({diagnostic(
        zero, "",
        phrase("Protocols", "the file contains a zero byte (U+0000); delete this character"))});
  }
  std::size_t read = 0;
  Handler handler(*this, read);
  const bool complete =
      nlohmann::json::sax_parse(CountingIterator{text.data(), &read},
                                CountingIterator{text.data() + text.size(), &read}, &handler);
  std::vector<Diagnostic> problems = handler.take_problems();
  if (!complete && problems.empty())
    problems.push_back(
        diagnostic(read, "", phrase("Protocols", "this is not JSON; write a JSON object {…}")));
  if (complete && problems_of_texts != nullptr) {
    *problems_of_texts = std::move(problems);
  } else if (!problems.empty()) {
    throw ProtocolError(std::move(problems));
  }
}

JsonDocument JsonDocument::with_root(nlohmann::json root) const {
  JsonDocument other = *this;
  other.root_ = std::move(root);
  return other;
}

Diagnostic JsonDocument::diagnostic(std::size_t offset, const std::string& pointer,
                                    Phrase message) const {
  Diagnostic result{};
  result.file = file_;
  result.pointer = pointer;
  result.message = std::move(message);
  offset = std::min(offset, text_.size());
  for (const char c : text_.substr(0, offset)) {
    if (c == '\n') {
      ++result.line;
      result.column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
      ++result.column;  // characters, not bytes
    }
  }
  return result;
}

Diagnostic JsonDocument::at(const std::string& pointer, Phrase message) const {
  std::string existing = pointer;
  auto found = places_.find(existing);
  while (found == places_.end() && !existing.empty()) {
    existing.resize(existing.rfind('/'));
    found = places_.find(existing);
  }
  const std::size_t offset = found == places_.end() ? 0 : found->second.value;
  return diagnostic(offset, pointer, std::move(message));
}

std::optional<JsonPlace> JsonDocument::place_of(const std::string& pointer) const {
  const auto found = places_.find(pointer);
  if (found == places_.end()) return {};
  return found->second;
}

Diagnostic JsonDocument::at_key(const std::string& pointer, Phrase message) const {
  const auto found = places_.find(pointer);
  if (found == places_.end()) return at(pointer, std::move(message));
  return diagnostic(found->second.key, pointer, std::move(message));
}

}  // namespace asperity
