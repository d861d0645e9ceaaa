// Finds the estimates of a study with which a sweep is compared. Absent without Qt, because it needs figures.

#include "app/cli/sweep/sweep_study.h"

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "app/cli/output/terminal.h"
#include "app/findings/outcome/figures_of.h"
#include "app/findings/study/analyze_study.h"
#include "app/sweep/sweep_beside.h"
#include "app/sweep/sweep_figure.h"
#include "app/words/text_parts.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/kinds/kind_list.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

/// The value of --protocol: every version of a protocol, or one of them.
struct NamedProtocol {
  std::string name{};
  std::optional<std::string> version{};
};

std::optional<NamedProtocol> named_protocol(const std::optional<std::string>& text) {
  if (!text) return {};
  const std::size_t at = text->find('@');
  if (at == std::string::npos) return NamedProtocol{*text, {}};
  return NamedProtocol{text->substr(0, at), text->substr(at + 1)};
}

bool estimates_roughness(const AnalysisOutcome& outcome) {
  return outcome.kind == magnitude_kind().id && outcome.answers > 0;
}

/// A sweep is compared with one experiment: a study with estimates by several protocols, or by several versions of one,
/// requires --protocol.
void require_one_protocol(const std::string& folder, const std::vector<AnalysisOutcome>& outcomes) {
  std::map<std::string, std::set<std::string>> versions{};
  for (const AnalysisOutcome& outcome : outcomes) {
    if (estimates_roughness(outcome)) versions[outcome.protocol].insert(outcome.version);
  }
  std::vector<std::string> choices{};
  for (const auto& [name, of_name] : versions) {
    for (const std::string& version : of_name) {
      choices.push_back(of_name.size() == 1 ? name : name + '@' + version);
    }
  }
  if (choices.size() < 2) return;
  throw std::runtime_error("the study " + folder + " has estimates of roughness from " +
                           (versions.size() > 1 ? std::to_string(versions.size()) + " protocols"
                                                : std::to_string(choices.size()) + " versions of " +
                                                      versions.begin()->first) +
                           ": name one with --protocol, " + comma_separated(choices));
}

/// The outcomes that --protocol selects.
std::vector<AnalysisOutcome> outcomes_beside(const Study& study, const SweepOptions& options) {
  const std::optional<NamedProtocol> named = named_protocol(options.protocol);
  std::vector<AnalysisOutcome> outcomes =
      analyze_study(study, named ? std::optional(named->name) : std::nullopt);
  if (named && named->version) {
    std::set<std::string> versions{};
    for (const AnalysisOutcome& outcome : outcomes) versions.insert(outcome.version);
    std::erase_if(outcomes, [&named](const AnalysisOutcome& outcome) {
      return outcome.version != *named->version;
    });
    if (outcomes.empty()) {
      throw std::runtime_error("the study " + options.beside + " has no session of " + named->name +
                               ", version " + *named->version +
                               "; name a version that it has: " + comma_separated(versions));
    }
  }
  require_one_protocol(options.beside, outcomes);
  return outcomes;
}

Protocol protocol_of(const Study& study, const AnalysisOutcome& outcome,
                     const ModelRegistry& models) {
  const ProtocolRow* found = nullptr;
  const std::vector<ProtocolRow> rows = study.protocols();
  std::size_t alike = 0;
  for (const ProtocolRow& row : rows) {
    if (row.name != outcome.protocol || row.version != outcome.version) continue;
    if (found == nullptr) found = &row;
    ++alike;
  }
  if (found == nullptr) {
    throw std::runtime_error("the study " + study.folder().string() +
                             " does not contain the protocol " + outcome.protocol + ' ' +
                             outcome.version + "; run asperity verify");
  }
  if (alike > 1) {
    say("asperity: warning: " + std::to_string(alike) + " different protocol files are named " +
        outcome.protocol + ' ' + outcome.version +
        ", and their responses are analysed together; the sweep is compared with the first file. "
        "Give a changed protocol a new version");
  }
  return read_protocol(found->source, found->name, declarations_of(models));
}

}  // namespace

StudyBeside study_beside(const SweepOptions& options, const ModelRegistry& models) {
  const Study study = Study::open(options.beside, Access::read_only);
  for (const AnalysisOutcome& outcome : outcomes_beside(study, options)) {
    for (Figure& figure : figures_of(outcome)) {
      if (figure.name != "roughness") continue;
      if (!figure.is_drawn()) throw std::runtime_error(figure.instead.english());
      const SweepBeside beside =
          sweep_beside(options.order, protocol_of(study, outcome, models), study.folder());
      require_estimates(figure, beside.conditions);
      say("estimates in the figure: " + outcome.protocol + " " + outcome.version + ", " +
          text_of(outcome.group) + ", " + counted(outcome.answers, "response"));
      for (const std::string& remark : beside.remarks) {
        say("asperity: warning: " + remark);
      }
      return {
          .estimates = std::move(figure), .conditions = beside.conditions, .group = outcome.group};
    }
  }
  throw std::runtime_error(
      "the study " + options.beside +
      " has no estimates of roughness; name another study, or leave out --beside");
}

}  // namespace asperity
