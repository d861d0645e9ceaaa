#!/usr/bin/env python3
"""Every quantity that is read by name has a source that writes it, no name is compared or kept as a text that nothing checks, and a
misspelt name does not compile; the name of a column of a result stands in its declaration alone, and no cell of a table in the golden
results has parts. Argument: the compiler."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FINDINGS = ROOT / "app/findings"
DECLARED = FINDINGS / "tidy/quantity_name.h"
# QuantityName checks its literals. Texts do not.
UNCHECKED = re.compile(r'(?:[=!]= |(?:std::string|std::string_view|char\*)(?: const)?&? \w+(?: = |\{))(?:\w+ \? )?"([\w.]+)"')
COLUMN = re.compile(r"ResultColumn\s+k\w+\s*[{=][^;]*?;", re.S)
# Columns that have the name of a factor, a measure, an option or a quantity, which other sources read.
OTHER_NAMES = {"d_prime", "jnd_dprime1", "jnd_posterior", "left_out", "odds_ratio", "relative_amplitude", "spacing_m", "time_s"}


def sources(folder):
    return {path: path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*")) if path.suffix in (".cpp", ".h") and path != DECLARED}


def is_written(name, texts):
    """As a text, or as several that are joined at a point: PREFIX.status."""
    ends = [at for at, letter in enumerate(name) if letter == "."]
    return name in texts or any(start in texts and (name[at:] in texts or is_written(name[at + 1:], texts))
                                for at in ends for start in (name[:at], name[:at + 1]))


def compiles(name):
    source = f'#include "{DECLARED.relative_to(ROOT)}"\nconst asperity::QuantityName kName = "{name}";\n'
    return subprocess.run([sys.argv[1], "-std=c++20", "-fsyntax-only", "-I", ROOT, "-x", "c++", "-"], input=source, text=True,
                          capture_output=True, check=False)


def main():
    names = set(re.findall(r'"([\w.]+)"', DECLARED.read_text(encoding="utf-8").split("to_array")[1].split("});")[0]))
    writers = {path: text for path, text in sources(FINDINGS).items() if "FindingList" in text or ".quantity = " in text}
    texts = set(re.findall(r'"([\w.]*)"', "".join(writers.values())))
    wrong = [f"{DECLARED.relative_to(ROOT)}: nothing writes {name}; correct the name, or remove it" for name in sorted(names) if not is_written(name, texts)]
    for path, text in sources(ROOT / "app").items():
        wrong += [f"{path.relative_to(ROOT)}: \"{name}\" is not checked; take a QuantityName, or is(finding, \"{name}\")"
                  for name in UNCHECKED.findall(text) if name in names and "." in name]
    readers = {path: text for name in ("cli", "figures", "findings", "gui", "power", "report") for path, text in sources(ROOT / "app" / name).items()}
    columns = {name for text in readers.values() for declared in COLUMN.findall(text) for name in re.findall(r'\.id = "(\w+)"', declared)}
    for path, text in readers.items():
        wrong += [f"{path.relative_to(ROOT)}: \"{name}\" is the name of a column; take its declaration"
                  for name in re.findall(r'"(\w+)"', COLUMN.sub("", text)) if name in columns - OTHER_NAMES and "_" in name]
        wrong += [f"{path.relative_to(ROOT)}: a column is compared with \"{name}\"; take its declaration"
                  for name in re.findall(r'(?:\.id|\bcolumn) [=!]= "(\w+)"', text) if name in columns and "gui" not in path.parts]
    for path in sorted((ROOT / "tests/golden/results").glob("*/analysis.txt")):
        of_table = False
        for line in path.read_text(encoding="utf-8").splitlines():
            of_table = line.startswith("table ") if not line.startswith("  ") else of_table
            if of_table and "|" in line:
                wrong.append(f"{path.relative_to(ROOT)}: a cell has parts: {line.strip()}; give each a column")
    right, misspelt = compiles("dprime.mean"), compiles("dprime.maen")
    if right.returncode != 0:
        wrong.append(f"dprime.mean does not compile: {right.stderr}")
    if misspelt.returncode == 0 or "no_such_quantity" not in misspelt.stderr:
        wrong.append(f"dprime.maen, which is no quantity, compiles or fails for another reason: {misspelt.stderr}")
    print("\n".join(wrong) or f"{len(names)} quantities and {len(columns)} columns are read by a name that is checked")
    return 1 if wrong or not names else 0


sys.exit(main())
