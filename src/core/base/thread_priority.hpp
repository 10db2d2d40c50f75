// The priority of threads, where the system has one per thread (Linux).
#pragma once

namespace gaspard {

/// Makes this thread, and those that it starts from now on, nicer: 0 changes nothing, 19 leaves nearly all of
/// a core to others that want it. Does nothing where that is not possible.
void lower_priority(int nicer);

} // namespace gaspard
