// SPDX-License-Identifier: MIT
#include "core/cloud/MeshIo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

TriangleMesh tetrahedron() {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 0.5}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    return mesh;
}

/// The corners of every triangle, whatever the numbering of the vertices.
std::vector<Eigen::Vector3d> corners(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3d> result;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            result.push_back(mesh.vertices.at(index));
    return result;
}

TEST(MeshIo, IsReadBackFromEveryFormat) {
    const TemporaryFolder folder;
    for (const char* name : {"a.ply", "a.stl", "a.obj", "a.STL"}) {
        writeMesh(folder / name, tetrahedron());
        const TriangleMesh again = readMesh(folder / name);
        EXPECT_EQ(corners(again), corners(tetrahedron())) << name;
        EXPECT_EQ(again.vertices.size(), 4u) << name;
        EXPECT_TRUE(isMeshFile(folder / name)) << name;
    }
    TriangleMesh coloured = tetrahedron();
    coloured.colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {255, 0, 128}};
    writeMesh(folder / "c.ply", coloured);
    EXPECT_EQ(readMesh(folder / "c.ply").colours, coloured.colours);
}

TEST(MeshIo, IsScaledIntoMetres) {
    const TemporaryFolder folder;
    writeMesh(folder / "a.obj", tetrahedron());
    EXPECT_DOUBLE_EQ(readMesh(folder / "a.obj", 0.001).vertices[2].y(), 0.002);
    for (const double scale : {0.0, -1.0, std::nan("")})
        expectError([&] { readMesh(folder / "a.obj", scale); }, "scale");
}

TEST(MeshIo, FansPolygonsAndCountsObjIndicesFromTheEndToo) {
    const TemporaryFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\nvn 0 0 1\n";
    const auto forward = folder.write("f.obj", "# quad\n" + vertices + "f 1/1/1 2//1 3 4/2\n");
    const auto backward = folder.write("b.obj", vertices + "f -4 -3 -2 -1\n");
    const auto ply = folder.write("q.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                  "property float z\nelement face 1\nproperty uchar flag\n"
                                  "property list uchar uint vertex_index\nend_header\n"
                                  "0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 4 0 1 2 3\n");
    for (const auto& file : {forward, backward, ply}) {
        EXPECT_EQ(readMesh(file).triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}})) << file;
    }
}

TEST(MeshIo, ReadsAsciiStlAndJoinsEqualVertices) {
    const TemporaryFolder folder;
    const std::string facet =
        "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 -0.0\n endloop\nendfacet\n";
    const auto file = folder.write("a.stl", "solid vertex of a tank\n" + facet + facet + "endsolid vertex of a tank\n");
    const TriangleMesh mesh = readMesh(file);
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(MeshIo, ReadsBinaryStlThatBeginsWithSolid) {
    const TemporaryFolder folder;
    writeMesh(folder / "a.stl", tetrahedron());
    std::string bytes = readTextFile(folder / "a.stl");
    bytes.replace(0, 12, "solid facet ");
    EXPECT_EQ(readMesh(folder.write("s.stl", bytes)).triangles.size(), 4u);
}

TEST(MeshIo, TellsWhatIsWrongWithAFile) {
    const TemporaryFolder folder;
    const auto expect = [&](const std::string& name, const std::string& bytes, const std::string& words) {
        const auto file = folder.write(name, bytes);
        expectError([&] { readMesh(file); }, words);
        expectError([&] { readMesh(file); }, name);
    };
    expectError([&] { readMesh(folder / "missing.stl"); }, "no such file");
    expect("empty.stl", "", "is empty");
    expect("text.txt", "no mesh at all\n", "is no mesh");
    expect("short.stl", "abc", "is truncated");
    expect("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", "is truncated");
    expect("open.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "is truncated");
    expect("two.stl", "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n", "three vertices");
    expect("word.stl", "solid a\nfacet\nvertex 0 zero 0\n", "is not a coordinate");
    expect("none.stl", "solid a\nendsolid a\n", "holds no triangles");
    expect("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "does not exist");
    expect("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "does not exist");
    expect("word.obj", "v 0 0 0\nf a b c\n", "does not exist");
    expect("line.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "fewer than three");
    expect("cut.obj", "v 0 0\n", "lacks a coordinate");
    expect("points.obj", "v 0 0 0\n", "holds no triangles");
    expect("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "is not finite");
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    expect("cloud.ply", ply + "end_header\n" + vertices, "holds no triangles");
    expect("range.ply", ply + faces + vertices + "3 0 1 3\n", "does not exist");
    expect("minus.ply", ply + faces + vertices + "3 0 1 -1\n", "does not exist");
    expect("cut.ply", ply + faces + vertices, "is truncated");
    std::string hostile(80, ' ');
    hostile += "\xff\xff\xff\xff";
    expect("hostile.stl", hostile + std::string(100, 'x'), "is truncated");
}

TEST(MeshIo, TellsMeshesFromClouds) {
    const TemporaryFolder folder;
    PointCloud cloud;
    cloud.points = {{1.0, 2.0, 3.0}};
    writePointCloud(folder / "a.ply", cloud);
    writePointCloud(folder / "a.pcd", cloud);
    EXPECT_FALSE(isMeshFile(folder / "a.ply"));
    EXPECT_FALSE(isMeshFile(folder / "a.pcd"));
    EXPECT_FALSE(isMeshFile(folder / "missing.stl"));
    EXPECT_FALSE(isMeshFile(folder.write("cut.stl", "abc")));
    EXPECT_FALSE(isMeshFile(folder.write("cut.ply", "ply\nformat")));
    expectError([&] { writeMesh(folder / "a.txt", tetrahedron()); }, "no extension of a mesh");
}

}  // namespace
}  // namespace fodscope
