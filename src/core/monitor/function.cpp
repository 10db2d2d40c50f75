#include "core/monitor/function.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/monitor/own_problem.hpp"

#include <utility>

namespace gaspard {

namespace {

class FunctionMonitor final : public Monitor {
  public:
    FunctionMonitor(std::function<double(Vec3)> function, Space space)
        : function_(std::move(function)), extent_{.space = space} {
        if (!function_) throw InputError("function_monitor: the function is empty");
    }

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = function_(is_inside(extent_, x[i]) ? x[i] : into(extent_, x[i]));
        check_positive(x, values);
    }
    std::optional<SpaceKind> made_for() const override { return extent_.space.kind; }

  private:
    std::function<double(Vec3)> function_;
    DomainExtent extent_;
};

} // namespace

std::shared_ptr<const Monitor> function_monitor(std::function<double(Vec3)> function, Space space) {
    return std::make_shared<FunctionMonitor>(std::move(function), space);
}

} // namespace gaspard
