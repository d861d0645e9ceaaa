"""Noisy judgements in both orders, with identical pairs: python3 gen.py in this folder."""
import random
import sys

sys.path.insert(0, "../python")
from similarity import write_case  # noqa: E402

draws = random.Random(12)
items = [f"g{i}" for i in range(1, 9)]
places = [(draws.uniform(-1, 1), draws.uniform(-1, 1)) for _ in items]
weights = [(draws.lognormvariate(0, 0.4), draws.lognormvariate(0, 0.4)) for _ in range(4)]
write_case("noisy judgements in both orders with identical pairs", items, draws,
           {"places": places, "weights": weights, "noise": 12.0, "scale": 40.0, "both_orders": True, "identical": True})
