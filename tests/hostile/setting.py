"""What all runs of the red team share."""

import os
import pathlib
import re
import socket
import subprocess
import sys
import threading
import tomllib

import box

HERE = pathlib.Path(__file__).resolve().parent


class Listener:
    """TCP, UDP and a local socket that count who calls."""

    def __init__(self):
        self.calls = 0
        self.tcp, self.udp = socket.socket(), socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.local = socket.socket(socket.AF_UNIX)
        self.name = f"hostile-{os.getpid()}"
        self.tcp.bind(("127.0.0.1", 0)), self.udp.bind(("127.0.0.1", 0)), self.local.bind("\0" + self.name)
        self.tcp.listen(), self.local.listen()
        for target in (lambda: self.accept(self.tcp), lambda: self.accept(self.local), self.answer):
            threading.Thread(target=target, daemon=True).start()

    def accept(self, listening):
        while True:
            listening.accept()[0].close()
            self.calls += 1

    def answer(self):
        while True:
            sender = self.udp.recvfrom(99)[1]
            self.calls += 1
            self.udp.sendto(b"back", sender)


def marked_lines(root):
    """Of the solution: what no output may hold."""
    found = set()
    for path in sorted((root / "solution").glob("*.cpp")):
        for block in re.findall(r"// BEGIN SOLUTION\n(.*?)// END SOLUTION", path.read_text(), re.DOTALL):
            found |= {line.strip() for line in block.splitlines() if len(line.strip()) >= 25}
    return found


class Setting:
    """A built grader, who calls, what no output may hold, and a home for each user."""

    def __init__(self, grade, work, keep, patience):
        self.grade = pathlib.Path(grade).resolve()
        chain = self.grade.parent.parent / "toolchain.toml"
        if not chain.exists():
            sys.exit(f"{chain}: not there; expected a grader in the folder of its build")
        if self.grade.is_relative_to("/tmp"):
            sys.exit(f"{self.grade}: expected a grader outside of /tmp, which is empty in a box")
        self.chain = tomllib.loads(chain.read_text())
        self.root = pathlib.Path(self.chain["source"])
        self.lines = marked_lines(self.root)
        self.listener = Listener()
        self.launcher = str(work / "docker_like")
        self.keep = keep
        self.patience = patience
        # of all runs of a user: the grader keeps the compiled header there
        self.homes = {as_root: work / ("root" if as_root else "user") for as_root in (True, False)}
        for as_root, home in self.homes.items():
            home.mkdir()
            if os.geteuid() == 0 and not as_root:
                os.chown(home, box.USER, box.USER)
        subprocess.run(["cc", "-O1", "-o", self.launcher, str(HERE / "docker_like.c")], check=True)
