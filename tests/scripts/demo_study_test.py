#!/usr/bin/env python3
"""scripts/demo-study with a pretended asperity: what it runs in each state that a study can be in."""
import pathlib
import shutil
import stat
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROTOCOLS = ("chapter_selection", "chapter_matching", "chapter_recognition")


class DemoStudy(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.study = self.folder / "demo-study"
        self.asked = self.folder / "asked"
        self.pretend()

    def pretend(self, new="", simulate=""):
        """An asperity that notes what it is asked; `new` and `simulate` are what it does besides."""
        files = " ".join(f'"$2/protocols/{name}.json"' for name in PROTOCOLS)
        self.asperity = self.folder / "asperity"
        self.asperity.write_text(f"""#!/bin/sh
echo "$@" >> {self.asked}
case $1 in
  new) mkdir -p "$2/protocols"; {new or ":"}; touch {files} ;;
  simulate) echo "done virtual0001 1 1 1" >&2; echo "stored virtual0001 1 2 1 not_compliant" >&2; echo "simulating: 50 %" >&2; {simulate or ":"} ;;
  analyze) echo "the result" ;;
esac
""")
        self.asperity.chmod(self.asperity.stat().st_mode | stat.S_IXUSR)

    def run_demo(self):
        answer = subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study], text=True,
                                capture_output=True, check=False)
        asked = self.asked.read_text().replace(str(self.study), "STUDY").splitlines() if self.asked.exists() else []
        self.asked.unlink(missing_ok=True)
        return answer, asked

    def everything(self):
        return sorted((path, path.stat().st_mtime_ns) for path in self.study.rglob("*"))

    def test_makes_simulates_and_shows_a_new_study(self):
        answer, (make, simulate, analyze) = self.run_demo()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(make, r"^new .*/demo-study --demo$")
        self.assertIn("simulate STUDY/protocols/chapter_selection.json STUDY/protocols/chapter_matching.json "
                      "STUDY/protocols/chapter_recognition.json --study STUDY --participants 20 --seed 1", simulate)
        self.assertEqual(analyze, "analyze STUDY")
        self.assertEqual(answer.stdout, "the result\n")

    def test_goes_on_with_a_study_that_is_there_and_makes_nothing_anew(self):
        self.run_demo()
        before = self.everything()
        answer, (simulate, analyze) = self.run_demo()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertTrue(simulate.endswith(" --resume"), simulate)
        self.assertEqual(analyze, "analyze STUDY")
        self.assertEqual(self.everything(), before)

    def test_leaves_no_half_made_study_behind(self):
        self.pretend(new="exit 1")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(len(asked), 1)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["asperity"])
        self.pretend()
        self.assertEqual(self.run_demo()[0].returncode, 0)

    def test_leaves_a_folder_alone_that_is_another_study(self):
        self.study.mkdir()
        (self.study / "notes.txt").write_text("mine")
        answer, asked = self.run_demo()
        self.assertEqual((answer.returncode, asked), (1, []))
        self.assertIn("chapter_selection.json", answer.stderr)
        self.assertEqual([path.name for path in self.study.iterdir()], ["notes.txt"])

    def test_shows_what_the_program_says_but_for_stored_attempts(self):
        answer, _ = self.run_demo()
        self.assertIn("simulating: 50 %", answer.stderr)
        self.assertNotIn("virtual0001", answer.stderr)

    def test_stops_when_the_simulation_was_interrupted(self):
        self.pretend(simulate="exit 1")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertEqual([line.split()[0] for line in asked], ["new", "simulate"])


if __name__ == "__main__":
    unittest.main()
