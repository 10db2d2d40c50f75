// What sanitizers are not to report, of libraries that they do not see through.

// fontconfig, by which figures find their fonts, keeps its caches until the program ends; so do the drivers
// that draw in memory.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:swrast_dri";
}

// How the threads of a driver wait for each other.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
    return "race:libOSMesa\nrace:libEGL\nrace:libgallium\nrace:swrast_dri";
}
