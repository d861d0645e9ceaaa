// A small study on disk whose rows a test writes by hand, and which is gone after the test.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

/// An answered trial: what was felt, what was answered, and what would have been right.
struct MadeUpTrial {
  std::string factors_json = "{}";
  std::vector<PresentationRow> surfaces{};
  std::vector<ComplianceRow> compliance{};  ///< how they were explored
  std::vector<std::string> answers{};
  /// As many as answers, or none. An answer to one that begins with a digit or a sign is a number.
  std::vector<std::string> questions{};
  std::optional<double> number{};    ///< that the answer is, of a magnitude
  std::vector<std::string> right{};  ///< as many as answers, or none
  std::vector<std::string> options{};
  std::optional<double> from_cue_s = 1.5;
  std::string phase = "main";
  std::string block = "only";
  int block_ordinal = 1;
  int repetition = 1;          ///< 0 of an anchor
  std::optional<int> track{};  ///< where a procedure chose the level
  std::optional<int> step{};
  bool is_catch = false;
  AttemptOutcome outcome = AttemptOutcome::answered;
  bool valid = true;
  bool flagged = false;
  std::optional<RecordingRow> recording{};
  std::vector<EventRow> events{};
  std::string plan_json = "{}";
  bool is_presented = true;
};

PresentationRow surface_of(const std::string& item, const std::string& model,
                           const std::string& texture);

class MadeUpStudy final {
 public:
  /// A folder of its own under the system's temporary one.
  MadeUpStudy();

  Study& study() { return *study_; }
  std::filesystem::path folder() const { return folder_ / "study"; }
  /// For what a test writes beside the study.
  std::filesystem::path beside(const std::string& name) const { return folder_ / name; }

  std::int64_t add_protocol(const std::string& name, const std::string& kind,
                            const std::string& source = "{}", const std::string& version = "1");
  void add_person(const std::string& label, const std::string& sex);
  void add_virtual(const std::string& label, const std::string& sex);

  /// Of the sessions added from now on.
  void set_observer(const std::string& observer_json) { observer_json_ = observer_json; }
  void set_device(const std::string& device_json) { device_json_ = device_json; }
  void set_files(const std::vector<StimulusFileRow>& files) { files_ = files; }
  void set_state(SessionState state) { state_ = state; }
  void set_group(const std::optional<std::string>& group) { group_ = group; }

  /// One session, completed unless another state was set, with one attempt per trial. Returns its id.
  std::int64_t add_session(const std::string& participant, std::int64_t protocol,
                           const std::vector<MadeUpTrial>& trials,
                           SessionMode mode = SessionMode::run);

 private:
  TemporaryFolder folder_{};
  std::optional<Study> study_{};
  std::string observer_json_ = "null";
  std::string device_json_ = "{}";
  std::vector<StimulusFileRow> files_{};
  SessionState state_ = SessionState::completed;
  std::optional<std::string> group_{};
};

}  // namespace asperity
