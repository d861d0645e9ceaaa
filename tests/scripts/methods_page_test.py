#!/usr/bin/env python3
"""docs/methods.md has a row for every library protocol, with the trials and minutes that `check` states, and with analyses that exist.

An analysis exists if a study of the protocol (tests/golden/results) has its number. Argument: the program asperity.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
STUDIES = ROOT / "tests" / "golden" / "results"
# The analyses in the words of the page, and the quantity of each in the findings of a study.
QUANTITIES = {
    "psychometric function": "fit.alpha",
    "JND": "jnd",
    "Weber fraction": "weber",
    "order effect": "order.difference",
    "with the posterior threshold and its credible interval": "jnd.posterior",
    "for the Young's modulus of a soft body": "jnd",
    "with the effect of the side": "order.difference",
    "d′ of each level by both decision rules": "dprime.io",
    "criterion": "k.diff",
    "JND at d′ = 1": "jnd.dprime1",
    "geometric means": "geomean",
    "exponent": "exponent.mean",
    "peak of the log-quadratic function": "quad.coef",
    "means with intervals": "mean.score",
    "ICC": "icc",
    "analysis of variance": "pes",
    "log odds ratios": "logodds",
    "principal components": "proportion",
    "Cronbach's α of constructs": "cronbach.alpha",
    "reliability over repetitions": "icc.mean",
    "non-metric multidimensional scaling": "stress.ordinal",
    "number of dimensions by cross-validation": "cv.chosen",
    "INDSCAL": "indscal.fit",
    "dendrogram": "hclust.average.height",
    "measured properties (PROTEST)": "protest.r2",
    "tests per pair": "signflip.p.two",
    "Bradley–Terry scale with order effect and ties": "bt.order.beta",
    "circular triads": "mean.zeta",
    "relative amplitudes of equal roughness": "relative_amplitude",
    "proportions of choices": "prop",
    "permutation and sign-flip tests": "signflip.p.two",
    "Plackett–Luce scale": "luce.logworth",
    "logistic mixed model of the choices of the target": "glmm.status",
    "proportion correct": "pc",
    "confusion matrix": "confusion",
    "information transfer": "IT.plugin",
    "proportion correct against chance": "prop.correct",
    "permutation test": "relabel.p.greater",
}


def rows(text):
    """Per library protocol: the kind, the trials and the minutes that its row states."""
    header = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if "library protocol" in cells:
            header = cells
        elif line.startswith("|") and header and len(cells) == len(header):
            row = dict(zip(header, cells))
            name = row["library protocol"].strip("`")
            if re.fullmatch(r"\w+", name):
                yield name, row
        elif not line.startswith("|"):
            header = []


def analyses(page):
    """Per library protocol: the analyses that its row states; "the same" stands for those of the last row without these words."""
    last = []
    for name, row in page.items():
        parts = re.split("[,;] ", row["analysis"])
        if parts[0] == "the same":
            parts[:1] = last
        else:
            last = parts
        yield name, parts


def quantities(name):
    """The quantities of the findings of a study of the protocol."""
    text = (STUDIES / name / "analysis.txt").read_text(encoding="utf-8")
    return set(re.findall(r"^findings \S+ \| (\S+) \|", text, re.MULTILINE))


def main():
    page = dict(rows((ROOT / "docs" / "methods.md").read_text(encoding="utf-8")))
    protocols = {path.stem: path for path in sorted((ROOT / "protocols" / "library").glob("*.json")) if "." not in path.stem}
    wrong = [f"{name}: docs/methods.md has no row for this library protocol" for name in protocols.keys() - page.keys()]
    wrong += [f"{name}: docs/methods.md has a row for it, and the library has no such protocol" for name in page.keys() - protocols.keys()]
    for name in protocols.keys() & page.keys():
        stated = subprocess.run([PROGRAM, "check", protocols[name]], text=True, capture_output=True, check=True).stdout
        trials = re.search(r"(\d+) trials?,", stated).group(1)
        minutes = re.search(r"about (\d+) min in all", stated).group(1)
        row = page[name]
        if (row["trials"], row["minutes"]) != (trials, minutes):
            wrong.append(f"{name}: docs/methods.md states {row['trials']} trials and {row['minutes']} min, "
                         f"check states {trials} trials and {minutes} min")
        kind = json.loads(protocols[name].read_text(encoding="utf-8"))["kind"]
        if f"`{kind}`" not in row["kind"]:
            wrong.append(f"{name}: docs/methods.md states the kind {row['kind']}, the protocol {kind}")
    for name, stated in analyses(page):
        found = quantities(name)
        wrong += [f"{name}: docs/methods.md states \"{part}\", and a study of it has no such number"
                  for part in stated if QUANTITIES.get(part) not in found]
    print("\n".join(sorted(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
