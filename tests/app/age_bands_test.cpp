// Ages that an export states as bands: enough participants share each.

#include "app/exports/age_bands.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/exported_study.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<ParticipantRow> participants_aged(const std::vector<double>& ages_years,
                                              bool is_virtual = false) {
  std::vector<ParticipantRow> rows{};
  for (const double age_years : ages_years) {
    ParticipantRow& row = rows.emplace_back();
    row.age_years = age_years;
    row.is_virtual = is_virtual;
  }
  return rows;
}

std::optional<std::string> band_at(const AgeBands& bands, double age_years) {
  return bands.of(participants_aged({age_years}).front());
}

TEST(AgeBands, AreFiveYearsWideWhereFiveParticipantsAreInThem) {
  const AgeBands bands(participants_aged({20, 21, 22, 23, 24.9, 25, 25, 26, 27, 29}));
  EXPECT_THAT(bands.names(), ElementsAre("20 to 24", "25 to 29"));
  EXPECT_EQ(band_at(bands, 24.9), "20 to 24");
  EXPECT_EQ(band_at(bands, 25.0), "25 to 29");
}

// 20 to 24 has four: with the one of 31 it is full. The two of 60 and more are too few for a band of theirs.
TEST(AgeBands, AreMergedUntilEachHasFiveParticipants) {
  const AgeBands bands(participants_aged({20, 21, 22, 23, 31, 35, 36, 37, 38, 39, 60, 71}));
  EXPECT_THAT(bands.names(), ElementsAre("20 to 34", "35 and older"));
  EXPECT_EQ(band_at(bands, 31.0), "20 to 34");
  EXPECT_EQ(band_at(bands, 71.0), "35 and older");
  EXPECT_EQ(band_at(bands, 19.9), std::nullopt);
}

TEST(AgeBands, AreNoneForFewerThanFiveParticipants) {
  std::vector<ParticipantRow> participants = participants_aged({20, 21, 22, 23});
  participants.emplace_back();  // without an age
  const AgeBands bands(participants);
  EXPECT_THAT(bands.names(), IsEmpty());
  EXPECT_EQ(band_at(bands, 20.0), std::nullopt);
  EXPECT_EQ(bands.of({}), std::nullopt);
}

TEST(AgeBands, AreNotFilledWithVirtualParticipants) {
  std::vector<ParticipantRow> participants = participants_aged({20, 21, 22, 23});
  for (const ParticipantRow& row : participants_aged({20, 20, 20, 20, 20}, true)) {
    participants.push_back(row);
  }
  const AgeBands bands(participants);
  EXPECT_EQ(bands.of(participants.front()), std::nullopt);
  EXPECT_EQ(bands.of(participants.back()), "20 to 24");
}

/// Nine with a session, one without; no other number of the study has these digits.
void fill_with_ages(MadeUpStudy& made) {
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kExportedProtocol);
  int number = 0;
  for (const int age_years : {20, 21, 22, 23, 40, 41, 42, 43, 44, 24}) {
    const std::string label = "p" + std::to_string(number++);
    made.study().add_participant({.label = label, .age_years = age_years + 0.40625});
    if (number < 10) made.add_session(label, protocol, {some_trial()});
  }
}

TEST(ExportedAges, AreBandsInEveryFileWhereTheyAreAskedFor) {
  MadeUpStudy made;
  fill_with_ages(made);
  ExportOptions options = options_of(ExportAudience::published);
  export_to(made, made.beside("exact"), options);
  options.has_age_bands = true;
  export_to(made, made.beside("bands"), options);
  const auto files_with_ages = [](const std::filesystem::path& out) {
    std::vector<std::string> names{};
    for (const std::string& name : files_in(out)) {
      if (read_file(out / name).find(".40625") != std::string::npos) names.push_back(name);
    }
    return names;
  };
  EXPECT_THAT(files_with_ages(made.beside("exact")),
              ElementsAre("bids/participants.tsv", "participants.tsv", "wide.csv"));
  EXPECT_THAT(files_with_ages(made.beside("bands")), IsEmpty());
  // Four participants with data are below 25: the one without data does not make them five.
  const Table participants = table_in(made.beside("bands"), "participants.tsv");
  EXPECT_THAT(participants.columns, Not(Contains("age_years")));
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(cell_of(participants, i, "age_band"), Cell{"20 to 44"});
  }
  EXPECT_EQ(cell_of(table_in(made.beside("bands"), "bids/participants.tsv"), 0, "age_band"),
            Cell{"20 to 44"});
  const Table codebook = table_in(made.beside("bands"), "codebook.tsv");
  EXPECT_THAT(columns_in_codebook(codebook),
              Contains(std::pair(std::string("wide.csv"), std::string("age_band"))));
}

TEST(ExportedAges, AreExactInAnExportOfTheLaboratory) {
  MadeUpStudy made;
  fill_with_ages(made);
  ExportOptions options{};
  options.has_age_bands = true;
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { export_to(made, made.beside("out"), options); }),
      HasSubstr("has_age_bands"));
}

}  // namespace
}  // namespace asperity
