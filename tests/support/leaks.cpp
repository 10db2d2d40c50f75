// What LeakSanitizer is not to report: fontconfig, by which figures find their fonts, keeps its caches until
// the program ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
