// The cell quality of a run, as series: measured with the mesh if method.cell_quality is on.
#include "core/diagnostics/cell_quality.hpp"
#include "core/session/run.hpp"

namespace gaspard {

bool Run::measures_shapes(const Course& course) {
    return course.problem.scenario.method.values.boolean("cell_quality") &&
           diagnostics(course) == Diagnostics::full && has_quality(course.discretisation->mesh()->kind);
}

void Run::prepare_shapes(Course& course) {
    const auto mesh = course.discretisation->mesh();
    if (!measures_shapes(course))
        course.shapes.reset();
    else if (!course.shapes || course.shapes->mesh() != mesh)
        course.shapes = std::make_shared<const CellQualityMeter>(mesh);
}

SeriesValues Run::shapes(const Course& course) {
    const Points& x = course.method->positions();
    std::vector<double> monitor(x.size());
    course.data.monitor->values(x, monitor);
    return values_of(course.shapes->measure(x, monitor));
}

} // namespace gaspard
