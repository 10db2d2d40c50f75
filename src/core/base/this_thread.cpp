#include "core/base/this_thread.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace gaspard {

void name_thread(const char* name) { pthread_setname_np(pthread_self(), name); }

void lower_priority(int nicer) {
    const auto thread = static_cast<id_t>(syscall(SYS_gettid));
    if (nicer > 0) setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + nicer);
}

} // namespace gaspard
