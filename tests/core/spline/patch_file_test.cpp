#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/base/short_number.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/patch_xml.hpp"
#include "core/spline/spline_domain.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

SplinePatch parsed(const std::string& text, const std::string& which = {}) {
    return parse_patch({text, "p.file", which}).patch;
}
std::string refusal(const std::string& text, const std::string& which = {}) {
    return message_of<InputError>([&] { parsed(text, which); });
}
/// `text` with the first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}
void expect_in(const std::string& part, const std::string& text) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

/// A quarter of the annulus with radii 1 and 2: the angle is the second direction.
SplinePatch quarter() {
    const double s = std::sqrt(0.5);
    SplinePatch patch{{{{1, {0, 0, 1, 1}}, {2, {0, 0, 0, 1, 1, 1}}}}, Points(6), {1, 1, s, s, 1, 1}};
    const double at[6][2] = {{1, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}};
    for (std::size_t i = 0; i < 6; ++i) patch.control.set(i, {at[i][0], at[i][1], 0});
    return patch;
}
void expect_quarter(const SplinePatch& patch) {
    const SplinePatch wanted = quarter();
    ASSERT_EQ(patch.space, wanted.space);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_LT(norm(patch.control[i] - wanted.control[i]), 1e-15) << i;
        EXPECT_NEAR(patch.weights[i], wanted.weights[i], 1e-15) << i;
    }
}

/// A bilinear geometry of G+Smo with the given corners and id.
std::string bilinear(const std::string& corners, const std::string& id, const std::string& more = {}) {
    return R"(<Geometry type="TensorBSpline2" id=")" + id + R"(">
  <Basis type="TensorBSplineBasis2">
   <Basis type="BSplineBasis" index="0"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
   <Basis type="BSplineBasis" index="1"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
  </Basis>
  <coefs geoDim="2">)" +
           corners + "</coefs>" + more + "\n</Geometry>\n";
}
std::string document(const std::string& content) {
    return "<?xml version='1.0'?>\n<xml>\n" + content + "</xml>\n";
}
const std::string unit = "0 0 1 0 0 1 1 1";

std::vector<double> flat(const Points& points) {
    std::vector<double> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.insert(all.end(), {points.x[i], points.y[i]});
    return all;
}
const std::vector<double> unit_corners = {0, 0, 1, 0, 0, 1, 1, 1};

TEST(PatchFile, ReadsBack) {
    const SplinePatch disk = nurbs_disk();
    EXPECT_EQ(parsed(patch_json(disk)), disk);
}

TEST(PatchFile, ScalesKnotsAndDefaultsWeightsToOne) {
    const SplinePatch patch = parsed(
        R"({"degrees": [1, 1], "knots": [[2, 2, 3, 4, 4], [0, 0, 5, 5]],
            "control_points": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 7]]})");
    EXPECT_EQ(patch.space.directions[0].knots, (std::vector<double>{0, 0, 0.5, 1, 1}));
    EXPECT_EQ(patch.weights, std::vector<double>(6, 1.0));
    EXPECT_EQ(patch_map(patch)->space_dimension(), 3);
}

const std::string smo = R"(<?xml version="1.0" encoding="UTF-8"?>
<xml>
 <!-- <Geometry type="TensorBSpline2"> of which nothing counts </Geometry> -->
 <Geometry type="BSpline" id="3"><Basis type="BSplineBasis"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
  <coefs geoDim="1">0 1</coefs></Geometry>
 <Geometry type="TensorNurbs2" id="0">
  <Basis type="TensorNurbsBasis2">
   <Basis type="TensorBSplineBasis2">
    <Basis type="BSplineBasis" index="0">
     <KnotVector degree="1">0 0 2 2 </KnotVector>
    </Basis>
    <Basis type="BSplineBasis" index="1">
     <KnotVector degree="2">0 0 0 1 1 1 </KnotVector>
    </Basis>
   </Basis>
   <weights>
1
1
0.7071067811865476
0.7071067811865476
1
1
</weights>
  </Basis>
  <coefs geoDim="2">1 0 
2 0 
1 1 
2 2 
0 1 
0 2 
</coefs>
 </Geometry>
</xml>
)";

TEST(PatchXml, ReadsTheFormatOfGSmo) { // quarter annulus of radii 1 and 2
    const SplinePatch patch = parsed(smo);
    expect_quarter(patch);
}

TEST(PatchXml, ReadsBackWhatItWrites) {
    SplinePatch patch = nurbs_disk();
    EXPECT_EQ(parsed(patch_xml(patch)), patch);
    patch.weights.assign(patch.weights.size(), 1.0);
    patch.control.z[3] = 0.1;
    EXPECT_EQ(parsed(patch_xml(patch)), patch);
    EXPECT_NE(patch_xml(patch).find("TensorBSpline2"), std::string::npos);
}

TEST(PatchXml, ReportsErrors) {
    const auto complaint = [](const std::string& from, const std::string& to) {
        std::string text = smo;
        text.replace(text.find(from), from.size(), to);
        return refusal(text);
    };
    const auto expect = [&](const std::string& from, const std::string& to, const std::string& part) {
        const std::string message = complaint(from, to);
        EXPECT_NE(message.find("p.file"), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect("TensorNurbs2", "TensorNurbs3", "TensorNurbs3, id 0 is a solid");
    expect("degree=\"2\"", "degree=\"8\"", "1 to 7");
    expect("degree=\"2\"", "order=\"2\"", "1 to 7");
    expect("0 0 0 1 1 1", "0 0 0 1 1 x", "list of numbers");
    expect("0 0 0 1 1 1", "0 0 1 1 1", "knots[1]");
    expect("0 1 \n0 2", "0 1 \n0", "not a multiple");
    expect("0.7071067811865476\n", "", "as many weights");
    expect("</coefs>\n </Geometry>", "</Geometry>", "XML syntax error at line 31");
}

TEST(PatchFile, IsRejectedIfItFoldsOrHasNoArea) {
    Values values("domain", spline_domains().back().rows);
    const auto with_corners = [&](const std::string& corners) {
        values.set("file", R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": )" +
                               corners + "}");
        return make_spline_domain("spline-patch", values);
    };
    EXPECT_NO_THROW(with_corners("[[0,0],[1,0],[0,1],[1,1]]"));
    EXPECT_NO_THROW(with_corners("[[1,0],[0,0],[1,1],[0,1]]")); // reversed orientation
    EXPECT_NO_THROW(with_corners("[[0,0,1],[0,1,0],[1,0,0],[1,1,1]]"));
    for (const char* bad :
         {"[[0,0],[1,0],[1,1],[0,1]]", "[[1,0],[1,0],[1,1],[1,1]]", "[[0,0,1],[0,0,2],[0,0,3],[0,0,4]]"})
        EXPECT_NE(message_of<InputError>([&] { with_corners(bad); }).find("folds or has no area"),
                  std::string::npos);
    values.set("file", std::string());
    EXPECT_NO_THROW(make_spline_domain("spline-patch", values)); // singular only at its corners
}

TEST(PatchFile, ReportsErrors) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"{", "JSON syntax error at character 2"},
        {"[]", "object"},
        {R"({"degrees": [1, 1]})", "'knots'"},
        {R"({"degrees": [1], "knots": [[0,0,1,1]], "control_points": []})", "two"},
        {R"({"degrees": [9, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": []})", "1 to 7"},
        {R"({"degrees": [1, 2], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": []})", "knots[1]"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,0,0]], "control_points": []})", "knots[1]"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[]], "control_points": []})", "knots[1]"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": [[0,0]]})",
         "4 control points"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": [[0,0],[1,0],[0,1],[1]]})",
         "control_points[3]"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": [[0,0],[1,0],[0,1],[1,"a"]]})",
         "control_points[3]"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": [[0,0],[1,0],[0,1],[1,1]],
             "weights": [1, 1, 1, 0]})",
         "positive"},
        {R"({"degrees": [1, 1], "knots": [[0,0,1,1],[0,0,1,1]], "control_points": [[0,0],[1,0],[0,1],[1,1]],
             "weights": [1, 1]})",
         "as many weights"}};
    for (const auto& [text, part] : cases) {
        const std::string message = refusal(text);
        EXPECT_NE(message.find("p.file"), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    EXPECT_THROW(read_patch("/"), InputError);
    EXPECT_EQ(find_patch(" \n" + patch_json(nurbs_disk())).patch, nurbs_disk());
    EXPECT_NE(message_of<InputError>([] { read_patch("/no/such/file.json"); }).find("/no/such"),
              std::string::npos);
}

TEST(PatchXml, IsReadAsXml) {
    const std::string plain = document(bilinear(unit, "7"));
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"type=\"TensorBSpline2\" id=\"7\"", "id='7'  type = 'TensorBSpline2'"},
             {"type=\"TensorBSpline2\"", "label=\"a > b\" type=\"TensorBSpline2\""},
             {"0 0 1 0 0 1 1 1", "0&#32;0&#x20;1&#10;0<!-- 7 8 --> 0 1<![CDATA[ 1 1]]>"},
             {"0 0 1 0 0 1 1 1", "0 0 1 0<!-- a --> <!-- b -->0 1 1 1"},
             {"<xml>", "<!DOCTYPE xml [<!ELEMENT xml ANY>]><xml xmlns:a=\"b\">"},
             {"<?xml version='1.0'?>", "<!-- <Geometry> --><?pi <Geometry> ?>"}})
        EXPECT_EQ(flat(parsed(with(plain, from, to)).control), unit_corners) << to;
    EXPECT_EQ(flat(parsed("\xef\xbb\xbf" + plain).control), unit_corners) << "a byte order mark";
    std::string wide = "\xff\xfe";
    for (const char c : plain) wide += {c, '\0'};
    EXPECT_EQ(flat(parsed(wide).control), unit_corners) << "UTF-16";
}

TEST(PatchXml, ThatIsNotWellFormedIsASyntaxError) {
    const std::string plain = document(bilinear(unit, "7"));
    expect_in("XML syntax error at line", refusal(with(plain, "<coefs", "<!-- never closed <coefs")));
    expect_in("XML syntax error at line 8", refusal(with(plain, "</coefs>", "</coef>")));
    expect_in("XML syntax error at line", refusal(plain.substr(0, plain.size() / 2)));
    expect_in("'&more;'", refusal(with(plain, "0 0 1 0 0 1 1 1", "&more; 0")));
    expect_in("its root element is <VTKFile>", refusal("<VTKFile/>"));
    std::string deep;
    for (int i = 0; i < 20000; ++i) deep += "<a>";
    expect_in("XML syntax error", refusal(deep));
}

TEST(PatchXml, CoefficientsByCoordinates) {
    const std::string rows = document(bilinear("0 1 3 4  0 5 1 6", "0"));
    EXPECT_EQ(flat(parsed(with(rows, "geoDim=\"2\"", "geoDim=\"2\" order=\"coordinates\"")).control),
              (std::vector<double>{0, 0, 1, 5, 3, 1, 4, 6}));
    EXPECT_EQ(flat(parsed(rows).control), (std::vector<double>{0, 1, 3, 4, 0, 5, 1, 6}));
    expect_in("unknown order 'points'", refusal(with(rows, "geoDim=\"2\"", "geoDim=\"2\" order=\"points\"")));
    const std::string space = with(document(bilinear("0 1 0 1  0 0 1 1  5 6 7 8", "0")), "geoDim=\"2\"",
                                   "geoDim=\"3\" order='coordinates'");
    EXPECT_EQ(parsed(space).control.z, (std::vector<double>{5, 6, 7, 8}));
}

TEST(PatchXml, RefusesWhatItWouldGetWrong) {
    const std::string moved = bilinear(unit, "0", "<transform><translation>1 0 0</translation></transform>");
    expect_in("<transform>", refusal(document(moved)));
    for (const char* wrong :
         {"0.5.5 0 1 0 0 1 1", "1/0 0 1 0 0 1 1 1", "1e400 0 1 0 0 1 1 1", "nan 0 1 0 0 1 1 1",
          "0x1 0 1 0 0 1 1 1", "+-1 0 1 0 0 1 1 1", "1/2/3 0 1 0 0 1 1 1"})
        expect_in("<coefs> must be a list of numbers", refusal(document(bilinear(wrong, "0"))));
    expect_in("'0.5.5'", refusal(document(bilinear("0.5.5 0 1 0 0 1 1", "0"))));
    expect_in("a TensorBSpline2 has no <weights>",
              refusal(with(document(bilinear(unit, "0")), "</Basis>\n  </Basis>",
                           "</Basis><weights>1 1 1 1</weights></Basis>")));
    expect_in("its <Basis> has no <weights>",
              refusal(with(document(bilinear(unit, "0")), "TensorBSpline2\"", "TensorNurbs2\"")));
}

TEST(PatchXml, NumbersAsGSmoWritesThem) {
    EXPECT_EQ(flat(parsed(document(bilinear("1/2 +0.5  3/2 .5  5e-1 15E-1  +3/+2 3/2", "0"))).control),
              (std::vector<double>{0.5, 0.5, 1.5, 0.5, 0.5, 1.5, 1.5, 1.5}));
    std::string uniform = document(bilinear("0 0 1 0 2 0  0 1 1 1 2 1", "0"));
    uniform = with(uniform, "<KnotVector degree=\"1\">0 0 1 1</KnotVector>",
                   "<KnotVector mode=\"uniform\" csize=\"3\" degree=\" 1\"/>");
    EXPECT_EQ(parsed(uniform).space.directions[0].knots, (std::vector<double>{0, 0, 0.5, 1, 1}));
    for (const char* csize : {"1", "0", "-3", "2.5", "1000000000", "x"})
        expect_in("csize", refusal(with(uniform, "csize=\"3\"", "csize=\"" + std::string(csize) + "\"")));
}

TEST(PatchXml, Base64) {
    // struct.pack("<8d", 0, 0, 1, 0, 0, 1, 1, 1) and so on, by Python's base64
    const std::string d =
        "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAA8D8AAAAAAADwPw==";
    const std::string f = "AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/AACAPwAAgD8=";
    const std::string h = "AAAAAAEAAAAAAAEAAQABAA==";
    const std::string plain = document(bilinear("CONTENT", "0"));
    const auto encoded = [&](const std::string& format, const std::string& content) {
        return with(with(plain, "geoDim=\"2\"", "geoDim=\"2\" format=\"" + format + "\""), "CONTENT",
                    content);
    };
    EXPECT_EQ(flat(parsed(encoded("B64Float64", "\n  " + d + "\n")).control), unit_corners);
    EXPECT_EQ(flat(parsed(encoded("b64float64", d.substr(0, 20) + "\n" + d.substr(20))).control),
              unit_corners);
    EXPECT_EQ(flat(parsed(encoded("B64Float32", f)).control), unit_corners);
    EXPECT_EQ(flat(parsed(encoded("B64Int16", h)).control), unit_corners);
    EXPECT_EQ(flat(parsed(encoded("B64Uint16", h)).control), unit_corners);
    EXPECT_EQ(flat(parsed(encoded("ASCII", unit)).control), unit_corners);
    expect_in("unknown format 'hex'", refusal(encoded("hex", "00")));
    expect_in("unknown type 'float16'", refusal(encoded("B64Float16", f)));
    expect_in("not valid base64", refusal(encoded("B64Float64", "AAA")));
    expect_in("not valid base64", refusal(encoded("B64Float64", "A=AA")));
    expect_in("not a multiple of 8", refusal(encoded("B64Float64", "AAAA")));
    expect_in("not finite", refusal(encoded("B64Float64", "AAAAAAAA+H8="))); // NaN
}

TEST(Base64, IsThatOfTheStandard) { // RFC 4648, section 10
    const std::vector<std::pair<const char*, const char*>> cases = {
        {"", ""},        {"Zg==", "f"},        {"Zm8=", "fo"},
        {"Zm9v", "foo"}, {"Zm9vYg==", "foob"}, {"Zm9vYmFy", "foobar"}};
    for (const auto& [text, bytes] : cases) EXPECT_EQ(decode_base64(text), bytes);
    EXPECT_EQ(decode_numbers("/////w==", "int32", "x"), std::vector<double>{-1});
    EXPECT_EQ(decode_numbers("/////w==", "uint32", "x"), std::vector<double>{4294967295.0});
    EXPECT_EQ(decode_numbers("AAAAAAAAAIA=", "int64", "x"), std::vector<double>{-9223372036854775808.0});
}

TEST(Numbers, AreReadWhateverTheirSize) {
    EXPECT_EQ(parse_number("1e-400"), 0.0);
    EXPECT_EQ(parse_number("1e400"), std::nullopt);
    EXPECT_EQ(parse_number(std::string(400, '1')), std::nullopt);
    EXPECT_EQ(parse_number(""), std::nullopt);
    EXPECT_EQ(parse_number("+"), std::nullopt);
    EXPECT_EQ(parse_number("/2"), std::nullopt);
}

TEST(PatchXml, OneOfSeveralPatches) {
    const std::string many = document(
        R"(<Geometry type="BSpline" id="1"/><MultiPatch parDim="2" id="9"><patches type="id_range">10 12</patches></MultiPatch>)" +
        bilinear(unit, "10") + R"(<Geometry type="THBSpline2" id="11"/>)" +
        bilinear("5 0 6 0 5 1 6 1", "12"));
    const auto corner = [&](const std::string& which) { return parsed(many, which).control.x[0]; };
    EXPECT_EQ(corner(""), 0);
    EXPECT_EQ(corner("1"), 0);
    EXPECT_EQ(corner("2"), 5) << "the second that can be read";
    EXPECT_EQ(corner("id:12"), 5);
    const FoundPatch found = parse_patch({many, "p.xml", "2"});
    EXPECT_EQ(found.origin, "p.xml, patch 2 of 2,");
    ASSERT_NE(found.patches, nullptr);
    EXPECT_EQ(found.patches->note, "patch 2 of 2 (TensorBSpline2, id 12)");
    EXPECT_EQ(found.patches->labels,
              (std::vector<std::string>{"1: TensorBSpline2, id 10", "2: TensorBSpline2, id 12"}));
    EXPECT_EQ(found.patches->chosen, 1u);
    for (const char* none : {"0", "3", "id:13", "id:", "12", "first", "-1", "99999999999999999999"})
        EXPECT_EQ(refusal(many, none),
                  "domain.patch = '" + std::string(none) +
                      "': p.file has 2 patches; give a number from 1 to 2, or id:ID with an "
                      "id of the file");
    expect_in("MultiPatch, id 9 is a list of patches", refusal(many, "id:9"));
    expect_in("THBSpline2, id 11 is a truncated hierarchical spline", refusal(many, "id:11"));
    expect_in("BSpline, id 1 is a curve", refusal(many, "id:1"));
    EXPECT_EQ(parse_patch({document(bilinear(unit, "0")), "p.xml", "1"}).patches, nullptr);
    const std::string twice = document(bilinear(unit, "7") + bilinear("5 0 6 0 5 1 6 1", "7"));
    EXPECT_EQ(refusal(twice, "id:7"),
              "domain.patch = 'id:7': p.file has 2 patches (several of them with this "
              "id); give a number from 1 to 2");
    EXPECT_EQ(parsed(twice, "2").control.x[0], 5);
    const std::string same = document("<MultiPatch id=\"0\"/>" + bilinear(unit, "0"));
    EXPECT_EQ(flat(parsed(same, "id:0").control), unit_corners) << "ids of other elements may be the same";
}

TEST(PatchXml, OtherGeometriesAreNamed) {
    for (const auto& [element, what] : std::vector<std::pair<std::string, std::string>>{
             {R"(<Geometry type="THBSpline2"/>)", "truncated hierarchical"},
             {R"(<Geometry type="HBSpline2"/>)", "hierarchical spline"},
             {R"(<Geometry type="TensorBSpline3"/>)", "a solid"},
             {R"(<Geometry type="TensorNurbs3"/>)", "a solid"},
             {R"(<Geometry type="Nurbs"/>)", "a curve"},
             {R"(<Geometry/>)", "without type"},
             {R"(<TrimSurface>)" + bilinear(unit, "0") + "</TrimSurface>", "a trimmed surface"},
             {R"(<PlanarDomain><CurveLoop><Geometry type="BSpline"/></CurveLoop></PlanarDomain>)",
              "boundary curves"},
             {"<Solid/>", "a solid"}})
        expect_in(what, refusal(document(element)));
    EXPECT_EQ(
        refusal(document(R"(<Geometry type="BSpline" id="3"/><Geometry type="BSpline" id="4"/><Solid/>)")),
        "cannot read a patch from p.file: BSpline, id 3 is a curve, not a surface; Solid is a solid given by "
        "trimmed surfaces");
    const std::string solid =
        document(R"(<MultiPatch id="0"/><Geometry type="TensorBSpline3" id="5"/><Mesh id="6"/>)");
    for (const char* which : {"", "1", "2", "id:7", "first"})
        EXPECT_EQ(refusal(solid, which),
                  "cannot read a patch from p.file: TensorBSpline3, id 5 is a solid, not a "
                  "surface (domain.type = spline-solid reads it); Mesh, id 6 is a mesh, "
                  "not a spline");
    EXPECT_EQ(refusal(solid, "id:6"), "cannot read a patch from p.file: Mesh, id 6 is a mesh, not a spline");
}

TEST(PatchFile, KindsThatAreNotReadAreNamed) {
    for (const auto& [text, what] : std::vector<std::pair<std::string, std::string>>{
             {std::string("\x1f\x8b\x08\0", 4), "gzip-compressed"},
             {"MFEM mesh v1.0\n", "not an MFEM NURBS mesh"},
             {"ISO-10303-21;", "a STEP file"},
             {"", "it is empty"},
             {"degrees = 1", "none of the kinds"}})
        expect_in(what, refusal(text));
}

TEST(PatchFile, MisspeltKeysAreRefused) {
    const std::string disk = patch_json(nurbs_disk());
    expect_in("unknown key 'weight' (did you mean 'weights'?)", refusal(with(disk, "weights", "weight")));
    expect_in("the key 'knots' occurs twice", refusal(with(disk, "{", "{\"knots\": [],")));
    expect_in("the number 1e400 at character",
              refusal(with(disk, "\"weights\": [\n  1.0", "\"weights\": [\n  1e400")));
    expect_in("more than 100 levels", refusal(std::string(100000, '[')));
    for (const char* wrong :
         {R"({"shape": 3})", R"({"shape": {"type": 3, "data": [3]}})", R"({"SplineList": 3})",
          R"({"SplineList": [3]})", R"({"SplineList": []})", R"({"degrees": {}})", "[1]"})
        expect_in("p.file", refusal(wrong));
}

TEST(PatchFile, ATornPatchIsRefused) {
    const auto torn = [](const std::string& knots, const std::string& points) {
        return refusal(R"({"degrees": [2, 1], "knots": [)" + knots +
                       R"(, [0, 0, 1, 1]], "control_points": [)" + points + "]}");
    };
    const std::string six = "[0,0],[1,0],[2,0],[2,0],[3,0],[4,0]",
                      up = ",[0,1],[1,1],[2,1],[2,1],[3,1],[4,1]";
    EXPECT_EQ(
        torn("[0,0,0,4,4,4,8,8,8]", six + up),
        "p.file is not a valid patch: it is torn at the knot 4 of knots[0]: for degree 2 an inner knot may "
        "occur at most 2 times");
    EXPECT_NO_THROW(
        parsed(R"({"degrees": [2, 1], "knots": [[0,0,0,4,4,8,8,8], [0, 0, 1, 1]], "control_points":
        [[0,0],[1,0],[2,0],[3,0],[4,0],[0,1],[1,1],[2,1],[3,1],[4,1]]})"));
}

TEST(PatchFile, AFoldingPatchIsNamed) {
    const TemporaryFolder folder;
    std::ofstream(folder / "two.xml") << document(bilinear(unit, "3") + bilinear("0 0 1 0 1 1 0 1", "4"));
    Values values("domain", spline_domains().back().rows);
    values.set("file", std::string("two.xml"));
    const auto domain = make_spline_domain("spline-patch", values, folder.path());
    EXPECT_EQ(domain->patches()->note, "patch 1 of 2 (TensorBSpline2, id 3)");
    values.set("patch", std::int64_t{2});
    const std::string message =
        message_of<InputError>([&] { make_spline_domain("spline-patch", values, folder.path()); });
    EXPECT_TRUE(message.starts_with((folder / "two.xml").string() +
                                    ", patch 2 of 2, is not a valid patch: the map folds"))
        << message;
}

TEST(PatchText, MfemNurbsMeshes) {
    const std::string s = "0.70710678118654757";
    const std::string head =
        "MFEM NURBS mesh v1.0\n# a quarter\ndimension\n2\n\nelements\n1\n1 3 0 1 2 3\n\nboundary\n0\n"
        "edges\n4\n0 0 1\n1 1 2\n0 3 2\n1 0 3\nvertices\n4\n\n";
    const std::string knots = "knotvectors\n2\n1 2 0 0 1 1\n2 3 0 0 0 1 1 1\ndimension\n2\n";
    const std::string cartesian =
        "controlpoints_cartesian\n1 0 1\n2 0 1\n1 1 " + s + "\n2 2 " + s + "\n0 1 1\n0 2 1\n";
    expect_quarter(parsed(head + "patches\n" + knots + cartesian));
    expect_quarter(parsed(head + "patches\n" + knots + "controlpoints\n1 0 1\n2 0 1\n" + s + " " + s + " " +
                          s + "\n1.4142135623730951 1.4142135623730951 " + s + "\n0 1 1\n0 2 1\n"));
    const auto of = [&](int elements) { // in a row
        std::string text = std::to_string(elements) + "\n";
        for (int i = 0; i < elements; ++i) text += "1 3 0 1 2 3\n";
        return with(head, "1\n1 3 0 1 2 3\n", text) + "patches\n";
    };
    const std::string two = of(2) + knots + cartesian + knots + with(cartesian, "1 0 1", "1.5 0 1");
    EXPECT_EQ(parsed(two, "2").control.x[0], 1.5);
    const std::string bad =
        of(3) + knots + cartesian + knots + with(cartesian, "2 2 " + s, "2 2 -1") + knots + cartesian;
    expect_quarter(parsed(bad));
    expect_quarter(parsed(bad, "3"));
    expect_in("p.file, patch 2 of 3,", refusal(bad, "2"));
    expect_in("p.file, patch 3,", refusal(two + "x"));
    expect_in("without a section 'patches'", refusal(head + "knotvectors\n2\n"));
    expect_in("not of dimension 2", refusal(with(head, "dimension\n2", "dimension\n3")));
    expect_in("but the file ends", refusal(head + "patches\n" + knots + "controlpoints\n1 0 1\n"));
    expect_in("says that it has 2 elements, each of which is a patch, but there are 1 patches",
              refusal(of(2) + knots + cartesian));
    expect_in("'elements' is missing", refusal(with(head, "elements", "element") + "patches\n"));
}

TEST(PatchText, GeometriesOfGeoPdes) {
    const std::string s = "0.707106781186548", t = "1.414213562373095";
    const std::string body = "# the patch\nPATCH 1\n1 2\n2 3\n0 0 1 1\n0 0 0 1 1 1\n1 2 " + s + " " + t +
                             " 0 0\n0 0 " + s + " " + t + " 1 2\n1 1 " + s + " " + s + " 1 1\n";
    for (const std::string head : {"# nurbs mesh v.0.7\n#\n2 1 0 1\n", "# nurbs mesh v.2.1\n2 2 1 0 1\n"}) {
        const SplinePatch patch = parsed(head + body + "SUBDOMAIN 1\n1\n");
        for (std::size_t i = 0; i < 6; ++i) EXPECT_LT(norm(patch.control[i] - quarter().control[i]), 1e-14);
        EXPECT_NEAR(patch.weights[2], std::sqrt(0.5), 1e-14);
    }
    const std::string two = "# nurbs mesh v.0.7\n2 2\n" + body + with(body, "\n1 1 " + s, "\n1 1 -1");
    EXPECT_EQ(parsed(two).control.size(), 6u);
    expect_in("p.file, patch 2 of 2,", refusal(two, "2"));
    expect_in("of solids", refusal("# nurbs mesh v.2.1\n3 3 1\n"));
    expect_in("a coordinate must be a number",
              refusal("# nurbs mesh v.0.7\n2 1\n" + with(body, "\n1 2 ", "\nx 2 ")));
}

TEST(PatchFile, JsonOfGeomdl) { // the second direction is fastest
    const std::string text =
        R"({"shape": {"type": "surface", "count": 1, "data": [{"type": "spline", "rational": true,
        "dimension": 2, "degree_u": 1, "degree_v": 2, "knotvector_u": [0, 0, 1, 1],
        "knotvector_v": [0, 0, 0, 1, 1, 1], "size_u": 2, "size_v": 3, "control_points": {
        "points": [[1, 0], [1, 1], [0, 1], [2, 0], [2, 2], [0, 2]],
        "weights": [1, 0.7071067811865476, 1, 1, 0.7071067811865476, 1]}, "delta": [0.1, 0.1]}]}})";
    expect_quarter(parsed(text));
    expect_in("a trimmed surface",
              refusal(with(text, "\"delta\"", "\"trims\": {\"count\": 1, \"data\": []}, \"delta\"")));
    expect_in("a curve, not a surface", refusal(with(text, "\"surface\"", "\"curve\"")));
    expect_in("size_u", refusal(with(text, "\"size_u\": 2", "\"size_u\": 4")));
    expect_in("'count' is 2, but the number of entries of 'data' is 1",
              refusal(with(text, "\"count\": 1", "\"count\": 2")));
    expect_in("'dimension' is 3, but the number of coordinates of a point is 2",
              refusal(with(text, "\"dimension\": 2", "\"dimension\": 3")));
    expect_in("'rational' is false, but there are weights",
              refusal(with(text, "\"rational\": true", "\"rational\": false")));
    expect_in("'rational' is true, but there are no weights",
              refusal(with(text, "\"weights\"", "\"weight\"")));
    expect_in("'rational' must be", refusal(with(text, "\"rational\": true", "\"rational\": 1")));
    for (const char* sizes : {"\"size_u\": 4, \"size_v\": 1.5", "\"size_u\": 1.5, \"size_v\": 4"})
        expect_in("size_u and size_v", refusal(with(text, "\"size_u\": 2, \"size_v\": 3", sizes)));
}

TEST(PatchFile, JsonOfSplinepy) {
    const std::string text =
        R"({"Name": "SplineGroup", "NumberOfSplines": 2, "Base64Encoding": false, "SplineList": [
        {"SplineType": "Bezier", "degrees": [1, 1], "control_points": [[0,0],[1,0],[0,1],[1,1]], "dim": 2,
         "para_dim": 2},
        {"SplineType": "NURBS", "degrees": [1, 2], "knot_vectors": [[0,0,1,1],[0,0,0,1,1,1]],
         "control_points": [[1,0],[2,0],[1,1],[2,2],[0,1],[0,2]], "dim": 2, "para_dim": 2,
         "weights": [[1],[1],[0.7071067811865476],[0.7071067811865476],[1],[1]]}]})";
    EXPECT_EQ(flat(parsed(text).control), unit_corners);
    expect_quarter(parsed(text, "2"));
    const std::string d =
        "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAA8D8AAAAAAADwPw==";
    EXPECT_EQ(flat(parsed(with(text, "[[0,0],[1,0],[0,1],[1,1]]", "\"" + d + "\"")).control), unit_corners);
    expect_in("'dim' is 3, but the number of coordinates of a point is 2",
              refusal(with(text, "\"dim\": 2", "\"dim\": 3")));
    expect_in("'para_dim' is 3, but the number of degrees is 2",
              refusal(with(text, "\"para_dim\": 2", "\"para_dim\": 3")));
    expect_in("'NumberOfSplines' is 3, but the number of entries of 'SplineList' is 2",
              refusal(with(text, "\"NumberOfSplines\": 2", "\"NumberOfSplines\": 3")));
    expect_in("Bezier is a solid",
              refusal(R"({"SplineList": [{"SplineType": "Bezier", "degrees": [1, 1, 1]}]})"));
}

TEST(PatchFile, IsReadOnlyUpToALimit) {
    for (const char* endless : {"/dev/zero", "/dev/urandom"})
        expect_in("it is larger than 32 MiB", message_of<InputError>([&] { read_patch(endless); }));
}

TEST(PatchFile, IsJudgedInItsOwnPlane) {
    const auto patch = [](const std::string& points) {
        return R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],"control_points":[)" + points + "]}";
    };
    Values values("domain", spline_domains().back().rows);
    values.set("file", patch("[0,0,1],[1,0,1],[1,1,1],[0,1,1]")); // a bow tie at z = 1
    expect_in("the map folds", message_of<InputError>([&] { make_spline_domain("spline-patch", values); }));
    values.set("file", patch("[0,0,1],[1,0,1],[0,1,1],[1,1,1]"));
    EXPECT_NO_THROW(make_spline_domain("spline-patch", values));
    expect_in("control_points[3] must have as many coordinates", refusal(patch("[0,0],[1,0],[0,1],[1,1,5]")));
}

TEST(PatchXml, IsOneElement) {
    const std::string good = patch_xml(nurbs_disk());
    EXPECT_NO_THROW(parsed(good + "<!-- the end -->\n"));
    expect_in("outside of it", refusal(good + "garbage"));
    expect_in("more than one XML element", refusal(good + "<another/>"));
}

TEST(PatchXml, NothingIsThereTwice) {
    const std::string good = document(bilinear(unit, "0"));
    expect_in("<Geometry> has the attribute 'type' twice",
              refusal(with(good, "id=\"0\"", "id=\"0\" type=\"TensorNurbs2\"")));
    expect_in("<Geometry> has more than one <coefs>",
              refusal(with(good, "</coefs>", "</coefs><coefs geoDim=\"2\">0 0 2 0 0 2 2 2</coefs>")));
    expect_in("<Geometry> has more than one <Basis>", refusal(with(good, "<coefs", "<Basis/><coefs")));
    expect_in("<Basis> has more than one <weights>",
              refusal(with(patch_xml(nurbs_disk()), "<weights>", "<weights/><weights>")));
}

TEST(PatchXml, ADocumentTypeIsSkippedButNotItsDeclarations) {
    const auto typed = [](const std::string& type) {
        return with(document(bilinear(unit, "0")), "<xml>", "<!DOCTYPE xml" + type + "><xml>");
    };
    EXPECT_EQ(flat(parsed(typed("")).control), unit_corners);
    EXPECT_EQ(flat(parsed(typed(" SYSTEM \"gismo.dtd\"")).control), unit_corners);
    for (const char* declaration : {"<!ENTITY one \"1\">", "<!ATTLIST coefs geoDim CDATA \"2\">"})
        expect_in("its <!DOCTYPE> declares entities or attributes",
                  refusal(typed(" [" + std::string(declaration) + "]")));
}

TEST(PatchFile, AByteOrderMarkIsSkipped) {
    const std::string mark = "\xef\xbb\xbf", json = patch_json(nurbs_disk());
    EXPECT_EQ(parsed(mark + json), nurbs_disk());
    EXPECT_EQ(parsed(mark + patch_xml(nurbs_disk())), nurbs_disk());
    expect_in("it is JSON in UTF-16; save it as UTF-8", refusal(std::string("\xff\xfe{\0", 4)));
    expect_in("it is JSON in UTF-16; save it as UTF-8", refusal(std::string("\xfe\xff\0[", 4)));
}

TEST(PatchFile, ATinyPatchIsNamed) {
    const auto patch = [](const std::string& s) {
        return R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],"control_points":[[0,0],[)" + s + ",0],[0," +
               s + "],[" + s + "," + s + "]]}";
    };
    for (const char* size : {"1e-31", "1e-100", "1e-200", "1e-320"})
        expect_in("it measures only " + exact_number(*parse_number(size)) + "; the smallest size is 10⁻³⁰",
                  refusal(patch(size)));
    EXPECT_NO_THROW(parsed(patch("1.5e-30")));
}

} // namespace
} // namespace gaspard
