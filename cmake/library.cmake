# The core as a shared library for other programs: libgaspard, its headers, find_package(Gaspard) with the target
# Gaspard::gaspard. What the library is made with (toml++, JSON, pugixml, muParser, TinyGLTF, stb, OpenMesh) stays inside of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What a simulation needs; src/core/gaspard.hpp includes all of them. Other headers are not public.
set(public_headers
  gaspard.hpp base/box.hpp base/error.hpp base/export.hpp base/field.hpp base/file_cache.hpp base/parameter.hpp base/points.hpp base/series.hpp base/version.hpp
  mesh/discretisation.hpp mesh/domain_type.hpp mesh/mesh.hpp mesh/patch_list.hpp mesh/patch_parameters.hpp mesh/solid_shape.hpp mesh/space.hpp mesh/sphere_mesh.hpp mesh/surface_mesh.hpp mesh/surface_topology.hpp
  diagnostics/interpolation_error.hpp data/field_data.hpp data/image.hpp function/field_options.hpp function/formula.hpp function/image_options.hpp function/scalar_function.hpp mesh/data_context.hpp
  monitor/combine.hpp monitor/derived.hpp monitor/field_monitor.hpp monitor/formula_monitor.hpp monitor/function.hpp monitor/image_monitor.hpp monitor/monitor.hpp monitor/problem_data.hpp monitor/tensor.hpp
  method/method.hpp
  scenario/catalogue.hpp scenario/data_files.hpp scenario/output_rows.hpp monitor/pde_type.hpp scenario/scenario.hpp scenario/toml.hpp session/interpolation_study.hpp session/run.hpp session/series_table.hpp session/snapshot.hpp
  tessellate/check_view.hpp tessellate/colour_choice.hpp io/formats.hpp io/history_file.hpp io/run_files.hpp io/state_file.hpp
  spline/knots.hpp spline/patch_choice.hpp spline/patch_file.hpp spline/patch_map.hpp spline/spline_patch.hpp spline/tensor_space.hpp)
# Here they are "core/session/run.hpp", for others <gaspard/session/run.hpp>.
foreach(header IN LISTS public_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/core/${header})
  file(READ src/core/${header} text)
  string(REPLACE "#include \"core/" "#include \"gaspard/" text "${text}")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/include/gaspard/${header} CONTENT "${text}" @ONLY)
endforeach()

add_library(gaspard_library SHARED $<TARGET_OBJECTS:gaspard_core>)
add_library(Gaspard::gaspard ALIAS gaspard_library)
set_target_properties(gaspard_library PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME gaspard EXPORT_NAME gaspard
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(gaspard_library INTERFACE cxx_std_20)
target_include_directories(gaspard_library INTERFACE
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(gaspard_library PUBLIC Threads::Threads
  PRIVATE $<BUILD_INTERFACE:gaspard_options> $<BUILD_INTERFACE:tomlplusplus::tomlplusplus>
    $<BUILD_INTERFACE:pugixml::pugixml> $<BUILD_INTERFACE:TinyGLTF::TinyGLTF> $<BUILD_INTERFACE:PkgConfig::STB> $<BUILD_INTERFACE:PkgConfig::NETCDF> $<BUILD_INTERFACE:PkgConfig::HDF5> $<BUILD_INTERFACE:PkgConfig::MUPARSER> $<BUILD_INTERFACE:PkgConfig::RSVG> $<BUILD_INTERFACE:PkgConfig::CAIRO> $<BUILD_INTERFACE:PNG::PNG> $<BUILD_INTERFACE:JPEG::JPEG> $<BUILD_INTERFACE:OpenMeshCore>)
# The list of symbols leaves out instances of the standard library's templates, which no visibility hides.
# -Bsymbolic: the library calls its own inline functions, not those of a program compiled with other options.
set(symbols ${PROJECT_SOURCE_DIR}/cmake/library.map)
target_link_options(gaspard_library PRIVATE LINKER:--version-script=${symbols} LINKER:-Bsymbolic)
set_property(TARGET gaspard_library APPEND PROPERTY LINK_DEPENDS ${symbols})
if(NOT GASPARD_SANITIZER)
  target_link_options(gaspard_library PRIVATE LINKER:-z,defs) # complete in itself
endif()

if(NOT GASPARD_INSTALL)
  return()
endif()
foreach(header IN LISTS public_headers)
  get_filename_component(module ${header} DIRECTORY)
  install(FILES ${PROJECT_BINARY_DIR}/include/gaspard/${header}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gaspard/${module} COMPONENT development)
endforeach()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Gaspard)
configure_package_config_file(cmake/GaspardConfig.cmake.in ${PROJECT_BINARY_DIR}/cmake/GaspardConfig.cmake
  INSTALL_DESTINATION ${config_folder})
# While the version begins with 0, a new minor one may change what headers promise.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/GaspardConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS gaspard_library EXPORT GaspardTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT GaspardTargets NAMESPACE Gaspard:: DESTINATION ${config_folder} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/cmake/GaspardConfig.cmake ${PROJECT_BINARY_DIR}/cmake/GaspardConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT development)

# For pkg-config. The prefix is where the file is found, so that the installed tree can be moved.
cmake_path(IS_ABSOLUTE CMAKE_INSTALL_LIBDIR absolute)
if(absolute)
  set(pkgconfig_prefix ${CMAKE_INSTALL_PREFIX})
else()
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
    OUTPUT_VARIABLE up)
  set(pkgconfig_prefix "\${pcfiledir}/${up}")
endif()
cmake_path(APPEND pkgconfig_libdir "\${prefix}" ${CMAKE_INSTALL_LIBDIR})
cmake_path(APPEND pkgconfig_includedir "\${prefix}" ${CMAKE_INSTALL_INCLUDEDIR})
configure_file(cmake/gaspard.pc.in ${PROJECT_BINARY_DIR}/cmake/gaspard.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/gaspard.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)
