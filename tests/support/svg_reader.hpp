// Reads SVG files: elements by name through tinyxml2, and path data by SVG's grammar.
#pragma once

#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tinyxml2.h>
#include <vector>

namespace gaspard {

struct SvgPoint {
    double x = 0, y = 0;
};

/// A subpath: its corners, and the control points of its curves.
struct SvgStroke {
    std::vector<SvgPoint> corners, controls;
    bool closed = false;
};

/// Absolute positions of the commands M, m, l, q and z, the only ones that are written. Throws for others.
inline std::vector<SvgStroke> read_path(std::string_view data) {
    std::vector<SvgStroke> strokes;
    SvgPoint at, begin;
    char command = 0;
    const auto number = [&] {
        while (!data.empty() && (data[0] == ' ' || data[0] == ',')) data.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(data.data(), data.data() + data.size(), value);
        if (error != std::errc())
            throw std::runtime_error("no number at '" + std::string(data.substr(0, 20)) + "'");
        data.remove_prefix(static_cast<std::size_t>(end - data.data()));
        return value;
    };
    const auto step = [&](SvgPoint from) {
        const double x = number(), y = number();
        return SvgPoint{from.x + x, from.y + y};
    };
    while (!data.empty()) {
        if (std::isalpha(static_cast<unsigned char>(data[0])) != 0) {
            command = data[0];
            data.remove_prefix(1);
        }
        if (command == 'M' || command == 'm') {
            at = begin = step(command == 'M' ? SvgPoint{} : at);
            strokes.push_back({{at}, {}, false});
            command = 'l';
        } else if (command == 'l') {
            at = step(at);
            strokes.back().corners.push_back(at);
        } else if (command == 'q') {
            strokes.back().controls.push_back(step(at));
            at = step(at);
            strokes.back().corners.push_back(at);
        } else if (command == 'z') {
            strokes.back().closed = true;
            at = begin;
            command = 0;
        } else {
            throw std::runtime_error("unknown command in a path");
        }
    }
    return strokes;
}

class SvgReader {
  public:
    explicit SvgReader(const std::string& text) {
        if (document_.Parse(text.c_str()) != tinyxml2::XML_SUCCESS)
            throw std::runtime_error(document_.ErrorStr());
    }
    const tinyxml2::XMLElement& root() const { return *document_.RootElement(); }

    /// All elements with a name, within `from` or in the whole file, in document order.
    std::vector<const tinyxml2::XMLElement*> all(const std::string& name,
                                                 const tinyxml2::XMLElement* from = nullptr) const {
        std::vector<const tinyxml2::XMLElement*> found;
        const std::function<void(const tinyxml2::XMLElement*)> look =
            [&](const tinyxml2::XMLElement* element) {
                for (auto* e = element->FirstChildElement(); e; e = e->NextSiblingElement()) {
                    if (e->Name() == name) found.push_back(e);
                    look(e);
                }
            };
        look(from ? from : document_.RootElement());
        return found;
    }
    const tinyxml2::XMLElement* with_id(const std::string& id) const {
        for (const char* name : {"g", "path"})
            for (const auto* e : all(name))
                if (e->Attribute("id") && e->Attribute("id") == id) return e;
        return nullptr;
    }
    /// The text of the image, including superscripts.
    std::vector<std::string> texts() const {
        std::vector<std::string> found;
        for (const auto* e : all("text")) {
            std::string text;
            for (auto* node = e->FirstChild(); node; node = node->NextSibling())
                text += node->ToText() ? node->Value() : node->ToElement()->GetText();
            found.push_back(text);
        }
        return found;
    }

  private:
    tinyxml2::XMLDocument document_;
};

} // namespace gaspard
