#include "programs/walls.h"

#include <asm/sockios.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <linux/securebits.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>

namespace grade {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t processor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t processor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t processor = 0;
#endif

/// Numbers that are one on all kinds of processors, and newer than some systems' headers.
constexpr int fchmodat2 = 452, setxattrat = 463, removexattrat = 466, file_setattr = 469, memfd_secret = 447;

/// Never needed by a compiler or a fragment.
constexpr int never[] = {SYS_unshare,
                         SYS_setns,
                         SYS_mount,
                         SYS_umount2,
                         SYS_pivot_root,
                         SYS_chroot,
                         SYS_open_tree,
                         SYS_move_mount,
                         SYS_fsopen,
                         SYS_fsconfig,
                         SYS_fsmount,
                         SYS_fspick,
                         SYS_mount_setattr,
                         SYS_io_uring_setup,
                         SYS_io_uring_enter,
                         SYS_io_uring_register,
                         SYS_ptrace,
                         SYS_process_vm_readv,
                         SYS_process_vm_writev,
                         SYS_process_madvise,
                         SYS_kcmp,
                         SYS_pidfd_open,
                         SYS_pidfd_getfd,
                         SYS_pidfd_send_signal,
                         SYS_add_key,
                         SYS_request_key,
                         SYS_keyctl,
                         SYS_bpf,
                         SYS_perf_event_open,
                         SYS_userfaultfd,
                         SYS_kexec_load,
                         SYS_init_module,
                         SYS_finit_module,
                         SYS_delete_module,
                         SYS_swapon,
                         SYS_swapoff,
                         SYS_reboot,
                         SYS_acct,
                         SYS_quotactl,
                         SYS_settimeofday,
                         SYS_clock_settime,
                         SYS_adjtimex,
                         SYS_clock_adjtime,
                         SYS_sethostname,
                         SYS_setdomainname,
                         SYS_name_to_handle_at,
                         SYS_open_by_handle_at,
                         SYS_fanotify_init,
                         SYS_socket,
                         SYS_socketpair,  // buffers of the kernel's, beside a program's memory
                         SYS_shmget,
                         SYS_shmat,
                         SYS_msgget,
                         SYS_semget,
                         SYS_mq_open,
                         SYS_setsid,
                         SYS_setpgid,
                         SYS_setpriority,
                         SYS_ioprio_set,
                         SYS_sched_setaffinity,
                         SYS_sched_setscheduler,
                         SYS_sched_setparam,
                         SYS_sched_setattr,
                         SYS_personality,
                         SYS_migrate_pages,
                         SYS_move_pages,
                         SYS_kill,
                         SYS_tkill,
                         SYS_rt_sigqueueinfo,
                         SYS_rt_tgsigqueueinfo,
                         SYS_memfd_create,
                         memfd_secret,
#ifdef __x86_64__
                         SYS_inotify_init,
#endif
                         SYS_inotify_init1};

/// What a tool does to its files, and a fragment has no need of: Landlock has no rules for these.
constexpr int tools_only[] = {
    SYS_truncate,  SYS_fchmod,    SYS_fchmodat,    SYS_fchown,       SYS_fchownat,     SYS_utimensat, SYS_setxattr,
    SYS_lsetxattr, SYS_fsetxattr, SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr, fchmodat2,     setxattrat,
    removexattrat, file_setattr,
#ifdef __x86_64__
    SYS_chmod,     SYS_chown,     SYS_lchown,      SYS_utime,        SYS_utimes,       SYS_futimesat, SYS_creat,
#endif
};

struct Filter : SystemCalls {
    Filter(Starts starts, bool alone) {
        load(offsetof(seccomp_data, arch));
        jump(BPF_JEQ, processor, 1, 0);
        end(SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
#ifdef __x86_64__
        jump(BPF_JGE, 0x40000000, 0, 1);  // the same calls under other numbers
        end(SECCOMP_RET_KILL_PROCESS);
#endif
        for (const int call : never) deny(call, EPERM);
        deny(SYS_clone3, ENOSYS);  // its flags are in memory, where no filter can look; clone takes its place
        deny(SYS_openat2, ENOSYS);
        refuse_if(SYS_prctl, 0, BPF_JEQ, PR_SET_PDEATHSIG);
        for (const std::uint32_t request : {TIOCSTI, FIOSETOWN, SIOCSPGRP}) refuse_if(SYS_ioctl, 1, BPF_JEQ, request);
        for (const std::uint32_t command : {F_SETOWN, F_SETSIG, F_SETOWN_EX})
            refuse_if(SYS_fcntl, 1, BPF_JEQ, command);  // signals
        refuse_unless(SYS_prlimit64, 0, BPF_JEQ, 0);
        if (starts == Starts::programs) {
            refuse_if(SYS_clone, 0, BPF_JSET,
                      CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID |
                          CLONE_NEWNET | CLONE_NEWTIME);
        } else {
            for (const int call : tools_only) deny(call, EPERM);
            refuse_if(SYS_openat, 2, BPF_JSET, O_TRUNC);
            refuse_if(SYS_clone, 0, BPF_JSET,
                      CLONE_THREAD);  // one thread is enough for an answer, and many would be the user's
            kill_at(SYS_clone);
#ifdef __x86_64__
            refuse_if(SYS_open, 1, BPF_JSET, O_TRUNC);
            kill_at(SYS_fork);
            kill_at(SYS_vfork);
#endif
        }
        if (alone) {
            own_number = code.size() + 2;
            refuse_unless(SYS_tgkill, 0, BPF_JEQ, 0);
        }
        end(SECCOMP_RET_ALLOW);
    }

private:
    static constexpr std::uint32_t refuse(std::uint32_t error) { return SECCOMP_RET_ERRNO | error; }

    void load(std::size_t offset) { code.push_back({BPF_LD | BPF_W | BPF_ABS, 0, 0, std::uint32_t(offset)}); }
    void jump(int test, std::uint32_t value, int then, int otherwise) {
        code.push_back({std::uint16_t(BPF_JMP | test | BPF_K), std::uint8_t(then), std::uint8_t(otherwise), value});
    }
    void end(std::uint32_t result) { code.push_back({BPF_RET | BPF_K, 0, 0, result}); }

    void deny(int call, std::uint32_t error) {
        jump(BPF_JEQ, std::uint32_t(call), 0, 1);
        end(refuse(error));
    }

    void kill_at(int call) {
        jump(BPF_JEQ, std::uint32_t(call), 0, 1);
        end(SECCOMP_RET_KILL_PROCESS);
    }

    void refuse_if(int call, int argument, int test, std::uint32_t value) { decide(call, argument, test, value, 0, 1); }
    void refuse_unless(int call, int argument, int test, std::uint32_t value) {
        decide(call, argument, test, value, 1, 0);
    }

    /// Refuses a call by the lower half of one of its arguments, or looks further.
    void decide(int call, int argument, int test, std::uint32_t value, int then, int otherwise) {
        jump(BPF_JEQ, std::uint32_t(call), 0, 4);
        load(offsetof(seccomp_data, args) + sizeof(std::uint64_t) * std::size_t(argument));
        jump(test, value, then, otherwise);
        end(refuse(EPERM));
        load(offsetof(seccomp_data, nr));
    }
};

// Landlock's rights, of which older headers do not know all.
constexpr std::uint64_t run_and_read = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE,
                        read_folder = LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t of_files = run_and_read | LANDLOCK_ACCESS_FS_WRITE_FILE | 1u << 14 | 1u << 15;

/// The rights that a version knows: for files, for TCP, and what is kept within.
struct Rights {
    std::uint64_t files, net, scope;
};

Rights rights(int version) {
    const int count = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    return {(1u << count) - 1, version >= 4 ? 3u : 0u, version >= 6 ? 3u : 0u};
}

std::size_t size_of_rights(int version) { return version >= 6 ? 24 : version >= 4 ? 16 : 8; }

void allow(int rules, const std::filesystem::path& path, std::uint64_t access) {
    const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (place < 0) return;
    struct stat facts {};
    fstat(place, &facts);
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = S_ISDIR(facts.st_mode) ? access : access & of_files;
    beneath.parent_fd = place;
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
    close(place);
}

}  // namespace

SystemCalls allowed_calls(Starts starts, bool alone) {
    if (processor == 0) return {};
    return Filter(starts, alone);
}

int landlock_version() {
    static const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? int(version) : 0;
}

int landlock_rules(const std::vector<std::filesystem::path>& readable,
                   const std::vector<std::filesystem::path>& writable) {
    const int version = landlock_version();
    if (version == 0) return -1;
    const Rights all = rights(version);
    const int rules = int(syscall(SYS_landlock_create_ruleset, &all, size_of_rights(version), 0));
    if (rules < 0) return -1;
    for (const auto& path : readable) allow(rules, path, run_and_read | read_folder);
    for (const auto& path : writable) allow(rules, path, all.files);
    return rules;
}

bool Walls::lock_in() {
    if (user > 0) {
        if (syscall(SYS_setgroups, 0, nullptr) != 0 || syscall(SYS_setresgid, user, user, user) != 0 ||
            syscall(SYS_setresuid, user, user, user) != 0)
            return false;
    } else {
        // root without its powers: a program that it starts does not get them back
        prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED);
        __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
        const __user_cap_data_struct none[2] = {};
        if (syscall(SYS_capset, &head, none) != 0) return false;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of user has taken it away
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
    if (files >= 0 && syscall(SYS_landlock_restrict_self, files, 0) != 0) return false;
    if (calls.own_number > 0) calls.code[calls.own_number].k = std::uint32_t(getpid());
    const sock_fprog program{static_cast<unsigned short>(calls.code.size()), calls.code.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace grade
