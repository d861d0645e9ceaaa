// Groups findings by analysis and key: a p with its statistic, degrees of freedom and estimates.

#include "app/report/text/report_tests.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/test_methods.h"
#include "app/report/text/report_sections.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

constexpr std::string_view kHolm = ".holm";

/// The name before the part "p": "subj.t" for "subj.t.p.two", "" for "p.GG"; nothing for a quantity
/// that is not a p.
std::optional<std::string> before_p(const std::string& quantity) {
  std::string before{};
  for (const std::string& part : parts_of(quantity, '.')) {
    if (part == "p") return before;
    before += (before.empty() ? "" : ".") + part;
  }
  return std::nullopt;
}

struct KeyPart {
  std::string name{};  ///< empty in keys without names
  std::string value{};
};

/// Of "column=1 person=Other or not told" or of several names; of several, those of "exp1" and "chance=one" have no names.
std::vector<KeyPart> key_parts(const FindingKey& key) {
  std::vector<KeyPart> parts{};
  if (key.empty()) return parts;
  if (key[0].find('=') == std::string::npos) {
    for (const std::string& value : key.names()) parts.push_back({{}, value});
    return parts;
  }
  for (const std::string& word : parts_of(key.text(), ' ')) {
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) {
      parts.push_back({word.substr(0, equals), word.substr(equals + 1)});
    } else if (!parts.empty()) {
      parts.back().value += ' ' + word;  // of a value that contains blanks
    }
  }
  return parts;
}

bool is_whole(const std::string& value) {
  return value == "all" || value == "Total" || value == "POOLED";
}

/// Findings by quantity, key and the analysis that they belong to.
class FindingPlaces final {
 public:
  explicit FindingPlaces(std::span<const Finding> findings) {
    for (const Finding& finding : findings) {
      places_.emplace(std::tuple(finding.quantity, finding.key, finding.analysis), &finding);
    }
  }
  /// The finding of `quantity` next to `other`, if it has a value; otherwise null.
  const Finding* beside(const Finding& other, const std::string& quantity) const {
    const auto found = places_.find(std::tuple(quantity, other.key, other.analysis));
    return found != places_.end() && found->second->value ? found->second : nullptr;
  }

 private:
  std::map<std::tuple<std::string, FindingKey, std::string>, const Finding*> places_{};
};

std::string joined(const std::string& prefix, std::string_view name) {
  return prefix.empty() ? std::string(name) : prefix + '.' + std::string(name);
}

/// The printed symbol of a statistic; empty for other names.
std::string symbol_of(const std::string& quantity) {
  static const std::map<std::string, std::string> kSymbols{
      {"t", "t"}, {"F", "F"},      {"z", "z"},   {"Q", "Q"},   {"U", "U"},  {"W", "W"},
      {"G", "G"}, {"chisq", "χ²"}, {"lr", "LR"}, {"X2", "X²"}, {"G2", "G²"}};
  const auto found = kSymbols.find(parts_of(quantity, '.').back());
  return found == kSymbols.end() ? std::string() : found->second;
}

/// A permutation test of one participant, whose p can only be 1.
bool can_only_be_one(const Finding& p, const FindingPlaces& places) {
  const TestMethod* method = test_method(p.quantity);
  if (method == nullptr || method->smallest.empty() || p.n > 1) return false;
  const Finding* smallest = places.beside(p, std::string(method->smallest));
  constexpr double kRounding = 1e-9;  // of a sum over all permutations
  return smallest != nullptr && *smallest->value >= 1.0 - kRounding;
}

const Finding* statistic_for(const std::string& prefix, const Finding& p,
                             const FindingPlaces& places) {
  if (!symbol_of(prefix).empty()) {
    if (const Finding* itself = places.beside(p, prefix)) return itself;
  }
  for (const char* name : {"t", "F", "z", "chisq", "Q", "U", "lr", "G2", "X2"}) {
    if (const Finding* found = places.beside(p, joined(prefix, name))) return found;
  }
  return nullptr;
}

std::vector<const Finding*> degrees_for(const std::string& prefix, const Finding* statistic,
                                        const FindingPlaces& places) {
  if (statistic == nullptr) return {};
  for (const std::string& name : {statistic->quantity, prefix}) {
    if (const Finding* one = places.beside(*statistic, joined(name, "df"))) return {one};
    const Finding* first = places.beside(*statistic, joined(name, "df1"));
    const Finding* second = places.beside(*statistic, joined(name, "df2"));
    if (first != nullptr && second != nullptr) return {first, second};
  }
  return {};
}

/// All findings of the same number as `finding`, with different intervals.
std::vector<const Finding*> all_intervals_of(const Finding& finding,
                                             std::span<const Finding> findings) {
  std::vector<const Finding*> same{};
  for (const Finding& other : findings) {
    if (other.quantity == finding.quantity && other.key == finding.key &&
        other.value == finding.value) {
      same.push_back(&other);
    }
  }
  return same;
}

std::vector<const Finding*> estimates_for(const std::string& prefix, std::size_t at,
                                          std::span<const Finding> findings,
                                          const FindingPlaces& places) {
  const FindingKey& key = findings[at].key;
  if (prefix.empty()) {
    // The nearest sequence of the same estimate, in the order of the findings.
    for (std::size_t i = at; i-- > 0 && findings[i].key == key;) {
      if (!findings[i].value || !findings[i].low) continue;
      std::size_t first = i;
      while (first > 0 && findings[first - 1].key == key &&
             findings[first - 1].quantity == findings[i].quantity) {
        --first;
      }
      return all_intervals_of(findings[i], findings.subspan(first, i - first + 1));
    }
    return {};
  }
  std::vector<std::string> names{joined(prefix, "diff"), joined(prefix, "estimate"),
                                 joined(prefix, "mean")};
  if (symbol_of(prefix).empty()) names.push_back(prefix);
  for (const std::string& name : names) {
    if (const Finding* found = places.beside(findings[at], name)) return {found};
  }
  return {};
}

/// Where a whole and its parts are tested, determines which of a test's parts of the key is the
/// whole.
void find_wholes(std::vector<ReportedTest>& tests) {
  const auto kind_of = [](const Finding& p) {
    std::vector<std::string> kind{p.quantity};
    for (const KeyPart& part : key_parts(p.key)) kind.push_back(part.name);
    return kind;
  };
  // By kind of test: the positions of its key that are "all" in some of the tests.
  std::map<std::vector<std::string>, std::set<std::size_t>> places{};
  for (const ReportedTest& test : tests) {
    const std::vector<KeyPart> parts = key_parts(test.p->key);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (is_whole(parts[i].value)) places[kind_of(*test.p)].insert(i);
    }
  }
  for (ReportedTest& test : tests) {
    const std::vector<KeyPart> parts = key_parts(test.p->key);
    for (const std::size_t place : places[kind_of(*test.p)]) {
      if (!is_whole(parts[place].value)) test.is_of_whole = false;
    }
  }
}

/// The text for a part of a key.
std::string word_of_factor(const std::string& name) {
  if (name == "column") return "repetition";
  return name == "person" ? "participant" : name;
}

/// For running text: two decimals, or as many as a small number requires.
std::string said_number(double value) {
  const double size = std::abs(value);
  if (size >= 0.095 && size < 1000.0) return display_signed(value, 2);
  return size >= 0.0095 && size < 0.095 ? display_signed(value, 3) : display_number(value);
}

/// "0.0005" for the level "5e-04"; a text that is not a number is unchanged.
std::string without_power(const std::string& level) {
  if (level.find('e') == std::string::npos) return level;
  double value = 0.0;
  const char* const end = level.data() + level.size();
  const auto read = std::from_chars(level.data(), end, value);
  return read.ec == std::errc() && read.ptr == end ? display_number(value) : level;
}

/// The text for the program's name of an effect or a coefficient.
std::string words_of_value(const std::string& value) {
  static const std::map<std::string, std::string> kWords{
      {"condition:spacing", "spacing by condition"},
      {"ICC1", "ICC(1,1)"},
      {"ICC1k", "ICC(1,k)"},
      {"ICC2", "ICC(2,1)"},
      {"ICC2k", "ICC(2,k)"},
      {"ICC3", "ICC(3,1)"},
      {"ICC3k", "ICC(3,k)"},
      {"Other or not told", "Other or not reported"}};
  const auto known = kWords.find(value);
  return known == kWords.end() ? value : known->second;
}

std::string printed_interval(const Finding& finding) {
  const double confidence = finding.confidence.value_or(0.95);
  return display_percent(confidence) + " CI [" + said_number(*finding.low) + ", " +
         said_number(*finding.high) + ']';
}

}  // namespace

std::vector<ReportedTest> tests_among(std::span<const Finding> findings) {
  const FindingPlaces places(findings);
  std::vector<ReportedTest> tests{};
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& finding = findings[i];
    const std::optional<std::string> prefix = before_p(finding.quantity);
    if (!prefix || !finding.value || finding.quantity.ends_with(kHolm)) continue;
    if (can_only_be_one(finding, places)) continue;
    ReportedTest& test = tests.emplace_back();
    test.p = &finding;
    test.statistic = statistic_for(*prefix, finding, places);
    test.degrees = degrees_for(*prefix, test.statistic, places);
    if (!test.degrees.empty() && *test.degrees.front()->value == 0.0) {  // tests no hypothesis
      tests.pop_back();
      continue;
    }
    test.estimates = estimates_for(*prefix, i, findings, places);
    test.holm = places.beside(finding, finding.quantity + std::string(kHolm));
  }
  find_wholes(tests);
  return tests;
}

std::string statistic_of(const ReportedTest& test) {
  if (test.statistic == nullptr) return {};
  const std::string symbol = symbol_of(test.statistic->quantity);
  std::string text = symbol.empty() ? words_of_quantity(test.statistic->quantity) : symbol;
  for (std::size_t i = 0; i < test.degrees.size(); ++i) {
    const double degrees = *test.degrees[i]->value;
    text += (i == 0 ? "(" : ", ") +
            (degrees == std::round(degrees) ? fixed(degrees, 0) : fixed(degrees, 1));
  }
  if (!test.degrees.empty()) text += ')';
  return text + " = " + display_signed(*test.statistic->value, 2);
}

std::string sentence_of(const ReportedTest& test) {
  const std::string about = words_of_key(test.p->key);
  std::string text = about.empty() ? "" : "for " + about + ", ";
  if (!test.estimates.empty()) {
    const Finding& estimate = *test.estimates.front();
    text += words_of_quantity(estimate.quantity) + " was " + said_number(*estimate.value);
    if (!estimate.unit.empty() && estimate.unit != "1") text += ' ' + estimate.unit;
    if (estimate.low && estimate.high) text += " (" + printed_interval(estimate) + ')';
    text += "; ";
  }
  std::string method =
      test.p->method.empty() ? words_of_quantity(test.p->quantity) : test.p->method;
  if (!test.estimates.empty()) {
    // A method may contain the program's name of the estimate.
    const std::string& name = test.estimates.front()->quantity;
    const std::size_t at = method.find(name);
    if (at != std::string::npos) method.replace(at, name.size(), words_of_quantity(name));
  }
  text += method + ": ";
  const std::string statistic = statistic_of(test);
  if (!statistic.empty()) text += statistic + ", ";
  text += display_p(*test.p->value);
  if (test.holm != nullptr) text += ", Holm-corrected " + display_p(*test.holm->value);
  return capitalised(text) + " (n = " + display_count(test.p->n) + ").";
}

std::string words_of_key(const FindingKey& key) {
  std::string names{};
  std::string wholes{};
  for (const KeyPart& part : key_parts(key)) {
    const auto add = [](std::string& to, const std::string& word) {
      to += (to.empty() ? "" : ", ") + word;
    };
    const bool is_number =
        !part.value.empty() && part.value.find_first_not_of("0123456789.e-") == std::string::npos;
    const std::string name = word_of_factor(part.name);
    const std::string value = is_number ? without_power(part.value) : words_of_value(part.value);
    if (!name.empty() && is_whole(part.value)) {
      add(wholes, "all " + name + (name.ends_with('s') ? "" : "s"));
    } else if (is_whole(part.value)) {
      add(wholes, part.value == "POOLED" ? "pooled" : part.value);
    } else if (!name.empty() && (is_number || name == "against")) {
      add(names, name + ' ' + value);
    } else {
      add(names, value);
    }
  }
  if (names.empty()) return wholes;
  return wholes.empty() ? names : names + " (" + wholes + ')';
}

std::string words_of_quantity(const std::string& quantity) {
  static const std::map<std::string, std::string> kNamed{
      {"geomean", "geometric mean"},
      {"mauchly.W", "Mauchly’s test of sphericity"},
      {"peak.fieller", "Fieller’s CI of the peak"},
      {"subj.sd", "SD of the participants’ proportions"},
      {"subj.t", "t over participants"}};
  if (const auto named = kNamed.find(quantity); named != kNamed.end()) return named->second;
  constexpr std::string_view kShare = "share";
  std::string words = quantity;
  if (words.starts_with(kShare)) words.replace(0, kShare.size(), "proportion");
  std::replace(words.begin(), words.end(), '_', ' ');
  std::replace(words.begin(), words.end(), '.', ' ');
  for (const auto& [unit, shown] : {std::pair(" N", " (N)"), std::pair(" s", " (s)"),
                                    std::pair(" m per s", " (m/s)"), std::pair(" m", " (m)")}) {
    const std::string_view ending = unit;
    if (words.size() > ending.size() && words.ends_with(ending)) {
      words.replace(words.size() - ending.size(), ending.size(), shown);
      break;
    }
  }
  return words;
}

}  // namespace asperity
