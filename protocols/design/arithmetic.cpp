// Parses a formula by recursive descent, and evaluates it with a function of names.

#include "protocols/design/arithmetic.h"

#include <algorithm>
#include <charconv>

#include "protocols/design/wording.h"

namespace asperity {

namespace {

bool is_name_start(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c) || c == '_'; }

}  // namespace

/// Recursive descent: sum = product {(+|-) product}; product = factor {(*|/) factor}; factor = - factor | number | name |
/// ( sum ).
class ArithmeticParser {
 public:
  explicit ArithmeticParser(std::string_view text) : text_(text) {}

  std::variant<Arithmetic, ArithmeticProblem> parse() {
    sum(0);
    skip_spaces();
    if (problem_.empty() && at_ < text_.size()) {
      fail(phrase("Protocols", "%1 is not expected").with(in_quotes(text_.substr(at_, 1))));
    }
    if (!problem_.empty()) return ArithmeticProblem{problem_};
    return std::move(made_);
  }

 private:
  static constexpr int kDeepest = 32;

  void fail(const Phrase& why) {
    if (!problem_.empty()) return;
    problem_ = phrase("Protocols", "%1 at character %2").with(why, std::to_string(at_ + 1));
  }
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  char next() {
    skip_spaces();
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  void sum(int depth) {
    product(depth);
    for (char sign = next(); problem_.empty() && (sign == '+' || sign == '-'); sign = next()) {
      ++at_;
      product(depth);
      made_.tokens_.emplace_back(sign);
    }
  }

  void product(int depth) {
    factor(depth);
    for (char sign = next(); problem_.empty() && (sign == '*' || sign == '/'); sign = next()) {
      ++at_;
      factor(depth);
      made_.tokens_.emplace_back(sign);
    }
  }

  void factor(int depth) {
    if (!problem_.empty()) return;
    if (depth > kDeepest)
      return fail(phrase("Protocols", "the formula has too many levels of parentheses"));
    const char first = next();
    if (first == '-') {
      ++at_;
      factor(depth + 1);
      made_.tokens_.emplace_back('n');
    } else if (first == '(') {
      ++at_;
      sum(depth + 1);
      if (!problem_.empty()) return;
      if (next() != ')') return fail(phrase("Protocols", "a \")\" is missing"));
      ++at_;
    } else if (is_digit(first)) {
      number();
    } else if (is_name_start(first)) {
      name();
    } else {
      fail(phrase("Protocols", "a number, a factor or \"(\" is missing"));
    }
  }

  void number() {
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) return fail(phrase("Protocols", "the number cannot be read"));
    at_ = static_cast<std::size_t>(end - text_.data());
    made_.tokens_.emplace_back(value);
  }

  void name() {
    std::size_t end = at_;
    while (end < text_.size() && is_name_part(text_[end])) ++end;
    const std::string name(text_.substr(at_, end - at_));
    at_ = end;
    const auto found = std::find(made_.names_.begin(), made_.names_.end(), name);
    const auto index = static_cast<std::size_t>(found - made_.names_.begin());
    if (found == made_.names_.end()) made_.names_.push_back(name);
    made_.tokens_.emplace_back(index);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Arithmetic made_{};
  Phrase problem_{};
};

std::variant<Arithmetic, ArithmeticProblem> Arithmetic::parse(std::string_view text) {
  return ArithmeticParser(text).parse();
}

double Arithmetic::value(const std::function<double(const std::string& name)>& of_name) const {
  std::vector<double> stack{};
  for (const Token& token : tokens_) {
    if (const auto* const number = std::get_if<double>(&token)) {
      stack.push_back(*number);
      continue;
    }
    if (const auto* const name = std::get_if<std::size_t>(&token)) {
      stack.push_back(of_name(names_[*name]));
      continue;
    }
    const char sign = std::get<char>(token);
    if (sign == 'n') {
      stack.back() = -stack.back();
      continue;
    }
    const double right = stack.back();
    stack.pop_back();
    double& left = stack.back();
    switch (sign) {
      case '+':
        left += right;
        break;
      case '-':
        left -= right;
        break;
      case '*':
        left *= right;
        break;
      default:
        left /= right;
        break;
    }
  }
  return stack.back();
}

}  // namespace asperity
