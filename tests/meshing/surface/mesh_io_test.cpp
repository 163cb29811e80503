#include "meshing/surface/mesh_io.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

class CameraMeshFile : public testing::Test {
 protected:
    [[nodiscard]] std::filesystem::path path() const { return scratch_ / "camera_mesh.ply"; }

 private:
    ScratchFolder scratch_;
};

CameraMesh tiny_mesh() {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kOpen;
    mesh.scene_centre_in_world = {1.0 / 3, -2e-7, 12345.678901234567};
    mesh.vertices = {
        {{0.1, 0.2, 0.3}, 4}, {{1e-9, 1e9, -7}, 0}, {{5, 6, 7}, 4}, {{8, 9, 1}, 2, true}};
    mesh.faces = {{0, 1, 2}, {2, 1, 3}};
    return mesh;
}

TEST_F(CameraMeshFile, KeepsEveryBit) {
    const CameraMesh mesh = tiny_mesh();
    write_camera_mesh_ply(path(), mesh);
    const CameraMesh again = read_camera_mesh_ply(path());
    EXPECT_EQ(again.construction, mesh.construction);
    EXPECT_EQ(again.scene_centre_in_world, mesh.scene_centre_in_world);
    EXPECT_EQ(again.faces, mesh.faces);
    ASSERT_EQ(again.vertices.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_EQ(again.vertices[i].position_in_world, mesh.vertices[i].position_in_world);
        EXPECT_EQ(again.vertices[i].view_index, mesh.vertices[i].view_index);
        EXPECT_EQ(again.vertices[i].is_virtual, mesh.vertices[i].is_virtual);
    }
}

TEST_F(CameraMeshFile, KeepsLinesOfSightOfCamerasWithoutASurface) {
    CameraMesh mesh = tiny_mesh();
    mesh.construction = MeshConstruction::kNearest;
    mesh.faces.clear();
    for (CameraMesh::Vertex& vertex : mesh.vertices)
        vertex.line_of_sight_in_world = vertex.position_in_world.normalized();
    write_camera_mesh_ply(path(), mesh);
    const CameraMesh again = read_camera_mesh_ply(path());
    EXPECT_EQ(again.construction, mesh.construction);
    ASSERT_EQ(again.vertices.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_EQ(again.vertices[i].position_in_world, mesh.vertices[i].position_in_world);
        EXPECT_EQ(again.vertices[i].view_index, mesh.vertices[i].view_index);
        EXPECT_EQ(again.vertices[i].line_of_sight_in_world,
                  mesh.vertices[i].line_of_sight_in_world);
    }
}

TEST_F(CameraMeshFile, OfAWalkForwardIsReadAsOfTheNearest) {
    CameraMesh mesh = tiny_mesh();
    mesh.construction = MeshConstruction::kSingle;
    mesh.faces.clear();
    const Bytes bytes = camera_mesh_ply(mesh);
    std::string text(bytes.begin(), bytes.end());
    const std::string name = "construction single";
    text.replace(text.find(name), name.size(), "construction forward");
    const CameraMesh again = parse_camera_mesh_ply(Bytes(text.begin(), text.end()), "walk.ply");
    EXPECT_EQ(again.construction, MeshConstruction::kNearest);
    ASSERT_EQ(again.vertices.size(), mesh.vertices.size());
    EXPECT_TRUE(again.vertices[0].line_of_sight_in_world.isZero());
}

TEST_F(CameraMeshFile, KeepsShellsApart) {
    CameraMesh mesh = tiny_mesh();
    mesh.shells = {tiny_mesh(), tiny_mesh()};
    mesh.shells[1].vertices.emplace_back(CameraMesh::Vertex{{7, 7, 7}, 1});
    mesh.shells[1].faces = {{4, 0, 1}};
    write_camera_mesh_ply(path(), mesh);
    const CameraMesh again = read_camera_mesh_ply(path());
    EXPECT_EQ(again.faces, mesh.faces);
    ASSERT_EQ(again.shells.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(again.shells[i].construction, mesh.shells[i].construction);
        EXPECT_EQ(again.shells[i].scene_centre_in_world, mesh.shells[i].scene_centre_in_world);
        EXPECT_EQ(again.shells[i].faces, mesh.shells[i].faces);
        ASSERT_EQ(again.shells[i].vertices.size(), mesh.shells[i].vertices.size());
        EXPECT_EQ(again.shells[i].vertices.back().position_in_world,
                  mesh.shells[i].vertices.back().position_in_world);
    }
}

TEST_F(CameraMeshFile, IsRefusedWhoseShellsTakeMoreThanThereIs) {
    CameraMesh mesh = tiny_mesh();
    mesh.shells = {tiny_mesh()};
    Bytes bytes = camera_mesh_ply(mesh);
    std::string text(bytes.begin(), bytes.end());
    const std::size_t at = text.find(" 4 2\nelement");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 4, " 9 2");
    EXPECT_THROW(static_cast<void>(parse_camera_mesh_ply(Bytes(text.begin(), text.end()), path())),
                 Error);
    text.replace(at, 4, " 3 2");  // The shell's faces then name a vertex of the mesh.
    EXPECT_THROW(static_cast<void>(parse_camera_mesh_ply(Bytes(text.begin(), text.end()), path())),
                 Error);
}

/// As files were written before vertices said whether they are virtual.
TEST_F(CameraMeshFile, IsReadWithoutVirtualVerticesToo) {
    const CameraMesh mesh = tiny_mesh();
    write_camera_mesh_ply(path(), mesh);
    std::string text = read_whole_text(path());
    const std::string line = "property uchar virtual\n";
    text.erase(text.find(line), line.size());
    std::size_t vertex_end = text.find("end_header\n") + 11;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        vertex_end += 3 * sizeof(double) + sizeof(std::int32_t);
        text.erase(vertex_end, 1);
    }
    write_whole_text(path(), text);
    const CameraMesh again = read_camera_mesh_ply(path());
    EXPECT_EQ(again.faces, mesh.faces);
    ASSERT_EQ(again.vertices.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_EQ(again.vertices[i].position_in_world, mesh.vertices[i].position_in_world);
        EXPECT_FALSE(again.vertices[i].is_virtual);
    }
}

TEST_F(CameraMeshFile, RefusesEveryTruncation) {
    write_camera_mesh_ply(path(), tiny_mesh());
    const Bytes bytes = read_whole_file(path());
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const Bytes beginning(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_THROW((void)parse_camera_mesh_ply(beginning, path()), Error) << "length " << length;
    }
}

TEST_F(CameraMeshFile, RefusesCountsBeyondItsSizeAndIndicesBeyondItsCounts) {
    write_camera_mesh_ply(path(), tiny_mesh());
    const std::string whole = read_whole_text(path());
    const auto refused_with = [&](const std::string& from, const std::string& to) {
        std::string damaged = whole;
        damaged.replace(damaged.find(from), from.size(), to);
        write_whole_text(path(), damaged);
        EXPECT_THROW((void)read_camera_mesh_ply(path()), Error) << from << " -> " << to;
    };
    refused_with("element vertex 4", "element vertex 4611686018427387904");
    refused_with("element vertex 4", "element vertex -1");
    refused_with("element face 2", "element face 3");
    refused_with("property double x", "property float x");
    refused_with("construction open", "construction round");
    refused_with(std::string("\x03\x02\x00\x00\x00", 5), std::string("\x03\x04\x00\x00\x00", 5));
}

}  // namespace
}  // namespace lumi
