"""A Slurm cluster of virtual nodes on this machine, in a folder of its own."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import run, skip  # noqa: E402

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol")

SETTINGS = """
ClusterName=grading
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=2
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/%n.pid
SlurmdSpoolDir={folder}/spool-%n
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SlurmdTimeout=8
KillWait=2
MinJobAge=3600
ReturnToService=2
SlurmdParameters=config_overrides
"""


def free_ports(count):
    """That nobody has at the moment."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Its nodes have process numbers of their own: when the first process of one is killed, all of the node are gone."""

    def __init__(self, folder, nodes):
        self.folder = folder
        self.processes = []
        self.node = {}
        os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
        (folder / "munge").mkdir(parents=True, mode=0o755)
        (folder / "state").mkdir()
        (folder / "munge/key").write_bytes(os.urandom(1024))
        (folder / "munge/key").chmod(0o400)
        host, ports = socket.gethostname().split(".")[0], free_ports(nodes + 1)
        conf = SETTINGS.format(host=host, ports=ports, folder=folder)
        for number, port in enumerate(ports[1:], 1):
            conf += f"NodeName=n{number} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1\n"
        (folder / "slurm.conf").write_text(conf + "PartitionName=all Nodes=ALL Default=YES State=UP\n")
        munge = [f"--{what}={folder}/munge/{what.split('-')[0]}" for what in ("key-file", "socket", "pid-file", "log-file", "seed-file")]
        self.start("munged", "--foreground", "--force", *munge)
        self.until(lambda: (folder / "munge/socket").exists(), "munged")
        self.start("slurmctld", "-D", "-i")
        for name in (f"n{number}" for number in range(1, nodes + 1)):
            self.start_node(name)

    def start(self, *command):
        with open(self.folder / "said", "ab") as said:
            self.processes.append(subprocess.Popen(command, stdout=said, stderr=said, stdin=subprocess.DEVNULL))
        return self.processes[-1]

    def start_node(self, name):
        self.node[name] = self.start("unshare", "--pid", "--fork", "--kill-child", "--mount-proc", "slurmd", "-D", "-N", name)

    def kill_node(self, name):
        """As when its power fails."""
        first = pathlib.Path(f"/proc/{self.node[name].pid}/task/{self.node[name].pid}/children").read_text().split()
        os.kill(int(first[0]), signal.SIGKILL)
        self.node[name].wait()

    def until(self, holds, what, patience=60):
        deadline = time.monotonic() + patience
        while not holds():
            if time.monotonic() > deadline:
                raise SystemExit(f"{what}: not after {patience} s\n{(self.folder / 'said').read_text()[-3000:]}")
            time.sleep(0.2)

    def ready(self):
        self.until(lambda: "idle" in subprocess.run(["sinfo", "-h", "-o", "%T"], capture_output=True, text=True).stdout.split(), "a node")

    def jobs(self):
        """Facts of each job, by name: JobState, NodeList, Restarts, ExitCode, ..."""
        return [dict(word.split("=", 1) for word in line.split() if "=" in word)
                for line in run(["scontrol", "-o", "show", "job"]).splitlines() if line.startswith("JobId")]

    def stop(self):
        for name, node in self.node.items():
            if node.poll() is None:
                self.kill_node(name)
        for process in self.processes:
            process.terminate()
            process.wait()


def cluster(folder, nodes):
    """Ready to take jobs. Ends the test where there can be none."""
    missing = [name for name in (*PROGRAMS, "unshare") if not shutil.which(name)]
    if missing:
        skip(f"no {', '.join(missing)} here (apt-get install slurm-wlm munge)")
    if os.geteuid() != 0:
        skip("only root can start nodes that run what users ask for")
    if subprocess.run(["unshare", "--pid", "--fork", "--mount-proc", "true"], capture_output=True).returncode != 0:
        skip("no namespaces here, in which a node would run")
    return Cluster(folder, nodes)
