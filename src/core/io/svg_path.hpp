// The "d" of an SVG path, short: relative steps in hundredths of a point that do not add up their rounding.
#pragma once

#include <string>

namespace gaspard {

/// In points of the page, y down.
struct PagePoint {
    double x = 0, y = 0;
};

class SvgPath {
  public:
    /// `decimals` of a point are kept.
    explicit SvgPath(int decimals = 2);

    void move(PagePoint to);
    void line(PagePoint to);                     ///< nothing where the step is too small to be written
    void curve(PagePoint control, PagePoint to); ///< quadratic; a line where it is as good as straight
    void close();

    bool empty() const { return data_.empty(); }
    const std::string& data() const { return data_; }

  private:
    struct Step {
        long x = 0, y = 0;
        friend Step operator-(Step a, Step b) { return {a.x - b.x, a.y - b.y}; }
        friend bool operator==(Step, Step) = default;
    };
    Step rounded(PagePoint p) const;
    void command(char letter);
    void number(long steps);
    void pair(Step step);

    int decimals_;
    double steps_per_point_;
    Step at_, begin_;
    char last_ = 0;        ///< the command that goes on without its letter
    bool started_ = false; ///< the first move is absolute
    std::string data_;
};

/// "1.5": at most so many decimals, no trailing zeros.
std::string svg_number(double value, int decimals = 2);

} // namespace gaspard
