#!/usr/bin/env python3
"""scripts/demo-study with a pretended asperity: what it runs and shows in each state that a study can be in."""
import contextlib
import json
import os
import pathlib
import re
import shutil
import sqlite3
import stat
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROTOCOLS = ("chapter_selection", "chapter_matching", "chapter_recognition")
SCHEMA = 15


def make_database(file, schema, application=7):
    with contextlib.closing(sqlite3.connect(file)) as database:
        database.executescript(f"PRAGMA application_id = {application}; PRAGMA user_version = {schema}; CREATE TABLE study (name)")


def outcome(protocol, table, question, column, counts, group="virtual"):
    """A part of asperity analyze --json, with numbers and texts that the result does not show."""
    rows = [{column: name, "repetition_1": one, "repetition_2": two, "repetition_3": three, "all": one + two + three}
            for name, (one, two, three) in counts.items()]
    return {"protocol": protocol, "group": group, "participants": 20, "sessions": 19, "answers": 59, "remarks": [],
            "questions": [{"name": "another", "question": "Another?", "answer": "Another answer."},
                          {"name": question, "question": f'The "{question}" question?', "answer": "Its answer. A test of it."}],
            "tables": [{"name": "persons", "title": "Another table", "note": "", "rows": [{"sessions": 7, "group": "men", "all": 99}]},
                       {"name": table, "title": f"The title of {table}", "note": f"Note of {table}.", "rows": rows}],
            "findings": [{"quantity": "sessions", "key": "virtual", "value": 500}]}


RESULT = json.dumps({"format": "asperity.analysis/1", "study": "Demo", "outcomes": [
    outcome("chapter_matching", "table_2", "whole", "person", {"Female": (9, 9, 10), "Male": (9, 8, 10), "Total": (18, 17, 20)}),
    outcome("chapter_recognition", "table_3", "right", "person", {"Female": (8, 8, 9), "Male": (7, 8, 9), "Total": (15, 16, 18)}),
    outcome("chapter_selection", "table_1", "preference", "item", {"height_map": (98, 98, 98)}, group="people"),
    outcome("chapter_selection", "table_1", "preference", "item",
            {"height_map": (8, 20, 19), "sinusoid": (8, 0, 1), "stochastic": (4, 0, 0)})]}, indent=2)


class DemoStudy(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.pretended = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.addCleanup(shutil.rmtree, self.pretended)
        self.study = self.folder / "demo-study"
        self.asked = self.pretended / "asked"
        make_database(self.pretended / "study.sqlite", SCHEMA)
        self.pretend()

    def pretend(self, new="", simulate="", result=RESULT):
        """An asperity that notes what it is asked; `new` and `simulate` are what it does besides, `result` what it finds."""
        files = " ".join(f'"$2/protocols/{name}.json"' for name in PROTOCOLS)
        (self.pretended / "result").write_text(result)
        self.asperity = self.pretended / "asperity"
        self.asperity.write_text(f"""#!/bin/sh
echo "$@" >> {self.asked}
case $1 in
  new) mkdir -p "$2/protocols"; {new or ":"}; touch {files}; cp {self.pretended}/study.sqlite "$2" ;;
  simulate) echo "asperity: each stored attempt is acknowledged by a line" >&2; echo "done virtual0001 1 1 1" >&2; echo "stored virtual0001 1 2 1 not_compliant" >&2; echo "simulating: 50 %" >&2; {simulate or ":"} ;;
  analyze) cat {self.pretended}/result ;;
esac
""")
        self.asperity.chmod(self.asperity.stat().st_mode | stat.S_IXUSR)

    def run_demo(self):
        answer = subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study], text=True,
                                capture_output=True, check=False)
        asked = self.asked.read_text().replace(str(self.study), "STUDY").splitlines() if self.asked.exists() else []
        self.asked.unlink(missing_ok=True)
        return answer, asked

    def make_study(self, name, schema):
        (self.folder / name / "protocols").mkdir(parents=True)
        for protocol in PROTOCOLS:
            (self.folder / name / "protocols" / f"{protocol}.json").touch()
        make_database(self.folder / name / "study.sqlite", schema)

    def everything(self, name="demo-study"):
        return sorted((path, path.stat().st_mtime_ns) for path in (self.folder / name).rglob("*"))

    def test_makes_simulates_and_shows_a_new_study(self):
        answer, (make, simulate, analyze) = self.run_demo()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(make, r"^new .*/demo-study --demo$")
        self.assertIn("simulate STUDY/protocols/chapter_selection.json STUDY/protocols/chapter_matching.json "
                      "STUDY/protocols/chapter_recognition.json --study STUDY --participants 20 --seed 1", simulate)
        self.assertEqual(analyze, "analyze STUDY --json")

    def test_goes_on_with_a_study_that_is_there_and_makes_nothing_anew(self):
        self.run_demo()
        before = self.everything()
        answer, (make, simulate, analyze) = self.run_demo()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertNotIn(str(self.folder), make)  # an empty study to compare the schema
        self.assertTrue(simulate.endswith(" --resume"), simulate)
        self.assertEqual(analyze, "analyze STUDY --json")
        self.assertEqual(self.everything(), before)

    def test_keeps_studies_of_other_schemas_and_makes_another(self):
        self.make_study("demo-study", SCHEMA - 1)
        self.make_study("demo-study-2", SCHEMA + 85)
        before = self.everything(), self.everything("demo-study-2")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual((self.everything(), self.everything("demo-study-2")), before)
        for line in (f"{self.study} has schema {SCHEMA - 1}, and this program uses schema {SCHEMA}", f"{self.study}-2 has schema {SCHEMA + 85}, and"):
            self.assertIn(line, answer.stderr)
        self.assertRegex(asked[1], r"^new .*/demo-study-3 --demo$")
        self.assertIn("--study STUDY-3 ", asked[2])
        self.assertIn("In " + str(self.study) + "-3, ", answer.stdout.replace("\n", " "))
        _, asked = self.run_demo()
        self.assertEqual([line.split()[0] for line in asked], ["new", "simulate", "analyze"])
        self.assertIn("--study STUDY-3 ", asked[1])

    def test_leaves_a_database_of_another_program_to_the_refusal_of_this_one(self):
        self.make_study("demo-study", SCHEMA - 1)
        (self.study / "study.sqlite").unlink()
        make_database(self.study / "study.sqlite", SCHEMA - 1, application=8)
        self.pretend(simulate="exit 1")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertNotIn("schema", answer.stderr)
        self.assertIn("--study STUDY ", asked[1])

    def test_leaves_no_half_made_study_behind(self):
        self.pretend(new="exit 1")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(len(asked), 1)
        self.assertEqual(list(self.folder.iterdir()), [])
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

    def test_shows_the_progress_of_the_simulation_in_one_line_of_a_terminal(self):
        self.pretend(simulate='echo "simulating: 100 %" >&2; echo "60 sessions" ')
        terminal, screen = os.openpty()
        with contextlib.closing(os.fdopen(terminal, "rb", buffering=0)) as shown:
            subprocess.run([ROOT / "scripts" / "demo-study", self.asperity, self.study], stdout=subprocess.PIPE, stderr=screen, check=True)
            os.close(screen)
            self.assertIn(b"\nsimulating: 50 %\rsimulating: 100 %\r60 sessions\r\n", shown.read(10000))

    def test_stops_when_the_simulation_was_interrupted(self):
        self.pretend(simulate="exit 1")
        answer, asked = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertEqual([line.split()[0] for line in asked], ["new", "simulate"])
        self.assertNotIn("again", answer.stderr)  # it failed by itself

    def test_names_the_command_that_resumes_after_an_interrupt(self):
        self.pretend(simulate="kill -INT $PPID; exit 1")
        answer, _ = self.run_demo()
        self.assertEqual(answer.returncode, 1)
        self.assertIn("To resume the simulation, call scripts/run again.", answer.stderr)
        self.assertNotIn("--resume", answer.stderr)

    def test_shows_the_counts_of_virtual_participants_next_to_the_published_ones(self):
        text = self.run_demo()[0].stdout
        rows = [line.split() for line in text.splitlines()]
        for row in ("height_map (image) 8 20 19 47 12 11 13 36", "sinusoid 8 0 1 9 7 8 7 22", "stochastic 4 0 0 4 1 1 0 2",
                    "Female 9 9 10 28 9 9 8 26", "Male 9 8 10 27 9 10 9 28", "Total 18 17 20 55 18 19 17 54",
                    "Female 8 8 9 25 7 8 7 22", "Male 7 8 9 24 9 8 8 25", "Total 15 16 18 49 16 16 15 47"):
            self.assertIn(row.split(), rows)
        self.assertIn("20 virtual participants completed 57 sessions", text.replace("\n", " "))
        self.assertIn("177 responses", text.replace("\n", " "))
        self.assertRegex(text, rf"(?m)^  scripts/run {re.escape(str(self.study))} +the window with this study$")
        self.assertEqual([line for line in text.splitlines() if "answer" in line],
                         ['The "preference" question? Its answer.', 'The "whole" question? Its answer.',
                          'The "right" question? Its answer.'])

    def test_shows_no_result_without_virtual_participants(self):
        self.pretend(result=RESULT.replace('"virtual"', '"people"'))
        answer, _ = self.run_demo()
        self.assertEqual((answer.returncode, answer.stdout), (1, ""))
        self.assertIn("has no responses of virtual participants", answer.stderr)


if __name__ == "__main__":
    unittest.main()
