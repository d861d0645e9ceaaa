#!/usr/bin/env python3
"""A divided sweep on a real Slurm, with failures of its nodes, has the bytes of one process, and so has a divided simulation. Argument:
the program asperity.

As root, with slurm-wlm, munge and parallel; takes two minutes. scripts/slurm-local runs the cluster.
"""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
SHARDS = 6
# One or two seconds for each shard, so that a task is found while it runs.
SWEEP = ["sweep", "--model", "pd_gradient", "--vary", "probe_diameter", "--values", "0.001,0.002", "--spacings", "0.0015:0.003:300"]


def run(*words, folder, check=True):
    done = subprocess.run([str(word) for word in words], cwd=folder, text=True, capture_output=True, check=False)
    assert not check or done.returncode == 0, (words, done)
    return done


def until(seconds, condition, what):
    """The first value of the condition that is true; nothing of the test depends on the time that it takes."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if value := condition():
            return value
        time.sleep(0.05)
    raise AssertionError(f"not within {seconds} s: {what}")


class Cluster:
    def __init__(self, folder):
        self.folder = folder

    def call(self, *words):
        return run(ROOT / "scripts" / "slurm-local", self.folder, *words, folder="/")

    def __enter__(self):
        self.call("start")
        os.environ["SLURM_CONF"] = str(self.folder / "slurm.conf")
        return self

    def __exit__(self, *unused):
        self.call("stop")

    def state_of_node(self, node):
        return run("sinfo", "--noheader", f"--nodes={node}", "--format=%T", folder="/").stdout.strip()

    def let_fail(self, command, node):
        """Until Slurm has noticed it."""
        self.call(command, node)
        until(90, lambda: self.state_of_node(node).startswith("down"), f"{node} is down")

    def start_node(self, node):
        self.call("start-node", node)
        until(60, lambda: self.state_of_node(node) in ("idle", "allocated", "mixed"), f"{node} is back")


def environment_of(process):
    with contextlib.suppress(OSError):
        return pathlib.Path("/proc", process, "environ").read_bytes().split(b"\0")
    return []


def task_on(cluster, node):
    """The process of a shard that runs on a node, and the number of the shard."""
    for process in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError, ValueError):
            words = pathlib.Path("/proc", process, "cmdline").read_bytes().split(b"\0")
            if b"--shard" not in words or b"sweep" not in words:
                continue
            environment = environment_of(process)
            if f"SLURMD_NODENAME={node}".encode() in environment and f"SLURM_CONF={cluster.folder}/slurm.conf".encode() in environment:
                return int(process), int(words[words.index(b"--shard") + 1].split(b"/")[0])
    return None


def stopped_task(cluster, node):
    """The same, halted, so that the node fails while it runs, however fast the computer is."""
    process, shard = until(60, lambda: task_on(cluster, node), f"a shard runs on {node}")
    os.kill(process, signal.SIGSTOP)
    return process, shard


class Computation:
    def __init__(self, folder, *options):
        self.folder = folder
        folder.mkdir()
        self.submit("--slurm", "--shards", SHARDS, *options, "--", *SWEEP, "--out", "table.tsv")

    def submit(self, *options):
        return run(PROGRAM, "submit", "submission", *options, folder=self.folder).stdout

    def state(self):
        return json.loads(self.submit("--status", "--json"))

    def is_complete(self):
        return self.state()["is_complete"]

    def files(self):
        return {path.name: path.read_bytes() for path in self.folder.glob("table.tsv*") if ".shard-" not in path.name}

    def start_delayed_tasks(self):
        """Slurm waits two minutes before it runs the task of a failed node again; a test need not."""
        for entry in self.state()["queued"]:
            if entry["reason"] == "BeginTime":
                run("scontrol", "update", f"jobid={entry['job']}_{entry['shard']}", "StartTime=now", folder="/", check=False)


def complete_without_failure(folder, whole):
    computation = Computation(folder)
    assert "submitted" not in computation.submit(), "a second call submits nothing twice"
    jobs = {(entry["job"], entry["shard"]) for entry in computation.state()["queued"]}
    assert len({job for job, _ in jobs}) <= 1, jobs
    until(120, computation.is_complete, "the result exists")
    assert computation.files() == whole, "array of shards"
    assert computation.submit() == f"{folder}/table.tsv: complete\n"


def node_fails(folder, cluster, whole):
    computation = Computation(folder)
    _, shard = stopped_task(cluster, "node2")
    cluster.let_fail("kill-node", "node2")
    cluster.start_node("node2")
    assert not list(folder.glob(f"*.shard-{shard}-of-*")), "a killed task leaves no shard"

    def is_complete():
        computation.start_delayed_tasks()
        return computation.is_complete()

    until(180, is_complete, "Slurm runs the task of the failed node again, and the gather job")
    assert computation.files() == whole, "a node failed"
    logs = list((folder / "submission" / "logs").glob("shard-*"))
    assert len(logs) == SHARDS, f"Slurm itself ran the task again, in the same job: {logs}"


def daemon_fails(folder, cluster, whole):
    computation = Computation(folder, "--sbatch=--no-requeue")
    process, shard = stopped_task(cluster, "node2")
    cluster.let_fail("kill-daemon", "node2")
    until(120, lambda: not computation.state()["queued"], "all other tasks end")
    state = computation.state()
    assert state["missing"] == [shard] and not state["is_complete"], state
    until(60, lambda: computation.state()["gathers"][0]["reason"] == "DependencyNeverSatisfied", "the gather job cannot run")
    stated = computation.submit("--status")
    assert f"missing: shard {shard}, task node fail" in stated, stated
    os.kill(process, signal.SIGCONT)  # the task runs on, and nobody knows of it
    until(60, lambda: computation.state()["missing"] == [], "the task completes its shard")
    assert not computation.is_complete(), "no gather job runs"
    cluster.start_node("node2")
    stated = computation.submit()
    assert "was cancelled by Slurm: a task on which it depends" in stated or "would wait for ever" in stated, stated
    assert "submitted: gather job " in stated and "job array" not in stated, stated
    until(60, computation.is_complete, "the gather job that was submitted again")
    assert computation.files() == whole, "a daemon failed"


def missing_shard_is_submitted_again(folder, whole):
    computation = Computation(folder, "--time", "1")
    run("scancel", computation.state()["queued"][0]["job"], folder="/")
    until(60, lambda: not computation.state()["queued"], "the array is cancelled")
    stated = computation.submit()
    assert "task cancelled" in stated and "submitted: job array " in stated, stated
    until(120, computation.is_complete, "the array that was submitted again")
    assert computation.files() == whole, "cancelled tasks"


def simulation(folder):
    """The joined study is that of the undivided simulation, merged alone under the same name, and joining it again changes nothing."""
    folder.mkdir()

    def program(*words):
        return run(PROGRAM, *words, folder=folder).stdout

    def files(study):
        return {path.relative_to(study): path.read_bytes() for path in study.rglob("*") if path.is_file()}

    program("new", "study", "--demo")
    simulate = ["simulate", "study/protocols/chapter_recognition.json", "--participants", "3", "--seed", "1", "--study"]
    program("submit", "submission", "--slurm", "--shards", "3", "--", *simulate, "study")
    until(120, lambda: json.loads(program("submit", "submission", "--json"))["is_complete"], "the merged study exists")
    program(*simulate, "study")
    program("merge", "study", "--out", "whole/study.merged")
    joined = files(folder / "study.merged")
    assert joined == files(folder / "whole" / "study.merged"), "a divided simulation"
    run("sbatch", "--wait", folder / "submission" / "gather.sbatch", folder=folder)  # as Slurm runs it again
    assert joined == files(folder / "study.merged"), "a joined simulation that is joined again"


def gnu_parallel(folder, whole):
    folder.mkdir()
    written = run(PROGRAM, "submit", "submission", "--slurm", "--shards", SHARDS, "--write-only", "--", *SWEEP, "--out", "table.tsv",
                  folder=folder).stdout
    line = written.split(f"without a batch system, in {folder}: ")[1].strip()
    run("bash", "-c", line, folder=folder)
    assert {path.name: path.read_bytes() for path in folder.glob("table.tsv*") if ".shard-" not in path.name} == whole, "GNU parallel"


for name in ("slurmctld", "munged", "parallel"):
    if shutil.which(name) is None:
        sys.exit(f"{name} is missing; install the packages of scripts/install long")
with tempfile.TemporaryDirectory(prefix="slurm-", dir="/tmp") as place:
    place = pathlib.Path(place)
    place.chmod(0o755)  # munged requires that all can reach its socket
    (place / "whole").mkdir()
    run(PROGRAM, *SWEEP, "--jobs", "1", "--out", "table.tsv", folder=place / "whole")
    one_process = {path.name: path.read_bytes() for path in (place / "whole").iterdir()}
    with Cluster(place / "c") as local:
        complete_without_failure(place / "array", one_process)
        print("array of shards: the bytes of one process")
        simulation(place / "simulation")
        print("array of shards of a simulation, joined twice: the study of one process")
        missing_shard_is_submitted_again(place / "cancelled", one_process)
        print("cancelled tasks, submitted again: the bytes of one process")
        node_fails(place / "node", local, one_process)
        print("a node that failed in the middle of the array: the bytes of one process")
        daemon_fails(place / "daemon", local, one_process)
        print("a daemon that failed while its task ran on: the bytes of one process")
    gnu_parallel(place / "parallel", one_process)
    print("GNU parallel: the bytes of one process")
