#include "core/data/field_file.hpp"
#include "core/io/netcdf_file.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(NetcdfBytes, KeepTheTypeOfTheirNumbers) {
    const auto written = [](auto values) {
        NetcdfFile file{{{"y", 2}, {"x", 2}}};
        for (const char* axis : {"x", "y"}) file.variables.push_back({axis, {axis}, std::vector{0.0, 0.5}});
        file.variables.push_back({"v", {"y", "x"}, std::move(values)});
        return netcdf_bytes(file);
    };
    const auto values = [](const std::string& bytes) {
        return std::get<GridData>(parse_netcdf_field(bytes, {}).data).values;
    };
    const std::string doubles = written(std::vector<double>{0.1, 2, 3, 4});
    const std::string floats = written(std::vector<float>{0.1f, 2, 3, 4});
    EXPECT_EQ(values(doubles), (std::vector<double>{0.1, 2, 3, 4}));
    EXPECT_EQ(values(floats), (std::vector<double>{static_cast<double>(0.1f), 2, 3, 4}));
    EXPECT_EQ(doubles.size(), floats.size() + 16);
}

} // namespace
} // namespace gaspard
