// asperity metadata: who a study is by, under which license, who approved it, and which places of a whole study it has.

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/metadata_options.h"
#include "app/cli/options/text_option.h"
#include "app/cli/output/terminal.h"
#include "app/study_files/dealt_places.h"
#include "app/study_files/study_metadata.h"
#include "app/words/text_parts.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

std::optional<std::string> stated(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string shown(const std::optional<std::string>& text) { return text.value_or("not stated"); }

/// Refuses a text that is not a range of places.
CLI::Validator names_places() {
  const auto read = [](std::string& text) -> std::string {
    if (place_range_in(text)) return {};
    return '"' + text +
           "\" is not permitted; write FROM-TO, such as 13-24, with numbers from 1 to " +
           std::to_string(kMostPlaces);
  };
  return {read, "FROM-TO"};
}

/// As in the option --deal.
std::vector<std::string> places_of(const Study& study) {
  std::vector<std::string> places{};
  for (const PlaceRange& range : dealt_places(study.folder())) places.push_back(text_of(range));
  return places;
}

void print(const Study& study, bool as_json) {
  const StudyMetadata metadata = study.metadata();
  const std::vector<std::string> places = places_of(study);
  if (as_json) {
    nlohmann::ordered_json json{{"format", "asperity.metadata/1"}, {"name", study.name()},
                                {"authors", metadata.authors},     {"license", nullptr},
                                {"ethics_approval", nullptr},      {"dealt_places", places}};
    if (metadata.license) json["license"] = *metadata.license;
    if (metadata.ethics_approval) json["ethics_approval"] = *metadata.ethics_approval;
    std::cout << json.dump(2) << '\n';
    return;
  }
  std::string authors{};
  for (const std::string& author : metadata.authors) {
    authors += (authors.empty() ? "" : "; ") + author;
  }
  std::cout << "name             " << study.name() << "\nauthors          "
            << (authors.empty() ? "not stated" : authors) << "\nlicense          "
            << shown(metadata.license) << "\nethics approval  " << shown(metadata.ethics_approval)
            << '\n';
  if (!places.empty()) std::cout << "dealt places     " << comma_separated(places) << '\n';
}

}  // namespace

StudyMetadata MetadataOptions::applied_to(StudyMetadata metadata) const {
  if (!authors.empty()) {
    metadata.authors = authors;
    std::erase(metadata.authors, "");
  }
  if (license) metadata.license = stated(*license);
  if (ethics) metadata.ethics_approval = stated(*ethics);
  return metadata;
}

void add_metadata_options(CLI::App& command, MetadataOptions& options, EmptyText empty) {
  const auto words = [empty](const std::string& what) {
    return empty == EmptyText::takes_away ? empty_or_not_blank(what) : not_blank(what);
  };
  command
      .add_option("--author", options.authors,
                  "An author, \"Family, Given\"; repeat the option for each author, in order")
      ->transform(words("an author"));
  command.add_option("--license", options.license, "Licence of the data, such as CC-BY-4.0")
      ->transform(words("a licence"));
  command
      .add_option("--ethics", options.ethics,
                  "Ethics approval: committee and number of the approval")
      ->transform(words("an ethics approval"));
}

void add_metadata(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    MetadataOptions metadata{};
    std::optional<std::string> deal{};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "metadata",
      "Show or change the authors, the licence and the ethics approval of a study, and the places "
      "that a station has.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  add_metadata_options(*command, options->metadata, EmptyText::takes_away);
  command
      ->add_option("--deal", options->deal,
                   "Deal these places of the whole study to this one, the study of a station: new "
                   "participants get the groups and the rows of the counterbalancing of these "
                   "places. Repeated later, the option deals further places")
      ->check(names_places())
      ->option_text("FROM-TO");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback([options, &job] {
    job = [options] {
      const bool changes = options->metadata.is_any() || options->deal;
      Study study = Study::open(options->study, changes ? Access::read_write : Access::read_only);
      if (options->deal) deal_places(study, *place_range_in(*options->deal));
      if (options->metadata.is_any()) {
        study.set_metadata(options->metadata.applied_to(study.metadata()));
      }
      print(study, options->json);
      return 0;
    };
  });
}

}  // namespace asperity
