// SPDX-License-Identifier: Apache-2.0
#include "render/colours/transfer_function_json.h"

#include "base/error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <fstream>

namespace vs::render {
namespace {

using Json = nlohmann::ordered_json;

TransferFunction someCurve() {
    TransferFunction f;
    f.name = "name \"quoted\"";
    f.description = "description";
    f.kind = FunctionKind::Gradient;
    f.positions = Positions::Landmarks;
    f.suits = {Mode::Mip, false, field::Sampling::Tricubic};
    f.unitMm = 0.3;
    f.lighting = {0.25, 1.0 / 3};
    f.points = {{-1.0 / 3, 0, {1, 2, 3}}, {0.1, 0.7, {255, 254, 0}}, {0.1, 1, {}}};
    return f;
}

TransferFunction somePlane() {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    f.positions = Positions::Relative;
    f.combine = Combine::Max;
    f.shapes = {{Trapezoid{{0, 0.1}, {0, 0.1}, {0, 1}, {0.2, 0.3}}, {1, 2, 3}, 0.4},
                {Trapezoid{{0.1, 0.1}, {0, 1.0 / 7}, {-1, 1}, {1, 0}}, {4, 5, 6}, 1},
                {Painting{{0, 1}, {0, 2}, {3, 2}, {0, 1, 2, 253, 254, 255}}, {7, 8, 9}, 0.5}};
    return f;
}

TEST(TransferFunctionJson, EveryKindComesBackAsItWas) {
    TransferFunction mapped = someCurve();
    mapped.kind = FunctionKind::Intensity;
    mapped.colours = SpreadColours{"tide", {-5, 1.0 / 3}};
    for (ControlPoint& point : mapped.points) {
        point.colour = ControlPoint().colour;
    }
    const auto path =
        std::filesystem::temp_directory_path() / fmt::format("vs_transfer_function_{}.json", getpid());
    for (const TransferFunction& f : {someCurve(), mapped, somePlane()}) {
        saveTransferFunction(path, f);
        EXPECT_EQ(loadTransferFunction(path), f);
        EXPECT_EQ(transferFunctionFromArgument(path.string()), f);
    }
    std::filesystem::remove(path);
}

std::string complaint(const std::string& text) {
    try {
        transferFunctionFromJson(Json::parse(text), "f.json");
    } catch (const SessionError& error) {
        return error.what();
    }
    return "accepted";
}

// A whole file around some members.
std::string curve(const std::string& members) {
    return R"({"volumeStudioTransferFunction":1,"kind":"intensity",)" + members + "}";
}

std::string plane(const std::string& shape) {
    return R"({"volumeStudioTransferFunction":1,"kind":"two-dimensional","shapes":[)" + shape + "]}";
}

TEST(TransferFunctionJson, ComplaintsNameThePlaceAndWhatWouldBeRight) {
    EXPECT_EQ(complaint("{}"), "f.json: the member 'volumeStudioTransferFunction' is missing");
    EXPECT_EQ(
        complaint(R"({"volumeStudioTransferFunction":2})"),
        "f.json: volumeStudioTransferFunction: made by a newer Volume Studio (this program knows version "
        "1); update it");
    EXPECT_EQ(complaint(curve(R"("points":[{"at":0,"opacity":2,"colour":"#000000"}])")),
              "f.json: points[0].opacity: 2 is out of bounds; 0 to 1 is allowed");
    EXPECT_EQ(complaint(curve(R"("points":[{"at":0,"opacity":1,"colour":"red"}])")),
              "f.json: points[0].colour: 'red' is no colour; write #rrggbb (hexadecimal, display sRGB)");
    EXPECT_EQ(complaint(curve(R"("suits":{"mode":"xrays"})")),
              "f.json: suits.mode: 'xrays' is not known; choose one of surface, mip, xray, overlay, segment, "
              "volume");
    EXPECT_EQ(complaint(curve(R"("points":[])")), "f.json: points: has 0 points; 1 to 4096 are allowed");
    EXPECT_EQ(complaint(curve(R"("points":[{"at":5,"opacity":1,"colour":"#000000"},
                                           {"at":4,"opacity":1,"colour":"#000000"}])")),
              "f.json: points[1].at: 4 is below the point before it (5); points must ascend");
    EXPECT_EQ(
        complaint(curve(R"("colourMap":{"name":"rainbow","range":[0,1]},"points":[])")),
        "f.json: colourMap.name: 'rainbow' is not known; choose one of grey, ivory, ember, marine, flesh, "
        "vessel, tide");
    EXPECT_EQ(complaint(curve(R"("colourMap":{"name":"grey","range":[0,1]},
                                 "points":[{"at":0,"opacity":1,"colour":"#000000"}])")),
              "f.json: points[0]: the member 'colour' is not known here; known are at, opacity");
    EXPECT_EQ(complaint(curve(R"("shapes":[])")).substr(0, 58),
              "f.json: the member 'shapes' is not known here; known are v");
    EXPECT_EQ(complaint(plane(R"({"shape":"disc"})")),
              "f.json: shapes[0].shape: 'disc' is not known; choose one of box, trapezoid, painting");
    EXPECT_EQ(complaint(plane(
                  R"({"shape":"box","values":[2,1],"gradients":[0,1],"colour":"#000000","opacity":1})")),
              "f.json: shapes[0].values: its first number must not be above its second");
    EXPECT_EQ(complaint(plane(R"({"shape":"painting","values":[0,1],"gradients":[0,1],"colour":"#000000",
                                  "opacity":1,"cells":[[1,2],[3]]})")),
              "f.json: shapes[0].cells[1]: must be a list of 2 numbers");
    EXPECT_EQ(complaint(plane(R"({"shape":"painting","values":[0,1],"gradients":[0,1],"colour":"#000000",
                                  "opacity":1,"cells":[[256]]})")),
              "f.json: shapes[0].cells[0][0]: 256 is out of bounds; 0 to 255 is allowed");
}

TEST(TransferFunctionJson, WhatAnotherKindHasIsRefused) {
    const std::string shape =
        R"({"shape":"box","values":[0,1],"gradients":[0,1],"colour":"#000000","opacity":1)";
    EXPECT_EQ(complaint(plane(shape + "}")), "accepted");
    EXPECT_EQ(
        complaint(plane(shape + R"(,"base":[0,1]})")),
        "f.json: shapes[0]: the member 'base' is not known here; known are shape, values, gradients, soft, "
        "colour, opacity");
    EXPECT_EQ(complaint(R"({"volumeStudioTransferFunction":1,"kind":"two-dimensional","points":[]})"),
              "f.json: the member 'points' is not known here; known are volumeStudioTransferFunction, name, "
              "description, kind, positions, unitMm, lighting, suits, combine, shapes");
    EXPECT_EQ(complaint(curve(R"("combine":"max")")),
              "f.json: the member 'combine' is not known here; known are volumeStudioTransferFunction, name, "
              "description, kind, positions, unitMm, lighting, suits, colourMap, points");
    EXPECT_EQ(complaint(R"({"volumeStudioTransferFunction":1,"kinds":"gradient"})"),
              "f.json: the member 'kinds' is not known here; known are volumeStudioTransferFunction, name, "
              "description, kind, positions, unitMm, lighting, suits, combine, shapes, colourMap, points");
}

TEST(TransferFunctionJson, FilesAreWrittenInTheirOrder) {
    EXPECT_EQ(toJson(somePlane()).dump(),
              R"({"volumeStudioTransferFunction":1,"name":"","description":"","kind":"two-dimensional",)"
              R"("positions":"relative","lighting":{"amount":1.0,"gloss":0.12},"combine":"max","shapes":[)"
              R"({"shape":"box","values":[0.0,0.1],"gradients":[0.0,1.0],"soft":[0.2,0.3],)"
              R"("colour":"#010203","opacity":0.4},)"
              R"({"shape":"trapezoid","base":[0.1,0.1],"top":[0.0,0.14285714285714285],)"
              R"("gradients":[-1.0,1.0],"soft":[1.0,0.0],"colour":"#040506","opacity":1.0},)"
              R"({"shape":"painting","values":[0.0,1.0],"gradients":[0.0,2.0],)"
              R"("cells":[[0,1,2],[253,254,255]],"colour":"#070809","opacity":0.5}]})");
}

TEST(TransferFunctionJson, WhatIsNeitherFileNorPresetIsToldWithTheList) {
    try {
        transferFunctionFromArgument("ct_bones");
        FAIL();
    } catch (const UsageError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("transfer function 'ct_bones' is neither a file nor a preset; presets are "),
                  0U);
        for (const std::string& name : presetNames()) {
            EXPECT_NE(message.find(name), std::string::npos);
        }
    }
}

TEST(TransferFunctionJson, EveryPresetIsReadAndShowsSomething) {
    const auto names = presetNames();
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const char* wanted :
         {"ct_bone", "ct_soft_tissue", "ct_skin", "ct_vessels", "mr_t1_head", "mr_angiography", "microscopy",
          "grey_ramp", "edges", "ct_bone_2d", "mr_t1_2d"}) {
        EXPECT_NE(std::find(names.begin(), names.end(), wanted), names.end()) << wanted;
    }
    for (const std::string& name : names) {
        const TransferFunction f = transferFunctionFromArgument(name);
        EXPECT_FALSE(f.name.empty()) << name;
        EXPECT_FALSE(f.description.empty()) << name;
        const bool isOpaque =
            std::any_of(f.points.begin(), f.points.end(), [](const auto& p) { return p.opacity > 0.2; }) ||
            std::any_of(f.shapes.begin(), f.shapes.end(), [](const auto& s) { return s.opacity > 0.2; });
        EXPECT_TRUE(isOpaque) << name;
        EXPECT_EQ(
            f, loadTransferFunction(VOLUME_STUDIO_SOURCE_DIR "/data/transfer_functions/" + name + ".json"));
    }
}

} // namespace
} // namespace vs::render
