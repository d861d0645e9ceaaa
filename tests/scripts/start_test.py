#!/usr/bin/env python3
"""OpenCV's codecs are loaded when a picture is read or written, not before. Argument: the program asperity."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
HEAVY = ("libopencv_imgcodecs", "libgdal")
MOST_LIBRARIES = 130  # with the windows 95 on Debian 12, 119 on Debian 13; with the codecs there were 190


class Start(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_program(self, *arguments, program=PROGRAM, **environment):
        return subprocess.run([program, *arguments], text=True, capture_output=True, cwd=self.folder,
                              env={**os.environ, **environment}, timeout=120)

    def loaded_by(self, *arguments):
        result = self.run_program(*arguments, LD_DEBUG="files", LD_DEBUG_OUTPUT=self.folder / "loaded")
        self.assertEqual(result.returncode, 0, result.stderr)
        return "".join(file.read_text() for file in self.folder.glob("loaded.*"))

    def test_needs_no_codecs_without_a_picture(self):
        loaded = self.loaded_by("--version")
        self.assertIn("libopencv_core", loaded)  # the list is one of libraries
        for library in HEAVY:
            self.assertNotIn(library, loaded)
        self.assertLess(loaded.count("calling init:"), MOST_LIBRARIES)

    def test_loads_the_codecs_for_a_picture(self):
        loaded = self.loaded_by("synth", "sinusoid", "--out", "waves.png", "--pixels", "256")
        for library in HEAVY:
            self.assertIn(library, loaded)
        self.assertTrue((self.folder / "waves.png").read_bytes().startswith(b"\x89PNG"))

    def test_names_the_module_that_is_missing_and_the_remedy(self):
        alone = self.folder / "bin" / "asperity"
        alone.parent.mkdir()
        shutil.copy(PROGRAM, alone)
        result = self.run_program("synth", "sinusoid", "--out", "waves.png", "--pixels", "256", program=alone)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("picture_codecs.so cannot be loaded", result.stderr)
        self.assertIn("Install Asperity again", result.stderr)


if __name__ == "__main__":
    unittest.main()
