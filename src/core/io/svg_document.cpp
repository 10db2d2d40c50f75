#include "core/io/svg_document.hpp"

#include "core/base/superscript.hpp"
#include "core/base/version.hpp"
#include "core/io/xml.hpp"

#include <array>
#include <utility>
#include <vector>

namespace gaspard {

namespace {

constexpr double raised_size = 0.7, rise = 0.38; // of the font's size

struct Piece {
    std::string text;
    bool raised = false;
};

std::vector<Piece> split(std::string_view text) {
    std::vector<Piece> pieces;
    while (!text.empty()) {
        const auto [length, raised] = superscript(text);
        if (pieces.empty() || pieces.back().raised != (length > 0)) pieces.push_back({{}, length > 0});
        pieces.back().text += length > 0 ? raised : text.substr(0, 1);
        text.remove_prefix(length > 0 ? length : 1);
    }
    return pieces;
}

} // namespace

std::string svg_colour(std::array<unsigned char, 3> colour) {
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned char channel : colour) (text += digits[channel >> 4]) += digits[channel & 15];
    return text;
}

std::string svg_background(const Background& background) {
    if (background.kind == Background::Kind::transparent) return "";
    return background.kind == Background::Kind::theme ? "#fff" : svg_colour(background.colour);
}

std::string svg_document(double width, double height, std::string_view title, std::string_view content,
                         std::string_view background, double zoom) {
    const std::string w = svg_number(width), h = svg_number(height);
    std::string below;
    if (!background.empty())
        below = "<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"" + std::string(background) + "\"/>\n";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
           svg_number(zoom * width / points_per_mm) + "mm\" height=\"" +
           svg_number(zoom * height / points_per_mm) + "mm\" viewBox=\"0 0 " + w + ' ' + h +
           "\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"" +
           svg_number(svg_font_size) + "\">\n<title>" + xml_escape(title) + "</title>\n<desc>Gaspard " +
           std::string(version()) + "</desc>\n" + below + std::string(content) + "</svg>\n";
}

std::string svg_text(PagePoint at, Anchor anchor, std::string_view text, std::string_view attributes) {
    std::string out = "<text x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) + '"';
    if (anchor == Anchor::middle) out += " text-anchor=\"middle\"";
    if (anchor == Anchor::end) out += " text-anchor=\"end\"";
    if (!attributes.empty()) out += ' ' + std::string(attributes);
    out += '>';
    bool raised = false;
    for (const Piece& piece : split(text)) {
        const std::string inside = xml_escape(piece.text), up = svg_number(rise * svg_font_size);
        if (piece.raised)
            out += "<tspan dy=\"-" + up + "\" font-size=\"" + svg_number(raised_size * svg_font_size) +
                   "\">" + inside + "</tspan>";
        else
            out += raised ? "<tspan dy=\"" + up + "\">" + inside + "</tspan>" : inside;
        raised = piece.raised;
    }
    return out + "</text>\n";
}

double svg_text_width(std::string_view text) {
    double characters = 0;
    for (const Piece& piece : split(text))
        for (const char byte : piece.text)
            if ((static_cast<unsigned char>(byte) & 0xc0u) != 0x80) // the first byte of a character
                characters += piece.raised ? raised_size : 1;
    return 0.56 * svg_font_size * characters;
}

std::vector<std::string> svg_lines(const std::vector<std::string>& parts, double width) {
    constexpr std::string_view between = " · ";
    std::vector<std::string> lines;
    for (const std::string& part : parts) {
        const std::string longer = lines.empty() ? part : lines.back() + std::string(between) + part;
        if (lines.empty() || svg_text_width(longer) > width)
            lines.push_back(part);
        else
            lines.back() = longer;
    }
    return lines;
}

std::string path_element(const SvgPath& path, const std::string& attributes) {
    return path.empty() ? "" : "<path" + attributes + " d=\"" + path.data() + "\"/>\n";
}

} // namespace gaspard
