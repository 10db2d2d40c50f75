#include "core/tessellate/interval_plots.hpp"

#include "core/base/check.hpp"
#include "core/tessellate/blend.hpp"
#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t adapted_colour = 0, uniform_colour = 1, second_colours = 2;
constexpr double edge = 0.02; // of the axis, beyond the ends of the interval

enum class XAxis { linear, log_left, log_right };

XAxis x_axis_of(const Values& view) {
    const std::string& name = view.text("x_axis");
    return name == "log-left" ? XAxis::log_left : name == "log-right" ? XAxis::log_right : XAxis::linear;
}

/// Which places come first, by where they are in the computational mesh.
std::vector<std::size_t> ordered(const std::vector<double>& xi) {
    std::vector<std::size_t> order(xi.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!std::is_sorted(xi.begin(), xi.end()))
        std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return xi[i] < xi[j]; });
    return order;
}

std::vector<double> picked(const std::vector<double>& values, const std::vector<std::size_t>& order) {
    std::vector<double> found(order.size());
    std::transform(order.begin(), order.end(), found.begin(), [&](std::size_t i) { return values[i]; });
    return found;
}

/// The axis of one coordinate of the interval, and the values that it shows: the coordinate, or the distance
/// from an end.
struct Coordinate {
    double a = 0, b = 1;
    XAxis kind = XAxis::linear;

    double distance(double p) const {
        return kind == XAxis::linear ? p : kind == XAxis::log_left ? p - a : b - p;
    }
    std::vector<double> distances(const std::vector<double>& p) const {
        std::vector<double> d(p.size());
        std::transform(p.begin(), p.end(), d.begin(), [this](double one) { return distance(one); });
        return d;
    }
    std::string before() const {
        const double end = kind == XAxis::log_left ? a : b;
        if (kind == XAxis::linear || (kind == XAxis::log_left && end == 0)) return {};
        const std::string sign = kind == XAxis::log_left ? "+" : "−";
        return end == 0 ? sign : short_number(end, 12) + " " + sign + " ";
    }
    /// `shown`: values of which those that an axis can show are to be seen.
    Axis axis(std::string label, const std::vector<const std::vector<double>*>& shown) const {
        Axis made{.label = std::move(label), .logarithmic = kind != XAxis::linear};
        made.reversed = kind == XAxis::log_right;
        made.before = before();
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const auto* values : shown)
            for (const double value : *values) {
                if (!std::isfinite(value) || (made.logarithmic && !(value > 0))) continue;
                low = std::min(low, value), high = std::max(high, value);
            }
        if (!(low < high)) return made;
        const double ratio = made.logarithmic ? std::pow(high / low, edge) : 1, more = edge * (high - low);
        made.low = made.logarithmic ? low / ratio : low - more;
        made.high = made.logarithmic ? high * ratio : high + more;
        return made;
    }
};

/// What a curve needs: x never decreases where the mesh is sound.
Curve curve_of(std::vector<double> x, std::vector<double> y, bool reversed) {
    if (reversed) {
        std::reverse(x.begin(), x.end());
        std::reverse(y.begin(), y.end());
    }
    return {.label = {}, .x = std::move(x), .y = std::move(y)};
}

/// A field on one of both meshes.
struct Component {
    const std::vector<double>* values = nullptr;
    bool uniform = false;
    std::size_t number = 1;
};

std::vector<Component> components_of(const Snapshot& snapshot, const std::string& name, FieldPlace place,
                                     const std::vector<double>& values) {
    std::vector<Component> found{{&values, false, 1}};
    const auto add = [&](const std::string& other, bool uniform, std::size_t number) {
        const Field* field = snapshot.field(other);
        const bool fits = field != nullptr && field->place == place && field->values.size() == values.size();
        if (fits) found.push_back({&field->values, uniform, number});
        return fits;
    };
    std::size_t count = 1;
    while (add(name + "_" + std::to_string(count + 1), false, count + 1)) ++count;
    for (std::size_t k = 1; k <= count; ++k)
        add(name + (k > 1 ? "_" + std::to_string(k) : "") + "_uniform", true, k);
    return found;
}

std::string legend_of(const Component& part, bool several) {
    std::string mesh = part.uniform ? "uniform mesh" : "adapted mesh";
    return several ? "component " + std::to_string(part.number) + ", " + mesh : mesh;
}

class Maker {
  public:
    Maker(const Snapshot& snapshot, const Values& view, ColouringMaker& cells)
        : snapshot_(snapshot), view_(view), nodes_(ordered(snapshot.mesh->nodes.x)),
          xi_(picked(snapshot.mesh->nodes.x, nodes_)), x_(picked(snapshot.x.x, nodes_)),
          colouring_(cells.make(snapshot, colour_choice(view))) {
        const double t = view.real("blend");
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = blended(xi_[i], x_[i], t);
        order_cells();
        coordinate_ = {xi_.front(), xi_.back(), x_axis_of(view)};
        physical_ = coordinate_.distances(x_);
        uniform_ = coordinate_.distances(xi_);
    }

    bool has_values() const { return colouring_.has_value(); }

    /// Over x: the values on both meshes, or xi(x), and where the nodes are.
    IntervalColumn over_x(std::string title) const {
        const bool reversed = coordinate_.kind == XAxis::log_right;
        const Axis x = coordinate_.axis("x", {&physical_, &uniform_});
        IntervalColumn column;
        column.values.title = std::move(title);
        column.values.x = x;
        if (has_values()) {
            add_values(column.values, physical_, uniform_, reversed);
        } else {
            column.values.y.label = "ξ";
            column.values.curves.push_back(as_nodes(curve_of(physical_, xi_, reversed)));
        }
        if (view_.boolean("lines")) {
            column.values.rows.push_back({curve_of(physical_, {}, reversed).x, adapted_colour});
            column.values.rows.push_back({curve_of(uniform_, {}, reversed).x, uniform_colour});
        }
        column.spacing = spacing(x, cell_middles(true), cell_middles(false), reversed);
        return column;
    }

    /// Over xi: the values at the same nodes, equidistant, or x(xi).
    IntervalColumn over_xi(std::string title) const {
        const Coordinate linear{coordinate_.a, coordinate_.b};
        const Axis xi = linear.axis("ξ", {&xi_});
        IntervalColumn column;
        column.values.title = std::move(title);
        column.values.x = xi;
        if (has_values()) {
            add_values(column.values, xi_, {}, false);
        } else {
            column.values.y = coordinate_.axis("x", {&physical_});
            column.values.curves.push_back(as_nodes(curve_of(xi_, physical_, false)));
        }
        const std::vector<double> between = middles_of_cells(xi_by_node_);
        column.spacing = spacing(xi, between, between, false);
        return column;
    }

  private:
    /// Cells from left to right in the computational mesh.
    void order_cells() {
        const Mesh& mesh = *snapshot_.mesh;
        xi_by_node_ = mesh.nodes.x, x_by_node_.resize(mesh.node_count());
        for (std::size_t i = 0; i < nodes_.size(); ++i) x_by_node_[nodes_[i]] = x_[i];
        cells_.resize(mesh.cell_count());
        std::iota(cells_.begin(), cells_.end(), std::size_t{0});
        const auto middle = [&](std::size_t i) { return between(xi_by_node_, i); };
        const auto before = [&](std::size_t i, std::size_t j) { return middle(i) < middle(j); };
        if (!std::is_sorted(cells_.begin(), cells_.end(), before))
            std::stable_sort(cells_.begin(), cells_.end(), before);
    }
    std::pair<std::size_t, std::size_t> ends(std::size_t cell) const {
        const auto nodes = snapshot_.mesh->cell(cell);
        return {static_cast<std::size_t>(nodes[0]), static_cast<std::size_t>(nodes[1])};
    }
    double between(const std::vector<double>& of_nodes, std::size_t cell) const {
        const auto [first, second] = ends(cell);
        return of_nodes[first] / 2 + of_nodes[second] / 2;
    }
    std::vector<double> middles_of_cells(const std::vector<double>& of_nodes) const {
        std::vector<double> found;
        for (const std::size_t cell : cells_) found.push_back(between(of_nodes, cell));
        return found;
    }
    /// As the x axis shows them: of distances, which are exact near the end.
    std::vector<double> cell_middles(bool physical) const {
        return middles_of_cells(coordinate_.distances(physical ? x_by_node_ : xi_by_node_));
    }
    std::vector<double> widths(const std::vector<double>& of_nodes) const {
        std::vector<double> found;
        for (const std::size_t cell : cells_) {
            const auto [first, second] = ends(cell);
            found.push_back(of_nodes[second] - of_nodes[first]);
        }
        return found;
    }

    Curve as_nodes(Curve curve) const {
        curve.markers = true;
        curve.linear = true;
        curve.colour = adapted_colour;
        return curve;
    }

    /// The field at these places of its nodes, or at the middles of its cells. `uniform` may be empty.
    void add_values(Plot& plot, const std::vector<double>& places, const std::vector<double>& uniform,
                    bool reversed) const {
        const bool of_cells = colouring_->place == FieldPlace::cell;
        plot.y = value_axis();
        const auto parts = components_of(snapshot_, colouring_->name, colouring_->place, colouring_->values);
        const bool several =
            std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.number > 1; });
        for (const Component& part : parts) {
            if (part.uniform && uniform.empty()) continue;
            std::vector<double> at = part.uniform ? uniform : places;
            if (of_cells) at = uniform.empty() ? middles_of_cells(xi_by_node_) : cell_middles(!part.uniform);
            Curve curve = curve_of(std::move(at), picked(*part.values, of_cells ? cells_ : nodes_), reversed);
            curve.label = legend_of(part, several);
            curve.linear = !of_cells;
            curve.markers = !part.uniform;
            curve.behind = part.uniform;
            curve.colour =
                (part.uniform ? uniform_colour : adapted_colour) + second_colours * (part.number - 1);
            plot.curves.push_back(std::move(curve));
        }
        limit(plot);
    }
    /// Solutions on the uniform mesh may oscillate wildly; they must not squeeze those on the adapted one.
    static void limit(Plot& plot) {
        if (plot.y.logarithmic || plot.y.low) return;
        double low = std::numeric_limits<double>::infinity(), high = -low, lowest = low, highest = high;
        for (const Curve& curve : plot.curves)
            for (const double y : curve.y) {
                if (!std::isfinite(y)) continue;
                lowest = std::min(lowest, y), highest = std::max(highest, y);
                if (!curve.behind) low = std::min(low, y), high = std::max(high, y);
            }
        constexpr double most = 1; // beyond the others, in units of their span
        const double span = high - low;
        if (!(span > 0) || (lowest >= low - most * span && highest <= high + most * span)) return;
        plot.y.low = std::max(lowest - 0.05 * span, low - most * span);
        plot.y.high = std::min(highest + 0.05 * span, high + most * span);
    }
    Axis value_axis() const {
        Axis axis{.label = colouring_->label, .logarithmic = view_.boolean("log")};
        if (view_.text("range") == "fixed") axis.low = view_.real("low"), axis.high = view_.real("high");
        return axis;
    }

    Plot spacing(const Axis& x, std::vector<double> at, std::vector<double> uniform_at, bool reversed) const {
        Plot plot{.title = {}, .x = x, .y = {"cell width", true}, .curves = {}};
        Curve adapted = curve_of(std::move(at), widths(x_by_node_), reversed);
        adapted.label = "adapted mesh", adapted.markers = true, adapted.colour = adapted_colour;
        Curve uniform = uniform_widths(x, std::move(uniform_at), reversed);
        uniform.label = "uniform mesh", uniform.behind = true, uniform.colour = uniform_colour;
        plot.curves = {std::move(adapted), std::move(uniform)};
        return plot;
    }

    /// From one end of the interval to the other.
    Curve uniform_widths(const Axis& x, std::vector<double> at, bool reversed) const {
        const Coordinate shown{coordinate_.a, coordinate_.b,
                               x.logarithmic ? coordinate_.kind : XAxis::linear};
        std::vector<double> y = widths(xi_by_node_);
        at.insert(at.begin(), shown.distance(coordinate_.a));
        y.insert(y.begin(), y.front());
        at.push_back(shown.distance(coordinate_.b));
        y.push_back(y.back());
        Curve curve = curve_of(std::move(at), std::move(y), reversed);
        curve.linear = true;
        return curve;
    }

    const Snapshot& snapshot_;
    const Values& view_;
    std::vector<std::size_t> nodes_, cells_; ///< from left to right in the computational mesh
    std::vector<double> xi_, x_;             ///< in that order, x as blended
    std::vector<double> xi_by_node_, x_by_node_;
    std::optional<Colouring> colouring_;
    Coordinate coordinate_;
    std::vector<double> physical_, uniform_; ///< x and xi as the x axis shows them
};

} // namespace

std::vector<IntervalColumn> interval_plots(const Snapshot& snapshot, const Values& view,
                                           ColouringMaker& cells) {
    GASPARD_CHECK(is_interval(*snapshot.mesh) && snapshot.mesh->node_count() > 1);
    const Maker maker(snapshot, view, cells);
    const std::string& layout = view.text("layout");
    if (layout != "side-by-side") {
        std::vector<IntervalColumn> columns;
        if (layout == "computational") {
            columns.push_back(maker.over_xi("computational"));
            return columns;
        }
        columns.push_back(maker.has_values() ? maker.over_x({}) : maker.over_xi({}));
        return columns;
    }
    std::vector<IntervalColumn> columns;
    columns.push_back(maker.over_x(blend_title(view.real("blend"))));
    columns.push_back(maker.over_xi("computational"));
    return columns;
}

std::vector<IntervalColumn> interval_plots(const Snapshot& snapshot, const Values& view) {
    ColouringMaker cells;
    return interval_plots(snapshot, view, cells);
}

std::vector<ColumnRanges> shown_ranges(const std::vector<IntervalColumn>& columns) {
    std::vector<ColumnRanges> ranges;
    for (const IntervalColumn& column : columns)
        ranges.push_back({shown_range(column.values, false), shown_range(column.values, true),
                          shown_range(column.spacing, true)});
    return ranges;
}

std::vector<ColumnRanges> merged(const std::vector<ColumnRanges>& one,
                                 const std::vector<ColumnRanges>& other) {
    if (one.empty() || other.empty()) return one.empty() ? other : one;
    GASPARD_CHECK(one.size() == other.size());
    const auto both = [](AxisRange a, AxisRange b) {
        return AxisRange{std::min(a.low, b.low), std::max(a.high, b.high)};
    };
    std::vector<ColumnRanges> all;
    for (std::size_t i = 0; i < one.size(); ++i)
        all.push_back({both(one[i].x, other[i].x), both(one[i].values, other[i].values),
                       both(one[i].spacing, other[i].spacing)});
    return all;
}

} // namespace gaspard
