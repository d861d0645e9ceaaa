-- Trials whose level a procedure chose from the responses: their track within the run of the block, and the place in it.
-- The plan of such a session grows: expected_trials is the estimate of its length when it began.

ALTER TABLE trial ADD COLUMN track INTEGER CHECK (track >= 1);
ALTER TABLE trial ADD COLUMN step INTEGER CHECK (step >= 1 AND (step IS NULL) = (track IS NULL));

ALTER TABLE session ADD COLUMN expected_trials INTEGER CHECK (expected_trials >= 1);

DROP TRIGGER session_only_changes_state;
CREATE TRIGGER session_only_changes_state BEFORE UPDATE ON session
WHEN NEW.id IS NOT OLD.id OR NEW.participant_id IS NOT OLD.participant_id
  OR NEW.session IS NOT OLD.session OR NEW.protocol_id IS NOT OLD.protocol_id
  OR NEW.mode IS NOT OLD.mode OR NEW.seed IS NOT OLD.seed OR NEW.generator IS NOT OLD.generator
  OR NEW.counterbalance_row IS NOT OLD.counterbalance_row
  OR NEW.program_version IS NOT OLD.program_version
  OR NEW.program_commit IS NOT OLD.program_commit OR NEW.program_build IS NOT OLD.program_build
  OR NEW.program_sha256 IS NOT OLD.program_sha256
  OR NEW.instruction_set IS NOT OLD.instruction_set OR NEW.os IS NOT OLD.os
  OR NEW.device IS NOT OLD.device OR NEW.device_json IS NOT OLD.device_json
  OR NEW.pacing IS NOT OLD.pacing OR NEW.scheduling IS NOT OLD.scheduling
  OR NEW.rate_Hz IS NOT OLD.rate_Hz OR NEW.started_utc IS NOT OLD.started_utc
  OR NEW.clock_zero_ns IS NOT OLD.clock_zero_ns OR NEW.observer_json IS NOT OLD.observer_json
  OR NEW.consent_version IS NOT OLD.consent_version OR NEW.consent_utc IS NOT OLD.consent_utc
  OR NEW.mirrored IS NOT OLD.mirrored OR NEW.group_level IS NOT OLD.group_level
  OR NEW.expected_trials IS NOT OLD.expected_trials
BEGIN SELECT RAISE(ABORT, 'of a session only state and ended_utc may change'); END;
