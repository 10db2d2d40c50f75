// What the shared library exports. The core is compiled with hidden visibility, so that the code of the
// libraries it is made with stays inside. A public header (cmake/library.cmake) opens its namespace with this
// attribute instead:
//
//     namespace gaspard GASPARD_API {
//
// What it declares is then exported, and nothing else is: the binary interface is what the installed headers
// say.
#pragma once

#define GASPARD_API __attribute__((visibility("default")))
