#include "core/tessellate/colouring.hpp"

#include "core/base/check.hpp"
#include "core/scenario/view_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr double decades_limit = 1e-6; // a logarithmic range spans no more than this part of its high end

double smallest_positive(std::span<const double> values) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const double value : values)
        if (value > 0 && value < smallest) smallest = value;
    return smallest;
}

ColourRange logarithmic(ColourRange range, std::span<const double> values, const FieldInfo& info,
                        bool diverging) {
    if (!(range.high > 0)) return range;
    if (!(range.low > 0)) range.low = std::min(smallest_positive(values), range.high);
    range.low = std::max(range.low, decades_limit * range.high);
    range.logarithmic = true;
    if (diverging && info.centre && *info.centre > 0) {
        const double ratio = std::max(range.high / *info.centre, *info.centre / range.low);
        range.low = *info.centre / ratio, range.high = *info.centre * ratio;
    }
    return range;
}

/// What differs by rounding alone is the same; colours would make a pattern of it.
bool constant(const ColourRange& range, const FieldInfo& info) {
    const double size = info.is_signed() ? 1 : std::max(std::abs(range.low), std::abs(range.high));
    return range.high - range.low <= 1e-12 * size;
}

ColourRange automatic_range(ColourRange range, std::span<const double> values, const FieldInfo& info,
                            bool log, bool diverging) {
    if (constant(range, info)) {
        const double middle = info.is_signed() ? *info.centre : range.low + (range.high - range.low) / 2;
        return {middle, middle};
    }
    if (log && !info.is_signed()) return logarithmic(range, values, info, diverging);
    if (!diverging || !info.centre) return range;
    const double half = std::max(range.high - *info.centre, *info.centre - range.low);
    return {*info.centre - half, *info.centre + half};
}

/// Of all values, also of those of other fields that are compared.
ColourRange whole_range(const Field* field, std::span<const double> values) {
    if (field == nullptr || !field->range) return range_of(values);
    return {field->range->first, field->range->second};
}

const ColourMap& map_of(const ColourChoice& choice, const FieldInfo& info) {
    if (choice.map != "automatic") return colour_map(choice.map);
    return info.is_signed() ? colour_map("blue-red") : colour_maps().front();
}

void count(Colouring& colouring) {
    const double parts = 2 * std::sqrt(static_cast<double>(colouring.values.size()));
    colouring.histogram.assign(static_cast<std::size_t>(std::clamp(parts, 8.0, 64.0)), 0);
    const ColourRange& range = colouring.range;
    const auto bins = static_cast<float>(colouring.histogram.size());
    const auto put = [&](float place) { // NaN is in none
        if (place < 0 || place > 1)
            (place < 0 ? colouring.below : colouring.above) = true;
        else if (place >= 0)
            ++colouring.histogram[static_cast<std::size_t>(std::min(place * bins, bins - 1))];
    };
    if (!(range.high > range.low)) {
        for (const double value : colouring.values) put(std::isfinite(value) ? 0.5F : std::nanf(""));
    } else if (range.logarithmic) {
        const double factor = 1 / range.low;
        const float scale = 1 / std::log2(static_cast<float>(range.high / range.low));
        for (const double value : colouring.values)
            put(value > 0 ? std::log2(static_cast<float>(value * factor)) * scale : -1.0F);
    } else {
        const double scale = 1 / (range.high - range.low);
        for (const double value : colouring.values) put(static_cast<float>((value - range.low) * scale));
    }
}

std::vector<double> displacements(const Snapshot& snapshot) {
    const Points &from = snapshot.mesh->nodes, &to = snapshot.x;
    std::vector<double> found(to.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double x = to.x[i] - from.x[i], y = to.y[i] - from.y[i], z = to.z[i] - from.z[i];
        found[i] = std::sqrt(x * x + y * y + z * z);
    }
    return found;
}

/// M_i / mean - 1
std::vector<double> deviations(const std::vector<double>& masses) {
    double mean = 0;
    for (const double mass : masses) mean += mass;
    mean /= static_cast<double>(masses.size());
    std::vector<double> found(masses.size());
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = masses[i] / mean - 1;
    return found;
}

/// Of what every mesh has, or of a field of the snapshot; null for "none" and where the snapshot, of another
/// method, has no such field.
const FieldInfo* find_info(const Snapshot& snapshot, std::string_view name) {
    for (const FieldInfo& info : mesh_colours())
        if (info.name == name) return &info;
    return snapshot.field(name);
}

std::string legend_text(const FieldInfo& info, int dimension) {
    if (info.name == "area" && dimension != 2) return dimension == 1 ? "cell length" : "cell volume";
    const std::string& text = info.label.empty() ? info.name : info.label;
    return info.unit.empty() ? text : text + " [" + info.unit + "]";
}

} // namespace

ColourChoice colour_choice(const Values& view) {
    return {view.text("color"),
            view.text("color_map"),
            view.boolean("log"),
            view.text("range") == "fixed",
            view.real("low"),
            view.real("high"),
            static_cast<int>(view.integer("contours"))};
}

std::optional<ColourRange> range_of_recording(const Recording& recording, const Snapshot* newest,
                                              const ColourChoice& choice) {
    std::optional<ColourRange> range;
    const auto take = [&](const std::shared_ptr<const RecordedIterate>& iterate) {
        const bool known = newest != nullptr && newest->version == iterate->version();
        cover(range, known ? *newest : *iterate->restore(), choice);
    };
    const auto first = recording.at(std::numeric_limits<int>::min()), last = last_sound(recording);
    if (first) take(first);
    if (last && last != first) take(last);
    return range;
}

void cover(std::optional<ColourRange>& range, const Snapshot& snapshot, const ColourChoice& choice) {
    const auto colouring = make_colouring(snapshot, choice);
    if (!colouring) return;
    if (!range) range = colouring->range;
    range =
        ColourRange{std::min(range->low, colouring->range.low), std::max(range->high, colouring->range.high)};
}

std::shared_ptr<const RecordedIterate> last_sound(const Recording& recording) {
    auto last = recording.at(std::numeric_limits<int>::max());
    if (!last || last->report().tangled_cells.value_or(0) == 0) return last;
    const auto tangled = recording.first_tangled();
    return tangled ? recording.at(*tangled - 1) : last;
}

Values with_range(Values view, const std::optional<ColourRange>& range) {
    if (!range || !(range->low < range->high) || view.text("range") == "fixed") return view;
    view.set("range", std::string("fixed"));
    view.set("low", range->low);
    view.set("high", range->high);
    return view;
}

void ColouringMaker::see(const Snapshot& snapshot) {
    GASPARD_CHECK(snapshot.mesh != nullptr);
    const bool new_mesh = mesh_ != snapshot.mesh;
    if (new_mesh) {
        mesh_ = snapshot.mesh;
        geometry_.emplace(mesh_);
        mass_.clear();
        quality_meter_.reset();
    }
    if (!new_mesh && seen_version_ == snapshot.version) return;
    seen_version_ = snapshot.version;
    jacobian_.clear();
    quality_.reset();
    if (const Field* mass = snapshot.field("mass")) mass_ = mass->values;
}

std::vector<double> ColouringMaker::measures(const Snapshot& snapshot) {
    see(snapshot);
    return geometry_->measures(snapshot.x);
}

const std::vector<double>& ColouringMaker::jacobians(const Snapshot& snapshot) {
    see(snapshot);
    if (const Field* measured = snapshot.field("jacobian")) return measured->values;
    if (jacobian_.empty()) jacobian_ = geometry_->jacobians(snapshot.x);
    return jacobian_;
}

const CellQuality* ColouringMaker::quality(const Snapshot& snapshot) {
    see(snapshot);
    if (!has_quality(mesh_->kind)) return nullptr;
    if (!quality_meter_) quality_meter_.emplace(mesh_);
    if (!quality_) {
        const Field* monitor = snapshot.field("monitor");
        quality_ = quality_meter_->measure(snapshot.x, monitor ? monitor->values : std::vector<double>{});
    }
    return &*quality_;
}

std::vector<std::uint32_t> ColouringMaker::tangled(const Snapshot& snapshot) {
    if (snapshot.tangled) return *snapshot.tangled;
    see(snapshot);
    if (snapshot.field("jacobian") != nullptr || !jacobian_.empty())
        return tangled_cells(jacobians(snapshot));
    return geometry_->tangled(snapshot.x);
}

/// Empty where the snapshot does not have them.
std::optional<std::vector<double>> ColouringMaker::values(const Snapshot& snapshot, const std::string& name) {
    if (name == "area") return geometry_->measures(snapshot.x);
    if (name == "jacobian") return jacobians(snapshot);
    if (name == "equidistribution") return mass_.empty() ? std::nullopt : std::optional(deviations(mass_));
    if (name == "displacement") return displacements(snapshot);
    for (const QualityMeasureInfo& measure : quality_measures()) {
        if (measure.name != name) continue;
        const CellQuality* found = quality(snapshot);
        return found && !(found->*measure.values).empty() ? std::optional(found->*measure.values)
                                                          : std::nullopt;
    }
    const Field* field = snapshot.field(name);
    return field != nullptr ? std::optional(field->values) : std::nullopt;
}

std::optional<Colouring> ColouringMaker::make(const Snapshot& snapshot, const ColourChoice& choice) {
    see(snapshot);
    const FieldInfo* info = find_info(snapshot, choice.colouring);
    if (info == nullptr) return std::nullopt;
    auto found = values(snapshot, choice.colouring);
    if (!found) return std::nullopt;
    Colouring colouring{.name = choice.colouring,
                        .label = legend_text(*info, cell_dimension(mesh_->kind)),
                        .symbol = info->symbol,
                        .place = info->place,
                        .values = std::move(*found)};
    colouring.map = &map_of(choice, *info);
    if (choice.fixed)
        colouring.range = {choice.low, choice.high,
                           choice.logarithmic && !info->is_signed() && choice.low > 0 && choice.high > 0};
    else
        colouring.range =
            automatic_range(whole_range(snapshot.field(choice.colouring), colouring.values), colouring.values,
                            *info, choice.logarithmic, colouring.map->diverging);
    count(colouring);
    if (info->place == FieldPlace::node)
        colouring.contours = contour_levels(colouring.range, choice.contours);
    return colouring;
}

std::optional<Colouring> make_colouring(const Snapshot& snapshot, const ColourChoice& choice) {
    return ColouringMaker().make(snapshot, choice);
}

} // namespace gaspard
