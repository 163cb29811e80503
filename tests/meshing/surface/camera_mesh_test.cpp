#include "meshing/surface/camera_mesh.h"

#include <gtest/gtest.h>

#include <vector>

namespace lumi {
namespace {

TEST(CameraMesh, ItsViewsAndThoseOfItsShellsAreRenumbered) {
    CameraMesh inner;
    inner.vertices = {{{1, 0, 0}, 3}};
    CameraMesh shell;
    shell.vertices = {{{0, 1, 0}, 2}, {{0, 0, 1}, 0}};
    shell.shells = {inner};
    CameraMesh mesh;
    mesh.vertices = {{{1, 1, 0}, 0}, {{0, 1, 1}, 1}, {{1, 0, 1}, 0, true}};
    mesh.faces = {{0, 1, 2}};
    mesh.shells = {shell};
    renumber_views(mesh, {5, 0, 7, 1});
    EXPECT_EQ(mesh.vertices[0].view_index, 5);
    EXPECT_EQ(mesh.vertices[1].view_index, 0);
    EXPECT_EQ(mesh.vertices[2].view_index, 5) << "several vertices may name one view";
    EXPECT_EQ(mesh.shells[0].vertices[0].view_index, 7);
    EXPECT_EQ(mesh.shells[0].vertices[1].view_index, 5);
    EXPECT_EQ(mesh.shells[0].shells[0].vertices[0].view_index, 1);
    EXPECT_EQ(mesh.faces, (std::vector<CameraMesh::Face>{{0, 1, 2}})) << "faces name vertices";
}

}  // namespace
}  // namespace lumi
