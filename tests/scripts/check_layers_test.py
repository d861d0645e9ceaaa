"""The include check has to fail on a tree with a forbidden include, and say where."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"

with tempfile.TemporaryDirectory() as folder:
    root = pathlib.Path(folder)
    for name in ("analysis", "stimuli", "device", "renderers", "protocols", "results_schema", "app"):
        (root / name).mkdir()
    (root / "device" / "wrong.cpp").write_text('#include "device/ok.h"\n#include "renderers/force_renderer.h"\n')
    (root / "analysis" / "wrong.cpp").write_text("#include <QString>\n")
    result = subprocess.run([sys.executable, CHECK, root], capture_output=True, text=True)

expected = ["device/wrong.cpp:2:", "analysis/wrong.cpp:1:"]
missing = [line for line in expected if line not in result.stdout]
if result.returncode != 1 or missing:
    sys.exit(f"check_layers.py exited {result.returncode}; not reported: {missing}\n{result.stdout}{result.stderr}")
