#include "core/spline/patch_xml.hpp"

#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parameter.hpp"
#include "core/spline/patch_checks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <new>
#include <pugixml.hpp>

namespace gaspard {

namespace {

using Node = pugi::xml_node;

constexpr double most_knots = 1e6; // of a uniform knot vector

/// Whitespace between comments counts, since it separates numbers.
constexpr unsigned parse_options =
    pugi::parse_default | pugi::parse_ws_pcdata | pugi::parse_fragment | pugi::parse_doctype;

/// A document is one element; text after it comes from a damaged file.
void check_root(const pugi::xml_document& document, const std::string& origin) {
    int elements = 0;
    for (const pugi::xml_node& node : document) {
        elements += node.type() == pugi::node_element ? 1 : 0;
        const std::string_view text = node.value();
        if (node.type() == pugi::node_doctype &&
            (text.find("<!ENTITY") != text.npos || text.find("<!ATTLIST") != text.npos))
            cannot_read(origin, "its <!DOCTYPE> declares entities or attributes, which are not read; remove "
                                "the declarations");
        const bool is_text = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
        if (elements > 1 || (is_text && text.find_first_not_of(" \t\r\n") != std::string_view::npos))
            cannot_read(origin, "it has more than one XML element, or text outside of it");
    }
    if (elements == 0) cannot_read(origin, "it has no XML element");
}

/// The next node in document order; within `node` only if `inside`.
Node next_node(const Node& node, const Node& root, bool inside) {
    if (inside && node.first_child()) return node.first_child();
    for (Node at = node; at && at != root; at = at.parent())
        if (at.next_sibling()) return at.next_sibling();
    return {};
}

/// XML forbids two attributes of one name, but the library's parser takes the first.
void check_attributes(const pugi::xml_document& document, const std::string& origin) {
    std::vector<std::string_view> names;
    for (Node at = document.first_child(); at; at = next_node(at, document, true)) {
        names.clear();
        for (const pugi::xml_attribute& one : at.attributes()) names.emplace_back(one.name());
        std::sort(names.begin(), names.end());
        const auto twice = std::adjacent_find(names.begin(), names.end());
        if (twice != names.end())
            cannot_read(origin, "<" + std::string(at.name()) + "> has the attribute '" + std::string(*twice) +
                                    "' twice");
    }
}

void load(pugi::xml_document& document, const PatchText& file) {
    const auto result = document.load_buffer(file.text.data(), file.text.size(), parse_options);
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) {
        const auto at =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), file.text.size());
        const auto line =
            1 + std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        cannot_read(file.origin, "XML syntax error at line " + std::to_string(line));
    }
    check_root(document, file.origin);
    check_attributes(document, file.origin);
}

/// All text of an element, without that of its children.
std::string text_of(const Node& node) {
    std::string text;
    for (const Node& child : node)
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
    return text;
}

/// Elements below `root` with a name, in document order.
std::vector<Node> elements(const Node& root, std::string_view name) {
    std::vector<Node> found;
    for (Node at = root.first_child(); at; at = next_node(at, root, true))
        if (name == at.name()) found.push_back(at);
    return found;
}

struct Refused {
    std::string_view name, what;
};

/// Elements that are geometries of another kind, and what they are. Geometries inside of them are parts.
constexpr std::array<Refused, 5> other_elements = {{
    {"MultiPatch", "a list of patches: choose one of them"},
    {"TrimSurface", "a trimmed surface"},
    {"PlanarDomain", "a planar domain given by its boundary curves"},
    {"Solid", "a solid given by trimmed surfaces"},
    {"Mesh", "a mesh, not a spline"},
}};

/// Why a <Geometry> of this type is not read; empty if it is.
std::string refusal_of(std::string_view type, const PatchText& file) {
    if (type == "BSpline" || type == "Nurbs") return refusal_of_directions(1, file);
    for (const std::string_view tensor : {"TensorBSpline", "TensorNurbs"})
        for (const char directions : {'1', '2', '3', '4'})
            if (type == std::string(tensor) + directions)
                return refusal_of_directions(static_cast<std::size_t>(directions - '0'), file);
    if (type.starts_with("THBSpline"))
        return "a truncated hierarchical spline (THB); convert it to tensor form";
    if (type.starts_with("HBSpline")) return "a hierarchical spline (HB); convert it to tensor form";
    const std::string d = std::to_string(file.directions);
    return "a geometry of another kind (Gaspard reads TensorBSpline" + d + " and TensorNurbs" + d + ")";
}

struct Found {
    PatchEntry entry;
    Node node;
};

std::vector<Found> geometries(const pugi::xml_document& document, const PatchText& file) {
    std::vector<Found> all;
    const auto add = [&](const Node& node, std::string_view kind, std::string refusal) {
        all.push_back({{std::string(kind), node.attribute("id").value(), std::move(refusal)}, node});
    };
    bool inside = true;
    for (Node at = document.first_child(); at; at = next_node(at, document, inside)) {
        const std::string_view name = at.name();
        inside = true;
        if (name == "Geometry") {
            const std::string_view type = at.attribute("type").value();
            add(at, type.empty() ? "Geometry without type" : type, refusal_of(type, file));
            inside = false;
        }
        for (const Refused& other : other_elements)
            if (name == other.name) {
                add(at, name, std::string(other.what));
                inside = name == "MultiPatch"; // its patches may be in it or beside it
            }
    }
    return all;
}

/// The numbers of an element: text, or base64 of the attribute `format`, such as B64Float64.
std::vector<double> numbers(const Node& node, const std::string& origin) {
    const std::string what = "<" + std::string(node.name()) + ">";
    std::string format = node.attribute("format").value();
    std::transform(format.begin(), format.end(), format.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    try {
        if (format.empty() || format == "ascii") return parse_numbers(text_of(node), what);
        if (format.starts_with("b64")) return decode_numbers(text_of(node), format.substr(3), what);
    } catch (const InputError& error) {
        not_a_patch(origin, error.what());
    }
    not_a_patch(origin, what + " has the unknown format '" + node.attribute("format").value() + "'");
}

/// A number in an attribute; `missing` if there is none or it is not a number.
double number(const Node& node, const char* attribute, double missing) {
    const std::string text = node.attribute(attribute).value();
    const auto begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
    if (begin == std::string::npos) return missing;
    return parse_number(std::string_view(text).substr(begin, end - begin + 1)).value_or(missing);
}

/// csize basis functions on equal cells of [0, 1].
std::vector<double> uniform(double degree, double csize, const std::string& origin) {
    if (!(csize <= most_knots) || !(csize > degree) || csize != std::floor(csize) || !(degree >= 1))
        not_a_patch(origin, "<KnotVector mode=\"uniform\"> must have a csize above its degree");
    const auto p = static_cast<std::size_t>(degree), cells = static_cast<std::size_t>(csize) - p;
    std::vector<double> knots(p, 0.0);
    for (std::size_t i = 0; i <= cells; ++i)
        knots.push_back(static_cast<double>(i) / static_cast<double>(cells));
    knots.insert(knots.end(), p, 1.0);
    return knots;
}

/// The only child of this name; empty if there is none.
Node optional_child(const Node& parent, const char* name, const std::string& origin) {
    const Node found = parent.child(name);
    if (found.next_sibling(name))
        not_a_patch(origin, "<" + std::string(parent.name()) + "> has more than one <" + name + ">");
    return found;
}

Node child(const Node& parent, const char* name, const std::string& origin) {
    if (const Node found = optional_child(parent, name, origin)) return found;
    not_a_patch(origin, "<" + std::string(parent.name()) + "> has no <" + name + ">");
}

void read_coefs(PatchParts& parts, const Node& geometry, const std::string& origin) {
    const Node coefs = child(geometry, "coefs", origin);
    const double dimension = number(coefs, "geoDim", 0);
    if (dimension != 2 && dimension != 3) not_a_patch(origin, "<coefs> must have geoDim=\"2\" or \"3\"");
    const auto d = static_cast<std::size_t>(dimension);
    const auto values = numbers(coefs, origin);
    if (values.size() % d != 0) not_a_patch(origin, "the length of <coefs> is not a multiple of geoDim");
    const std::string_view order = coefs.attribute("order").value();
    if (!order.empty() && order != "coordinates")
        not_a_patch(origin, "<coefs> has the unknown order '" + std::string(order) + "'");
    parts.control = order.empty() ? points_in_rows(values, d) : points_in_columns(values, d);
}

SplinePatch read_geometry(const Node& geometry, std::size_t directions, const std::string& origin) {
    const std::string type = geometry.attribute("type").value();
    const bool rational = type.starts_with("TensorNurbs");
    if (geometry.child("transform"))
        not_a_patch(origin,
                    "it has a <transform>, which is not applied; transform the control points instead");
    const Node basis = child(geometry, "Basis", origin);
    const auto lines = elements(basis, "KnotVector");
    if (lines.size() != directions)
        not_a_patch(origin, std::string("it must have ") + (directions == 2 ? "two" : "three") +
                                " <KnotVector>, but has " + std::to_string(lines.size()));
    PatchParts parts{.directions = directions};
    for (std::size_t d = 0; d < directions; ++d) {
        parts.degrees[d] = number(lines[d], "degree", 0);
        parts.knots[d] = std::string_view(lines[d].attribute("mode").value()) == "uniform"
                             ? uniform(parts.degrees[d], number(lines[d], "csize", 0), origin)
                             : numbers(lines[d], origin);
    }
    read_coefs(parts, geometry, origin);
    const Node weights = optional_child(basis, "weights", origin);
    if (rational != static_cast<bool>(weights))
        not_a_patch(origin, rational ? "its <Basis> has no <weights>" : "a " + type + " has no <weights>");
    if (rational) {
        parts.weights = numbers(weights, origin);
        if (parts.weights.empty()) not_a_patch(origin, "there must be as many weights as control points");
    }
    return make_patch(std::move(parts), origin);
}

} // namespace

FoundPatch read_gismo(const PatchText& file) {
    pugi::xml_document document;
    load(document, file);
    const auto found = geometries(document, file);
    if (found.empty())
        cannot_read(file.origin, "it has no <Geometry> of type TensorBSpline" +
                                     std::to_string(file.directions) + " or TensorNurbs" +
                                     std::to_string(file.directions) + " (G+Smo); its root element is <" +
                                     std::string(document.document_element().name()) + ">");
    std::vector<PatchEntry> entries;
    for (const Found& one : found) entries.push_back(one.entry);
    ChosenPatch chosen = choose_patch(entries, file);
    const Found& one = found[chosen.entry];
    SplinePatch patch = read_geometry(one.node, file.directions, chosen.origin);
    return {std::move(patch), std::move(chosen.origin), std::move(chosen.patches)};
}

std::string patch_xml(const SplinePatch& patch) {
    const auto& w = patch.weights;
    const bool rational = std::any_of(w.begin(), w.end(), [](double one) { return one != 1; });
    const auto& z = patch.control.z;
    const std::size_t directions = patch.space.directions.size();
    const std::string dimension = std::to_string(directions);
    const bool flat = directions == 2 && std::all_of(z.begin(), z.end(), [](double one) { return one == 0; });
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n";
    text += std::string(" <Geometry type=\"") + (rational ? "TensorNurbs" : "TensorBSpline") + dimension +
            "\" id=\"0\">\n";
    if (rational) text += "  <Basis type=\"TensorNurbsBasis" + dimension + "\">\n";
    text += "  <Basis type=\"TensorBSplineBasis" + dimension + "\">\n";
    for (std::size_t d = 0; d < directions; ++d) {
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
