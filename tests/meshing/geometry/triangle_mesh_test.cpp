#include "meshing/geometry/triangle_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/geometry/mesh_depth.h"
#include "meshing/geometry/triangle_mesh_writing.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

std::string code_of_reading(const std::filesystem::path& path) {
    try {
        (void)read_triangle_mesh(path);
    } catch (const Error& error) {
        return error.code();
    }
    return "none";
}

TEST(TriangleMesh, PlyKeepsEveryBit) {
    const ScratchFolder folder;
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 1}, {1.25, 0, 2}, {0, double{1e-7F}, 3}, {4, 5, 6}};
    mesh.faces = {{0, 1, 2}, {2, 1, 3}};
    write_triangle_mesh_ply(folder.path() / "m.ply", mesh);
    const TriangleMesh read = read_triangle_mesh(folder.path() / "m.ply");
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.faces, mesh.faces);
    mesh.normals.assign(4, {0, 0, -1});
    mesh.colors.assign(4, {1, 2, 3});
    write_triangle_mesh_ply(folder.path() / "n.ply", mesh);
    EXPECT_EQ(read_triangle_mesh(folder.path() / "n.ply").vertices, mesh.vertices);
    EXPECT_EQ(read_triangle_mesh(folder.path() / "n.ply").faces, mesh.faces);
}

TEST(TriangleMesh, APlyFileHoldsDoublesOnlyWhereFloatsWouldChangeTheTriangles) {
    const ScratchFolder folder;
    const auto path = folder.path() / "m.ply";
    const Eigen::Vector3d far_away(500000, 5400000, 300);
    TriangleMesh mesh;
    mesh.vertices = {{0.1, 0.2, 1}, {0.11, 0.2, 1}, {0.1, 0.21, 1.001}};
    mesh.faces = {{0, 1, 2}};
    write_triangle_mesh_ply(path, mesh);
    EXPECT_THAT(read_whole_text(path), testing::HasSubstr("property float x\n"));
    EXPECT_LT((read_triangle_mesh(path).vertices[2] - mesh.vertices[2]).norm(), 1e-7);
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex += far_away;
    write_triangle_mesh_ply(path, mesh);
    EXPECT_THAT(read_whole_text(path), testing::HasSubstr("property double x\n"));
    EXPECT_EQ(read_triangle_mesh(path).vertices, mesh.vertices);
}

TEST(TriangleMesh, ReadsBinaryPlyOfEitherByteOrderWithPolygonsAndMore) {
    const ScratchFolder folder;
    for (const bool is_big : {false, true}) {
        const std::string header =
            std::string("ply\nformat binary_") + (is_big ? "big" : "little") +
            "_endian 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double "
            "z\nproperty uchar red\nelement face 2\nproperty float quality\n"
            "property list uchar ushort vertex_index\nelement edge 1\nproperty int a\nend_header\n";
        Bytes bytes(header.begin(), header.end());
        const auto append = [&](auto number) {
            std::array<std::uint8_t, sizeof(number)> raw;
            std::memcpy(raw.data(), &number, raw.size());
            if (is_big) std::reverse(raw.begin(), raw.end());
            bytes.insert(bytes.end(), raw.begin(), raw.end());
        };
        for (int i = 0; i < 5; ++i) {
            for (const double place : {0.5 * i, -1.0 * i, 1e-3 * i}) append(place);
            append(std::uint8_t{7});
        }
        const std::vector<std::vector<std::uint16_t>> polygons{{0, 1, 2, 3, 4}, {4, 2, 0}};
        for (const auto& polygon : polygons) {
            append(0.25F);
            append(static_cast<std::uint8_t>(polygon.size()));
            for (const std::uint16_t index : polygon) append(index);
        }
        append(std::int32_t{1});
        write_whole_file(folder.path() / "m.ply", bytes);
        const TriangleMesh mesh = read_triangle_mesh(folder.path() / "m.ply");
        ASSERT_EQ(mesh.vertices.size(), 5U);
        EXPECT_EQ(mesh.vertices[4], Eigen::Vector3d(2, -4, 4e-3));
        EXPECT_EQ(mesh.faces, (std::vector<std::array<std::uint32_t, 3>>{
                                  {0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 2, 0}}));
        bytes.resize(bytes.size() - 10);
        write_whole_file(folder.path() / "m.ply", bytes);
        EXPECT_EQ(code_of_reading(folder.path() / "m.ply"), "E-GEOMETRY-READ") << "ends early";
    }
}

TEST(TriangleMesh, RefusesWhatAnObjFileCannotMean) {
    const ScratchFolder folder;
    const auto path = folder.path() / "m.obj";
    const std::string vertices = "v 0 0 1\nv 1 0 1\nv 0 1 1\n";
    for (const char* wrong :
         {"f 1 2 0\n", "f 1 2 -4\n", "f 1 2 4\n", "f 1 2 x\n", "v 1 nan 1\nf 1 2 3\n",
          "v 1 1\nf 1 2 3\n", "v 1 1 inf\nf 1 2 3\n", "v 1 1 1e39\nf 1 2 3\n"}) {
        write_whole_text(path, vertices + wrong);
        EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-READ") << wrong;
    }
    write_whole_text(path, vertices + "f 1 2\n");
    EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-EMPTY") << "an edge is no triangle";
}

TEST(TriangleMesh, ReadsTextPlyAndObjWithPolygons) {
    const ScratchFolder folder;
    write_whole_text(folder.path() / "m.ply",
                     "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement vertex 4\r\nproperty float x"
                     "\r\nproperty float y\r\nproperty float z\r\nproperty uchar red\r\n"
                     "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
                     "0 0 1 9\r\n1 0 1 9\r\n1 1 1 9\r\n0 1 1 9\r\n4 0 1 2 3\r\n");
    write_whole_text(folder.path() / "m.obj",
                     "# x\no thing\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvt 0 0\n"
                     "f 1/1/1 2//1 3 -1\n");
    for (const char* name : {"m.ply", "m.obj"}) {
        const TriangleMesh mesh = read_triangle_mesh(folder.path() / name);
        ASSERT_EQ(mesh.vertices.size(), 4) << name;
        ASSERT_EQ(mesh.faces.size(), 2) << name;
        EXPECT_EQ(mesh.faces[1], (std::array<std::uint32_t, 3>{0, 2, 3})) << name;
    }
}

TEST(TriangleMesh, ReadsObjWithCommentsBehindItsNumbersAndANameInCapitals) {
    const ScratchFolder folder;
    write_whole_text(folder.path() / "M.OBJ",
                     "v 0 0 1 # first\nv 1 0 1\nv 0 1 1\nf 1 2 3 # the only one\n");
    const TriangleMesh mesh = read_triangle_mesh(folder.path() / "M.OBJ");
    EXPECT_EQ(mesh.vertices.size(), 3);
    EXPECT_EQ(mesh.faces, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
}

TEST(TriangleMesh, NumbersMayHaveAPlusSignButNotTwoSigns) {
    const ScratchFolder folder;
    const auto path = folder.path() / "m.obj";
    write_whole_text(path, "v +1 -2 +3e+0\nv 4 5 6\nv 7 8 10\nf 1 2 3\n");
    EXPECT_EQ(read_triangle_mesh(path).vertices.front(), Eigen::Vector3d(1, -2, 3));
    for (const char* wrong : {"+-1", "++1", "+"}) {
        write_whole_text(path, std::string("v ") + wrong + " 2 3\nv 4 5 6\nv 7 8 10\nf 1 2 3\n");
        EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-READ") << wrong;
    }
}

TEST(TriangleMesh, AnObjFileMayBeginWithAByteOrderMark) {
    const ScratchFolder folder;
    const auto path = folder.path() / "m.Obj";
    write_whole_text(path, "\xEF\xBB\xBFv 1 2 3\nv 4 5 6\nv 7 8 10\nv 0 0 1\nf 1 2 3\n");
    const TriangleMesh mesh = read_triangle_mesh(path);
    ASSERT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(1, 2, 3));
}

TEST(TriangleMesh, RefusesWhatLies) {
    const ScratchFolder folder;
    const auto path = folder.path() / "m.ply";
    const std::string head = "ply\nformat ascii 1.0\nelement vertex ";
    write_whole_text(path, head + "99999999999\nproperty float x\nend_header\n1\n");
    EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-READ");
    write_whole_text(path, head + "2\nproperty float x\nend_header\n1\n");
    EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-READ") << "ends early";
    write_whole_text(path, head + "1\nproperty float x\nend_header\nnan\n");
    EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-READ") << "not finite";
    write_whole_text(path, head + "1\nproperty float x\nend_header\n1\n");
    EXPECT_EQ(code_of_reading(path), "E-GEOMETRY-EMPTY");
    write_whole_text(folder.path() / "m.obj", "v 0 0 1\nf 1 1 7\n");
    EXPECT_EQ(code_of_reading(folder.path() / "m.obj"), "E-GEOMETRY-READ") << "index";
    write_whole_text(folder.path() / "m.stl", "solid\n");
    EXPECT_EQ(code_of_reading(folder.path() / "m.stl"), "E-GEOMETRY-READ");
}

TEST(MeshDepth, EqualsTheRayCastOfTheSamePlanes) {
    // A slanted wall as two large triangles that reach behind the camera, and a board before it.
    const auto board = [](const Eigen::Vector3d& p) {
        return p.x() > -0.3 && p.x() < 0.3 && p.y() > -0.2 && p.y() < 0.2;
    };
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 3}, {1, 0, 1}, [](const auto&) { return true; }, noise_texture(0.1, 5)},
         {{0, 0, 1.8}, {0, 0, 1}, board, noise_texture(0.1, 8)}},
        {{0, 0, 0}, {0.1, 0.05, 0}}, {});
    TriangleMesh mesh;
    mesh.vertices = {{-9, -9, 12},      {-9, 9, 12},      {9, -9, -6},      {9, 9, -6},
                     {-0.3, -0.2, 1.8}, {0.3, -0.2, 1.8}, {-0.3, 0.2, 1.8}, {0.3, 0.2, 1.8}};
    mesh.faces = {{0, 1, 2}, {2, 1, 3}, {4, 6, 5}, {5, 6, 7}};
    for (std::size_t i = 0; i < 2; ++i) {
        const DepthMap map = mesh_depth(known.scene.views[i], mesh);
        int different = 0;
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 240; ++x) {
                ASSERT_EQ(map.confidence(x, y), 255);
                if (std::abs(map.inverse_depth(x, y) - known.inverse_depths[i](x, y)) > 1e-5F) {
                    ++different;
                }
            }
        }
        EXPECT_LE(different, 4) << "pixels whose centre lies on the board's edge";
    }
}

TEST(MeshDepth, IsTheSameFarFromTheOriginByWayOfAFile) {
    const ScratchFolder folder;
    // Up to the last of these decimals an OBJ file of a surveyed world tells places.
    write_whole_text(folder.path() / "home.obj",
                     "v -0.512 -0.301 2.125\nv 0.498 -0.287 1.875\nv 0.013 0.442 3.001\nf 1 2 3\n");
    write_whole_text(folder.path() / "far.obj",
                     "v 499999.488 5399999.699 302.125\nv 500000.498 5399999.713 301.875\n"
                     "v 500000.013 5400000.442 303.001\nf 1 2 3\n");
    DepthView view;
    view.camera = small_camera();
    const DepthMap home = mesh_depth(view, read_triangle_mesh(folder.path() / "home.obj"));
    view.cam_from_world.translation = -Eigen::Vector3d(500000, 5400000, 300);
    const DepthMap far = mesh_depth(view, read_triangle_mesh(folder.path() / "far.obj"));
    EXPECT_EQ(far.confidence, home.confidence);
    for (std::size_t i = 0; i < home.inverse_depth.pixels().size(); ++i) {
        ASSERT_NEAR(far.inverse_depth.pixels()[i], home.inverse_depth.pixels()[i], 1e-6F);
    }
}

TEST(MeshDepth, BesideTheMeshNothingIsKnown) {
    DepthView view;
    view.camera = small_camera();
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 2}, {0.1, 0, 2}, {0, 0.1, 2}};
    mesh.faces = {{0, 1, 2}};
    const DepthMap map = mesh_depth(view, mesh);
    EXPECT_EQ(map.confidence(2, 2), 0);
    EXPECT_EQ(map.confidence(122, 92), 255);
    EXPECT_FLOAT_EQ(map.inverse_depth(122, 92), 0.5F);
    mesh.vertices = {{0, 0, -2}, {1, 0, -2}, {0, 1, -2}};
    EXPECT_EQ(mesh_depth(view, mesh).confidence, GrayImage(240, 180)) << "behind the camera";
}

TEST(MeshDepth, OneStrayVertexFarAwayHidesNothing) {
    DepthView view;
    view.camera = small_camera();
    TriangleMesh mesh;
    mesh.vertices = {{-2, -2, 1}, {2, -2, 1}, {2, 2, 1}, {-2, 2, 1}, {0, 0, 1e9}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(mesh_depth(view, mesh).confidence, GrayImage(240, 180, 255)) << "of no triangle";
    mesh.faces.push_back({0, 1, 4});
    EXPECT_EQ(mesh_depth(view, mesh).confidence, GrayImage(240, 180, 255)) << "of one";
}

}  // namespace
}  // namespace lumi
