#include "core/monitor/monitor.hpp"

namespace gaspard {

std::vector<MonitorType> monitor_types() { return {ring_monitor(), bell_monitor(), constant_monitor()}; }

} // namespace gaspard
