#include "core/spline/patch_xml.hpp"

#include "core/base/parameter.hpp"
#include "core/spline/patch_checks.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace gaspard {

namespace {

/// The content of an element and the text of its opening tag. Nested elements of the same name are not
/// handled: in these files only <Basis> is nested, and it is never looked up.
struct Element {
    std::string_view tag, content;
    std::size_t end = 0; ///< position after the element in the searched text
};

std::optional<Element> find_element(std::string_view text, const std::string& name, std::size_t from = 0) {
    for (std::size_t at = from; (at = text.find("<" + name, at)) != std::string_view::npos; ++at) {
        const std::size_t after = at + 1 + name.size();
        if (after < text.size() && text[after] != '>' && text[after] != ' ' && text[after] != '\n' &&
            text[after] != '\t' && text[after] != '\r')
            continue; // a longer name with this prefix
        const std::size_t open = text.find('>', at);
        const std::size_t close = text.find("</" + name, open == std::string_view::npos ? at : open);
        if (close == std::string_view::npos) return std::nullopt;
        return Element{text.substr(at, open - at), text.substr(open + 1, close - open - 1), close};
    }
    return std::nullopt;
}

std::string attribute(std::string_view tag, const std::string& name) {
    const std::size_t at = tag.find(name + "=\"");
    if (at == std::string_view::npos) return {};
    const std::size_t begin = at + name.size() + 2;
    return std::string(tag.substr(begin, tag.find('"', begin) - begin));
}

std::vector<double> numbers(std::string_view text, const std::string& what, const std::string& origin) {
    std::vector<double> all;
    const char *at = text.data(), *const end = at + text.size();
    while (true) {
        while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
        if (at == end) return all;
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc()) not_a_patch(origin, what + " must be a list of numbers");
        all.push_back(value);
        at = next;
    }
}

std::string without_comments(std::string_view xml) {
    std::string text(xml);
    for (std::size_t begin; (begin = text.find("<!--")) != std::string::npos;) {
        const std::size_t end = text.find("-->", begin);
        text.erase(begin, end == std::string::npos ? end : end + 3 - begin);
    }
    return text;
}

/// The first geometry with two directions.
Element geometry(std::string_view text, const std::string& origin) {
    std::size_t from = 0;
    while (const auto found = find_element(text, "Geometry", from)) {
        const std::string type = attribute(found->tag, "type");
        if (type == "TensorBSpline2" || type == "TensorNurbs2") return *found;
        from = found->end;
    }
    not_a_patch(origin, "it has no <Geometry> of type TensorBSpline2 or TensorNurbs2");
}

Element child(const Element& parent, const std::string& name, const std::string& origin) {
    if (const auto found = find_element(parent.content, name)) return *found;
    not_a_patch(origin, "the geometry has no <" + name + ">");
}

} // namespace

SplinePatch parse_patch_xml(std::string_view xml, const std::string& origin) {
    const std::string text = without_comments(xml);
    const Element whole = geometry(text, origin);
    SplinePatch patch;
    std::size_t from = 0;
    for (const char* which : {"0", "1"}) {
        const auto found = find_element(whole.content, "KnotVector", from);
        if (!found) not_a_patch(origin, "the geometry must have two <KnotVector>");
        const std::string degree = attribute(found->tag, "degree");
        const auto parsed = numbers(degree, "degree", origin);
        patch.space.directions.push_back(checked_direction(parsed.size() == 1 ? parsed[0] : 0,
                                                           numbers(found->content, "<KnotVector>", origin),
                                                           which, origin));
        from = found->end;
    }
    const Element coefs = child(whole, "coefs", origin);
    const auto values = numbers(coefs.content, "<coefs>", origin);
    const std::string dimension = attribute(coefs.tag, "geoDim");
    if (dimension != "2" && dimension != "3") not_a_patch(origin, "<coefs> must have geoDim=\"2\" or \"3\"");
    const std::size_t d = dimension == "2" ? 2 : 3, n = values.size() / d;
    if (values.size() % d != 0) not_a_patch(origin, "the length of <coefs> is not a multiple of geoDim");
    patch.control = Points(n);
    for (std::size_t i = 0; i < n; ++i)
        patch.control.set(i, {values[d * i], values[d * i + 1], d == 3 ? values[d * i + 2] : 0});
    patch.weights.assign(n, 1.0);
    if (const auto weights = find_element(whole.content, "weights"))
        patch.weights = numbers(weights->content, "<weights>", origin);
    check_patch(patch, origin);
    return patch;
}

std::string patch_xml(const SplinePatch& patch) {
    const auto& w = patch.weights;
    const bool rational = std::any_of(w.begin(), w.end(), [](double one) { return one != 1; });
    const auto& z = patch.control.z;
    const bool flat = std::all_of(z.begin(), z.end(), [](double one) { return one == 0; });
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n";
    text +=
        std::string(" <Geometry type=\"") + (rational ? "TensorNurbs2" : "TensorBSpline2") + "\" id=\"0\">\n";
    if (rational) text += "  <Basis type=\"TensorNurbsBasis2\">\n";
    text += "  <Basis type=\"TensorBSplineBasis2\">\n";
    for (std::size_t d = 0; d < 2; ++d) {
        const KnotVector& line = patch.space.directions[d];
        text += "   <Basis type=\"BSplineBasis\" index=\"" + std::to_string(d) +
                "\">\n    <KnotVector degree=\"" + std::to_string(line.degree) + "\">";
        for (const double knot : line.knots) text += format_number(knot) + ' ';
        text += "</KnotVector>\n   </Basis>\n";
    }
    text += "  </Basis>\n";
    if (rational) {
        text += "  <weights>\n";
        for (const double one : w) text += format_number(one) + '\n';
        text += "  </weights>\n  </Basis>\n";
    }
    text += std::string("  <coefs geoDim=\"") + (flat ? "2" : "3") + "\">\n";
    for (std::size_t i = 0; i < patch.control.size(); ++i) {
        const Vec3 c = patch.control[i];
        text += format_number(c.x) + ' ' + format_number(c.y) + (flat ? "" : ' ' + format_number(c.z)) + '\n';
    }
    return text + "  </coefs>\n </Geometry>\n</xml>\n";
}

} // namespace gaspard
