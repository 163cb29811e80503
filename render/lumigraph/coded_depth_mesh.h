#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "render/lumigraph/depth_mesh.h"

namespace lumi {

/// What a manifest says of a depth mesh beside its bytes; see DepthMesh.
struct CodedDepthMeshHeader {
    int columns = 0;
    int rows = 0;
    double wanted_error_px = 0.0;
    double error_px = 0.0;
    double disparity_px = 0.0;
    double min_inverse_depth = 0.0;  ///< Of its vertices.
    double max_inverse_depth = 0.0;
    int vertices = 0;
    std::array<int, kDepthKinds> triangles{};  ///< Seen, filled, stretched.
};

/// A depth mesh in 5 to 7 bytes a triangle; deflated (RFC 1950) in a package, in 4 to 5.
///
/// The bytes are the corners of one triangle after the other, three each, in numbers of 7 bits a
/// byte, low ones first, the highest bit saying that more follow (LEB128). A corner is how many
/// vertices ago its vertex was first named (1 for the last), so that it is small where triangles
/// follow one another over the picture; 0 is a new vertex. A new one goes on with its column, its
/// row and its step of inverse depth, as the differences from the new one before (from 0 for the
/// first), zigzag (0, -1, 1, -2 become 0, 1, 2, 3). Columns and rows count quarters of a sample
/// from the photograph's top left corner, so that samples, borders between them and the
/// photograph's are whole numbers; inverse depth is in even steps from the least to the largest,
/// enough of them for a 64th of a pixel of disparity each, but at most 65535.
struct CodedDepthMesh {
    CodedDepthMeshHeader header;
    std::vector<std::uint8_t> bytes;
};

/// Vertices that no triangle names are left out, and the others sorted by when they are named;
/// positions are rounded to a quarter of a sample, which changes only where triangles end at the
/// photograph's border, and inverse depths to half a step. What is decoded is coded without change.
[[nodiscard]] CodedDepthMesh encode(const DepthMesh& mesh, const Camera& camera);

/// Trusts nothing in it: counts, that vertices are named before they are used again and lie in the
/// photograph, and that the bytes end with the last triangle. Throws Error (E-PACKAGE-MESH) that
/// `where` begins.
[[nodiscard]] DepthMesh decode(const CodedDepthMesh& coded, const Camera& camera,
                               const std::string& where);

}  // namespace lumi
