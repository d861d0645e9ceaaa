// The same bytes where the decimal point is a comma.

#include <clocale>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

std::map<std::string, std::string> journey(const SmallStudy& small, const std::string& name,
                                           const std::map<std::string, std::string>& environment) {
  // Relative names, so that nothing differs but the locale.
  const fs::path folder = small.place() / name;
  fs::create_directory(folder);
  fs::copy_file(small.selection(), folder / "selection.json");
  write_text(folder / "path.tsv",
             "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t-0.0005\n0.001\t0.0001\t0\t-0.0005\n"
             "0.002\t0.00025\t1e-5\t-0.00075\n");
  const std::vector<std::vector<std::string>> steps{
      {"new", "study"},
      {"synth", "sinusoid", "--out", "study/stimuli/walnut.png", "--pixels", "128", "--width-m",
       "0.02", "--param", "amplitude_m=0.00015", "--photo", "bright_height",
       "study/stimuli/walnut_photo.png"},
      {"texture", "study/stimuli/walnut_photo.png", "--out", "study/stimuli/slate.png", "--width-m",
       "0.02", "--preview", "study/stimuli/slate_photo.png"},
      {"check", "selection.json", "--study", "study"},
      {"simulate", "selection.json", "--study", "study", "--participants", "2", "--seed", "6"},
      {"analyze", "study"},
      {"analyze", "study", "--json"},
      {"export", "study", "--out", "tables"},
      {"verify", "study", "--replay"},
      {"models"},
      {"models", "--json"},
      {"replay", "study", "--attempt", "1", "--out", "replayed.tsv"},
      {"render", "--model", "height_map", "--stimulus", "study/stimuli/walnut.png", "--param",
       "height_scale=0.5", "--path", "path.tsv", "--out", "forces.tsv"}};
  std::map<std::string, std::string> results{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Invocation invocation{};
    invocation.arguments = steps[i];
    invocation.environment = environment;
    invocation.folder = folder;
    const Outcome outcome = run(invocation);
    EXPECT_EQ(outcome.status, 0) << steps[i].front() << ": " << outcome.err;
    // How long a simulation took is its own affair.
    if (steps[i].front() != "simulate") {
      results[std::to_string(i) + ' ' + steps[i].front()] = outcome.out;
    }
  }
  for (const char* part : {"tables", "study/stimuli", "study/recordings"}) {
    for (const auto& [file, content] : contents_of(folder / part)) {
      results[std::string(part) + '/' + file] = content;
    }
  }
  results["replayed.tsv"] = text_of(folder / "replayed.tsv");
  results["forces.tsv"] = text_of(folder / "forces.tsv");
  return results;
}

TEST(Locale, WithADecimalCommaChangesNoByte) {
  const SmallStudy small(2);
  const auto plain = journey(small, "plain", {{"LC_ALL", "C"}});
  const auto german =
      journey(small, "german", {{"LC_ALL", "de_DE.UTF-8"}, {"LOCPATH", ASPERITY_LOCALE_FOLDER}});
  for (const auto& [name, content] : plain) {
    ASSERT_TRUE(german.contains(name)) << name;
    EXPECT_TRUE(german.at(name) == content) << name << " differs";
  }
  EXPECT_EQ(german.size(), plain.size());
}

TEST(Locale, IsTheOneThatWasAskedFor) {
  // The journey above would prove nothing where the locale is not found.
  ::setenv("LOCPATH", ASPERITY_LOCALE_FOLDER, 1);
  ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
  EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace asperity::test
