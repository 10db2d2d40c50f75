// What LeakSanitizer is not to report: fontconfig, by which figures find their fonts, keeps its caches until
// the program ends; so do the drivers that draw in memory.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:swrast_dri";
}
