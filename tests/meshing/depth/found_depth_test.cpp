#include "meshing/depth/found_depth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "meshing/depth/finished_depth.h"
#include "meshing/geometry/mesh_depth.h"
#include "meshing/geometry/triangle_mesh.h"
#include "tests/calib/interrupted_progress.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

constexpr int kWallWidth_px = 120;
constexpr int kWallHeight_px = 80;
constexpr double kFocalPx = 100;
constexpr double kBaseline = 0.5;
constexpr int kStartPx = 30;
constexpr float kRim = 0.9F;
constexpr double kSlopePx = 0.6;
constexpr int kViews = 5;

/// What recedes from column 30 of the first view on, as inverse depth.
double inverse_depth_at(double x) {
    return static_cast<double>(kRim) -
           kSlopePx / (kFocalPx * kBaseline) * std::max(0.0, x - kStartPx);
}

/// Where column x of a view that stands `j` baselines to the right shows the first view's surface.
double column_in_first_view(double x, int j) {
    const double shift_px = kFocalPx * kBaseline * j * static_cast<double>(kRim);
    const double before = x + shift_px;
    return before <= kStartPx ? before : (before + kSlopePx * j * kStartPx) / (1 + kSlopePx * j);
}

/// A wall that recedes from column 30 of the first view on. The second view stands to its right,
/// all others where it stands: each tells the same.
DepthScene receding_wall() {
    DepthScene scene;
    for (int j = 0; j < kViews; ++j) {
        DepthView view;
        view.name = std::to_string(j);
        view.camera = {kWallWidth_px,
                       kWallHeight_px,
                       LensModel::kPinhole,
                       {kFocalPx, kFocalPx, kWallWidth_px / 2.0, kWallHeight_px / 2.0}};
        const int place = j == 1 ? 1 : 0;
        view.cam_from_world.translation = {-kBaseline * place, 0, 0};
        view.photograph = ColorImage(kWallWidth_px, kWallHeight_px);
        view.neighbours = {j == 1 ? 0 : 1};
        view.disparity_px_per_inverse_depth = kFocalPx * kBaseline;
        for (int y = 0; y < kWallHeight_px; ++y) {
            for (int x = 0; x < kWallWidth_px; ++x) {
                const double own = column_in_first_view(x + 0.5, place);
                const auto level =
                    static_cast<std::uint8_t>(std::lround(120 + 100 * std::sin(0.05 * own)));
                view.photograph(x, y) = {level, level, level};
            }
        }
        scene.views.push_back(view);
    }
    return scene;
}

DepthMap known_up_to(int column) {
    DepthMap map{FloatImage(kWallWidth_px, kWallHeight_px, kRim),
                 GrayImage(kWallWidth_px, kWallHeight_px)};
    for (int y = 0; y < kWallHeight_px; ++y) {
        for (int x = 0; x < column; ++x) map.confidence(x, y) = 255;
    }
    return map;
}

/// Knows at last all that there is to know, but of the first `unfinished` views only what lies
/// before column 30, and of the second of them nothing; and where it refines, no more than that of
/// any view before.
class ModelThatMayRefine final : public DepthModel {
 public:
    ModelThatMayRefine(bool refines, int unfinished) : refines_(refines), unfinished_(unfinished) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene&, int view) const override {
        return !refines_ && view >= unfinished_ ? all() : little_of(view);
    }
    [[nodiscard]] DepthEstimate refine(const DepthScene&, const std::vector<DepthEstimate>&,
                                       int view) const override {
        return view >= unfinished_ ? all() : little_of(view);
    }
    [[nodiscard]] std::string begins_as() const override { return "little"; }
    [[nodiscard]] int refinements() const override { return refines_ ? 1 : 0; }

 private:
    static DepthEstimate all() { return {known_up_to(kWallWidth_px), "all", false, false}; }
    static DepthEstimate little_of(int view) {
        return {known_up_to(view == 1 ? 0 : kStartPx), "little", false, false};
    }

    bool refines_;
    int unfinished_;
};

struct Found {
    DepthResult result;
    std::vector<std::string> notes;
};

Found depth_by(const ModelThatMayRefine& model) {
    NotedProgress progress;
    Found found;
    found.result.memory.views_matched = found.result.memory.views_filled = 2;
    find_depth(receding_wall(), std::vector<GrayImage>(kViews),
               std::make_unique<ModelThatMayRefine>(model), progress, found.result);
    found.notes = progress.notes;
    return found;
}

/// Mean pixels of disparity by which the first view is wrong beyond what is known.
double error_beyond_px(const DepthResult& result) {
    double sum = 0;
    for (int x = kStartPx; x < kWallWidth_px / 2; ++x) {
        const double found = static_cast<double>(result.depth_maps[0].inverse_depth(x, 40));
        sum += std::abs(found - inverse_depth_at(x + 0.5)) * kFocalPx * kBaseline;
    }
    return sum / (kWallWidth_px / 2 - kStartPx);
}

// Without receding the first view would be wrong by 9 pixels.
constexpr double kSmoothed_px = 2.0;

TEST(FoundDepth, RecedesBeyondWhatIsKnownWhereFourViewsTell) {
    const Found found = depth_by({false, kViews});
    EXPECT_THAT(found.notes, testing::ElementsAre(testing::HasSubstr("recedes by 0.6 px")));
    EXPECT_LT(error_beyond_px(found.result), kSmoothed_px);
}

TEST(FoundDepth, WhereRefinementLeavesTooFewToAskTheUnrefinedViewsTell) {
    const Found found = depth_by({true, 1});  // One view alone is left with something to continue.
    EXPECT_THAT(found.notes, testing::ElementsAre(testing::HasSubstr("recedes by 0.6 px")));
    EXPECT_LT(error_beyond_px(found.result), kSmoothed_px);
    EXPECT_EQ(found.result.depth_maps[2].confidence, GrayImage(kWallWidth_px, kWallHeight_px, 255))
        << "what was refined stays";
}

/// Railings before a wall with a hole in it, as OBJ.
void write_railings(const std::filesystem::path& file) {
    std::ofstream obj(file);
    int vertices = 0;
    const auto rectangle = [&](double left, double right, double z) {
        obj << "v " << left << " -9 " << z << "\nv " << right << " -9 " << z << "\nv " << right
            << " 9 " << z << "\nv " << left << " 9 " << z << "\nf " << vertices + 1 << " "
            << vertices + 2 << " " << vertices + 3 << " " << vertices + 4 << "\n";
        vertices += 4;
    };
    rectangle(-9, 0.6, 4);
    rectangle(0.9, 9, 4);
    for (int i = -4; i <= 4; ++i) rectangle(0.3 * i, 0.3 * i + 0.06, 2);  // Three pixels wide.
}

TEST(FoundDepth, LeavesEveryPixelOfGivenGeometryAndFillsTheRest) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "railings.obj";
    write_railings(file);
    const TriangleMesh mesh = read_triangle_mesh(file);
    DepthScene scene = receding_wall();
    const auto gray = noise_texture(2.0, 1);  // Of railings, too: no outline shows.
    for (DepthView& view : scene.views) {
        for (int y = 0; y < kWallHeight_px; ++y) {
            for (int x = 0; x < kWallWidth_px; ++x) {
                const auto level = static_cast<std::uint8_t>(gray({1.0 * x, 1.0 * y, 0.0}));
                view.photograph(x, y) = {level, level, level};
            }
        }
    }
    DepthResult result;
    NotedProgress progress;
    find_depth(scene, std::vector<GrayImage>(kViews), mesh_depth_model(file), progress, result);
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthMap given = mesh_depth(scene.views[i], mesh);
        int filled = 0;
        for (std::size_t k = 0; k < given.confidence.pixels().size(); ++k) {
            const float found = result.depth_maps[i].inverse_depth.pixels()[k];
            if (given.confidence.pixels()[k] != 0) {
                ASSERT_EQ(found, given.inverse_depth.pixels()[k]) << i << " " << k;
            } else {
                ++filled;
                ASSERT_GT(found, 0.2F) << i << " " << k;
            }
        }
        EXPECT_GT(filled, 0) << i << ": the hole";
    }
}

TEST(FoundDepth, StopsAtEachViewThatIsAskedHowItsFillRecedes) {
    const DepthScene scene = receding_wall();
    const ModelThatMayRefine model(false, kViews);
    std::vector<DepthEstimate> estimates;
    std::vector<DepthMap> confirmed_maps;
    for (int view = 0; view < kViews; ++view) {
        estimates.push_back(model.estimate(scene, view));
        confirmed_maps.push_back(estimates.back().map);
    }
    for (int questions = 0; questions < kViews; ++questions) {
        const InterruptedProgress progress(questions);
        std::vector<DepthMap> maps = confirmed_maps;
        try {
            (void)fill_recession(scene, std::vector<GrayImage>(kViews), estimates, 1, progress,
                                 maps);
            ADD_FAILURE() << "went on after " << questions;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-INTERRUPTED");
        }
    }
}

TEST(FoundDepth, DoesNotRecedeWhereNobodyTells) {
    // The same single view, and no estimates before it that could be asked.
    const Found found = depth_by({false, 1});
    EXPECT_THAT(found.notes, testing::IsEmpty());
}

}  // namespace
}  // namespace lumi
