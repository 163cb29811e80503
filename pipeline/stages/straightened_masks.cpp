#include "pipeline/stages/straightened_masks.h"

#include <algorithm>
#include <set>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/drawn_mask.h"
#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"
#include "pipeline/stages/straightened_raster.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Up to three of them by name.
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, names.size()); ++i) {
        text += (i > 0 ? ", " : "") + names[i];
    }
    return names.size() > 3 ? text + " and " + std::to_string(names.size() - 3) + " more" : text;
}

void note_if_any(const std::vector<std::string>& names, const std::string& what,
                 Progress& progress) {
    if (!names.empty()) progress.note("masks: " + what + ": " + listed(names));
}

/// Masks whose name is that of no photograph: most likely misspelt.
std::vector<std::string> masks_of_nothing(const MaskedPhotographs& photographs) {
    std::set<fs::path> known;
    for (const std::string& name : photographs.all_names) {
        known.insert(mask_file_of(name, photographs.mask_folder).lexically_normal());
    }
    std::vector<std::string> strangers;
    for (const auto& entry : fs::recursive_directory_iterator(photographs.mask_folder)) {
        const fs::path path = entry.path().lexically_normal();
        if (entry.is_regular_file() && path.extension() == ".png" && known.count(path) == 0) {
            strangers.push_back(path.lexically_relative(photographs.mask_folder).string());
        }
    }
    std::sort(strangers.begin(), strangers.end());
    return strangers;
}

}  // namespace

fs::path straightened_mask_file(const fs::path& folder, const std::string& name) {
    return folder / (name + ".png");
}

void straighten_masks(const MaskedPhotographs& photographs, const fs::path& folder, int threads,
                      Progress& progress) {
    expect_own_masks(photographs.all_names, photographs.mask_folder);
    const Capture lenses = read_colmap_model(photographs.poses_folder / "sparse");
    const Capture pinholes = read_colmap_model(photographs.poses_folder / "pinhole");
    const auto may_lack = [&](const std::string& name) {
        return std::find(photographs.held_out.begin(), photographs.held_out.end(), name) !=
               photographs.held_out.end();
    };
    std::vector<std::string> missing(pinholes.views.size());
    std::vector<std::string> full(pinholes.views.size());
    progress.begin("straightening masks", pinholes.views.size());
    parallel_for(static_cast<int>(pinholes.views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        const View& view = pinholes.views[index];
        progress.advance();
        if (may_lack(view.name) && mask_file_of(view.name, photographs.mask_folder).empty()) {
            missing[index] = view.name;
            return;
        }
        const Camera& lens = camera_of_view(lenses, view.name);
        const GrayImage drawn =
            read_drawn_mask(view.name, lens.width_px, lens.height_px, photographs.mask_folder);
        if (std::count(drawn.pixels().begin(), drawn.pixels().end(), 0) == 0) {
            full[index] = view.name;
        }
        write_png(straightened_mask_file(folder, view.name),
                  straightened(drawn, lens, camera_of(pinholes, view)));
    });
    std::erase(missing, "");
    std::erase(full, "");
    note_if_any(full, "nothing is hidden in", progress);
    note_if_any(missing, "the subject is not told from the rest in held-out photographs", progress);
    note_if_any(masks_of_nothing(photographs), "named like no photograph", progress);
}

}  // namespace lumi
