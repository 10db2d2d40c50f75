// Files of other software (make_files.py), small texts and damaged files.
#include "core/base/error.hpp"
#include "core/base/read_data_file.hpp"
#include "core/data/field_file.hpp"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <stop_token>

namespace gaspard {
namespace {

const std::filesystem::path files = std::filesystem::path(GASPARD_SOURCE_DIR) / "tests/core/data/files";

FieldData read(const std::string& name, const FieldRequest& request = {}) {
    return parse_field(read_data_file(name, files), name, request);
}

FieldData parse(const std::string& text, const FieldRequest& request = {}) {
    return parse_field(text, "it.csv", request);
}

const GridData& grid(const FieldData& field) { return std::get<GridData>(field.data); }
const ScatteredData& scattered(const FieldData& field) { return std::get<ScatteredData>(field.data); }

/// The values of most files.
double f(double x, double y) { return 1 + 2 * x - 3 * y + x * y; }

void expect_f(const FieldData& field, std::size_t count, double tolerance = 1e-12) {
    ASSERT_EQ(values_of(field).size(), count);
    if (const auto* data = std::get_if<GridData>(&field.data)) {
        for (std::size_t j = 0; j < data->axes[1].size(); ++j)
            for (std::size_t i = 0; i < data->axes[0].size(); ++i)
                EXPECT_NEAR(data->values[j * data->axes[0].size() + i], f(data->axes[0][i], data->axes[1][j]),
                            tolerance);
        return;
    }
    const ScatteredData& data = scattered(field);
    EXPECT_EQ(data.dimension, 2);
    for (std::size_t p = 0; p < count; ++p)
        EXPECT_NEAR(data.values[p], f(data.points.x[p], data.points.y[p]), tolerance);
}

std::string error_of(const std::string& bytes, const FieldRequest& request = {}) {
    try {
        parse(bytes, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

std::string error_in(const std::string& name, const FieldRequest& request = {}) {
    try {
        read(name, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(FieldFile, VtkHasTheValuesThatVtkWrote) {
    for (const char* name : {"image-4.vtk", "image-ascii.vtk", "image-binary.vtk", "ascii.vti", "binary.vti",
                             "appended.vti", "raw-zlib.vti", "rectilinear-4.vtk", "rectilinear-ascii.vtk",
                             "rectilinear-binary.vtk", "ascii.vtr", "binary.vtr", "appended.vtr"}) {
        SCOPED_TRACE(name);
        const FieldData field = read(name);
        EXPECT_EQ(field.variables, (std::vector<std::string>{"f", "velocity", "number"}));
        EXPECT_EQ(field.variable, "f");
        EXPECT_EQ(grid(field).axes[0].size(), 4u);
        expect_f(field, 12);
    }
    for (const char* name : {"structured-4.vtk", "structured-ascii.vtk", "structured-binary.vtk", "ascii.vts",
                             "binary.vts", "appended.vts"}) {
        SCOPED_TRACE(name);
        // VTK writes eleven digits.
        expect_f(read(name), 12, std::string_view(name).ends_with("ascii.vtk") ? 1e-9 : 1e-12);
    }
    for (const char* name : {"unstructured-4.vtk", "unstructured-ascii.vtk", "unstructured-binary.vtk",
                             "polydata-4.vtk", "polydata-ascii.vtk", "polydata-binary.vtk", "ascii.vtu",
                             "binary.vtu", "appended.vtu", "big-base64-zlib.vtu", "ascii.vtp", "binary.vtp",
                             "appended.vtp", "meshio-plain.vtu", "meshio-zlib.vtu", "meshio.vtk"}) {
        SCOPED_TRACE(name);
        expect_f(read(name), 6);
    }
}

/// g of make_files.py.
double g(double x, double y, double z) { return 1 + 2 * x - 3 * y + x * y + 4 * z + x * y * z; }

void expect_g(const FieldData& field, std::size_t count) {
    EXPECT_EQ(field.variable, "g");
    EXPECT_EQ(values_of(field).size(), count);
    if (const auto* data = std::get_if<ScatteredData>(&field.data)) {
        EXPECT_EQ(data->dimension, 3);
        for (std::size_t p = 0; p < data->values.size(); ++p)
            EXPECT_NEAR(data->values[p], g(data->points.x[p], data->points.y[p], data->points.z[p]), 1e-12);
        return;
    }
    const GridData& data = grid(field);
    ASSERT_EQ(data.dimension(), 3u);
    std::size_t at = 0;
    for (const double z : data.axes[2])
        for (const double y : data.axes[1])
            for (const double x : data.axes[0]) EXPECT_NEAR(data.values[at++], g(x, y, z), 1e-12);
}

TEST(FieldFile, FieldsInSpaceAreReadWhole) {
    for (const char* name : {"space.vti", "space.vtk", "space.vts"}) {
        SCOPED_TRACE(name);
        const FieldData field = read(name, {.dimension = 3});
        expect_g(field, 36);
        EXPECT_TRUE(std::holds_alternative<GridData>(field.data)) << "the points are a lattice";
    }
    const FieldData netcdf = read("space.nc", {.dimension = 3});
    expect_g(netcdf, 60);
    EXPECT_EQ(netcdf.variables, std::vector<std::string>{"g"}) << "the ground has two directions";
    EXPECT_EQ(grid(netcdf).axes[1], (std::vector<double>{0, 0.5, 1, 2, 3})) << "y descends in the file";
    EXPECT_EQ(grid(read("space.nc", {.variable = "ground", .dimension = 3})).dimension(), 2u);
    expect_g(read("space-points.nc", {.dimension = 3}), 30);
    expect_g(read("space.vtu", {.dimension = 3}), 5);
    const FieldData cells = read("space.vtu", {.variable = "number", .dimension = 3});
    EXPECT_NEAR(scattered(cells).points.z[1], 0.75, 1e-15) << "the middle of the second tetrahedron";
}

TEST(FieldFile, InThePlaneALevelOfAFieldInSpaceIsRead) {
    const FieldData upper = read("space.vti", {.variable = "g", .level = 2});
    ASSERT_EQ(grid(upper).dimension(), 2u);
    EXPECT_NEAR(grid(upper).values[1], g(-0.5, 2, 4), 1e-12);
    const FieldData ground = read("space.nc", {.variable = "g", .level = -1});
    ASSERT_EQ(grid(ground).dimension(), 2u);
    EXPECT_NEAR(grid(ground).values[2], g(1, 0, 0.25), 1e-12);
    EXPECT_TRUE(std::holds_alternative<ScatteredData>(read("space.vts").data))
        << "its third direction is kept";
}

TEST(FieldFile, NotesSayWhichEntriesOfUnknownDimensionsAreUsed) {
    const FieldData plane = read("members.nc", {.level = 1});
    EXPECT_EQ(grid(plane).values, (std::vector<double>{8, 9, 10, 11}));
    EXPECT_EQ(plane.notes, (std::vector<std::string>{
                               "The dimension member is no height; level = 1 chooses one of its 3 entries.",
                               "Of the dimension stage the first of 2 entries is used."}));
    const FieldData solid = read("members.nc", {.dimension = 3});
    EXPECT_EQ(grid(solid).count(2), 2u);
    EXPECT_EQ(solid.notes,
              (std::vector<std::string>{"The dimension stage is no known axis and is taken as z.",
                                        "Of the dimension member the first of 3 entries is used."}));
    const FieldData with_height = read("members.nc", {.variable = "w", .level = 1});
    EXPECT_EQ(grid(with_height).values, (std::vector<double>{4, 5, 6, 7})) << "z is the level, not member";
    EXPECT_EQ(with_height.notes,
              (std::vector<std::string>{"The dimension row is no known axis and is taken as y.",
                                        "Of the dimension member the first of 3 entries is used."}));
    EXPECT_EQ(error_in("members.nc", {.variable = "w", .level = 2}),
              "cannot read members.nc: there is no level 2; it has 0 to 1 (-1 is the last)");
    for (const char* name : {"space.nc", "globe-classic.nc"}) EXPECT_TRUE(read(name).notes.empty()) << name;
    EXPECT_EQ(read("globe-classic.nc").time_steps, 2u);
    EXPECT_TRUE(read("globe-classic.nc", {.time_ends = false}).notes.empty());
    EXPECT_EQ(read("space.nc", {.time_ends = false}).notes,
              std::vector<std::string>{"The field has one time step, and does not move while time passes."});
}

TEST(FieldFile, ColumnsOfPointsInSpace) {
    const FieldRequest in_space{.dimension = 3};
    const FieldData named = parse_field("z;y;x;t\n0;1;2;3\n1;0;2;5\n2;2;2;7\n", "it", in_space);
    EXPECT_EQ(scattered(named).dimension, 3);
    EXPECT_EQ(scattered(named).points.x, (std::vector<double>{2, 2, 2}));
    EXPECT_EQ(scattered(named).points.z, (std::vector<double>{0, 1, 2}));
    const FieldData plain = parse_field("0 1 2 3\n1 0 2 5\n2 2 2.5 7\n", "it", in_space);
    EXPECT_EQ(plain.notes, std::vector<std::string>{"The four columns are read as x, y, z and the value."});
    EXPECT_EQ(scattered(plain).values, (std::vector<double>{3, 5, 7}));
    EXPECT_TRUE(std::holds_alternative<GridData>(parse_field("0 1 2 3\n1 0 2 5\n", "it").data))
        << "in the plane it is a matrix";
    std::string lattice = "x,y,z,v\n";
    for (const char* point : {"0,0,0", "1,0,0", "0,1,0", "1,1,0", "0,0,1", "1,0,1", "0,1,1", "1,1,1"})
        lattice += std::string(point) + "," + point[0] + "\n";
    EXPECT_EQ(grid(parse_field(lattice, "it", in_space)).values,
              (std::vector<double>{0, 1, 0, 1, 0, 1, 0, 1}));
    EXPECT_TRUE(std::holds_alternative<ScatteredData>(parse_field(lattice, "it").data));
}

TEST(FieldFile, VectorsOfVtkAreTheirLengths) {
    const FieldData field = read("raw-zlib.vti", {.variable = "velocity"});
    for (std::size_t k = 0; k < 12; ++k)
        EXPECT_NEAR(grid(field).values[k], 5 * std::abs(grid(field).axes[0][k % 4]), 1e-12);
    EXPECT_EQ(field.notes, std::vector<std::string>{"The value of 'velocity' is the length of its vectors."});
}

TEST(FieldFile, ValuesOfCellsAreAtTheirCentres) {
    const FieldData image = read("binary.vti", {.variable = "number"});
    EXPECT_EQ(grid(image).axes[0], (std::vector<double>{-0.75, -0.25, 0.25}));
    EXPECT_EQ(grid(image).axes[1], (std::vector<double>{2.125, 2.375}));
    EXPECT_EQ(grid(image).values, (std::vector<double>{0, 1, 2, 3, 4, 5}));
    for (const char* name : {"big-base64-zlib.vtu", "meshio-zlib.vtu", "polydata-binary.vtk", "ascii.vtp",
                             "unstructured-4.vtk"}) {
        SCOPED_TRACE(name);
        const FieldData field = read(name, {.variable = "number"});
        const ScatteredData& data = scattered(field);
        EXPECT_EQ(data.values, (std::vector<double>{0, 1, 2}));
        EXPECT_NEAR(data.points.x[0], 2.0 / 3, 1e-15);
        EXPECT_NEAR(data.points.y[1], 2.0 / 3, 1e-15);
        EXPECT_NEAR(data.points.x[2], 1.5, 1e-15);
        EXPECT_NEAR(data.points.y[2], 0.625, 1e-15);
    }
    const FieldData ring = read("binary.vts", {.variable = "number"});
    EXPECT_NEAR(scattered(ring).points.x[0], (1 + 1.5) * (1 + std::sqrt(0.75)) / 4, 1e-12);
}

TEST(FieldFile, PackedNetcdfIsUnpacked) {
    for (const char* name : {"globe-classic.nc", "globe-hdf5.nc"}) {
        SCOPED_TRACE(name);
        const FieldData first = read(name);
        EXPECT_EQ(first.variable, "height");
        EXPECT_EQ(grid(first).coordinates, Coordinates::geographic);
        EXPECT_EQ(grid(first).axes[0].back(), 330);
        EXPECT_EQ(grid(first).axes[1].front(), -80) << "latitudes descend in the file";
        EXPECT_EQ(count_missing(grid(first).values), 4u) << "fill value, missing value, beyond the range";
        for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(std::isnan(grid(first).values[8 * 12 + i]));
        EXPECT_EQ(grid(first).values[8 * 12 + 4], 100 + 0.5 * 4);
        EXPECT_EQ(grid(first).values[5], 100 + 0.5 * (5 + 20 * 8));
        const FieldData later = read(name, {.time = 1, .level = -1});
        EXPECT_EQ(count_missing(grid(later).values), 0u);
        EXPECT_EQ(grid(later).values[5], 100 + 0.5 * (5 + 20 * 8 + 200 * 2 + 1000));
        EXPECT_EQ(error_in(name, {.time = 2}), std::string("cannot read ") + name +
                                                   ": there is no time 2; it has 0 to 1 (-1 is the last)");
    }
}

TEST(FieldFile, NetcdfHasItsDimensionsInAnyOrder) {
    expect_f(read("plane-64bit.nc"), 12);
    EXPECT_EQ(grid(read("plane-64bit.nc")).coordinates, Coordinates::cartesian);
    EXPECT_EQ(grid(read("plane-64bit.nc", {.variable = "flags"})).values[3], 250);
    expect_f(read("scipy.nc"), 15);
    EXPECT_EQ(grid(read("scipy.nc")).coordinates, Coordinates::none);
}

TEST(FieldFile, NetcdfWithCoordinatesInTwoDimensions) {
    const FieldData field = read("curvilinear.nc");
    const ScatteredData& data = scattered(field);
    EXPECT_EQ(data.coordinates, Coordinates::geographic);
    EXPECT_NEAR(data.points.x[6], 10 + 4 + 0.1, 1e-5);
    EXPECT_NEAR(data.points.y[6], 45 + 1 - 0.4, 1e-5);
    EXPECT_EQ(data.values[6], f(2, 1));
    EXPECT_EQ(count_missing(data.values), 1u);
}

TEST(FieldFile, CsvWithColumns) {
    const FieldData numpy = read("numpy.csv"); // its comment has the names
    EXPECT_EQ(numpy.variable, "f");
    ASSERT_EQ(grid(numpy).values.size(), 12u);
    expect_f(numpy, 12);
    const FieldData points =
        parse("\xef\xbb\xbf\"lon\";lat;t;p\n# stations\n10;50;1;2\n11.5;49;;3\n12;48;nan;4\n");
    EXPECT_EQ(points.variables, (std::vector<std::string>{"t", "p"}));
    EXPECT_EQ(scattered(points).coordinates, Coordinates::geographic);
    EXPECT_EQ(scattered(points).points.x[1], 11.5);
    EXPECT_EQ(count_missing(values_of(points)), 2u);
    EXPECT_EQ(values_of(parse("\"lon\";lat;t;p\n10;50;1;2\n11.5;49;;3\n", {.variable = "p"})),
              (std::vector<double>{2, 3}));
    const FieldData space = parse("x\ty\tz\tw\n0\t0\t1\t5\n1\t0\t0\t6\n");
    EXPECT_EQ(scattered(space).dimension, 3);
    EXPECT_EQ(scattered(space).points.z[0], 1);
    const FieldData plain = parse("0 0   1\n  1 0 2\n0 1 3\n1.5 1 4\n");
    EXPECT_EQ(scattered(plain).dimension, 2);
    EXPECT_EQ(values_of(plain), (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(plain.notes, std::vector<std::string>{"The three columns are read as x, y and the value."});
}

TEST(FieldFile, CsvWithNamesOfStations) {
    const FieldData field =
        parse("station,lon,lat,height,country\nDavos,9.8,46.8,1594,CH\nBern,7.4,46.9,553,CH\n"
              "Ulm,10,48.4,n/a,DE\n");
    EXPECT_EQ(field.variables, std::vector<std::string>{"height"});
    EXPECT_EQ(scattered(field).points.x, (std::vector<double>{9.8, 7.4, 10}));
    EXPECT_EQ(values_of(field)[1], 553);
    EXPECT_EQ(count_missing(values_of(field)), 1U);
    EXPECT_EQ(error_of("x,y,name\n0,1,a\n"),
              "cannot read it.csv: it has coordinates, but no column of values");
    EXPECT_EQ(error_of("x,y,v\n0,1,2\n0,1,two\n"), "cannot read it.csv: line 3: 'two' is not a number");
}

TEST(FieldFile, CsvWithAMatrix) {
    const FieldData field = parse("1,2,3,4\r\n5,6,,8\r\n"); // the first row is the top
    EXPECT_EQ(grid(field).coordinates, Coordinates::none);
    EXPECT_EQ(grid(field).values[0], 5);
    EXPECT_EQ(grid(field).values[7], 4);
    EXPECT_EQ(count_missing(grid(field).values), 1u);
    const FieldData axes = parse("y\\x,0,0.5,2\n1,10,11,12\n0,20,21,22\n");
    EXPECT_EQ(grid(axes).axes[0], (std::vector<double>{0, 0.5, 2}));
    EXPECT_EQ(grid(axes).axes[1], (std::vector<double>{0, 1}));
    EXPECT_EQ(grid(axes).values, (std::vector<double>{20, 21, 22, 10, 11, 12}));
}

TEST(FieldFile, PointsOfAGridAreOne) {
    const FieldData field = parse("x,y,v\n1,0,2\n0,1,3\n0,0,1\n1,1,4\n");
    EXPECT_EQ(grid(field).values, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_TRUE(std::holds_alternative<ScatteredData>(parse("x,y,v\n1,0,2\n0,1,3\n0,0,1\n1,0,4\n").data))
        << "a point twice";
}

TEST(FieldFile, CoincidentPointsHaveTheMeanOfTheirValues) {
    const FieldData twice = parse("x,y,v\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n0,0,3\n");
    EXPECT_EQ(grid(twice).values, (std::vector<double>{2, 2, 3, 4}));
    EXPECT_EQ(twice.notes, std::vector<std::string>{"One point coincides with another; the means of the "
                                                    "values at such points are used."});
    // What rounding has moved, a missing value, and coordinates of different sizes.
    const FieldData more = parse("x,y,v\n0,0,6\n1e6,0,2\n0,1e-4,\n1e6,1e-4,4\n5e5,5e-5,7\n500000.0000001,"
                                 "0.00005,9\n1e-9,1e-16,3\n0,1e-4,5\n0,0,3\n");
    EXPECT_EQ(scattered(more).values, (std::vector<double>{4, 2, 5, 4, 8}));
    EXPECT_EQ(scattered(more).points.size(), 5u);
    EXPECT_EQ(more.notes, std::vector<std::string>{"4 points coincide with others; the means of the values "
                                                   "at such points are used."});
}

TEST(FieldFile, InfinityIsMissing) {
    const FieldData field = parse("1,inf,3,4\n5,-Infinity,+Inf,8\n9,infinity,-INF,12\n");
    EXPECT_EQ(count_missing(values_of(field)), 5u);
    EXPECT_EQ(values_of(field)[0], 9);
    EXPECT_EQ(error_of("x,y,v\ninf,2,3\n"), "cannot read it.csv: row 1 of its numbers has no coordinates");
}

TEST(FieldFile, LinesMayEndWithCarriageReturns) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const auto lines = [&](std::initializer_list<const char*> all) {
            std::string text;
            for (const char* one : all) text += one + end;
            return text;
        };
        EXPECT_EQ(values_of(parse(lines({"# a table", "x,y,v", "0,0,1", "1,0,2", "", "0,1,3", "1,1,4"}))),
                  (std::vector<double>{1, 2, 3, 4}));
        EXPECT_EQ(error_of(lines({"x,y,v", "", "0,0,1", "1,0"})),
                  "cannot read it.csv: line 4 has 2 columns, the first has 3");
        EXPECT_EQ(values_of(parse(lines({"# vtk DataFile Version 3.0", "title", "ASCII",
                                         "DATASET STRUCTURED_POINTS", "DIMENSIONS 2 2 1", "POINT_DATA 4",
                                         "SCALARS v float 1", "LOOKUP_TABLE default", "1 2", "3 4"}))),
                  (std::vector<double>{1, 2, 3, 4}));
    }
}

TEST(FieldFile, NumbersOfVtkBeyondADoubleAreMissingOrZero) {
    const FieldData old =
        parse("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 1\n"
              "POINT_DATA 6\nSCALARS v double 1\nLOOKUP_TABLE default\n1 1e400 -1E+400\n1e-400 "
              "nan +5\n");
    const FieldData xml =
        parse("<VTKFile type=\"ImageData\"><ImageData><Piece Extent=\"0 2 0 1 0 0\"><PointData>"
              "<DataArray type=\"Float64\" Name=\"v\" format=\"ascii\">1 1e400 -1E+400 1e-400 "
              "nan +5</DataArray></PointData></Piece></ImageData></VTKFile>");
    for (const FieldData* field : {&old, &xml}) {
        EXPECT_EQ(count_missing(values_of(*field)), 3u);
        EXPECT_EQ(values_of(*field)[0], 1);
        EXPECT_EQ(values_of(*field)[3], 0);
        EXPECT_EQ(values_of(*field)[5], 5);
    }
}

TEST(FieldFile, ReadingReportsProgressAndStops) {
    std::string numbers;
    for (int i = 0; i < 10'000; ++i) numbers += std::to_string(i) + " 1 2 0\n";
    const std::string image =
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 10000 "
        "1\nPOINT_DATA 40000\nSCALARS v float 1\nLOOKUP_TABLE default\n";
    const std::string xml =
        "<VTKFile type=\"ImageData\"><ImageData><Piece Extent=\"0 3 0 9999 0 0\"><PointData>"
        "<DataArray type=\"Float64\" Name=\"v\" format=\"ascii\">" +
        numbers + "</DataArray></PointData></Piece></ImageData></VTKFile>";
    for (const std::string& text : {numbers, image + numbers, xml}) {
        std::vector<double> reported;
        std::stop_source stop;
        parse(text, {.progress = [&](double done) { reported.push_back(done); }, .stop = stop.get_token()});
        EXPECT_GE(reported.size(), 9u);
        for (const double done : reported) EXPECT_TRUE(done >= 0 && done <= 1) << done;
        int calls = 0;
        const auto third = [&](double) {
            if (++calls == 3) stop.request_stop();
        };
        EXPECT_THROW(parse(text, {.progress = third, .stop = stop.get_token()}), Interrupted);
        EXPECT_EQ(calls, 3);
    }
}

TEST(FieldFile, WrongCsvIsOneSentence) {
    EXPECT_EQ(error_of(""), "cannot read it.csv: it is empty");
    EXPECT_EQ(error_of("# only\n\n# comments\n"), "cannot read it.csv: it has no numbers");
    EXPECT_EQ(error_of("x,y,v\n"), "cannot read it.csv: it has a line of names, but no numbers");
    EXPECT_EQ(error_of("x,y,v\n1,2,3\n1,2\n"), "cannot read it.csv: line 3 has 2 columns, the first has 3");
    EXPECT_EQ(error_of("1,2,3,4\n1,zwei,3,4\n"), "cannot read it.csv: line 2: 'zwei' is not a number");
    EXPECT_EQ(error_of("1,2,3\n1,2,x\n"), "cannot read it.csv: line 2: 'x' is not a number");
    EXPECT_EQ(error_of("0;0;1\n0,5;1;2\n"),
              "cannot read it.csv: line 2: '0,5' is not a number (write decimal points, not commas)");
    EXPECT_EQ(error_of("x,y\n1,2\n"), "cannot read it.csv: it has coordinates, but no column of values");
    EXPECT_EQ(error_of("x,y,v\n,2,3\n"), "cannot read it.csv: row 1 of its numbers has no coordinates");
    EXPECT_EQ(error_of("x,y,v\n1,2,\n"), "cannot read it.csv: all values of 'v' are missing");
    EXPECT_EQ(error_of("x,y,vel\n1,2,3\n", {.variable = "val"}),
              "cannot read it.csv: it has no variable 'val' (did you mean 'vel'?); it has vel");
    EXPECT_EQ(
        error_of("1,2,3,4\n"),
        "cannot read it.csv: a matrix must have two rows and two columns, or it must have columns x, y and "
        "value");
    EXPECT_EQ(error_of(",1,2,1\n0,1,2,3\n1,1,2,3\n"),
              "cannot read it.csv: the coordinate 1 of the grid appears twice");
}

TEST(FieldFile, OtherKindsAreNamed) {
    EXPECT_EQ(error_of("GRIB2..."),
              "cannot read it.csv: it is a GRIB file; convert it to NetCDF (cdo -f nc copy)");
    EXPECT_EQ(error_of("<svg/>"), "cannot read it.csv: it is an XML file, but not a VTK file");
    EXPECT_EQ(error_of(std::string("\0\1\2", 3)),
              "cannot read it.csv: it is none of the kinds of file that are read: NetCDF, CSV, VTK");
    EXPECT_EQ(error_of("<?xml version=\"1.0\"?><svg/>"),
              "cannot read it.csv: its root element is <svg>, not <VTKFile>");
    EXPECT_EQ(error_in("lz4.vti"), "cannot read lz4.vti: it is compressed by vtkLZ4DataCompressor; only "
                                   "vtkZLibDataCompressor is read");
}

std::string legacy(const std::string& text) { return error_of("# vtk DataFile Version 3.0\ntitle\n" + text); }

TEST(FieldFile, WrongLegacyVtkIsOneSentence) {
    const std::string begin = "cannot read it.csv: ";
    EXPECT_EQ(legacy("TEXT\n"), begin + "its third line must be ASCII or BINARY, not 'TEXT'");
    EXPECT_EQ(legacy("ASCII\nDATASET FIELD\n"),
              begin + "its data set is FIELD, not STRUCTURED_POINTS, RECTILINEAR_GRID, STRUCTURED_GRID, "
                      "UNSTRUCTURED_GRID or POLYDATA");
    const std::string image = "DATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\nORIGIN 0 0 0\nSPACING 1 1 1\n";
    EXPECT_EQ(legacy("ASCII\n" + image + "POINT_DATA 4\nSCALARS v float 1\nLOOKUP_TABLE default\n1 2 3\n"),
              begin + "it ends within an array");
    EXPECT_EQ(legacy("ASCII\n" + image + "POINT_DATA 4\nSCALARS v float 1\nLOOKUP_TABLE default\n1 2 x 3\n"),
              begin + "it has 'x' where a number is expected");
    EXPECT_EQ(legacy("ASCII\n" + image + "POINT_DATA 3\nSCALARS v float 1\nLOOKUP_TABLE default\n1 2 3\n"),
              begin + "'v' has 3 values for 4 points");
    EXPECT_EQ(legacy("BINARY\n" + image + "POINT_DATA 4\nSCALARS v float 1\nLOOKUP_TABLE default\n1234"),
              begin + "it ends within an array");
    EXPECT_EQ(legacy("ASCII\n" + image), begin + "it has no arrays of numbers at points or cells");
    EXPECT_EQ(legacy("ASCII\n" + image + "POINT_DATA 4\nSCALARS v bit 1\nLOOKUP_TABLE default\n1 0 1 0\n"),
              begin + "it has numbers of the type 'bit', which is not read");
}

TEST(FieldFile, HugeCountsAreRefusedBeforeMemoryIsTaken) {
    const std::string begin = "cannot read it.csv: it has more than ";
    EXPECT_EQ(legacy("ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1000000 1000000 1\n"),
              begin + "33554432 points");
    EXPECT_EQ(legacy("BINARY\nDATASET POLYDATA\nPOINTS 1099511627776 float\n"),
              begin + "33554432 numbers in an array");
    EXPECT_EQ(legacy("ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 30000000 1 1\n"),
              begin + "1048576 points along an axis");
    const auto xml = [](const std::string& grid) {
        return error_of("<VTKFile type=\"" + grid + "</Piece></" + grid.substr(0, grid.find('"')) +
                        "></VTKFile>");
    };
    EXPECT_EQ(xml("UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"1099511627776\" "
                  "NumberOfCells=\"1\">"),
              "cannot read it.csv: NumberOfPoints is larger than 33554432");
    EXPECT_EQ(xml("ImageData\"><ImageData><Piece Extent=\"0 1000000 0 1000000 0 0\">"),
              begin + "33554432 points");
}

TEST(FieldFile, WrongXmlVtkIsOneSentence) {
    const std::string begin = "cannot read it.csv: ";
    const auto image = [](const std::string& array, const std::string& attributes = "") {
        return error_of("<VTKFile type=\"ImageData\"" + attributes +
                        "><ImageData><Piece Extent=\"0 1 0 1 0 0\">"
                        "<PointData><DataArray type=\"Float32\" Name=\"v\" " +
                        array + "</DataArray></PointData></Piece></ImageData></VTKFile>");
    };
    EXPECT_EQ(image("format=\"ascii\">1 2 3"), begin + "'v' has 3 numbers instead of 4");
    EXPECT_EQ(image("format=\"ascii\">1 2 x 4"), begin + "'v' has 'x' where a number is expected");
    EXPECT_EQ(image("format=\"binary\">!!!!"), begin + "'v' is not valid base64");
    EXPECT_EQ(image("format=\"binary\">EAAAAAAA"), begin + "'v' ends before its 16 bytes");
    EXPECT_EQ(image("format=\"appended\" offset=\"7\">"),
              begin + "'v' begins beyond the end of the appended data");
    EXPECT_EQ(image("format=\"binary\">AQAAABAAAAAQAAAACAAAAA==AAAAAAAAAAA=",
                    " compressor=\"vtkZLibDataCompressor\""),
              begin + "'v' has damaged compressed data");
    EXPECT_EQ(error_of("<VTKFile type=\"ImageData\">\n<Image"), begin + "XML syntax error at line 2");
    EXPECT_EQ(
        error_of("<VTKFile type=\"PUnstructuredGrid\"></VTKFile>"),
        begin + "it only lists the files of a parallel run (PUnstructuredGrid); read one of these, or merge "
                "them");
}

TEST(FieldFile, DamagedNetcdfIsOneSentence) {
    for (const char* name : {"globe-classic.nc", "globe-hdf5.nc", "plane-64bit.nc", "scipy.nc"}) {
        const std::string whole = read_data_file(name, files);
        for (const std::size_t length : {std::size_t{4}, whole.size() / 8, whole.size() / 2}) {
            SCOPED_TRACE(name + std::string(" ") + std::to_string(length));
            const std::string error = error_of(whole.substr(0, length));
            EXPECT_TRUE(error.starts_with("cannot read it.csv: it is damaged") || error == "none") << error;
            EXPECT_EQ(error.find('\n'), std::string::npos);
        }
    }
    EXPECT_EQ(error_in("large-chunk.nc"),
              "cannot read large-chunk.nc: 'value' is stored in chunks of more than 256 MiB");
    EXPECT_EQ(error_in("no-scale.nc"), "cannot read no-scale.nc: scale_factor of 'value' is zero");
    EXPECT_EQ(
        error_in("globe-hdf5.nc", {.variable = "heigt"}),
        "cannot read globe-hdf5.nc: it has no variable 'heigt' (did you mean 'height'?); it has height");
}

TEST(FieldFile, NetcdfWithDataOfOtherFilesIsRefused) {
    const std::string end = "; only files that are complete in themselves are read";
    EXPECT_EQ(error_in("external.nc"), "cannot read external.nc: 'value' is stored in another file" + end);
    EXPECT_EQ(error_in("virtual.nc"), "cannot read virtual.nc: 'value' is a virtual dataset" + end);
    EXPECT_EQ(error_in("link.nc"), "cannot read link.nc: 'more/value' is a link to another file" + end);
}

TEST(FieldFile, GroupsOfNetcdfAreNamed) {
    EXPECT_EQ(error_in("groups.nc"),
              "cannot read groups.nc: it has no variable with two dimensions outside of its groups (land, "
              "ocean), which are not read; take them out of the groups (ncks -G :)");
}

} // namespace
} // namespace gaspard
