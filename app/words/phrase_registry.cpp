// The phrases that have a code.

#include "app/words/phrase_registry.h"

#include <string_view>
#include <vector>

#include "app/words/device_remarks.h"
#include "app/words/offered_reasons.h"
#include "app/words/reason.h"
#include "results_schema/stored_words.h"

namespace asperity {

namespace {

constexpr const char* kCommaList = "comma_list";

const Phrase& semicolon_list() {
  static const Phrase kList = Phrase("%1; %2").coded(kListCode.data());
  return kList;
}

const Phrase& comma_list() {
  static const Phrase kList = Phrase("%1, %2").coded(kCommaList);
  return kList;
}

}  // namespace

const std::map<std::string, Phrase, std::less<>>& coded_phrases() {
  static const auto kAll = [] {
    std::map<std::string, Phrase, std::less<>> all{};
    for (const std::vector<Phrase>& some : {coded_reasons(), coded_remarks(), coded_offers(),
                                            std::vector<Phrase>{semicolon_list(), comma_list()}}) {
      for (const Phrase& one : some) all.emplace(one.code(), one);
    }
    return all;
  }();
  return kAll;
}

Phrase with_semicolon(const Phrase& first, const Phrase& second) {
  return with_next(semicolon_list(), first, second);
}

Phrase with_comma(const Phrase& first, const Phrase& second) {
  return with_next(comma_list(), first, second);
}

bool is_phrase_list(const Phrase& phrase) {
  return phrase.code() != nullptr &&
         (phrase.code() == kListCode || std::string_view(phrase.code()) == kCommaList);
}

Phrase with_next(const Phrase& list, const Phrase& first, const Phrase& second) {
  return first.empty() ? second : list.with(first, second);
}

}  // namespace asperity
