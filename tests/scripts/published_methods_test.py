#!/usr/bin/env python3
"""The commands of docs/seeds.md that render work as written and show what their rows claim. Usage: … asperity"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = shlex.quote(str(pathlib.Path(sys.argv[1]).resolve()))
page = (ROOT / "docs/seeds.md").read_text(encoding="utf-8")
block = re.search(r"```sh\n(.*?)```", page, re.DOTALL).group(1)
preparation = block.replace("asperity new study --demo\n", "").replace("asperity ", PROGRAM + " ")
# Without a study, a GPU or a file of the reader's; a sweep or a benchmark takes minutes.
commands = [command for command in re.findall(r"`asperity ((?:render|texture-recording) [^`]*)`", page)
            if not re.search(r"study/|MESH|--compute gpu", command)]

with tempfile.TemporaryDirectory() as place:
    def output_of(command: str) -> str:
        done = subprocess.run(["sh", "-e", "-c", command], cwd=place, text=True, capture_output=True, check=False)
        assert done.returncode == 0, (command, done.stderr)
        return done.stdout + done.stderr

    def column(name: str, heading: str) -> list[float]:
        rows = [line.split("\t") for line in (pathlib.Path(place) / name).read_text(encoding="utf-8").splitlines()]
        return [float(row[rows[0].index(heading)]) for row in rows[1:]]

    output_of(preparation)
    printed = {command: output_of(f"{PROGRAM} {command}") for command in commands}
    up_N = column("s7.tsv", "fz_N")[600:]

assert len(commands) >= 14, commands

# s7: a box that rests on whole crests would be pressed by the same force whatever its angle.
assert max(up_N) - min(up_N) > 0.01, (min(up_N), max(up_N))

# s11: what is rendered is what the fit prints, rounded as it is written.
fit = json.loads("{" + re.search(r"auto_regressive: (.*)", printed["texture-recording --relief wave.png --out s11.tsv"]).group(1) + "}")
(rendering,) = (command for command in commands if "auto_regressive" in command)
fitted = {name: value for name, value in fit["parameters"].items() if value != 0}
written = dict(part.split("=") for part in re.findall(r"--param (\S+)", rendering))
assert fitted.keys() == written.keys(), (fitted, written)
for name, value in written.items():
    assert abs(float(value) / fitted[name] - 1) < 5e-4, (name, value, fitted[name])

# s23: the contact stays within the model's small strains.
(pressing,) = (command for command in commands if "elastic_halfspace" in command)
assert "large_strain" not in printed[pressing], printed[pressing]
