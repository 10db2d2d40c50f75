#include "gui/panels/monitor_pictures.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr int width = monitor_picture_width, height = monitor_picture_height;
constexpr std::size_t most_known = 96;   // in one sheet
constexpr int most_computed = 3;         // per frame
constexpr double logarithmic_from = 1e3; // largest over smallest value

/// The part of a picture that shows a region of these proportions.
struct Part {
    int left = 0, top = 0, columns = width, rows = height;
    explicit Part(double aspect) { // width over height
        if (aspect > static_cast<double>(width) / height)
            rows = std::max(1, static_cast<int>(std::lround(width / aspect)));
        else
            columns = std::max(1, static_cast<int>(std::lround(height * aspect)));
        left = (width - columns) / 2, top = (height - rows) / 2;
    }
};

Part part_of(const MonitorSubject& subject) {
    if (subject.space.kind == SpaceKind::sphere) return Part(2);
    const Vec3 side = subject.region.high - subject.region.low;
    return Part(side.x > 0 && side.y > 0 ? std::clamp(side.x / side.y, 0.1, 10.0)
                                         : static_cast<double>(width) / height);
}

/// By rows from the top, at the middles of pixels.
Points samples_of(const MonitorSubject& subject, const Part& part) {
    Points samples(static_cast<std::size_t>(part.columns * part.rows));
    const Vec3 low = subject.region.low, high = subject.region.high;
    for (int row = 0; row < part.rows; ++row)
        for (int column = 0; column < part.columns; ++column) {
            const double s = (column + 0.5) / part.columns, t = 1 - (row + 0.5) / part.rows;
            const auto i = static_cast<std::size_t>(row * part.columns + column);
            if (subject.space.kind == SpaceKind::sphere)
                samples.set(i, at_latitude_longitude(180 * t - 90, 360 * s - 180));
            else
                samples.set(
                    i, {low.x + s * (high.x - low.x), low.y + t * (high.y - low.y), (low.z + high.z) / 2});
        }
    return samples;
}

/// Whether it is made from its rows alone, at once.
bool is_cheap(const MonitorType& type, const Values& values) {
    const bool file = std::any_of(values.rows().begin(), values.rows().end(),
                                  [](const ParameterRow& row) { return row.role == ParameterRole::file; });
    return type.make && type.stages.empty() && !file;
}

Image coloured(const std::vector<double>& values, const Part& part, const ColourMap& map) {
    ColourRange range = range_of(values);
    range.logarithmic = range.low > 0 && range.high > logarithmic_from * range.low;
    const bool flat = !(range.low < range.high);
    Image image{width, height, std::vector<std::uint8_t>(4U * width * height)};
    for (int row = 0; row < part.rows; ++row)
        for (int column = 0; column < part.columns; ++column) {
            const double value = values[static_cast<std::size_t>(row * part.columns + column)];
            const auto colour = colour_at(map, flat ? 0 : range.position(value));
            const auto at = image.rgba.begin() + 4 * ((part.top + row) * width + part.left + column);
            std::copy(colour.begin(), colour.end(), at);
            at[3] = 255;
        }
    return image;
}

} // namespace

std::optional<Image> picture_of_monitor(const MonitorType& type, const MonitorSubject& subject,
                                        const Values* pde) {
    if (!is_cheap(type, subject.values)) return std::nullopt;
    const Part part = part_of(subject);
    const Points samples = samples_of(subject, part);
    std::vector<double> values(samples.size());
    try {
        type.make(subject.values, {.space = subject.space, .pde = pde})->values(samples, values);
    } catch (const InputError&) { // such as a formula that is not valid here
        return std::nullopt;
    }
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
        return std::nullopt;
    return coloured(values, part, colour_map(subject.colours == "automatic" ? "viridis" : subject.colours));
}

void MonitorPictures::begin_frame() {
    computed_ = 0, waiting_ = false;
    if (known_.size() < most_known) return;
    known_.clear();
    sheet_.reset(); // what was drawn refers to it, so not in the middle of a frame
}

std::optional<PicturePlace> MonitorPictures::find(const MonitorType& type, const MonitorSubject& subject,
                                                  const Values* pde) {
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.subject == subject; });
    if (found != known_.end()) return found->place;
    if (computed_ >= most_computed || known_.size() >= most_known) {
        waiting_ = true;
        return std::nullopt;
    }
    ++computed_;
    if (!sheet_) sheet_ = std::make_shared<PictureSheet>(width, height, static_cast<int>(most_known));
    const auto image = picture_of_monitor(type, subject, pde);
    known_.push_back({subject, image ? std::optional(sheet_->add(*image)) : std::nullopt});
    return known_.back().place;
}

} // namespace gaspard
