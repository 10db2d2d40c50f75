// adapted.csv: one line per node with its number, its coordinates on both meshes and all fields of nodes.
#include "core/base/check.hpp"
#include "core/base/csv.hpp"
#include "core/base/parameter.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/formats.hpp"

#include <array>
#include <cmath>

namespace gaspard {

namespace {

struct Column {
    std::string name;
    const std::vector<double>* values;
};

std::vector<Column> columns_of(const Snapshot& snapshot) {
    const Points &xi = snapshot.mesh->nodes, &x = snapshot.x;
    const auto dimension = static_cast<std::size_t>(snapshot.mesh->space_dimension);
    const std::array<Column, 3> before{{{"xi_1", &xi.x}, {"xi_2", &xi.y}, {"xi_3", &xi.z}}},
        after{{{"x", &x.x}, {"y", &x.y}, {"z", &x.z}}};
    std::vector<Column> columns(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(dimension));
    columns.insert(columns.end(), after.begin(), after.begin() + static_cast<std::ptrdiff_t>(dimension));
    for (const Field& field : snapshot.fields)
        if (field.place == FieldPlace::node) columns.push_back({field.name, &field.values});
    return columns;
}

} // namespace

void write_csv(const std::filesystem::path& file, const Snapshot& snapshot) {
    const std::vector<Column> columns = columns_of(snapshot);
    std::string text = "node";
    for (const Column& column : columns) {
        GASPARD_CHECK(column.values->size() == snapshot.mesh->node_count());
        text += ',' + csv_text(column.name);
    }
    text += '\n';
    for (std::size_t i = 0; i < snapshot.mesh->node_count(); ++i) {
        text += std::to_string(i);
        for (const Column& column : columns) {
            const double value = (*column.values)[i];
            GASPARD_CHECK(std::isfinite(value));
            text += ',' + format_number(value);
        }
        text += '\n';
    }
    write_atomically(file, text);
}

} // namespace gaspard
