// Divides a text into words, and compares them with lists of numbers, nouns and function words of English and German.

#include "protocols/texts/stated_numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <optional>

#include "protocols/texts/placeholders.h"

namespace asperity {

namespace {

struct Word {
  std::string lower{};
  std::size_t begin = 0;  ///< in the text
  std::size_t end = 0;
  bool follows_blank = false;  ///< nothing but blanks is between it and the word before
};

bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80U || std::isalnum(byte) != 0;
}

/// In lower case, for ASCII and Ä, Ö, Ü.
std::string lowered(std::string_view text) {
  std::string lower(text);
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const auto byte = static_cast<unsigned char>(lower[i]);
    if (byte < 0x80U) {
      lower[i] = static_cast<char>(std::tolower(byte));
    } else if (byte == 0xC3U && i + 1 < lower.size()) {
      const auto next = static_cast<unsigned char>(lower[i + 1]);
      if (next == 0x84U || next == 0x96U || next == 0x9CU) {
        lower[i + 1] = static_cast<char>(next + 0x20U);
      }
    }
  }
  return lower;
}

/// Typographic marks are no letters: “ ” „ – — … and the no-break space are blanks or marks.
std::size_t length_of_mark(std::string_view text) {
  if (text.starts_with("\xC2\xA0")) return 2;
  return text.starts_with("\xE2\x80") ? 3 : 0;
}

std::vector<Word> words_of(std::string_view text) {
  std::vector<Word> words{};
  bool only_blanks = true;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t mark = length_of_mark(text.substr(i)); mark > 0) {
      only_blanks = only_blanks && mark == 2;
      i += mark;
      continue;
    }
    if (!is_letter(text[i])) {
      only_blanks = only_blanks && std::isspace(static_cast<unsigned char>(text[i])) != 0;
      ++i;
      continue;
    }
    std::size_t end = i;
    const auto is_inside = [&](std::size_t at) {
      if (length_of_mark(text.substr(at)) > 0) return false;
      if (is_letter(text[at])) return true;
      const bool joins = text[at] == '-' || text[at] == '\'';
      return joins && at + 1 < text.size() && is_letter(text[at + 1]);
    };
    while (end < text.size() && is_inside(end)) ++end;
    words.push_back({lowered(text.substr(i, end - i)), i, end, only_blanks});
    only_blanks = true;
    i = end;
  }
  return words;
}

using List = std::span<const std::string_view>;

bool is_one_of(const std::string& word, List list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

struct Noun {
  std::string_view name{};
  List words{};
};

constexpr std::array<std::string_view, 8> kSurfacesEn{"surface", "surfaces", "texture", "textures",
                                                      "sample",  "samples",  "tool",    "tools"};
constexpr std::array<std::string_view, 2> kScalesEn{"scale", "scales"};
constexpr std::array<std::string_view, 2> kOptionsEn{"option", "options"};
constexpr std::array<std::string_view, 8> kPicturesEn{
    "picture", "pictures", "photograph", "photographs", "photo", "photos", "image", "images"};
constexpr std::array<std::string_view, 2> kQuestionsEn{"question", "questions"};
constexpr std::array<std::string_view, 2> kTrialsEn{"trial", "trials"};
constexpr std::array<std::string_view, 2> kPracticeEn{"practice trial", "practice trials"};
constexpr std::array<std::string_view, 2> kBlocksEn{"block", "blocks"};
constexpr std::array<std::string_view, 2> kBreaksEn{"break", "breaks"};
constexpr std::array<std::string_view, 2> kMinutesEn{"minute", "minutes"};

constexpr std::array<std::string_view, 9> kSurfacesDe{"oberfläche", "oberflächen", "textur",
                                                      "texturen",   "probe",       "proben",
                                                      "werkzeug",   "werkzeuge",   "werkzeugen"};
constexpr std::array<std::string_view, 2> kScalesDe{"skala", "skalen"};
constexpr std::array<std::string_view, 4> kOptionsDe{"option", "optionen", "antwortmöglichkeit",
                                                     "antwortmöglichkeiten"};
constexpr std::array<std::string_view, 8> kPicturesDe{
    "bild", "bilder", "bildern", "foto", "fotos", "fotografie", "fotografien", "photos"};
constexpr std::array<std::string_view, 2> kQuestionsDe{"frage", "fragen"};
constexpr std::array<std::string_view, 3> kTrialsDe{"durchgang", "durchgänge", "durchgängen"};
constexpr std::array<std::string_view, 3> kPracticeDe{"übungsdurchgang", "übungsdurchgänge",
                                                      "übungsdurchgängen"};
constexpr std::array<std::string_view, 3> kBlocksDe{"block", "blöcke", "blöcken"};
constexpr std::array<std::string_view, 2> kBreaksDe{"pause", "pausen"};
constexpr std::array<std::string_view, 2> kMinutesDe{"minute", "minuten"};

/// What is different in a language.
struct Language {
  std::string_view tag{};
  std::array<std::string_view, 20> numbers{};  ///< from one
  std::array<Noun, 10> nouns{};
  List no_adjectives{};  ///< function words, which no adjective is
  /// Words before a number that is no count of the design: limits, ordinals, intervals.
  List before_others{};
  List joints{};  ///< of ranges
  List
      verbs_before_one{};  ///< "feel one surface": a count; elsewhere "one" is an article or a pronoun
  List after_one{};        ///< "one surface at a time"
  List about{};
};

constexpr std::array<std::string_view, 24> kFunctionEn{
    "of", "to",   "in",  "on", "or",    "and",  "the", "a",    "an",   "for",   "with", "at",
    "by", "from", "are", "is", "times", "time", "you", "each", "your", "these", "this", "after"};
constexpr std::array<std::string_view, 22> kBeforeEn{
    "least",   "most", "than",  "first",    "last",      "next",    "every",  "each",
    "another", "more", "other", "to",       "few",       "between", "within", "after",
    "any",     "if",   "when",  "whenever", "remaining", "whether"};
constexpr std::array<std::string_view, 3> kJointsEn{"or", "to", "and"};
constexpr std::array<std::string_view, 7> kVerbsEn{"feel", "see",      "hear", "has",
                                                   "have", "contains", "get"};
constexpr std::array<std::string_view, 5> kAfterOneEn{"at", "after", "then", "of", "and"};

constexpr std::array<std::string_view, 24> kFunctionDe{
    "von", "zu",  "in",  "auf", "oder", "und",  "der", "die",  "das", "den", "dem", "des",
    "mal", "mit", "bei", "an",  "für",  "nach", "aus", "sind", "ist", "sie", "je",  "pro"};
constexpr std::array<std::string_view, 24> kBeforeDe{
    "mindestens", "höchstens", "als",   "ersten",  "letzten", "nächsten", "alle",    "allen",
    "jede",       "jeden",     "jeder", "weitere", "bis",     "noch",     "anderen", "nach",
    "binnen",     "zwischen",  "je",    "pro",     "wenn",    "falls",    "ob",      "übrigen"};
constexpr std::array<std::string_view, 3> kJointsDe{"oder", "bis", "und"};
constexpr std::array<std::string_view, 3> kVerbsDe{"fühlen", "sehen", "hören"};
constexpr std::array<std::string_view, 6> kAfterOneDe{"auf",  "nach",   "nacheinander",
                                                      "dann", "danach", "und"};

constexpr std::array<std::string_view, 4> kAboutEn{"about", "approximately", "around", "roughly"};
constexpr std::array<std::string_view, 5> kAboutDe{"etwa", "ungefähr", "rund", "circa", "ca"};
constexpr std::array<std::string_view, 11> kNegations{
    "no", "not", "never", "without", "kein", "keine", "keinen", "keiner", "nicht", "nie", "ohne"};

constexpr std::array<Language, 2> kLanguages{
    {{.tag = "en",
      .numbers = {"one",     "two",     "three",     "four",     "five",     "six",      "seven",
                  "eight",   "nine",    "ten",       "eleven",   "twelve",   "thirteen", "fourteen",
                  "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"},
      .nouns = {{{"surfaces", kSurfacesEn},
                 {"scales", kScalesEn},
                 {"options", kOptionsEn},
                 {"pictures", kPicturesEn},
                 {"questions", kQuestionsEn},
                 {"practice_trials", kPracticeEn},
                 {"trials", kTrialsEn},
                 {"blocks", kBlocksEn},
                 {"breaks", kBreaksEn},
                 {"minutes", kMinutesEn}}},
      .no_adjectives = kFunctionEn,
      .before_others = kBeforeEn,
      .joints = kJointsEn,
      .verbs_before_one = kVerbsEn,
      .after_one = kAfterOneEn,
      .about = kAboutEn},
     {.tag = "de",
      .numbers = {"eine",     "zwei",     "drei",     "vier",     "fünf",
                  "sechs",    "sieben",   "acht",     "neun",     "zehn",
                  "elf",      "zwölf",    "dreizehn", "vierzehn", "fünfzehn",
                  "sechzehn", "siebzehn", "achtzehn", "neunzehn", "zwanzig"},
      .nouns = {{{"surfaces", kSurfacesDe},
                 {"scales", kScalesDe},
                 {"options", kOptionsDe},
                 {"pictures", kPicturesDe},
                 {"questions", kQuestionsDe},
                 {"practice_trials", kPracticeDe},
                 {"trials", kTrialsDe},
                 {"blocks", kBlocksDe},
                 {"breaks", kBreaksDe},
                 {"minutes", kMinutesDe}}},
      .no_adjectives = kFunctionDe,
      .before_others = kBeforeDe,
      .joints = kJointsDe,
      .verbs_before_one = kVerbsDe,
      .after_one = kAfterOneDe,
      .about = kAboutDe}}};

const Language* find_language(std::string_view tag) {
  const auto* const found =
      std::find_if(kLanguages.begin(), kLanguages.end(),
                   [tag](const Language& each) { return is_language(tag, each.tag); });
  return found == kLanguages.end() ? nullptr : &*found;
}

/// Nothing for a word that is no number.
std::optional<int> number_of(const std::string& word, const Language& language) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc{} && end == word.data() + word.size()) return number;
  const bool is_one = language.tag == "de" && (word == "ein" || word == "einen");
  if (is_one) return 1;
  const auto* const found =
      std::find(language.numbers.begin(), language.numbers.end(), std::string_view(word));
  if (found == language.numbers.end()) return {};
  return static_cast<int>(found - language.numbers.begin()) + 1;
}

/// The noun that begins at a word, and after how many words it ends.
std::optional<std::pair<std::string_view, std::size_t>> noun_at(const std::vector<Word>& words,
                                                                std::size_t at,
                                                                const Language& language) {
  for (const Noun& noun : language.nouns) {
    if (is_one_of(words[at].lower, noun.words)) return std::pair(noun.name, at + 1);
    if (at + 1 < words.size() && words[at + 1].follows_blank &&
        is_one_of(words[at].lower + ' ' + words[at + 1].lower, noun.words)) {
      return std::pair(noun.name, at + 2);
    }
  }
  return {};
}

/// The noun that a number before word `at` counts.
std::optional<std::pair<std::string_view, std::size_t>> counted_noun(const std::vector<Word>& words,
                                                                     std::size_t at,
                                                                     const Language& language) {
  constexpr std::size_t kAdjectives = 2;
  for (std::size_t i = at; i < words.size() && i <= at + kAdjectives; ++i) {
    if (!words[i].follows_blank) return {};
    if (const auto noun = noun_at(words, i, language)) return noun;
    if (is_one_of(words[i].lower, language.no_adjectives) || number_of(words[i].lower, language)) {
      return {};
    }
  }
  return {};
}

/// Whether only a dash, a point or a comma is between a number and the one before it: "2–4", "1.5", "2,5".
bool continues_number(std::string_view text, const std::vector<Word>& words, std::size_t at,
                      const Language& language) {
  if (at == 0 || words[at].follows_blank) return false;
  if (!number_of(words[at - 1].lower, language)) return false;
  std::string between(text.substr(words[at - 1].end, words[at].begin - words[at - 1].end));
  std::erase(between, ' ');
  return between == "." || between == "," || between == "-" || between == "–" || between == "—";
}

/// The sentence that contains these characters.
std::string sentence_around(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::string_view kEnds = ".!?\n";
  const std::size_t before =
      begin == 0 ? std::string_view::npos : text.find_last_of(kEnds, begin - 1);
  const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
  return std::string(text.substr(first, text.find_first_of(kEnds, end) - first));
}

}  // namespace

std::vector<StatedNumber> numbers_stated_in(std::string_view text, std::string_view tag) {
  const Language* const language = find_language(tag);
  if (language == nullptr) return {};
  std::vector<StatedNumber> found{};
  const std::vector<Word> words = words_of(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::optional<int> number = number_of(words[i].lower, *language);
    if (!number || *number < 1) continue;
    const auto noun = counted_noun(words, i + 1, *language);
    if (!noun) continue;
    const std::string before = i > 0 && words[i].follows_blank ? words[i - 1].lower : "";
    if (is_one_of(before, language->before_others)) continue;
    const bool is_range = i > 1 && is_one_of(before, language->joints) &&
                          number_of(words[i - 2].lower, *language).has_value();
    if (is_range || continues_number(text, words, i, *language)) continue;
    if (*number == 1 && words[i].lower != "1") {
      const std::string after = noun->second < words.size() ? words[noun->second].lower : "";
      if (!is_one_of(before, language->verbs_before_one) || is_one_of(after, language->after_one)) {
        continue;
      }
    }
    const std::size_t end = words[noun->second - 1].end;
    found.push_back({.name = noun->first,
                     .number = *number,
                     .words = std::string(text.substr(words[i].begin, end - words[i].begin)),
                     .begins_clause = before.empty(),
                     .is_about = is_one_of(before, language->about),
                     .sentence = sentence_around(text, words[i].begin, end)});
  }
  return found;
}

std::string phrase_in(std::string_view text, std::span<const std::string_view> phrases) {
  const std::vector<Word> words = words_of(text);
  for (const std::string_view phrase : phrases) {
    const std::vector<Word> wanted = words_of(phrase);
    for (std::size_t i = 0; i + wanted.size() <= words.size() && !wanted.empty(); ++i) {
      bool is_same = true;
      for (std::size_t j = 0; j < wanted.size() && is_same; ++j) {
        const bool is_stem = j + 1 == wanted.size() && phrase.ends_with('*');
        is_same = is_stem ? words[i + j].lower.starts_with(wanted[j].lower)
                          : words[i + j].lower == wanted[j].lower;
      }
      const auto is_negated = [&](std::size_t before) {  // "no pictures", "not be blindfolded"
        return i >= before && is_one_of(words[i - before].lower, kNegations);
      };
      if (!is_same || is_negated(1) || is_negated(2)) continue;
      const std::size_t end = words[i + wanted.size() - 1].end;
      return std::string(text.substr(words[i].begin, end - words[i].begin));
    }
  }
  return {};
}

}  // namespace asperity
