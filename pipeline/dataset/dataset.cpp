#include "pipeline/dataset/dataset.h"

#include <set>

#include "calib/work/error.h"
#include "pipeline/config/config_variant.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// The ending of a file is no part of a scene's name; a dot in a folder's name is.
std::string default_scene_name(const fs::path& config, const fs::path& photos) {
    std::error_code status;
    const bool is_folder =
        photos.empty() ? fs::is_directory(config, status) : !fs::is_regular_file(photos, status);
    const fs::path source = photos.empty() ? config : photos;
    const fs::path named = source.has_filename() ? source : source.parent_path();
    return (is_folder ? named.filename() : named.stem()).string();
}

/// All keys of a scene are known once they were asked for.
void name_known_keys(const ConfigSection& scene) {
    for (const char* key : {"config", "photos", "name"}) static_cast<void>(scene.text(key, ""));
    scene.leave_to_others("settings");
}

DatasetScene read_scene(const ConfigSection& section, std::vector<ConfigChange> changes) {
    const fs::path config = section.path("config");
    const fs::path photos = section.path("photos");
    if (config.empty() == photos.empty()) {
        section.refuse("config", "either `config` (a file) or `photos` (a folder)");
    }
    DatasetScene scene;
    scene.name = section.text("name", default_scene_name(config, photos));
    if (!is_plain_name(scene.name)) section.refuse("name", "a name that can name a folder");
    // A change like the others, so that the workspace's own configuration has the name, too.
    changes.push_back({"name", literal_of_text(scene.name)});
    try {
        scene.config =
            ConfigDocument::open(config.empty() ? photos : config).build_config_with(changes);
    } catch (const Error& error) {
        scene.failure = error;
    }
    return scene;
}

}  // namespace

bool is_dataset_file(const fs::path& path) {
    std::error_code status;
    if (!fs::is_regular_file(path, status)) return false;
    return ConfigDocument::open(path).has_tables("scene");
}

Dataset read_dataset(const fs::path& path) {
    const ConfigSection file = ConfigSection::from_file(path);
    const ConfigDocument document = ConfigDocument::open(path);
    Dataset dataset;
    dataset.name = file.text("name", path.stem().string());
    if (!is_plain_name(dataset.name)) file.refuse("name", "a name that can name a folder");
    file.leave_to_others("settings");
    const std::vector<ConfigChange> for_all = document.changes_of("settings");
    std::set<std::string> names;
    const std::vector<ConfigSection> sections = file.sections("scene");
    for (const ConfigSection& section : sections) name_known_keys(section);
    file.expect_all_keys_known();  // Before a scene is found to lack what is misspelt.
    for (std::size_t i = 0; i < sections.size(); ++i) {
        std::vector<ConfigChange> changes = for_all;
        for (ConfigChange& change :
             document.changes_of("scene[" + std::to_string(i) + "].settings")) {
            changes.push_back(std::move(change));
        }
        dataset.scenes.push_back(read_scene(sections[i], std::move(changes)));
        if (!names.insert(dataset.scenes.back().name).second) {
            throw Error(ErrorKind::kUsage, "E-DATASET-NAME",
                        path.string() + ": two scenes are named " + dataset.scenes.back().name,
                        "give one of them another name = \"...\"");
        }
    }
    return dataset;
}

}  // namespace lumi
