# Writes OUT/NAME.hpp and OUT/NAME.cpp from the FILES below ROOT (separated by |). See embed.cmake.
file(WRITE ${OUT}/${NAME}.hpp.new "// Generated from the files in assets/ and shaders/.
#pragma once
#include <span>
#include <string_view>
namespace gaspard::${NAME} {
struct File {
    std::string_view path; ///< below the root of the sources
    std::string_view bytes;
};
std::span<const File> files();
} // namespace gaspard::${NAME}
")
set(arrays "")
set(table "")
set(index 0)
string(REPLACE "|" ";" FILES "${FILES}")
foreach(path IN LISTS FILES)
  file(READ ${ROOT}/${path} hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR bytes "${digits} / 2")
  string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
  string(APPEND arrays "const unsigned char file${index}[] = {\n${hex}0};\n")
  string(APPEND table "    {\"${path}\", {reinterpret_cast<const char*>(file${index}), ${bytes}}},\n")
  math(EXPR index "${index} + 1")
endforeach()
if(index)
  set(table_declaration "const File table[] = {\n${table}};")
  set(table_value table)
else()
  set(table_declaration "")
  set(table_value "{}")
endif()
file(WRITE ${OUT}/${NAME}.cpp.new "// Generated from the files in assets/ and shaders/.
#include \"${NAME}.hpp\"
namespace gaspard::${NAME} {
namespace {
${arrays}
${table_declaration}
} // namespace
std::span<const File> files() { return ${table_value}; }
} // namespace gaspard::${NAME}
")
file(RENAME ${OUT}/${NAME}.hpp.new ${OUT}/${NAME}.hpp)
file(RENAME ${OUT}/${NAME}.cpp.new ${OUT}/${NAME}.cpp)
