"""Two dimensions that raters weigh differently, with little noise: python3 gen.py in this folder."""
import random
import sys

sys.path.insert(0, "../python")
from similarity import write_case  # noqa: E402

draws = random.Random(11)
items = ["oak", "felt", "brick", "slate", "cork", "wool"]
places = [(-1.0, 0.6), (-0.7, -0.8), (0.1, 1.0), (0.9, 0.3), (0.6, -0.9), (0.2, -0.1)]
weights = [(1.6, 0.5), (1.0, 1.0), (0.4, 1.7), (1.2, 0.7), (0.8, 1.3)]
write_case("raters weigh two dimensions differently", items, draws,
           {"places": places, "weights": weights, "noise": 4.0, "scale": 40.0, "both_orders": False, "identical": False})
