// For run.cpp and run_time.cpp.
#pragma once

#include "core/base/stopwatch.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/session/run.hpp"

namespace gaspard {

/// Wall and CPU time, also of the threads of method and meter.
class Run::Timer {
  public:
    explicit Timer(const Course& course)
        : method_(course.method), others_before_(method_->other_cpu_seconds()) {}

    /// Sets the times of a report, which continue those of the last one.
    void add_to(StepReport& report, const StepReport& last, const Course& course) const {
        report.seconds = last.seconds + watch_.seconds();
        report.cpu_seconds = last.cpu_seconds + watch_.cpu_seconds() + method_->other_cpu_seconds() -
                             others_before_ + (course.measured ? course.meter->other_cpu_seconds() : 0);
    }

  private:
    Stopwatch watch_;
    std::shared_ptr<const Method> method_;
    double others_before_;
};

} // namespace gaspard
