# The program: the window, the offscreen picture and the command line.
find_package(CLI11 REQUIRED)
find_package(glfw3 REQUIRED)
find_package(glm REQUIRED)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig)

# The window and the offscreen picture.
file(GLOB_RECURSE GASPARD_GUI_SOURCES CONFIGURE_DEPENDS src/gui/*.cpp)
gaspard_embed(GASPARD_GUI_ASSETS gui_assets FILES shaders/*.vert shaders/*.frag shaders/*.glsl assets/fonts/*.ttf
              assets/thumbnails/*.png)
add_library(gaspard_gui STATIC ${GASPARD_GUI_SOURCES} ${GASPARD_GUI_ASSETS})
gaspard_unity(gaspard_gui)
target_include_directories(gaspard_gui PUBLIC src PRIVATE ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(gaspard_gui PUBLIC gaspard_core PkgConfig::IMGUI glm::glm
  PRIVATE gaspard_options tomlplusplus::tomlplusplus PkgConfig::STB PkgConfig::FONTCONFIG glfw ${CMAKE_DL_LIBS})
target_precompile_headers(gaspard_gui PRIVATE ${GASPARD_STANDARD_HEADERS} <imgui.h>)

# The command line.
file(GLOB GASPARD_CLI_SOURCES CONFIGURE_DEPENDS src/cli/*.cpp)
add_executable(gaspard src/main.cpp ${GASPARD_CLI_SOURCES})
gaspard_unity(gaspard)
target_link_libraries(gaspard PRIVATE gaspard_options gaspard_gui CLI11::CLI11)
target_compile_options(gaspard PRIVATE -O1) # it reads arguments and prints; the work is done in the libraries
