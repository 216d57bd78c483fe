"""What lies outside of the box: secrets, other processes, the network, the kernel."""

from .kit import ANY_FAULT, attack, bomb, case, paths, quoted

SEARCH = r"""
static bool holds(const char* path) {
    const int fd = open(path, O_RDONLY);
    if (fd < 0) return false;
    std::string text(1 << 20, 0);
    const ssize_t got = read(fd, text.data(), text.size());
    close(fd);
    text.resize(got > 0 ? got : 0);
    const std::size_t at = text.find("secret-of-the");
    if (at != text.npos) std::fprintf(stderr, "%s\n", text.substr(at, 60).c_str());
    return at != text.npos;
}
extern char** environ;
"""

case("13a", "looks for secrets in the environments and arguments of all processes", ANY_FAULT, fast=True,
     source=attack("""    for (char** word = environ; *word; ++word)
        if (std::strstr(*word, "secret-of-the")) { std::fprintf(stderr, "%s\\n", *word); return true; }
    for (int pid = 1; pid < 40000; ++pid)
        for (const char* file : {"environ", "cmdline", "cwd/secret", "root/proc/1/environ"})
            if (holds(("/proc/" + std::to_string(pid) + "/" + file).c_str())) return true;
    return false;""", SEARCH))


@case("13c", "reads secret files, the solution and references", ANY_FAULT)
def _(place):
    return attack("""    for (const char* path : paths) {
        if (holds(path)) return true;
        const int fd = open(path, O_RDONLY);
        char first = 0;
        if (fd >= 0 && read(fd, &first, 1) == 1) { std::fprintf(stderr, "%s can be read\\n", path); return true; }
    }
    return false;""", SEARCH + paths(place.secret, place.root / "solution/uniform_disk.cpp", place.root / "grader/grade.cpp",
                                     place.folder / "out/record.json", "/etc/shadow", "/etc/passwd", "/root/.bashrc"))


case("24", "looks whether the grader is its parent", ANY_FAULT,
     source=attack("""    for (int pid = getppid(), steps = 0; steps < 4; ++steps) {
        const std::string folder = "/proc/" + std::to_string(pid);
        char name[99] = {};
        const int fd = open((folder + "/comm").c_str(), O_RDONLY);
        if (fd < 0) return false;
        (void)!read(fd, name, 98);
        if (std::strstr(name, "grade")) return true;
        pid = 1;
    }
    return false;"""))


@case("25a", "TCP", ANY_FAULT, fast=True)
def _(place):
    return attack(f"""    const int fd = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in to{{}};
    to.sin_family = AF_INET, to.sin_port = htons({place.tcp}), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return fd >= 0 && connect(fd, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;""")


@case("25b", "UDP", ANY_FAULT)
def _(place):
    return attack(f"""    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{{}};
    to.sin_family = AF_INET, to.sin_port = htons({place.udp}), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (fd < 0 || sendto(fd, "taken", 5, 0, reinterpret_cast<sockaddr*>(&to), sizeof to) != 5) return false;
    char back[9];
    timeval soon{{1, 0}};
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &soon, sizeof soon);
    return recv(fd, back, 9, 0) > 0;""")


@case("25c", "a socket without a file", ANY_FAULT)
def _(place):
    return attack(f"""    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un to{{}};
    to.sun_family = AF_UNIX;
    std::strcpy(to.sun_path + 1, {quoted(place.unix)});
    return fd >= 0 && connect(fd, reinterpret_cast<sockaddr*>(&to), sizeof(sa_family_t) + 1 + {len(place.unix)}) == 0;""")


case("27a", "ptrace and the memory of others", ANY_FAULT,
     source=attack("""    for (int pid : {int(getppid()), 1, int(getpid()) - 1, int(getpid()) - 2, int(getpid()) + 1}) {
        if (pid <= 0 || pid == getpid()) continue;
        char byte;
        iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
        if (syscall(SYS_process_vm_readv, pid, &here, 1ul, &there, 1ul, 0ul) == 1) return true;
        if (open(("/proc/" + std::to_string(pid) + "/mem").c_str(), O_RDONLY) >= 0) return true;
        if (ptrace(PTRACE_ATTACH, pid, 0, 0) == 0) return true;
    }
    return false;""", "#include <sys/uio.h>"))

case("27b", "kills its parent", ANY_FAULT | {"passed"}, bystander=True, seconds=90,
     source=bomb("    kill(getppid(), SIGKILL);\n    kill(0, SIGKILL);"))

case("27c", "kills everyone", {"crashed", "failed"}, bystander=True, seconds=90,
     source=attack("    return kill(-1, SIGKILL) == 0 && sleep(1) == 0;"))

case("27d", "has the kernel send SIGKILL to others, as the news of a socket", {"failed", "passed", "crashed"}, bystander=True,
     source=bomb("""    for (int pid : {int(getppid()), int(getpid()) - 1, int(getpid()) - 2, int(getpid()) - 3, int(getpid()) + 1, 2, 3}) {
        int ends[2] = {0, 2};  // where there is no other socket, those that lead to the grader
        if (pid <= 1 || pid == getpid()) continue;
        (void)!socketpair(AF_UNIX, SOCK_STREAM, 0, ends);
        fcntl(ends[0], F_SETOWN, pid), fcntl(ends[0], 10 /* F_SETSIG */, SIGKILL), fcntl(ends[0], F_SETFL, O_ASYNC);
        (void)!write(ends[1], "x", 1);
    }"""))

case("28a", "overwrites the machine code around it", ANY_FAULT, bystander=True,
     source=attack("""    auto* at = reinterpret_cast<unsigned char*>(reinterpret_cast<unsigned long>(&rt::cosine_hemisphere) & ~4095ul);
    if (mprotect(at, 4096, PROT_READ | PROT_WRITE | PROT_EXEC) == 0) std::memset(at, 0xc3, 4096);
    return false;"""))

case("41a", "namespaces and mounts of its own", ANY_FAULT, fast=True,
     source=attack("""    if (syscall(SYS_unshare, CLONE_NEWUSER | CLONE_NEWNS) == 0) return true;
    if (mount("tmpfs", "/tmp", "tmpfs", 0, nullptr) == 0) return true;
    const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0);
    if (child == 0) _exit(0);
    return child > 0;"""))

case("41b", "io_uring and keyrings", ANY_FAULT, fast=True,
     source=attack("""    char parameters[120] = {};
    if (syscall(425, 4, parameters) >= 0) return true;
    return syscall(SYS_add_key, "user", "hostile", "x", 1ul, -4l) >= 0 || syscall(SYS_keyctl, 0, -3, 1) >= 0;"""))

case("41c", "pairs of sockets, whose buffers are nobody's memory, secret memory, and news of others' files", ANY_FAULT, fast=True,
     source=attack("""    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0) return true;
    if (syscall(SYS_inotify_init1, 0) >= 0 || syscall(447 /* memfd_secret */, 0) >= 0) return true;
#ifdef SYS_inotify_init
    return syscall(SYS_inotify_init) >= 0;
#else
    return false;
#endif"""))
