#!/usr/bin/env python3
"""asperity power: assumptions, also of a study, simulated studies that are kept, extended and divided, refusals. Argument: the program asperity."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
PROTOCOL = ROOT / "protocols" / "library" / "amplitude_jnd.json"
EFFECT = "comparisons.rougher.order"
STATED = ("--effect", "order=0.5,null", "--assume", "order_sd=0.3")


def power(*arguments):
    return subprocess.run([PROGRAM, "power", PROTOCOL, *map(str, arguments)], text=True, capture_output=True, check=False)


def done(*arguments):
    result = power(*arguments)
    assert result.returncode == 0, result.stderr
    return result


def refused(status, sentence, *arguments):
    result = power(*arguments)
    assert result.returncode == status and sentence in result.stderr, (status, sentence, result)


def new_study(folder):
    subprocess.run([PROGRAM, "new", folder], check=True, capture_output=True)
    return folder


def simulated(folder, runs, *arguments):
    return done("--participants", "4:6:2", "--seed", 3, "--runs", runs, *STATED, "--out", folder, *arguments)


listed = {entry["name"]: entry for entry in json.loads(done("--list-assumptions").stdout)}
assert listed[EFFECT]["part"] == "effect" and listed[EFFECT]["value"] is None, listed[EFFECT]
assert listed[EFFECT + "_sd"]["value"] is None, listed[EFFECT + "_sd"]

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    whole, grown = folder / "whole", folder / "grown"
    json_text = simulated(whole, 6, "--jobs", 1, "--json", "--dropout", 0.2).stdout
    document = json.loads(json_text)
    assert document["format"] == "asperity.power/1" and document["runs"] == 6, document
    # Two effects and two numbers of participants; a row for each test and one for the family.
    rows = document["power"]
    tests = {(row["family"], row["test"]) for row in rows}
    assert len(rows) == 4 * len(tests) and all(row["studies"] == 6 for row in rows), rows
    assert {row["effect"] for row in rows} == {f"{EFFECT}=0.5", f"{EFFECT}=0"}, rows
    assert len((whole / "studies.tsv").read_text().splitlines()) == 1 + 6 * 4 * len(tests)
    statements = document["statements"]
    assert [statement["power"] for statement in statements] == [0.8, 0.9], statements
    for statement in statements:
        for part in (f"{EFFECT} = 0.5 d′ (", "; without an effect 0 d′; source: stated by the researcher as the smallest effect of interest)",
                     "one-sided (\"order" if "one-sided" in statement["text"] else "two-sided (\"order", "at α = .05, uncorrected",
                     "the power is estimated at", "95 % Monte-Carlo CI [", "6 simulated studies for each number",
                     f"{EFFECT}_sd = 0.3 d′ (SD over participants of this order effect; source: stated by the researcher)"):
            assert part in statement["text"], (part, statement)
    for row in document["sample_size"]:
        assert all(row[key] is None or isinstance(row[key], int) for key in ("participants", "participants_low", "participants_high", "planned")), row
    assert {path.name for path in whole.iterdir()} == {"studies.tsv", "studies.tsv.json", "power.tsv", "sample_size.tsv", "assumptions.json"}

    simulated(grown, 2, "--jobs", 2)
    plot = ("--plot", folder / "power.svg") if "--plot" in done("--help").stdout else ()
    printed = simulated(grown, 6, "--jobs", 2, *plot).stdout
    assert not plot or plot[1].stat().st_size > 0
    assert max(map(len, printed.splitlines())) <= 100, printed
    if plot:
        # Runs are added to the command's own result, and its figure is replaced; one that has been changed since is not.
        plot[1].unlink()
        figures = folder / "figures"
        for runs in (1, 2):
            simulated(figures, runs, *plot)
        drawn = plot[1].read_bytes()
        plot[1].write_text("changed", encoding="utf-8")
        refused(1, "power.svg", "--participants", "4:6:2", "--seed", 3, "--runs", 3, *STATED, "--out", figures, *plot)
        simulated(figures, 2, *plot, "--force")
        assert plot[1].read_bytes() == drawn
        refused(1, "power.svg", "--participants", "4:6:2", "--seed", 3, "--runs", 2, *STATED, "--out", folder / "another", *plot)
    assert (grown / "studies.tsv").read_bytes() == (whole / "studies.tsv").read_bytes()
    assert "min a session" in printed and f"{EFFECT}_sd" in printed, printed

    # In shards: the same bytes, with which the undivided command goes to its end.
    divided = folder / "divided"
    parts = [divided / f"studies.tsv.shard-{k}-of-2" for k in (1, 2)]
    said = [simulated(divided, 6, "--shard", f"{k}/2", "--jobs", 1).stdout for k in (1, 2)]
    assert said == [f"{part}: shard {k}/2, 3 runs of 6\n" for k, part in enumerate(parts, 1)], said
    assert "already simulated" in simulated(divided, 6, "--shard", "1/2").stdout
    joined = subprocess.run([PROGRAM, "gather", *reversed(parts), "--out", divided / "studies.tsv"], text=True, capture_output=True, check=True)
    assert f"{6 * 4 * len(tests)} rows of power, from 2 shards" in joined.stdout, joined.stdout
    for name in ("studies.tsv", "studies.tsv.json"):
        assert (divided / name).read_bytes() == (whole / name).read_bytes(), name
    assert simulated(divided, 6, "--dropout", 0.2, "--json", "--jobs", 1).stdout == json_text
    refused(2, "--shard needs --out", "--participants", 4, "--seed", 3, *STATED, "--shard", "1/2")

    refused(1, "which differ in the seed; repeat the command with the same inputs", "--participants", "4:6:2", "--seed", 4, "--runs", 6,
            *STATED, "--out", grown)
    done("--participants", "4:6:2", "--seed", 4, "--runs", 2, *STATED, "--out", grown, "--force")

    # The list of assumptions, with the missing values, is a file of assumptions; a value from a pilot is marked.
    for name, value in ((EFFECT, 0.5), (EFFECT + "_sd", 0.3)):
        listed[name].update(value=value, source="pilot of 8 participants")
    stated = folder / "assumptions.json"
    stated.write_text(json.dumps(list(listed.values())), encoding="utf-8")
    marked = done("--participants", 4, "--seed", 3, "--runs", 2, "--assumptions", stated)
    assert f"the effect {EFFECT} is taken from a pilot (pilot of 8 participants)" in marked.stderr, marked.stderr

    # A simulated study shows everything but the effect; what is stated has precedence.
    study = new_study(folder / "simulated pilot")
    subprocess.run([PROGRAM, "simulate", PROTOCOL, "--study", study, "--participants", "2", "--seed", "1", "--recordings", "none"], check=True,
                   capture_output=True)
    result = done("--calibrate", f"{study}/", "--assume", "lapse=0.05", "--list-assumptions")
    calibrated = {entry["name"]: entry for entry in json.loads(result.stdout)}
    threshold = calibrated["comparisons.rougher.threshold"]
    assert threshold["source"] == "simulated study simulated pilot, 2 participants", threshold
    # The geometric mean of the JNDs at d′ = 1 that asperity analyze states, 13.9 µm and 9.55 µm.
    assert math.isclose(threshold["value"], 11.5e-6, rel_tol=0.1), threshold
    assert not math.isclose(listed[threshold["name"]]["value"], 11.5e-6, rel_tol=0.1), listed[threshold["name"]]
    assert calibrated[EFFECT]["value"] is None, calibrated[EFFECT]
    assert calibrated["comparisons.rougher.lapse"]["source"] == "stated by the researcher", calibrated["comparisons.rougher.lapse"]
    assert f"taken from the study {study}/: " in result.stderr and threshold["name"] in result.stderr, result.stderr
    refused(1, "has no responses to the protocol", "--calibrate", new_study(folder / "empty"), "--list-assumptions")

# On the full physics: two and three participants, a staircase of a few trials. The effects are those of the observers.
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    short = json.loads(PROTOCOL.read_text(encoding="utf-8"))
    del short["blocks"]["practice"]
    short["flow"] = [step for step in short["flow"] if step.get("run") != "practice"]
    short.pop("resume", None)
    short["blocks"]["comparisons"]["procedure"]["stop"] = {"trials": 8}
    del short["blocks"]["comparisons"]["procedure"]["catch_trials"]
    protocol = folder / "short.json"
    protocol.write_text(json.dumps(short), encoding="utf-8")
    said = ("--participants", "2,3", "--seed", 3, "--runs", 2, "--physics")
    whole, divided = folder / "whole", folder / "divided"

    def on_physics(*arguments):
        result = subprocess.run([PROGRAM, "power", protocol, *map(str, said + arguments)], text=True, capture_output=True, check=False)
        assert result.returncode == 0, result.stderr
        return result.stdout

    json_text = on_physics("--out", whole, "--jobs", 1, "--json")
    document = json.loads(json_text)
    assert document["responses"] == "physics" and document["runs"] == 2, document
    assert {(row["effect"], row["participants"], row["studies"]) for row in document["power"]} == {
        ("virtual observers", 2, 2), ("virtual observers", 3, 2)}, document["power"]
    assert {path.name for path in whole.iterdir()} == {"studies.tsv", "studies.tsv.json", "power.tsv", "sample_size.tsv"}
    for k in (1, 2):
        on_physics("--out", divided, "--shard", f"{k}/2", "--jobs", 2)
    subprocess.run([PROGRAM, "gather", *divided.glob("*shard*"), "--out", divided / "studies.tsv"], check=True, capture_output=True)
    assert (divided / "studies.tsv").read_bytes() == (whole / "studies.tsv").read_bytes()
    assert on_physics("--out", divided, "--json") == json_text
    assert "virtual observers on the full physics" in on_physics("--out", divided)

for option in (("--effect", "order=0.5"), ("--assume", "order_sd=0.3"), ("--calibrate", "study"), ("--assumptions", "file"),
               ("--list-assumptions",), ("--effect-source", "pilot"), ("--assume-source", "Smith 2020")):
    refused(2, f"{option[0]} belongs to response tables and has no effect with --physics", "--participants", 4, "--seed", 3, "--physics", *option)
refused(2, "add --physics", "--participants", 4, "--seed", 3, *STATED, "--study", "study")

refused(1, f"{EFFECT} has no value", "--participants", 4, "--seed", 3, "--assume", "order_sd=0.3")
refused(2, f"its effects are {EFFECT} (d′)", "--participants", 4, "--seed", 3, "--effect", "difference=1")
refused(2, "write NAME=VALUE", "--participants", 4, "--seed", 3, "--effect", "order")
refused(2, "--assume ordre_sd=1", "--participants", 4, "--seed", 3, "--assume", "ordre_sd=1")
sourced = {entry["name"]: entry for entry in json.loads(done("--assume", "order_sd=0.3", "--assume-source", "Smith 2020", "--list-assumptions").stdout)}
assert sourced[EFFECT + "_sd"]["source"] == "Smith 2020", sourced[EFFECT + "_sd"]
refused(2, "write FROM:TO:STEP", "--participants", "6:4:2", "--seed", 3, *STATED)
refused(2, "requires --participants and --seed", "--participants", 4)
