// Every simulated rate of docs/data/coverage.tsv that the page on analyses states is that of the table, and translations state the
// same numbers as their sources.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "tests/app/drawn_rates.h"

namespace asperity {
namespace {

std::vector<std::string> documented_rates() {
  const auto with_lapses = [](double rate) {
    return span_of(drawn("comparison_thresholds", "geomean.jnd", with_effect(rate)));
  };
  const auto of_areas = [](const char* quantity, bool differ) {
    return span_of(drawn("areas_of_participants", quantity, where_participants_differ(differ)));
  };
  const auto unforced = [](const char* judgement) {
    return span_of(drawn("unforced_thresholds", "jnd", with_key(judgement)));
  };
  const auto with_d_up_to = [](double from, double to) {
    return at_least(drawn("choice_effects", "signflip.d", [from, to](const DrawnCount& count) {
      return std::abs(count.truth.value()) >= from && std::abs(count.truth.value()) <= to;
    }));
  };
  const std::string large_d = with_d_up_to(0.8, 1e9).substr(std::string("at least ").size());
  return {
      "truncated at −1 and 1; its coverage was " + span_of(drawn("groups", "subj.diff")),
      "Its coverage is " + span_of(drawn("choice_effects", "relabel.W")) +
          " with 12 and 20 participants (part `choice_effects`",
      "d_z of choices is " + with_d_up_to(0.0, 0.8) +
          " if the true d is at most 0.8, and as low as " + large_d + " if it is larger",
      "(coverage " + span_of(drawn("ratings_of_signal", "auc")) + ", part `ratings_of_signal`",
      "(`uv.az.mean`, coverage " + span_of(drawn("areas_of_participants", "uv.az.mean")) + ")",
      "(`auc.mean`, coverage " + span_of(drawn("areas_of_participants", "auc.mean")) + ")",
      "contained the common A_z in " + of_areas("uv.az", true) +
          " of the simulations in which participants had different criteria (" +
          of_areas("uv.az", false) + " where they were alike)",
      "DeLong's the common area in " + of_areas("auc", true) + " (" + of_areas("auc", false) + ")",
      "The coverage of the CI of the geometric mean was " + with_lapses(0.0) +
          " where participants never lapsed",
      "and " + with_lapses(0.02) + " with lapse rates of 2 %; that of the CI of the mean PSE was " +
          span_of(drawn("comparison_thresholds", "mean.pse")),
      "the 95 % CI of the JND of a comparison contained the true JND in " + unforced("comparison") +
          " of the tables that had one",
      "that of a judgement of performance with two alternatives in " + unforced("performance"),
      "a coverage of " +
          span_of(drawn("varying_items", "lmm.beta", where_participants_differ(true))) +
          ": part `varying_items`",
      "the coverage of other geometric means, " + span_of(drawn("response_times", "geomean")) +
          ", part `response_times`",
      "(coverage " + span_of(drawn("components", "proportion.corrected")) + ", part `components`",
      "contained the true loading in " + span_of(drawn("components", "loading.corrected")) +
          " of simulations"};
}

TEST(DocumentedRates, AreThoseOfTheSimulations) {
  const std::string page = page_in_one_line();
  for (const std::string& stated : documented_rates()) {
    EXPECT_NE(page.find(stated), std::string::npos)
        << "docs/analysis.md does not state: " << stated;
  }
}

/// The numbers of a sentence, with a decimal point.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex kNumber(R"([0-9]+([.,][0-9]+)?)");
  std::vector<std::string> numbers{};
  for (std::sregex_iterator each(text.begin(), text.end(), kNumber), end; each != end; ++each) {
    std::string number = each->str();
    std::replace(number.begin(), number.end(), ',', '.');
    numbers.push_back(std::move(number));
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

TEST(DocumentedRates, HaveTheSameNumbersInTranslation) {
  static const std::regex kLeadingPoint(R"( \.([0-9]))");
  const std::string translations =
      read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "app/gui/translations/asperity_de.ts");
  std::size_t compared = 0;
  for (std::size_t at = translations.find("<source>"); at != std::string::npos;
       at = translations.find("<source>", at + 1)) {
    const std::size_t begin = at + std::string("<source>").size();
    const std::string source =
        translations.substr(begin, translations.find("</source>", begin) - begin);
    if (source.find("imulation") == std::string::npos &&
        source.find("overage") == std::string::npos) {
      continue;
    }
    const std::size_t translated =
        translations.find("<translation>", begin) + std::string("<translation>").size();
    const std::string text = translations.substr(
        translated, translations.find("</translation>", translated) - translated);
    EXPECT_EQ(numbers_in(std::regex_replace(source, kLeadingPoint, " 0.$1")), numbers_in(text))
        << source;
    ++compared;
  }
  EXPECT_GT(compared, 10U);
}

}  // namespace
}  // namespace asperity
