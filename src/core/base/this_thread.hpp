// The name and the priority of threads, where the system has them (Linux).
#pragma once

namespace gaspard {

/// Names this thread, and those that it starts from now on, for `ps -T`, debuggers and profilers; at most 15
/// letters.
void name_thread(const char* name);

/// Makes this thread, and those that it starts from now on, nicer: 0 changes nothing, 19 leaves nearly all of
/// a core to others that want it. Does nothing where that is not possible.
void lower_priority(int nicer);

} // namespace gaspard
