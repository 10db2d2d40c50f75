// A line on the terminal that says how far a command is, overwritten at most ten times a second.
#pragma once

#include "core/base/stopwatch.hpp"

#include <string>

namespace gaspard {

class ProgressLine {
  public:
    /// Shows nothing if `quiet`, or if standard error is no terminal.
    explicit ProgressLine(bool quiet);
    ~ProgressLine(); ///< the line is empty again
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Whether it is time for another text.
    bool due() const { return on_ && watch_.seconds() >= next_; }
    void show(const std::string& text); ///< if it is due

  private:
    Stopwatch watch_;
    bool on_, shown_ = false;
    double next_ = 0;
};

} // namespace gaspard
