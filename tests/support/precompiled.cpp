// Carries the headers that all test programs share, precompiled (tests/CMakeLists.txt).
int main() {}
