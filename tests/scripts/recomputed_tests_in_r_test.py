#!/usr/bin/env python3
"""Every number of a study's tables of tests is recomputed in R, from the exported tables and what the protocols declare.
Arguments: the program asperity and, in place of the studies below, folders of studies. Needs R (r-base-core) and nothing else of
R's.

The studies are one of virtual participants and that in tests/earlier_studies; no two conditions of theirs have interior maxima whose
ratio is tested. Where the program draws permutations at random, its p lies within what these draws allow of the p over all
permutations, which R counts."""
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
TOLERANCE = 1e-6
# How many standard errors a proportion of random permutations may be off; they are drawn with a fixed seed.
MOST_ERRORS = 4
NUMBERS = ("value", "df1", "df2", "effect", "effect_low", "effect_high", "n", "left_out", "p", "p_holm", "p_smallest")
# The kinds that are recomputed, with the family of a protocol that declares none (docs/authoring-protocols.md).
USUAL_FAMILY = {"selection": "pairs", "matching": "items", "recognition": "right", "magnitude": "spacing"}
PRESENT = ROOT / "tests/earlier_studies/present/study"
# With so many participants the program draws the groups of matching at random, and of no other test.
PARTICIPANTS = {"chapter_selection": 20, "chapter_matching": 26, "chapter_recognition": 22, "roughness_force": 8}


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True).stdout


def write_declarations(study, path):
    with open(path, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(("protocol", "family", "target", "condition", "conditions"))
        for source in sorted((study / "protocols").glob("*.json")):
            if "." in source.stem:  # a translation
                continue
            protocol = json.loads(source.read_text(encoding="utf-8"))
            if protocol["kind"] not in USUAL_FAMILY:
                continue
            analysis = protocol.get("analysis", {})
            family = analysis.get("family", [USUAL_FAMILY[protocol["kind"]]])
            condition = protocol.get("estimation", {}).get("condition", "")
            conditions = protocol["factors"][condition]["levels"] if condition else []
            rows.writerow((protocol["name"], ";".join(family), analysis.get("target", ""), condition,
                           ";".join(map(str, conditions))))


def recomputed(study, folder):
    """(protocol, group, test, about, column) -> number"""
    asperity("export", study, "--out", folder / "out", "--formats", "none")
    write_declarations(study, folder / "declared.csv")
    subprocess.run(["Rscript", "--vanilla", ROOT / "tests/scripts/recomputed_tests.R", folder / "out",
                    folder / "declared.csv", folder / "results.csv"], check=True)
    with open(folder / "results.csv", encoding="utf-8", newline="") as file:
        return {(row["protocol"], row["group"], row["test"], row["about"], row["quantity"]): float(row["value"])
                for row in csv.DictReader(file)}


def allowed_error(of_p, draws):
    """Of a p by random permutations, the observed one among them."""
    return MOST_ERRORS * math.sqrt(of_p * (1 - of_p) / draws) + 1 / draws if draws else 0.0


def check_study(study, folder):
    ours, compared, drawn = recomputed(study, folder), set(), 0
    for outcome in json.loads(asperity("analyze", study, "--json"))["outcomes"]:
        if outcome["kind"] not in USUAL_FAMILY:
            continue
        rows = next((table["rows"] for table in outcome["tables"] if table["name"] == "tests"), [])
        in_family = sum(bool(row["family"]) for row in rows)
        for row in rows:
            draws = 0 if row["permutations"] in (None, "exact") else int(row["permutations"])
            drawn += bool(draws)
            about = " / ".join(row[name] for name in ("about", "first", "second") if row[name])
            for column in NUMBERS:
                place = (outcome["protocol"], outcome["group"], row["test"], about, column)
                if row["p"] is None:
                    assert row[column] is None or column in ("n", "left_out"), place
                    continue
                assert (row[column] is None) == (place not in ours), (place, row[column], ours.get(place))
                if row[column] is None:
                    continue
                allowed = TOLERANCE * max(1.0, abs(row[column]))
                if column in ("p", "p_holm"):
                    allowed += allowed_error(ours[place[:4] + ("p",)], draws) * (1 if column == "p" else in_family)
                elif column == "p_smallest":
                    allowed += allowed_error(row[column], draws)
                assert abs(ours[place] - row[column]) <= allowed, (place, ours[place], row[column])
                compared.add(place)
    tested = {place[:4] for place in compared}
    missing = {place for place in ours if place[:4] not in tested}
    assert not missing, missing
    return len(compared), drawn


def demonstration(folder):
    """The demonstration's study and the short magnitude estimation of the study in tests/earlier_studies."""
    study = folder / "study"
    asperity("new", study, "--demo")
    for picture in (PRESENT / "stimuli").glob("cones_*"):
        shutil.copyfile(picture, study / "stimuli" / picture.name)
    shutil.copyfile(PRESENT / "protocols/roughness_force.json", study / "protocols/roughness_force.json")
    for name, participants in PARTICIPANTS.items():
        protocol = study / "protocols" / f"{name}.json"
        if not protocol.exists():
            shutil.copyfile(ROOT / "protocols/library" / protocol.name, protocol)
        asperity("simulate", protocol, "--study", study, "--participants", participants, "--seed", 5, "--recordings", "none")
    return study


def copy_of(study, folder):
    shutil.copytree(study, folder / "study", copy_function=shutil.copyfile)
    return folder / "study"


def main():
    report = []
    for name in sys.argv[2:] or ("demonstration", PRESENT):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            study = demonstration(folder) if name == "demonstration" else copy_of(name, folder)
            numbers, drawn = check_study(study, folder)
            assert numbers > 0, name
            report.append(f"{numbers} of {name}" + (f" ({drawn} test by random permutations)" if drawn else ""))
    print("numbers of tables of tests that R agrees with: " + ", ".join(report))


main()
