#include "render/depth_layers/layer_rows.h"

#include <cstddef>

#include "calib/capture/inverse_depth_warp.h"
#include "render/gl/to_glm.h"
#include "render/transfer/past_sight.h"

namespace lumi {
namespace {

/// The three that take (x, y, 1, inverse depth) in a window of this height to the target.
void append_transfer(const InverseDepthWarp& target_from_eye, int height_px, LayerRows& rows) {
    const Eigen::Matrix3d target_from_window =
        target_from_eye.infinite_homography * pixel_from_window(height_px);
    for (Eigen::Index row = 0; row < 3; ++row)
        rows.push_back(
            to_glm(Eigen::Vector4d(target_from_window(row, 0), target_from_window(row, 1),
                                   target_from_window(row, 2), target_from_eye.epipole[row])));
}

/// `append` adds those of a view; layers without one get three of zeros and `of_none`.
template <class Append>
LayerRows rows_of_layers(const std::vector<int>& view_indices, const glm::vec4& of_none,
                         const Append& append) {
    LayerRows rows;
    for (std::size_t layer = 0; layer < kMaxDepthViews; ++layer) {
        const int view = layer < view_indices.size() ? view_indices[layer] : kNoView;
        if (view == kNoView) {
            rows.resize(rows.size() + 3, glm::vec4(0.0F));
            rows.push_back(of_none);
        } else {
            append(view, rows);
        }
    }
    return rows;
}

}  // namespace

LayerRows pixel_rows(const Lumigraph& lumigraph, const Eye& eye,
                     const std::vector<int>& view_indices) {
    return rows_of_layers(
        view_indices, glm::vec4(kNoView, 0.0F, 0.0F, 0.0F), [&](int index, LayerRows& rows) {
            const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(index)];
            append_transfer(warp_from(eye).to(view), eye.camera.height_px, rows);
            rows.emplace_back(index, 0.0F, 0.0F, 0.0F);
        });
}

LayerRows sample_rows(const Lumigraph& lumigraph, const Eye& depth_eye,
                      const std::vector<int>& view_indices) {
    return rows_of_layers(view_indices, glm::vec4(0.0F), [&](int index, LayerRows& rows) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(index)];
        append_transfer(PastSight(view, depth_eye).samples_from_eye(), depth_eye.camera.height_px,
                        rows);
        const FloatImage& samples = view.depth.inverse_depth;
        rows.emplace_back(samples.width(), samples.height(), index, 0.0F);
    });
}

}  // namespace lumi
