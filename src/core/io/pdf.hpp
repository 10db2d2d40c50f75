// Vector graphics as PDF: a drawing as SVG, converted by librsvg and cairo.
#pragma once


#include <filesystem>
#include <string>

namespace gaspard {

/// One page of the size of the drawing, with paths and text as vectors; the same bytes for the same drawing
/// and fonts. Throws MachineError if the libraries fail.
std::string pdf_of_svg(const std::string& svg);

/// Throws MachineError also if the file cannot be written.
void write_pdf(const std::filesystem::path& file, const std::string& svg);

} // namespace gaspard
