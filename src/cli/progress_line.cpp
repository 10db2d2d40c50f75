#include "cli/progress_line.hpp"

#include <cstdio>
#include <unistd.h>

namespace gaspard {

ProgressLine::ProgressLine(bool quiet) : on_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const std::string& text) {
    if (!due()) return;
    next_ = watch_.seconds() + 0.1;
    shown_ = true;
    std::fprintf(stderr, "\r%s\033[K", text.c_str());
    std::fflush(stderr);
}

} // namespace gaspard
