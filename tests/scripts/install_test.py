#!/usr/bin/env python3
"""scripts/install against a pretended Debian: what it asks of apt-get, and when it does not."""
import os
import pathlib
import shutil
import stat
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Install(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.asked = self.folder / "asked"
        (self.folder / "scripts").mkdir()
        (self.folder / "bin").mkdir()
        shutil.copy(ROOT / "scripts" / "install", self.folder / "scripts")
        (self.folder / "scripts" / "packages").write_text(
            "# a comment\nbuild compiler\nbuild compiler-extras\ntest checker\n")
        self.pretend("apt-get", f'echo "$@" >> {self.asked}')
        self.installed([])
        self.user(0)
        self.pretend("sudo", "exit 1")

    def pretend(self, program, body):
        path = self.folder / "bin" / program
        path.write_text("#!/bin/sh\n" + body + "\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def installed(self, packages):
        lines = "".join(f"echo 'installed {p}'\n" for p in packages)
        # As the real one does when it does not know a package.
        self.pretend("dpkg-query", lines + "exit 1")

    def user(self, number):
        self.pretend("id", f"echo {number}")

    def run_install(self, *groups):
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        return subprocess.run([self.folder / "scripts" / "install", *groups], text=True,
                              capture_output=True, check=False, env={**os.environ, "PATH": path})

    def asked_of_apt(self):
        return self.asked.read_text().splitlines() if self.asked.exists() else []

    def test_touches_nothing_when_nothing_is_missing(self):
        self.installed(["compiler", "compiler-extras"])
        answer = self.run_install("build")
        self.assertEqual((answer.returncode, answer.stderr, self.asked_of_apt()), (0, "", []))

    def test_updates_once_and_installs_only_what_is_missing(self):
        self.installed(["compiler-extras"])  # whose name begins like the missing one's
        self.assertEqual(self.run_install("build", "test").returncode, 0)
        update, install = self.asked_of_apt()
        self.assertTrue(update.startswith("update"))
        self.assertIn("--no-install-recommends", install)
        self.assertTrue(install.endswith(" compiler checker"), install)

    def test_leaves_other_groups_alone(self):
        self.run_install("test")
        self.assertNotIn("compiler", " ".join(self.asked_of_apt()))

    def test_gives_an_administrator_the_command_when_it_may_not_install(self):
        self.user(1000)
        answer = self.run_install("build")
        self.assertEqual((answer.returncode, self.asked_of_apt()), (1, []))
        self.assertIn("apt-get update && apt-get install --no-install-recommends compiler compiler-extras",
                      answer.stderr)

    def test_goes_through_sudo_where_it_asks_for_no_password(self):
        self.user(1000)
        self.pretend("sudo", '[ "$1" = --non-interactive ] && shift; exec "$@"')
        self.assertEqual(self.run_install("test").returncode, 0)
        self.assertEqual(len(self.asked_of_apt()), 2)

    def test_lets_sudo_ask_for_the_password_on_a_terminal(self):
        self.user(1000)
        self.pretend("sudo", f'case $1 in --non-interactive) exit 1;; --validate) echo typed >> {self.folder}/password;; *) exec "$@";; esac')
        controlling, terminal = os.openpty()
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        answer = subprocess.run([self.folder / "scripts" / "install", "test"], check=False, stdin=terminal, stderr=terminal,
                                env={**os.environ, "PATH": path})
        os.close(terminal)
        os.close(controlling)
        self.assertEqual(answer.returncode, 0)
        self.assertEqual((self.folder / "password").read_text(), "typed\n")
        self.assertEqual(len(self.asked_of_apt()), 2)

    def test_shows_what_apt_said_when_it_failed(self):
        self.pretend("apt-get", "echo E: no network; exit 100")
        answer = self.run_install("test")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("E: no network", answer.stderr)
        self.assertIn("could not install checker", answer.stderr)

    def test_installs_although_one_source_did_not_answer(self):
        self.pretend("apt-get", f'echo "$@" >> {self.asked}; test "$1" = install')
        self.assertEqual(self.run_install("test").returncode, 0)
        self.assertEqual(len(self.asked_of_apt()), 2)

    def test_refuses_a_group_that_there_is_not(self):
        self.assertEqual(self.run_install("tests").returncode, 2)


if __name__ == "__main__":
    unittest.main()
