"""What does not end, or ends too soon; processes, threads and memory."""

from .kit import HEAD, bomb, case, disk, outputs_are_short

case("10b", "100 MB on stdout and on stderr", "passed", bystander=True, after=outputs_are_short, own=True,
     source=bomb("""    const std::string text(1 << 16, 'x');
    for (int i = 0; i < 1600; ++i) (void)!write(1 + i % 2, text.data(), text.size());"""))

case("14a", "an endless loop", "timed_out", "ran longer than", own=True,
     source=disk("    volatile bool on = true;\n    while (on) {}\n    return right(u);"))

case("14b", "sleeps", "timed_out", "waits", own=True, seconds=90,
     source=disk("    sleep(1000);\n    return right(u);"))

case("14c", "raises its own limits and runs on", "timed_out", ("longer", "waits"), seconds=90,
     source=disk("""    rlimit all{};
    getrlimit(RLIMIT_CPU, &all);
    all.rlim_cur = all.rlim_max;
    setrlimit(RLIMIT_CPU, &all);
    signal(SIGXCPU, SIG_IGN);
    volatile bool on = true;
    while (on) {}
    return right(u);"""))

OWN_NAME = 'static const int named = prctl(PR_SET_NAME, "hostile");'

case("15", "a fork bomb of 256 processes", {"crashed", "timed_out"}, "starts other programs", bystander=True, seconds=90, fast=True,
     source=bomb("    for (int i = 0; i < 8; ++i) fork();\n    sleep(20);", OWN_NAME))

case("15b", "starts another program", {"crashed", "failed"}, "starts other programs",
     source=bomb("""    const pid_t child = fork();
    if (child == 0) { execl("/bin/true", "true", nullptr); _exit(9); }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) std::abort();"""))

RUN = '    const char* words[] = {"/bin/sh", "-c", "exit 42", nullptr};\n'

case("15d", "becomes another program", "crashed", "starts other programs", bystander=True, fast=True,
     source=bomb(RUN + "    execv(words[0], const_cast<char**>(words));"))

case("15e", "becomes another program before main, by a number of the kernel's", "crashed", "starts other programs",
     source=disk("    return right(u);", f"""
[[gnu::constructor]] static void first() {{
{RUN}    syscall(SYS_execveat, AT_FDCWD, words[0], words, nullptr, 0);
}}"""))

case("15c", "1,400 threads", {"passed", "crashed", "timed_out"}, bystander=True, seconds=90,
     source=bomb("""    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 1 << 16);
    pthread_t thread;
    for (int i = 0; i < 1400; ++i)
        if (pthread_create(&thread, &small, [](void*) -> void* { sleep(15); return nullptr; }, nullptr) != 0) break;
    sleep(10);""", "#include <pthread.h>"))

case("16a", "2.9 GB of memory", "crashed", "memory", bystander=True, own=True, seconds=120, jobs=1,
     source=bomb("""    for (int i = 0; i < 29; ++i) std::memset(new char[100 << 20], 1 + i, 100 << 20);"""))

case("16b", "2.9 GB of memory, spread over seven children", {"crashed", "timed_out"}, ("memory", "GB", "other programs"), bystander=True, seconds=120,
     jobs=1,
     source=bomb("""    for (int i = 0; i < 7; ++i)
        if (fork() == 0) { std::memset(new char[420 << 20], 1 + i, 420 << 20); sleep(8); _exit(0); }
    while (wait(nullptr) > 0) {}""", OWN_NAME))

case("17", "a daemon, forked twice", {"passed", "crashed"}, bystander=True,
     source=bomb("    if (fork() == 0) { setsid(); if (fork() == 0) { sleep(100); _exit(0); } _exit(0); }", OWN_NAME))

case("18", "a child that holds stdout and all else open", {"passed", "crashed"}, seconds=40,
     source=bomb("    if (fork() == 0) { setsid(); sleep(100); _exit(0); }", OWN_NAME))

case("40a", "stops itself", "timed_out", ("waits", "stopped", "stop"), seconds=90,
     source=bomb("    raise(SIGSTOP);"))

case("40b", "stops its parent", {"timed_out", "passed", "crashed"}, seconds=90, bystander=True,
     source=bomb("    kill(getppid(), SIGSTOP);"))

case("40c", "kills process 1", {"crashed", "passed", "failed"}, absent=("out of memory",), seconds=90, bystander=True,
     source=bomb("    kill(1, SIGKILL);"))

case("40d", "closes all descriptors", {"crashed", "timed_out"}, own=True, seconds=90,
     source=bomb("    for (int fd = 0; fd < 1024; ++fd) close(fd);"))

case("42", "one second of sleep for each answer", "timed_out", ("longer", "too long", "waits", "budget"), seconds=120, own=True,
     source=disk("    static int calls = 0;\n    if (calls++ % 50 == 0) usleep(1000000);\n    return right(u);"))

case("42b", "waits until it is given up, and ends by itself then", "timed_out", "waits", seconds=90, fragments=("mirror_direction",),
     source={"mirror_direction.cpp": HEAD + """namespace rt {
vec3 mirror_direction(vec3 d, vec3) {
    char byte;
    while (read(0, &byte, 1) > 0) {}
    _exit(int(d.x) & 1);
}
}  // namespace rt
"""})

case("42c", "computes for 4 s and ends by itself, in each of 13 checks", {"crashed", "timed_out"}, "too long in all", seconds=120,
     fragments=("light_sample",), source={"light_sample.cpp": HEAD + """namespace rt {
LightSample light_sample(const Emitter&, vec3, vec2) {
    while (clock() < 4 * CLOCKS_PER_SEC) {}
    _exit(0);
}
}  // namespace rt
"""})
