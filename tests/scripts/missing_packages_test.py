#!/usr/bin/env python3
"""What CMake says on a system on which libraries are missing: one sentence with the packages of Debian to install."""
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What compiles, runs or speeds up, and is not looked for by CMake itself.
TOOLS = {"g++", "cmake", "ninja-build", "mold", "ccache", "python3", "pocl-opencl-icd"}


def configured_without(packages, programs=()):
    """The error of a configuration, in one line, in which find_package and find_program do not find the given ones."""
    hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in packages]
    hidden += ["-DASPERITY_BUILD_TESTS=ON", *(f"-D{variable}=OFF" for variable in programs)]
    with tempfile.TemporaryDirectory() as folder:
        answer = subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *hidden],
                                text=True, capture_output=True, check=False)
    assert answer.returncode == 1, answer
    return " ".join(answer.stderr.split())


class MissingPackages(unittest.TestCase):
    def test_are_named_in_one_sentence_with_what_to_install(self):
        self.assertRegex(
            configured_without(["glm", "Hidapi"]),
            r"^CMake Error at CMakeLists\.txt:\d+ \(message\): Asperity needs the following, which was not found: "
            r"glm \(Debian: libglm-dev\), Hidapi 0\.13 \(Debian: libhidapi-dev\); on Debian 12 and 13 "
            r"`scripts/install build test` installs it, on other systems install the corresponding packages\.$")

    def test_are_those_that_are_installed_for_the_program_and_its_tests(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        packages = re.findall(r'asperity_need\("[^"]+" (\w+)', text) + re.findall(r"^ *find_package\((\w+) \d", text, re.M)
        programs = re.findall(r"asperity_note_if_missing\(([A-Z_]+) ", text)
        named = re.findall(r"\(Debian: ([^)]+)\)", configured_without(packages, programs))
        listed = re.findall(r"^(?:build|test) (\S+)$", (ROOT / "scripts" / "packages").read_text(), re.M)
        self.assertEqual({package for some in named for package in some.split()}, set(listed) - TOOLS)


if __name__ == "__main__":
    unittest.main()
