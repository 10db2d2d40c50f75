// adapted.csv read back by splitting at commas.
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "support/comma_locale.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace gaspard {
namespace {

struct ReadTable {
    std::string head;
    std::vector<std::vector<double>> rows;

    explicit ReadTable(const std::filesystem::path& file) {
        std::istringstream lines(read_file(file));
        std::getline(lines, head);
        for (std::string line; std::getline(lines, line);) {
            rows.emplace_back();
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) {
                char* end = nullptr;
                rows.back().push_back(std::strtod(cell.c_str(), &end));
                EXPECT_EQ(*end, '\0') << cell;
            }
        }
    }
};

class NodeCsv : public testing::Test {
  protected:
    ReadTable written(const Snapshot& snapshot) {
        write_csv(folder_ / "adapted.csv", snapshot);
        return ReadTable(folder_ / "adapted.csv");
    }
    TemporaryFolder folder_;
};

TEST_F(NodeCsv, HasOneLinePerNodeToTheLastBit) {
    Snapshot snapshot = sample_snapshot(two_triangles());
    Field solution{{.name = "solution"}, {1.0 / 3, -5e-324, 1e300, -0.1}};
    snapshot.fields.push_back(solution);
    const ReadTable table = written(snapshot);
    EXPECT_EQ(table.head, "node,xi_1,xi_2,x,y,monitor,solution") << "fields of cells are left out";
    ASSERT_EQ(table.rows.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 xi = snapshot.mesh->nodes[i], x = snapshot.x[i];
        EXPECT_EQ(table.rows[i], (std::vector<double>{static_cast<double>(i), xi.x, xi.y, x.x, x.y,
                                                      snapshot.fields[0].values[i], solution.values[i]}));
    }
}

TEST_F(NodeCsv, HasAsManyCoordinatesAsTheSpace) {
    EXPECT_EQ(written(sample_snapshot(three_lines())).head, "node,xi_1,x,monitor");
    const Snapshot surface = sample_snapshot(curved_square());
    const ReadTable table = written(surface);
    EXPECT_EQ(table.head, "node,xi_1,xi_2,xi_3,x,y,z,monitor");
    ASSERT_EQ(table.rows.size(), surface.x.size()) << "all nodes, not corners alone";
    EXPECT_EQ(table.rows.back()[6], surface.x.z.back());
}

TEST_F(NodeCsv, RefusesAValueThatIsNotFinite) {
    Snapshot snapshot = sample_snapshot(three_lines());
    snapshot.fields[0].values[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(write_csv(folder_ / "adapted.csv", snapshot), InternalError);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "adapted.csv"));
}

TEST_F(NodeCsv, HasPointsInEveryLocale) {
    const CommaLocale comma;
    write_csv(folder_ / "adapted.csv", sample_snapshot(three_lines()));
    EXPECT_NE(read_file(folder_ / "adapted.csv").find("\n2,0.25,"), std::string::npos);
}

} // namespace
} // namespace gaspard
