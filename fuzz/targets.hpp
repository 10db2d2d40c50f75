// What scripts/fuzz.sh feeds with random bytes: every reader of what a user or another program wrote.
//
// A target calls a reader as the program does. An InputError is a right answer. Findings are: any other
// exception, a sanitizer's report, a broken promise (what is read and written again reads back the same), and
// too much time or memory. tests/core/fuzz_test.cpp runs all targets on the inputs in fuzz/seeds and
// fuzz/regressions.
#pragma once

#include <span>
#include <string_view>

namespace gaspard {

struct FuzzTarget {
    std::string_view name; ///< of its folders in fuzz/seeds and fuzz/regressions
    void (*read)(std::string_view bytes);
};

std::span<const FuzzTarget> fuzz_targets();

/// Runs a target. Throws whatever the reader throws that is not an InputError, and std::logic_error if an
/// InputError has no text or one of more than 20,000 bytes.
void run_target(const FuzzTarget& target, std::string_view bytes);

} // namespace gaspard
