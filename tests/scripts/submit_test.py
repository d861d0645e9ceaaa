#!/usr/bin/env python3
"""A divided command is submitted with the commands of Slurm, and again where its shards are missing. Argument: the program asperity.

The commands of Slurm are scripts that note how they are called: sbatch numbers the jobs from 21, squeue lists the file "queue".
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
SWEEP = ["sweep", "--model", "bump_map", "--param", "height_scale=$x 'y' \"z\"", "--out", "my table.tsv"]


class Submit(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.slurm = pathlib.Path(place.name, "slurm")
        self.folder = pathlib.Path(place.name, "work").resolve()
        self.slurm.mkdir()
        self.folder.mkdir()
        self.pretend("sbatch", "echo \"sbatch $*\" >> calls; echo $((20 + $(grep -c sbatch calls)))")
        self.pretend("scancel", "echo \"scancel $*\" >> calls")
        self.pretend("squeue", "cat queue")
        self.queue()

    def pretend(self, name, body):
        path = self.slurm / name
        path.write_text(f"#!/bin/sh\nset -e\ncd \"$(dirname \"$0\")\"\n{body}\n")
        path.chmod(0o755)

    def queue(self, *jobs):
        """Each a name of a job without the digest, and the rest of its line."""
        (self.slurm / "queue").write_text("".join(self.job_name + rest + "\n" for rest in jobs))

    @property
    def job_name(self):
        file = self.folder / "jobs" / "submission.json"
        return json.loads(file.read_text())["job_name"] if file.exists() else ""

    def calls(self):
        """Since the last time."""
        file = self.slurm / "calls"
        text = file.read_text() if file.exists() else ""
        noted, self.noted = text[getattr(self, "noted", 0):], len(text)
        return noted.replace(str(self.folder), "").splitlines()

    def submit(self, *words, path=None):
        environment = {**os.environ, "PATH": path or f"{self.slurm}:{os.environ['PATH']}"}
        return subprocess.run([PROGRAM, "submit", *words], cwd=self.folder, env=environment, text=True, capture_output=True,
                              check=False, stdin=subprocess.DEVNULL)

    def submitted(self, *words):
        done = self.submit(*words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        return done.stdout

    def begin(self, *options):
        return self.submitted("jobs", "--slurm", "--shards", "4", *options, "--", *SWEEP)

    def shard(self, index):
        (self.folder / f"my table.tsv.shard-{index}-of-4").write_text("a shard\n")

    def words_of(self, script):
        """What the script would run, with a program that prints its arguments."""
        text = (self.folder / "jobs" / script).read_text()
        self.assertIn(f"exec {PROGRAM} ", text)
        printing = text.replace(f"exec {PROGRAM} ", "printf '%s\\n' ")
        done = subprocess.run(["bash", "-c", printing], env={"SLURM_ARRAY_TASK_ID": "3", "SLURM_CPUS_PER_TASK": "2"}, text=True,
                              capture_output=True, check=True)
        return done.stdout.splitlines()

    def test_an_array_and_a_job_that_depends_on_it(self):
        self.assertEqual(self.begin("--time", "10", "--sbatch=--account=lab", "--sbatch=--qos=low"),
                         "submitted: job array 21 (shards 1-4) and gather job 22\n")
        self.assertEqual(self.calls(), ["sbatch --parsable --array=1-4 /jobs/shards.sbatch",
                                        "sbatch --parsable --dependency=afterok:21 --kill-on-invalid-dep=yes /jobs/gather.sbatch"])
        self.assertEqual(self.words_of("shards.sbatch"), ["sweep", "--shard", "3/4", "--jobs", "2", *SWEEP[1:]])
        self.assertEqual(self.words_of("gather.sbatch"), ["gather", *(f"my table.tsv.shard-{k}-of-4" for k in range(1, 5)), "--out",
                                                          "my table.tsv"])
        for script in ("shards.sbatch", "gather.sbatch"):
            text = (self.folder / "jobs" / script).read_text()
            for line in ("#SBATCH --time=10", "#SBATCH --account=lab", "#SBATCH --qos=low", "#SBATCH --requeue"):
                self.assertIn(line + "\n", text)

    def test_one_process_submits_at_a_time(self):
        unless_locked = f"if flock --nonblock '{self.folder}/jobs/lock' true; then echo 'not locked' >&2; exit 1; fi"
        self.pretend("sbatch", f"{unless_locked}; echo 21")
        self.pretend("squeue", f"{unless_locked}; cat queue")
        self.begin()
        self.submitted("jobs")
        self.assertIn("not locked", self.submit("jobs", "--status").stderr, "the state can be shown at any time")

    def test_what_is_missing_is_submitted_again(self):
        self.begin()
        self.calls()
        self.shard(1)
        self.queue("|21|2|RUNNING|None", "|21|3|PENDING|Resources", "|21|4|TIMEOUT|TimeLimit", "-gather|22|N/A|PENDING|Dependency")
        state = (f"{self.folder}/my table.tsv: 1 of 4 shards complete\npending (Resources): shard 3\nrunning: shard 2\n"
                 "missing: shard 4, task timeout (TimeLimit); there is no log\ngather job 22: pending (Dependency)\n")
        self.assertEqual(self.submitted("jobs", "--status"), state)
        self.assertEqual(self.calls(), [], "the state alone")
        self.assertEqual(self.submitted("jobs"),
                         state + "cancelled: gather job 22\nsubmitted: job array 23 (shard 4) and gather job 24\n")
        self.assertEqual(self.calls(), [
            "scancel 22", "sbatch --parsable --array=4 /jobs/shards.sbatch",
            "sbatch --parsable --dependency=afterok:23,afterany:21 --kill-on-invalid-dep=yes /jobs/gather.sbatch"])
        self.queue("|21|2|RUNNING|None", "|21|3|PENDING|Resources", "|23|4|PENDING|None", "-gather|24|N/A|PENDING|Dependency")
        self.assertNotIn("submitted", self.submitted("jobs"))
        self.assertEqual(self.calls(), [], "everything is in the queue")

    def test_a_gather_job_that_cannot_run_is_stated_and_replaced(self):
        self.begin()
        for index in range(1, 5):
            self.shard(index)
        self.calls()
        self.queue("|21|4|CANCELLED|None", "-gather|22|N/A|CANCELLED|DependencyNeverSatisfied")
        self.assertIn("gather job 22 was cancelled by Slurm: a task on which it depends did not end successfully\nsubmitted: gather job 23\n",
                      self.submitted("jobs"))
        self.assertEqual(self.calls(), ["sbatch --parsable /jobs/gather.sbatch"])
        self.queue("-gather|22|N/A|PENDING|DependencyNeverSatisfied")
        self.assertIn("gather job 22 would wait for ever", self.submitted("jobs"))
        self.assertEqual(self.calls(), ["scancel 22", "sbatch --parsable /jobs/gather.sbatch"])

    def test_the_state_as_a_document(self):
        self.begin()
        self.shard(2)
        self.queue("|21|1|RUNNING|None", "-gather|22|N/A|PENDING|Dependency")
        self.assertEqual(json.loads(self.submitted("jobs", "--json")), {
            "format": "asperity.submit/1", "result": f"{self.folder}/my table.tsv", "is_complete": False, "shards": 4, "complete": [2],
            "queued": [{"shard": 1, "job": "21", "state": "RUNNING", "reason": "None"}], "missing": [3, 4],
            "gathers": [{"job": "22", "state": "PENDING", "reason": "Dependency"}], "cancelled": ["22"],
            "submitted": {"shards": [3, 4], "array": "23", "gather": "24"}})

    def test_a_result_needs_neither_slurm_nor_shards(self):
        self.begin()
        (self.folder / "my table.tsv").write_text("the table\n")
        for option in ([], ["--status"], ["--watch"]):
            done = self.submit("jobs", *option, path="/nowhere")
            self.assertEqual((done.returncode, done.stdout), (0, f"{self.folder}/my table.tsv: complete\n"), done)

    def test_scripts_can_be_written_first_and_submitted_later(self):
        written = self.begin("--write-only")
        self.assertEqual(self.calls(), [])
        self.assertIn(f"to submit them: asperity submit {self.folder}/jobs\n", written)
        self.assertIn("seq 4 | parallel ", written)
        self.assertEqual(self.submitted("jobs", "--status"),
                         f"{self.folder}/my table.tsv: 0 of 4 shards complete\nnot submitted: shards 1-4\n")
        self.assertEqual(self.submitted("jobs"), "submitted: job array 21 (shards 1-4) and gather job 22\n")

    def test_errors_state_the_remedy(self):
        without = self.submit("jobs", "--slurm", "--shards", "4", "--", *SWEEP, path="/nowhere")
        self.assertEqual(without.returncode, 1, without)
        self.assertRegex(without.stderr, r"sbatch of Slurm is not in a folder of PATH.*module load slurm.*seq 4 \| parallel ")
        self.pretend("squeue", "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1")
        unknown = self.submit("jobs")
        self.assertEqual((unknown.returncode, self.calls()), (1, []), unknown)
        self.assertRegex(unknown.stderr, r"squeue --me .* exit status 1: .*Unable to contact slurm controller.*nothing was submitted")
        self.pretend("squeue", "cat queue")
        self.pretend("sbatch", "echo 'sbatch: error: invalid partition specified: nope' >&2; exit 1")
        refused = self.submit("jobs")
        self.assertRegex(refused.stderr, r"sbatch --parsable .* exit status 1: .*partition specified: nope.*correct .*/jobs/shards\.sbatch")

    def test_wrong_usage(self):
        for words, sentence in (
                (["jobs"], "holds no submission"),
                (["jobs", "--shards", "4", "--", *SWEEP], r"add --slurm\. Without a batch system: seq 4 "),
                (["jobs", "--slurm", "--", *SWEEP], "--shards is missing"),
                (["jobs", "--slurm", "--shards", "1", "--", *SWEEP], "a whole number from 2 to 1000"),
                (["jobs", "--slurm", "--shards", "4"], "--slurm needs COMMAND|--shards needs COMMAND"),
                (["jobs", "--slurm", "--shards", "4", "--", "verify", "S"], "\"verify\" cannot be divided"),
                (["jobs", "--slurm", "--shards", "4", "--", "sweep", "--model", "x"], "--out, which names the shards, is missing"),
                (["jobs", "--slurm", "--shards", "4", "--", *SWEEP, "--jobs", "2"], "write --cpus N before --"),
                (["jobs", "--slurm", "--shards", "4", "--time", "2 h", "--", *SWEEP], "--time \"2 h\" is not one word"),
                (["jobs", "--status", "--watch"], "exclude each other")):
            done = self.submit(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertTrue(re.search(sentence, done.stderr), (words, done.stderr))
        self.assertFalse((self.folder / "jobs").exists())


unittest.main()
