# gaspard_embed(OUT NAME FILES patterns...): files as constants in the program.
# Makes generated/NAME.hpp and NAME.cpp with `std::span<const EmbeddedFile> NAME()`; sets OUT to the source.
function(gaspard_embed out name)
  cmake_parse_arguments(ARG "" "" "FILES" ${ARGN})
  set(files)
  foreach(pattern IN LISTS ARG_FILES)
    file(GLOB found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${pattern})
    list(APPEND files ${found})
  endforeach()
  list(SORT files)
  set(source ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
  set(header ${PROJECT_BINARY_DIR}/generated/${name}.hpp)
  string(REPLACE ";" "|" packed "${files}")
  add_custom_command(OUTPUT ${source} ${header}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} "-DFILES=${packed}" -DROOT=${PROJECT_SOURCE_DIR}
            -DOUT=${PROJECT_BINARY_DIR}/generated -P ${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM COMMENT "Embedding ${name}")
  set(${out} ${source} ${header} PARENT_SCOPE)
endfunction()
