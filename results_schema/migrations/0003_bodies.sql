-- What touched each other, where a force model has two bodies; and how often it was asked beyond its limits.

ALTER TABLE presentation ADD COLUMN surface_sha256 TEXT
  CHECK (length(surface_sha256) = 64 AND surface_sha256 NOT GLOB '*[^0-9a-f]*');
ALTER TABLE presentation ADD COLUMN tool_sha256 TEXT
  CHECK (length(tool_sha256) = 64 AND tool_sha256 NOT GLOB '*[^0-9a-f]*');

-- One row for each kind of limit that the force model watches, whether or not it was met.
CREATE TABLE model_limit (
  attempt_id INTEGER NOT NULL,
  position   INTEGER NOT NULL,
  kind       TEXT NOT NULL CHECK (kind <> ''),
  ticks      INTEGER NOT NULL CHECK (ticks >= 0),
  PRIMARY KEY (attempt_id, position, kind),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

CREATE TRIGGER model_limit_no_update BEFORE UPDATE ON model_limit
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;
CREATE TRIGGER model_limit_no_delete BEFORE DELETE ON model_limit
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;
CREATE TRIGGER model_limit_no_replace BEFORE INSERT ON model_limit
WHEN EXISTS (SELECT 1 FROM model_limit WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                         AND kind = NEW.kind)
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;
CREATE TRIGGER model_limit_has_its_presentation BEFORE INSERT ON model_limit
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a model_limit needs its presentation'); END;
