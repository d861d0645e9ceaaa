"""Judgements of pairs: subject, first, second, dissimilarity. INDSCAL by Levenberg and Marquardt's method on all parameters together, from
many random starts (the program alternates regressions), and the correlations and regressions by their definitions. Standard library only."""
import csv
import json
import math
import random

TOLERANCES = {"formula": (1e-10, 1e-12), "curvature": (1e-4, 1e-6)}


def solved(matrix, right):
    n = len(matrix)
    rows = [row[:] + [value] for row, value in zip(matrix, right)]
    for column in range(n):
        pivot = max(range(column, n), key=lambda r: abs(rows[r][column]))
        rows[column], rows[pivot] = rows[pivot], rows[column]
        for r in range(column + 1, n):
            factor = rows[r][column] / rows[column][column]
            if factor:
                for k in range(column, n + 1):
                    rows[r][k] -= factor * rows[column][k]
    x = [0.0] * n
    for r in reversed(range(n)):
        x[r] = (rows[r][n] - sum(rows[r][k] * x[k] for k in range(r + 1, n))) / rows[r][r]
    return x


def scalar_products(d):
    """-1/2 J D^2 J, with a sum of squares of 1."""
    n = len(d)
    square = [[v * v for v in row] for row in d]
    row_mean = [sum(row) / n for row in square]
    all_mean = sum(row_mean) / n
    b = [[-0.5 * (square[i][j] - row_mean[i] - row_mean[j] + all_mean) for j in range(n)] for i in range(n)]
    size = math.sqrt(sum(v * v for row in b for v in row))
    return [[v / size for v in row] for row in b]


def loss_of(products, x, w):
    return sum((b[i][j] - sum(weights[a] * x[i][a] * x[j][a] for a in range(len(weights)))) ** 2
               for b, weights in zip(products, w) for i in range(len(x)) for j in range(len(x)))


def indscal(products, dimensions, starts):
    """The least squares of B_s - X W_s X', over X and all W_s at once."""
    n, raters, r = len(products[0]), len(products), dimensions
    best = None
    for start in range(starts):
        draws = random.Random(start)
        x = [[draws.gauss(0, 0.4) for _ in range(r)] for _ in range(n)]
        w = [[0.5 + draws.random() for _ in range(r)] for _ in range(raters)]
        damping, loss = 1e-2, loss_of(products, x, w)
        for _ in range(400):
            size = n * r + raters * r
            normal = [[0.0] * size for _ in range(size)]
            slope = [0.0] * size
            for s, b in enumerate(products):
                for i in range(n):
                    for j in range(n):
                        residual = b[i][j] - sum(w[s][a] * x[i][a] * x[j][a] for a in range(r))
                        gradient = {}
                        for a in range(r):
                            gradient[i * r + a] = gradient.get(i * r + a, 0.0) + w[s][a] * x[j][a]
                            gradient[j * r + a] = gradient.get(j * r + a, 0.0) + w[s][a] * x[i][a]
                            gradient[n * r + s * r + a] = x[i][a] * x[j][a]
                        for p, dp in gradient.items():
                            slope[p] += dp * residual
                            for q, dq in gradient.items():
                                normal[p][q] += dp * dq
            while True:
                step = solved([[v + (damping * (1e-9 + normal[p][p]) if p == q else 0.0) for q, v in enumerate(row)]
                               for p, row in enumerate(normal)], slope)
                x_new = [[x[i][a] + step[i * r + a] for a in range(r)] for i in range(n)]
                w_new = [[w[s][a] + step[n * r + s * r + a] for a in range(r)] for s in range(raters)]
                loss_new = loss_of(products, x_new, w_new)
                if loss_new <= loss or damping > 1e12:
                    break
                damping *= 4
            change, x, w, loss = loss - loss_new, x_new, w_new, loss_new
            damping = max(damping / 6, 1e-14)
            if abs(change) < 1e-18:
                break
        if best is None or loss < best[0] - 1e-12:
            best = (loss, x, w)
    loss, x, w = best
    for a in range(r):
        size = math.sqrt(sum(row[a] ** 2 for row in x))
        largest = max((row[a] for row in x), key=abs)
        for row in x:
            row[a] *= math.copysign(1.0, largest) / size
        for weights in w:
            weights[a] *= size * size
    order = sorted(range(r), key=lambda a: -sum(weights[a] ** 2 for weights in w))
    return [[row[a] for a in order] for row in x], [[weights[a] for a in order] for weights in w]


def correlation(a, b):
    ma, mb = sum(a) / len(a), sum(b) / len(b)
    return sum((x - ma) * (y - mb) for x, y in zip(a, b)) / math.sqrt(
        sum((x - ma) ** 2 for x in a) * sum((y - mb) ** 2 for y in b))


def write_case(title, items, draws, options):
    """Draws the judgements of the raters, and writes the tables, the case and its results."""
    places, weights, noise, scale = options["places"], options["weights"], options["noise"], options["scale"]
    raters = [f"P{s + 1}" for s in range(len(weights))]
    rows = []
    for rater, weight in zip(raters, weights):
        for i, a in enumerate(items):
            for j, b in enumerate(items):
                if i > j and not options["both_orders"]:
                    continue
                if i == j and not options["identical"]:
                    continue
                distance = math.sqrt(sum(w * (p - q) ** 2 for w, p, q in zip(weight, places[i], places[j])))
                rows.append((rater, a, b, round(max(0.0, scale * distance + draws.gauss(0, noise)), 1)))
    with open("judgements.csv", "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("subject", "first", "second", "dissimilarity"), *rows])
    properties = [(name, "height", round(3 * place[0] - place[1] + draws.gauss(0, 0.5), 2)) for name, place in zip(items, places)]
    with open("properties.csv", "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("item", "property", "value"), *properties])
    with open("case.json", "w", encoding="utf-8") as file:
        json.dump({"family": "similarity", "title": title, "inputs": ["judgements.csv", "properties.csv"],
                   "options": {"items": items, "dimensions": 2}}, file, indent=2)
        file.write("\n")
    results = []

    def put(quantity, key, value, known):
        results.append((quantity, key, format(value, ".15g"), *TOLERANCES[known]))

    means = {}
    for rater in raters:
        for i, a in enumerate(items):
            for j in range(i + 1, len(items)):
                own = [v for who, x, y, v in rows if who == rater and {x, y} == {a, items[j]}]
                means[rater, i, j] = sum(own) / len(own)
    pairs = [(i, j) for i in range(len(items)) for j in range(i + 1, len(items))]
    for rater in raters:
        others = [sum(means[other, i, j] for other in raters if other != rater) / (len(raters) - 1) for i, j in pairs]
        put("agreement.r", rater, correlation([means[rater, i, j] for i, j in pairs], others), "formula")
        if options["both_orders"]:
            value = {(x, y): v for who, x, y, v in rows if who == rater}
            put("orders.r", rater, correlation([value[items[i], items[j]] for i, j in pairs],
                                               [value[items[j], items[i]] for i, j in pairs]), "formula")
    if options["identical"]:
        differences = []
        for rater in raters:
            same = [v for who, x, y, v in rows if who == rater and x == y]
            other = [v for who, x, y, v in rows if who == rater and x != y]
            differences.append(sum(other) / len(other) - sum(same) / len(same))
        n = len(differences)
        mean = sum(differences) / n
        sd = math.sqrt(sum((v - mean) ** 2 for v in differences) / (n - 1))
        put("t", "identical", mean / (sd / math.sqrt(n)), "formula")
        put("dz", "identical", mean / sd, "formula")
    matrices = [[[0.0 if i == j else means[rater, min(i, j), max(i, j)] for j in range(len(items))] for i in range(len(items))]
                for rater in raters]
    products = [scalar_products(matrix) for matrix in matrices]
    x, w = indscal(products, 2, 12)
    for name, row in zip(items, x):
        for a, value in enumerate(row):
            put("indscal.position", f"{name}|{a + 1}", value, "curvature")
    fits = []
    for rater, weights_of_rater, b in zip(raters, w, products):
        for a, value in enumerate(weights_of_rater):
            put("indscal.weight", f"{rater}|{a + 1}", value, "curvature")
        fits.append(1 - loss_of([b], x, [weights_of_rater]))
        put("indscal.fit", rater, fits[-1], "curvature")
    put("indscal.fit.mean", "", sum(fits) / len(fits), "curvature")
    with open("expected.csv", "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("quantity", "key", "value", "rtol", "atol"), *results])
