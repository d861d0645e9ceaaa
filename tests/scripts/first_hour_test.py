#!/usr/bin/env python3
"""What docs/first-hour.md has a reader bake and render works as written, and its numbers are those that the program prints.

Argument: the program asperity.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = shlex.quote(str(pathlib.Path(sys.argv[1]).resolve()))
page = (ROOT / "docs/first-hour.md").read_text(encoding="utf-8")
commands = next(block for block in re.findall(r"```sh\n(.*?)```", page, re.DOTALL) if "scripts/run bake" in block)
stated = page.split(commands)[1].split("\n\n")[1]

with tempfile.TemporaryDirectory() as folder:
    done = subprocess.run(["sh", "-e", "-c", commands.replace("scripts/run", PROGRAM)], cwd=folder, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done
    rows = [line.split("\t") for line in (pathlib.Path(folder) / "forces.tsv").read_text(encoding="utf-8").splitlines()]

before, after = re.search(r"ball.mesh: (\d+) → (\d+) triangles", done.stdout).groups()
without, textured = re.findall(r"texture: RMS ([0-9.]+) µm", done.stdout)
up = rows[0].index("fz_N")
pressed = [float(row[up]) for row in rows[501:]]
force = f"{sum(pressed) / len(pressed):.2f} N"
for number in (f"{before[:-3]} {before[-3:]}", f" {after} ", f"{without} µm", f"{textured} µm", f"{len(rows) - 1} rows", force):
    assert number in stated, (number, stated)
assert "limit" not in done.stdout + done.stderr, done
