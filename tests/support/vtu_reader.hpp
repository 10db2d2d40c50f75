// A VTU file read by tinyxml2, its arrays by a few lines of our own, to the last bit.
#pragma once

#include "core/base/points.hpp"
#include "support/little_endian.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <tinyxml2.h>
#include <vector>

namespace gaspard {

inline std::string from_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    EXPECT_EQ(text.size() % 4, 0u);
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    for (const char c : text) {
        const std::uint32_t digit = c >= 'A' && c <= 'Z'   ? static_cast<std::uint32_t>(c - 'A')
                                    : c >= 'a' && c <= 'z' ? static_cast<std::uint32_t>(c - 'a' + 26)
                                    : c >= '0' && c <= '9' ? static_cast<std::uint32_t>(c - '0' + 52)
                                    : c == '+'             ? 62u
                                                           : 63u;
        if (digit == 63) {
            EXPECT_EQ(c, '/');
        }
        group = group << 6 | digit;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 255u);
    }
    return bytes;
}

struct VtuArray {
    std::string type;
    int components = 0;
    std::string bytes; ///< without their length

    std::vector<double> reals() const {
        EXPECT_EQ(type, "Float64");
        std::vector<double> values;
        for (LittleEndian in(bytes); !in.rest().empty();) values.push_back(in.real());
        return values;
    }
    std::vector<std::int32_t> integers() const {
        EXPECT_EQ(type, "Int32");
        std::vector<std::int32_t> values;
        for (LittleEndian in(bytes); !in.rest().empty();) values.push_back(in.int32());
        return values;
    }
    Points points() const {
        EXPECT_EQ(components, 3);
        const auto values = reals();
        Points points(values.size() / 3);
        for (std::size_t i = 0; i < points.size(); ++i)
            points.set(i, {values[3 * i], values[3 * i + 1], values[3 * i + 2]});
        return points;
    }
};

using VtuArrays = std::map<std::string, VtuArray>;

inline VtuArrays vtu_arrays_of(const tinyxml2::XMLElement* section) {
    VtuArrays arrays;
    for (auto* e = section->FirstChildElement(); e; e = e->NextSiblingElement()) {
        EXPECT_STREQ(e->Name(), "DataArray");
        EXPECT_STREQ(e->Attribute("format"), "binary");
        const std::string block = from_base64(e->GetText());
        LittleEndian in(block);
        const auto length = in.unsigned_number<std::uint64_t>();
        EXPECT_EQ(length, in.rest().size());
        arrays[e->Attribute("Name")] = {e->Attribute("type"), e->IntAttribute("NumberOfComponents"),
                                        std::string(in.rest())};
    }
    return arrays;
}

struct ReadVtu {
    tinyxml2::XMLDocument document;
    VtuArrays points, cells, point_data, cell_data, field_data;
    int point_count = 0, cell_count = 0;

    explicit ReadVtu(const std::filesystem::path& file) {
        if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS)
            throw std::runtime_error(document.ErrorStr());
        const auto* root = document.RootElement();
        EXPECT_STREQ(root->Name(), "VTKFile");
        EXPECT_STREQ(root->Attribute("type"), "UnstructuredGrid");
        EXPECT_STREQ(root->Attribute("byte_order"), "LittleEndian");
        EXPECT_STREQ(root->Attribute("header_type"), "UInt64");
        const auto* grid = root->FirstChildElement("UnstructuredGrid");
        const auto* piece = grid->FirstChildElement("Piece");
        point_count = piece->IntAttribute("NumberOfPoints");
        cell_count = piece->IntAttribute("NumberOfCells");
        field_data = vtu_arrays_of(grid->FirstChildElement("FieldData"));
        point_data = vtu_arrays_of(piece->FirstChildElement("PointData"));
        cell_data = vtu_arrays_of(piece->FirstChildElement("CellData"));
        points = vtu_arrays_of(piece->FirstChildElement("Points"));
        cells = vtu_arrays_of(piece->FirstChildElement("Cells"));
    }
};

} // namespace gaspard
