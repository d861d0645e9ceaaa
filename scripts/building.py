"""Builds what a script of this folder runs."""
import pathlib
import subprocess

SCRIPTS = pathlib.Path(__file__).resolve().parent


def built(target):
    """The path of a program that needs the tests' packages, after it was built (building.sh)."""
    subprocess.run(["bash", "-c", f'source "{SCRIPTS}/building.sh"; build_with_tests {target}'], check=True)
    return str(SCRIPTS.parent / "build" / "release" / "bin" / target)
