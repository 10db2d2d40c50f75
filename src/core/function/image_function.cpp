#include "core/function/image_function.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

/// Where a direction of the grid lies in the picture: pixel = first + step * i, from the left or from the
/// top.
struct PixelLine {
    double first = 0, step = 1;
    bool wraps = false;
};

struct Placing {
    PixelLine across, down;
    double pixel = 1; ///< the length of a pixel of the file
};

Placing place(const GreyImage& image, const ImageOptions& options, const Grid& grid,
              const ChartExtent& extent) {
    const auto width = static_cast<double>(image.width), height = static_cast<double>(image.height);
    const double reduction = width / static_cast<double>(image.full_width);
    const auto low = [&](std::size_t d) { return grid.chart->direction(d).low; };
    const auto side = [&](std::size_t d) { return grid.chart->direction(d).high - low(d); };
    Placing at;
    if (grid.chart->kind() == ChartKind::sphere) {
        at.across = {(grid.coordinate(0, 0) - options.left_longitude) / 360 * width,
                     grid.spacing(0) / 360 * width, true};
        at.down = {height, -grid.spacing(1) / 180 * height, false};
        at.pixel = extent.width / width * reduction;
        return at;
    }
    double by_width = width / extent.width, by_height = height / extent.height; // pixels per length
    if (options.fit == ImageFit::fit) by_width = by_height = std::max(by_width, by_height);
    if (options.fit == ImageFit::fill) by_width = by_height = std::min(by_width, by_height);
    const auto fraction = [&](std::size_t d) { return (grid.coordinate(d, 0) - low(d)) / side(d) - 0.5; };
    at.across = {width / 2 + fraction(0) * extent.width * by_width,
                 grid.spacing(0) / side(0) * extent.width * by_width, false};
    at.down = {height / 2 - fraction(1) * extent.height * by_height,
               -grid.spacing(1) / side(1) * extent.height * by_height, false};
    at.pixel = reduction / std::sqrt(by_width * by_height);
    return at;
}

struct PixelWeight {
    std::size_t pixel;
    double weight;
};

/// Averages over intervals of the grid's step, or of one pixel if that is longer.
std::vector<std::vector<PixelWeight>> averages(const PixelLine& line, std::size_t count, std::size_t pixels) {
    const double half = std::max(std::abs(line.step), 1.0) / 2;
    const auto n = static_cast<std::int64_t>(pixels);
    std::vector<std::vector<PixelWeight>> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double middle = line.first + line.step * static_cast<double>(i);
        const double begin = middle - half, end = middle + half;
        for (double p = std::floor(begin); p < end; ++p) {
            const double part = std::min(end, p + 1) - std::max(begin, p);
            auto pixel = static_cast<std::int64_t>(p);
            pixel = line.wraps ? ((pixel % n) + n) % n : std::clamp<std::int64_t>(pixel, 0, n - 1);
            if (part > 0) result[i].push_back({static_cast<std::size_t>(pixel), part / (2 * half)});
        }
    }
    return result;
}

std::vector<double> sample(const GreyImage& image, const Placing& at, const Grid& grid) {
    const std::size_t columns = grid.directions[0].count, rows = grid.directions[1].count;
    const auto across = averages(at.across, columns, image.width);
    const auto down = averages(at.down, rows, image.height);
    std::vector<double> result(grid.size()), line(image.width);
    for (std::size_t j = 0; j < rows; ++j) {
        std::fill(line.begin(), line.end(), 0.0);
        for (const PixelWeight& row : down[j]) {
            const float* grey = image.grey.data() + row.pixel * image.width;
            for (std::size_t x = 0; x < image.width; ++x)
                line[x] += row.weight * static_cast<double>(grey[x]);
        }
        for (std::size_t i = 0; i < columns; ++i) {
            double sum = 0;
            for (const PixelWeight& column : across[i]) sum += column.weight * line[column.pixel];
            result[j * columns + i] = sum;
        }
    }
    return result;
}

/// The mean difference of opposite edges, of the larger pair.
double border_jump(const ImageGrid& made) {
    const std::size_t columns = made.grid.directions[0].count, rows = made.grid.directions[1].count;
    double across = 0, up = 0;
    for (std::size_t j = 0; j < rows; ++j)
        across += std::abs(made.values[j * columns] - made.values[(j + 1) * columns - 1]);
    for (std::size_t i = 0; i < columns; ++i)
        up += std::abs(made.values[i] - made.values[(rows - 1) * columns + i]);
    return std::max(across / static_cast<double>(rows), up / static_cast<double>(columns));
}

} // namespace

ImageGrid image_grid(const GreyImage& image, const ImageOptions& options, const DataContext& context) {
    const auto chart = chart_of(context);
    if (chart->dimension() != 2) throw InputError("a picture needs a domain of dimension two");
    const ChartExtent extent = extent_of(chart, context);
    ImageGrid made{.grid = {chart, {}}, .cell = extent.cell};
    // The blur in pixels depends on the place, but not on the grid.
    const double pixel = place(image, options, grid_on(chart, {32, 33}), extent).pixel;
    const double wanted = options.blur * (options.blur_unit == LengthUnit::pixels ? pixel : extent.cell);
    made.sigma = std::max(wanted, least_blur * extent.cell);
    const double step = made.sigma / 4;
    const bool sphere = chart->kind() == ChartKind::sphere;
    made.grid = grid_on(chart, {handy_count(extent.width / step), handy_count(extent.height / step) + sphere},
                        GridEnds::reflecting);
    // Between the points at both ends of a periodic direction lies the border of the picture.
    for (GridDirection& direction : made.grid.directions)
        if (direction.ends == GridEnds::periodic && !sphere) direction.centred = true;
    made.values = sample(image, place(image, options, made.grid, extent), made.grid);
    for (double& value : made.values) {
        const double grey = options.invert ? 1 - value : value;
        value = std::max(std::pow(std::clamp(grey, 0.0, 1.0), options.gamma), options.floor);
    }
    made.wanted = wanted;
    if (context.space.kind == SpaceKind::periodic_square && border_jump(made) > 0.05)
        made.notes.push_back("Opposite edges of the picture differ; on the periodic plane they meet, and are "
                             "blurred into each other.");
    return made;
}

std::string blur_note(const ImageOptions& options, const ImageGrid& made) {
    std::string note = "The picture is blurred over " + in_cells(made.sigma / made.cell);
    if (made.sigma > made.wanted * 1.005) {
        note += " instead of " + exact_number(options.blur);
        if (options.blur_unit == LengthUnit::pixels) note += options.blur == 1 ? " pixel" : " pixels";
    }
    return note + ", so that the mesh can follow.";
}

MadeFunction image_function(const GreyImage& image, const ImageOptions& options, const DataContext& context) {
    ImageGrid made = image_grid(image, options, context);
    made.notes.insert(made.notes.begin(), blur_note(options, made));
    blur(made.grid, made.values, made.sigma, context.progress, context.stop);
    return {std::make_shared<GridFunction>(std::move(made.grid), made.values), std::move(made.notes), {}};
}

} // namespace gaspard
