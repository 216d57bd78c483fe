"""What is written, and where: the record, the disk, links and devices, state for the next run."""

import os

from .kit import ANY_FAULT, NO_FILE, attack, bomb, case, disk, paths, quoted, victim_is_whole


@case("5", "CMake files that execute at configure", "passed", after=victim_is_whole)
def _(place):
    evil = f'execute_process(COMMAND touch "{place.victim}/cmake")\nfile(WRITE "{place.victim}/file" "x")\n'
    return {"uniform_disk.cpp": disk("    return right(u);"), "CMakeLists.txt": evil, "rt/CMakeLists.txt": evil,
            "CMakePresets.json": "{", "Makefile": f"all:\n\ttouch {place.victim}/make\n"}


@case("11", "writes into the results", ANY_FAULT, absent=("HACKED",), after=victim_is_whole)
def _(place):
    return attack("    bool won = false;\n    for (const char* path : paths) {\n"
                  "        const int fd = open(path, O_WRONLY);\n"
                  '        if (fd >= 0 && write(fd, "HACKED", 6) == 6) won = true;\n'
                  f"        close(open({quoted(place.victim / 'new')}, O_WRONLY | O_CREAT, 0666));\n    }}\n    return won;",
                  paths(place.folder / "out/record.json", place.folder / "out/page/index.html", place.folder / "out/stdout",
                        place.victim / "file", place.folder / "submission/uniform_disk.cpp", place.root / "assignment.toml"))


FILL = """    std::string text(1 << 20, 'x');
    int whole = 0;
    for (const char* folder : {".", "/tmp", "/dev/shm", "/var/tmp", "/dev", "/run"})
        for (int i = 0; i < 200 && whole < 200; ++i) {
            const int fd = open((std::string(folder) + "/hostile-" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
            if (fd < 0) break;
            if (write(fd, text.data(), text.size()) == ssize_t(text.size())) ++whole;
            close(fd);
        }
"""

case("19a", "fills the disk: 200 MB", ANY_FAULT, bystander=True,
     source=attack(FILL + "    return whole >= 200;"))

case("19b", "a sparse file of 1 TB", ANY_FAULT,
     source=attack("""    signal(SIGXFSZ, SIG_IGN);
    const int fd = open("hostile-sparse", O_RDWR | O_CREAT, 0600);
    return fd >= 0 && ftruncate(fd, 1l << 40) == 0;"""))

case("19c", "20,000 files", ANY_FAULT | {"passed"}, bystander=True,
     source=bomb("""    for (int i = 0; i < 20000; ++i) {
        const int fd = open(("hostile-" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
        if (fd >= 0) close(fd);
    }"""))


def special(place, make, *more):
    folder = place.folder / "submission"
    folder.mkdir(exist_ok=True)
    make(folder / "uniform_disk.cpp", *more)
    return folder


@case("20a", "the source is a link to the solution", {"did_not_build", "not_started"}, NO_FILE, fast=True)
def _(place):
    return special(place, lambda path: path.symlink_to(place.root / "solution/uniform_disk.cpp"))


@case("20b", "the source is a FIFO", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    return special(place, os.mkfifo)


@case("20c", "the source is a link to a device", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    return special(place, lambda path: path.symlink_to("/dev/zero"))


case("20d", "puts links and FIFOs in place of all files around it", {"passed"} | ANY_FAULT, bystander=True,
     source=bomb("""    if (DIR* here = opendir(".")) {
        while (const dirent* entry = readdir(here))
            if (entry->d_name[0] != '.' && unlink(entry->d_name) == 0)
                if (mkfifo(entry->d_name, 0666) != 0) (void)!symlink("/dev/zero", entry->d_name);
        closedir(here);
    }
    (void)!mkfifo("answer", 0666);"""))

case("26", "state between runs: /tmp, /dev/shm, System V", ANY_FAULT, times=2,
     source=attack("""    bool seen = false;
    for (const char* path : {"/tmp/hostile-state", "/var/tmp/hostile-state", "/dev/shm/hostile-state", "/run/hostile-state", "../hostile-state"}) {
        if (access(path, F_OK) == 0) seen = true;
        const int fd = open(path, O_WRONLY | O_CREAT, 0666);
        if (fd >= 0) close(fd);
    }
    const long shared = syscall(SYS_shmget, 0x686f73, 4096, IPC_CREAT | IPC_EXCL | 0666);
    if (shared < 0 && errno == EEXIST) seen = true;
    const long queue = syscall(SYS_msgget, 0x686f73, IPC_CREAT | IPC_EXCL | 0666);
    if (queue < 0 && errno == EEXIST) seen = true;
    return seen;"""))

case("39a", "deep folders, mode 000", {"passed"} | ANY_FAULT, bystander=True,
     source=bomb("""    for (int i = 0; i < 400 && mkdir("hostile-deep", 0700) == 0 && chdir("hostile-deep") == 0; ++i)
        for (const char* name : {"a", "b"}) { const int fd = open(name, O_WRONLY | O_CREAT, 0); if (fd >= 0) close(fd); }
    chmod("..", 0), chmod(".", 0), chmod("../..", 0);"""))

case("43", "writes to its own program file", ANY_FAULT | {"passed"}, bystander=True,
     source=bomb("""    char self[4096] = {};
    if (readlink("/proc/self/exe", self, 4095) <= 0) return;
    chmod(self, 0777);
    int fd = open(self, O_WRONLY);
    if (fd < 0) { unlink(self); fd = open(self, O_WRONLY | O_CREAT, 0777); }
    if (fd >= 0 && write(fd, "#!/bin/false\\n", 13) == 13) std::fprintf(stderr, "written\\n");"""))
