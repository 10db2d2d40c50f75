#include "core/base/thread_priority.hpp"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace gaspard {

void lower_priority(int nicer) {
    const auto thread = static_cast<id_t>(syscall(SYS_gettid));
    if (nicer > 0) setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + nicer);
}

} // namespace gaspard
