"""Power on the full physics against power from response tables: the part `physics` of scripts/power-figures."""
import csv
import json
import pathlib
import shutil
import statistics
import subprocess

# Copies of protocols of the library whose virtual observers have more noise, so that few participants do not find everything.
# `alike`: the observers do not differ, and have no order effect. The SD over textures is that with which the proportions
# correct differ about as much as those of the observers do (0.70, 0.33, 0.33 and 0.11 in 180 trials of 60 participants).
PHYSICS = {
    "chapter_recognition": {
        "noise": 1.2, "participants": 8, "effect": "sensitivity", "values": [0.2 * i for i in range(1, 11)],
        "alike": ["sensitivity_sd=0", "bias_sd=0", "texture_sd=0.8"]},
    "chapter_selection": {
        "noise": 0.4, "participants": 14, "effect": "target", "values": [0.2 * i for i in range(1, 11)],
        "alike": ["target_sd=0", "order_sd=0"]},
    "roughness_of_photographs": {
        "noise": 3.0, "participants": 5, "effect": "difference", "calibrated_with": 40, "alike": ["difference_sd=0"]},
}
STUDIES_TO_MATCH = 300


class PhysicsComparison:
    """Runs of one program; studies, copies of protocols and simulated studies are in a folder and are resumed there."""

    def __init__(self, root, path, jobs, folder):
        self.root = root
        self.path = path
        self.jobs = jobs
        self.folder = pathlib.Path(folder).resolve()
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *arguments):
        return subprocess.run([self.path, *map(str, arguments)], text=True, stdout=subprocess.PIPE, check=True).stdout

    def study(self):
        made = self.folder / "physics-study"
        if not made.exists():
            self.run("new", made, "--demo")
        return made

    def protocol(self, name):
        text = json.loads((self.root / "protocols" / "library" / f"{name}.json").read_text(encoding="utf-8"))
        text["observer"]["feature_noise"] = PHYSICS[name]["noise"]
        file = self.folder / f"{name}.json"
        file.write_text(json.dumps(text, ensure_ascii=False, indent=2), encoding="utf-8")
        return file

    def power(self, name, out, runs, *options):
        """The rows of the tests."""
        of_power = json.loads(self.run("power", self.protocol(name), "--participants", PHYSICS[name]["participants"],
                                       "--runs", runs, "--seed", 1, "--jobs", self.jobs, "--json", "--out", self.folder / out,
                                       *options))["power"]
        rows = of_power if isinstance(of_power, list) else [dict(zip(of_power["columns"], row)) for row in of_power["rows"]]
        return [row for row in rows if row["test"]]

    def mean_estimates(self, out):
        """Over the studies and tests, by effect."""
        with open(self.folder / out / "studies.tsv", encoding="utf-8", newline="") as file:
            rows = [row for row in csv.DictReader(file, delimiter="\t") if row["test"]]
        return {effect: statistics.fmean(float(row["estimate"]) for row in rows
                                         if row["effect"] == effect and row["estimate"] != "n/a")
                for effect in dict.fromkeys(row["effect"] for row in rows)}

    def matching_effect(self, name, options):
        """The effect with which studies from response tables have the mean estimate of those on the full physics."""
        wanted, = self.mean_estimates(f"physics-{name}").values()
        values = PHYSICS[name]["values"]
        effects = ",".join(f"{value:g}" for value in values)
        self.power(name, f"match-{name}", STUDIES_TO_MATCH, "--effect", f"{PHYSICS[name]['effect']}={effects}", *options)
        means = list(self.mean_estimates(f"match-{name}").values())
        for low, high, first, second in zip(means, means[1:], values, values[1:]):
            if low <= wanted <= high:
                return first + (second - first) * (wanted - low) / (high - low)
        raise SystemExit(f"{name}: no effect from {values[0]:g} to {values[-1]:g} has the mean estimate {wanted:g}")

    def calibration(self, name):
        """A simulated study, and the difference of equally spaced items whose means vary as its means do."""
        made = self.folder / f"calibration-{name}"
        if not made.exists():
            part = self.folder / f"calibration-{name}.part"
            shutil.rmtree(part, ignore_errors=True)
            shutil.copytree(self.study(), part)
            self.run("simulate", self.protocol(name), "--study", part, "--participants", PHYSICS[name]["calibrated_with"],
                     "--seed", 2, "--recordings", "none", "--jobs", self.jobs)
            part.rename(made)
        # Scale, item, participants, mean; the last three columns are its interval and the mean rank.
        lines = self.run("analyze", made).split("Mean ratings of the items on each scale\n")[1].splitlines()[2:]
        means = []
        for line in lines:
            if line.startswith(" ") or not line.strip():
                break
            means.append(float(line.split()[3]))
        places = [i / (len(means) - 1) - 0.5 for i in range(len(means))]
        return made, statistics.pstdev(means) / statistics.pstdev(places)

    def compared(self, name, runs):
        """A row for each test."""
        one = PHYSICS[name]
        felt = self.power(name, f"physics-{name}", runs // 50, "--physics", "--study", self.study())
        options = [option for stated in one["alike"] for option in ("--assume", stated)]
        if "calibrated_with" in one:
            calibration, effect = self.calibration(name)
            options += ["--calibrate", calibration]
        else:
            effect = self.matching_effect(name, options)
        tabled = self.power(name, f"table-{name}", runs, "--effect", f"{one['effect']}={effect:.4g}", *options)
        return [{"protocol": name, "test": row["test"], "feature_noise": one["noise"], "participants": one["participants"],
                 "effect": f"{one['effect']}={effect:.4g}", "physics_studies": row["studies"],
                 "physics_significant": row["significant"], "studies": other["studies"], "significant": other["significant"]}
                for row in felt for other in tabled if other["test"] == row["test"]]
