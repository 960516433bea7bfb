// SPDX-License-Identifier: Apache-2.0
#include "sandbox.h"

#include <fcntl.h>
#include <seccomp.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>

namespace vs::decoder {
namespace {

// What reading never needs. Not a list of what it does need, which differs from one C library to the next.
constexpr std::array kForbidden{
    // Changing files and folders; opening for writing is forbidden below.
    SCMP_SYS(creat), SCMP_SYS(truncate), SCMP_SYS(unlink), SCMP_SYS(unlinkat), SCMP_SYS(rename),
    SCMP_SYS(renameat), SCMP_SYS(renameat2), SCMP_SYS(mkdir), SCMP_SYS(mkdirat), SCMP_SYS(rmdir),
    SCMP_SYS(link), SCMP_SYS(linkat), SCMP_SYS(symlink), SCMP_SYS(symlinkat), SCMP_SYS(mknod),
    SCMP_SYS(mknodat), SCMP_SYS(chmod), SCMP_SYS(fchmod), SCMP_SYS(fchmodat), SCMP_SYS(chown),
    SCMP_SYS(fchown), SCMP_SYS(lchown), SCMP_SYS(fchownat), SCMP_SYS(setxattr), SCMP_SYS(lsetxattr),
    SCMP_SYS(fsetxattr), SCMP_SYS(removexattr), SCMP_SYS(lremovexattr), SCMP_SYS(fremovexattr),
    SCMP_SYS(utime), SCMP_SYS(utimes), SCMP_SYS(futimesat), SCMP_SYS(utimensat), SCMP_SYS(open_by_handle_at),
    SCMP_SYS(open_tree), SCMP_SYS(move_mount), SCMP_SYS(fsopen), SCMP_SYS(mount), SCMP_SYS(umount2),
    SCMP_SYS(chroot), SCMP_SYS(pivot_root),
    // Networks.
    SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(connect), SCMP_SYS(bind), SCMP_SYS(listen),
    SCMP_SYS(accept), SCMP_SYS(accept4),
    // Other programs and processes. abort() raises its signal by tgkill.
    SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(kill), SCMP_SYS(tkill), SCMP_SYS(rt_sigqueueinfo),
    SCMP_SYS(rt_tgsigqueueinfo), SCMP_SYS(pidfd_send_signal), SCMP_SYS(pidfd_getfd), SCMP_SYS(ptrace),
    SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(pidfd_open), SCMP_SYS(unshare),
    SCMP_SYS(setns),
    // What has often been a way around filters.
    SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(keyctl), SCMP_SYS(add_key),
    SCMP_SYS(request_key), SCMP_SYS(io_uring_setup)};

// Forbids opening files for writing, the flags being the argument of that number.
void forbidWriting(scmp_filter_ctx filter, int call, unsigned flagsAt) {
    const auto where = [&](std::uint64_t bits, std::uint64_t value) {
        return scmp_arg_cmp{flagsAt, SCMP_CMP_MASKED_EQ, bits, value};
    };
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 1, where(O_ACCMODE, O_WRONLY));
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 1, where(O_ACCMODE, O_RDWR));
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 1, where(O_CREAT, O_CREAT));
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 1, where(O_TRUNC, O_TRUNC));
}

} // namespace

void closeSandbox() {
    const std::unique_ptr<void, void (*)(void*)> filter(seccomp_init(SCMP_ACT_ALLOW), seccomp_release);
    if (!filter) {
        return;
    }
    for (const int call : kForbidden) {
        seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 0);
    }
    forbidWriting(filter.get(), SCMP_SYS(open), 1);
    forbidWriting(filter.get(), SCMP_SYS(openat), 2);
    // Its flags lie in memory, where a filter cannot look; the C library goes back to openat.
    seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(openat2), 0);
    seccomp_load(filter.get());
}

} // namespace vs::decoder
