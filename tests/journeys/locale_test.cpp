// The same bytes whatever the locale: a decimal comma, another capital of i, digits of another script, other dates.

#include <clocale>
#include <cstddef>
#include <cstdlib>
#include <list>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

/// The commands of the journey, in a folder with the files that they name.
std::vector<std::vector<std::string>> steps_of_journey() {
  return {
      {"new", "study"},
      {"synth", "sinusoid", "--out", "study/stimuli/walnut.png", "--pixels", "128", "--width-m",
       "0.02", "--param", "amplitude_m=0.00015", "--photo", "bright_height",
       "study/stimuli/walnut_photo.png"},
      {"texture", "study/stimuli/walnut_photo.png", "--out", "study/stimuli/slate.png", "--width-m",
       "0.02", "--preview", "study/stimuli/slate_photo.png"},
      {"synth", "sinusoid", "--out", "study/stimuli/unused.png", "--width-m", "0.02"},
      {"stimulus", "study/stimuli/unused.png", "--rename", "spare"},
      {"check", "selection.json", "--study", "study"},
      {"check", "selection.json", "--study", "study", "--device", "simulated:falcon"},
      {"simulate", "selection.json", "--study", "study", "--participants", "2", "--seed", "6"},
      {"simulate", "selection.json", "--study", "study", "--participants", "2", "--seed", "6",
       "--resume"},
      {"analyze", "study"},
      {"analyze", "study", "--json"},
      {"export", "study", "--out", "tables"},
      {"verify", "study", "--replay"},
      {"models"},
      {"models", "--json"},
      {"replay", "study", "--attempt", "1", "--out", "replayed.tsv"},
      {"replay", "study", "--compare", "--model", "sinusoid", "--param", "amplitude_m=0.00025",
       "--out", "made/compared.tsv"},
      {"render", "--model", "height_map", "--stimulus", "study/stimuli/walnut.png", "--param",
       "height_scale=0.5", "--path", "path.tsv", "--out", "forces.tsv"},
      {"analyze", "--table", "shares.csv", "--as", "proportion"},
      {"texture-recording", "--relief", "study/stimuli/walnut.png", "--out", "made/strokes.tsv"},
      {"fit-model", "made/strokes.tsv", "--out", "made/vibrations.tsv"},
      {"bake", "solid.obj", "--triangles", "4", "--out", "made/solid.mesh"},
      {"sweep", "--model", "height_map", "--vary", "exploratory_speed", "--values", "0.05,0.1",
       "--spacings", "0.001:0.004:3", "--out", "made/sweep"},
      {"sweep", "--model", "height_map", "--vary", "exploratory_speed", "--values", "0.05,0.1",
       "--spacings", "0.001:0.004:3", "--shard", "1/2", "--out", "made/divided"},
      {"sweep", "--model", "height_map", "--vary", "exploratory_speed", "--values", "0.05,0.1",
       "--spacings", "0.001:0.004:3", "--shard", "2/2", "--out", "made/divided"},
      {"gather", "made/divided.shard-1-of-2", "made/divided.shard-2-of-2", "--out",
       "made/gathered"},
      {"submit", "made/submission", "--slurm", "--shards", "2", "--write-only", "--time",
       "00:10:00", "--", "sweep", "--model", "height_map", "--vary", "exploratory_speed",
       "--values", "0.05,0.1", "--out", "made/submitted"},
      {"power", fs::path(ASPERITY_SOURCE_DIR) / "protocols/library/amplitude_jnd.json",
       "--list-assumptions"},
      {"power", fs::path(ASPERITY_SOURCE_DIR) / "protocols/library/amplitude_jnd.json",
       "--participants", "4", "--seed", "3", "--runs", "4", "--effect", "order=0.5", "--assume",
       "order_sd=0.3", "--out", "made/power"},
      {"clean-stiffness", "--model", "height_map", "--amplitudes", "0.0001", "--wavelengths",
       "0.002", "--rates", "1000", "--strokes", "1", "--out", "made/clean.tsv"},
      {"devices"},
      {"bench", "--list"},
      {"metadata", "study", "--author", "I\u015f\u0131k, \u0130lk", "--license", "CC-BY-4.0"},
#ifdef ASPERITY_WITH_WINDOWS
      {"render", "--model", "height_map", "--stimulus", "study/stimuli/walnut.png", "--path",
       "path.tsv", "--out", "made/forces.tsv", "--tool-out", "made/tool.tsv", "--plot",
       "made/plot.svg"},
      {"analyze", "--table", "levels.csv", "--as", "psyfit", "--option", "shape=logistic",
       "gamma=0", "lambda=0.02", "pt=0.5", "bootstrap=20", "--figures", "made/figures"},
      {"report", "study", "--out", "made/report.html"},
#endif
      {"run", "selection.json", "--study", "study", "--participant", "iris", "--virtual", "--seed",
       "9"},
      {"copy", "study", "copied"},
      {"merge", "study", "--out", "merged"},
      {"withdraw", "study", "iris", "--by", "me"},
      {"withdraw", "study", "virtual0002", "--delete", "--confirm", "virtual0002", "--by", "me"},
      {"export", "study", "--out", "tables_after"}};
}

std::map<std::string, std::string> journey(const SmallStudy& small,
                                           const std::map<std::string, std::string>& environment) {
  // Always the same folder, so that nothing differs but the locale.
  const fs::path folder = small.place() / "journey";
  fs::create_directory(folder);
  fs::copy_file(small.selection(), folder / "selection.json");
  write_text(folder / "path.tsv",
             "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t-0.0005\n0.001\t0.0001\t0\t-0.0005\n"
             "0.002\t0.00025\t1e-5\t-0.00075\n");
  write_text(folder / "solid.obj",
             "v 0 0 0\nv 10.5 0 0\nv 0 10.5 0\nv 0 0 10.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  write_text(folder / "shares.csv", "id,k,n,p0\na,5,10,0.5\nb,9,12,0.25\n");
  write_text(folder / "levels.csv",
             "condition,x,n,k\na,0.1,20,3\na,0.25,20,9\na,0.5,20,16\na,0.75,20,19\n");
  fs::create_directory(folder / "made");
  const std::vector<std::vector<std::string>> steps = steps_of_journey();
  std::map<std::string, std::string> results{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Invocation invocation{};
    invocation.arguments = steps[i];
    invocation.environment = environment;
    invocation.folder = folder;
    const Outcome outcome = run(invocation);
    EXPECT_EQ(outcome.status, 0) << steps[i].front() << ": " << outcome.err;
    // How long a simulation took is its own affair, and so is the day of a withdrawal.
    if (steps[i].front() != "simulate" && steps[i].front() != "withdraw") {
      results[std::to_string(i) + ' ' + steps[i].front()] = outcome.out;
    }
  }
  for (const char* part : {"tables", "made", "study/stimuli", "study/recordings"}) {
    for (const auto& [file, content] : contents_of(folder / part)) {
      results[std::string(part) + '/' + file] = content;
    }
  }
  results["replayed.tsv"] = text_of(folder / "replayed.tsv");
  results["forces.tsv"] = text_of(folder / "forces.tsv");
  fs::remove_all(folder);
  return results;
}

constexpr const char* kLocales[] = {"de_DE.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8", "ja_JP.UTF-8"};

TEST(Locale, ChangesNoByte) {
  const SmallStudy small(2);
  const auto plain = journey(small, {{"LC_ALL", "C"}});
  for (const std::string locale : kLocales) {
    SCOPED_TRACE(locale);
    const auto other = journey(small, {{"LC_ALL", locale}, {"LOCPATH", ASPERITY_LOCALE_FOLDER}});
    for (const auto& [name, content] : plain) {
      ASSERT_TRUE(other.contains(name)) << name;
      EXPECT_TRUE(other.at(name) == content) << name << " differs";
    }
    EXPECT_EQ(other.size(), plain.size());
  }
}

// device-test measures: the last test of this file is about its decimal point.
TEST(Locale, IsTriedWithEveryCommandOfHelp) {
  std::set<std::string> tried{"device-test"};
  for (const std::vector<std::string>& step : steps_of_journey()) tried.insert(step.front());
  const std::string help = asperity({"--help"}).out;
  const std::size_t list = help.find("Subcommands:");
  ASSERT_NE(list, std::string::npos);
  const std::regex command("\n  ([a-z-]+) ");
  std::size_t commands = 0;
  for (std::sregex_iterator
           each(help.begin() + static_cast<std::ptrdiff_t>(list), help.end(), command),
       end;
       each != end; ++each) {
    EXPECT_TRUE(tried.contains((*each)[1])) << (*each)[1];
    ++commands;
  }
  EXPECT_GT(commands, 20U);
}

// Errors state numbers as well. close-device is in no list of commands, and the program starts it where a device is left.
TEST(Locale, ChangesNoWordOfAnError) {
  const TemporaryFolder folder;
  write_text(folder / "table.csv", "id,k,n,p0\na,5,10,1.5\n");
  const std::vector<std::vector<std::string>> mistakes{
      {"close-device", "falcon:NONE", "--within", "1", "--claim"},  // the name of the claim follows
      {"analyze", "--table", "table.csv", "--as", "proportion"},
      {"render", "--model", "sinusoid", "--param", "amplitude_m=-0.00025", "--path", "path.tsv",
       "--out", "forces.tsv"},
      {"texture", "photo.png", "--width-m", "0,02", "--out", "relief.png"}};
  std::vector<std::map<std::string, std::string>> environments{{{"LC_ALL", "C"}}};
  for (const char* const locale : kLocales) {
    environments.push_back({{"LC_ALL", locale}, {"LOCPATH", ASPERITY_LOCALE_FOLDER}});
  }
  for (const std::vector<std::string>& mistake : mistakes) {
    SCOPED_TRACE(mistake.front());
    std::list<Program> programs{};  // side by side: the device is waited for
    for (const auto& environment : environments) {
      Invocation invocation{};
      invocation.arguments = mistake;
      if (mistake.front() == "close-device") {
        invocation.arguments.push_back("locale_test_" + environment.at("LC_ALL"));
      }
      invocation.environment = environment;
      invocation.folder = folder.path();
      programs.emplace_back(invocation);
    }
    std::vector<Outcome> outcomes{};
    for (Program& program : programs) outcomes.push_back(program.finish());
    EXPECT_NE(outcomes.front().status, 0);
    EXPECT_NE(outcomes.front().err, "");
    for (const Outcome& outcome : outcomes) {
      EXPECT_EQ(outcome.status, outcomes.front().status);
      EXPECT_EQ(outcome.err, outcomes.front().err);
    }
  }
}

// What is measured differs each time, but not its decimal point.
TEST(Locale, ChangesNoDecimalPointOfAMeasurement) {
  const std::map<std::string, std::string> german{{"LC_ALL", "de_DE.UTF-8"},
                                                  {"LOCPATH", ASPERITY_LOCALE_FOLDER}};
  Invocation device_test{};
  device_test.arguments = {"device-test", "simulated"};
  device_test.environment = german;
  Program device(device_test);
  Invocation bench{};
  bench.arguments = {"bench", "--scene", "plane", "--ticks", "20", "--seconds", "1"};
  bench.environment = german;
  const Outcome times = run(bench);
  const Outcome profile = device.finish();
  EXPECT_EQ(times.status, 0) << times.err;
  EXPECT_EQ(profile.status, 0) << profile.err;
  EXPECT_THAT(times.out, HasSubstr("Quoted p50 0.76 \u00b5s, p99 0.91 \u00b5s"));
  EXPECT_THAT(profile.out, HasSubstr("When 5.0 N was requested at a limit of 0.5 N, at most 0.500 "
                                     "N was sent."));
  for (const std::string& out : {times.out, profile.out}) {
    EXPECT_FALSE(std::regex_search(out, std::regex("[0-9],[0-9]"))) << out;
  }
}

TEST(Locale, IsTheOneThatWasAskedFor) {
  // The tests above would prove nothing where a locale is not found.
  ::setenv("LOCPATH", ASPERITY_LOCALE_FOLDER, 1);
  for (const char* const locale : kLocales)
    EXPECT_NE(std::setlocale(LC_ALL, locale), nullptr) << locale;
  ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
  EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace asperity::test
