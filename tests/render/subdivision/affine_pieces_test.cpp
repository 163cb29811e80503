#include "render/subdivision/affine_pieces.h"

#include <gtest/gtest.h>

#include <random>

#include "calib/capture/inverse_depth_warp.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

struct Pieces {
    BlendTriangles affine;
    std::vector<FacePolygon> exact;
    std::vector<PlaneView> views;
};

Pieces pieces_of(const Lumigraph& lumigraph, const Eye& eye,
                 const std::vector<FacePolygon>& polygons, const AffinePieceOptions& options) {
    Pieces pieces;
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    for (const LumigraphView& view : lumigraph.views) {
        pieces.views.push_back({warp_from(eye).to(view).homography_of(plane),
                                static_cast<double>(view.camera.width_px),
                                static_cast<double>(view.camera.height_px)});
    }
    for (const FacePolygon& polygon : polygons)
        cut_into_affine_pieces(polygon, pieces.views, plane, options, pieces.affine, pieces.exact);
    return pieces;
}

double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
}

const FacePolygon& polygon_of_face(const std::vector<FacePolygon>& polygons, int face_index) {
    return *std::find_if(polygons.begin(), polygons.end(), [&](const FacePolygon& polygon) {
        return polygon.face_index == face_index;
    });
}

constexpr std::size_t kPlaces = 100;

bool is_within(const PlaneView& view, const Eigen::Vector2d& pixel) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= view.width_px &&
           pixel.y() <= view.height_px;
}

/// At some places on each triangle; photographs that have ended there do not count.
void expect_within_the_stated_error(const Lumigraph& lumigraph, const Eye& eye) {
    const std::vector<FacePolygon> polygons = face_polygons(lumigraph.mesh, eye);
    const AffinePieceOptions options{.max_error_px = 0.05, .max_weight_error = 0.01};
    const Pieces pieces = pieces_of(lumigraph, eye, polygons, options);
    ASSERT_GT(pieces.affine.count(), 0U);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (std::size_t n = 0; n < kPlaces * pieces.affine.count(); ++n) {
        const std::size_t i = 3 * (n / kPlaces);
        Eigen::Vector3d in_picture(share(random), share(random), share(random));
        in_picture /= in_picture.sum();
        Eigen::Vector3d in_space;
        Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
        std::array<const BlendVertex*, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = &pieces.affine.vertices[pieces.affine.indices[i + c]];
            pixel += in_picture[static_cast<Eigen::Index>(c)] *
                     Eigen::Vector2d(corners[c]->pixel[0], corners[c]->pixel[1]);
            in_space[static_cast<Eigen::Index>(c)] =
                in_picture[static_cast<Eigen::Index>(c)] / static_cast<double>(corners[c]->depth);
        }
        in_space /= in_space.sum();
        const FacePolygon& polygon =
            polygon_of_face(polygons, static_cast<int>(corners[0]->face_index));
        const auto exact_weights = weights_at(polygon, pixel);
        std::array<double, 3> weights{};
        double visible = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c)
                weights[k] += in_space[static_cast<Eigen::Index>(c)] *
                              static_cast<double>(corners[c]->weights[k]);
            if (weights[k] > 0) visible += exact_weights[k];
        }
        std::array<Eigen::Vector2d, 3> expected;
        double counting = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const PlaneView& view = pieces.views[static_cast<std::size_t>(polygon.view_indices[k])];
            expected[k] = (view.view_from_eye * pixel.homogeneous()).hnormalized();
            if (!is_within(view, expected[k])) continue;
            counting += weights[k];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (weights[k] <= 0) continue;
            EXPECT_NEAR(weights[k], exact_weights[k] / visible, 2 * options.max_weight_error);
            Eigen::Vector2d at = Eigen::Vector2d::Zero();
            for (std::size_t c = 0; c < 3; ++c)
                at += in_space[static_cast<Eigen::Index>(c)] *
                      Eigen::Vector2d(corners[c]->view_pixels[k][0], corners[c]->view_pixels[k][1]);
            const PlaneView& view = pieces.views[static_cast<std::size_t>(polygon.view_indices[k])];
            if (!is_within(view, expected[k])) continue;
            EXPECT_LE(weights[k] / counting * (at - expected[k]).norm(),
                      options.max_error_px + 1e-3);
        }
    }
}

TEST(AffinePieces, LookUpPhotographsWithinTheStatedError) {
    expect_within_the_stated_error(
        ball_in_sky(), eye_at({0.5, 0.6, -2}, {0, 0, 0}, pinhole_camera(320, 240, 260)));
}

TEST(AffinePieces, KeepToTheErrorWhereAPhotographEndsAndOthersCountForIt) {
    expect_within_the_stated_error(
        card_before_wall(), eye_at({1.2, 0.3, 0.2}, {0, 0, 4}, pinhole_camera(320, 240, 260)));
}

/// Of affine and exact pieces, in square pixels.
double area_of_pieces(const Lumigraph& lumigraph, const Eye& eye) {
    const std::vector<FacePolygon> polygons = face_polygons(lumigraph.mesh, eye);
    const Pieces pieces = pieces_of(lumigraph, eye, polygons, {});
    double area = 0;
    for (std::size_t i = 0; i < pieces.affine.indices.size(); i += 3) {
        std::array<Eigen::Vector2d, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) {
            const BlendVertex& vertex = pieces.affine.vertices[pieces.affine.indices[i + c]];
            corners[c] = {vertex.pixel[0], vertex.pixel[1]};
        }
        area += 0.5 * twice_area(corners[0], corners[1], corners[2]);
    }
    for (const FacePolygon& piece : pieces.exact)
        for (std::size_t c = 1; c + 1 < piece.corners_px.size(); ++c)
            area +=
                0.5 * twice_area(piece.corners_px[0], piece.corners_px[c], piece.corners_px[c + 1]);
    return area;
}

// These narrow eyes see only what photographs show; faces overlap by a hundredth of a pixel.

TEST(AffinePieces, AndExactOnesTogetherCoverWhatPhotographsSee) {
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 90));
    EXPECT_NEAR(area_of_pieces(card_before_wall(), eye), 64 * 48, 8);
}

TEST(AffinePieces, CoverWhatIsSeenThroughALongLensFromFarAway) {
    // For photographs depths are a thousandth, a hundred thousandth of what they are for the eye.
    for (const double times_farther : {1e2, 1e3, 2e3, 1e5}) {
        const Eye eye = eye_at({0.21, 0.13, -4 * times_farther}, {0.1, 0.1, 4},
                               pinhole_camera(64, 48, 800 * times_farther));
        EXPECT_NEAR(area_of_pieces(card_before_wall(), eye), 64 * 48, 8) << times_farther;
    }
}

TEST(AffinePieces, LeaveOutWhatNoPhotographSees) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, -4}, pinhole_camera(64, 48, 60));
    const Pieces pieces =
        pieces_of(lumigraph, eye, face_polygons(lumigraph.mesh, eye), AffinePieceOptions{});
    EXPECT_EQ(pieces.affine.count(), 0U);
}

}  // namespace
}  // namespace lumi
