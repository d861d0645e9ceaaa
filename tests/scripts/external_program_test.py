#!/usr/bin/env python3
"""Levels of an external program, through the real program: the example of docs/formats/external.md has the levels of the built-in
staircase, a killed simulation is completed with the same levels, and a study that needs a program opens without one. Argument: asperity."""
import json
import os
import pathlib
import re
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]

STAIRCASE = {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [20, 10, 5], "start": 50,
             "stop": {"trials": 12}, "tracks": [{}, {}]}
EXTERNAL = {"method": "external", "stop": {"trials": 12}, "tracks": [{}, {}],
            "settings": {"start": 50, "steps": [4, 2, 1]}}


def protocol(procedure):
    surfaces = [{"role": role, "stimulus": "grating"} for role in ("standard", "comparison")]
    return {
        "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "tracks",
        "version": "1.0.0", "title": "Tracks",
        "consent": {"version": "1.0", "statement": "I take part of my own free will."},
        "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
        "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
        "blocks": {"main": {
            "exploration": "short",
            "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
                     "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
            "procedure": procedure, "presented": surfaces, "positions": "balanced",
            "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
            "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
        "flow": [{"run": "main"}]}


def asperity(*arguments, status=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, timeout=300)
    if done.returncode != status:
        sys.exit(f"asperity {' '.join(map(str, arguments))}: {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout + done.stderr


def levels(study):
    with sqlite3.connect(f"file:{study}/study.sqlite?mode=ro", uri=True) as database:
        return [json.loads(row[0])["amplitude_m"] for row in
                database.execute("SELECT factors_json FROM trial JOIN session ON session.id = session_id "
                                 "JOIN participant ON participant.id = participant_id ORDER BY label, trial")]


def expect(holds, what):
    if not holds:
        sys.exit(what)


with tempfile.TemporaryDirectory() as place:
    place = pathlib.Path(place)
    page = (ROOT / "docs" / "formats" / "external.md").read_text(encoding="utf-8")
    example = place / "staircase.py"
    example.write_text(re.search(r"```python\n(.*?)```", page, re.DOTALL).group(1), encoding="utf-8")
    example.chmod(0o755)
    for name, procedure in {"external": EXTERNAL, "built_in": STAIRCASE}.items():
        (place / f"{name}.json").write_text(json.dumps(protocol(procedure)), encoding="utf-8")

    def simulate(study, name="external", *more, status=0):
        chosen = ["--external", example] if name == "external" else []
        return asperity("simulate", place / f"{name}.json", "--study", place / study, "--participants", 2,
                        "--seed", 5, "--recordings", "none", *chosen, *more, status=status)

    said = asperity("check", place / "external.json")
    expect("unknown before the session" in said, f"check does not state that the levels are unknown: {said}")
    said = asperity("simulate", place / "external.json", "--study", place / "none", "--participants", 1, "--seed", 1,
                    status=1)
    expect("--external PROGRAM" in said, f"a missing program is not named: {said}")
    said = asperity("simulate", place / "built_in.json", "--study", place / "none", "--participants", 1, "--seed", 1,
                    "--external", example, status=1)
    expect("takes no levels from an external program" in said, f"a program without use is accepted: {said}")

    simulate("stated")
    simulate("computed", "built_in")
    expect(len(levels(place / "stated")) == 48, "there are not two tracks of twelve trials for each participant")
    expect(levels(place / "stated") == levels(place / "computed"), "the levels differ from those of the staircase")
    simulate("jobs", "external", "--jobs", 2)
    expect(levels(place / "jobs") == levels(place / "stated"), "the levels depend on the number of jobs")

    # Killed at its fifth, thirtieth and fortieth trial.
    arguments = [PROGRAM, "simulate", place / "external.json", "--study", place / "killed", "--participants", "2",
                 "--seed", "5", "--recordings", "none", "--external", example]
    for count in (5, 25, 10):
        running = subprocess.Popen([*map(str, arguments)], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        done = 0
        for line in running.stderr:
            done += line.startswith("done ")
            if done == count:
                break
        running.send_signal(signal.SIGKILL)
        running.wait()
        running.stderr.close()
        if "--resume" not in arguments:
            arguments.append("--resume")
    simulate("killed", "external", "--resume")
    expect(levels(place / "killed") == levels(place / "stated"), "after kills the levels are others")

    # Without the program the study can be used.
    example.unlink()
    for study in ("stated", "killed"):
        said = asperity("verify", place / study)
        expect("levels of an external program, as stored" in said and "2 sessions" in said,
               f"verify does not state that levels were read: {said}")
    asperity("analyze", place / "stated")
    asperity("export", place / "stated", "--out", place / "tables")
    if "report" in asperity("--help"):
        asperity("report", place / "stated", "--out", place / "report.html")
        said = (place / "report.html").read_text(encoding="utf-8")
        expect("staircase.py (SHA-256" in said, "the report does not name the program")
        expect("stated levels in 2 sessions" in said, "the report does not state the sessions of the program")

        # A program that fails before its first statement has stated no levels.
        example.write_text("#!/usr/bin/env python3\nraise SystemExit('not installed')\n", encoding="utf-8")
        example.chmod(0o755)
        said = simulate("failed", "external", "--jobs", 1, status=1)
        expect("not installed" in said, f"the failure of the program is not stated: {said}")
        asperity("report", place / "failed", "--out", place / "failed.html")
        said = (place / "failed.html").read_text(encoding="utf-8")
        expect("An external program failed once." in said, "the report does not state the failure of the program")
        expect("stated levels" not in said, "the report states levels of a program that stated none")
    asperity("copy", place / "stated", place / "copy")
    asperity("verify", place / "copy")
