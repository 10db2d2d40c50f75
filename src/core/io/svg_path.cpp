#include "core/io/svg_path.hpp"

#include "core/base/check.hpp"

#include <cmath>
#include <cstdlib>

namespace gaspard {

namespace {

/// A whole number of steps as a decimal fraction: -1234 with two decimals is "-12.34", 5 is ".05".
std::string decimal(long steps, int decimals) {
    std::string digits = std::to_string(std::labs(steps));
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() < places) digits.insert(0, places - digits.size(), '0');
    std::string fraction = digits.substr(digits.size() - places);
    while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
    std::string text = digits.substr(0, digits.size() - places);
    if (!fraction.empty()) text += '.' + fraction;
    if (text.empty()) return "0";
    return steps < 0 ? '-' + text : text;
}

long whole_steps(double value, double steps) {
    GASPARD_CHECK(std::isfinite(value) && std::abs(value) < 1e7); // far beyond any page
    return std::lround(value * steps);
}

} // namespace

std::string svg_number(double value, int decimals) {
    return decimal(whole_steps(value, std::pow(10.0, decimals)), decimals);
}

SvgPath::SvgPath(int decimals) : decimals_(decimals), steps_per_point_(std::pow(10.0, decimals)) {}

SvgPath::Step SvgPath::rounded(PagePoint p) const {
    return {whole_steps(p.x, steps_per_point_), whole_steps(p.y, steps_per_point_)};
}

void SvgPath::command(char letter) {
    if (letter == last_) return;
    data_ += letter;
    last_ = letter;
}

void SvgPath::number(long steps) {
    const char before = data_.back();
    const bool digit = before == '.' || (before >= '0' && before <= '9');
    if (digit && steps >= 0) data_ += ' ';
    data_ += decimal(steps, decimals_);
}

void SvgPath::pair(Step step) {
    number(step.x);
    number(step.y);
}

void SvgPath::move(PagePoint to) {
    const Step target = rounded(to);
    last_ = 0;
    command(started_ ? 'm' : 'M');
    pair(started_ ? target - at_ : target);
    started_ = true;
    at_ = begin_ = target;
}

void SvgPath::line(PagePoint to) {
    const Step target = rounded(to);
    if (target == at_) return;
    command('l');
    pair(target - at_);
    at_ = target;
}

void SvgPath::curve(PagePoint control, PagePoint to) {
    const Step target = rounded(to), via = rounded(control);
    // The curve leaves the chord by half of what its control point does.
    const double x = static_cast<double>(at_.x + target.x) / 2 - static_cast<double>(via.x);
    const double y = static_cast<double>(at_.y + target.y) / 2 - static_cast<double>(via.y);
    if (std::hypot(x, y) <= 2) return line(to);
    command('q');
    pair(via - at_);
    pair(target - at_);
    at_ = target;
}

void SvgPath::close() {
    data_ += 'z';
    last_ = 0;
    at_ = begin_;
}

} // namespace gaspard
