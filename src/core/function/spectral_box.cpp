#include "core/function/spectral_box.hpp"

#include "core/base/error.hpp"
#include "core/linear/batch_fft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr std::size_t lanes = BatchFft::lanes;

/// Real and imaginary parts of the values or coefficients on the grid.
struct Complex {
    std::vector<double> re, im;
};

/// The transform along one direction of n points, of eight lines at a time. Cosine transforms are Fourier
/// transforms of the sequence mirrored at its ends.
class LineTransform {
  public:
    explicit LineTransform(const GridDirection& direction)
        : n_(direction.count), periodic_(direction.ends == GridEnds::periodic), centred_(direction.centred),
          fft_(length()), data_(2 * fft_.length() * lanes), scratch_(data_.size()) {}

    std::size_t count() const { return n_; }
    /// Which multiple of 2 pi / length (periodic) or pi / length coefficient k belongs to.
    double frequency(std::size_t k) const {
        return static_cast<double>(periodic_ && k > n_ / 2 ? n_ - k : k) * (periodic_ ? 2 : 1);
    }
    double* element(std::size_t j) { return data_.data() + 2 * lanes * j; }

    /// Transforms the elements 0 .. n - 1 in place.
    void forward() {
        if (n_ == 1) return;
        if (!periodic_)
            for (std::size_t j = n_; j < fft_.length(); ++j) copy(mirror(j), j, 1);
        const double* y = fft_.forward(data_.data(), scratch_.data());
        for (std::size_t k = 0; k < n_; ++k) turn(y + 2 * lanes * k, k, -1, 1, element(k));
    }
    void backward() {
        if (n_ == 1) return;
        const std::size_t m = fft_.length();
        if (!periodic_ && centred_) {
            std::fill_n(element(n_), 2 * lanes, 0.0);
            for (std::size_t k = 1; k < n_; ++k) copy(k, m - k, -1);
            for (std::size_t k = 0; k < m; ++k) turn(element(k), k, 1, 1, element(k));
        } else if (!periodic_) {
            for (std::size_t k = n_; k < m; ++k) copy(m - k, k, 1);
        }
        const double* y = fft_.backward(data_.data(), scratch_.data());
        const double scale = 1 / static_cast<double>(m);
        for (std::size_t k = 0; k < n_; ++k) {
            double* to = element(k);
            for (std::size_t l = 0; l < 2 * lanes; ++l) to[l] = scale * y[2 * lanes * k + l];
        }
    }

  private:
    std::size_t length() const { return periodic_ || n_ == 1 ? n_ : centred_ ? 2 * n_ : 2 * (n_ - 1); }
    std::size_t mirror(std::size_t j) const { return centred_ ? 2 * n_ - 1 - j : 2 * (n_ - 1) - j; }
    void copy(std::size_t from, std::size_t to, double factor) {
        for (std::size_t l = 0; l < 2 * lanes; ++l) element(to)[l] = factor * element(from)[l];
    }
    /// Multiplies by exp(sign i pi k / (2 n)) if the points are centred.
    void turn(const double* from, std::size_t k, double sign, double factor, double* to) const {
        const bool turned = centred_ && !periodic_;
        const double phase =
            turned ? sign * std::numbers::pi * static_cast<double>(k) / (2 * static_cast<double>(n_)) : 0.0;
        const double c = factor * std::cos(phase), s = factor * std::sin(phase);
        for (std::size_t l = 0; l < lanes; ++l) {
            const double re = from[l], im = from[lanes + l];
            to[l] = c * re - s * im, to[lanes + l] = s * re + c * im;
        }
    }

    std::size_t n_;
    bool periodic_, centred_;
    BatchFft fft_;
    std::vector<double> data_, scratch_;
};

/// All lines along a direction with `stride` numbers between their points.
void transform(Complex& c, LineTransform& line, std::size_t stride, bool forward,
               const std::stop_token& stop) {
    const std::size_t count = line.count(), lines = c.re.size() / count;
    const auto start = [&](std::size_t number) { // of a line
        return number / stride * stride * count + number % stride;
    };
    for (std::size_t first = 0; first < lines; first += lanes) {
        if (stop.stop_requested()) throw Interrupted();
        const std::size_t batch = std::min(lanes, lines - first);
        std::array<std::size_t, lanes> starts{};
        for (std::size_t l = 0; l < batch; ++l) starts[l] = start(first + l);
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t l = 0; l < lanes; ++l) {
                const std::size_t at = starts[l] + j * stride; // unused lanes repeat the first line
                line.element(j)[l] = c.re[at], line.element(j)[lanes + l] = c.im[at];
            }
        forward ? line.forward() : line.backward();
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t l = 0; l < batch; ++l) {
                const std::size_t at = starts[l] + j * stride;
                c.re[at] = line.element(j)[l], c.im[at] = line.element(j)[lanes + l];
            }
    }
}

} // namespace

void multiply_spectrum(const Grid& grid, std::span<double> values,
                       const std::function<double(double lambda)>& factor, const Progress& progress,
                       const std::stop_token& stop) {
    const std::size_t dimension = grid.directions.size();
    Complex c{{values.begin(), values.end()}, std::vector<double>(values.size(), 0.0)};
    std::vector<LineTransform> lines;
    std::vector<std::size_t> strides;
    std::array<std::vector<double>, 3> squares{{{0.0}, {0.0}, {0.0}}};
    for (std::size_t d = 0; d < dimension; ++d) {
        strides.push_back(d == 0 ? 1 : strides[d - 1] * grid.directions[d - 1].count);
        const ChartDirection& direction = grid.chart->direction(d);
        const LineTransform& line = lines.emplace_back(grid.directions[d]);
        squares[d].resize(line.count());
        for (std::size_t k = 0; k < line.count(); ++k) {
            const double wave = line.frequency(k) * std::numbers::pi / (direction.high - direction.low);
            squares[d][k] = wave * wave;
        }
    }
    const auto report = [&](std::size_t done) {
        if (progress) progress(static_cast<double>(done) / static_cast<double>(2 * dimension), "Smoothing");
    };
    for (std::size_t d = 0; d < dimension; ++d) {
        report(d);
        transform(c, lines[d], strides[d], true, stop);
    }
    std::size_t i = 0;
    for (const double z : squares[2])
        for (const double y : squares[1])
            for (const double x : squares[0]) {
                const double f = factor(x + y + z);
                c.re[i] *= f, c.im[i] *= f, ++i;
            }
    for (std::size_t d = dimension; d-- > 0;) {
        report(2 * dimension - 1 - d);
        transform(c, lines[d], strides[d], false, stop);
    }
    std::copy(c.re.begin(), c.re.end(), values.begin());
}

} // namespace gaspard
