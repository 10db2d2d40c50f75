// What sanitizers watch for shows in a part of a long repetition.
#pragma once

namespace gaspard {

/// Whether this is a build with AddressSanitizer or ThreadSanitizer (GASPARD_SANITIZER).
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

} // namespace gaspard
