"""A box around one run of the grader: namespaces of its own for processes, mounts and IPC, the disk read-only but for the
case's folder, /tmp and /dev/shm small, memory and processes bounded. Whatever a submission does ends with the box.

    box.py JSON     what run() writes for it; the report goes to its "report"
"""

import ctypes
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

NEWNS, NEWUSER, NEWPID, NEWIPC = 0x20000, 0x10000000, 0x20000000, 0x08000000
RDONLY, NOSUID, NODEV, BIND, REC, PRIVATE = 1, 2, 4, 4096, 16384, 1 << 18
MOUNT_SETATTR, AT_FDCWD, AT_RECURSIVE = 442, -100, 0x8000
MOST_MEMORY, MOST_PROCESSES = 3 << 30, 1500
USER = 54321  # who has nothing here
libc = ctypes.CDLL(None, use_errno=True)


def check(result, what):
    if result != 0:
        raise OSError(ctypes.get_errno(), what)


def mount(source, target, kind=None, flags=0, data=None):
    encode = lambda text: text and str(text).encode()
    check(libc.mount(encode(source), encode(target), encode(kind), ctypes.c_ulong(flags), encode(data)), f"mount {target}")


def set_read_only(path, on, recursive=True):
    attributes = (ctypes.c_uint64 * 4)(1 if on else 0, 0 if on else 1, 0, 0)
    check(libc.syscall(MOUNT_SETATTR, AT_FDCWD, str(path).encode(), AT_RECURSIVE if recursive else 0, attributes, 32),
          f"read-only {path}")


def make_mounts(spec):
    mount("none", "/", flags=REC | PRIVATE)
    writable = [spec["folder"], spec["environment"]["HOME"]]
    for folder in writable:
        mount(folder, folder, flags=BIND)
    set_read_only("/", True)
    for folder in writable:
        set_read_only(folder, False)
    mount("tmpfs", "/tmp", "tmpfs", NOSUID | NODEV, "size=400m,mode=1777")
    mount("tmpfs", "/dev/shm", "tmpfs", NOSUID | NODEV, "size=64m,mode=1777")
    mount("proc", "/proc", "proc", NOSUID | NODEV)
    if spec["profile"] == "host" and os.path.isdir("/sys/fs/cgroup") and spec["root"]:
        set_read_only("/sys", False)


def processes():
    """Of the box: by number, the name, state and program."""
    found = {}
    for entry in os.listdir("/proc"):
        if not entry.isdigit() or int(entry) == os.getpid():
            continue
        try:
            status = pathlib.Path("/proc", entry, "status").read_text()
            fields = dict(line.split(":\t", 1) for line in status.splitlines() if ":\t" in line)
            found[int(entry)] = fields
        except OSError:
            pass
    return found


def program_of(pid):
    try:
        return os.readlink(f"/proc/{pid}/exe")
    except OSError:
        return ""


def what_is_left():
    files = []
    for folder in ("/tmp", "/dev/shm"):
        for at, folders, names in os.walk(folder):
            files += [os.path.join(at, name) for name in folders + names][: 20 - len(files)]
    for kind in ("shm", "msg", "sem"):
        try:
            files += [f"{kind} {line.split()[0]}" for line in pathlib.Path("/proc/sysvipc", kind).read_text().splitlines()[1:]]
        except OSError:
            pass
    return files


def preserve(spec):
    """In the new process, before the grader: its user and limits."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if not spec["as_root"]:
        resource.setrlimit(resource.RLIMIT_NPROC, (MOST_PROCESSES, MOST_PROCESSES))
    os.setsid()
    if spec["user"] is not None and spec["profile"] != "container":
        os.setgroups([])
        os.setresgid(*[spec["user"]] * 3)
        os.setresuid(*[spec["user"]] * 3)


def start(spec, command):
    out, err = (open(os.path.join(spec["folder"], "out", name), "ab") for name in ("stdout", "stderr"))
    return subprocess.Popen(command, env=spec["environment"], cwd=spec["folder"], stdin=subprocess.DEVNULL, stdout=out,
                            stderr=err, preexec_fn=lambda: preserve(spec))


def watch(spec, command, kill_after):
    """Runs the grader once, watching its memory."""
    began = time.monotonic()
    grader = start(spec, command)
    peak, code = 0, None
    while code is None:
        for pid, fields in processes().items():
            if pid == grader.pid or program_of(pid) == spec["grade"]:
                peak = max(peak, int(fields.get("VmHWM", "0 kB").split()[0]))
        pause = 0.05
        if kill_after is not None:
            pause = max(0.0, min(pause, began + kill_after - time.monotonic()))
            if pause == 0.0:
                grader.kill()
        if time.monotonic() - began > spec["wall"]:
            grader.kill()
            return {"code": "no end", "seconds": time.monotonic() - began, "peak": peak, "left": left_after()}
        try:
            code = grader.wait(pause)
        except subprocess.TimeoutExpired:
            pass
    return {"code": code, "seconds": time.monotonic() - began, "peak": peak, "left": left_after()}


def left_after():
    """What three seconds of patience do not see go; zombies are this box's own affair."""
    deadline = time.monotonic() + 3
    while True:
        reap()
        alive = [f"{fields['Name']} ({pid})" for pid, fields in processes().items() if fields["State"][0] != "Z"]
        if not alive or time.monotonic() > deadline:
            return alive + what_is_left()
        time.sleep(0.05)


def reap():
    try:
        while os.waitpid(-1, os.WNOHANG)[0] > 0:
            pass
    except ChildProcessError:
        pass


def kill_the_rest():
    for pid in processes():
        try:
            os.kill(pid, signal.SIGKILL)
        except OSError:
            pass
    reap()


def first_process(spec):
    make_mounts(spec)
    # a Popen object must be the one to wait for its own child: reap() runs only between runs
    reports = []
    for command, kill_after in zip(spec["commands"], spec["kill_after"]):
        began = time.time()
        reports.append({**watch(spec, command, kill_after), "complete": is_complete(spec, began)})
        kill_the_rest()
    with open(spec["report"], "w") as file:
        json.dump(reports, file)


def is_complete(spec, began):
    """Of the record: whether it says so, and whether it is this run's own."""
    path = pathlib.Path(spec["folder"], "out/record.json")
    try:
        return {"complete": json.loads(path.read_text())["complete"], "own": path.stat().st_mtime >= began - 0.01}
    except (OSError, ValueError, KeyError):
        return None


def join_bounds(name):
    """Memory and processes of all that is in the box, where this machine lets us."""
    for controller, limits in {"memory": {"memory.limit_in_bytes": MOST_MEMORY}, "pids": {"pids.max": MOST_PROCESSES}}.items():
        folder = pathlib.Path("/sys/fs/cgroup", controller, name)
        try:
            folder.mkdir(exist_ok=True)
            for file, value in limits.items():
                (folder / file).write_text(str(value))
            (folder / "cgroup.procs").write_text(str(os.getpid()))
        except OSError:
            pass


def leave_bounds(name):
    for controller in ("memory", "pids"):
        try:
            os.rmdir(f"/sys/fs/cgroup/{controller}/{name}")
        except OSError:
            pass


def unshare(root):
    uid, gid = os.getuid(), os.getgid()
    check(libc.unshare((0 if root else NEWUSER) | NEWNS | NEWPID | NEWIPC), "unshare")
    if not root:
        pathlib.Path("/proc/self/setgroups").write_text("deny")
        pathlib.Path("/proc/self/uid_map").write_text(f"{uid} {uid} 1")
        pathlib.Path("/proc/self/gid_map").write_text(f"{gid} {gid} 1")


def works():
    """Whether this machine can make a box at all."""
    return subprocess.run([sys.executable, __file__, "probe"], capture_output=True).returncode == 0


def run(profile, as_root, grade, commands, folder, environment, launcher, wall=240, kill_after=None):
    """A report for each command: exit code, wall seconds, the grader's own peak memory [kB], and what was left behind."""
    root = os.geteuid() == 0
    user = USER if root and not as_root else None
    if profile == "container":
        commands = [[launcher, *(["--user", str(user)] if user else []), *command] for command in commands]
    spec = {"profile": profile, "as_root": as_root, "user": user, "root": root, "grade": str(grade), "commands": commands,
            "folder": str(folder), "environment": environment, "wall": wall, "kill_after": kill_after or [None] * len(commands),
            "report": str(folder / "report.json"), "name": f"hostile-{os.getpid()}-{folder.name}"}
    box = subprocess.Popen([sys.executable, __file__, json.dumps(spec)])
    try:
        box.wait(len(commands) * (wall + 20))
    except subprocess.TimeoutExpired:
        box.kill()
        box.wait()
    leave_bounds(spec["name"])
    try:
        return json.loads((folder / "report.json").read_text())
    except (OSError, ValueError):
        return [{"code": "no report", "seconds": 0, "peak": 0, "left": []}]


if __name__ == "__main__":
    if sys.argv[1] == "probe":
        unshare(os.geteuid() == 0)
        sys.exit(0)
    given = json.loads(sys.argv[1])
    join_bounds(given["name"])
    unshare(given["root"])
    libc.prctl(1, signal.SIGKILL)
    child = os.fork()
    if child == 0:
        libc.prctl(1, signal.SIGKILL)
        first_process(given)
        os._exit(0)
    os.waitpid(child, 0)
