"""No two headers define an inline constant of one name: the linker would keep one of the definitions for both, without a message."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("analysis", "app", "device", "protocols", "renderers", "results_schema", "stimuli")
CONSTANT = re.compile(r"^\s*inline\s+(?:constexpr|constinit|const)\b[^=;{(]*?\b(k[A-Z]\w*)\s*(?:\[[^\]]*\]\s*)?(?:=|\{|;|$)", re.MULTILINE)


def repeated(headers):
    """Name → the headers, of each name that several headers define."""
    places = collections.defaultdict(set)
    for path, text in headers:
        for match in CONSTANT.finditer(text):
            places[match.group(1)].add(str(path))
    return {name: sorted(paths) for name, paths in places.items() if len(paths) > 1}


planted = [("a.h", "inline constexpr double kOne = 1.0;\n"), ("b.h", "inline constexpr auto kTwo =\n    2;\ninline constexpr int kOne[2]{1, 2};\n")]
if repeated(planted) != {"kOne": ["a.h", "b.h"]}:
    sys.exit(f"the check finds {repeated(planted)} in two headers that both define kOne")
found = repeated((path.relative_to(ROOT), path.read_text(encoding="utf-8")) for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.h")))
for name, paths in sorted(found.items()):
    print(f"{name} is defined in {' and '.join(paths)}: rename one of them")
sys.exit(1 if found else 0)
