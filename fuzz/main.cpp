// libFuzzer's entry. The environment variable GASPARD_FUZZ_TARGET names the target.
#include "fuzz/targets.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace {

const gaspard::FuzzTarget& chosen() {
    const char* name = std::getenv("GASPARD_FUZZ_TARGET");
    for (const auto& target : gaspard::fuzz_targets())
        if (name != nullptr && target.name == name) return target;
    std::fputs("GASPARD_FUZZ_TARGET must be one of:\n", stderr);
    for (const auto& target : gaspard::fuzz_targets())
        std::fprintf(stderr, "  %.*s\n", static_cast<int>(target.name.size()), target.name.data());
    std::exit(2);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const gaspard::FuzzTarget& target = chosen();
    gaspard::run_target(target, {reinterpret_cast<const char*>(data), size});
    return 0;
}
