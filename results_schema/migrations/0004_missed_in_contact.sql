-- Late ticks while a surface was touched, on which an attempt is judged; missing where they were not counted apart.

ALTER TABLE servo_quality ADD COLUMN missed_in_contact INTEGER
  CHECK (missed_in_contact >= 0 AND missed_in_contact <= missed_deadlines);
