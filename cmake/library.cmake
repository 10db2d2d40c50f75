# The core as a shared library for other programs: libgaspard, its headers, find_package(Gaspard) with the target
# Gaspard::gaspard. What the library is made with (toml++, JSON, pugixml, TinyGLTF, stb, OpenMesh) stays inside of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What a simulation needs; src/core/gaspard.hpp includes all of them. Other headers are not public.
set(public_headers
  gaspard.hpp base/box.hpp base/error.hpp base/field.hpp base/parameter.hpp base/points.hpp base/series.hpp base/version.hpp
  mesh/discretisation.hpp mesh/domain_type.hpp mesh/mesh.hpp mesh/patch_list.hpp mesh/space.hpp mesh/sphere_mesh.hpp mesh/surface_topology.hpp
  monitor/function.hpp monitor/monitor.hpp monitor/problem_data.hpp monitor/tensor.hpp
  method/method.hpp
  scenario/catalogue.hpp scenario/output_rows.hpp scenario/pde_type.hpp scenario/scenario.hpp scenario/toml.hpp session/run.hpp session/series_table.hpp session/snapshot.hpp
  tessellate/check_view.hpp tessellate/colour_choice.hpp io/formats.hpp io/run_files.hpp io/state_file.hpp io/surface_mesh.hpp
  spline/knots.hpp spline/patch_file.hpp spline/patch_map.hpp spline/spline_patch.hpp spline/tensor_space.hpp)
# Here they are "core/session/run.hpp", for others <gaspard/session/run.hpp>.
foreach(header IN LISTS public_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/core/${header})
  file(READ src/core/${header} text)
  string(REPLACE "#include \"core/" "#include \"gaspard/" text "${text}")
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/include/gaspard/${header} CONTENT "${text}" @ONLY)
  get_filename_component(module ${header} DIRECTORY)
  install(FILES ${CMAKE_BINARY_DIR}/include/gaspard/${header}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gaspard/${module} COMPONENT development)
endforeach()

add_library(gaspard_library SHARED $<TARGET_OBJECTS:gaspard_core>)
add_library(Gaspard::gaspard ALIAS gaspard_library)
set_target_properties(gaspard_library PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME gaspard EXPORT_NAME gaspard
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(gaspard_library INTERFACE cxx_std_20)
target_include_directories(gaspard_library INTERFACE
  $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(gaspard_library PUBLIC Threads::Threads
  PRIVATE $<BUILD_INTERFACE:gaspard_options> $<BUILD_INTERFACE:tomlplusplus::tomlplusplus>
    $<BUILD_INTERFACE:pugixml::pugixml> $<BUILD_INTERFACE:TinyGLTF::TinyGLTF> $<BUILD_INTERFACE:PkgConfig::STB> $<BUILD_INTERFACE:PkgConfig::NETCDF> $<BUILD_INTERFACE:OpenMeshCore>)
if(NOT GASPARD_SANITIZER)
  target_link_options(gaspard_library PRIVATE LINKER:-z,defs) # complete in itself
endif()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Gaspard)
configure_package_config_file(cmake/GaspardConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/GaspardConfig.cmake
  INSTALL_DESTINATION ${config_folder})
# While the version begins with 0, a new minor one may change what headers promise.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/GaspardConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS gaspard_library EXPORT GaspardTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT GaspardTargets NAMESPACE Gaspard:: DESTINATION ${config_folder} COMPONENT development)
install(FILES ${CMAKE_BINARY_DIR}/cmake/GaspardConfig.cmake ${CMAKE_BINARY_DIR}/cmake/GaspardConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT development)
