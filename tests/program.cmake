# The tests of the program: its window, its pictures, its command line, and what is installed.
# Meshes and scenes to draw, and the comparison of pictures.
add_library(gaspard_scenes STATIC gui/scenes.cpp gui/globes.cpp gui/similarity.cpp)
gaspard_unity(gaspard_scenes)
target_include_directories(gaspard_scenes PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(gaspard_scenes PUBLIC gaspard_fixtures gaspard_gui PRIVATE gaspard_options)

# What has to be quick: frames, dragging, picking, plots.
set(timing_tests core/session/drag_test.cpp gui/app/frame_cost_test.cpp gui/scene/picking_time_test.cpp gui/panels/monitor_pictures_time_test.cpp
  gui/plot/plot_time_test.cpp)
gaspard_test(timing_tests LABELS timing LIBRARIES gaspard_scenes SOURCES ${timing_tests})
set(picture_tests gui/app/pdf_figure_test.cpp gui/app/whole_window_test.cpp gui/app/viewport_image_test.cpp gui/app/globe_image_test.cpp gui/app/fixture_image_test.cpp gui/app/thumbnail_image_test.cpp
  gui/gl/imgui_renderer_test.cpp gui/plot/plot_image_test.cpp gui/render/mesh_draft_test.cpp
  gui/render/mesh_renderer_test.cpp)

# The window's panels, with no graphics backend: all other tests of the window.
file(GLOB_RECURSE gui_tests RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS gui/*_test.cpp)
list(REMOVE_ITEM gui_tests ${timing_tests} ${picture_tests} gui/app/window_test.cpp)
gaspard_test(gui_tests LABELS threads LIBRARIES gaspard_scenes PkgConfig::IMGUI SOURCES ${gui_tests})

# Pictures drawn offscreen, compared with those in tests/goldens, which make_goldens draws anew.
gaspard_test(picture_tests LABELS graphics LIBRARIES gaspard_scenes PkgConfig::IMGUI SOURCES ${picture_tests})
# Images are drawn by OSMesa where it is installed. Golden.LooksTheSameThroughEgl compares those of EGL with the
# stored ones, too; this repeats the negative controls through EGL.
add_test(NAME pictures_through_egl COMMAND picture_tests --gtest_brief=1 --gtest_filter=Wrong*:Offscreen.*:Fixture*)
set_tests_properties(pictures_through_egl PROPERTIES TIMEOUT 300 LABELS graphics COST 8
  ENVIRONMENT GASPARD_OFFSCREEN=egl)
add_executable(make_goldens gui/make_goldens.cpp)
target_link_libraries(make_goldens PRIVATE gaspard_options gaspard_test_options gaspard_scenes)

# The program in a real window, on a screen in memory.
gaspard_test(window_tests LABELS display LIBRARIES gaspard_gui PkgConfig::IMGUI nlohmann_json::nlohmann_json
  SOURCES gui/app/window_test.cpp gui/virtual_display.cpp)
target_compile_definitions(window_tests PRIVATE GASPARD_PROGRAM="$<TARGET_FILE:gaspard>")
add_dependencies(window_tests gaspard)

# The command line, as a user's script sees it.
foreach(group Runs BadInput Files Machine Information Films)
  add_test(NAME cli_${group} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cli/contract_test.py
    $<TARGET_FILE:gaspard> ${group})
  set_tests_properties(cli_${group} PROPERTIES TIMEOUT 300 LABELS "graphics" COST 7)
endforeach()

# README and docs: links, paths and labels that they name, and the examples, which are run.
foreach(group Text Examples)
  add_test(NAME documents_${group} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/documents_test.py
    $<TARGET_FILE:gaspard> ${group})
endforeach()
set_tests_properties(documents_Examples PROPERTIES TIMEOUT 600 LABELS "graphics" COST 22)

# What is installed and packaged is enough for others.
add_test(NAME installed_library COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/install/library_test.py
  ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/examples)
set_tests_properties(installed_library PROPERTIES TIMEOUT 600 LABELS "graphics" COST 60)
add_test(NAME debian_packages COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/install/package_test.py
  ${PROJECT_SOURCE_DIR})
set_tests_properties(debian_packages PROPERTIES TIMEOUT 1500 LABELS "graphics;long" COST 150)
