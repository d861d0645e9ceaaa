-- An emergency stop is one in the view as well; the table keeps it among the faults, which the servo's row tells apart.

DROP VIEW tidy_attempt;
CREATE VIEW tidy_attempt AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       participant.is_virtual, session.mode, session.state AS session_state,
       protocol.name AS protocol, protocol.version AS protocol_version,
       trial.block, trial.phase, trial.repetition, trial.factors_json,
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
