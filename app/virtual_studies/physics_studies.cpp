// Simulates the largest study in a temporary folder, and analyses its first participants.

#include "app/virtual_studies/physics_studies.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "app/findings/gathering/gathered_answers.h"
#include "app/session/levels/external_program.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/session/session_setup.h"
#include "app/tasks/simulation/simulation_declaration.h"
#include "protocols/file/protocol_reader.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

void refuse_external_levels(const Protocol& protocol) {
  const std::vector<std::string> blocks = blocks_of_external_program(protocol);
  if (blocks.empty()) return;
  throw std::runtime_error("an external program states the levels of the block \"" +
                           blocks.front() +
                           "\", and power does not start one; simulate studies with \"asperity "
                           "simulate\", and analyse each of them");
}

/// A study without participants that has the files of the protocol.
void make_origin(const std::filesystem::path& folder, const Protocol& protocol,
                 const std::filesystem::path& from) {
  Study::create(folder, protocol.name);
  const std::vector<NamedFile> named = files_of(protocol);
  if (named.empty()) return;
  if (from.empty()) {
    throw std::runtime_error("the protocol names files, such as " + named.front().path +
                             ", which are rendered on the full physics; state the study that has "
                             "them with --study");
  }
  copy_files(protocol, from, folder);
}

}  // namespace

std::uint64_t simulation_seed(std::uint64_t seed, std::int64_t run) {
  return random_of_study(seed, run).bits();
}

PhysicsStudies::PhysicsStudies(const Protocol& protocol, PhysicsInputs inputs,
                               const ModelRegistry& models)
    : protocol_(protocol), inputs_(std::move(inputs)), models_(models) {
  refuse_external_levels(protocol_);
  make_origin(origin(), protocol_, inputs_.study);
  // The file of the user can change during hours of simulation.
  write_file(protocol_file(), protocol_.source, Overwrite::refuse);
}

SimulationInputs PhysicsStudies::simulation_of(const std::filesystem::path& study,
                                               std::uint64_t seed) const {
  return {.protocols = {protocol_file()},
          .study = study,
          .participants = inputs_.participants.back(),
          .seed = seed,
          .jobs = inputs_.jobs,
          .recordings = Recordings::none};
}

std::string PhysicsStudies::declaration() const {
  return declaration_of(simulation_of(origin(), 0), models_);
}

std::vector<SimulatedOutcome> PhysicsStudies::outcomes(int participants, std::uint64_t seed,
                                                       std::int64_t run,
                                                       const std::stop_token& stop) {
  if (!last_ || last_->seed != seed || last_->number != run) last_ = simulated(seed, run, stop);
  if (!last_) return {};
  return last_->by_participants.at(participants);
}

std::optional<PhysicsStudies::Run> PhysicsStudies::simulated(std::uint64_t seed, std::int64_t run,
                                                             const std::stop_token& stop) {
  const WorkFolder work("study");
  const std::filesystem::path folder = work.path() / "study";
  Study::open(origin(), Access::read_only).copy_to(folder);
  SimulationInputs inputs = simulation_of(folder, simulation_seed(seed, run));
  inputs.warned = std::exchange(inputs_.warned, {});
  try {
    simulate(inputs, models_, stop, {}, {});
  } catch (...) {
    if (stop.stop_requested()) return std::nullopt;
    throw;
  }
  const Study study = Study::open(folder, Access::read_only);
  Run made{.seed = seed, .number = run};
  std::set<std::string> labels{};
  for (const int participants : inputs_.participants) {
    while (static_cast<int>(labels.size()) < participants) {
      labels.insert(virtual_person(static_cast<int>(labels.size()) + 1, Random(seed), "").label);
    }
    made.by_participants[participants] = outcomes_of(gather_answers(
        study, protocol_.name,
        [&labels](const ParticipantRow& person) { return labels.contains(person.label); }, {}));
  }
  return made;
}

}  // namespace asperity
