// Legacy files of VTK (vtk.org, "VTK File Formats"): a header of lines, then keywords with numbers in ASCII
// or big-endian binary.
#include "core/base/error.hpp"
#include "core/data/field_file.hpp"
#include "core/data/text_lines.hpp"
#include "core/data/vtk_data.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

std::string upper_case(std::string_view text) {
    std::string large(text);
    std::transform(large.begin(), large.end(), large.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return large;
}

std::string shortened(std::string_view word) { return std::string(word.substr(0, 40)); }

double ascii_number(std::string_view word) {
    if (word.empty()) throw InputError("it ends where a number is expected");
    const auto number = vtk_number(word);
    if (!number) throw InputError("it has '" + shortened(word) + "' where a number is expected");
    return *number;
}

/// Where an array of numbers is in the file.
struct Numbers {
    std::string_view text;
    std::size_t count = 0;
    VtkType type{};
    bool binary = false;
    const FieldRequest* request = nullptr; ///< null: there are no numbers
};

/// Words, lines and numbers one after the other.
class Scanner {
  public:
    Scanner(std::string_view text, const FieldRequest& request) : request_(&request), rest_(text) {}

    bool binary = false;

    std::string_view line() { return take_line(rest_); }
    /// Empty at the end.
    std::string_view word() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        const std::string_view found = rest_.substr(0, std::min(rest_.find_first_of(blanks), rest_.size()));
        rest_.remove_prefix(found.size());
        return found;
    }
    std::string_view peek() const { return Scanner(rest_, *request_).word(); }
    std::size_t count() {
        const std::string_view text = word();
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size())
            throw InputError("it has '" + shortened(text) + "' where a count is expected");
        if (value > largest_field)
            throw InputError("it has more than " + std::to_string(largest_field) + " numbers in an array");
        return value;
    }
    double number() { return ascii_number(word()); }

    /// Skips an array and tells where it is.
    Numbers numbers(std::size_t count, std::string_view type_name) {
        const auto type = vtk_type(type_name);
        if (!type)
            throw InputError("it has numbers of the type '" + shortened(type_name) + "', which is not read");
        if (binary) line(); // the end of the line with the keyword
        Numbers found{rest_, count, *type, binary, request_};
        if (binary) {
            const std::size_t bytes = count * type->bytes;
            if (bytes > rest_.size()) throw InputError("it ends within an array");
            found.text = rest_.substr(0, bytes);
            rest_.remove_prefix(bytes);
        } else {
            if (count > rest_.size()) throw InputError("it ends within an array");
            for (std::size_t i = 0; i < count; ++i) {
                if (i % 4096 == 0) check_stop(*request_, static_cast<double>(i) / static_cast<double>(count));
                if (word().empty()) throw InputError("it ends within an array");
            }
            found.text.remove_suffix(rest_.size());
        }
        return found;
    }

  private:
    const FieldRequest* request_;
    std::string_view rest_;
};

std::vector<double> read(const Numbers& numbers) {
    if (numbers.request == nullptr) return {};
    if (numbers.binary) return vtk_numbers(numbers.text, numbers.type, true);
    Scanner scanner(numbers.text, *numbers.request);
    std::vector<double> all(numbers.count);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % 4096 == 0)
            check_stop(*numbers.request, static_cast<double>(i) / static_cast<double>(all.size()));
        all[i] = scanner.number();
    }
    return all;
}

std::vector<std::size_t> read_indices(const Numbers& numbers) {
    std::vector<std::size_t> all;
    for (const double one : read(numbers)) {
        if (!(one >= 0) || one > static_cast<double>(largest_field))
            throw InputError("an index of a cell is out of range");
        all.push_back(static_cast<std::size_t>(one));
    }
    return all;
}

/// One list of cells: counts before the points of each (version 4), or offsets and connectivity (version 5).
struct CellList {
    Numbers first, second;
    bool offsets = false;
};

void append_cells(VtkCells& cells, const CellList& list) {
    if (cells.offsets.empty()) cells.offsets.push_back(0);
    const std::vector<std::size_t> first = read_indices(list.first);
    if (list.offsets) {
        const std::vector<std::size_t> points = read_indices(list.second);
        const std::size_t before = cells.connectivity.size();
        for (std::size_t i = 1; i < first.size(); ++i) cells.offsets.push_back(before + first[i]);
        cells.connectivity.insert(cells.connectivity.end(), points.begin(), points.end());
        return;
    }
    for (std::size_t at = 0; at < first.size(); at += first[at] + 1) {
        if (first[at] >= first.size() - at) throw InputError("the lists of cells are too short");
        const auto begin = first.begin() + static_cast<std::ptrdiff_t>(at + 1);
        cells.connectivity.insert(cells.connectivity.end(), begin,
                                  begin + static_cast<std::ptrdiff_t>(first[at]));
        cells.offsets.push_back(cells.connectivity.size());
    }
}

class LegacyReader {
  public:
    LegacyReader(std::string_view bytes, const FieldRequest& request) : in_(bytes, request) {}

    VtkFile read_file() {
        read_header();
        for (std::string keyword = next(); !keyword.empty(); keyword = next()) {
            if (keyword == "POINT_DATA" || keyword == "CELL_DATA")
                begin_data(keyword == "CELL_DATA");
            else if (in_data_)
                attribute(keyword);
            else
                geometry(keyword);
        }
        finish();
        return std::move(file_);
    }

  private:
    std::string next() { return upper_case(in_.word()); }

    void read_header() {
        in_.line(), in_.line();
        const std::string format = next();
        if (format != "ASCII" && format != "BINARY")
            throw InputError("its third line must be ASCII or BINARY, not '" + shortened(format) + "'");
        in_.binary = format == "BINARY";
        if (next() != "DATASET") throw InputError("its fourth line must begin with DATASET");
        kind_ = next();
        if (kind_ != "STRUCTURED_POINTS" && kind_ != "RECTILINEAR_GRID" && kind_ != "STRUCTURED_GRID" &&
            kind_ != "UNSTRUCTURED_GRID" && kind_ != "POLYDATA")
            throw InputError(
                "its data set is " + shortened(kind_) +
                ", not STRUCTURED_POINTS, RECTILINEAR_GRID, STRUCTURED_GRID, UNSTRUCTURED_GRID or "
                "POLYDATA");
    }

    void geometry(const std::string& keyword) {
        if (keyword == "DIMENSIONS") {
            for (std::size_t& one : dimensions_)
                if ((one = in_.count()) > longest_axis)
                    throw InputError("it has more than " + std::to_string(longest_axis) +
                                     " points along an axis");
            checked_product(dimensions_[0], dimensions_[1], dimensions_[2], "points");
        } else if (keyword == "ORIGIN") {
            for (double& one : origin_) one = in_.number();
        } else if (keyword == "SPACING" || keyword == "ASPECT_RATIO") {
            for (double& one : spacing_) one = in_.number();
        } else if (keyword.size() == 13 && keyword.ends_with("_COORDINATES")) {
            const std::size_t count = in_.count();
            axes_[static_cast<std::size_t>(std::clamp(keyword[0] - 'X', 0, 2))] =
                read(in_.numbers(count, in_.word()));
        } else if (keyword == "POINTS") {
            const std::size_t count = in_.count();
            points_ = in_.numbers(checked_product(count, 3, 1, "coordinates"), in_.word());
        } else if (keyword == "CELLS" || keyword == "VERTICES" || keyword == "LINES" ||
                   keyword == "POLYGONS" || keyword == "TRIANGLE_STRIPS") {
            cell_list();
        } else if (keyword == "CELL_TYPES") {
            in_.numbers(in_.count(), "int");
        } else if (keyword == "METADATA") {
            metadata();
        } else if (keyword == "FIELD") {
            field(false);
        } else {
            throw InputError("it has the keyword '" + shortened(keyword) + "', which is not read here");
        }
    }

    void cell_list() {
        const std::size_t first = in_.count(), second = in_.count();
        if (upper_case(in_.peek()) != "OFFSETS") {
            cells_.push_back({in_.numbers(second, "int"), {}, false});
            return;
        }
        in_.word();
        CellList list{in_.numbers(first, in_.word()), {}, true};
        if (next() != "CONNECTIVITY") throw InputError("its cells have no CONNECTIVITY");
        list.second = in_.numbers(second, in_.word());
        cells_.push_back(list);
    }

    void begin_data(bool of_cells) {
        in_data_ = true, of_cells_ = of_cells;
        count_ = in_.count();
    }

    void attribute(const std::string& keyword) {
        if (keyword == "FIELD") return field(true);
        if (keyword == "METADATA") return metadata();
        if (keyword == "LOOKUP_TABLE") {
            in_.word();
            in_.numbers(checked_product(in_.count(), 4, 1, "colours"),
                        in_.binary ? "unsigned_char" : "float");
            return;
        }
        const std::string name(in_.word());
        if (keyword == "SCALARS") return scalars(name);
        if (keyword == "COLOR_SCALARS") {
            in_.numbers(checked_product(in_.count(), count_, 1, "numbers"),
                        in_.binary ? "unsigned_char" : "float");
        } else if (keyword == "VECTORS" || keyword == "NORMALS") {
            add(name, 3, in_.word());
        } else if (keyword == "TENSORS" || keyword == "TENSORS6") {
            in_.numbers(checked_product(count_, keyword == "TENSORS" ? 9 : 6, 1, "numbers"), in_.word());
        } else if (keyword == "TEXTURE_COORDINATES") {
            const std::size_t components = in_.count();
            in_.numbers(checked_product(count_, components, 1, "numbers"), in_.word());
        } else if (keyword == "GLOBAL_IDS" || keyword == "PEDIGREE_IDS" || keyword == "EDGE_FLAGS") {
            in_.numbers(count_, in_.word());
        } else {
            throw InputError("it has the keyword '" + shortened(keyword) + "', which is not read");
        }
    }

    void scalars(const std::string& name) {
        const std::string_view type = in_.word();
        std::size_t components = 1;
        if (upper_case(in_.peek()) != "LOOKUP_TABLE" && !in_.peek().empty()) {
            const std::string_view next_word = in_.peek();
            if (next_word.size() == 1 && next_word[0] >= '1' && next_word[0] <= '4') components = in_.count();
        }
        if (upper_case(in_.peek()) == "LOOKUP_TABLE") in_.word(), in_.word();
        add(name, components, type);
    }

    /// FIELD name n, then n arrays: name, components, tuples, type.
    void field(bool keep) {
        in_.word();
        const std::size_t arrays = in_.count();
        for (std::size_t i = 0; i < arrays; ++i) {
            while (upper_case(in_.peek()) == "METADATA") in_.word(), metadata();
            const std::string name(in_.word());
            if (name.empty()) throw InputError("it ends within FIELD");
            if (upper_case(name) == "NULL_ARRAY") continue;
            const std::size_t components = in_.count(), tuples = in_.count();
            const std::string_view type = in_.word();
            const Numbers where = in_.numbers(checked_product(components, tuples, 1, "numbers"), type);
            if (keep && tuples == count_ && components > 0) keep_array(name, components, where);
        }
    }

    /// Lines up to an empty one.
    void metadata() {
        in_.line();
        while (!in_.line().empty()) {
        }
    }

    void add(const std::string& name, std::size_t components, std::string_view type) {
        keep_array(name, components, in_.numbers(checked_product(count_, components, 1, "numbers"), type));
    }
    void keep_array(const std::string& name, std::size_t components, const Numbers& where) {
        file_.arrays.push_back({name, of_cells_, components, [where] { return read(where); }});
    }

    void finish() {
        std::stable_sort(file_.arrays.begin(), file_.arrays.end(),
                         [](const VtkArray& a, const VtkArray& b) { return a.of_cells < b.of_cells; });
        if (kind_ == "STRUCTURED_POINTS") {
            for (std::size_t d = 0; d < 3; ++d)
                for (std::size_t i = 0; i < dimensions_[d]; ++i)
                    axes_[d].push_back(origin_[d] + static_cast<double>(i) * spacing_[d]);
            file_.axes = axes_;
        } else if (kind_ == "RECTILINEAR_GRID") {
            file_.axes = axes_;
        } else {
            file_.points = read(points_);
            if (kind_ == "STRUCTURED_GRID") {
                file_.structure = dimensions_;
                if (dimensions_[0] * dimensions_[1] * dimensions_[2] == 0)
                    throw InputError("it has no points");
                if (3 * dimensions_[0] * dimensions_[1] * dimensions_[2] != file_.points.size())
                    throw InputError("it has not as many points as its DIMENSIONS say");
            }
            file_.cells = [lists = cells_] {
                VtkCells cells;
                for (const CellList& list : lists) append_cells(cells, list);
                return cells;
            };
        }
    }

    Scanner in_;
    VtkFile file_;
    std::string kind_;
    std::array<std::size_t, 3> dimensions_{};
    std::array<double, 3> origin_{}, spacing_ = {1, 1, 1};
    std::array<std::vector<double>, 3> axes_;
    Numbers points_;
    std::vector<CellList> cells_;
    bool in_data_ = false, of_cells_ = false;
    std::size_t count_ = 0; ///< of points or cells with data
};

} // namespace

FieldData parse_legacy_vtk_field(std::string_view bytes, const FieldRequest& request) {
    return vtk_field(LegacyReader(bytes, request).read_file(), request);
}

} // namespace gaspard
