// MSH read back by a few lines of our own, section by section; Gmsh's numbering of nodes is written out here
// as its manual draws it. That Gmsh, meshio and FEniCS read the files too is tried by hand (docs/formats.md).
#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/io/formats.hpp"
#include "core/spline/tensor_domain.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/comma_locale.hpp"
#include "support/middle_nodes.hpp"
#include "support/sample_snapshot.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace gaspard {
namespace {

struct Element {
    int type = 0;
    std::size_t physical = 0, geometrical = 0;
    std::vector<std::size_t> nodes; ///< from 0
};

struct Data {
    int components = 0;
    std::vector<double> values;
};

struct ReadMsh {
    std::vector<std::string> sections;
    std::map<std::pair<int, std::string>, std::size_t>
        names; ///< physical groups: dimension and name to number
    Points nodes;
    std::vector<Element> elements;
    std::map<std::string, Data> data;
    std::string periodic;

    explicit ReadMsh(const std::filesystem::path& file) {
        std::istringstream in(read_file(file));
        for (std::string head; std::getline(in, head);) {
            EXPECT_EQ(head.substr(0, 1), "$");
            sections.push_back(head.substr(1));
            std::string body, line;
            while (std::getline(in, line) && line != "$End" + head.substr(1)) body += line + '\n';
            EXPECT_EQ(line, "$End" + head.substr(1));
            std::istringstream content(body);
            read(head.substr(1), content);
            if (head == "$Periodic") periodic = body;
        }
    }

    std::vector<Element> of_group(int dimension, const std::string& name) const {
        std::vector<Element> found;
        for (const Element& e : elements)
            if (e.physical == names.at({dimension, name})) found.push_back(e);
        return found;
    }

  private:
    static double real(std::istream& in) {
        std::string word;
        in >> word;
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        EXPECT_TRUE(!word.empty() && *end == '\0') << word;
        return value;
    }
    static std::string quoted(std::istream& in) {
        std::string text;
        std::getline(in >> std::ws, text);
        EXPECT_EQ(text.front(), '"');
        EXPECT_EQ(text.back(), '"');
        return text.substr(1, text.size() - 2);
    }

    void read(const std::string& section, std::istream& in) {
        std::size_t count = 0, number = 0;
        if (section == "MeshFormat") {
            std::string line;
            std::getline(in, line);
            EXPECT_EQ(line, "2.2 0 8");
        } else if (section == "PhysicalNames") {
            in >> count;
            for (int dimension = 0; count-- > 0;) {
                in >> dimension >> number;
                names[{dimension, quoted(in)}] = number;
            }
        } else if (section == "Nodes") {
            in >> count;
            nodes = Points(count);
            for (std::size_t i = 0; i < count; ++i) {
                in >> number;
                EXPECT_EQ(number, i + 1);
                const double x = real(in), y = real(in), z = real(in);
                nodes.set(i, {x, y, z});
            }
        } else if (section == "Elements") {
            read_elements(in);
        } else if (section == "NodeData") {
            read_data(in);
        }
    }

    void read_elements(std::istream& in) {
        std::size_t count = 0;
        in >> count;
        std::string line;
        std::getline(in, line);
        while (std::getline(in, line)) {
            std::istringstream words(line);
            Element element;
            std::size_t number = 0, tags = 0;
            words >> number >> element.type >> tags >> element.physical >> element.geometrical;
            EXPECT_EQ(number, elements.size() + 1);
            EXPECT_EQ(tags, 2u);
            for (std::size_t node; words >> node;) element.nodes.push_back(node - 1);
            elements.push_back(element);
        }
        EXPECT_EQ(elements.size(), count);
    }

    void read_data(std::istream& in) {
        std::size_t strings = 0, reals = 0, integers = 0, step = 0, rows = 0, number = 0;
        in >> strings;
        EXPECT_EQ(strings, 1u);
        Data& section = data[quoted(in)];
        in >> reals;
        EXPECT_EQ(reals, 1u);
        EXPECT_EQ(real(in), 0);
        in >> integers >> step >> section.components >> rows;
        EXPECT_EQ(integers, 3u);
        EXPECT_EQ(rows, nodes.size());
        for (std::size_t i = 0; i < rows; ++i) {
            in >> number;
            EXPECT_EQ(number, i + 1);
            for (int k = 0; k < section.components; ++k) section.values.push_back(real(in));
        }
    }
};

/// What a node lies in the middle of, as Gmsh numbers the cells' nodes: itself, or an edge's or face's
/// corners.
std::vector<std::vector<int>> gmsh_nodes(CellKind kind) {
    static const std::map<CellShape, std::vector<std::vector<int>>> corners_and_more = {
        {CellShape::line, {{0}, {1}, {0, 1}}},
        {CellShape::triangle, {{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}}},
        {CellShape::quadrilateral, {{0}, {1}, {2}, {3}, {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}}},
        // Hexahedron27: edges in the order of their lower, then their higher corner; faces by their plane.
        {CellShape::hexahedron, {{0},          {1},          {2},
                                 {3},          {4},          {5},
                                 {6},          {7},          {0, 1},
                                 {0, 3},       {0, 4},       {1, 2},
                                 {1, 5},       {2, 3},       {2, 6},
                                 {3, 7},       {4, 5},       {4, 7},
                                 {5, 6},       {6, 7},       {0, 1, 2, 3},
                                 {0, 1, 4, 5}, {0, 3, 4, 7}, {1, 2, 5, 6},
                                 {2, 3, 6, 7}, {4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}}}};
    auto nodes = corners_and_more.at(kind.shape);
    nodes.resize(static_cast<std::size_t>(nodes_per_cell(kind)));
    return nodes;
}

class MshTest : public testing::TestWithParam<std::size_t> {
  protected:
    MshTest() { write_msh(file_, snapshot_, {}); }
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "adapted.msh";
    Snapshot snapshot_ = sample_snapshot(meshes_of_every_kind()[GetParam()]);
};
INSTANTIATE_TEST_SUITE_P(Kinds, MshTest, testing::Range<std::size_t>(0, 8),
                         [](const auto& mesh) { return kind_name(meshes_of_every_kind()[mesh.param].kind); });

TEST_P(MshTest, HoldsNodesAndFieldsToTheLastBit) {
    ReadMsh msh(file_);
    EXPECT_EQ(msh.sections, (std::vector<std::string>{"MeshFormat", "PhysicalNames", "Nodes", "Elements",
                                                      "NodeData", "NodeData", "NodeData"}));
    EXPECT_EQ(msh.nodes, snapshot_.x);
    EXPECT_EQ(msh.data["monitor"].components, 1);
    EXPECT_EQ(msh.data["monitor"].values, snapshot_.field("monitor")->values);
    const Points d = snapshot_.x - snapshot_.mesh->nodes;
    for (const auto& [name, points] :
         {std::pair("xi", &snapshot_.mesh->nodes), std::pair("displacement", &d)}) {
        const Data& data = msh.data[name];
        ASSERT_EQ(data.components, 3);
        ASSERT_EQ(data.values.size(), 3 * points->size());
        for (std::size_t i = 0; i < points->size(); ++i)
            EXPECT_EQ((Vec3{data.values[3 * i], data.values[3 * i + 1], data.values[3 * i + 2]}),
                      (*points)[i]);
    }
}

TEST_P(MshTest, CellsHaveGmshsTypeAndNumbering) {
    const std::map<std::string, int> types = {
        {"line1", 1},          {"line2", 8},           {"triangle1", 2},   {"triangle2", 9},
        {"quadrilateral1", 3}, {"quadrilateral2", 10}, {"hexahedron1", 5}, {"hexahedron2", 12}};
    const Mesh& mesh = *snapshot_.mesh;
    const ReadMsh msh(file_);
    const auto cells = msh.of_group(cell_dimension(mesh.kind), "domain");
    ASSERT_EQ(cells.size(), mesh.cell_count());
    const auto expected = gmsh_nodes(mesh.kind);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        EXPECT_EQ(cells[c].type, types.at(kind_name(mesh.kind)));
        ASSERT_EQ(cells[c].nodes.size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            Vec3 mean; // of the computational mesh, whose cells are straight
            for (const int corner : expected[k])
                mean = mean + 1.0 / static_cast<double>(expected[k].size()) *
                                  mesh.nodes[cells[c].nodes[static_cast<std::size_t>(corner)]];
            EXPECT_LT(norm(mesh.nodes[cells[c].nodes[k]] - mean), 1e-15) << "cell " << c << " node " << k;
        }
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners_per_cell(mesh.kind)); ++k)
            EXPECT_EQ(cells[c].nodes[k], static_cast<std::size_t>(mesh.cell(c)[k]));
    }
}

TEST_P(MshTest, EveryFacetOfTheBorderIsInOneGroup) {
    const Mesh& mesh = *snapshot_.mesh;
    const ReadMsh msh(file_);
    const std::size_t facets = msh.elements.size() - mesh.cell_count();
    EXPECT_EQ(facets, (std::vector<std::size_t>{0, 2, mesh.kind.shape == CellShape::triangle ? 4u : 8u,
                                                10})[static_cast<std::size_t>(cell_dimension(mesh.kind))]);
    const std::vector<std::set<std::string>> sides = {{},
                                                      {"left", "right"},
                                                      {"left", "right", "bottom", "top"},
                                                      {"left", "right", "front", "back", "bottom", "top"}};
    const int dimension = cell_dimension(mesh.kind);
    std::set<std::string> found;
    for (const auto& [name, number] : msh.names)
        if (name.first == dimension - 1) found.insert(name.second);
    EXPECT_EQ(found, sides[static_cast<std::size_t>(dimension)]);
}

TEST(Msh, TheSidesOfASquareAreWhereTheirNamesSay) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(4));
    write_msh(folder / "m.msh", snapshot, {});
    const ReadMsh msh(folder / "m.msh");
    const Points& xi = snapshot.mesh->nodes;
    const std::map<std::string, std::pair<std::vector<double> Points::*, double>> sides = {
        {"left", {&Points::x, 0}},
        {"right", {&Points::x, 1}},
        {"bottom", {&Points::y, 0}},
        {"top", {&Points::y, 1}}};
    for (const auto& [name, side] : sides) {
        const auto edges = msh.of_group(1, name);
        EXPECT_EQ(edges.size(), 4u) << name;
        for (const Element& edge : edges) {
            ASSERT_EQ(edge.nodes.size(), 2u);
            EXPECT_EQ(edge.geometrical, edge.physical);
            for (const auto node : edge.nodes) EXPECT_EQ((xi.*side.first)[node], side.second) << name;
            // The square lies to the left.
            const Vec3 along = xi[edge.nodes[1]] - xi[edge.nodes[0]],
                       inward = Vec3{.5, .5, 0} - xi[edge.nodes[0]];
            EXPECT_GT(cross(along, inward).z, 0) << name;
        }
    }
}

TEST(Msh, CellsOfASphereHaveAllTheirMiddleNodes) {
    const TemporaryFolder folder;
    for (const Mesh& mesh : {cubed_sphere_mesh(3), round_octahedron()}) {
        Snapshot snapshot = sample_snapshot(mesh);
        snapshot.x = mesh.nodes;
        write_msh(folder / "m.msh", snapshot, {});
        const ReadMsh msh(folder / "m.msh");
        EXPECT_EQ(msh.nodes, mesh.nodes);
        const bool triangles = mesh.kind.shape == CellShape::triangle;
        EXPECT_EQ(msh.elements.size(), mesh.cell_count()) << "there is no border";
        for (const Element& element : msh.elements) {
            EXPECT_EQ(element.type, triangles ? 9 : 10); // second order triangle, quadrangle with 9 nodes
            expect_middle_nodes(msh.nodes, element.nodes, triangles ? 3 : 4);
        }
    }
}

// Gmsh's manual draws a quadrilateral's nodes in rings, "quadrangle16" for example
//
//   3---9---8---2
//   |           |
//  10  15  14   7
//   |           |
//  11  12  13   6
//   |           |
//   0---4---5---1
TEST(Msh, PatchesAreCellsOfTheirDegreeInGmshsRings) {
    const TemporaryFolder folder;
    const std::vector<std::pair<int, int>> third = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 0}, {2, 0},
                                                    {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1},
                                                    {1, 1}, {2, 1}, {2, 2}, {1, 2}};
    const std::map<int, std::pair<int, int>> types = {
        {3, {36, 26}}, {4, {37, 27}}, {5, {38, 28}}, {6, {47, 62}}, {7, {48, 63}}};
    for (const auto& [degree, type] : types) {
        Snapshot snapshot = sample_snapshot(*SplineDomain(degree, 2, square_map()).mesh());
        snapshot.x = snapshot.mesh->nodes;
        write_msh(folder / "m.msh", snapshot, {});
        const ReadMsh msh(folder / "m.msh");
        ASSERT_EQ(msh.elements.size(), 4u + 8u) << "cells, and the border's edges";
        const auto at = [&](std::size_t node) { return 2.0 * degree * msh.nodes[node]; };
        for (std::size_t e = 0; e < 4; ++e) {
            const Element& cell = msh.elements[e];
            EXPECT_EQ(cell.type, type.first);
            ASSERT_EQ(cell.nodes.size(), static_cast<std::size_t>((degree + 1) * (degree + 1)));
            for (std::size_t k = 0; degree == 3 && k < third.size(); ++k)
                EXPECT_LT(
                    norm(at(cell.nodes[k]) - at(cell.nodes[0]) -
                         Vec3{static_cast<double>(third[k].first), static_cast<double>(third[k].second), 0}),
                    1e-12);
            // Each ring goes around what is left: all nodes once, and the last one or four in the middle.
            EXPECT_EQ(std::set(cell.nodes.begin(), cell.nodes.end()).size(), cell.nodes.size());
            const double half = degree / 2.0;
            EXPECT_LT(norm(at(cell.nodes.back()) - at(cell.nodes[0]) - Vec3{half, half, 0}), 0.71);
            for (std::size_t k = 4; k + 1 < 4 * static_cast<std::size_t>(degree); ++k) // around the cell
                if ((k - 4) % static_cast<std::size_t>(degree - 1) != static_cast<std::size_t>(degree - 2)) {
                    EXPECT_NEAR(norm(at(cell.nodes[k + 1]) - at(cell.nodes[k])), 1, 1e-12);
                }
        }
        for (std::size_t e = 4; e < 12; ++e) {
            EXPECT_EQ(msh.elements[e].type, type.second);
            const auto& edge = msh.elements[e].nodes; // ends first, then from the first end on
            ASSERT_EQ(edge.size(), static_cast<std::size_t>(degree + 1));
            const Vec3 step = (1.0 / degree) * (at(edge[1]) - at(edge[0]));
            for (std::size_t k = 2; k < edge.size(); ++k)
                EXPECT_LT(norm(at(edge[k]) - at(edge[0]) - (static_cast<double>(k) - 1) * step), 1e-12);
        }
    }
}

// The order in which Gmsh itself writes the nodes of one cell (gmsh -3 -order 3 and 4), in units of 1 /
// order.
TEST(Msh, SolidsAreCellsInGmshsOrder) {
    const TemporaryFolder folder;
    const std::map<int, std::pair<int, std::string>> written = {
        {3,
         {92, "000 300 330 030 003 303 333 033 100 200 010 020 001 002 310 320 301 302 230 130 "
              "331 332 031 032 103 203 013 023 313 323 233 133 110 120 220 210 101 201 202 102 "
              "011 012 022 021 311 321 322 312 231 131 132 232 113 213 223 123 111 211 221 121 "
              "112 212 222 122 "}},
        {4,
         {93, "000 400 440 040 004 404 444 044 100 200 300 010 020 030 001 002 003 410 420 430 "
              "401 402 403 340 240 140 441 442 443 041 042 043 104 204 304 014 024 034 414 424 "
              "434 344 244 144 110 130 330 310 120 230 320 210 220 101 301 303 103 201 302 203 "
              "102 202 011 013 033 031 012 023 032 021 022 411 431 433 413 421 432 423 412 422 "
              "341 141 143 343 241 142 243 342 242 114 314 334 134 214 324 234 124 224 111 311 "
              "331 131 113 313 333 133 211 121 112 321 312 231 332 132 213 123 323 233 221 212 "
              "122 322 232 223 222 "}}};
    for (const auto& [degree, cell] : written) {
        Snapshot snapshot = sample_snapshot(*SolidDomain(degree, 1, cube_map()).mesh());
        snapshot.x = snapshot.mesh->nodes;
        write_msh(folder / "m.msh", snapshot, {});
        const ReadMsh msh(folder / "m.msh");
        ASSERT_EQ(msh.elements.size(), 1U + 6U) << "the cell, and the faces of its boundary";
        EXPECT_EQ(msh.elements[0].type, cell.first);
        std::string order;
        for (const std::size_t node : msh.elements[0].nodes)
            for (const double c : {msh.nodes[node].x, msh.nodes[node].y, msh.nodes[node].z})
                order += std::to_string(std::lround(degree * c));
        std::string expected = cell.second;
        std::erase(expected, ' ');
        EXPECT_EQ(order, expected);
        for (std::size_t f = 1; f < 7; ++f) { // corners around the face, then those of its edges in turn
            const auto& face = msh.elements[f].nodes;
            ASSERT_EQ(face.size(), static_cast<std::size_t>((degree + 1) * (degree + 1)));
            for (std::size_t e = 0; e < 4; ++e) {
                const Vec3 a = msh.nodes[face[e]], b = msh.nodes[face[(e + 1) % 4]];
                const auto m = static_cast<std::size_t>(degree - 1);
                for (std::size_t k = 0; k < m; ++k)
                    EXPECT_LT(norm(msh.nodes[face[4 + e * m + k]] - a -
                                   (static_cast<double>(k) + 1) / degree * (b - a)),
                              1e-12);
            }
        }
    }
}

TEST(Msh, FacesOfSolidsPointOutward) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(of_order_two(two_cubes()));
    write_msh(folder / "m.msh", snapshot, {});
    const ReadMsh msh(folder / "m.msh");
    const Points& xi = snapshot.mesh->nodes;
    std::size_t faces = 0;
    for (const Element& e : msh.elements) {
        if (e.type != 10) continue;
        ++faces;
        ASSERT_EQ(e.nodes.size(), 9u);
        const auto p = [&](std::size_t i) { return xi[e.nodes[i]]; };
        EXPECT_GT(dot(cross(p(1) - p(0), p(3) - p(0)), p(8) - Vec3{1, .5, .5}), 0);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(p(4 + i), 0.5 * (p(i) + p((i + 1) % 4)));
        EXPECT_EQ(p(8), 0.25 * (p(0) + p(1) + p(2) + p(3)));
    }
    EXPECT_EQ(faces, 10u);
}

TEST(Msh, ABorderThatIsNoBoxIsOneGroup) {
    const TemporaryFolder folder;
    // A kite: its sides lie on no side of the box around it.
    const Mesh kite = mesh_of({CellShape::quadrilateral, 1}, 2,
                              {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {0, 1, 2, 3});
    write_msh(folder / "m.msh", sample_snapshot(kite), {});
    EXPECT_EQ(ReadMsh(folder / "m.msh").of_group(1, "boundary").size(), 4u);
    // A patch in space has a border, but neither left nor right.
    write_msh(folder / "m.msh", sample_snapshot(curved_square()), {});
    EXPECT_EQ(ReadMsh(folder / "m.msh").of_group(1, "boundary").size(), 4u);
}

TEST(Msh, TheSidesOfAPeriodicSquareArePaired) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(3));
    write_msh(folder / "m.msh", snapshot, {SpaceKind::periodic_square});
    const ReadMsh msh(folder / "m.msh");
    ASSERT_NE(msh.periodic, "");
    std::istringstream in(msh.periodic);
    std::size_t sides = 0, dimension = 0, copy = 0, original = 0, pairs = 0;
    in >> sides;
    ASSERT_EQ(sides, 2u);
    for (const Vec3 shift : {Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
        in >> dimension >> copy >> original;
        EXPECT_EQ(dimension, 1u);
        const bool across = shift.x == 1;
        EXPECT_EQ(copy, msh.names.at({1, across ? "right" : "top"}));
        EXPECT_EQ(original, msh.names.at({1, across ? "left" : "bottom"}));
        std::string affine;
        std::getline(in >> std::ws, affine);
        EXPECT_EQ(affine, across ? "Affine 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1"
                                 : "Affine 1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1");
        in >> pairs;
        EXPECT_EQ(pairs, 4u);
        for (std::size_t from, to; pairs-- > 0;) {
            in >> from >> to;
            EXPECT_EQ(snapshot.mesh->nodes[from - 1], snapshot.mesh->nodes[to - 1] + shift);
        }
    }
    EXPECT_TRUE((in >> std::ws).eof());
}

TEST(Msh, DoesNotKnowTheLocale) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(40));
    write_msh(folder / "plain.msh", snapshot, {});
    {
        const CommaLocale comma;
        write_msh(folder / "comma.msh", snapshot, {});
    }
    EXPECT_EQ(read_file(folder / "plain.msh"), read_file(folder / "comma.msh"));
}

TEST(Msh, WhatIsNotFiniteIsAFaultAndNothingIsWritten) {
    const TemporaryFolder folder;
    Snapshot position = sample_snapshot(two_triangles()), field = position;
    position.x.x[0] = std::numeric_limits<double>::infinity();
    field.fields[0].values[1] = std::numeric_limits<double>::quiet_NaN();
    for (const Snapshot& snapshot : {position, field})
        EXPECT_THROW(write_msh(folder / "m.msh", snapshot, {}), InternalError);
    EXPECT_TRUE(folder.content().empty());
}

} // namespace
} // namespace gaspard
