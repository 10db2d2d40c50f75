# Installs the program with its desktop entry, and makes Debian packages by CPack (scripts/package.sh):
#   gaspard          program, desktop entry, icon, manual page
#   libgaspard0.1    the library
#   libgaspard-dev   headers, CMake configuration, example
set(packages libgaspard${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}:library libgaspard-dev:development)
if(GASPARD_PROGRAM)
  list(PREPEND packages gaspard:program)
  install(TARGETS gaspard RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(FILES packaging/gaspard.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
  install(FILES packaging/gaspard.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
    COMPONENT program)
endif()

# Debian requires compressed manual pages and change logs without timestamps.
find_program(GZIP gzip REQUIRED)
configure_file(packaging/gaspard.1 ${PROJECT_BINARY_DIR}/packaging/gaspard.1 @ONLY)
configure_file(packaging/changelog.Debian ${PROJECT_BINARY_DIR}/packaging/changelog @ONLY)
function(gaspard_compress from to)
  add_custom_command(OUTPUT ${to} COMMAND ${GZIP} -9nc ${from} > ${to} DEPENDS ${from} VERBATIM)
endfunction()
set(manual ${PROJECT_BINARY_DIR}/packaging/gaspard.1.gz)
set(changes ${PROJECT_BINARY_DIR}/packaging/changelog.gz)
gaspard_compress(${PROJECT_BINARY_DIR}/packaging/gaspard.1 ${manual})
set(news ${PROJECT_BINARY_DIR}/packaging/NEWS.gz)
gaspard_compress(${PROJECT_BINARY_DIR}/packaging/changelog ${changes})
gaspard_compress(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${news})
add_custom_target(gaspard_documents ALL DEPENDS ${manual} ${changes} ${news})
if(GASPARD_PROGRAM)
  install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endif()
set(CPACK_COMPONENTS_ALL)
foreach(package IN LISTS packages)
  string(REPLACE ":" ";" package ${package})
  list(GET package 0 name)
  list(GET package 1 component)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${name})
  install(FILES packaging/copyright DESTINATION ${folder} COMPONENT ${component})
  install(FILES ${changes} ${news} DESTINATION ${folder} COMPONENT ${component})
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${key}_FILE_NAME DEB-DEFAULT)
endforeach()
install(FILES examples/follow_a_feature.cpp examples/typed_formula.cpp examples/CMakeLists.txt
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libgaspard-dev/examples COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_VENDOR "The Gaspard authors")
set(CPACK_PACKAGE_CONTACT "The Gaspard authors <gaspard@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/triggers)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# Loaded at run time, so no tool finds them: OpenGL for the window, and one of two for images without a display.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libgl1, libosmesa6 | libegl1")
# For the texts of figures as PDF.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-liberation | fonts-dejavu-core")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION}), libstdc++-12-dev | libstdc++-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "adaptive meshes by the Monge-Ampere equation
Computes adaptive meshes of the plane, the sphere and spline patches by optimal transport.
A window with sliders and plots shows the iteration; a command line writes meshes,
numbers and images without a display.")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "adaptive meshes by the Monge-Ampere equation (library)
Adaptive meshes that follow a simulation, by optimal transport.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "adaptive meshes by the Monge-Ampere equation (development files)
Headers, CMake configuration and an example.")
include(CPack)
