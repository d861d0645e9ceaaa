// The words of the store for the closed sets of a row; the assets of a presentation.

#include "results_schema/rows.h"

#include <algorithm>

namespace asperity {

std::optional<std::string> asset_sha256(const std::vector<AssetRow>& assets,
                                        std::string_view role) {
  const auto found = std::find_if(assets.begin(), assets.end(),
                                  [role](const AssetRow& asset) { return asset.role == role; });
  if (found == assets.end()) return {};
  return found->sha256;
}

const char* text_of(SessionMode mode) noexcept {
  switch (mode) {
    case SessionMode::run:
      return "run";
    case SessionMode::pilot:
      return "pilot";
    case SessionMode::simulate:
      return "simulate";
  }
  return "";
}

const char* text_of(SessionState state) noexcept {
  switch (state) {
    case SessionState::open:
      return "open";
    case SessionState::completed:
      return "completed";
    case SessionState::stopped:
      return "stopped";
    case SessionState::crashed:
      return "crashed";
  }
  return "";
}

const char* text_of(AttemptOutcome outcome) noexcept {
  switch (outcome) {
    case AttemptOutcome::answered:
      return "answered";
    case AttemptOutcome::timed_out:
      return "timed_out";
    case AttemptOutcome::not_compliant:
      return "not_compliant";
    case AttemptOutcome::aborted:
      return "aborted";
    case AttemptOutcome::device_fault:
      return "device_fault";
    case AttemptOutcome::emergency_stop:
      return "emergency_stop";
    case AttemptOutcome::skipped:
      return "skipped";
  }
  return "";
}

const char* text_of(AttemptPurpose purpose) noexcept {
  switch (purpose) {
    case AttemptPurpose::trial:
      return "trial";
    case AttemptPurpose::refresher:
      return "refresher";
  }
  return "";
}

const char* text_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::set_aside:
      return "set_aside";
    case Verdict::flag:
      return "flag";
    case Verdict::exclude:
      return "exclude";
    case Verdict::include:
      return "include";
  }
  return "";
}

const char* text_of(OutputKind kind) noexcept {
  switch (kind) {
    case OutputKind::export_:
      return "export";
    case OutputKind::public_export:
      return "public_export";
    case OutputKind::report:
      return "report";
    case OutputKind::copy:
      return "copy";
    case OutputKind::merge:
      return "merge";
  }
  return "";
}

const char* text_of(WithdrawnData data) noexcept {
  switch (data) {
    case WithdrawnData::kept:
      return "kept";
    case WithdrawnData::deleted:
      return "deleted";
  }
  return "";
}

const char* text_of(WithdrawalReason reason) noexcept {
  switch (reason) {
    case WithdrawalReason::consent_withdrawn:
      return "consent_withdrawn";
    case WithdrawalReason::not_eligible:
      return "not_eligible";
    case WithdrawalReason::other:
      return "other";
  }
  return "";
}

}  // namespace asperity
