#!/usr/bin/env python3
"""Without a screen the program says what to do, and never aborts. Argument: the program asperity."""
import os
import subprocess
import sys

PROGRAM = sys.argv[1]
SCREENLESS = {name: value for name, value in os.environ.items()
              if name not in {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}}
complaints = []


def expect(name, environment, arguments, status, words):
    result = subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, env=environment, timeout=60)
    if result.returncode != status or words not in result.stderr:
        complaints.append(f"{name}: exit status {result.returncode} instead of {status}: {result.stderr}")


expect("no screen", SCREENLESS, [], 1, "there is no screen to show a window on")
expect("a screen that does not answer", {**SCREENLESS, "DISPLAY": ":4321"}, [], 1, "no window can be shown")
expect("neither subcommand nor folder", SCREENLESS, ["nonsense"], 2, 'there is no subcommand and no folder "nonsense"')
expect("a folder before a subcommand", SCREENLESS, ["/tmp", "models"], 2, "before the subcommand models has no meaning")
if complaints:
    sys.exit("\n".join(complaints))
