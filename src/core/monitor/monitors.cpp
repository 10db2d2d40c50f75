#include "core/monitor/monitor.hpp"

namespace gaspard {

MonitorType ring_monitor();
MonitorType bell_monitor();
MonitorType constant_monitor();
MonitorType x_n_monitor();
MonitorType cross_monitor();
MonitorType ring_and_bell_monitor();
MonitorType random_bells_monitor();
MonitorType random_waves_monitor();
MonitorType circle_monitor();
MonitorType spiral_monitor();
MonitorType three_circles_monitor();
MonitorType two_circles_monitor();
MonitorType cosine_waves_monitor();
MonitorType sine_waves_monitor();
MonitorType typed_formula_monitor();
MonitorType image_file_monitor();
MonitorType field_file_monitor();
MonitorType flow_monitor_type();
MonitorType burgers_monitor_type();
MonitorType derived_monitor_type();
MonitorType combined_monitor_type();
MonitorType layer_monitor_type();
MonitorType two_layers_monitor_type();
MonitorType layer_tensor_monitor_type();

std::vector<MonitorType> monitor_types() {
    return {ring_monitor(),
            bell_monitor(),
            constant_monitor(),
            x_n_monitor(),
            cross_monitor(),
            ring_and_bell_monitor(),
            random_bells_monitor(),
            random_waves_monitor(),
            circle_monitor(),
            spiral_monitor(),
            three_circles_monitor(),
            two_circles_monitor(),
            cosine_waves_monitor(),
            sine_waves_monitor(),
            typed_formula_monitor(),
            image_file_monitor(),
            field_file_monitor(),
            flow_monitor_type(),
            burgers_monitor_type(),
            derived_monitor_type(),
            combined_monitor_type(),
            layer_monitor_type(),
            two_layers_monitor_type(),
            layer_tensor_monitor_type()};
}

} // namespace gaspard
