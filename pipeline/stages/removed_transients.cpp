#include "pipeline/stages/removed_transients.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "calib/pictures/image_io.h"
#include "calib/work/formatted.h"
#include "meshing/transients/transient_removal.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/stages/file_stems.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Side by side.
ColorImage before_and_after(const ColorImage& before, const ColorImage& after) {
    constexpr int kWidthPx = 480;
    const int width = std::min(kWidthPx, before.width());
    const int height = std::max(1, before.height() * width / before.width());
    ColorImage both(2 * width, height);
    const ColorImage left = resized(before, width, height);
    const ColorImage right = resized(after, width, height);
    for (int y = 0; y < height; ++y) {
        std::copy(left.row(y), left.row(y) + width, both.row(y));
        std::copy(right.row(y), right.row(y) + width, both.row(y) + width);
    }
    return both;
}

}  // namespace

Json remove_transients(Lumigraph& lumigraph, const fs::path& pack_folder, int threads,
                       int max_memory_mib, Progress& progress) {
    std::vector<ViewWithoutTransients> changed =
        without_transients(pictured_views(lumigraph), threads,
                           static_cast<std::uint64_t>(max_memory_mib) << 20, progress);
    Json list = Json::array();
    if (changed.empty()) return list;
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    const std::vector<std::string> stems = file_stems_of_views(names);
    fs::create_directories(pack_folder / kTransientFolder);
    double largest = 0.0;
    for (ViewWithoutTransients& clean : changed) {
        const auto index = static_cast<std::size_t>(clean.view);
        LumigraphView& view = lumigraph.views[index];
        const std::string file = stems[index] + ".png";
        write_png(pack_folder / kTransientFolder / file,
                  before_and_after(view.photograph, clean.photograph));
        list.push_back({{"name", view.name}, {"share", clean.share}, {"picture", file}});
        largest = std::max(largest, clean.share);
        view.photograph = std::move(clean.photograph);
        view.depth = std::move(clean.depth);
    }
    progress.note(formatted(
        "pack: something was there for one photograph alone, and was painted over as others show "
        "the scene: in %zu of %zu photographs, up to %.1f %% of one ([package] keep_transients = "
        "true leaves it in)",
        changed.size(), lumigraph.views.size(), 100 * largest));
    return list;
}

}  // namespace lumi
