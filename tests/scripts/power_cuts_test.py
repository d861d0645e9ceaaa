#!/usr/bin/env python3
"""The power fails after every write of a session: no attempt that was reported stored is lost.

Arguments: the program asperity; the library of noted_writes.cpp; --draws N, of what a disk happens to keep (1);
--programs N, how many cuts of each disk are also given to the program (50).

One participant completes a short session. Another one's session of 20 trials is killed after the tenth; then the first
withdraws and is deleted, the study is exported, and the session is resumed. All changes and syncs of files are noted, with all that
the program reports. A cut after every note, on the three disks of lossy_disk.py:

  - the database can be read, and holds every attempt that was reported stored, with its recording, bit for bit;
    those of the participant who is deleted, until the deletion begins, and then all or none; none after its end;
  - an export has its name only when it is complete, and is there once it is reported made.

At some of the cuts the program is run on what the disk kept: verify finds no problem, a withdrawal that had begun can be
repeated and leaves no byte of the label, and the session is resumed to the same answers.
"""
import argparse
import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile

import lossy_disk

TRIALS = 20
LEAVER, STAYER = "leaver7", "stayer3"


def protocol(name, trials):
    surfaces = [{"role": role, "stimulus": "grating"} for role in ("standard", "comparison")]
    return {
        "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": name,
        "version": "1.0.0", "title": "Tracks",
        "consent": {"version": "1.0", "statement": "I take part of my own free will."},
        "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
        "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
        "blocks": {"main": {
            "exploration": "short",
            "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
                     "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
            "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [20, 10, 5], "start": 50,
                          "stop": {"trials": trials // 2}, "tracks": [{}, {}]},
            "presented": surfaces, "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
            "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
        "flow": [{"run": "main"}]}


@dataclasses.dataclass
class Course:
    """What happened, by the numbers of notes."""
    program: str
    root: str
    before: dict           # snapshots of the folder
    after: dict
    notes: str             # their file
    withdrawal: tuple      # from note, to note
    export_end: int
    resume: list           # the words of its command
    answers: list          # of the whole session


def run(words, **more):
    return subprocess.run([*map(str, words)], text=True, capture_output=True, check=False, stdin=subprocess.DEVNULL, **more)


def must(words, **more):
    done = run(words, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")


def rows_of(study, query, **values):
    store = sqlite3.connect(f"file:{study}/study.sqlite?mode=ro", uri=True)
    try:
        return store.execute(query, values).fetchall()
    finally:
        store.close()


def answers(study):
    return rows_of(study, "SELECT a.trial, r.answer FROM response r JOIN attempt a ON a.id = r.attempt_id "
                   "JOIN session s ON s.id = a.session_id JOIN participant p ON p.id = s.participant_id "
                   "WHERE p.label = :label AND a.valid = 1 ORDER BY a.trial, a.attempt", label=STAYER)


def make_course(program, library, folder):
    """Runs it all, with the notes in folder/notes, below folder/place."""
    root = folder / "place"
    study, notes = root / "study", folder / "notes"
    root.mkdir()
    must([program, "new", study])
    for name, trials in (("few", 4), ("many", TRIALS)):
        (folder / f"{name}.json").write_text(json.dumps(protocol(name, trials)), encoding="utf-8")
    before = lossy_disk.snapshot(root)
    noting = dict(os.environ, LD_PRELOAD=library, ASPERITY_NOTED_FOLDER=str(root), ASPERITY_NOTES=str(notes),
                  ASAN_OPTIONS="verify_asan_link_order=0")

    def session(name, label, *more):
        return [program, "run", folder / f"{name}.json", "--study", study, "--participant", label, "--virtual", *more]

    def notes_so_far():
        return len(lossy_disk.read_notes(notes))

    must(session("few", LEAVER, "--seed", "3"), env=noting)
    running = subprocess.Popen([*map(str, session("many", STAYER, "--seed", "4"))], env=noting, text=True,
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    done = 0
    for line in running.stderr:
        done += line.startswith("done ")
        if done == TRIALS // 2:
            running.send_signal(signal.SIGKILL)
    running.stderr.close()
    assert running.wait() == -signal.SIGKILL, running.returncode
    begin = notes_so_far()
    must([program, "withdraw", study, LEAVER, "--delete", "--confirm", LEAVER], env=noting)
    end = notes_so_far()
    must([program, "export", study, "--out", root / "tables"], env=noting)
    export_end = notes_so_far()
    resume = session("many", STAYER, "--resume")
    must(resume, env=noting)
    after = lossy_disk.snapshot(root)
    return Course(program=str(program), root=str(root), before=before, after=after, notes=str(notes), withdrawal=(begin, end),
                  export_end=export_end, resume=[*map(str, resume)], answers=answers(study))


def without_shared_memory(files):
    return {path: content for path, content in files.items() if not path.endswith("-shm")}


class Checks:
    """The states of one disk after every cut."""

    def __init__(self, course, model, draw, programs, folder):
        self.course, self.model, self.random = course, model, random.Random(f"{model} {draw}")
        self.folder = pathlib.Path(folder)
        (self.folder / "place").mkdir()
        self.place = lossy_disk.Place(self.folder / "place")
        self.notes = lossy_disk.read_notes(course.notes)
        self.problems = []
        self.counts = {"cuts": 0, "acknowledged attempts looked for": 0, "runs of the program": 0}
        self.given = set(self.random.sample(range(1, len(self.notes) + 1), min(programs, len(self.notes))))
        self.hashes = {}
        disk = lossy_disk.Disk(course.root, "strict", course.before)
        for note in self.notes[:course.export_end]:
            disk.take(note)
        self.export = {path: content for path, content in disk.now().items() if path.startswith("tables")}
        for note in self.notes[course.export_end:]:
            disk.take(note)
        real = {path: content for path, (_, content) in course.after.items() if path != "."}
        assert without_shared_memory(disk.now()) == without_shared_memory(real), "the notes do not have all changes"

    def complain(self, cut, text):
        self.problems.append(f"{self.model}, cut after note {cut} of {len(self.notes)}: {text}")

    def run(self):
        disk = lossy_disk.Disk(self.course.root, self.model, self.course.before)
        said, acknowledged, seen, stored = "", set(), None, None
        for cut, note in enumerate(self.notes, 1):
            disk.take(note)
            if note.kind == "said":
                said += note.content.decode(errors="replace")
                lines = said.split("\n")
                said = lines.pop()
                for line in lines:
                    word = re.match(r"(?:done (\S+ \d+ \d+ \d+)|stored (\S+ \d+ \d+ \d+) \S+)$", line)
                    if word:
                        acknowledged.add(word[1] or word[2])
            if self.model != "strict" or seen != disk.version:
                seen = disk.version
                files = without_shared_memory(disk.after_cut(self.random))
                self.place.show(files)
                stored = self.stored(cut, files)
            self.counts["cuts"] += 1
            if stored is not None:
                self.compare(cut, files, acknowledged, stored)
            if cut in self.given:
                self.run_program(cut)
            if len(self.problems) >= 5:
                break
        return self.counts, self.problems

    def stored(self, cut, files):
        """"PARTICIPANT SESSION TRIAL ATTEMPT" → path and hash of its recording; None where the study cannot be read."""
        study = self.folder / "place" / "study"
        try:
            sound = rows_of(study, "PRAGMA integrity_check")
            found = rows_of(study, "SELECT p.label || ' ' || s.session || ' ' || a.trial || ' ' || a.attempt, r.path, r.sha256 "
                            "FROM attempt a JOIN session s ON s.id = a.session_id JOIN participant p ON p.id = s.participant_id "
                            "LEFT JOIN recording r ON r.attempt_id = a.id")
        except sqlite3.Error as error:
            self.complain(cut, f"the study cannot be read: {error}")
            return None
        finally:  # what reading makes
            for path in ("study/study.sqlite-shm", "study/study.sqlite-wal"):
                if path not in files:
                    (self.folder / "place" / path).unlink(missing_ok=True)
        if sound != [("ok",)]:
            self.complain(cut, f"the study is damaged: {sound[:2]}")
            return None
        return {attempt: (path, sha256) for attempt, path, sha256 in found}

    def hash_of(self, path, content):
        known = self.hashes.get(path)
        if known is None or known[0] is not content:
            known = self.hashes[path] = (content, hashlib.sha256(content).hexdigest())
        return known[1]

    def compare(self, cut, files, acknowledged, stored):
        begin, end = self.course.withdrawal
        leavers = {attempt for attempt in acknowledged if attempt.startswith(LEAVER)}
        there = {attempt for attempt in stored if attempt.startswith(LEAVER)}
        expected = acknowledged if cut <= begin else acknowledged - leavers
        self.counts["acknowledged attempts looked for"] += len(expected)
        lost = expected - stored.keys()
        if lost:
            self.complain(cut, f"lost: {sorted(lost)[:3]}")
        if begin < cut < end and there and there != leavers:
            self.complain(cut, f"a part of the attempts is deleted: {sorted(there)} of {sorted(leavers)}")
        if cut >= end and there:
            self.complain(cut, f"deleted attempts have come back: {sorted(there)}")
        for attempt in expected & stored.keys():
            path, sha256 = stored[attempt]
            content = files.get(f"study/{path}") if path else None
            if path and (content is None or self.hash_of(path, content) != sha256):
                self.complain(cut, f"the recording of {attempt} is {'missing' if content is None else 'damaged'}")
        export = {path: content for path, content in files.items() if path.split("/")[0] == "tables"}
        if export != self.export and (export or cut >= self.course.export_end):
            self.complain(cut, f"the export is not complete: {len(export)} of {len(self.export)} files and folders")

    def run_program(self, cut):
        """The program on a copy of what the disk kept, in the place where it was."""
        begin, _ = self.course.withdrawal
        self.counts["runs of the program"] += 1
        copy = self.folder / "copy"
        study = copy / "study"
        shutil.copytree(self.folder / "place", copy)
        try:
            if cut > begin:
                repeated = run([self.course.program, "withdraw", study, LEAVER, "--delete", "--confirm", LEAVER])
                if repeated.returncode != 0 and f"no participant {LEAVER}" not in repeated.stderr:
                    self.complain(cut, f"the withdrawal cannot be repeated: {repeated.stderr[-300:]}")
                rest = [str(path.relative_to(copy)) for path in sorted(study.rglob("*"))
                        if LEAVER in path.name or (path.is_file() and LEAVER.encode() in path.read_bytes())]
                if rest:
                    self.complain(cut, f"after the withdrawal was repeated, the label is left in {rest}")
            self.verify(cut, study)
            states = rows_of(study, "SELECT s.state FROM session s JOIN participant p ON p.id = s.participant_id "
                             "WHERE p.label = :label", label=STAYER)
            if states and states != [("completed",)]:
                resumed = run([word.replace(self.course.root, str(copy)) for word in self.course.resume])
                if resumed.returncode != 0:
                    self.complain(cut, f"the session cannot be resumed: {resumed.stderr[-300:]}")
                elif answers(study) != self.course.answers:
                    self.complain(cut, "the resumed session has other answers")
                self.verify(cut, study)
        finally:
            shutil.rmtree(copy)

    def verify(self, cut, study):
        verified = run([self.course.program, "verify", study])
        if verified.returncode != 0:
            self.complain(cut, f"verify: {(verified.stdout + verified.stderr)[-400:]}")


def check(course, model, draw, programs, folder):
    with tempfile.TemporaryDirectory(dir=folder) as own:
        return Checks(course, model, draw, programs, own).run()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--draws", type=int, default=1)
    parser.add_argument("--programs", type=int, default=50)
    asked = parser.parse_args()
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        folder = pathlib.Path(folder).resolve()
        course = make_course(asked.program, asked.library, folder)
        tasks = [(course, model, draw, asked.programs, folder) for draw in range(asked.draws) for model in lossy_disk.MODELS]
        total, problems = {}, []
        with concurrent.futures.ProcessPoolExecutor() as pool:
            for counts, found in pool.map(check, *zip(*tasks)):
                problems += found
                for what, count in counts.items():
                    total[what] = total.get(what, 0) + count
    print(", ".join(f"{count} {what}" for what, count in total.items()))
    if problems:
        sys.exit("\n".join(problems))


main()
