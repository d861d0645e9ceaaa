-- The visits of the hand to each surface of an attempt. Attempts of earlier versions have none stored.
-- The material of a surface, and the height of its plane above that of the workspace, which can differ between the surfaces of a
-- trial. In attempts of earlier versions all surfaces have the material of the protocol, and height 0.

-- Without rules: a rule of a new column would also check the others, and a study with a damaged hash could not be opened.
ALTER TABLE presentation ADD COLUMN stiffness_N_per_m REAL;
ALTER TABLE presentation ADD COLUMN friction REAL;
ALTER TABLE presentation ADD COLUMN raised_m REAL;

CREATE TABLE visit (
  attempt_id           INTEGER NOT NULL,
  position             INTEGER NOT NULL,
  visit                INTEGER NOT NULL CHECK (visit >= 1),
  contact_ns           INTEGER NOT NULL,
  offset_ns            INTEGER NOT NULL CHECK (offset_ns >= contact_ns),
  contact_s            REAL NOT NULL CHECK (contact_s > 0),
  path_m               REAL NOT NULL CHECK (path_m >= 0),
  force_mean_N         REAL,
  force_sd_N           REAL CHECK (force_sd_N >= 0 AND (force_sd_N IS NULL) = (force_mean_N IS NULL)),
  speed_mean_m_per_s   REAL NOT NULL CHECK (speed_mean_m_per_s >= 0),
  speed_sd_m_per_s     REAL NOT NULL CHECK (speed_sd_m_per_s >= 0),
  PRIMARY KEY (attempt_id, position, visit),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

CREATE TRIGGER visit_no_update BEFORE UPDATE ON visit
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;
CREATE TRIGGER visit_no_delete BEFORE DELETE ON visit
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;
CREATE TRIGGER visit_no_replace BEFORE INSERT ON visit
WHEN EXISTS (SELECT 1 FROM visit WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                   AND visit = NEW.visit)
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;
CREATE TRIGGER visit_has_its_presentation BEFORE INSERT ON visit
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a visit needs its presentation'); END;
