#!/usr/bin/env python3
"""scripts/demo-study with a pretended asperity: what it runs in each state that a study can be in."""
import pathlib
import shutil
import stat
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROTOCOLS = ("selection", "matching", "recognition")
EVERYBODY = [f"virtual{n:04}" for n in range(1, 21)]


class DemoStudy(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.study = self.folder / "demo-study"
        self.asked = self.folder / "asked"
        self.tables = self.folder / "tables"
        self.tables.mkdir()
        self.holds([])
        self.asperity = self.folder / "asperity"
        self.asperity.write_text(f"""#!/bin/sh
case $1 in
  export) cp -r {self.tables} "$4" ;;
  simulate) echo "$@" >> {self.asked}; echo "done virtual0001 1 1 1" >&2; echo "half done" >&2 ;;
  *) echo "$@" >> {self.asked} ;;
esac
""")
        self.asperity.chmod(self.asperity.stat().st_mode | stat.S_IXUSR)

    def holds(self, sessions, participants=()):
        """What is in the study: sessions as (participant, protocol, state), participants without any."""
        lines = ["participant\tsession\tstate\tprotocol"]
        lines += [f"{who}\t1\t{state}\t{what}" for who, what, state in sessions]
        (self.tables / "sessions.tsv").write_text("\n".join(lines) + "\n")
        labels = sorted({who for who, _, _ in sessions} | set(participants))
        (self.tables / "participants.tsv").write_text("\n".join(["participant", *labels]) + "\n")

    def run_demo(self):
        answer = subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study], text=True,
                                capture_output=True, check=False)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.asked_lines = self.asked.read_text().replace(str(self.study), "STUDY").splitlines()
        return answer

    def test_makes_simulates_and_shows_a_new_study(self):
        self.run_demo()
        make, simulate, analyze = self.asked_lines
        self.assertEqual(make, "new STUDY --demo")
        self.assertIn("simulate STUDY/protocols/selection.json STUDY/protocols/matching.json "
                      "STUDY/protocols/recognition.json --study STUDY --participants 20 --seed 1", simulate)
        self.assertEqual(analyze, "analyze STUDY")

    def test_only_shows_a_complete_study(self):
        self.study.mkdir()
        self.holds([(who, what, "completed") for who in EVERYBODY for what in PROTOCOLS])
        self.run_demo()
        self.assertEqual(self.asked_lines, ["analyze STUDY"])

    def test_resumes_what_was_interrupted_and_runs_what_was_not_begun(self):
        self.study.mkdir()
        self.holds([(EVERYBODY[0], what, "completed") for what in PROTOCOLS] +
                   [(EVERYBODY[1], "selection", "completed"), (EVERYBODY[1], "matching", "open")])
        self.run_demo()
        resumed, run, simulated, _ = self.asked_lines
        self.assertEqual(resumed, "run STUDY/protocols/matching.json --study STUDY --participant virtual0002 "
                                  "--virtual --resume")
        self.assertEqual(run, "run STUDY/protocols/recognition.json --study STUDY --participant virtual0002 "
                              "--virtual --seed 1")
        self.assertIn("--participants 18 ", simulated)

    def test_runs_all_protocols_of_a_participant_who_has_no_session_yet(self):
        self.study.mkdir()
        self.holds([], participants=[EVERYBODY[0]])
        self.run_demo()
        self.assertEqual([line.split()[0] for line in self.asked_lines], ["run"] * 3 + ["simulate", "analyze"])
        self.assertIn("--participants 19 ", self.asked_lines[3])

    def test_stops_when_the_export_lacks_a_column(self):
        self.study.mkdir()
        self.holds([])
        (self.tables / "sessions.tsv").write_text("participant\tprotocol\n")
        answer = subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study], text=True,
                                capture_output=True, check=False)
        self.assertEqual(answer.returncode, 1)
        self.assertIn("no column state", answer.stderr)

    def test_does_not_count_people(self):
        self.study.mkdir()
        self.holds([("P01", "selection", "open")])
        self.run_demo()
        self.assertEqual(len(self.asked_lines), 2)
        self.assertIn("--participants 20 ", self.asked_lines[0])

    def test_shows_what_the_program_says_but_for_finished_trials(self):
        answer = self.run_demo()
        self.assertIn("half done", answer.stderr)
        self.assertNotIn("done virtual0001", answer.stderr)

    def test_stops_when_the_program_fails(self):
        self.study.mkdir()
        self.asperity.write_text("#!/bin/sh\nexit 1\n")
        answer = subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study],
                                capture_output=True, check=False)
        self.assertEqual(answer.returncode, 1)


if __name__ == "__main__":
    unittest.main()
