#!/usr/bin/env python3
"""Every number in the tables of tests of a study is recomputed from its exported tables, by code that shares nothing with
the program: permutations are enumerated one by one, distributions integrated or summed. Arguments: the program asperity
and, in place of the study in tests/earlier_studies, the folder of a study that is analysed."""
import collections
import csv
import itertools
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
TOLERANCE = 1e-6
DRAWS = 20000  # of permutations where the program draws them too
CONFIDENCE = 0.95


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True).stdout


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t"))


# --- distributions ---------------------------------------------------------------------------------------------------

def bisected(function, low, high):
    """Where a function that grows crosses 0."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if function(middle) > 0 else (middle, high)
    return (low + high) / 2


def simpson(function, low, high, steps=4000):
    h = (high - low) / steps
    inner = sum((4 if i % 2 else 2) * function(low + i * h) for i in range(1, steps))
    return (function(low) + inner + function(high)) * h / 3


def beta_below(x, a, b):
    """Regularised incomplete beta function, by Lentz's continued fraction."""
    if x <= 0 or x >= 1:
        return 0.0 if x <= 0 else 1.0
    if x > (a + 1) / (a + b + 2):
        return 1 - beta_below(1 - x, b, a)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x)) / a
    f, c, d = 1.0, 1.0, 0.0
    for i in range(500):
        m = i // 2
        if i == 0:
            term = 1.0
        elif i % 2 == 0:
            term = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
        else:
            term = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))
        d = 1 / (1 + term * d)
        c = 1 + term / c
        f *= c * d
        if i > 0 and abs(c * d - 1) < 1e-15:
            break
    return front * (f - 1)


def f_below(value, df1, df2, noncentrality=0.0):
    """A noncentral F is a Poisson mixture of central beta distributions."""
    x = df1 * value / (df1 * value + df2)
    total, weight = 0.0, math.exp(-noncentrality / 2)
    for j in range(10 + int(noncentrality + 20 * math.sqrt(noncentrality + 1))):
        total += weight * beta_below(x, df1 / 2 + j, df2 / 2)
        weight *= noncentrality / 2 / (j + 1)
    return total


def t_two_sided(t, df):
    return beta_below(df / (df + t * t), df / 2, 0.5)


def t_below(t, df, delta):
    """A noncentral t: P(Z + δ ≤ t·s), over the distribution of s = √(χ²/df)."""
    scale = math.log(2) + df / 2 * math.log(df / 2) - math.lgamma(df / 2)

    def density(s):
        return math.exp(scale + (df - 1) * math.log(s) - df * s * s / 2) if s > 0 else 0.0
    return simpson(lambda s: density(s) * math.erfc((delta - t * s) / math.sqrt(2)) / 2, 0.0, 1 + 12 / math.sqrt(df), 2000)


def noncentralities(t, df):
    tail = (1 - CONFIDENCE) / 2
    width = 12 * math.sqrt(1 + t * t / (2 * df))

    def crossing(probability):
        low, high = t - width, t + width
        for _ in range(45):
            middle = (low + high) / 2
            low, high = (middle, high) if t_below(t, df, middle) > probability else (low, middle)
        return (low + high) / 2
    return crossing(1 - tail), crossing(tail)


def z_quantile():
    return bisected(lambda z: (1 - CONFIDENCE) / 2 - math.erfc(z / math.sqrt(2)) / 2, 0.0, 10.0)


# --- statistics ------------------------------------------------------------------------------------------------------

def mean(values):
    return sum(values) / len(values)


def variance(values):
    return sum((value - mean(values)) ** 2 for value in values) / (len(values) - 1)


def paired_d(values, null=0.0):
    """Cohen's d of one sample, with its limits; nothing without a spread."""
    if len(values) < 2 or variance(values) < 1e-20:
        return None
    root = math.sqrt(len(values))
    d = (mean(values) - null) / math.sqrt(variance(values))
    low, high = noncentralities(d * root, len(values) - 1)
    return d, low / root, high / root


def hedges_g(first, second):
    n1, n2 = len(first), len(second)
    if min(n1, n2) < 2:
        return None
    f = n1 + n2 - 2
    pooled = ((n1 - 1) * variance(first) + (n2 - 1) * variance(second)) / f
    if pooled < 1e-20:
        return None
    bias = math.exp(math.lgamma(f / 2) - math.lgamma((f - 1) / 2)) / math.sqrt(f / 2)
    d = (mean(first) - mean(second)) / math.sqrt(pooled)
    root = math.sqrt(n1 * n2 / (n1 + n2))
    low, high = noncentralities(d * root, f)
    return bias * d, bias * low / root, bias * high / root


def cohen_h(hits, trials, chance):
    z2 = z_quantile() ** 2
    middle = (hits + z2 / 2) / (trials + z2)
    half = math.sqrt(z2 * (hits * (trials - hits) / trials + z2 / 4)) / (trials + z2)
    limits = (hits / trials, max(0.0, middle - half), min(1.0, middle + half))
    return tuple(2 * math.asin(math.sqrt(p)) - 2 * math.asin(math.sqrt(chance)) for p in limits)


def binomial_above(hits, trials, chance):
    return sum(math.comb(trials, k) * chance ** k * (1 - chance) ** (trials - k) for k in range(hits, trials + 1))


def midranks(values):
    return [sum(other < value for other in values) + (sum(other == value for other in values) + 1) / 2 for value in values]


def kendall_w(counts):
    """With its jackknife from ten rows on."""
    def concordance(rows):
        centred = [[rank - (len(row) + 1) / 2 for rank in midranks(row)] for row in rows]
        within = sum(value * value for row in centred for value in row)
        between = sum(sum(column) ** 2 for column in zip(*centred))
        return between / (len(rows) * within) if within > 0 else None
    n, w = len(counts), concordance(counts)
    if n < 2 or w is None:
        return None
    if n < 10:
        return w, None, None

    def transformed(rows):
        of_rows = concordance(rows)
        r = None if of_rows is None else (len(rows) * of_rows - 1) / (len(rows) - 1)
        return math.atanh(r) if r is not None and abs(r) < 1 else None
    parts = [transformed(counts)] + [transformed(counts[:i] + counts[i + 1:]) for i in range(n)]
    if None in parts:
        return w, None, None
    pseudo = [n * parts[0] - (n - 1) * part for part in parts[1:]]
    limit = bisected(lambda t: 1 - CONFIDENCE - t_two_sided(t, n - 1), 0.0, 100.0)
    half = limit * math.sqrt(variance(pseudo) / n)
    ends = (mean(pseudo) - half, mean(pseudo) + half)
    return (w, *(max(0.0, (1 + (n - 1) * math.tanh(end)) / n) for end in ends))


def convolved(distributions):
    """Of the sum of independent numbers, each {value: probability}."""
    total = {0: 1.0}
    for one in distributions:
        following = collections.defaultdict(float)
        for value, p in total.items():
            for more, q in one.items():
                following[value + more] += p * q
        total = following
    return total


def uniform(values):
    counts = collections.Counter(values)
    return {value: count / sum(counts.values()) for value, count in counts.items()}


def sign_flip(differences):
    null = convolved([uniform([d, -d]) for d in differences])
    return sum(p for total, p in null.items() if abs(total) >= abs(sum(differences)))


def relabelling(counts):
    """Labels exchanged within every row: the distribution of the totals, row by row."""
    totals = {tuple([0] * len(counts[0])): 1.0}
    for row in counts:
        orders = collections.Counter(itertools.permutations(row))
        following = collections.defaultdict(float)
        for so_far, p in totals.items():
            for order, times in orders.items():
                key = tuple(sorted(a + b for a, b in zip(so_far, order)))
                following[key] += p * times / math.factorial(len(row))
        totals = following
    observed = sum(sum(column) ** 2 for column in zip(*counts))
    return sum(p for key, p in totals.items() if sum(value * value for value in key) >= observed)


def group_permutation(first, second):
    values, observed = first + second, abs(mean(first) - mean(second))
    chosen = [sum(values[i] for i in places) for places in itertools.combinations(range(len(values)), len(first))]
    differences = (abs(c / len(first) - (sum(values) - c) / len(second)) for c in chosen)
    return sum(difference >= observed - 1e-12 for difference in differences) / len(chosen)


def holm(values):
    order = sorted(range(len(values)), key=lambda i: values[i])
    adjusted, most = [0.0] * len(values), 0.0
    for place, i in enumerate(order):
        most = max(most, min(1.0, (len(values) - place) * values[i]))
        adjusted[i] = most
    return adjusted


# --- the tests of each kind ------------------------------------------------------------------------------------------

class Answers:
    """What counts of one protocol and group, trial by trial."""

    def __init__(self, tables, outcome):
        virtual = {"virtual": "1", "people": "0", "pilot": "0"}[outcome["group"]]
        counted = {self.key(row) for row in tables["attempts"] if row["counts_in_analyses"] == "1"}
        of_protocol = {self.key(row)[:3]: row for row in tables["trials"]
                       if row["protocol"] == outcome["protocol"] and row["phase"] == "main" and row["virtual"] == virtual}
        self.sex = {row["participant"]: row["sex"] for row in tables["participants"]}
        self.trials = {}
        for row in tables["responses"]:
            key = self.key(row)
            is_pilot = row["mode"] == "pilot"
            if key not in counted or key[:3] not in of_protocol or (outcome["group"] != "virtual" and
                                                                    is_pilot != (outcome["group"] == "pilot")):
                continue
            trial = self.trials.setdefault(key, {"who": row["participant"], "trial": of_protocol[key[:3]], "replies": [],
                                                 "felt": [], "options": json.loads(row["options_json"])})
            trial["replies"].append(row)
        for row in sorted(tables["presentations"], key=lambda row: int(row["position"])):
            if self.key(row) in self.trials:
                self.trials[self.key(row)]["felt"].append(row)
        self.people = sorted({trial["who"] for trial in self.trials.values()})

    @staticmethod
    def key(row):
        return row["participant"], row["session"], row["trial"], row.get("attempt")

    def of(self, person):
        return [trial for trial in self.trials.values() if trial["who"] == person]


def result(statistic, value, p, effect, n, df=()):
    return {"statistic": statistic, "value": value, "p": p, "effect": effect, "n": n, "df": df}


def within_participants(rows):
    kept = [row for row in rows if sum(row) > 0]
    if not kept:
        return None
    totals = [sum(column) for column in zip(*kept)]
    x2 = sum((total - mean(totals)) ** 2 for total in totals) / mean(totals)
    return result("X²", x2, relabelling(kept), kendall_w(kept), len(kept))


def selection(answers, rows):
    tests = {}
    offered = {frozenset(row["item"] for row in trial["felt"]) for trial in answers.trials.values()}
    items = sorted(frozenset.union(*offered))
    chosen = {key: trial["replies"][0]["answer"] for key, trial in answers.trials.items()}
    # Where trials present different items a pair is tested on those that presented both.
    for a, b in itertools.combinations(items, 2):
        def count(person, item, pair=frozenset((a, b))):
            return sum(chosen[key] == item for key, trial in answers.trials.items()
                       if trial["who"] == person and pair <= {row["item"] for row in trial["felt"]})
        choosers = [who for who in answers.people
                    if any(count(who, item) for item in ((a, b) if len(offered) > 1 else items))]
        differences = [count(who, a) - count(who, b) for who in choosers]
        if differences:
            made = result("D", sum(differences), sign_flip(differences), paired_d(differences), len(differences))
            tests["pairs", (a, b)] = tests["target_pairs", (a, b)] = made
    tests["preference", None] = within_participants(
        [[sum(t["replies"][0]["answer"] == item for t in answers.of(who)) for item in items] for who in answers.people])
    places = max(len(trial["felt"]) for trial in answers.trials.values())
    tests["position", None] = within_participants(
        [[sum(t["felt"][i]["item"] == t["replies"][0]["answer"] for t in answers.of(who)) for i in range(places)]
         for who in answers.people])
    textures = sorted({trial["felt"][0]["texture"] for trial in answers.trials.values()})
    for target in items:  # which one the table is about shows only in its numbers
        tests["textures " + target, None] = within_participants(
            [[sum(t["replies"][0]["answer"] == target and t["felt"][0]["texture"] == texture for t in answers.of(who))
              for texture in textures] for who in answers.people])
    for row in rows:
        if row["test"] == "textures":
            pairs = [set(subject(test)) for test in rows if test["test"] == "target_pairs"]
            tests["textures", None] = tests["textures " + set.intersection(*pairs).pop(), None]
    return tests


def fixed_points(items):
    return uniform([sum(i == place for i, place in enumerate(order)) for order in itertools.permutations(range(items))])


def mallows(right, items):
    null = fixed_points(items)

    def fit(theta):
        weights = {k: p * math.exp(theta * k) for k, p in null.items()}
        total = sum(weights.values())
        return math.log(total), sum(k * weight for k, weight in weights.items()) / total
    if mean(right) in (0, items):
        return None
    theta = bisected(lambda x: fit(x)[1] - mean(right), -40.0, 40.0)

    def deviance(x):
        return 2 * len(right) * (theta * mean(right) - fit(theta)[0] - x * mean(right) + fit(x)[0])
    limit = z_quantile() ** 2
    return (theta, -bisected(lambda x: deviance(-x) - limit, -theta, 60.0), bisected(lambda x: deviance(x) - limit, theta, 60.0))


def matching(answers, _):
    tests, null_right, null_whole = {}, [], []
    null_of = collections.defaultdict(list)
    right, whole, hits, shown = [], 0, collections.Counter(), collections.Counter()
    for who in answers.people:
        own = [{felt["item"]: reply["answer"] for felt, reply in zip(t["felt"], t["replies"])} for t in answers.of(who)]
        pictures = sorted(own[0])
        totals, wholes, by_item = [], [], collections.defaultdict(list)
        for order in itertools.permutations(pictures):
            renamed = dict(zip(pictures, order))
            matches = [[renamed[answer] == felt for felt, answer in trial.items()] for trial in own]
            totals.append(sum(map(sum, matches)))
            wholes.append(sum(map(all, matches)))
            for felt in pictures:
                by_item[felt].append(sum(renamed[trial[felt]] == felt for trial in own))
        null_right.append(uniform(totals))
        null_whole.append(uniform(wholes))
        for felt in pictures:
            null_of[felt].append(uniform(by_item[felt]))
        for trial in own:
            right.append(sum(felt == answer for felt, answer in trial.items()))
            whole += right[-1] == len(trial)
            for felt, answer in trial.items():
                shown[felt] += 1
                hits[felt] += felt == answer
    m, people = len(pictures), len(answers.people)

    def above(nulls, observed):
        return sum(p for value, p in convolved(nulls).items() if value >= observed)
    tests["items", None] = result("k", sum(right), above(null_right, sum(right)), mallows(right, m), people)
    tests["whole", None] = result("k", whole, above(null_whole, whole),
                                  cohen_h(whole, len(right), 1 / math.factorial(m)), people)
    for felt in shown:
        tests["textures", felt] = result("k", hits[felt], above(null_of[felt], hits[felt]),
                                         cohen_h(hits[felt], shown[felt], 1 / m), people)
    means = {who: mean([sum(felt["item"] == reply["answer"] for felt, reply in zip(t["felt"], t["replies"]))
                        for t in answers.of(who)]) for who in answers.people}
    tests["sexes", ("F", "M")] = of_sexes(answers, means)
    return tests


def of_sexes(answers, means):
    first, second = ([means[who] for who in answers.people if answers.sex[who] == sex] for sex in "FM")
    if not first or not second:
        return None
    return result("ΔM", mean(first) - mean(second), group_permutation(first, second), hedges_g(first, second),
                  len(first) + len(second))


def permuted_responses(trials_of_participants):
    """Proportion of random permutations of each participant's responses with at least this dependence."""
    generator = random.Random(1)

    def dependence(trials):
        return sum(count * math.log(count) for count in collections.Counter(trials).values()) + 1e-9

    felt = [[one for one, _ in own] for own in trials_of_participants]
    given = [[one for _, one in own] for own in trials_of_participants]
    observed = dependence(trial for own in trials_of_participants for trial in own) - 2e-9
    as_large = 1
    for _ in range(DRAWS):
        for own in given:
            generator.shuffle(own)
        as_large += dependence(trial for own in map(zip, felt, given) for trial in own) >= observed
    return as_large / (DRAWS + 1)


def recognition(answers, _):
    tests, table = {}, collections.Counter()
    labels = sorted({option for trial in answers.trials.values() for option in trial["options"]} - {"cannot_tell"})
    own, judged = collections.defaultdict(list), collections.defaultdict(list)
    for trial in answers.trials.values():
        felt, answer = trial["felt"][0]["item"], trial["replies"][0]["answer"]
        own[trial["who"]].append(felt == answer)
        judged[trial["who"]].append((felt, answer))
        table[felt, answer] += 1
    shares = [mean(own[who]) for who in answers.people]
    m, n = len(labels), sum(table.values())
    effect = paired_d(shares, 1 / m)
    if effect is not None:
        t = effect[0] * math.sqrt(len(shares))
        tests["right", None] = result("t", t, t_two_sided(t, len(shares) - 1), effect, len(shares), (len(shares) - 1,))
    elif len(shares) == 1:
        hits = sum(count for (felt, answer), count in table.items() if felt == answer)
        tests["right", None] = result("k", hits, binomial_above(hits, n, 1 / m), cohen_h(hits, n, 1 / m), n)
    felt = {label: sum(table[label, answer] for answer in labels) for label in labels}
    given = {label: sum(table[one, label] for one in labels) for label in labels}
    g = 2 * sum(count * math.log(count * n / (felt[a] * given[b])) for (a, b), count in table.items() if count)
    df = (sum(map(bool, felt.values())) - 1) * (sum(map(bool, given.values())) - 1)
    bits = g / (2 * n * math.log(2)) - df / (2 * n * math.log(2))
    tests["information", None] = result("G²", g, permuted_responses(judged.values()), (bits, None, None), n, (df,))
    for label in labels:
        if felt[label]:
            hits = table[label, label]
            tests["textures", label] = result("k", hits, binomial_above(hits, felt[label], 1 / m),
                                              cohen_h(hits, felt[label], 1 / m), felt[label])
    tests["sexes", ("F", "M")] = of_sexes(answers, dict(zip(answers.people, shares)))
    return tests


def contrasts(levels):
    """Orthonormal, Helmert's."""
    rows = []
    for i in range(1, levels):
        scale = math.sqrt(i * (i + 1))
        rows.append([1 / scale] * i + [-i / scale] + [0.0] * (levels - i - 1))
    return rows


def magnitude(answers, _):
    def level(trial, name):
        return trial["trial"]["factor_" + name]
    spacing_factor, condition_factor = FACTORS[next(iter(answers.trials.values()))["trial"]["protocol"]]
    cells = collections.defaultdict(list)
    for trial in answers.trials.values():
        if trial["trial"]["repetition"] in ("0", "n/a"):
            continue
        cells[trial["who"], level(trial, condition_factor), level(trial, spacing_factor)].append(
            math.log10(float(trial["replies"][0]["answer"])))
    conditions, spacings = sorted({key[1] for key in cells}), sorted({key[2] for key in cells})
    y = [[[mean(cells[who, c, s]) for s in spacings] for c in conditions] for who in answers.people]
    if len(y) < 2:
        return {}
    n = len(y)
    average_s, average_c = [len(spacings) ** -0.5] * len(spacings), [len(conditions) ** -0.5] * len(conditions)
    of_effect = {"condition": [(c, average_s) for c in contrasts(len(conditions))],
                 "spacing": [(average_c, s) for s in contrasts(len(spacings))],
                 "interaction": [(c, s) for c in contrasts(len(conditions)) for s in contrasts(len(spacings))]}
    effects, errors = {}, 0.0  # the modulus is free: the scales of the participants are removed, and vary in no stratum
    for name, pairs in of_effect.items():
        z = [[sum(c[i] * s[j] * person[i][j] for i in range(len(c)) for j in range(len(s))) for c, s in pairs] for person in y]
        means = [mean(column) for column in zip(*z)]
        ss = n * sum(value * value for value in means)
        covariance = [[sum((row[i] - means[i]) * (row[j] - means[j]) for row in z) for j in range(len(pairs))]
                      for i in range(len(pairs))]
        trace = sum(covariance[i][i] for i in range(len(pairs)))
        epsilon = trace ** 2 / (len(pairs) * sum(value * value for row in covariance for value in row))
        effects[name] = (ss, trace, len(pairs), epsilon)
        errors += trace
    tests = {}
    for name, (ss, error, q, epsilon) in effects.items():
        df1, df2 = q, q * (n - 1)
        f = ss / df1 / (error / df2)

        def limit(probability, f=f, df1=df1 * epsilon, df2=df2 * epsilon, error=error):
            if f_below(f, df1, df2) < probability:
                return 0.0
            lam = bisected(lambda x: probability - f_below(f, df1, df2, x), 0.0, 10 * f * df1 + 50)
            partial = lam / (lam + df1 + df2 + 1)
            odds = partial / (1 - partial)
            return odds / (odds + errors / error)
        tail = (1 - CONFIDENCE) / 2
        tests[name, None] = result("F", f, 1 - f_below(f, df1 * epsilon, df2 * epsilon),
                                   (ss / (ss + errors), limit(1 - tail), limit(tail)), n, (df1, df2))
    return tests


KINDS = {"selection": selection, "matching": matching, "recognition": recognition, "magnitude": magnitude}
FACTORS = {f"roughness_{condition}": ("texture", condition) for condition in ("force", "speed")}  # spacing and condition
compared = 0


def agree(where, ours, theirs):
    global compared
    assert (ours is None) == (theirs is None), (where, ours, theirs)
    if ours is None:
        return
    assert abs(ours - theirs) <= TOLERANCE * max(1.0, abs(theirs)), (where, ours, theirs)
    compared += 1


def subject(row):
    """Of a row of the table of tests: one name, two, or none."""
    return row["about"] or (row["first"] and (row["first"], row["second"]))


def check(outcome, tables):
    rows = next((table["rows"] for table in outcome["tables"] if table["name"] == "tests"), None)
    if rows is None:
        return
    where = (outcome["protocol"], outcome["group"])
    tests = KINDS[outcome["kind"]](Answers(tables, outcome), rows)
    family = [row["p"] if row["p"] is not None else 1.0 for row in rows if row["family"]]
    adjusted = iter(holm(family))
    for row in rows:
        place = (*where, row["test"], subject(row))
        own = next(adjusted) if row["family"] else None
        assert row["role"] == "exploratory" or (row["role"] == "confirmatory" and row["family"]), place
        if row["p"] is None:
            assert row["status"] and row["value"] is None and row["effect"] is None and row["p_holm"] is None, place
            continue
        test = tests[row["test"], subject(row)]
        assert row["statistic"] == test["statistic"] and row["n"] == test["n"], (place, row, test)
        if row["permutations"] in (None, "exact"):
            agree((*place, "p"), row["p"], test["p"])
        else:
            variance = test["p"] * (1 - test["p"]) * (1 / DRAWS + 1 / int(row["permutations"]))
            assert abs(row["p"] - test["p"]) <= 4 * math.sqrt(variance), (place, row["p"], test["p"])
        agree((*place, "p_holm"), row["p_holm"], own)
        agree((*place, "value"), row["value"], test["value"])
        for i, name in enumerate(("df1", "df2")):
            agree((*place, name), row[name], test["df"][i] if i < len(test["df"]) else None)
        effect = test["effect"] or (None,) * 3
        if row["n"] == 1 and row["unit"] == "participants":  # an interval over trials says nothing about participants
            effect = (effect[0], None, None)
        for name, value in zip(("effect", "effect_low", "effect_high"), effect):
            agree((*place, name), row[name], value)


def check_study(study, folder):
    asperity("export", study, "--out", folder / "out", "--formats", "none")
    tables = {name: rows_of(folder / "out" / f"{name}.tsv")
              for name in ("attempts", "participants", "presentations", "responses", "trials")}
    for outcome in json.loads(asperity("analyze", study, "--json"))["outcomes"]:
        if outcome["kind"] in KINDS:  # thresholds have reference cases of their own
            check(outcome, tables)


def main():
    study = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "tests/earlier_studies/present/study")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(study, folder / "study", copy_function=shutil.copyfile)
        check_study(folder / "study", folder)
    assert len(sys.argv) > 2 or compared > 100, compared
    print(f"{compared} numbers of tables of tests agree with an independent computation")


main()
