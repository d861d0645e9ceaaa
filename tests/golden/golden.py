#!/usr/bin/env python3
"""Compares the results of made-up studies with the stored ones, or stores them again.

Usage: golden.py check PROGRAM MAKER PROTOCOL [without-report]
       golden.py check-simulated PROGRAM
       golden.py write PROGRAM MAKER [PROTOCOL…]

PROGRAM is asperity, MAKER asperity_golden_study; the form of the files is described in README.md. "check" prints what
differs and ends with status 1; "check-simulated" does so for the simulated studies of all kinds. "write" replaces the files of all
library protocols or of those named, and prints what changed."""
import concurrent.futures
import difflib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import golden_texts

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / "tests" / "golden" / "results"
LIBRARY = ROOT / "protocols" / "library"
COMMON = "common.tsv"
# One protocol of each kind is simulated: the one whose text these changes shorten, or else the first. The demo study has its stimuli.
SHORTENED = {"roughness_in_pairs": {'"repetitions": 3': '"repetitions": 1'},
             "roughness_of_photographs": {'"repetitions": 6': '"repetitions": 1'},
             "roughness_speed": {'"repetitions": 3': '"repetitions": 1', '"repetitions": 2': '"repetitions": 1', "0.000045": "0.00025"}}
RELATIVE, ABSOLUTE = 1e-9, 1e-14
# Of findings that an iterative fit ends with where the likelihood is flat, by the beginning of their quantity: they differ that much
# between mathematical libraries (glibc with and without the instructions FMA and AVX2).
RELATIVE_OF_FITS = {"fit.detection.": 1e-4, "glmm.": 1e-6}
RELATIVE_OF_SIMULATED, ABSOLUTE_OF_SIMULATED = 1e-6, 1e-12  # the servo loop accumulates differences of mathematical libraries
NUMBER = re.compile(r"(?<![\w.])[-−+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]*\w)")
LONGEST_REPORT = 40  # differences of a file that are printed
LONGEST_TEXT = 240  # characters of a line that are printed


def run(*command):
    made = subprocess.run([*map(str, command)], encoding="utf-8", capture_output=True, check=False)
    if made.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {made.returncode}:\n{made.stdout}{made.stderr}")
    return made.stdout


def results_of(program, maker, protocol, with_report):
    """File name → lines of the golden file; and the lines that protocols have in common."""
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        study, report, export = (pathlib.Path(folder) / name for name in ("study", "report.html", "export"))
        run(maker, protocol, study)
        analysis = json.loads(golden_texts.mask(run(program, "analyze", study, "--json"), study))
        lines = {"analysis.txt": list(golden_texts.analysis_lines(analysis))}
        if with_report:
            run(program, "report", study, "--out", report)
            lines["report.html"] = list(golden_texts.report_lines(golden_texts.mask(report.read_text(encoding="utf-8"), study)))
        run(program, "export", study, "--out", export)
        lines["export.txt"] = list(golden_texts.export_lines(export, study))
        return lines, golden_texts.common_lines(export, study)


def simulated():
    """The protocols that are simulated."""
    of_kind = {}
    for protocol, kind in sorted(library().items(), key=lambda entry: (entry[0] not in SHORTENED, entry)):
        of_kind.setdefault(kind, protocol)
    return sorted(of_kind.values())


def simulated_results(program, protocols):
    """Protocol → lines of the golden file of a session of one virtual participant."""
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        demo = pathlib.Path(folder) / "demo"
        run(program, "new", demo, "--demo")

        def lines_of_protocol(protocol):
            study, export = (pathlib.Path(folder) / f"{protocol}{end}" for end in ("", "-export"))
            shutil.copytree(demo, study)
            file = study / "protocols" / f"{protocol}.json"
            text = (LIBRARY / file.name).read_text(encoding="utf-8")
            for before, after in SHORTENED.get(protocol, {}).items():
                if before not in text:
                    sys.exit(f"The protocol {protocol} no longer has the text {before} that SHORTENED in tests/golden/golden.py replaces.")
                text = text.replace(before, after)
            file.write_text(text, encoding="utf-8")
            run(program, "simulate", file, "--study", study, "--participants", 1, "--seed", 1, "--jobs", 1,
                "--recordings", "none")
            run(program, "export", study, "--out", export)
            return list(golden_texts.simulated_lines(export))

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return dict(zip(protocols, pool.map(lines_of_protocol, protocols), strict=True))


def is_same(stored, now, relative, absolute):
    """Byte for byte, and the same numbers within the tolerance."""
    if stored == now:
        return True
    if NUMBER.split(stored) != NUMBER.split(now):
        return False
    for one, other in zip(NUMBER.findall(stored), NUMBER.findall(now), strict=True):
        one, other = float(one.replace("−", "-")), float(other.replace("−", "-"))
        if abs(one - other) > max(absolute, relative * max(abs(one), abs(other))):
            return False
    return True


def around(text, other):
    """A long line is shown from shortly before the first difference to the other one."""
    first = len(os.path.commonprefix([text, other]))
    start = 0 if len(text) <= LONGEST_TEXT else max(0, first - LONGEST_TEXT // 3)
    return ("…" if start else "") + text[start:start + LONGEST_TEXT] + ("…" if start + LONGEST_TEXT < len(text) else "")


def differences(name, stored, now, relative=RELATIVE, absolute=ABSOLUTE):
    """What changed, with the file, the line and both texts; empty where every line is the same."""
    if len(stored) == len(now):
        same, tolerance = [], relative
        for before, after in zip(stored, now, strict=True):
            if not before.startswith("  "):
                fits = [of_fit for quantity, of_fit in RELATIVE_OF_FITS.items()
                        if before.startswith("findings ") and before.split(" | ")[1].startswith(quantity)]
                tolerance = max([relative, *fits])
            same.append(before if is_same(before, after, tolerance, absolute) else after)
        now = same
    if not stored:
        return [f"{name}: {len(now)} lines, which are not stored yet"]
    found = []
    for what, start, end, now_start, now_end in difflib.SequenceMatcher(None, stored, now, autojunk=False).get_opcodes():
        if what == "equal":
            continue
        for step in range(max(end - start, now_end - now_start)):
            before = stored[start + step] if start + step < end else None
            after = now[now_start + step] if now_start + step < now_end else None
            found.append(f"{name}:{min(start + step, end) + 1}"
                         + (f"\n  stored: {around(before, after or '')}" if before is not None else "\n  stored: no such line")
                         + (f"\n  now:    {around(after, before or '')}" if after is not None else "\n  now:    no such line"))
    left = len(found) - LONGEST_REPORT
    return found[:LONGEST_REPORT] + ([f"{name}: … and {left} lines more"] if left > 0 else [])


def lines_of(path):
    return path.read_text(encoding="utf-8").splitlines() if path.exists() else []


def name_of(path):
    return path.relative_to(ROOT).as_posix()


def library():
    """Name → kind."""
    files = sorted(LIBRARY.glob("*.json"))
    return {path.stem: json.loads(path.read_text(encoding="utf-8"))["kind"] for path in files if "." not in path.stem}


def end_with(found, what):
    if found:
        print("\n".join(found))
        sys.exit(f"The results of {what} are not the stored ones. If the change is meant, run\n  scripts/golden\n"
                 "or scripts/golden with the names of protocols, review what it prints, and commit the files as a separate change.")


def check(program, maker, protocol, *options):
    files, common = results_of(program, maker, protocol, "without-report" not in options)
    found = []
    for name, lines in files.items():
        path = RESULTS / protocol / name
        found += differences(name_of(path), lines_of(path), lines)
    known = set(lines_of(RESULTS / COMMON))
    found += [f"{name_of(RESULTS / COMMON)} has no line: {line}" for line in sorted(common) if line not in known]
    end_with(found, f"the protocol {protocol}")


def check_simulated(program):
    found = []
    for protocol, lines in simulated_results(program, simulated()).items():
        path = RESULTS / protocol / "simulated.txt"
        found += differences(name_of(path), lines_of(path), lines, RELATIVE_OF_SIMULATED, ABSOLUTE_OF_SIMULATED)
    end_with(found, "simulated sessions")


def write(program, maker, *protocols):
    known = library()
    unknown = sorted(set(protocols) - set(known))
    if unknown:
        sys.exit(f"The library has no protocol {', '.join(unknown)}; it has {', '.join(known)}.")
    chosen = list(protocols) or list(known)
    common = set(lines_of(RESULTS / COMMON)) if protocols else set()
    found = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        made = pool.map(lambda protocol: results_of(program, maker, protocol, True), chosen)
        # Each as soon as it is made: what is interrupted keeps what was stored.
        for protocol, (files, lines) in zip(chosen, made, strict=True):
            common |= lines
            for name, now in files.items():
                found += replace(RESULTS / protocol / name, now)
    found += replace(RESULTS / COMMON, sorted(common))
    for protocol, now in simulated_results(program, [name for name in simulated() if name in chosen]).items():
        found += replace(RESULTS / protocol / "simulated.txt", now, RELATIVE_OF_SIMULATED, ABSOLUTE_OF_SIMULATED)
    if not protocols:
        for folder in sorted(path for path in RESULTS.iterdir() if path.is_dir() and path.name not in known):
            found.append(f"{name_of(folder)}: the library has no such protocol; remove the folder")
    print("\n".join([*found, f"{len({place.split(':')[0] for place in found})} files changed."] if found else ["Nothing changed."]))


def replace(path, lines, *tolerance):
    """What changed. A file whose numbers are the same within the tolerance is left as it is."""
    found = differences(name_of(path), lines_of(path), lines, *tolerance)
    if found:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return found


if __name__ == "__main__":
    actions = {"check": (check, 3), "check-simulated": (check_simulated, 1), "write": (write, 2)}
    action, least = actions.get(sys.argv[1] if len(sys.argv) > 1 else "", (None, 0))
    if action is None or len(sys.argv) - 2 < least:
        sys.exit(__doc__)
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stderr.reconfigure(encoding="utf-8")
    action(*sys.argv[2:])
