#define _GNU_SOURCE
// docker_like [--user UID] COMMAND...: runs a command in Docker's default conditions, without Docker. Its capabilities
// are bounded to Docker's default set, and a filter refuses what Docker's refuses to who has no more: new namespaces,
// mounts, io_uring, keyrings and other processes' memory. ptrace is allowed, as there.
#include <errno.h>
#include <grp.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__x86_64__)
#define THIS_MACHINE AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define THIS_MACHINE AUDIT_ARCH_AARCH64
#else
#error "no list of calls for this kind of processor"
#endif

static const int allowed_capabilities[] = {
    CAP_CHOWN,  CAP_DAC_OVERRIDE, CAP_FOWNER,           CAP_FSETID,  CAP_KILL,       CAP_SETGID,      CAP_SETUID,
    CAP_SETPCAP, CAP_NET_RAW,     CAP_NET_BIND_SERVICE, CAP_SYS_CHROOT, CAP_MKNOD, CAP_AUDIT_WRITE, CAP_SETFCAP};

static const int refused[] = {
    SYS_acct, SYS_add_key, SYS_bpf, SYS_clock_adjtime, SYS_clock_settime, SYS_delete_module, SYS_fanotify_init,
    SYS_finit_module, SYS_fsconfig, SYS_fsmount, SYS_fsopen, SYS_fspick, SYS_get_mempolicy, SYS_init_module,
    SYS_io_uring_enter, SYS_io_uring_register, SYS_io_uring_setup, SYS_kcmp, SYS_kexec_load, SYS_keyctl,
    SYS_lookup_dcookie, SYS_mbind, SYS_migrate_pages, SYS_mount, SYS_mount_setattr, SYS_move_mount, SYS_move_pages,
    SYS_nfsservctl, SYS_open_by_handle_at, SYS_open_tree, SYS_perf_event_open, SYS_pidfd_getfd, SYS_pivot_root,
    SYS_process_vm_readv, SYS_process_vm_writev, SYS_quotactl, SYS_reboot, SYS_request_key, SYS_set_mempolicy,
    SYS_setdomainname, SYS_sethostname, SYS_setns, SYS_settimeofday, SYS_swapoff, SYS_swapon, SYS_syslog, SYS_umount2,
    SYS_unshare, SYS_userfaultfd, SYS_vhangup};

static void die(const char* what) {
    fprintf(stderr, "docker_like: %s: %s\n", what, strerror(errno));
    exit(125);
}

static void install_filter(void) {
    enum { count = sizeof refused / sizeof *refused };
    static struct sock_filter code[3 * count + 16];
    size_t n = 0;
#define ADD(...) code[n++] = (struct sock_filter)__VA_ARGS__
#define REFUSE(error) ADD(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | (error)))
    ADD(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, arch)));
    ADD(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, THIS_MACHINE, 1, 0));
    REFUSE(ENOSYS);
    ADD(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)));
    for (size_t i = 0; i < count; ++i) {
        ADD(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (unsigned)refused[i], 0, 1));
        REFUSE(EPERM);
    }
    // what it asks for is behind a pointer: the C library falls back on clone
    ADD(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 0, 1));
    REFUSE(ENOSYS);
    ADD(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 3));
    ADD(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[0])));
    ADD(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K,
                 CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET,
                 0, 1));
    REFUSE(EPERM);
    ADD(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    struct sock_fprog filter = {(unsigned short)n, code};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) == 0) return;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) != 0)
        die("the filter");
}

static void bound_capabilities(void) {
    unsigned long long keep = 0;
    for (size_t i = 0; i < sizeof allowed_capabilities / sizeof *allowed_capabilities; ++i)
        keep |= 1ull << allowed_capabilities[i];
    for (int i = 0; prctl(PR_CAPBSET_READ, i, 0, 0, 0) >= 0; ++i)
        if (!(keep >> i & 1) && prctl(PR_CAPBSET_DROP, i, 0, 0, 0) != 0) die("the bounding set");
    struct __user_cap_header_struct head = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct sets[2];
    for (int i = 0; i < 2; ++i) {
        const unsigned half = (unsigned)(keep >> 32 * i);
        sets[i] = (struct __user_cap_data_struct){half, half, 0};
    }
    if (syscall(SYS_capset, &head, sets) != 0) die("capabilities");
}

int main(int argc, char** argv) {
    int at = 1;
    long user = -1;
    if (argc > 3 && strcmp(argv[1], "--user") == 0) user = atol(argv[2]), at = 3;
    if (at >= argc) return fprintf(stderr, "docker_like [--user UID] COMMAND...\n"), 125;
    install_filter();  // needs a capability that goes next
    if (geteuid() == 0) bound_capabilities();
    if (user >= 0 && (gid_t)user != getgid() && (setgroups(0, NULL) != 0 || setresgid(user, user, user) != 0)) die("the group");
    if (user >= 0 && setresuid(user, user, user) != 0) die("the user");
    execvp(argv[at], argv + at);
    die(argv[at]);
}
