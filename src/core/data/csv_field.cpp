// Numbers in text, separated by ',', ';', tabs or blanks. Own code, since the separator has to be guessed and
// messages name the line, which CSV libraries do not help with.
//
//   x,y,value       columns with coordinates, named x, y, z, lon, lat and the like; or three without
//   0.1,0.2,3       names, in space four
//
//   1,2,3           a matrix: its first row is the top
//   4,5,6
//
//   ,0,0.5,1        a matrix with its axes: x in the first row, y in the first column
//   0,1,2,3
#include "core/base/error.hpp"
#include "core/base/letters.hpp"
#include "core/base/number_text.hpp"
#include "core/data/field_file.hpp"
#include "core/data/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_columns = std::size_t{1} << 16;

std::string_view trim(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

bool is_missing(std::string_view cell) {
    static constexpr std::array<std::string_view, 9> words = {"nan", "na",       "n/a", "null", "none",
                                                              "inf", "infinity", "-",   "--"};
    constexpr std::size_t longest = 10;
    if (cell.empty()) return true;
    if (cell.size() > longest) return false;
    const std::string word =
        lower_case(cell.size() > 2 && (cell[0] == '-' || cell[0] == '+') ? cell.substr(1) : cell);
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// How the cells of a line are separated.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blank = ' ' };

Separator separator_of(std::string_view line) {
    for (const Separator one : {Separator::semicolon, Separator::tab, Separator::comma})
        if (line.find(static_cast<char>(one)) != std::string_view::npos) return one;
    return Separator::blank;
}

/// The end of the cell at the beginning of `line`: the position of its separator or the end. Quoted
/// separators do not count.
std::size_t cell_end(std::string_view line, char separator) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (!quoted && (line[i] == separator || (separator == ' ' && line[i] == '\t'))) return i;
    }
    return line.size();
}

std::string_view without_quotes(std::string_view cell) {
    return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"' ? cell.substr(1, cell.size() - 2)
                                                                         : cell;
}

template <class Visit>
void each_cell(std::string_view line, Separator separator, const Visit& visit) {
    line = separator == Separator::tab ? line : trim(line);
    while (true) {
        const std::size_t end = cell_end(line, static_cast<char>(separator));
        visit(without_quotes(trim(line.substr(0, end))));
        if (end == line.size()) return;
        line.remove_prefix(end + 1);
        if (separator == Separator::blank) line = trim(line);
    }
}

std::vector<std::string_view> cells_of(std::string_view line, Separator separator) {
    std::vector<std::string_view> cells;
    each_cell(line, separator, [&](std::string_view cell) {
        if (cells.size() == most_columns)
            throw InputError("its first line has more than " + std::to_string(most_columns) + " columns");
        cells.push_back(cell);
    });
    return cells;
}

/// The file as a table of numbers.
struct Table {
    std::vector<std::string> names; ///< of the columns; empty if there are none
    std::size_t columns = 0;
    std::vector<double> numbers; ///< row by row; NaN where a cell is missing
    std::vector<bool> text;      ///< with names: columns whose first cell is a text, which are not read
    bool corner = false; ///< the first row has coordinates: its first cell is not a number, all others are
};

class TableReader {
  public:
    TableReader(std::string_view text, const FieldRequest& request)
        : request_(request), size_(text.size()), rest_(text) {
        if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    }

    Table read() {
        if (!next()) throw InputError("it has no numbers");
        separator_ = separator_of(line_);
        const std::string comment = comment_;
        begin(cells_of(line_, separator_), comment);
        while (next()) add_row();
        if (table_.numbers.empty()) throw InputError("it has a line of names, but no numbers");
        return std::move(table_);
    }

  private:
    /// Goes to the next line that is neither empty nor a comment; false at the end.
    bool next() {
        while (!rest_.empty()) {
            line_ = take_line(rest_);
            if (++number_ % 1024 == 0)
                check_stop(request_, 1 - static_cast<double>(rest_.size()) / static_cast<double>(size_));
            const std::string_view text = trim(line_);
            if (text.starts_with('#')) comment_ = trim(text.substr(1));
            if (!text.empty() && !text.starts_with('#')) return true;
        }
        return false;
    }

    void begin(const std::vector<std::string_view>& cells, const std::string& comment) {
        table_.columns = cells.size();
        const auto is_name = [](std::string_view cell) { return !is_missing(cell) && !parse_number(cell); };
        const auto names = std::count_if(cells.begin(), cells.end(), is_name);
        const bool number_first = parse_number(cells[0]).has_value();
        table_.corner = !number_first && cells.size() > 2 &&
                        std::all_of(cells.begin() + 1, cells.end(),
                                    [](auto cell) { return parse_number(cell).has_value(); });
        if (names > 0 && !table_.corner) {
            if (std::any_of(cells.begin(), cells.end(),
                            [](auto cell) { return parse_number(cell).has_value(); }))
                fail(*std::find_if(cells.begin(), cells.end(), is_name));
            table_.names.assign(cells.begin(), cells.end());
            table_.text.resize(cells.size());
            return;
        }
        const auto described = cells_of(comment, separator_of(comment));
        if (described.size() == cells.size() && std::all_of(described.begin(), described.end(), is_name))
            table_.names.assign(described.begin(), described.end());
        if (table_.corner) {
            table_.numbers.push_back(nothing);
            for (std::size_t i = 1; i < cells.size(); ++i) table_.numbers.push_back(*parse_number(cells[i]));
        } else {
            add_row();
        }
    }

    void add_row() {
        const std::size_t before = table_.numbers.size();
        each_cell(line_, separator_, [&](std::string_view cell) {
            if (table_.numbers.size() == largest_field)
                throw InputError("it has more than " + std::to_string(largest_field) + " numbers");
            const auto number = parse_number(cell);
            if (!number && !is_missing(cell) && !is_text(table_.numbers.size() - before, cell)) fail(cell);
            table_.numbers.push_back(number.value_or(nothing));
        });
        first_row_ = false;
        const std::size_t cells = table_.numbers.size() - before;
        if (cells != table_.columns)
            throw InputError("line " + std::to_string(number_) + " has " + std::to_string(cells) +
                             " columns, the first has " + std::to_string(table_.columns));
    }

    /// Whether a cell that is not a number belongs to a column of texts, such as names of stations.
    bool is_text(std::size_t column, std::string_view cell) {
        if (column >= table_.text.size()) return false;
        if (first_row_ && cell.find(',') == std::string_view::npos) table_.text[column] = true;
        return table_.text[column];
    }

    [[noreturn]] void fail(std::string_view cell) const {
        const bool comma = cell.find(',') != std::string_view::npos;
        throw InputError("line " + std::to_string(number_) + ": '" + std::string(cell.substr(0, 40)) +
                         "' is not a number" + (comma ? " (write decimal points, not commas)" : ""));
    }

    const FieldRequest& request_;
    std::size_t size_;
    std::string_view rest_, line_;
    std::string comment_; ///< the last one
    std::size_t number_ = 0;
    bool first_row_ = true;
    Separator separator_ = Separator::comma;
    Table table_;
};

/// Names of the columns of a coordinate, in lower case.
struct CoordinateNames {
    std::vector<std::string_view> x, y, z;
    Coordinates coordinates;
};

const std::vector<CoordinateNames>& coordinate_names() {
    static const std::vector<CoordinateNames> all = {{{"lon", "longitude", "long", "lng", "lon_deg"},
                                                      {"lat", "latitude", "lat_deg"},
                                                      {},
                                                      Coordinates::geographic},
                                                     {{"x", "x1", "points:0", "x_coord", "easting"},
                                                      {"y", "x2", "points:1", "y_coord", "northing"},
                                                      {"z", "x3", "points:2", "z_coord"},
                                                      Coordinates::cartesian}};
    return all;
}

struct Columns {
    Coordinates coordinates = Coordinates::none; ///< none: the table is a matrix
    std::size_t x = 0, y = 1;
    std::optional<std::size_t> z{};
    std::vector<std::size_t> values{};
};

std::optional<std::size_t> find_column(const std::vector<std::string>& names,
                                       const std::vector<std::string_view>& wanted) {
    for (const std::string_view one : wanted)
        for (std::size_t i = 0; i < names.size(); ++i)
            if (lower_case(trim(names[i])) == one) return i;
    return std::nullopt;
}

/// `dimension`: of the domain, in whose space four columns without names are points.
Columns columns_of(const Table& table, std::size_t dimension) {
    Columns found;
    if (table.corner) return found;
    for (const CoordinateNames& names : coordinate_names()) {
        const auto x = find_column(table.names, names.x), y = find_column(table.names, names.y);
        if (!x || !y) continue;
        found = {names.coordinates, *x, *y, find_column(table.names, names.z), {}};
        if (table.columns == 3) found.z.reset(); // then z is the value
        break;
    }
    const bool in_space = dimension == 3 && table.columns == 4;
    if (found.coordinates == Coordinates::none && table.names.empty() && in_space)
        found = {Coordinates::cartesian, 0, 1, 2, {}};
    if (found.coordinates == Coordinates::none && table.columns == 3)
        found.coordinates = Coordinates::cartesian;
    for (std::size_t i = 0; i < table.columns; ++i)
        if (i != found.x && i != found.y && i != found.z && !(i < table.text.size() && table.text[i]))
            found.values.push_back(i);
    return found;
}

ScatteredData points_in(const Table& table, const Columns& columns, std::size_t value) {
    ScatteredData data{columns.coordinates, columns.z ? 3 : 2, {}, {}};
    for (std::size_t at = 0; at + table.columns <= table.numbers.size(); at += table.columns) {
        const double x = table.numbers[at + columns.x], y = table.numbers[at + columns.y],
                     z = columns.z ? table.numbers[at + *columns.z] : 0;
        if (std::isnan(x + y + z)) // missing, or a text
            throw InputError("row " + std::to_string(at / table.columns + 1) +
                             " of its numbers has no coordinates");
        data.points.x.push_back(x), data.points.y.push_back(y), data.points.z.push_back(z);
        data.values.push_back(table.numbers[at + value]);
    }
    return data;
}

FieldData read_columns(const Table& table, const Columns& columns, const FieldRequest& request) {
    FieldData field;
    if (columns.values.empty()) throw InputError("it has coordinates, but no column of values");
    for (const std::size_t i : columns.values)
        field.variables.push_back(table.names.empty() || table.names[i].empty()
                                      ? "column " + std::to_string(i + 1)
                                      : table.names[i]);
    const std::size_t chosen = find_variable(request.variable, field.variables);
    field.variable = field.variables[chosen];
    field.data = arranged(points_in(table, columns, columns.values[chosen]), field.notes, request);
    if (table.names.empty())
        field.notes.push_back(columns.z ? "The four columns are read as x, y, z and the value."
                                        : "The three columns are read as x, y and the value.");
    return field;
}

/// Coordinates 0, 1, 2, ...
std::vector<double> counted(std::size_t count) {
    std::vector<double> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<double>(i);
    return all;
}

GridData matrix(const Table& table) {
    const std::size_t nx = table.columns, ny = table.numbers.size() / nx;
    GridData grid{Coordinates::none, {counted(nx), counted(ny), {}}, {}};
    grid.values.reserve(nx * ny);
    for (std::size_t j = ny; j-- > 0;) // the first row is the top
        for (std::size_t i = 0; i < nx; ++i) grid.values.push_back(table.numbers[j * nx + i]);
    return grid;
}

GridData matrix_with_axes(const Table& table) {
    const std::size_t nx = table.columns, ny = table.numbers.size() / nx;
    GridData grid{Coordinates::cartesian, {}, {}};
    grid.axes[0].assign(table.numbers.begin() + 1, table.numbers.begin() + static_cast<std::ptrdiff_t>(nx));
    for (std::size_t j = 1; j < ny; ++j) {
        grid.axes[1].push_back(table.numbers[j * nx]);
        for (std::size_t i = 1; i < nx; ++i) grid.values.push_back(table.numbers[j * nx + i]);
    }
    return with_sorted_axes(std::move(grid));
}

} // namespace

FieldData parse_csv_field(std::string_view text, const FieldRequest& request) {
    find_time(request, 1), find_index(request.level, 1, "level");
    const Table table = TableReader(text, request).read();
    const Columns columns = columns_of(table, request.dimension);
    if (columns.coordinates != Coordinates::none) return read_columns(table, columns, request);
    FieldData field{"matrix", {"matrix"}, table.corner ? matrix_with_axes(table) : matrix(table), {}};
    find_variable(request.variable, field.variables);
    const auto& axes = std::get<GridData>(field.data).axes;
    if (axes[0].size() < 2 || axes[1].size() < 2)
        throw InputError(
            "a matrix must have two rows and two columns, or it must have columns x, y and value");
    return field;
}

} // namespace gaspard
