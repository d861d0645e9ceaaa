#!/usr/bin/env python3
"""scripts/run and scripts/test share a build: the command that compiles a source of the product is the same with and without tests,
and has the assertions of the standard library."""
import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def commands(folder, tests):
    subprocess.run(["cmake", "--preset", "release", "-B", folder, f"-DASPERITY_BUILD_TESTS={tests}"], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    return {entry["file"].replace(str(folder), ""): entry["command"].replace(str(folder), "")
            for entry in json.loads((folder / "compile_commands.json").read_text(encoding="utf-8"))}


with tempfile.TemporaryDirectory() as place:
    product = commands(pathlib.Path(place) / "program", "OFF")
    everything = commands(pathlib.Path(place) / "tests", "ON")
assert len(product) > 100, len(product)
different = [source for source, command in product.items() if everything.get(source) != command]
assert not different, f"{len(different)} of {len(product)} sources would be compiled again: {different[:5]}"
unlike = [source for source, command in product.items() if "-D_GLIBCXX_ASSERTIONS" not in command or "NDEBUG" in command]
assert not unlike, f"{len(unlike)} of {len(product)} sources are compiled without assertions: {unlike[:5]}"
print(f"{len(product)} sources of the product have assertions and the same command with and without tests")
