#include "meshing/selection/view_selection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "calib/work/error.h"
#include "meshing/selection/view_worth.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

std::vector<OpticalAxis> axes_at(const Points& centres) {
    std::vector<OpticalAxis> axes;
    for (const Eigen::Vector3d& centre : centres) {
        axes.push_back({static_cast<int>(axes.size()), centre, -centre.normalized(), 1});
    }
    return axes;
}

std::vector<int> first_of(const std::vector<int>& order, int count) {
    return {order.begin(), order.begin() + count};
}

/// The largest distance of a camera to the nearest chosen one.
double widest_gap(const std::vector<OpticalAxis>& axes, const std::vector<int>& views) {
    double widest = 0;
    for (const OpticalAxis& axis : axes) {
        double nearest = 1e9;
        for (const int view : views) {
            nearest =
                std::min(nearest, viewpoint_distance(axis, axes[static_cast<std::size_t>(view)],
                                                     Eigen::Vector3d::Zero()));
        }
        widest = std::max(widest, nearest);
    }
    return widest;
}

TEST(ViewsFarApart, NameNearDuplicatesLast) {
    Points centres = sphere_directions(20, -1);
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        centres.push_back(centres[static_cast<std::size_t>(i)] + 0.01 * random_direction(random));
    }
    const auto order = views_far_apart(axes_at(centres), Eigen::Vector3d::Zero());
    ASSERT_EQ(order.size(), 40U);
    std::set<int> originals;
    for (const int view : first_of(order, 20)) originals.insert(view % 20);
    EXPECT_EQ(originals.size(), 20U);
}

TEST(ViewsFarApart, LeaveNarrowerGapsThanAnyRandomChoice) {
    std::mt19937 random(2);
    Points centres;
    for (int i = 0; i < 169; ++i) centres.push_back(random_direction(random));
    const auto axes = axes_at(centres);
    const double ours =
        widest_gap(axes, first_of(views_far_apart(axes, Eigen::Vector3d::Zero()), 40));
    std::vector<int> all(169);
    for (int i = 0; i < 169; ++i) all[static_cast<std::size_t>(i)] = i;
    for (int trial = 0; trial < 100; ++trial) {
        std::shuffle(all.begin(), all.end(), random);
        EXPECT_GT(widest_gap(axes, first_of(all, 40)), 1.2 * ours);
    }
}

TEST(ViewsFarApart, AreAllViewsWhateverTheCameras) {
    const Points one_spot(7, Eigen::Vector3d(1, 0, 0));
    const auto order = views_far_apart(axes_at(one_spot), Eigen::Vector3d::Zero());
    EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 7U);
    EXPECT_TRUE(views_far_apart({}, Eigen::Vector3d::Zero()).empty());
}

TEST(SelectionSizes, FallByAQuarterEachTime) {
    EXPECT_EQ(selection_sizes(16, 4), (std::vector<int>{16, 12, 9, 6, 4}));
    EXPECT_EQ(selection_sizes(2, 4), (std::vector<int>{2}));
    EXPECT_EQ(selection_sizes(1, 1), (std::vector<int>{1}));
}

/// Losses that do not change down to a known size, but for noise, and rise below it.
TEST(SelectViews, FindsTheSizeBelowWhichTheLossRises) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.05);
    const auto order =
        views_far_apart(axes_at(sphere_directions(100, -1)), Eigen::Vector3d::Zero());
    for (const int needed : {20, 40, 70}) {
        const auto losses_of = [&](const std::vector<int>& views) {
            std::vector<double> losses;
            const double missing = std::max(
                0.0, std::log(static_cast<double>(needed) / static_cast<double>(views.size())));
            for (int place = 0; place < 20; ++place) {
                // Places differ by far more than choices of views do.
                losses.push_back(5.0 * place + missing + noise(random));
            }
            return losses;
        };
        const ViewSelection selection = select_views(order, selection_sizes(100, 4), losses_of);
        const auto chosen = static_cast<int>(selection.curve[selection.chosen].views.size());
        EXPECT_GE(chosen, 0.9 * needed);
        EXPECT_LE(chosen, 1.5 * needed + 1);
        EXPECT_EQ(selection.curve.front().views.size(), 100U);
    }
}

TEST(SelectViews, RefuseASizeThatTheViewsDoNotComeTo) {
    const auto losses_of = [](const std::vector<int>&) { return std::vector<double>{1.0}; };
    for (const int size : {4, 0, -2}) {
        try {
            (void)select_views({2, 0, 1}, {3, size}, losses_of);
            ADD_FAILURE() << "accepted " << size;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-SELECT-SIZE");
            EXPECT_NE(std::string(error.what()).find(std::to_string(size)), std::string::npos);
        }
    }
    EXPECT_EQ(select_views({2, 0, 1}, {3, 1}, losses_of).curve.back().views, std::vector<int>{2});
}

}  // namespace
}  // namespace lumi
