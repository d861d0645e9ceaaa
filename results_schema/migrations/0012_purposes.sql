-- Attempts at a practice trial that are made again when an interrupted session is resumed have the purpose 'refresher': they
-- never complete their trial and are never analysed. All others, and those of earlier versions, have the purpose 'trial'.
-- A catch trial has an easy level at a random place among the trials of a procedure, has repetition 0, and belongs to no
-- track.

-- Without rules: a rule of a new column would also check the others, and a study with a damaged hash could not be opened.
ALTER TABLE attempt ADD COLUMN purpose TEXT NOT NULL DEFAULT 'trial';
ALTER TABLE trial ADD COLUMN is_catch INTEGER NOT NULL DEFAULT 0;

CREATE TRIGGER attempt_has_a_purpose BEFORE INSERT ON attempt
WHEN NEW.purpose NOT IN ('trial', 'refresher')
BEGIN SELECT RAISE(ABORT, 'the purpose of an attempt is trial or refresher'); END;
CREATE TRIGGER attempt_refreshes_practice BEFORE INSERT ON attempt
WHEN NEW.purpose = 'refresher' AND NOT EXISTS (SELECT 1 FROM trial WHERE session_id = NEW.session_id
                                               AND trial = NEW.trial AND phase = 'practice')
BEGIN SELECT RAISE(ABORT, 'only trials of a practice are repeated as refreshers'); END;
CREATE TRIGGER trial_is_catch_or_of_a_track BEFORE INSERT ON trial
WHEN NEW.is_catch NOT IN (0, 1)
  OR (NEW.is_catch = 1 AND (NEW.repetition <> 0 OR NEW.track IS NOT NULL))
BEGIN SELECT RAISE(ABORT, 'a catch trial has repetition 0 and no track'); END;

-- One valid attempt per trial, but for those that were set aside, and refreshers.
DROP TRIGGER attempt_no_replace;
CREATE TRIGGER attempt_no_replace BEFORE INSERT ON attempt
WHEN EXISTS (SELECT 1 FROM attempt WHERE id = NEW.id
             OR (session_id = NEW.session_id AND trial = NEW.trial
                 AND (attempt = NEW.attempt
                      OR (NEW.valid = 1 AND valid = 1
                          AND NEW.purpose = 'trial' AND purpose = 'trial' AND NOT EXISTS (
                            SELECT 1 FROM decision WHERE decision.session_id = NEW.session_id
                            AND decision.trial = NEW.trial AND decision.attempt = attempt.attempt
                            AND verdict = 'set_aside')))))
BEGIN SELECT RAISE(ABORT, 'an attempt is append-only, and a trial has one valid attempt'); END;

DROP VIEW tidy_attempt;
CREATE VIEW tidy_attempt AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       participant.is_virtual, session.mode, session.state AS session_state,
       protocol.name AS protocol, protocol.version AS protocol_version,
       trial.block, trial.phase, trial.repetition, trial.is_catch, attempt.purpose,
       trial.factors_json,
       CASE WHEN attempt.outcome = 'device_fault'
            AND (SELECT fault FROM servo_quality WHERE attempt_id = attempt.id) = 'emergency_stop'
         THEN 'emergency_stop' ELSE attempt.outcome END AS outcome,
       attempt_standing.valid,
       coalesce(iif(attempt.invalid_reason IS NULL, '', attempt.invalid_reason || '; ') ||
                (SELECT 'set aside: ' || reason FROM decision
                 WHERE decision.session_id = attempt.session_id AND decision.trial = attempt.trial
                 AND decision.attempt = attempt.attempt AND verdict = 'set_aside'
                 ORDER BY decision.id LIMIT 1), attempt.invalid_reason) AS invalid_reason,
       attempt_standing.excluded,
       attempt.flagged OR EXISTS (
         SELECT 1 FROM decision WHERE decision.session_id = attempt.session_id
         AND decision.trial = attempt.trial AND decision.attempt = attempt.attempt
         AND verdict = 'flag') AS flagged,
       nullif(concat_flags.reasons, '') AS flag_reason,
       (attempt.onset_ns - session.clock_zero_ns) / 1e9 AS onset_s,
       (attempt.offset_ns - attempt.onset_ns) / 1e9 AS duration_s,
       recording.path AS recording_path
FROM attempt
JOIN attempt_standing ON attempt_standing.attempt_id = attempt.id
JOIN (SELECT attempt.id AS attempt_id,
             coalesce(attempt.flag_reason, '') || coalesce((
               SELECT iif(attempt.flag_reason IS NULL, '', '; ') || group_concat(reason, '; ')
               FROM decision WHERE decision.session_id = attempt.session_id
               AND decision.trial = attempt.trial AND decision.attempt = attempt.attempt
               AND verdict = 'flag'), '') AS reasons
      FROM attempt) AS concat_flags ON concat_flags.attempt_id = attempt.id
JOIN trial ON trial.session_id = attempt.session_id AND trial.trial = attempt.trial
JOIN session ON session.id = attempt.session_id
JOIN participant ON participant.id = session.participant_id
JOIN protocol ON protocol.id = session.protocol_id
LEFT JOIN recording ON recording.attempt_id = attempt.id
ORDER BY participant.label, session.session, attempt.trial, attempt.attempt;
